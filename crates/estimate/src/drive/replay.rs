//! The replay of a drive, row by row.

use crate::drive::course::{Course, Fate, Otherwise};
use crate::drive::filter::{Filter, Move};
use crate::drive::learned::Rolling;
use crate::drive::read::reading;
use crate::drive::row::{Drive, Event};
use crate::drive::sensor::{BySensor, Sensor};
use crate::drive::statistics::{Errors, Judged, Statistics};
use crate::drive::step::Step;
use crate::drive::summary::Summary;
use crate::error::{Code, Error};
use crate::reading::Setup;
use geom::SE2;
use nalgebra::{DMatrix, Matrix2, Vector2};
use numerics::hypot;

/// A row that was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taken {
    /// Its index among the drive's rows.
    pub row: usize,
    /// When it was measured, s.
    pub time: f64,
    /// Whether it lies before the start, where nothing is estimated yet.
    pub early: bool,
    /// What became of it, if it is a reading that was looked at.
    pub judged: Option<Judged>,
    /// How far the estimate was from a withheld fix, m.
    pub withheld: Option<f64>,
}

/// A localizer that replays a [`Drive`] row by row, along a [`Course`].
///
/// The state is [x, y, θ], and behind it, as far as they are learned, ε, κ and b.
///
/// Over dt seconds, with the distance d and the turn a at the heading θ, x ← [x + d cos θ, y + d sin θ, θ + a] and P ←
/// F P Fᵀ + B diag(σ_d², σ_θ²) Bᵀ dt. `O` rows bring d and a; speeds v and turn rates ω are held and move the estimate
/// to the time of every later row, by d = v (1 + κ) dt and a = (ω − b) dt. Rates that change evenly do so by the mean
/// of a row's rate and the next one's ([`Motion`](crate::drive::Motion)). `D` rows bring d and a that were driven
/// evenly since the row before: they move the estimate to the time of every later row by the share of that time. Both
/// drive along the heading half-way through the turn, θ + a/2. A reading is gated by its d² and taken in Joseph's
/// form.
///
/// # Example
/// ```
/// use estimate::Landmark;
/// use estimate::drive::{Course, Drive, Event, Motion, Replay, Row, Settings, Truth};
/// let drive = Drive {
///     landmarks: vec![Landmark { id: 7, x: 3.0, y: 4.0 }],
///     truth: Truth::default(),
///     rows: vec![
///         Row::new(0.0, Event::Odometry { distance: 0.0, turn: 0.0 }),
///         Row::new(0.5, Event::Range { landmark: 0, range: 4.9 }),
///     ],
///     motion: Motion::Odometry,
/// };
/// let course = Course::new(&drive, Settings::default())?;
/// let mut replay = Replay::new(&course);
/// while let Some(taken) = replay.take(&drive, &course)? {
///     assert_eq!(taken.time, drive.rows[taken.row].time);
/// }
/// assert_eq!(replay.summary(&course).used, 1);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Replay {
    pub(crate) filter: Filter,
    /// The steps behind the replay, and the rows.
    steps: usize,
    rows: u32,
    /// When the estimate was last predicted, s.
    time: f64,
    /// v and ω, as they are held.
    held: Vector2<f64>,
    /// When the last row of odometry was, s; not a number before the first.
    odometry: f64,
    /// The stamp of the last row of each sensor that was not passed over.
    last: BySensor<f64>,
    statistics: Statistics,
    errors: Errors,
    withheld: Errors,
}

impl Replay {
    /// A replay at the start of its course.
    pub fn new(course: &Course) -> Self {
        Self {
            filter: Filter::new(course),
            steps: 0,
            rows: 0,
            time: course.start(),
            held: Vector2::zeros(),
            odometry: f64::NAN,
            last: BySensor::all(f64::NEG_INFINITY),
            statistics: Statistics::default(),
            errors: Errors::default(),
            withheld: Errors::default(),
        }
    }

    /// Takes the next row of `drive`; `None` behind the last.
    ///
    /// # Errors
    /// [`Code::NotFinite`] or [`Code::InnovationNotPositiveDefinite`] where the numbers leave the range of floating
    /// point; the replay is then as it was. [`Code::Limit`] for a landmark that `drive` does not have.
    pub fn take(&mut self, drive: &Drive, course: &Course) -> Result<Option<Taken>, Error> {
        let before = course.splits().then_some(*self);
        let taken = self.taken(drive, course);
        if let (Err(_), Some(before)) = (&taken, before) {
            *self = before;
        }
        taken
    }

    fn taken(&mut self, drive: &Drive, course: &Course) -> Result<Option<Taken>, Error> {
        let mut taken = None;
        while let Some(step) = course.step(drive, self.steps) {
            // The speeds of V rows that are measured behind the last row are a part of it.
            if taken.is_some() && (step.counts || (self.rows as usize) < drive.rows.len()) {
                break;
            }
            let found = self.step(drive, course, &step)?;
            if step.counts {
                taken = Some(found);
            }
            if !course.splits() {
                break;
            }
        }
        Ok(taken)
    }

    /// Takes the next step; after an error the replay is as it was.
    pub(crate) fn step(&mut self, drive: &Drive, course: &Course, step: &Step) -> Result<Taken, Error> {
        let moved = self.moved(course, step);
        let before = (self.filter, self.time);
        let found = self.advance(step, moved.as_ref()).and_then(|()| self.read(drive, course, step));
        match found {
            Ok(_) => self.pass(step),
            Err(_) => (self.filter, self.time) = before,
        }
        found
    }

