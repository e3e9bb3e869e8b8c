//! Which readings there are in a run, when each was measured and when it came.

use super::LateParams;
use sim::scenarios::THREE_SENSORS;

/// The number of the camera, whose readings come late.
pub(super) const CAMERA: usize = 2;

/// A reading, in ticks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Planned {
    pub sensor: usize,
    pub measured: usize,
    pub came: usize,
}

/// The reading in hand, in ticks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Picked {
    pub number: usize,
    pub of: usize,
    pub reading: Planned,
    pub missing: bool,
}

/// The readings of a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plan {
    /// Ticks from one reading of each sensor to its next; none where it reads nothing.
    pub periods: [Option<usize>; 3],
    /// In the order in which they come; those measured first ahead of others, and the sensors as they are listed.
    pub readings: Vec<Planned>,
    pub picked: Option<Picked>,
    /// The first tick in the gap, and the first behind it.
    pub gap: Option<[usize; 2]>,
}

impl Plan {
    pub fn new(params: &LateParams) -> Self {
        let last = THREE_SENSORS.ticks;
        let rates = [params.sonar_rate, params.laser_rate, params.camera_rate];
        let periods =
            rates.map(|rate| (rate > 0.0).then(|| (libm::round(1.0 / (rate * THREE_SENSORS.tick)) as usize).max(1)));
        let gap = params.gap.map(|[a, b]| [a.min(b), a.max(b)].map(ticks)).filter(|[from, to]| from < to);
        let missing = |tick: usize| gap.is_some_and(|[from, to]| (from..to).contains(&tick));
        let count = |sensor: usize| periods[sensor].map_or(0, |period| last / period);
        let picked = periods[CAMERA].filter(|_| count(CAMERA) > 0).map(|period| {
            let of = count(CAMERA);
            let number = (params.picked as usize).min(of - 1);
            let measured = (number + 1) * period;
            let came = measured + ticks(params.own_delay.unwrap_or(params.delay));
            Picked { number, of, reading: Planned { sensor: CAMERA, measured, came }, missing: missing(measured) }
        });
        let mut readings = Vec::new();
        for (sensor, period) in periods.iter().enumerate() {
            let Some(period) = period else { continue };
            for measured in (1..=last / period).map(|i| i * period).filter(|tick| !missing(*tick)) {
                let in_hand = picked.filter(|picked| sensor == CAMERA && picked.reading.measured == measured);
                let late = if sensor == CAMERA { ticks(params.delay) } else { 0 };
                let came = in_hand.map_or(measured + late, |picked| picked.reading.came);
                if !(in_hand.is_some() && params.removed) {
                    readings.push(Planned { sensor, measured, came });
                }
            }
        }
        readings.sort_by_key(|one| (one.came, one.measured, one.sensor));
        Self { periods, readings, picked, gap }
    }
}

/// A time in ticks.
pub(super) fn ticks(time: f64) -> usize {
    libm::round(time / THREE_SENSORS.tick) as usize
}

/// A tick in seconds.
pub(super) fn seconds(tick: usize) -> f64 {
    tick as f64 * THREE_SENSORS.tick
}
