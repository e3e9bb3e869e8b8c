//! What a replay does: its settings, where and when it starts, and in which order it takes what was measured.

use crate::drive::learned::Which;
use crate::drive::row::{Drive, Event, Motion};
use crate::drive::sensor::{BySensor, Sensor};
use crate::drive::settings::{Delays, Settings};
use crate::drive::step::{Step, at_rates, means, order, step, way, ways};
use crate::error::Error;
use crate::landmark::Landmark;
use alloc::vec::Vec;
use filters::consistency::chi2_quantile;
use geom::SE2;

/// A row is passed over where it comes more than this before its turn, s: stamps that are a period apart to rounding
/// are a period apart.
const EARLY: f64 = 1e-9;

/// What is done with a reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fate {
    /// Nothing: its sensor is off.
    Off,
    /// Its distance from the estimate is taken.
    Withheld,
    /// Nothing: it comes too soon after another.
    PassedOver,
    /// It is gated, and corrects the estimate.
    LookedAt,
}

/// What a verdict takes otherwise than settings say it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Otherwise {
    /// What is added to the pose at the start: m, m, rad.
    pub shift: [f64; 3],
    /// Whether the robot turns on the way, and not at its end.
    pub arcs: bool,
    /// Whether the turns have the other sign.
    pub mirrored: bool,
    /// Whether the bearings have the other sign.
    pub clockwise: bool,
    /// By what share the distances of odometry and the turns of any motion are larger than they are read.
    pub driven: [f64; 2],
    /// By how much more the robot turns to its left on each metre than is read, rad.
    pub swerve: f64,
    /// By how much the antenna stands farther ahead, and to the left, than is set, m.
    pub antenna: [f64; 2],
    /// Two landmarks, by their places in the list, that are taken for one another.
    pub exchanged: Option<[usize; 2]>,
    /// A landmark, by its place in the list, whose ranges read so much too long, m.
    pub biased: Option<(usize, f64)>,
    /// A landmark, by its place in the list, that stands beside its place by so much, m.
    pub displaced: Option<(usize, [f64; 2])>,
}

/// How a drive is replayed under some settings.
///
/// Each row was measured at its stamp less its sensor's delay, and rows go by that time: at equal times motion before
/// readings, then by their lines. Only where there are delays is an order kept, of four bytes for each row.
///
/// It starts at the first true pose, at its time. Where there is no truth, it starts at the pose that the settings
/// name, when the first fix was measured; where there are no fixes either, when the first row was. Rows of held motion
/// before the start say what is held; others are skipped.
#[derive(Clone, Debug)]
pub struct Course {
    settings: Settings,
    motion: Motion,
    /// The steps, where they are not the rows as they stand: twice the row's index, and 1 for the speed of a `V` whose
    /// turn is a step of its own.
    order: Option<Vec<u32>>,
    splits: bool,
    /// Of odometry that is driven evenly, for each step the row of odometry that is next, itself included; behind the
    /// last none.
    ways: Vec<u32>,
    /// Of rates that change evenly, by row: their means until the next row of their kind.
    means: Vec<[f64; 2]>,
    steps: usize,
    start: f64,
    pose: SE2,
    gates: BySensor<Option<f64>>,
    sensors: BySensor<bool>,
    otherwise: Otherwise,
    /// The landmarks, where one is taken to stand elsewhere than the drive says.
    map: Option<Vec<Landmark>>,
}

impl Course {
    /// The course of `drive` under these settings.
    ///
    /// # Errors
    /// [`crate::Code::NotFinite`] or [`crate::Code::Limit`] naming the setting: a standard deviation of a sensor or of
    /// the start is not above 0, one of the motion is negative, a gate is no probability between 0 and 1, a delay is
    /// beyond ten seconds, 1 + scale or 1 + κ is not positive, or a log of `O` rows is asked for what only speeds and
    /// turn rates have.
    pub fn new(drive: &Drive, settings: Settings) -> Result<Self, Error> {
        settings.check(drive.motion)?;
        let Delays { speed, turn, .. } = settings.delays;
        let splits = speed != turn;
        let order = (settings.delays != Delays::default()).then(|| order(drive, &settings.delays));
        let mut sensors = BySensor::default();
        for sensor in drive.rows.iter().filter_map(|row| Sensor::of(&row.event)) {
            *sensors.of_mut(sensor) = true;
        }
        let mut gates = BySensor::all(None);
        for sensor in [Sensor::Fix, Sensor::Heading, Sensor::Range, Sensor::Bearing] {
            let gate = settings.gate.of(sensor);
            *gates.of_mut(sensor) = gate.map(|p| chi2_quantile(sensor.outputs(), p)).transpose()?;
        }
        let steps = order.as_ref().map_or(drive.rows.len(), Vec::len);
        let (start, pose, motion) = (0.0, SE2::new(0.0, 0.0, 0.0), drive.motion);
        let otherwise = Otherwise::default();
        let ways = if motion == Motion::EvenOdometry { ways(drive, order.as_deref()) } else { Vec::new() };
        let means = if motion == Motion::EvenVelocity { means(drive) } else { Vec::new() };
        let map = None;
        let mut course =
            Self { settings, motion, order, splits, ways, means, steps, start, pose, gates, sensors, otherwise, map };
        if let Some(first) = drive.truth.poses().first() {
            course.start = first.time;
            course.pose = SE2::new(first.x, first.y, first.theta);
            return Ok(course);
        }
        let [x, y, theta] = settings.start.unwrap_or_default();
        course.pose = SE2::new(x, y, theta);
        let fix = drive.rows.iter().find(|row| matches!(row.event, Event::Position { .. }));
        let first = fix.map(|row| row.time - settings.delays.fix);
        course.start = first.or(course.step(drive, 0).map(|step| step.time)).unwrap_or(0.0);
        Ok(course)
    }

