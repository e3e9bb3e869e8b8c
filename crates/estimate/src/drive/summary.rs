//! What a replay says of itself: errors against the truth, and whether its innovations are what the model claims.

use crate::drive::course::Course;
use crate::drive::statistics::{Errors, Innovations, Statistics};
use nalgebra::{DMatrix, DVector};
use numerics::sqrt;

/// What the readings of one sensor say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorSummary {
    /// Readings that corrected the estimate.
    pub used: u32,
    /// Readings that did not: beyond the gate, or of a landmark that the estimate stood on.
    pub refused: u32,
    /// Mean of d²/p over the used ones: 1 is expected.
    pub nis: Option<f64>,
    /// Mean of ν/√S of the first number: 0 is expected.
    pub mean_innovation: Option<f64>,
    /// Its autocorrelation from one used reading to the next: 0 is expected.
    pub lag1: Option<f64>,
}

/// What the fixes say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixSummary {
    /// Fixes that corrected the estimate.
    pub used: u32,
    /// Fixes beyond the gate.
    pub refused: u32,
    /// Mean of d²/p over the used ones: 1 is expected.
    pub nis: Option<f64>,
    /// Mean of ν/√S of x: 0 is expected.
    pub mean_innovation: Option<f64>,
    /// Its autocorrelation from one used fix to the next: 0 is expected.
    pub lag1: Option<f64>,
    /// Mean of ν/√S along the estimated heading: 0 is expected; fixes and speed with other delays show here.
    pub mean_along: Option<f64>,
    /// Mean of ν/√S across it, to the left.
    pub mean_across: Option<f64>,
}

/// What sightings with a bearing say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingSummary {
    /// Sightings that corrected the estimate.
    pub used: u32,
    /// Sightings that did not: beyond the gate, or of a landmark that the estimate stood on.
    pub refused: u32,
    /// Mean of d²/p over the used ones: 1 is expected.
    pub nis: Option<f64>,
    /// Mean of ν/√S of the range: 0 is expected.
    pub mean_innovation: Option<f64>,
    /// Its autocorrelation from one used sighting to the next: 0 is expected.
    pub lag1: Option<f64>,
    /// Mean of ν/√S of the bearing: 0 is expected.
    pub mean_bearing: Option<f64>,
    /// Its autocorrelation from one used sighting to the next.
    pub lag1_bearing: Option<f64>,
}

/// What each sensor that the log has says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sensors {
    /// Fixes.
    pub fix: Option<FixSummary>,
    /// Headings.
    pub heading: Option<SensorSummary>,
    /// Ranges alone.
    pub range: Option<SensorSummary>,
    /// Ranges with a bearing.
    pub bearing: Option<BearingSummary>,
}

/// How far the track is from the fixes that were withheld from it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Withheld {
    /// How many were withheld so far.
    pub rows: u32,
    /// Root of the mean squared distance of the filter's estimate from them, m.
    pub rms: Option<f64>,
    /// The largest such distance, m.
    pub worst: Option<f64>,
    /// The same of the smoothed track, once it is computed.
    pub rms_smoothed: Option<f64>,
    /// The largest.
    pub worst_smoothed: Option<f64>,
}

