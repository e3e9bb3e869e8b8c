//! Types of the core and of its world, as a view knows them.

use crate::interface::{About, Interface};
use crate::{described, worded};
use estimate::drive::{Line, Summary};
use estimate::localizer::SensorKind;
use estimate::{Complex, Landmark, RiccatiLimit, Verdict};
use geom::Ellipse;
use nalgebra::DVector;
use sim::Room;

described! {
    /// An ellipse as a view draws it.
    Ellipse as "Ellipse"; &[], &[];
    {
        /// Half the long axis.
        semi_major: f64 as "semiMajor";
        /// Half the short axis.
        semi_minor: f64 as "semiMinor";
        /// Angle of the long axis, radians in (−π/2, π/2].
        angle: f64 as "angle";
    }
}

type Root = Complex<f64>;

described! {
    /// A complex number.
    Root as "Complex"; &[], &[];
    {
        /// Real part.
        re: f64 as "re";
        /// Imaginary part.
        im: f64 as "im";
    }
}

worded! {
    Verdict { Yes = "yes", No = "no", Undecided = "undecided", }
}

worded! {
    RiccatiLimit {
        FromEveryStart = "from-every-start",
        FromLargeStart = "from-large-start",
        None = "none",
        DependsOnStart = "depends-on-start",
        Undecided = "undecided",
    }
}

worded! {
    SensorKind {
        Range = "range",
        RangeBearing = "range-bearing",
    }
}

described! {
    /// A rectangular room.
    Room as "Room"; &[], &[];
    {
        /// Its name.
        name: &'static str as "name";
        /// West wall, metres.
        x: f64 as "x";
        /// South wall, metres.
        y: f64 as "y";
        /// West to east, metres.
        width: f64 as "width";
        /// South to north, metres.
        height: f64 as "height";
    }
}

described! {
    /// A mapped landmark; ids are whole numbers below 2³², each given once.
    Landmark as "Landmark"; &[], &[];
    {
        /// Its name in the map.
        id: u32 as "id";
        /// Metres.
        x: f64 as "x";
        /// Metres.
        y: f64 as "y";
    }
}

described! {
    /// A straight line through points, with the least squared distances along y.
    Line as "FittedLine"; &[], &[];
    {
        /// y for each x.
        slope: f64 as "slope";
        /// y at x = 0.
        offset: f64 as "offset";
        /// R², the share of the variance of y that it explains.
        r2: f64 as "r2";
    }
}

described! {
    /// What the replay says of itself so far; null where there is nothing to say it of.
    Summary as "LogSummary"; &[], &[];
    {
        /// Sightings that corrected the estimate.
        used: u32 as "used";
        /// Sightings that did not.
        refused: u32 as "refused";
        /// Root of the mean squared error of the position at the rows of motion, metres.
        rmse: Option<f64> as "rmse";
        /// The largest error of the position, metres.
        worst: Option<f64> as "worst";
        /// The mean over the used sightings of νᵀS⁻¹ν for each output: 1 is expected.
        nis: Option<f64> as "nis";
        /// The mean over the used sightings of ν/√S of the range: 0 is expected.
        mean_innovation: Option<f64> as "meanInnovation";
        /// The autocorrelation of ν/√S from one used sighting to the next: 0 is expected.
        lag1: Option<f64> as "lag1";
        /// The learned ε.
        epsilon: Option<f64> as "epsilon";
        /// Its standard deviation.
        epsilon_sigma: Option<f64> as "epsilonSigma";
        /// The state [x, y, θ] in metres and radians; and ε where it is learned.
        x: DVector<f64> as "x";
        /// The trace of the pose's covariance, m² and rad² added up.
        trace: f64 as "trace";
    }
}

/// The interfaces of those that the core's own functions take or answer.
pub const OF_THE_CORE: &[About] = &[Complex::ABOUT, Ellipse::ABOUT, Landmark::ABOUT];

/// The interfaces of the others.
pub const INTERFACES: &[About] = &[Line::ABOUT, Summary::ABOUT, Room::ABOUT];
