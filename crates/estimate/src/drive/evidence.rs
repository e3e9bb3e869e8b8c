//! What a replay says of every reading, so that two replays can be compared reading by reading; and of its errors.

use crate::drive::course::{Course, Otherwise};
use crate::drive::replay::Replay;
use crate::drive::row::Drive;
use crate::drive::sensor::Sensor;
use crate::drive::settings::Settings;
use crate::drive::statistics::{Errors, Judged};
use crate::error::Error;
use alloc::vec::Vec;
use filters::consistency::{chi2_quantile, nees};
use nalgebra::Vector2;

/// Behind a gate a reading is an outlier with this probability, and its innovation then has a standard deviation of so
/// many √S. With these two, readings are likelier as outliers from about the gate [`OUTLIER_GATE`] on.
pub(crate) const OUTLIERS: f64 = 0.02;
const WIDE: f64 = 6.0;
pub(crate) const OUTLIER_GATE: f64 = 0.9995;

/// Where in the space of what may be wrong a replay is done.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    pub settings: Settings,
    pub otherwise: Otherwise,
}

/// A reading as a replay found it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weighed {
    pub row: u32,
    pub sensor: Sensor,
    pub used: bool,
    pub log_likelihood: f64,
    /// L⁻¹ν.
    pub white: [f64; 2],
}

/// How far a filter was from the truth, and how far it claimed to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Against {
    /// Root of the mean squared distance of the position, m.
    pub rmse: f64,
    /// The mean of eᵀP⁻¹e of the position: 2 is expected.
    pub nees: f64,
    /// The share of the errors beyond the ellipse that should hold 95 of 100.
    pub outside: f64,
}

/// A replay's readings, by their rows.
#[derive(Clone, Debug)]
pub(crate) struct Evidence {
    pub readings: Vec<Weighed>,
    pub against: Option<Against>,
}

impl Evidence {
    /// Replays the first `rows` rows.
    pub fn new(drive: &Drive, place: &Trial, rows: u32) -> Result<Self, Error> {
        let course = Course::new(drive, place.settings)?.with(drive, place.otherwise);
        let mut replay = Replay::new(&course);
        let (mut readings, mut compared) = (Vec::new(), Compared::new()?);
        while replay.rows() < rows
            && let Some(taken) = replay.take(drive, &course)?
        {
            if let Some(judged) = taken.judged {
                let gated = course.gates().of(judged.sensor).is_some();
                readings.extend(weighed(taken.row as u32, &judged, gated));
            } else if drive.rows[taken.row].event.is_motion() && !taken.early {
                compared.take(drive, &replay, taken.time);
            }
        }
        // A row has one reading at most, and only delays put them out of order.
        readings.sort_unstable_by_key(|reading| reading.row);
        Ok(Self { readings, against: compared.against() })
    }

    /// How much likelier it makes the readings from a row on than another replay of the same drive: the readings that
    /// both have looked at.
    pub fn gain(&self, other: &Self, from: u32) -> f64 {
        self.gain_of(other, from, |_| true)
    }

    /// That of the readings of some sensors.
    pub fn gain_of(&self, other: &Self, from: u32, of: impl Fn(Sensor) -> bool) -> f64 {
        let both = self.aligned(other).zip(&other.readings);
        both.filter_map(|(mine, its)| mine.map(|mine| (mine, its)))
            .filter(|(_, its)| its.row >= from && of(its.sensor))
            .map(|(mine, its)| mine.log_likelihood - its.log_likelihood)
            .sum()
    }

    /// For each reading of another replay the same one in this.
    pub fn aligned<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = Option<&'a Weighed>> {
        let mut rest = self.readings.iter().peekable();
        other.readings.iter().map(move |its| {
            while rest.peek().is_some_and(|mine| mine.row < its.row) {
                rest.next();
            }
            rest.peek().copied().filter(|mine| mine.row == its.row)
        })
    }

    /// How many readings of a sensor it refused, and how many it looked at.
    pub fn refused(&self, of: impl Fn(Sensor) -> bool) -> [u32; 2] {
        let all = self.readings.iter().filter(|reading| of(reading.sensor));
        all.fold([0, 0], |[refused, all], reading| [refused + u32::from(!reading.used), all + 1])
    }
}

/// d² of an outlier with p numbers, in the units of its own normal distribution. Beyond its mean there the density
/// falls as |ν|⁻ᵖ, whatever S is: how far off an outlier is says nothing of how wide the others are.
fn far(d2: f64, p: f64) -> f64 {
    let share = d2 / (WIDE * WIDE);
    if share <= p { share } else { p + p * libm::log(share / p) }
}

/// How likely a reading is. Behind a gate it may be an outlier, and is taken for one where it is refused.
pub(crate) fn log_likelihood_of(judged: &Judged, gated: bool) -> f64 {
    let p = f64::from(judged.outputs);
    match (gated, judged.used) {
        (false, _) => judged.log_likelihood(),
        (true, true) => judged.log_likelihood() + libm::log(1.0 - OUTLIERS),
        (true, false) => libm::log(OUTLIERS) - 0.5 * (judged.log_det + 2.0 * p * libm::log(WIDE) + far(judged.d2, p)),
    }
}

/// A reading that can be compared.
fn weighed(row: u32, judged: &Judged, gated: bool) -> Option<Weighed> {
    let log_likelihood = log_likelihood_of(judged, gated);
    let reading = Weighed { row, sensor: judged.sensor, used: judged.used, log_likelihood, white: judged.white };
    log_likelihood.is_finite().then_some(reading)
}

/// Sums over the errors of a replay.
struct Compared {
    errors: Errors,
    nees: f64,
    outside: u32,
    /// d² of the 95 % ellipse.
    ellipse: f64,
}

impl Compared {
    fn new() -> Result<Self, Error> {
        Ok(Self { errors: Errors::default(), nees: 0.0, outside: 0, ellipse: chi2_quantile(2, 0.95)? })
    }

    fn take(&mut self, drive: &Drive, replay: &Replay, time: f64) {
        let known = drive.truth.position(time).filter(|_| drive.truth.covers(time));
        let Some([x, y]) = known else { return };
        let error = Vector2::new(replay.pose().x() - x, replay.pose().y() - y);
        // Where P has no inverse nothing is claimed that could be compared.
        let Ok(squared) = nees(&error, &replay.place_covariance()) else { return };
        self.errors.take(numerics::hypot(error[0], error[1]));
        self.nees += squared;
        self.outside += u32::from(squared > self.ellipse);
    }

    fn against(&self) -> Option<Against> {
        let count = f64::from(self.errors.count());
        let (nees, outside) = (self.nees / count, f64::from(self.outside) / count);
        self.errors.rmse().map(|rmse| Against { rmse, nees, outside })
    }
}
