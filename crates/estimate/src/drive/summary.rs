//! What a replay says of itself: errors against the truth, and whether its innovations are what the model claims.

use nalgebra::DVector;

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
    /// Autocorrelation of ν₁/√S₁₁ from one used sighting to the next: 0 is expected. `None` of fewer than two, or where all
    /// are equal.
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
        (self.count > 0).then(|| (self.squares / f64::from(self.count)).sqrt())
    }

    pub fn worst(&self) -> Option<f64> {
        (self.count > 0).then_some(self.worst)
    }
}

/// Sums over normalized innovations n = ν₁/√S₁₁, of constant memory however many there are. They are taken less the first, so
/// that a mean far from 0 costs no digits of the autocorrelation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Innovations {
    count: u32,
    first: f64,
    last: f64,
    sum: f64,
    squares: f64,
    products: f64,
    nis: f64,
}

impl Innovations {
    /// Takes n and d²/p of a used sighting.
    pub fn take(&mut self, n: f64, nis: f64) {
        if self.count == 0 {
            self.first = n;
        }
        let shifted = n - self.first;
        self.products += self.last * shifted;
        self.count += 1;
        self.sum += shifted;
        self.squares += shifted * shifted;
        self.nis += nis;
        self.last = shifted;
    }

    pub fn count(&self) -> u32 {
        self.count
    }

    pub fn nis(&self) -> Option<f64> {
        (self.count > 0).then(|| self.nis / f64::from(self.count))
    }

    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.first + self.sum / f64::from(self.count))
    }

    /// Σ cᵢcᵢ₊₁ / Σ cᵢ² with cᵢ = nᵢ − n̄, multiplied out: Σ nᵢnᵢ₊₁ − n̄ (2 Σ nᵢ − n_first − n_last) + (count − 1) n̄².
    pub fn lag1(&self) -> Option<f64> {
        if self.count < 2 {
            return None;
        }
        let count = f64::from(self.count);
        let mean = self.sum / count;
        let variance = self.squares - count * mean * mean;
        // The first is 0 less itself.
        let covariance = self.products - mean * (2.0 * self.sum - self.last) + (count - 1.0) * mean * mean;
        (variance > 0.0).then(|| covariance / variance)
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
    fn the_autocorrelation_is_its_definition() {
        for values in [vec![1.0, 2.0, 4.0, -3.0], vec![1e6 + 1.0, 1e6 - 1.0, 1e6 + 2.0], vec![0.5, -0.5]] {
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            let c: Vec<f64> = values.iter().map(|n| n - mean).collect();
            let exact = c.windows(2).map(|w| w[0] * w[1]).sum::<f64>() / c.iter().map(|c| c * c).sum::<f64>();
            assert!((taken(&values).lag1().expect("two or more") - exact).abs() < 1e-9, "{values:?}");
            // The sum of the values rounds by a few last digits of the largest.
            let most = values.iter().fold(0.0, |most: f64, n| most.max(n.abs()));
            assert!((taken(&values).mean().expect("some") - mean).abs() < 4.0 * f64::EPSILON * most, "{values:?}");
        }
    }

    #[test]
    fn what_cannot_be_said_is_none() {
        assert_eq!((taken(&[]).nis(), taken(&[]).mean(), taken(&[]).lag1()), (None, None, None));
        assert_eq!((taken(&[3.0]).nis(), taken(&[3.0]).mean(), taken(&[3.0]).lag1()), (Some(9.0), Some(3.0), None));
        assert_eq!(taken(&[3.0, 3.0]).lag1(), None, "equal values have no correlation");
        assert_eq!((Errors::default().rmse(), Errors::default().worst()), (None, None));
    }
}