    /// The same, but for what is taken otherwise.
    pub(crate) fn with(mut self, drive: &Drive, otherwise: Otherwise) -> Self {
        if let Some((landmark, [x, y])) = otherwise.displaced {
            let mut map = drive.landmarks.clone();
            map.get_mut(landmark).into_iter().for_each(|it| (it.x, it.y) = (it.x + x, it.y + y));
            self.map = Some(map);
        }
        let (pose, [x, y, theta]) = (self.pose, otherwise.shift);
        if otherwise.antenna != [0.0; 2] && drive.truth.poses().is_empty() {
            // The start was taken from fixes, and they are of the antenna.
            let [ahead, left] = otherwise.antenna;
            let robot = pose.compose(SE2::new(-ahead, -left, 0.0));
            return Self { pose: robot, otherwise, ..self };
        }
        if otherwise.shift == [0.0; 3] {
            return Self { otherwise, ..self };
        }
        Self { pose: SE2::new(pose.x() + x, pose.y() + y, pose.theta() + theta), otherwise, ..self }
    }

    /// Where the landmarks are taken to stand.
    pub(crate) fn map<'a>(&'a self, drive: &'a Drive) -> &'a [Landmark] {
        self.map.as_deref().unwrap_or(&drive.landmarks)
    }

    /// The landmark that a row which names one is taken to have seen.
    pub(crate) fn seen(&self, landmark: usize) -> usize {
        match self.otherwise.exchanged {
            Some([a, b]) if landmark == a => b,
            Some([a, b]) if landmark == b => a,
            _ => landmark,
        }
    }

    /// A range to a landmark, as it is taken.
    pub(crate) fn range_to(&self, landmark: usize, range: f64) -> f64 {
        match self.otherwise.biased {
            Some((biased, by)) if landmark == biased => range - by,
            _ => range,
        }
    }

    /// Where the antenna is taken to stand on the robot: ahead and to the left, m.
    pub(crate) fn antenna(&self) -> [f64; 2] {
        let ([ahead, left], more) = (self.settings.antenna, self.otherwise.antenna);
        [ahead + more[0], left + more[1]]
    }

    /// What is taken otherwise than the settings say.
    pub(crate) fn otherwise(&self) -> &Otherwise {
        &self.otherwise
    }

    /// The settings.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// When the replay starts, s. Rows of held motion before it say what is held; others are skipped.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// Where the replay starts.
    pub fn pose(&self) -> SE2 {
        self.pose
    }

    /// Which sensors the drive has.
    pub fn sensors(&self) -> &BySensor<bool> {
        &self.sensors
    }

    /// When the first and the last row were measured, s; `None` where there is no row.
    pub fn span(&self, drive: &Drive) -> Option<[f64; 2]> {
        Some([self.step(drive, 0)?.time, self.step(drive, self.steps.checked_sub(1)?)?.time])
    }

    /// How many readings of the drive are looked at: those of sensors that are on, neither withheld nor passed over.
    pub fn looked_at(&self, drive: &Drive) -> u32 {
        let mut last = BySensor::all(f64::NEG_INFINITY);
        let steps = (0..self.steps).map_while(|position| self.step(drive, position));
        let looks = |step: &Step| step.time >= self.start && self.fate(step, &mut last) == Some(Fate::LookedAt);
        steps.filter(looks).count() as u32
    }

    /// What is done with a reading, by its stamp and those before; `None` of a row of motion. `last` is the stamp of
    /// each sensor's last row that was not passed over.
    pub(crate) fn fate(&self, step: &Step, last: &mut BySensor<f64>) -> Option<Fate> {
        let (sensor, settings) = (Sensor::of(&step.event)?, &self.settings);
        let on = match sensor {
            Sensor::Fix => settings.fixes,
            Sensor::Heading => settings.headings,
            Sensor::Range | Sensor::Bearing => settings.sightings,
        };
        let withheld = settings.withheld.filter(|_| sensor == Sensor::Fix);
        Some(if !on {
            Fate::Off
        } else if withheld.is_some_and(|[from, to]| from < step.stamp && step.stamp < to) {
            Fate::Withheld
        } else if step.stamp - last.of(sensor) < settings.every.of(sensor) - EARLY {
            Fate::PassedOver
        } else {
            *last.of_mut(sensor) = step.stamp;
            Fate::LookedAt
        })
    }

    /// How the robot moves.
    pub(crate) fn moves_by(&self) -> Motion {
        self.motion
    }

    /// A step by its place in the order.
    pub(crate) fn step(&self, drive: &Drive, position: usize) -> Option<Step> {
        let code = match &self.order {
            None => u32::try_from(2 * position).ok()?,
            Some(order) => *order.get(position)?,
        };
        let step = step(drive, code, &self.settings.delays)?;
        let event = self.means.get(step.row).map_or(step.event, |means| at_rates(step.event, *means));
        Some(Step { event, way: self.ways.get(position).and_then(|row| way(drive, *row)), ..step })
    }

    /// Which numbers are learned.
    pub(crate) fn which(&self) -> Which {
        let Settings { learn: epsilon, learn_speed: speed_scale, learn_bias: turn_bias, .. } = self.settings;
        Which { epsilon, speed_scale, turn_bias }
    }

    pub(crate) fn gates(&self) -> &BySensor<Option<f64>> {
        &self.gates
    }

    /// Whether a row may be in two steps.
    pub(crate) fn splits(&self) -> bool {
        self.splits
    }
}
