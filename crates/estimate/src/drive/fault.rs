//! The kinds of what may be wrong with a log or its settings.

/// A kind of fault, in the order in which they are named where their evidence ties.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fault {
    /// The robot did not start where the filter does.
    Start,
    /// A sensor's clock is late, or early.
    Clock,
    /// What is read is off by a constant: a turn rate, a range.
    Bias,
    /// A speed or a range reads too much or too little by a share.
    Scale,
    /// The distances and turns of odometry read too much or too little by a share.
    Odometry,
    /// The scale and the offset of the ranges are wrong, and so are the ways that are driven.
    Lengths,
    /// The speed and the turn rate of two wheels read too much or too little by the same share.
    WheelSize,
    /// Turn rates read too much or too little by a share.
    TurnScale,
    /// Turns are off by an angle for each metre, as of a robot with one wheel larger than the other.
    UnequalWheels,
    /// The antenna stands elsewhere on the robot than is set.
    Antenna,
    /// Outliers: more readings lie far off than a normal distribution has.
    Tails,
    /// A standard deviation is claimed too small or too large.
    Sigma,
    /// The camera does not look straight ahead, or the compass reads another north.
    Turned,
    /// Turns are counted the other way round.
    Mirrored,
    /// Bearings are counted the other way round.
    MirroredBearings,
    /// The ranges of one landmark are off by a constant, as behind a wall.
    LandmarkBias,
    /// Two landmarks are taken for one another.
    Exchanged,
    /// A landmark stands elsewhere than its row says.
    Displaced,
}

impl Fault {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Clock => "clock",
            Self::Bias => "bias",
            Self::Scale => "scale",
            Self::Odometry => "odometry",
            Self::Lengths => "lengths",
            Self::WheelSize => "wheel-size",
            Self::TurnScale => "turn-scale",
            Self::UnequalWheels => "unequal-wheels",
            Self::Antenna => "antenna",
            Self::Tails => "tails",
            Self::Sigma => "sigma",
            Self::Turned => "turned",
            Self::Mirrored => "mirrored",
            Self::MirroredBearings => "mirrored-bearings",
            Self::LandmarkBias => "landmark-bias",
            Self::Exchanged => "exchanged",
            Self::Displaced => "displaced",
        }
    }
}
