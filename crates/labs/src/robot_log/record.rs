//! What a replay has shown so far, in constant memory: long logs are thinned, sums are kept whole.

use super::frame::{
    FixOutcome, LogBands, LogCorrelation, LogErrors, LogFixInnovations, LogFixes, LogHistogram, LogInnovations,
    LogLandmark, LogLandmarkStatistics, LogNis, LogRanges, LogSighting,
};
use super::logged::LoggedDrive;
use super::seen::Seen;
use estimate::drive::{Event, Judged, Line, Points, Taken};
use filters::Autocorrelation;
use filters::consistency::chi2_interval;
use lab::series::Track;
use std::f64::consts::PI;

/// The lags of the autocorrelation.
const LAGS: usize = 20;
/// Bins of the histogram, each half a σ wide, from −5 σ to 5 σ.
const BINS: usize = 20;
const BIN: f64 = 0.5;
const FIRST: f64 = -5.0;
/// The share of runs that a band holds.
const BAND: f64 = 0.95;

/// Everything that a frame shows of the way there.
#[derive(Clone, Debug, Default)]
pub(super) struct LogRecord {
    pub estimate: Track,
    pub reckoning: Track,
    pub errors: LogErrors,
    pub ranges: LogRanges,
    range_points: Points,
    pub innovations: LogInnovations,
    innovation_points: Points,
    nis: Blocks,
    bins: [u32; BINS],
    normalized: Autocorrelation<LAGS>,
    /// For each landmark.
    landmarks: Vec<Seen>,
    pub sighting: Option<LogSighting>,
    pub fixes: LogFixes,
    pub fix_innovations: LogFixInnovations,
    /// Every how many readings that were looked at one is drawn, and how many there were.
    pub looked_stride: u32,
    looked: u32,
    /// Rows of motion and readings so far.
    motions: u32,
    readings: u32,
}

/// A pose and a point on the map, at a row.
pub(super) struct At {
    pub time: f64,
    pub estimate: [f64; 2],
    pub reckoning: [f64; 2],
    pub truth: Option<[f64; 2]>,
}

impl LogRecord {
    /// Nothing yet; every `looked_stride`th reading that is looked at will be drawn.
    pub fn new(looked_stride: u32) -> Self {
        Self { looked_stride, ..Self::default() }
    }

    /// Takes a row of motion; `sigma` answers the claimed σ of the position.
    pub fn moved(&mut self, logged: &LoggedDrive, at: &At, sigma: impl FnOnce() -> f64) {
        let kept = self.motions.is_multiple_of(logged.motion_stride());
        self.motions += 1;
        if !kept {
            return;
        }
        let most = usize::MAX;
        self.estimate.push(at.estimate[0], at.estimate[1], most);
        self.reckoning.push(at.reckoning[0], at.reckoning[1], most);
        self.errors.time.push(at.time);
        self.errors.bound.push(2.0 * sigma());
        if let Some(truth) = at.truth {
            self.errors.error.push(distance(at.estimate, truth));
        }
    }

    /// Takes a sighting that read `range` of the landmark with this index and place, and what the filter made of it.
    pub fn sighted(
        &mut self,
        logged: &LoggedDrive,
        at: &At,
        (landmark, place): (usize, [f64; 2]),
        range: f64,
        judged: Option<&Judged>,
    ) {
        let kept = self.keeps(logged);
        let known = distance(at.truth.unwrap_or(at.reckoning), place);
        self.range_points.take(known, range - known);
        if kept {
            self.ranges.time.push(at.time);
            self.ranges.range.push(known);
            self.ranges.residual.push(range - known);
        }
        let Some(judged) = judged else { return };
        self.landmarks.resize(logged.drive().landmarks.len(), Seen::default());
        self.landmarks[landmark].take(judged);
        if judged.used {
            self.innovation_points.take(range - judged.innovation, judged.innovation);
        }
        self.judged(logged, at, (range, Some(logged.drive().landmarks[landmark].id)), judged);
    }

    /// Takes a fix or a heading, and what the filter made of it.
    pub fn read(&mut self, logged: &LoggedDrive, at: &At, event: &Event, taken: &Taken) {
        let kept = self.keeps(logged);
        let first = match *event {
            Event::Position { x, y, .. } => {
                if kept {
                    self.fixes.take(at.time, [x, y], taken);
                }
                x
            }
            Event::Heading { theta, .. } => theta,
            _ => return,
        };
        if let Some(judged) = &taken.judged {
            self.judged(logged, at, (first, None), judged);
        }
    }

    /// Whether the next reading is drawn.
    fn keeps(&mut self, logged: &LoggedDrive) -> bool {
        self.readings += 1;
        (self.readings - 1).is_multiple_of(logged.sighting_stride())
    }

