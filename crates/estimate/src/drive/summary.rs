//! What a replay says of itself: errors against the truth, and whether its innovations are what the model claims.

use filters::Autocorrelation;
use nalgebra::DVector;
use numerics::sqrt;

/// The summary of a replay. What cannot be said is `None`: errors without a truth, statistics without a used sighting.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Sightings that corrected the estimate.
    pub used: u32,
    /// Sightings that did not: beyond the gate, or of a landmark that the estimate stood on.
    pub refused: u32,
    /// Root of the mean squared distance between estimate and truth at the rows of motion, m.
    pub rmse: Option<f64>,
    /// The largest such distance, m.
    pub worst: Option<f64>,
    /// Mean of d²/p over the used sightings, p the outputs of each: 1 is expected.
    pub nis: Option<f64>,
    /// Mean of ν₁/√S₁₁ over the used sightings: 0 is expected.
    pub mean_innovation: Option<f64>,
    /// Autocorrelation of ν₁/√S₁₁ from one used sighting to the next: 0 is expected. `None` of fewer than two, or where
    /// all are equal.
    pub lag1: Option<f64>,
    /// The learned ε.
    pub epsilon: Option<f64>,
    /// Its standard deviation.
    pub epsilon_sigma: Option<f64>,
    /// The final state: `[x, y, θ]` in m, m and rad, and ε where it is learned.
    pub x: DVector<f64>,
    /// The trace of the pose's covariance, m² and rad² added up.
    pub trace: f64,
}

/// Sums over the errors of the position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Errors {
    count: u32,
    squares: f64,
    worst: f64,
}

impl Errors {
    pub fn take(&mut self, distance: f64) {
        self.count += 1;
        self.squares += distance * distance;
        self.worst = self.worst.max(distance);
    }

    pub fn rmse(&self) -> Option<f64> {
        (self.count > 0).then(|| sqrt(self.squares / f64::from(self.count)))
    }

    pub fn worst(&self) -> Option<f64> {
        (self.count > 0).then_some(self.worst)
    }
}

/// Sums over normalized innovations n = ν₁/√S₁₁, of constant memory however many there are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Innovations {
    normalized: Autocorrelation<1>,
    nis: f64,
}

impl Innovations {
    /// Takes n and d²/p of a used sighting.
    pub fn take(&mut self, n: f64, nis: f64) {
        self.normalized.take(n);
        self.nis += nis;
    }

    pub fn count(&self) -> u32 {
        self.normalized.count()
    }

    pub fn nis(&self) -> Option<f64> {
        (self.count() > 0).then(|| self.nis / f64::from(self.count()))
    }

    pub fn mean(&self) -> Option<f64> {
        self.normalized.mean()
    }

    pub fn lag1(&self) -> Option<f64> {
        self.normalized.at(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken(values: &[f64]) -> Innovations {
        let mut sums = Innovations::default();
        values.iter().for_each(|n| sums.take(*n, n * n));
        sums
    }

    #[test]
    fn what_cannot_be_said_is_none() {
        assert_eq!((taken(&[]).nis(), taken(&[]).mean(), taken(&[]).lag1()), (None, None, None));
        assert_eq!((taken(&[3.0]).nis(), taken(&[3.0]).mean(), taken(&[3.0]).lag1()), (Some(9.0), Some(3.0), None));
        assert_eq!((Errors::default().rmse(), Errors::default().worst()), (None, None));
    }
}
