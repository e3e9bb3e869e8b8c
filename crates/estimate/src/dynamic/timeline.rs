//! A time line: readings of several sensors, each at the time at which it was measured, in whatever order they come.

mod history;
mod output;
mod sensor;
mod statistics;

pub use output::{AnyOutput, Map, Output, OwnOutput};
pub use sensor::{Judged, MAX_AHEAD, MAX_CAPACITY, MAX_DELAY, MAX_SENSORS, Memory, Outcome, Placed, Sensor};
pub use statistics::SensorStatistics;

use super::{Belief, Continuous};
use crate::error::{Code, Error};
use crate::kf::belief_fits;
use crate::validate::{self, size};
use alloc::collections::VecDeque;
use alloc::vec::Vec;
use history::{Event, Given, Key, Moment};
use nalgebra::{DMatrix, DVector};
use statistics::{Tally, count};

/// A Kalman filter in continuous time that keeps the last `window` seconds of events. What comes late is put in its
/// place, and what follows is replayed: the belief is that of the sorted events **to the last bit**, in whatever order
/// they came, as long as none is [too late](Outcome::TooLate).
///
/// Events go by the time at which they were measured; at one time an input comes first, then readings by their sensors
/// as these are declared, then by id. An input is held until the next; before the first it is zero. For each event of a
/// system with n states, m inputs and p outputs 3 n² + n m + n + m + p² + 2 p numbers are kept.
///
/// # Example
/// ```
/// use estimate::dynamic::{Continuous, Memory, Outcome, Sensor, Timeline};
/// use nalgebra::{DMatrix, dmatrix, dvector};
/// // Position and speed of a cart; one sensor reads the position, half a second late, another the speed.
/// let (a, b) = (dmatrix![0.0, 1.0; 0.0, 0.0], DMatrix::zeros(2, 0));
/// let system = Continuous::new(a, b, dmatrix![0.0, 0.0; 0.0, 0.1])?;
/// let belief = estimate::validate::belief(dvector![0.0, 0.0], DMatrix::identity(2, 2))?;
/// let position = Sensor {
///     name: "position".into(),
///     h: dmatrix![1.0, 0.0],
///     w: dmatrix![0.04],
///     delay: 0.5,
///     gate: Some(9.0),
/// };
/// let speed = Sensor {
///     name: "speed".into(),
///     h: dmatrix![0.0, 1.0],
///     w: dmatrix![0.01],
///     delay: 0.0,
///     gate: None,
/// };
/// let memory = Memory { window: 5.0, capacity: 100 };
/// let mut line = Timeline::new(system, &belief, 0.0, memory, vec![position, speed])?;
/// line.reading("speed", 0.4, &[Some(1.0)], 0)?;
/// line.reading("speed", 0.8, &[Some(1.1)], 0)?;
/// // Stamped 0.9, measured at 0.4.
/// assert_eq!(line.reading("position", 0.9, &[Some(0.5)], 0)?.outcome, Outcome::Accepted);
/// // Half a metre at 0.4, and about 1.1 m/s since.
/// assert!((line.at(1.0)?.x[0] - 1.15).abs() < 0.05);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Timeline<H = DMatrix<f64>> {
    system: Continuous,
    sensors: Vec<Sensor<H>>,
    memory: Memory,
    start: f64,
    /// The latest time of an event.
    newest: f64,
    /// What is known after all events before the window.
    base: Moment,
    /// What the readings before the window have told, sensor by sensor.
    past: Vec<Tally>,
    /// The events in the window, sorted.
    events: VecDeque<Event>,
}

impl<H: Output> Timeline<H> {
    /// The time line of `system` with the `belief` at `time`, in seconds of any clock, and its sensors in their order.
    ///
    /// # Errors
    /// Naming belief, time, window, capacity or sensors, with a sensor's name and field: [`Code::Shape`],
    /// [`Code::NotFinite`], [`Code::Limit`], [`Code::Index`] for two of one name, and those of
    /// [`validate::covariance`] for W.
    pub fn new(
        system: Continuous,
        belief: &Belief,
        time: f64,
        memory: Memory,
        sensors: Vec<Sensor<H>>,
    ) -> Result<Self, Error> {
        let (n, m) = system.sizes();
        belief_fits(belief, n)?;
        let start = validate::finite(time, "time")? + 0.0;
        if validate::finite(memory.window, "window")? <= 0.0 {
            return Err(Error::new(Code::Limit, "window", "must be more than no time"));
        }
        validate::count(memory.capacity, MAX_CAPACITY, "capacity")?;
        size(sensors.len(), MAX_SENSORS, "sensors")?;
        let mut checked: Vec<Sensor<H>> = Vec::with_capacity(sensors.len());
        for sensor in sensors {
            let path = ["sensors.", &sensor.name].concat();
            if checked.iter().any(|other| other.name == sensor.name) {
                return Err(Error::new(Code::Index, path, "is the name of two sensors"));
            }
            checked.push(sensor.checked(n).map_err(|e| e.within(&path))?);
        }
        let sensors = checked;
        let base = Moment { time: start, input: DVector::zeros(m), belief: belief.clone() };
        let past = sensors.iter().map(Tally::of).collect();
        Ok(Self { system, sensors, memory, start, newest: start, base, past, events: VecDeque::new() })
    }

