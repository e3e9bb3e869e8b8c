//! A log of a linear system, filtered in one call.

use super::{Belief, KalmanFilter, System};
use crate::error::{Argument, Code, Error};
use crate::kf::belief_fits;
use crate::validate::affordable_steps;
use alloc::borrow::ToOwned;
use alloc::format;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// The most steps of a log of a linear system; of a large one fewer, see [`MAX_WORK`](crate::validate::MAX_WORK).
pub const MAX_LOG: usize = 100_000;

/// What a filtered log answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Replayed {
    /// x̂(k | k) after each step, steps × n, row by row.
    pub x: Vec<f64>,
    /// The diagonal of P(k | k), in the same order.
    pub variances: Vec<f64>,
    /// P(k | k) after the last step, n×n.
    pub p: DMatrix<f64>,
    /// Whether S and P of every step are right, as [`KalmanFilter::conditioned`] says it.
    pub conditioned: bool,
    /// Σ −½ (ln det 2πS + νᵀS⁻¹ν) over the steps, as [`KalmanFilter::log_likelihood`] answers it.
    pub log_likelihood: Option<f64>,
}

/// One [`kalman_step`](crate::kf::kalman_step) for each row of `readings` (steps × p, row by row), with the row of
/// `inputs` (steps × m) beside it.
///
/// # Errors
/// Those of the step, saying at which, with `inputs` for u and `readings` for y; [`Code::Shape`] when the rows do not
/// fit the system or each other, [`Code::NotFinite`] naming the number, [`Code::Limit`] for no step or more than
/// [`MAX_LOG`], or than [`MAX_WORK`](crate::validate::MAX_WORK) leaves for a system of this size: a longer log is
/// replayed in parts, each from the last belief of the one before.
pub fn kalman_replay(system: &System, belief: &Belief, inputs: &[f64], readings: &[f64]) -> Result<Replayed, Error> {
    let (n, m, p) = (system.f.nrows(), system.g.ncols(), system.h.nrows());
    belief_fits(belief, n)?;
    let steps = readings.len() / p;
    if readings.len().is_multiple_of(p) {
        affordable(system, steps)?;
    }
    rows(readings, (steps, p), "readings")?;
    rows(inputs, (steps, m), "inputs")?;
    let mut filter = KalmanFilter::new(system, belief)?;
    let (x, variances) = filter.replay(inputs, readings).map_err(|(e, k)| at_step(e, k))?;
    Ok(replayed(&filter, x, variances))
}

/// [`kalman_replay`] of a log with gaps: a row of `readings` has p parts, of which some, or all, are missing.
///
/// # Errors
/// As there.
///
/// # Example
/// ```
/// use estimate::dynamic::{System, kalman_replay_partly};
/// use nalgebra::{DMatrix, dmatrix, dvector};
/// let one = dmatrix![1.0];
/// let system = System::new(one.clone(), DMatrix::zeros(1, 0), one.clone(), one.clone(), one.clone())?;
/// let belief = estimate::validate::belief(dvector![0.0], dmatrix![1.0])?;
/// let log = kalman_replay_partly(&system, &belief, &[], &[vec![Some(3.0)], vec![None]])?;
/// // Where nothing is read the variance grows by V.
/// assert!((log.x[1] - 2.0).abs() < 1e-15 && (log.variances[1] - log.variances[0] - 1.0).abs() < 1e-15);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn kalman_replay_partly(
    system: &System,
    belief: &Belief,
    inputs: &[f64],
    readings: &[Vec<Option<f64>>],
) -> Result<Replayed, Error> {
    let (m, steps) = (system.g.ncols(), readings.len());
    affordable(system, steps)?;
    rows(inputs, (steps, m), "inputs")?;
    let mut filter = KalmanFilter::new(system, belief)?;
    let (mut x, mut variances) = (Vec::new(), Vec::new());
    for (k, y) in readings.iter().enumerate() {
        let step = filter.step_partly(&inputs[k * m..(k + 1) * m], y);
        step.map_err(|error| of_row(at_step(error, k + 1), k))?;
        x.extend_from_slice(filter.x());
        variances.extend(filter.belief().p.diagonal().iter());
    }
    Ok(replayed(&filter, x, variances))
}

fn replayed(filter: &KalmanFilter, x: Vec<f64>, variances: Vec<f64>) -> Replayed {
    let (conditioned, log_likelihood) = (filter.conditioned(), filter.log_likelihood());
    Replayed { x, variances, p: filter.belief().p, conditioned, log_likelihood }
}

/// # Errors
/// [`Code::Limit`] for no step, or more than a call may take.
fn affordable(system: &System, steps: usize) -> Result<(), Error> {
    let (n, p) = (system.f.nrows(), system.h.nrows());
    let most = affordable_steps(n, p, MAX_LOG);
    if (1..=most).contains(&steps) {
        return Ok(());
    }
    let message =
        format!("holds {steps} steps; of {n} states and {p} outputs at least 1 and at most {most} are accepted");
    Err(Error::new(Code::Limit, "readings", message))
}

/// The error of a row that is refused for what is in it, which a filter calls y.
fn of_row(mut error: Error, k: usize) -> Error {
    if error.argument == "y" {
        error.argument = format!("readings[{k}]").into();
    }
    error
}

/// # Errors
/// [`Code::Shape`] unless `numbers` are so many rows of so many, [`Code::NotFinite`] naming the first that is not.
fn rows(numbers: &[f64], (steps, each): (usize, usize), name: &str) -> Result<(), Error> {
    if numbers.len() != steps * each {
        let message = match numbers.len().checked_rem(each) {
            Some(0) => format!("has {} rows of {each}; the readings are of {steps} steps", numbers.len() / each),
            Some(_) => format!("has {} numbers, which are no whole number of rows of {each}", numbers.len()),
            None => format!("has {} numbers; the system has no input", numbers.len()),
        };
        return Err(Error::new(Code::Shape, name.to_owned(), message));
    }
    match numbers.iter().position(|number| !number.is_finite()) {
        Some(i) => Err(Error::new(Code::NotFinite, format!("{name}[{i}]"), "must be a finite number")),
        None => Ok(()),
    }
}

/// Why step `k` was refused, with the names that the arguments of a log have.
#[cold]
fn at_step(error: Error, k: usize) -> Error {
    let mut error = error.called(|argument| match argument {
        Argument::Input => "inputs".into(),
        Argument::Reading => "readings".into(),
        Argument::Mean => "belief.x".into(),
        Argument::Covariance => "belief.P".into(),
        other => other.letter(),
    });
    error.message = format!("{}; at step {k}", error.message).into();
    error
}