/// The summary of a replay. What cannot be said is `None`: errors without a truth, statistics without a used reading.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Readings that corrected the estimate.
    pub used: u32,
    /// Readings that did not: beyond the gate, or of a landmark that the estimate stood on.
    pub refused: u32,
    /// Root of the mean squared distance between estimate and truth at the rows of motion, m.
    pub rmse: Option<f64>,
    /// The largest such distance, m.
    pub worst: Option<f64>,
    /// The root of the mean squared distance of the smoothed track, once it is computed.
    pub rmse_smoothed: Option<f64>,
    /// Mean of d²/p over the used readings, p the outputs of each: 1 is expected.
    pub nis: Option<f64>,
    /// Mean of ν₁/√S₁₁ over the used readings: 0 is expected.
    pub mean_innovation: Option<f64>,
    /// Autocorrelation of ν₁/√S₁₁ from one used reading to the next: 0 is expected. `None` of fewer than two, or where
    /// all are equal.
    pub lag1: Option<f64>,
    /// Σ −½ (ln det 2πS + d²) over the used readings; `None` of none.
    pub log_likelihood: Option<f64>,
    /// What each sensor says.
    pub sensors: Sensors,
    /// The learned ε.
    pub epsilon: Option<f64>,
    /// Its standard deviation.
    pub epsilon_sigma: Option<f64>,
    /// The learned κ.
    pub speed_scale: Option<f64>,
    /// Its standard deviation.
    pub speed_scale_sigma: Option<f64>,
    /// The learned b, rad/s.
    pub turn_bias: Option<f64>,
    /// Its standard deviation.
    pub turn_bias_sigma: Option<f64>,
    /// What the withheld fixes say; `None` where none are withheld.
    pub withheld: Option<Withheld>,
    /// The final state: `[x, y, θ]` in m, m and rad, then ε, κ and b as far as they are learned.
    pub x: DVector<f64>,
    /// The trace of the pose's covariance, m² and rad² added up.
    pub trace: f64,
}

impl Summary {
    /// Of a state and its covariance, and of the sums so far.
    pub(crate) fn new(
        (x, p): (DVector<f64>, DMatrix<f64>),
        course: &Course,
        sums: &Statistics,
        [errors, withheld]: [&Errors; 2],
    ) -> Self {
        let which = course.which();
        let value = |at: Option<usize>| at.map(|i| x[i]);
        let sigma = |at: Option<usize>| at.map(|i| sqrt(p[(i, i)].max(0.0)));
        let Statistics { all, .. } = sums;
        let settings = course.settings();
        Self {
            used: all.count(),
            refused: all.refused(),
            rmse: errors.rmse(),
            worst: errors.worst(),
            rmse_smoothed: None,
            nis: all.nis(),
            mean_innovation: all.mean(),
            lag1: all.lag1(),
            log_likelihood: (all.count() > 0).then_some(sums.log_likelihood),
            sensors: sensors(sums, course),
            epsilon: value(which.epsilon()),
            epsilon_sigma: sigma(which.epsilon()),
            speed_scale: value(which.speed_scale()),
            speed_scale_sigma: sigma(which.speed_scale()),
            turn_bias: value(which.turn_bias()),
            turn_bias_sigma: sigma(which.turn_bias()),
            withheld: settings.withheld.filter(|_| settings.fixes).map(|_| Withheld {
                rows: withheld.count(),
                rms: withheld.rmse(),
                worst: withheld.worst(),
                ..Withheld::default()
            }),
            trace: p[(0, 0)] + p[(1, 1)] + p[(2, 2)],
            x,
        }
    }
}

fn sensors(sums: &Statistics, course: &Course) -> Sensors {
    let of = |sums: &Innovations| SensorSummary {
        used: sums.count(),
        refused: sums.refused(),
        nis: sums.nis(),
        mean_innovation: sums.mean(),
        lag1: sums.lag1(),
    };
    let (each, has) = (&sums.each, course.sensors());
    let fixes = each.fix.count();
    let mean = |sum: f64| (fixes > 0).then(|| sum / f64::from(fixes));
    Sensors {
        fix: has.fix.then(|| {
            let SensorSummary { used, refused, nis, mean_innovation, lag1 } = of(&each.fix);
            let (mean_along, mean_across) = (mean(sums.along[0]), mean(sums.along[1]));
            FixSummary { used, refused, nis, mean_innovation, lag1, mean_along, mean_across }
        }),
        heading: has.heading.then(|| of(&each.heading)),
        range: has.range.then(|| of(&each.range)),
        bearing: has.bearing.then(|| {
            let SensorSummary { used, refused, nis, mean_innovation, lag1 } = of(&each.bearing);
            let (mean_bearing, lag1_bearing) = (sums.bearings.mean(), sums.bearings.at(1));
            BearingSummary { used, refused, nis, mean_innovation, lag1, mean_bearing, lag1_bearing }
        }),
    }
}
