//! What the filter made of the readings of one landmark, as sums.

use super::frame::{LogLandmark, LogLandmarkStatistics};
use estimate::drive::{Judged, Sensor};
use filters::Autocorrelation;
use lab::words;

words! {
    /// A sensor of a log.
    pub enum LogSensor {
        /// Fixes of the position.
        Fix = "fix",
        /// Headings.
        Heading = "heading",
        /// Ranges alone.
        Range = "range",
        /// Ranges with a bearing.
        Bearing = "bearing",
    }
}

/// Sums over the readings of a landmark.
#[derive(Clone, Debug, Default)]
pub(super) struct Seen {
    refused: u32,
    /// Of the innovations of all readings.
    innovations: f64,
    /// Of d²/p over the used ones.
    nis: f64,
    normalized: Autocorrelation<1>,
    /// Of the innovations of the used bearings, rad, and how many these are.
    pub bearings: f64,
    pub count: u32,
}

impl Seen {
    pub fn take(&mut self, judged: &Judged) {
        self.innovations += judged.innovation;
        if !judged.used {
            self.refused += 1;
            return;
        }
        self.normalized.take(judged.normalized());
        self.nis += judged.d2 / f64::from(judged.outputs);
        if let Some(bearing) = judged.bearing {
            self.bearings += bearing;
            self.count += 1;
        }
    }

    /// What they say of the landmark with this id.
    pub fn told(&self, id: u32) -> LogLandmark {
        let (used, refused) = (self.normalized.count(), self.refused);
        LogLandmark {
            id,
            used,
            refused,
            mean_innovation: (used + refused > 0).then(|| self.innovations / f64::from(used + refused)),
        }
    }

    /// Whether they are what the model claims.
    pub fn statistics(&self) -> LogLandmarkStatistics {
        let used = self.normalized.count();
        LogLandmarkStatistics {
            nis: (used > 0).then(|| self.nis / f64::from(used)),
            mean: self.normalized.mean(),
            lag1: self.normalized.at(1),
            mean_bearing: (self.count > 0).then(|| self.bearings / f64::from(self.count)),
        }
    }
}

impl From<Sensor> for LogSensor {
    fn from(sensor: Sensor) -> Self {
        match sensor {
            Sensor::Fix => Self::Fix,
            Sensor::Heading => Self::Heading,
            Sensor::Range => Self::Range,
            Sensor::Bearing => Self::Bearing,
        }
    }
}