    /// The input is `u` (m) from the time `t` on.
    ///
    /// # Errors
    /// [`Code::Shape`] or [`Code::NotFinite`], naming t or u, or what of the events cannot be replayed with it; the
    /// time line is then as it was.
    pub fn input(&mut self, t: f64, u: &[f64]) -> Result<Placed, H::Fault> {
        validate::entries(u, self.base.input.len(), "u")?;
        let time = validate::finite(t, "t")? + 0.0;
        self.place(Key { time, rank: 0, id: 0 }, Given::Input(DVector::from_column_slice(u)))
    }

    /// The sensor of this name has read `y`, of which parts may be missing, with the stamp `t`. Readings of one sensor
    /// at one time are told apart by `id`.
    ///
    /// # Errors
    /// [`Code::Index`] naming the name; [`Code::Shape`] or [`Code::NotFinite`] naming t or y, [`Code::Shape`] also
    /// where no part is there; [`Code::InnovationNotPositiveDefinite`] naming W; or what of the events cannot be
    /// replayed with it. The time line is then as it was.
    pub fn reading(&mut self, name: &str, t: f64, y: &[Option<f64>], id: u64) -> Result<Placed, H::Fault> {
        let Some(sensor) = self.sensors.iter().position(|sensor| sensor.name == name) else {
            return Err(Error::new(Code::Index, "name", "is no sensor's").into());
        };
        let Sensor { h, delay, .. } = &self.sensors[sensor];
        let whole: Vec<f64> = y.iter().map(|part| part.unwrap_or(0.0)).collect();
        validate::entries(&whole, h.outputs(), "y")?;
        if y.iter().all(Option::is_none) {
            return Err(Error::new(Code::Shape, "y", "has no part that was read").into());
        }
        // Zero, not minus zero: times are told apart by their bits.
        let time = validate::finite(t, "t")? - delay + 0.0;
        self.place(Key { time, rank: sensor + 1, id }, Given::Reading(y.to_vec()))
    }

    /// The belief at the time `t`, after all events of that time. Asking changes nothing.
    ///
    /// # Errors
    /// [`Code::Limit`] naming t where it lies before the window, [`Code::NotFinite`] where the belief at t is no finite
    /// one.
    pub fn at(&self, t: f64) -> Result<Belief, Error> {
        let t = validate::finite(t, "t")?;
        let known = self.before(self.events.partition_point(|event| event.key.time <= t));
        if t < known.time {
            return Err(Error::new(Code::Limit, "t", "is before the window"));
        }
        let step = history::step(&self.system, known.time, t)?;
        history::predicted(known, step.as_ref())
    }

    /// The latest time of an event, or that of the start.
    pub fn newest(&self) -> f64 {
        self.newest
    }

    /// How many events are kept.
    pub fn len(&self) -> usize {
        self.events.len()
    }

    /// Whether no event is kept.
    pub fn is_empty(&self) -> bool {
        self.events.is_empty()
    }

    /// What became of the readings of each sensor, in their order, since the start.
    pub fn statistics(&self) -> Vec<SensorStatistics> {
        let mut tallies = self.past.clone();
        self.events.iter().for_each(|event| count(&mut tallies, &self.sensors, event));
        tallies.iter().zip(&self.sensors).map(|(tally, sensor)| tally.statistics(&sensor.name)).collect()
    }

    /// Puts an event in its place, and replays what follows; nothing changes before all of that is computed.
    fn place(&mut self, key: Key, given: Given) -> Result<Placed, H::Fault> {
        let aside = |outcome| Ok(Placed { outcome, judged: None });
        if key.time < self.horizon(self.newest) {
            return aside(Outcome::TooLate);
        }
        if key.time - self.newest > MAX_AHEAD {
            return aside(Outcome::Ahead);
        }
        let Err(place) = self.events.binary_search_by(|event| event.key.cmp(&key)) else {
            return aside(Outcome::Duplicate);
        };
        let newest = self.newest.max(key.time);
        let horizon = self.horizon(newest);
        let past = self.events.partition_point(|event| event.key.time < horizon);
        if self.events.len() - past >= self.memory.capacity {
            return aside(Outcome::Full);
        }
        let mut placed = Vec::with_capacity(self.events.len() - place + 1);
        let before = self.before(place);
        let step = history::step(&self.system, before.time, key.time)?;
        placed.push(Event::new(&self.sensors, before, key, given, step)?);
        for (i, event) in self.events.range(place..).enumerate() {
            let before = &placed[i].after;
            // The step to the first lies in two parts now, the others are as they were.
            let step = if i == 0 { history::step(&self.system, key.time, event.key.time)? } else { event.step.clone() };
            placed.push(Event::new(&self.sensors, before, event.key, event.given.clone(), step)?);
        }
        let answer = placed[0].answer(&self.sensors);
        self.newest = newest;
        self.events.truncate(place);
        placed.into_iter().for_each(|event| self.events.push_back(event));
        for _ in 0..past {
            if let Some(event) = self.events.pop_front() {
                count(&mut self.past, &self.sensors, &event);
                self.base = event.after;
            }
        }
        Ok(answer)
    }

    /// The earliest time that an event may have when the latest is `newest`.
    fn horizon(&self, newest: f64) -> f64 {
        self.start.max(newest - self.memory.window)
    }

    /// What is known before the event in this place.
    fn before(&self, place: usize) -> &Moment {
        place.checked_sub(1).and_then(|i| self.events.get(i)).map_or(&self.base, |event| &event.after)
    }
}
