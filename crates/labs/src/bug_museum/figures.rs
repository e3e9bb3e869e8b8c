//! The figures of a run: each panel in a few numbers.

use super::filter::{Filter, Outcome};
use filters::Autocorrelation;
use filters::consistency::nees;
use geom::SE2;
use nalgebra::{DMatrix, Matrix3, Vector3};

/// The lags of the autocorrelation.
pub(super) const LAGS: usize = 10;
/// How many figures a run has.
pub const FIGURES: usize = 14;

/// The panels, in the order of the page, and which of the figures belong to each.
pub const PANELS: [(&str, &[usize]); 7] = [
    ("map", &[0, 1]),
    ("error", &[2]),
    ("nees", &[3]),
    ("nis", &[4, 5, 6, 7]),
    ("mean", &[8, 9]),
    ("correlation", &[10, 11]),
    ("covariance", &[12, 13]),
];

/// P as a panel shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Covariance {
    /// The smallest eigenvalue of P with each state in its own standard deviation, hence without units.
    pub least: f64,
    /// The largest |Pᵢⱼ − Pⱼᵢ|, as a part of the largest entry.
    pub asymmetry: f64,
}

impl Covariance {
    pub fn of(p: &Matrix3<f64>) -> Self {
        let scale = p.diagonal().map(|variance| variance.abs().sqrt().max(f64::MIN_POSITIVE));
        let scaled = DMatrix::from_fn(3, 3, |i, j| 0.5 * (p[(i, j)] + p[(j, i)]) / (scale[i] * scale[j]));
        let found = numerics::eigenvalues(&scaled).unwrap_or_default();
        let least = found.iter().map(|root| root.re).min_by(f64::total_cmp).unwrap_or(f64::NAN);
        Self { least, asymmetry: (p - p.transpose()).amax() / p.amax().max(f64::MIN_POSITIVE) }
    }
}

/// What is compared at each step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Compared {
    /// Truth less estimate, the heading the short way round.
    pub error: Vector3<f64>,
    /// Two standard deviations of each, as claimed; 0 where a variance is negative.
    pub two_sigma: [f64; 3],
    /// None where P is no covariance.
    pub nees: Option<f64>,
    pub covariance: Covariance,
}

impl Compared {
    pub fn new(truth: SE2, filter: &Filter) -> Self {
        let error = truth.boxminus(filter.pose());
        let two_sigma = [0, 1, 2].map(|i| 2.0 * filter.p[(i, i)].max(0.0).sqrt());
        Self { error, two_sigma, nees: nees(&error, &filter.p).ok(), covariance: Covariance::of(&filter.p) }
    }
}

/// Sums over a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Sums {
    steps: u32,
    squares: f64,
    along: f64,
    beyond: u32,
    nees: (f64, u32),
    nis: [f64; 3],
    sighted: u32,
    used: u32,
    pub range: Autocorrelation<LAGS>,
    pub bearing: Autocorrelation<LAGS>,
    least: Option<f64>,
    asymmetry: f64,
}

impl Sums {
    pub fn take(&mut self, truth: SE2, compared: &Compared) {
        let Compared { error, two_sigma, nees, covariance } = compared;
        self.steps += 1;
        self.squares += error[0] * error[0] + error[1] * error[1];
        let (sin, cos) = libm::sincos(truth.theta());
        self.along += cos * error[0] + sin * error[1];
        self.beyond += (0..3).map(|i| u32::from(error[i].abs() > two_sigma[i])).sum::<u32>();
        if let Some(nees) = nees {
            self.nees = (self.nees.0 + nees, self.nees.1 + 1);
        }
        self.least = Some(self.least.map_or(covariance.least, |least| least.min(covariance.least)));
        self.asymmetry = self.asymmetry.max(covariance.asymmetry);
    }

    pub fn take_reading(&mut self, outcome: &Outcome) {
        self.sighted += 1;
        if !outcome.used {
            return;
        }
        self.used += 1;
        let normalized = outcome.normalized();
        let squares = [outcome.nis.unwrap_or(0.0), normalized[0] * normalized[0], normalized[1] * normalized[1]];
        squares.iter().zip(&mut self.nis).for_each(|(square, sum)| *sum += square);
        self.range.take(normalized[0]);
        self.bearing.take(normalized[1]);
    }

    /// The mean NEES of the steps at which P is a covariance.
    pub fn mean_nees(&self) -> Option<f64> {
        (self.nees.1 > 0).then(|| self.nees.0 / f64::from(self.nees.1))
    }

    /// The figures, in the order of [`PANELS`]: root mean square and mean forward error of the position (m), share of
    /// errors beyond 2 σ, mean NEES, mean NIS, that of the range and of the bearing alone, share of readings refused,
    /// mean normalized innovation of range and of bearing, their autocorrelation at lag 1, smallest eigenvalue,
    /// asymmetry. NaN where there is nothing to compute a figure from.
    pub fn figures(&self) -> [f64; FIGURES] {
        let (steps, used) = (f64::from(self.steps), f64::from(self.used));
        let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
        [
            (self.squares / steps).sqrt(),
            self.along / steps,
            f64::from(self.beyond) / (3.0 * steps),
            number(self.mean_nees()),
            self.nis[0] / used,
            self.nis[1] / used,
            self.nis[2] / used,
            1.0 - used / f64::from(self.sighted),
            number(self.range.mean()),
            number(self.bearing.mean()),
            number(self.range.at(1)),
            number(self.bearing.at(1)),
            number(self.least),
            self.asymmetry,
        ]
    }
}
