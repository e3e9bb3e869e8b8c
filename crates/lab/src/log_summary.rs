//! What the replay of a log says of itself, as a view knows it.

use crate::described;
use crate::interface::{About, Interface};
use crate::shape::{Field, Plain, Shape};
use estimate::drive::{BearingSummary, FixSummary, SensorSummary, Sensors, Summary, Withheld};
use nalgebra::DVector;

described! {
    /// What the replay says of itself so far; null where there is nothing to say it of.
    Summary as "LogSummary"; &[], &[];
    {
        /// Readings that corrected the estimate.
        used: u32 as "used";
        /// Readings that did not.
        refused: u32 as "refused";
        /// Root of the mean squared error of the position at the rows of motion, metres.
        rmse: Option<f64> as "rmse";
        /// The largest error of the position, metres.
        worst: Option<f64> as "worst";
        /// The same root of the smoothed track; null until smooth() was called.
        rmse_smoothed: Option<f64> as "rmseSmoothed";
        /// The mean over the used readings of νᵀS⁻¹ν for each output: 1 is expected.
        nis: Option<f64> as "nis";
        /// The mean over the used readings of ν/√S of the first output: 0 is expected.
        mean_innovation: Option<f64> as "meanInnovation";
        /// The autocorrelation of ν/√S from one used reading to the next: 0 is expected.
        lag1: Option<f64> as "lag1";
        /// Σ −½ (ln det 2πS + νᵀS⁻¹ν) over the used readings.
        log_likelihood: Option<f64> as "logLikelihood";
        /// What each sensor that the log has says.
        sensors: Sensors as "sensors";
        /// The learned ε.
        epsilon: Option<f64> as "epsilon";
        /// Its standard deviation.
        epsilon_sigma: Option<f64> as "epsilonSigma";
        /// The learned κ.
        speed_scale: Option<f64> as "speedScale";
        /// Its standard deviation.
        speed_scale_sigma: Option<f64> as "speedScaleSigma";
        /// The learned bias b of the turn rate, radians a second.
        turn_bias: Option<f64> as "turnBias";
        /// Its standard deviation.
        turn_bias_sigma: Option<f64> as "turnBiasSigma";
        /// How far the track is from the fixes that are withheld from it; null where none are.
        withheld: Option<Withheld> as "withheld";
        /// The state [x, y, θ] in metres and radians; then ε, κ and b as far as they are learned.
        x: DVector<f64> as "x";
        /// The trace of the pose's covariance, m² and rad² added up.
        trace: f64 as "trace";
    }
}

described! {
    /// What the readings of one sensor say: headings, or ranges alone.
    SensorSummary as "SensorSummary"; &[], &[];
    {
        /// Readings that corrected the estimate.
        used: u32 as "used";
        /// Readings that did not.
        refused: u32 as "refused";
        /// The mean over the used ones of νᵀS⁻¹ν for each output: 1 is expected.
        nis: Option<f64> as "nis";
        /// The mean of ν/√S of the first output: 0 is expected.
        mean_innovation: Option<f64> as "meanInnovation";
        /// Its autocorrelation from one used reading to the next: 0 is expected.
        lag1: Option<f64> as "lag1";
    }
}

described! {
    /// What the fixes say; the first output is x.
    FixSummary as "FixSummary"; &[], &[];
    {
        /// Fixes that corrected the estimate.
        used: u32 as "used";
        /// Fixes that did not.
        refused: u32 as "refused";
        /// The mean over the used ones of νᵀS⁻¹ν for each output: 1 is expected.
        nis: Option<f64> as "nis";
        /// The mean of ν/√S of x: 0 is expected.
        mean_innovation: Option<f64> as "meanInnovation";
        /// Its autocorrelation from one used fix to the next: 0 is expected.
        lag1: Option<f64> as "lag1";
        /// The mean of ν/√S along the estimated heading: 0 is expected.
        mean_along: Option<f64> as "meanAlong";
        /// The mean of ν/√S across it, to the left: 0 is expected.
        mean_across: Option<f64> as "meanAcross";
    }
}

described! {
    /// What ranges with a bearing say; the first output is the range.
    BearingSummary as "BearingSummary"; &[], &[];
    {
        /// Sightings that corrected the estimate.
        used: u32 as "used";
        /// Sightings that did not.
        refused: u32 as "refused";
        /// The mean over the used ones of νᵀS⁻¹ν for each output: 1 is expected.
        nis: Option<f64> as "nis";
        /// The mean of ν/√S of the range: 0 is expected.
        mean_innovation: Option<f64> as "meanInnovation";
        /// Its autocorrelation from one used sighting to the next: 0 is expected.
        lag1: Option<f64> as "lag1";
        /// The mean of ν/√S of the bearing: 0 is expected.
        mean_bearing: Option<f64> as "meanBearing";
        /// Its autocorrelation.
        lag1_bearing: Option<f64> as "lag1Bearing";
    }
}

described! {
    /// How far the track is from the fixes that are withheld from it.
    Withheld as "LogWithheld"; &[], &[];
    {
        /// How many were withheld so far.
        rows: u32 as "rows";
        /// Root of the mean squared distance of the estimate from them, metres.
        rms: Option<f64> as "rms";
        /// The largest such distance, metres.
        worst: Option<f64> as "worst";
        /// The same root of the smoothed track; null until smooth() was called.
        rms_smoothed: Option<f64> as "rmsSmoothed";
        /// The largest distance of the smoothed track, metres.
        worst_smoothed: Option<f64> as "worstSmoothed";
    }
}

const FIELDS: &[Field] = &[
    Field { name: "fix", shape: <Option<FixSummary> as Plain>::SHAPE },
    Field { name: "heading", shape: <Option<SensorSummary> as Plain>::SHAPE },
    Field { name: "range", shape: <Option<SensorSummary> as Plain>::SHAPE },
    Field { name: "bearing", shape: <Option<BearingSummary> as Plain>::SHAPE },
];

impl Plain for Sensors {
    const SHAPE: Shape = Shape::Sparse("LogSensors", FIELDS);

    fn write(&self, to: &mut Vec<f64>) {
        self.fix.write(to);
        self.heading.write(to);
        self.range.write(to);
        self.bearing.write(to);
    }
}

impl Interface for Sensors {
    const ABOUT: About = About {
        shape: Self::SHAPE,
        record: " What each sensor says that the log has; the others are not there.",
        fields: &[" Fixes of the position.", " Headings.", " Ranges alone.", " Ranges with a bearing."],
        parameters: &[],
        defaults: &[],
    };
}

/// The interfaces of these.
pub const INTERFACES: &[About] =
    &[Summary::ABOUT, Sensors::ABOUT, FixSummary::ABOUT, SensorSummary::ABOUT, BearingSummary::ABOUT, Withheld::ABOUT];
