//! Types of the core and of its world, as a view knows them.

use crate::interface::{About, Interface};
use crate::parameter::Knob;
use crate::shape::{Plain, Shape};
use crate::{described, worded};
use estimate::drive::{BySensor, Line};
use estimate::localizer::SensorKind;
use estimate::{Complex, Landmark, RiccatiLimit, Verdict};
use geom::Ellipse;
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

/// The sensors of a log, as a caller names them.
const SENSORS: &[&str] = &["fix", "heading", "range", "bearing"];

impl<T: Plain + 'static> Plain for BySensor<T> {
    const SHAPE: Shape = Shape::Each(SENSORS, &T::SHAPE);

    fn write(&self, to: &mut Vec<f64>) {
        self.each().into_iter().for_each(|(_, value)| value.write(to));
    }
}

impl<T: Knob + 'static> Knob for BySensor<T> {
    const LIMITS: [f64; 3] = T::LIMITS;

    fn read(from: &mut core::slice::Iter<'_, f64>) -> Self {
        Self { fix: T::read(from), heading: T::read(from), range: T::read(from), bearing: T::read(from) }
    }
}

/// The interfaces of those that the core's own functions take or answer.
pub const OF_THE_CORE: &[About] = &[Complex::ABOUT, Ellipse::ABOUT, Landmark::ABOUT];

/// The interfaces of the others.
pub const INTERFACES: &[About] = &[Line::ABOUT, Room::ABOUT];
