//! What may be wrong with a log or its settings, and what was found of it.

use crate::drive::evidence::Against;
use crate::drive::fault::Fault;
use crate::drive::fitted::Fitted;
use crate::drive::sensor::Sensor;
use crate::drive::tried::Tried;
use alloc::vec::Vec;

/// How far a verdict commits itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// The readings are much likelier with this fault than without, and than with any other.
    Sure,
    /// Much likelier than without; another explains them about as well, or better.
    Maybe,
    /// No likelier than chance explains.
    Cleared,
}

/// A number: what the settings say, and what the readings do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// As it is set.
    pub now: f64,
    /// Where the readings are likeliest.
    pub value: f64,
    /// The standard deviation of `value`; infinite where the readings do not tell it.
    pub sigma: f64,
    /// Whether `value` is the last that is tried: the readings are likeliest there or beyond, and it is no estimate.
    pub end: bool,
}

/// A fault that was looked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Suspect {
    /// Of which kind.
    pub fault: Fault,
    /// The setting that mends it; `None` of the start and of what no setting mends. Of outliers, which a gate refuses,
    /// the σ of their sensor, where that is another one behind the gate.
    pub number: Option<Fitted>,
    /// The setting that mends it together with that one: the other of the ranges' scale and offset, or a second delay;
    /// of an antenna the delay that is off as well.
    pub with: Option<Fitted>,
    /// The sensor whose readings have outliers.
    pub sensor: Option<Sensor>,
    /// The two landmarks that are exchanged, by their ids, or the one that stands elsewhere or whose ranges are off.
    pub landmarks: Vec<u32>,
    /// The numbers; of the start x, y and θ in m, m and rad; of a landmark x and y in m, or by how much its ranges
    /// are too long; of outliers their share, and σ where that is another one behind the gate; of
    /// odometry the shares by which distances and, where it turns, turns are larger than they are read; of turn rates
    /// that share; of unequal wheels by how much more the robot turns to its left on each metre than is read, rad/m;
    /// of an antenna how far ahead of the robot's centre and how far to its left it stands, m, and
    /// the delay where one is off as well, s.
    pub sizes: Vec<Size>,
    /// The least of the standard deviations that readings bring, their median and the greatest: of a factor on them.
    pub claims: Option<[f64; 3]>,
    /// Of a share of the turns by how much noise of what is read makes them look larger: its σ counts that.
    pub dilution: Option<f64>,
    /// By how much the log-likelihood of the readings rises where it is freed.
    pub gain: f64,
    /// By how much that is more than the best of all suspects brings by chance, in 97 of 100 logs without a fault; 0 at
    /// most where no size is two of its own standard deviations away from what is set.
    pub excess: f64,
    /// What is said of it.
    pub standing: Standing,
    /// Whether it may be the motion model's own half a step between rows of motion: a delay of at most that is cleared,
    /// and a longer one may be it where half a step and chance make the readings as likely.
    pub own: bool,
    /// From where to where the likelihood of a delay is the same, where the motion has rows too rarely to tell more.
    pub flat: Option<[f64; 2]>,
    /// How far the mended filter is from the truth, of those that were held against it.
    pub mended: Option<Against>,
}

impl Suspect {
    /// What was tried.
    pub(crate) fn tried(&self) -> Tried {
        match (self.fault, self.number, self.sensor) {
            (Fault::Mirrored, ..) => Tried::Mirrored,
            (Fault::MirroredBearings, ..) => Tried::MirroredBearings,
            (Fault::Lengths, ..) => Tried::Lengths,
            (Fault::WheelSize, ..) => Tried::WheelSize,
            (Fault::TurnScale, ..) => Tried::TurnScale,
            (Fault::UnequalWheels, ..) => Tried::UnequalWheels,
            (Fault::Antenna, ..) => Tried::Antenna(self.with),
            (Fault::Exchanged, ..) => Tried::Exchanged,
            (Fault::Displaced, ..) => Tried::Displaced,
            (Fault::LandmarkBias, ..) => Tried::LandmarkBias,
            (Fault::Odometry, ..) => Tried::Odometry(self.sizes.len()),
            (Fault::Tails, _, Some(sensor)) => Tried::Outliers(sensor),
            (Fault::Clock, ..) if self.with.is_some() => Tried::Together(
                crate::drive::tried::READINGS
                    .map(|it| self.sizes.len() > 2 || [self.number, self.with].contains(&Some(it))),
            ),
            (_, Some(_), _) if self.with.is_some() => Tried::Ruler,
            (_, Some(number), _) => Tried::Number(number),
            (_, None, _) => Tried::Start,
        }
    }
}
