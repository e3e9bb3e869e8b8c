//! The sensors of a time line, and what becomes of their readings.

use super::output::Output;
use crate::error::{Code, Error};
use crate::validate;
use alloc::string::String;
use nalgebra::{DMatrix, DVector};

/// The most sensors of a time line.
pub const MAX_SENSORS: usize = 64;
/// The most events that a time line keeps: a late one may have all others replayed.
pub const MAX_CAPACITY: usize = 10_000;
/// The longest delay of a sensor, either way, in seconds.
pub const MAX_DELAY: f64 = 10.0;
/// How far an event may lie ahead of all others, in seconds. What is further is taken for a clock that is wrong: it
/// would push everything else out of the window.
pub const MAX_AHEAD: f64 = 1e6;

/// A sensor y = H x + w, Cov w = W, with p outputs; or y = h(x) + w, see [`Output`].
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor<H = DMatrix<f64>> {
    /// What it is called, as no other.
    pub name: String,
    /// H, p×n, or a function.
    pub h: H,
    /// W, p×p.
    pub w: DMatrix<f64>,
    /// What is stamped t was measured at t − delay; in seconds, from −[`MAX_DELAY`] to [`MAX_DELAY`].
    pub delay: f64,
    /// A reading whose χ² is greater is not used; none where every reading is.
    pub gate: Option<f64>,
}

/// How much of the past a time line keeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    /// How much older than the latest event another may be, in seconds.
    pub window: f64,
    /// How many events within the window are kept, from 1 to [`MAX_CAPACITY`]. It bounds the work of a call: what comes
    /// late has all that are later replayed. So n that come in reversed order, by their times or by their ids at one
    /// time, have n²/2 replayed in all.
    pub capacity: usize,
}

/// What became of an input or a reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It has its place. A reading has corrected the belief.
    Accepted,
    /// The reading has its place, and lies beyond its sensor's gate. What comes late may change that.
    Rejected,
    /// It was measured before the window, or before the start.
    TooLate,
    /// It was measured more than [`MAX_AHEAD`] after everything else.
    Ahead,
    /// There is an input at this time, or a reading of this sensor with this time and id.
    Duplicate,
    /// As many events as there is room for lie within the window.
    Full,
}

/// How a reading compares with what was expected at its time.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// ν = y − H x̂, or y − h(x̂), of the parts that were read.
    pub innovation: DVector<f64>,
    /// S = H P Hᵀ + W.
    pub s: DMatrix<f64>,
    /// νᵀS⁻¹ν; nothing where S is singular to working accuracy, which is within no gate.
    pub chi2: Option<f64>,
}

/// The answer to an input or a reading.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// What became of it.
    pub outcome: Outcome,
    /// For a reading that has its place.
    pub judged: Option<Judged>,
}

impl<H: Output> Sensor<H> {
    /// # Errors
    /// Naming the field.
    pub(super) fn checked(self, n: usize) -> Result<Self, Error> {
        let h = self.h.checked(n)?;
        let w = validate::covariance(self.w, h.outputs(), "W")?;
        if validate::finite(self.delay, "delay")?.abs() > MAX_DELAY {
            return Err(Error::new(Code::Limit, "delay", "must be at most 10 s, either way"));
        }
        if let Some(gate) = self.gate
            && validate::finite(gate, "gate")? <= 0.0
        {
            return Err(Error::new(Code::Limit, "gate", "a gate on χ² is positive, or null"));
        }
        Ok(Self { h, w, ..self })
    }
}
