//! How each thing that may be wrong with a log or its settings is tried.

use crate::drive::course::Course;
use crate::drive::evidence::Trial;
use crate::drive::fault::Fault;
use crate::drive::fitted::Fitted;
use crate::drive::row::Drive;
use crate::drive::sensor::Sensor;
use crate::drive::settings::{MAX_ARM, MAX_DELAY};
use alloc::vec::Vec;

/// What is tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Tried {
    Start,
    Number(Fitted),
    /// Scale and offset of the ranges together.
    Ruler,
    /// Scale and offset of the ranges, and the share of the ways that are driven: each makes up for a part of another.
    Lengths,
    /// The delays of several sensors by the same, as of one receiver: which of [`READINGS`].
    Together([bool; 3]),
    Outliers(Sensor),
    /// The distances of odometry alone, or with the turns: how many of the two. So the speed and turn rate of wheels.
    Odometry(usize),
    /// The speed and the turn rate that the same two wheels read, by one share.
    WheelSize,
    /// The turn rates of motion that is held.
    TurnScale,
    /// What is added to the turn on each metre where both are read by the same wheels.
    UnequalWheels,
    /// Where on the robot the antenna stands whose position fixes are, alone or with a delay: theirs or the motion's.
    Antenna(Option<Fitted>),
    Mirrored,
    MirroredBearings,
    Exchanged,
    /// One landmark at another place.
    Displaced,
    /// The ranges of one landmark.
    LandmarkBias,
}

/// Scale and offset of the ranges.
const RULER: [Fitted; 2] = [Fitted::Scale, Fitted::Offset];
/// The delays of what is read beside the motion.
pub(crate) const READINGS: [Fitted; 3] = [Fitted::DelayFix, Fitted::DelayHeading, Fitted::DelaySighting];
/// The first difference of the start's place and heading: a share of their standard deviations, at most so much.
const START_SHARE: f64 = 0.1;
const START_MOST: f64 = 0.1;
/// That of a share of odometry or of turn rates, and from where to where one is tried.
const SHARE: f64 = 1e-4;
const SHARES: [f64; 2] = [-0.9, 9.0];
/// That of what is added to the turn on each metre, rad/m, and the most that is tried.
const SWERVE: f64 = 1e-4;
const MOST_SWERVE: f64 = 1.0;
/// That of an antenna's place, m.
const ARM: f64 = 0.01;
/// That of a delay, s, and at least so many periods of the motion.
const DELAY: f64 = 0.05;
const PERIODS: f64 = 2.0;

impl Tried {
    /// All that a drive may tell.
    pub fn all(drive: &Drive, course: &Course) -> Vec<Self> {
        let (has, s, gate) = (course.sensors(), course.settings(), course.gates());
        let numbers = Fitted::all(drive, course);
        if numbers.is_empty() {
            return Vec::new();
        }
        let free = |sensor: Sensor, on: bool| on && *has.of(sensor) && gate.of(sensor).is_none();
        let sensors = [
            (Sensor::Fix, s.fixes),
            (Sensor::Heading, s.headings),
            (Sensor::Range, s.sightings),
            (Sensor::Bearing, s.sightings),
        ];
        let outliers = sensors.into_iter().filter(|(sensor, on)| free(*sensor, *on)).map(|it| Self::Outliers(it.0));
        // A σ of 0 has no logarithm.
        let landmarks = drive.landmarks.len() > 1 && s.sightings && (has.range || has.bearing);
        let read = READINGS.map(|number| numbers.contains(&number));
        let turning = drive.rows.iter().any(|row| row.event.turns());
        let mounted = turning && has.fix && s.fixes;
        let placed = has.fix && s.fixes || s.sightings && (has.range || has.bearing);
        let ruled = RULER.iter().all(|number| numbers.contains(number));
        let others = [
            (Self::Odometry(1 + usize::from(turning)), placed && drive.motion.is_odometry()),
            (Self::Together(read), read.iter().filter(|it| **it).count() > 1),
            (Self::Ruler, ruled),
            (Self::Lengths, ruled && drive.rows.iter().any(|row| row.event.drives())),
            (Self::TurnScale, turning && !drive.motion.is_odometry()),
            (Self::UnequalWheels, placed && drive.rows.iter().any(|row| row.event.drives_and_turns())),
            // Straight on it looks like a delay.
            (Self::Antenna(None), mounted),
            (Self::Antenna(Some(Fitted::DelayFix)), mounted),
            (Self::Antenna(Some(Fitted::DelaySpeed)), mounted && numbers.contains(&Fitted::DelaySpeed)),
            (Self::Antenna(Some(Fitted::DelayTurn)), mounted && numbers.contains(&Fitted::DelayTurn)),
            (Self::Mirrored, turning),
            (Self::MirroredBearings, s.sightings && has.bearing),
            (Self::Exchanged, landmarks),
            (Self::Displaced, landmarks),
            (Self::LandmarkBias, landmarks),
        ];
        let others = others.into_iter().filter_map(|(tried, there)| there.then_some(tried));
        let open = |number: &Fitted| !number.is_sigma() || number.value(number.get(s)) > 2.0 * Fitted::LEAST;
        let numbers = numbers.iter().copied().filter(open).map(Self::Number);
        core::iter::once(Self::Start).chain(numbers).chain(outliers).chain(others).collect()
    }

