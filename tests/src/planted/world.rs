//! Drives that are made up with known noise.

use core::f64::consts::{PI, TAU};
use estimate::Landmark;
use estimate::drive::{Drive, Event, Motion, Pose, Row, Settings, Truth};
use geom::wrap;
use sim::Noise;

/// A robot and its sensors.
#[derive(Clone, Copy, Debug)]
pub struct World {
    /// What it is called in a table.
    pub name: &'static str,
    /// How many beacons or landmarks stand around.
    pub landmarks: usize,
    /// Whether their bearings are seen too.
    pub bearings: bool,
    /// Seconds between readings of landmarks, of fixes, and of headings; 0 of none.
    pub periods: [f64; 3],
    /// Metres a second, about.
    pub speed: f64,
    /// Whether the motion is read as `O` rows, else as speeds and turn rates.
    pub odometry: bool,
    /// Whether speeds and turn rates change evenly from row to row, as of a robot that is read, and not at the rows.
    pub even: bool,
    /// Seconds.
    pub duration: f64,
    /// Seconds between rows of motion.
    pub period: f64,
    /// Whether it turns on its way, on arcs, and not at the end of each step as the filter has it.
    pub arcs: bool,
    /// σ of motion and sensors.
    pub settings: fn() -> Settings,
}

/// Beacons, a camera, a car, a compass, a mower.
pub const WORLDS: [World; 5] = [
    World {
        name: "beacons",
        landmarks: 5,
        bearings: false,
        periods: [0.25, 0.0, 0.0],
        speed: 1.0,
        odometry: false,
        even: false,
        duration: 100.0,
        period: 0.1,
        arcs: false,
        settings: || Settings { sigma_range: 0.15, sigma_distance: 0.05, sigma_turn: 0.03, ..Settings::default() },
    },
    World {
        name: "camera",
        landmarks: 8,
        bearings: true,
        periods: [0.4, 0.0, 0.0],
        speed: 0.7,
        odometry: false,
        even: false,
        duration: 80.0,
        period: 0.1,
        arcs: false,
        settings: || Settings { sigma_range: 0.1, sigma_bearing: 0.03, sigma_turn: 0.04, ..Settings::default() },
    },
    World {
        name: "car",
        landmarks: 0,
        bearings: false,
        periods: [0.0, 0.5, 0.0],
        speed: 8.0,
        odometry: false,
        even: false,
        duration: 160.0,
        period: 0.1,
        arcs: false,
        settings: || Settings { sigma_fix: 0.8, sigma_distance: 0.3, sigma_turn: 0.02, ..Settings::default() },
    },
    World {
        name: "compass",
        landmarks: 0,
        bearings: false,
        periods: [0.0, 0.5, 0.3],
        speed: 2.0,
        odometry: false,
        even: false,
        duration: 120.0,
        period: 0.1,
        arcs: false,
        settings: || Settings { sigma_fix: 0.4, sigma_heading: 0.04, sigma_distance: 0.15, ..Settings::default() },
    },
    World {
        name: "mower",
        landmarks: 4,
        bearings: false,
        periods: [0.3, 0.0, 0.0],
        speed: 0.8,
        odometry: true,
        even: false,
        duration: 110.0,
        period: 0.1,
        arcs: false,
        settings: || Settings { sigma_range: 0.2, sigma_distance: 0.06, sigma_turn: 0.04, ..Settings::default() },
    },
];

/// Two robots that turn on their way, whose fixes are precise: one reads its motion rarely.
pub const ARCS: [World; 2] = [World { period: 0.5, ..TURNING }, World { period: 0.1, ..TURNING }];

const TURNING: World = World {
    name: "turning",
    landmarks: 0,
    bearings: false,
    periods: [0.0, 0.5, 0.0],
    speed: 1.5,
    odometry: false,
    even: false,
    duration: 200.0,
    period: 0.1,
    arcs: true,
    settings: || Settings { sigma_fix: 0.05, sigma_distance: 0.02, sigma_turn: 0.01, ..Settings::default() },
};

/// A log, and the settings under which it is looked at.
#[derive(Clone, Debug)]
pub struct Log {
    /// The log.
    pub drive: Drive,
    /// The settings.
    pub settings: Settings,
}

/// A robot stands so long at first, s.
const REST: f64 = 2.0;
/// So long it takes to get going, where rates change evenly, s.
const STARTS: f64 = 1.0;

impl World {
    /// The same world, whose robot changes its rates evenly and turns on its way, as tables of speeds are read.
    pub fn even(self) -> Self {
        Self { even: true, arcs: true, ..self }
    }

