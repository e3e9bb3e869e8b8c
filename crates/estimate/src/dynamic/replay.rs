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
    let most = affordable_steps(n, p, MAX_LOG);
    if !(1..=most).contains(&steps) && readings.len().is_multiple_of(p) {
        let message =
            format!("holds {steps} steps; of {n} states and {p} outputs at least 1 and at most {most} are accepted");
        return Err(Error::new(Code::Limit, "readings", message));
    }
    rows(readings, (steps, p), "readings")?;
    rows(inputs, (steps, m), "inputs")?;
    let mut filter = KalmanFilter::new(system, belief)?;
    let (x, variances) = filter.replay(inputs, readings).map_err(|(e, k)| at_step(e, k))?;
    let (conditioned, log_likelihood) = (filter.conditioned(), filter.log_likelihood());
    Ok(Replayed { x, variances, p: filter.belief().p, conditioned, log_likelihood })
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