    /// What is tried where two wheels alone say how the robot drove and turned. Without a gyro no turn rate has a bias,
    /// and wheels of two sizes are what looks like one; as both wheels read speed and turn rate, a wheel of another
    /// size makes both wrong: they are freed by one factor, and by two.
    pub fn by_wheels(tried: &mut Vec<Self>) {
        tried.retain(|it| *it != Self::Number(Fitted::TurnBias));
        let speed = Self::Number(Fitted::SpeedScale);
        if tried.contains(&speed) && tried.contains(&Self::TurnScale) {
            tried.retain(|it| *it != speed);
            tried.extend([Self::WheelSize, Self::Odometry(2)]);
        }
    }

    pub fn fault(self) -> Fault {
        match self {
            Self::Start => Fault::Start,
            Self::Outliers(_) => Fault::Tails,
            Self::Number(Fitted::TurnBias | Fitted::Offset) => Fault::Bias,
            Self::Number(Fitted::Scale | Fitted::SpeedScale) | Self::Ruler => Fault::Scale,
            Self::Number(Fitted::BearingOffset | Fitted::HeadingOffset) => Fault::Turned,
            Self::Odometry(_) => Fault::Odometry,
            Self::Lengths => Fault::Lengths,
            Self::WheelSize => Fault::WheelSize,
            Self::TurnScale => Fault::TurnScale,
            Self::UnequalWheels => Fault::UnequalWheels,
            Self::Antenna(_) => Fault::Antenna,
            Self::Mirrored => Fault::Mirrored,
            Self::MirroredBearings => Fault::MirroredBearings,
            Self::Exchanged => Fault::Exchanged,
            Self::Displaced => Fault::Displaced,
            Self::LandmarkBias => Fault::LandmarkBias,
            Self::Together(_) => Fault::Clock,
            Self::Number(number) if number.is_delay() => Fault::Clock,
            Self::Number(_) => Fault::Sigma,
        }
    }

    /// Whether it is a σ, or a factor on what is read, either of which may be wrong many times over.
    pub fn is_far(self) -> bool {
        self.fault() == Fault::Scale || self.is_share() || self.numbers().iter().any(|number| number.is_sigma())
    }

    /// Whether motion is taken by shares of what is read.
    fn is_share(self) -> bool {
        matches!(self, Self::Odometry(_) | Self::WheelSize | Self::TurnScale)
    }

    /// Whether readings come at other times: they are in another order, and not all replays have the same ones.
    pub fn delays(self) -> bool {
        self.fault() == Fault::Clock || matches!(self, Self::Antenna(Some(_)))
    }

    /// How many numbers are freed.
    pub fn freedom(self) -> usize {
        match self {
            Self::Start | Self::Lengths => 3,
            Self::Ruler | Self::Displaced => 2,
            Self::Odometry(count) => count,
            Self::Antenna(delay) => 2 + usize::from(delay.is_some()),
            Self::Number(_) | Self::Outliers(_) | Self::Together(_) => 1,
            Self::WheelSize | Self::TurnScale | Self::UnequalWheels | Self::LandmarkBias => 1,
            Self::Mirrored | Self::MirroredBearings | Self::Exchanged => 0,
        }
    }

    /// The settings that are freed.
    pub fn numbers(self) -> Vec<Fitted> {
        match self {
            Self::Number(number) => alloc::vec![number],
            Self::Ruler | Self::Lengths => RULER.to_vec(),
            Self::Together(which) => READINGS.into_iter().zip(which).filter(|it| it.1).map(|it| it.0).collect(),
            _ => Vec::new(),
        }
    }

    /// Where they are, as a search moves them.
    pub fn first(self, place: &Trial) -> Vec<f64> {
        match self {
            Self::Start => return alloc::vec![0.0; 3],
            // By how much it stands elsewhere, and is later, than is set.
            Self::Antenna(_) | Self::Odometry(_) => return alloc::vec![0.0; self.freedom()],
            // By how much all of them are later than they are set.
            Self::Together(_) | Self::WheelSize | Self::TurnScale | Self::UnequalWheels => return alloc::vec![0.0],
            _ => {}
        }
        let mut first: Vec<f64> = self.numbers().iter().map(|number| number.get(&place.settings)).collect();
        first.resize(self.freedom(), 0.0);
        first
    }

