//! What the readings of a sensor have told, over all of a time line's history.

use super::history::Event;
use super::output::Output;
use super::sensor::{Judged, Sensor};
use alloc::string::String;
use alloc::vec::Vec;

/// What became of a sensor's readings, those before the window as well. It is of the readings in their order of time:
/// what comes late may change it.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorStatistics {
    /// The sensor's name.
    pub name: String,
    /// How many readings have corrected the belief.
    pub used: usize,
    /// How many lie beyond the gate.
    pub refused: usize,
    /// The mean of νᵀS⁻¹ν over the parts of the readings used: 1 is expected. Nothing where none was used.
    pub nis: Option<f64>,
    /// The mean innovation of each output over the readings used; nothing where it was never read. Zero is expected.
    pub mean_innovation: Vec<Option<f64>>,
}

/// The sums of a sensor's readings.
#[derive(Clone, Debug)]
pub struct Tally {
    used: usize,
    refused: usize,
    chi2: f64,
    /// Of how many parts χ² is the sum.
    parts: usize,
    /// The sum of the innovations of each output, and of how many.
    innovations: Vec<(f64, usize)>,
}

impl Tally {
    pub fn of(sensor: &Sensor<impl Output>) -> Self {
        Self { used: 0, refused: 0, chi2: 0.0, parts: 0, innovations: alloc::vec![(0.0, 0); sensor.h.outputs()] }
    }

    /// Counts a reading of the sensor.
    pub fn add(&mut self, y: &[Option<f64>], judged: &Judged, accepted: bool) {
        if !accepted {
            self.refused += 1;
            return;
        }
        self.used += 1;
        if let Some(chi2) = judged.chi2 {
            self.chi2 += chi2;
            self.parts += judged.innovation.len();
        }
        let read = self.innovations.iter_mut().zip(y).filter(|(_, part)| part.is_some());
        for ((sums, _), innovation) in read.zip(&judged.innovation) {
            sums.0 += innovation;
            sums.1 += 1;
        }
    }

    pub fn statistics(&self, name: &str) -> SensorStatistics {
        let mean = |sum: f64, count: usize| (count > 0).then(|| sum / count as f64).filter(|mean| mean.is_finite());
        SensorStatistics {
            name: name.into(),
            used: self.used,
            refused: self.refused,
            nis: mean(self.chi2, self.parts),
            mean_innovation: self.innovations.iter().map(|&(sum, count)| mean(sum, count)).collect(),
        }
    }
}

/// Counts what an event has told, where it is a reading.
pub fn count<H>(tallies: &mut [Tally], sensors: &[Sensor<H>], event: &Event) {
    if let Some((y, judged)) = event.reading() {
        let sensor = event.key.rank - 1;
        tallies[sensor].add(y, judged, sensors[sensor].accepts(judged));
    }
}
