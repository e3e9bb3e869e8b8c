//! Events in their order, and what is known after each.

use super::output::Output;
use super::sensor::{Judged, Outcome, Placed, Sensor};
use crate::dynamic::{Belief, Continuous, Discrete};
use crate::error::{Argument, Error};
use alloc::vec::Vec;
use core::cmp::Ordering;
use nalgebra::DVector;

/// What is known after an event.
#[derive(Clone, Debug)]
pub struct Moment {
    pub time: f64,
    /// The input that is held from now on, m.
    pub input: DVector<f64>,
    pub belief: Belief,
}

/// Where an event stands among the others.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// When it was measured.
    pub time: f64,
    /// Zero for an input, and for a reading one more than its sensor's number.
    pub rank: usize,
    pub id: u64,
}

impl Key {
    pub fn cmp(&self, other: &Self) -> Ordering {
        self.time.total_cmp(&other.time).then(self.rank.cmp(&other.rank)).then(self.id.cmp(&other.id))
    }
}

#[derive(Clone, Debug)]
pub enum Given {
    Input(DVector<f64>),
    Reading(Vec<Option<f64>>),
}

#[derive(Clone, Debug)]
pub struct Event {
    pub key: Key,
    pub given: Given,
    /// The system over the time from the event before; none where that is no time.
    pub step: Option<Discrete>,
    pub after: Moment,
    judged: Option<Judged>,
}

impl Event {
    /// What the event makes of what is known `before` it.
    ///
    /// # Errors
    /// Those of a prediction and a correction.
    pub fn new<H: Output>(
        sensors: &[Sensor<H>],
        before: &Moment,
        key: Key,
        given: Given,
        step: Option<Discrete>,
    ) -> Result<Self, H::Fault> {
        let mut after =
            Moment { belief: predicted(before, step.as_ref())?, time: key.time, input: before.input.clone() };
        let mut judged = None;
        match &given {
            Given::Input(u) => after.input.copy_from(u),
            Given::Reading(y) => {
                let sensor = &sensors[key.rank - 1];
                let (corrected, reading) = sensor.h.corrected(&after.belief, y, &sensor.w)?;
                if sensor.accepts(&reading) {
                    after.belief = corrected;
                }
                judged = Some(reading);
            }
        }
        Ok(Self { key, given, step, after, judged })
    }

    /// What was read, and how it compares with what was expected; nothing of an input.
    pub fn reading(&self) -> Option<(&[Option<f64>], &Judged)> {
        match &self.given {
            Given::Input(_) => None,
            Given::Reading(y) => self.judged.as_ref().map(|judged| (y.as_slice(), judged)),
        }
    }

    pub fn answer<H>(&self, sensors: &[Sensor<H>]) -> Placed {
        let accepted = self.judged.as_ref().is_none_or(|reading| sensors[self.key.rank - 1].accepts(reading));
        let outcome = if accepted { Outcome::Accepted } else { Outcome::Rejected };
        Placed { outcome, judged: self.judged.clone() }
    }
}

impl<H> Sensor<H> {
    pub(super) fn accepts(&self, reading: &Judged) -> bool {
        self.gate.is_none_or(|gate| reading.chi2.is_some_and(|chi2| chi2 <= gate))
    }
}

/// The system from one time to another; none where they are the same.
///
/// # Errors
/// [`Code::NotFinite`](crate::Code::NotFinite) naming t.
pub fn step(system: &Continuous, from: f64, to: f64) -> Result<Option<Discrete>, Error> {
    if from == to {
        return Ok(None);
    }
    let renamed = |mut error: Error| {
        error.argument = "t".into();
        error
    };
    system.discretize(to - from).map(Some).map_err(renamed)
}

/// The belief at the end of a step from a known moment.
///
/// # Errors
/// [`Code::NotFinite`](crate::Code::NotFinite).
pub fn predicted(known: &Moment, step: Option<&Discrete>) -> Result<Belief, Error> {
    let Some(Discrete { f, g, v }) = step else { return Ok(known.belief.clone()) };
    known.belief.predicted(f, v, Some((g, &known.input))).map_err(named)
}

#[cold]
fn named(error: filters::Error) -> Error {
    Error::from(error).called(Argument::letter)
}