    /// Takes what became of a reading whose first number is `first`, and the id of its landmark.
    fn judged(&mut self, logged: &LoggedDrive, at: &At, (first, id): (f64, Option<u32>), judged: &Judged) {
        let normalized = judged.normalized();
        self.looked += 1;
        if (self.looked - 1).is_multiple_of(self.looked_stride.max(1)) {
            if let Some([along, across]) = judged.along {
                let fixes = &mut self.fix_innovations;
                fixes.time.push(at.time);
                fixes.x.push(at.estimate[0]);
                fixes.y.push(at.estimate[1]);
                fixes.along.push(along);
                fixes.across.push(across);
                fixes.used.push(judged.used);
            }
            self.innovations.time.push(at.time);
            self.innovations.normalized.push(normalized);
            self.innovations.expected.push(first - judged.innovation);
            self.innovations.innovation.push(judged.innovation);
            self.innovations.used.push(judged.used);
            self.innovations.sensor.push(judged.sensor.into());
            self.innovations.landmark.push(id);
            self.innovations.bearing.push(judged.bearing);
            self.innovations.second.push(judged.second);
            self.innovations.x.push(at.estimate[0]);
            self.innovations.y.push(at.estimate[1]);
        }
        if judged.used {
            self.normalized.take(normalized);
            let bin = ((normalized - FIRST) / BIN).floor();
            if (0.0..BINS as f64).contains(&bin) {
                self.bins[bin as usize] += 1;
            }
            self.nis.take(logged.block(), at.time, judged);
        }
    }

    pub fn range_line(&self) -> Option<Line> {
        self.range_points.line()
    }

    pub fn innovation_line(&self) -> Option<Line> {
        self.innovation_points.line()
    }

    pub fn nis(&self, logged: &LoggedDrive) -> LogNis {
        LogNis { block: logged.block(), ..self.nis.closed.clone() }
    }

    pub fn histogram(&self) -> LogHistogram {
        let all = f64::from(self.normalized.count());
        let within: u32 = self.bins.iter().sum();
        let density = |count: &u32| if all > 0.0 { f64::from(*count) / (all * BIN) } else { 0.0 };
        let normal = |i: usize| {
            let x = FIRST + 0.5 * BIN * i as f64;
            libm::exp(-0.5 * x * x) / (2.0 * PI).sqrt()
        };
        LogHistogram {
            from: FIRST,
            width: BIN,
            density: self.bins.iter().map(density).collect(),
            beyond: if all > 0.0 { 1.0 - f64::from(within) / all } else { 0.0 },
            normal: (0..=2 * BINS).map(normal).collect(),
        }
    }

    pub fn correlation(&self) -> LogCorrelation {
        LogCorrelation {
            values: (1..=LAGS).map_while(|lag| self.normalized.at(lag)).collect(),
            band: self.normalized.band().unwrap_or(0.0),
        }
    }

    pub fn by_landmark(&self, logged: &LoggedDrive) -> Vec<LogLandmark> {
        logged.drive().landmarks.iter().zip(&self.landmarks).map(|(landmark, seen)| seen.told(landmark.id)).collect()
    }

    pub fn landmark_statistics(&self) -> Vec<LogLandmarkStatistics> {
        self.landmarks.iter().map(Seen::statistics).collect()
    }

    pub fn mean_bearing(&self) -> Option<f64> {
        let (sum, count) = self.landmarks.iter().fold((0.0, 0), |(sum, n), seen| (sum + seen.bearings, n + seen.count));
        (count > 0).then(|| sum / f64::from(count))
    }

    pub fn bands(&self) -> Option<LogBands> {
        let mean = self.normalized.band()?;
        Some(LogBands { nis: band(self.nis.all), mean })
    }
}

impl LogFixes {
    fn take(&mut self, time: f64, [x, y]: [f64; 2], taken: &Taken) {
        self.time.push(time);
        self.x.push(x);
        self.y.push(y);
        self.outcome.push(match taken.judged {
            Some(Judged { used: true, .. }) => FixOutcome::Used,
            Some(_) => FixOutcome::Refused,
            None if taken.withheld.is_some() => FixOutcome::Withheld,
            None => FixOutcome::Unused,
        });
    }
}

/// NIS by blocks: a block that is not full yet is kept as its sums.
#[derive(Clone, Debug, Default)]
struct Blocks {
    closed: LogNis,
    readings: u32,
    outputs: u32,
    sum: f64,
    /// The outputs of all used readings.
    all: u32,
    /// The outputs of the last closed block, and its band.
    known: Option<(u32, [f64; 2])>,
}

impl Blocks {
    fn take(&mut self, block: u32, time: f64, judged: &Judged) {
        self.readings += 1;
        self.outputs += judged.outputs;
        self.all += judged.outputs;
        self.sum += judged.d2;
        if self.readings < block {
            return;
        }
        let known = self.known.filter(|(outputs, _)| *outputs == self.outputs);
        let [low, high] = known.map_or_else(|| band(self.outputs), |(_, band)| band);
        self.known = Some((self.outputs, [low, high]));
        let closed = &mut self.closed;
        closed.time.push(time);
        closed.mean.push(self.sum / f64::from(self.outputs));
        closed.low.push(low);
        closed.high.push(high);
        (self.readings, self.outputs, self.sum) = (0, 0, 0.0);
    }
}

/// The band of the mean of squares of `outputs` standard normal numbers.
fn band(outputs: u32) -> [f64; 2] {
    chi2_interval(1, outputs, BAND).map_or([0.0, f64::INFINITY], |(low, high)| [low, high])
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    numerics::hypot(a[0] - b[0], a[1] - b[1])
}
