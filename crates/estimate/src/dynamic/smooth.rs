//! The best track afterwards: every state of a log in the light of all its readings (Rauch, Tung and Striebel 1965).

use super::{Belief, KalmanFilter, MAX_LOG, System};
use crate::error::{Argument, Code, Error};
use crate::kf::belief_fits;
use crate::validate::affordable_steps;
use alloc::borrow::Cow;
use alloc::format;
use alloc::vec::Vec;
use filters::linear;
use nalgebra::DVector;

/// The beliefs N(x(k | all), P(k | all)) after each row of a log: a Kalman filter runs forward over it, and a smoother
/// back over the filter's beliefs. A row is an input (m) and the reading after it (p), of which parts, or all, may be
/// missing. `inputs` may be empty where the system has none.
///
/// With x̄ and P̄ the prediction of x(k+1), and C = P Fᵀ P̄⁻¹ the gain by which x(k) would be corrected if x(k+1)
/// were read, x(k | all) = x + C (x(k+1 | all) − x̄) and P(k | all) = P − C P̄ Cᵀ + C P(k+1 | all) Cᵀ. P − C P̄ Cᵀ is
/// computed as a correction is, in Joseph's form: where P is vast, the difference would have no digits.
///
/// From the last row with a reading on the answer is the filter's, to the last bit. It needs n² + n numbers for
/// each row.
///
/// # Errors
/// Those of the filter, naming the row: [`Code::Shape`], [`Code::NotFinite`],
/// [`Code::InnovationNotPositiveDefinite`]; the last also, naming V, where a P̄ cannot be factored. [`Code::Limit`] for
/// no row, or more than [`MAX_LOG`], or than [`MAX_WORK`](crate::validate::MAX_WORK) leaves for n states and n + p
/// outputs.
///
/// # Example
/// ```
/// use estimate::dynamic::{System, kalman_smooth};
/// use nalgebra::{DMatrix, dmatrix, dvector};
/// // A point that is pushed about: read at the start, and once more after a gap.
/// let one = dmatrix![1.0];
/// let system = System::new(one.clone(), DMatrix::zeros(1, 0), one.clone(), one.clone(), one.clone())?;
/// let belief = estimate::validate::belief(dvector![0.0], dmatrix![0.0])?;
/// let track = kalman_smooth(&system, &belief, &[], &[vec![Some(0.0)], vec![None], vec![Some(4.0)]])?;
/// // The gap is closed from both ends.
/// assert!((track[1].x[0] - 12.0 / 7.0).abs() < 1e-14 && (track[2].x[0] - 20.0 / 7.0).abs() < 1e-14);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn kalman_smooth(
    system: &System,
    belief: &Belief,
    inputs: &[Vec<f64>],
    readings: &[Vec<Option<f64>>],
) -> Result<Vec<Belief>, Error> {
    let (n, m, p) = (system.f.nrows(), system.g.ncols(), system.h.nrows());
    belief_fits(belief, n)?;
    let (rows, most) = (readings.len(), affordable_steps(n, n + p, MAX_LOG));
    if !(1..=most).contains(&rows) {
        let message =
            format!("has {rows} rows; of {n} states and {p} outputs at least 1 and at most {most} are accepted");
        return Err(Error::new(Code::Limit, "ys", message));
    }
    if inputs.len() != rows && !(m == 0 && inputs.is_empty()) {
        return Err(Error::new(Code::Shape, "us", format!("has {} rows; ys has {rows}", inputs.len())));
    }
    let mut filter = KalmanFilter::new(system, belief)?;
    let mut track = Vec::with_capacity(rows);
    let input = |k: usize| inputs.get(k).map_or(&[][..], Vec::as_slice);
    for (k, reading) in readings.iter().enumerate() {
        filter.step_partly(input(k), reading).map_err(|e| at_row(e, k))?;
        track.push(filter.belief());
    }
    // What nothing was read after is known as well as it will be.
    let last = readings.iter().rposition(|reading| reading.iter().any(Option::is_some)).unwrap_or(0);
    for k in (0..last).rev() {
        let (known, after) = track.split_at_mut(k + 1);
        smooth(&mut known[k], input(k + 1), &after[0], system).map_err(|e| at_step(e, k + 1))?;
    }
    Ok(track)
}

/// Corrects `belief` of x(k) by what is known of x(k+1) `after` all readings: by x(k+1) − G u as a reading of F x(k),
/// whose noise is V and what is still unknown of x(k+1).
fn smooth(belief: &mut Belief, u: &[f64], after: &Belief, system: &System) -> Result<(), filters::Error> {
    let z = &after.x - &system.g * DVector::from_column_slice(u);
    let (known, update) = belief.corrected(&z, &system.f, &system.v)?;
    let p = linear::predicted_covariance(&update.k, &after.p, &known.p)?;
    *belief = Belief { x: known.x, p };
    Ok(())
}

/// Why the filter refused row `k`, with the names that the arguments of a log have.
#[cold]
fn at_row(mut error: Error, k: usize) -> Error {
    let name: Cow<'static, str> = match &*error.argument {
        "u" => format!("us[{k}]").into(),
        "y" => format!("ys[{k}]").into(),
        "x" => "belief.x".into(),
        "P" => "belief.P".into(),
        other => Cow::Owned(other.into()),
    };
    error.argument = name;
    error.message = format!("{}; at row {k}", error.message).into();
    error
}

/// Why the smoother cannot go back from row `k`.
#[cold]
fn at_step(error: filters::Error, k: usize) -> Error {
    if error == filters::Error::InnovationNotPositiveDefinite {
        let message = format!("the predicted covariance at row {k} cannot be factored: add noise V of the motion");
        return Error::new(Code::InnovationNotPositiveDefinite, "V", message);
    }
    at_row(Error::from(error).called(Argument::letter), k)
}