    /// A drive through it without a fault: the robot stands, then drives in loops at changing speed. Where there is no
    /// truth, the start is known as well as its standard deviations say.
    pub fn sound(&self, seed: u64, truth: bool) -> Log {
        let (mut noise, mut settings) = (Noise::new(seed), (self.settings)());
        let landmarks = self.placed(&mut noise);
        let mut drawn = || noise.uniform();
        let side = if drawn() < 0.5 { -1.0 } else { 1.0 };
        let (slow, swing) = (8.0 + 8.0 * drawn(), 9.0 + 12.0 * drawn());
        let (a, b) = (TAU * drawn(), TAU * drawn());
        let speed = |t: f64| self.speed * (1.0 + 0.6 * libm::sin(TAU * t / slow + a));
        let rate = |t: f64| side * 0.15 + 0.35 * libm::sin(TAU * t / swing + b);
        let read = |t: f64| if t < REST { [0.0; 2] } else { [speed(t), rate(t)] };
        // What changes evenly does not jump at the start.
        let started = |t: f64| read(t).map(|rate| rate * ((t - REST) / STARTS).clamp(0.0, 1.0));
        let mut rows = Vec::new();
        let mut pose = [0.0, 0.0, 2.0 * PI * (drawn() - 0.5)];
        let begin = pose;
        let (mut time, mut held, mut since) = (0.0, [0.0; 2], [0.0; 2]);
        let mut poses = Vec::new();
        for (at, what) in self.moments() {
            let dt: f64 = at - time;
            let root = dt.sqrt();
            // The rate half-way has the integral over a short time, but for its third order.
            let rates = if self.even { started(0.5 * (time + at)) } else { held };
            let [d, turn] = rates.map(|rate| rate * dt);
            let true_d = d + settings.sigma_distance * root * noise.normal();
            let true_turn = turn + settings.sigma_turn * root * noise.normal();
            let half = if self.arcs { 0.5 * true_turn } else { 0.0 };
            let chord = if half == 0.0 { true_d } else { true_d * libm::sin(half) / half };
            let (sin, cos) = libm::sincos(pose[2] + half);
            pose = [pose[0] + chord * cos, pose[1] + chord * sin, wrap(pose[2] + true_turn)];
            (time, since) = (at, [since[0] + d, since[1] + turn]);
            let event = match what {
                0 => {
                    poses.push(Pose { time, x: pose[0], y: pose[1], theta: pose[2] });
                    held = if self.even { started(time) } else { read(time) };
                    let [distance, turn] = core::mem::take(&mut since);
                    if self.odometry {
                        Event::Odometry { distance, turn }
                    } else {
                        Event::Velocity { v: held[0], omega: held[1] }
                    }
                }
                1 => self.sighting(&landmarks, pose, &settings, &mut noise),
                2 => {
                    let (x, y) = (noise.normal() * settings.sigma_fix, noise.normal() * settings.sigma_fix);
                    Event::Position { x: pose[0] + x, y: pose[1] + y, sigma: None }
                }
                _ => Event::Heading { theta: wrap(pose[2] + settings.sigma_heading * noise.normal()), sigma: None },
            };
            rows.push(Row { time, event, line: rows.len() as u32 });
        }
        if !truth {
            let (place, heading) = (settings.start_sigma, settings.start_sigma_heading);
            let off = [place, place, heading].map(|sigma| sigma * noise.normal());
            settings.start = Some([begin[0] + off[0], begin[1] + off[1], begin[2] + off[2]]);
        }
        let motion = match (self.odometry, self.even) {
            (true, _) => Motion::EvenOdometry,
            (_, true) => Motion::EvenVelocity,
            _ => Motion::Velocity,
        };
        let truth = Truth::new(if truth { poses } else { Vec::new() });
        Log { drive: Drive { landmarks, truth, rows, motion }, settings }
    }

    /// Landmarks around the loops.
    fn placed(&self, noise: &mut Noise) -> Vec<Landmark> {
        let place = |i: usize| {
            let angle = TAU * (i as f64 + 0.6 * noise.uniform()) / self.landmarks as f64;
            let far = 6.0 + 12.0 * noise.uniform();
            Landmark { id: i as u32, x: far * libm::cos(angle), y: far * libm::sin(angle) }
        };
        (0..self.landmarks).map(place).collect()
    }

    /// When something happens, and what: motion (0), a landmark (1), a fix (2), a heading (3). Motion comes first.
    fn moments(&self) -> Vec<(f64, u8)> {
        let count = |period: f64| if period > 0.0 { (self.duration / period) as u32 } else { 0 };
        let motions = (0..count(self.period)).map(|k| (f64::from(k) * self.period, 0));
        // A log that moves by `O` rows says nothing of where the robot was between them.
        let at = |time: f64| if self.odometry { (time / self.period).round() * self.period } else { time };
        let readings = (1..=3).zip(self.periods).flat_map(|(what, period)| {
            (0..count(period)).map(move |k| (at(f64::from(k) * period + 0.003 * f64::from(what)), what))
        });
        let mut moments: Vec<(f64, u8)> = motions.chain(readings).collect();
        moments.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        moments
    }

    fn sighting(&self, landmarks: &[Landmark], pose: [f64; 3], settings: &Settings, noise: &mut Noise) -> Event {
        let landmark = (noise.uniform() * landmarks.len() as f64) as usize;
        let (dx, dy) = (landmarks[landmark].x - pose[0], landmarks[landmark].y - pose[1]);
        let range = (libm::hypot(dx, dy) + settings.sigma_range * noise.normal()).max(0.01);
        if !self.bearings {
            return Event::Range { landmark, range };
        }
        let bearing = wrap(libm::atan2(dy, dx) - pose[2] + settings.sigma_bearing * noise.normal());
        Event::RangeBearing { landmark, range, bearing }
    }
}