    /// The replay in which they are `at`.
    pub fn place(self, place: &Trial, at: &[f64]) -> Trial {
        let mut place = *place;
        match (self, at) {
            (Self::Start, &[x, y, theta]) => place.otherwise.shift = [x, y, theta],
            (Self::Outliers(sensor), _) => {
                *place.settings.gate.of_mut(sensor) = Some(crate::drive::evidence::OUTLIER_GATE);
            }
            (Self::WheelSize, &[share]) => place.otherwise.driven = [share; 2],
            (Self::TurnScale, &[share]) => place.otherwise.driven[1] = share,
            (Self::UnequalWheels, &[swerve]) => place.otherwise.swerve = swerve,
            (Self::Antenna(delay), &[ahead, left, ref later @ ..]) => {
                place.otherwise.antenna = [ahead, left];
                if let (Some(delay), Some(later)) = (delay, later.first()) {
                    let now = delay.get(&place.settings);
                    delay.set(&mut place.settings, now + later);
                }
            }
            (Self::Mirrored, _) => place.otherwise.mirrored = true,
            (Self::MirroredBearings, _) => place.otherwise.clockwise = true,
            (Self::Odometry(_), at) => place.otherwise.driven.iter_mut().zip(at).for_each(|(is, at)| *is = *at),
            (Self::Together(_), &[by]) => self.numbers().iter().for_each(|number| {
                let now = number.get(&place.settings);
                number.set(&mut place.settings, now + by);
            }),
            _ => {
                self.numbers().iter().zip(at).for_each(|(number, at)| number.set(&mut place.settings, *at));
                if let (Self::Lengths, Some(share)) = (self, at.last()) {
                    place.otherwise.driven[0] = *share;
                }
            }
        }
        place
    }

    /// How far differences go, with motion every so many seconds.
    pub fn steps(self, place: &Trial, period: f64) -> Vec<f64> {
        let s = &place.settings;
        let begins = |sigma: f64| (START_SHARE * sigma).min(START_MOST);
        if self == Self::Start {
            return [s.start_sigma, s.start_sigma, s.start_sigma_heading].map(begins).to_vec();
        }
        if self.is_share() {
            return alloc::vec![SHARE; self.freedom()];
        }
        if self == Self::UnequalWheels {
            return alloc::vec![SWERVE];
        }
        let late = DELAY.max(PERIODS * period);
        if let Self::Antenna(_) = self {
            return [ARM, ARM, late][..self.freedom()].to_vec();
        }
        let step = |number: &Fitted| if number.is_delay() { late } else { number.fine() };
        let ways = (self == Self::Lengths).then_some(SHARE);
        self.numbers().iter().take(self.freedom()).map(step).chain(ways).collect()
    }

    /// Where the first is sought beside where it is: a scale at factors half as large again each, an eighth to eight.
    pub fn others(self) -> Vec<f64> {
        let factors = [0.12, 0.2, 0.3, 0.45, 0.65, 1.5, 2.2, 3.3, 5.0, 8.0];
        if self.fault() == Fault::Scale || self.is_share() {
            factors.map(|factor| factor - 1.0).to_vec()
        } else {
            Vec::new()
        }
    }

    /// How far they are tried, with delays changed by at most so much.
    pub fn bounds(self, first: &[f64], most: f64) -> Vec<[f64; 2]> {
        if self == Self::Start {
            return alloc::vec![[f64::MIN, f64::MAX]; 3];
        }
        match self {
            Self::Together(_) => return alloc::vec![[-most, most]],
            Self::Antenna(_) => {
                return [[-MAX_ARM, MAX_ARM], [-MAX_ARM, MAX_ARM], [-most, most]][..self.freedom()].to_vec();
            }
            Self::Odometry(_) | Self::WheelSize | Self::TurnScale => return alloc::vec![SHARES; self.freedom()],
            Self::UnequalWheels => return alloc::vec![[-MOST_SWERVE, MOST_SWERVE]],
            _ => {}
        }
        let bound = |(number, at): (&Fitted, &f64)| match number.is_delay() {
            true => [(at - most).max(-MAX_DELAY), (at + most).min(MAX_DELAY)],
            false => number.bounds(most),
        };
        let ways = (self == Self::Lengths).then_some(SHARES);
        self.numbers().iter().zip(first).map(bound).chain(ways).collect()
    }
}