    /// How the estimate moves to a step; `None` where it does not.
    pub(crate) fn moved(&self, course: &Course, step: &Step) -> Option<Move> {
        if step.time < course.start() {
            return None;
        }
        let dt = (step.time - self.time).max(0.0);
        let Otherwise { arcs, mirrored, driven: [far, much], swerve, .. } = *course.otherwise();
        let u = match (step.way, step.event) {
            (Some(way), _) => self.on(way, step.time)?,
            (None, Event::Odometry { distance, turn }) => Vector2::new(distance, turn),
            _ if course.moves_by().is_odometry() => return None,
            _ => self.held * dt,
        };
        let much = if mirrored { -1.0 - much } else { 1.0 + much };
        let u = Vector2::new((1.0 + far) * u[0], much * u[1] + swerve * u[0]);
        let s = course.settings();
        let noise = Matrix2::new(s.sigma_distance * s.sigma_distance, 0.0, 0.0, s.sigma_turn * s.sigma_turn) * dt;
        // What is driven evenly turns on the way.
        let arcs = arcs || course.moves_by().is_even();
        Some(Move { u, rolling: Rolling { dt, speed_scale: s.speed_scale, turn_bias: s.turn_bias, arcs }, noise })
    }

    /// What of a row of odometry is driven until `time`, evenly from the row before on; all of the first at its end.
    fn on(&self, [end, distance, turn]: [f64; 3], time: f64) -> Option<Vector2<f64>> {
        let all = Vector2::new(distance, turn);
        if self.odometry.is_nan() {
            return (time >= end).then_some(all);
        }
        let (whole, part) = (end - self.odometry, time - self.time.max(self.odometry));
        Some(if whole > 0.0 { all * (part / whole).clamp(0.0, 1.0) } else { all })
    }

    /// Moves the estimate, and its time, to a step.
    pub(crate) fn advance(&mut self, step: &Step, moved: Option<&Move>) -> Result<(), Error> {
        if let Some(moved) = moved {
            self.filter.predict(moved)?;
            self.time = self.time.max(step.time);
        }
        Ok(())
    }

    /// Takes what was measured in a step that the estimate has moved to.
    pub(crate) fn read(&mut self, drive: &Drive, course: &Course, step: &Step) -> Result<Taken, Error> {
        match step.event {
            Event::Velocity { v, omega } => self.held = Vector2::new(v, omega),
            Event::Speed { v } => self.held[0] = v,
            Event::TurnRate { omega } => self.held[1] = omega,
            Event::Odometry { .. } => self.odometry = step.time,
            _ => {}
        }
        let early = step.time < course.start();
        let taken = Taken { row: step.row, time: step.time, early, judged: None, withheld: None };
        if early {
            return Ok(taken);
        }
        let Some(sensor) = Sensor::of(&step.event) else {
            let known = drive.truth.position(step.time).filter(|_| step.counts);
            if let Some([x, y]) = known {
                self.errors.take(hypot(self.pose().x() - x, self.pose().y() - y));
            }
            return Ok(taken);
        };
        let mut last = self.last;
        match (course.fate(step, &mut last), step.event) {
            (Some(Fate::LookedAt), _) => {}
            (Some(Fate::Withheld), Event::Position { x, y, .. }) => {
                let [ahead, left] = course.antenna();
                let antenna = self.pose().compose(SE2::new(ahead, left, 0.0));
                let distance = hypot(antenna.x() - x, antenna.y() - y);
                self.withheld.take(distance);
                return Ok(Taken { withheld: Some(distance), ..taken });
            }
            _ => return Ok(taken),
        }
        let judged = self.judged(drive, course, &step.event, sensor)?;
        self.last = last;
        match judged {
            Some(judged) => self.statistics.take(&judged),
            None => self.statistics.refuse(sensor),
        }
        Ok(Taken { judged, ..taken })
    }

    /// What becomes of a reading; `None` where the estimate stands on the landmark.
    fn judged(
        &mut self,
        drive: &Drive,
        course: &Course,
        event: &Event,
        sensor: Sensor,
    ) -> Result<Option<Judged>, Error> {
        let (s, gate) = (course.settings(), *course.gates().of(sensor));
        let heading = self.pose().theta();
        let setup = Setup { map: course.map(drive), scale: (!s.learn).then_some(s.scale), offset: s.offset, gate };
        let Some(reading) = reading(course, event) else { return Ok(None) };
        match self.filter.correct(&reading, &setup) {
            Ok(corrected) => Judged::new(sensor, &corrected, heading, gate.is_some()).map(Some),
            Err(error) if error.code == Code::AtLandmark => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// The estimated pose.
    pub fn pose(&self) -> SE2 {
        self.filter.estimate().0
    }

    /// The learned ε; `None` where it is given.
    pub fn epsilon(&self) -> Option<f64> {
        let (_, which, numbers) = self.filter.estimate();
        which.epsilon().map(|at| numbers[at - 3])
    }

    /// P, from 3×3 to, with all that can be learned in the state, 6×6.
    pub fn covariance(&self) -> DMatrix<f64> {
        self.filter.covariance()
    }

    /// The covariance of x and y.
    pub(crate) fn place_covariance(&self) -> Matrix2<f64> {
        self.filter.place_covariance()
    }

    /// The time that the estimate is of, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// How many rows were taken.
    pub fn rows(&self) -> u32 {
        self.rows
    }

    /// How many steps were taken.
    pub(crate) fn steps(&self) -> usize {
        self.steps
    }

    /// Stands behind a step that was taken.
    pub(crate) fn pass(&mut self, step: &Step) {
        self.steps += 1;
        self.rows += u32::from(step.counts);
    }

    /// What the replay says of itself so far.
    pub fn summary(&self, course: &Course) -> Summary {
        let belief = (self.filter.state(), self.filter.covariance());
        Summary::new(belief, course, &self.statistics, [&self.errors, &self.withheld])
    }
}
