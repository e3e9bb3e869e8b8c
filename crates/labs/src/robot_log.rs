//! A robot that really drove: its log, replayed under the reader's settings.
//!
//! A lab like the others, but for its world, which comes from outside: a function of the log, the parameters, and the
//! number of rows taken. Beside the filter runs dead reckoning, which the filter has to beat.

mod fit;
pub(crate) mod frame;
mod logged;
mod params;
mod record;
mod rows;
mod seen;
mod table;
mod verdict;

pub use fit::LogFit;
pub use frame::{
    FixOutcome, LogBands, LogCorrelation, LogErrors, LogFixInnovations, LogFixes, LogFrame, LogHistogram,
    LogInnovations, LogLandmark, LogLandmarkStatistics, LogNis, LogRanges, LogSighting, LogSmoothed, LogTimeline,
    LogTracks,
};
pub use logged::LoggedDrive;
pub use params::LogParams;
pub use seen::LogSensor;
pub use table::{LogTable, LogTableKind};
pub use verdict::LogVerdict;

use crate::shapes::{ellipse_of, rows};
use estimate::drive::{BySensor, Course, Event, Judged, Replay, Settings, Smoothed, Summary, Taken};
use estimate::{Code, Error};
use lab::{Digest, Lab, Params, named};
use nalgebra::{Matrix2, Matrix3};
use record::{At, LogRecord};
use std::sync::Arc;

/// The lab.
#[derive(Clone, Debug)]
pub struct RobotLog {
    logged: Arc<LoggedDrive>,
    params: LogParams,
    course: Arc<Course>,
    replay: Replay,
    /// By motion alone: dead reckoning.
    reckoned: Arc<Course>,
    reckoning: Replay,
    /// When the last row that was taken was measured, s.
    time: f64,
    record: LogRecord,
    /// The smoothed track of the rows that are taken, once it was asked for.
    smoothed: Option<Arc<Smoothed>>,
    digest: Digest,
}

impl Lab for RobotLog {
    named! {
        "robot-log", LogParams, LogFrame, &[frame::INTERFACES],
        "A robot that really drove: a log, replayed under the reader's settings. A step is a row of motion or of a \
            sighting."
    }
    /// That of the longest log.
    const LAST_STEP: u32 = 2_000_000;
    type World = Arc<LoggedDrive>;

    fn start(logged: Arc<LoggedDrive>, params: LogParams) -> Result<Self, Error> {
        params.check()?;
        let settings = Settings::from(params);
        let course = Arc::new(Course::new(logged.drive(), settings)?);
        let reckoned = Arc::new(Course::new(logged.drive(), settings.reckoning())?);
        let (replay, reckoning) = (Replay::new(&course), Replay::new(&reckoned));
        let time = logged.span()[0];
        let looked_stride = logged.looked_stride(course.looked_at(logged.drive()));
        let (record, digest) = (LogRecord::new(looked_stride), Digest::default());
        Ok(Self { logged, params, course, replay, reckoned, reckoning, time, record, smoothed: None, digest })
    }

    fn tried() -> Vec<LogParams> {
        let gate = BySensor::all(Some(0.999));
        vec![LogParams::default(), LogParams { gate, learn: true, ..LogParams::default() }]
    }

    fn world(&self) -> Arc<LoggedDrive> {
        Arc::clone(&self.logged)
    }

    fn params(&self) -> &LogParams {
        &self.params
    }

    fn steps(&self) -> u32 {
        self.replay.rows()
    }

    fn digest(&self) -> u64 {
        self.digest.value()
    }

    /// The log after `step` rows; [`Code::Limit`] naming `step` where it is shorter.
    fn at(logged: Arc<LoggedDrive>, params: LogParams, step: u32) -> Result<Self, Error> {
        if step > logged.rows() {
            let message = format!("is {step}; the log has {} rows of motion and sightings", logged.rows());
            return Err(Error::new(Code::Limit, "step", message));
        }
        let mut lab = Self::start(logged, params)?;
        if step > 0 {
            lab.run(step)?;
        }
        Ok(lab)
    }

    /// The next `n` rows, or what is left of them. After a refused row the lab is replayed to where it was: a copy of
    /// what it has recorded would cost more at every call.
    fn run(&mut self, n: u32) -> Result<(), Error> {
        if n == 0 || n > Self::LAST_STEP {
            let message = format!("is {n}; it must be at least 1 and at most {}", Self::LAST_STEP);
            return Err(Error::new(Code::Limit, "n", message));
        }
        let before = self.steps();
        for _ in 0..n.min(self.logged.rows() - before) {
            if let Err(refused) = self.advance() {
                *self = Self::at(self.world(), self.params, before)?;
                return Err(refused);
            }
        }
        Ok(())
    }

    fn advance(&mut self) -> Result<(), Error> {
        let (logged, course) = (Arc::clone(&self.logged), Arc::clone(&self.course));
        if let Some(taken) = self.replay.take(logged.drive(), &course)? {
            self.smoothed = None;
            self.take(&taken)?;
        }
        Ok(())
    }

    fn frame(&self) -> LogFrame {
        let Self { logged, params, replay, reckoning, time, record, .. } = self;
        let (time, step) = (*time, self.steps());
        let [first, last] = logged.span();
        let pose = |replay: &Replay| {
            let pose = replay.pose();
            [pose.x(), pose.y(), pose.theta()]
        };
        let p: Matrix3<f64> = replay.covariance().fixed_view::<3, 3>(0, 0).into_owned();
        let position: Matrix2<f64> = p.fixed_view::<2, 2>(0, 0).into_owned();
        let mut tracks = LogTracks {
            truth: logged.truth_until(time),
            reckoning: record.reckoning.clone(),
            estimate: record.estimate.clone(),
        };
        let truth = logged.drive().truth.position(time);
        let ends = [(&mut tracks.estimate, Some(pose(replay))), (&mut tracks.reckoning, Some(pose(reckoning)))];
        for (track, end) in ends.into_iter().chain([(&mut tracks.truth, truth.map(|[x, y]| [x, y, 0.0]))]) {
            if let Some([x, y, _]) = end {
                track.push(x, y, usize::MAX);
            }
        }
        LogFrame {
            step,
            params: *params,
            rows: logged.rows(),
            time: time - first,
            duration: last - first,
            timeline: logged.timeline(),
            landmarks: logged.drive().landmarks.clone(),
            bearings: logged.bearings(),
            has_truth: !logged.drive().truth.poses().is_empty(),
            truth,
            reckoning: pose(reckoning),
            estimate: pose(replay),
            p: rows(&p),
            ellipse: ellipse_of(&position),
            sighting: record.sighting,
            tracks,
            every: logged.sighting_stride(),
            every_looked: record.looked_stride,
            ranges: record.ranges.clone(),
            range_line: record.range_line(),
            innovations: record.innovations.clone(),
            fixes: record.fixes.clone(),
            fix_innovations: record.fix_innovations.clone(),
            smoothed: self.smoothed.as_deref().map(|smoothed| drawn(smoothed, first)),
            innovation_line: record.innovation_line(),
            errors: record.errors.clone(),
            nis: record.nis(logged),
            histogram: record.histogram(),
            correlation: record.correlation(),
            by_landmark: record.by_landmark(logged),
            landmark_statistics: record.landmark_statistics(),
            mean_bearing: record.mean_bearing(),
            summary: self.summary(),
            bands: record.bands(),
            reckoned_rmse: reckoning.summary(&self.reckoned).rmse,
        }
    }
}

impl RobotLog {
    /// All rows that are left.
    ///
    /// # Errors
    /// [`Code::NotFinite`] or [`Code::InnovationNotPositiveDefinite`] where the numbers leave the range of floating
    /// point. The lab is then as it was.
    pub fn run_all(&mut self) -> Result<(), Error> {
        self.run(Self::LAST_STEP)
    }

    /// Smooths the rows that are taken. The log is replayed twice for it, and less than 2 MB are needed meanwhile for a
    /// million rows. The smoothed track is in the frame, and what it says in the summary, until another row is taken.
    ///
    /// # Errors
    /// [`Code::InnovationNotPositiveDefinite`] naming the row, or [`Code::NotFinite`]. The lab is then as it was.
    pub fn smooth(&mut self) -> Result<(), Error> {
        let stride = self.logged.motion_stride() as usize;
        self.smoothed = Some(Arc::new(Smoothed::new(self.logged.drive(), &self.course, &self.replay, stride)?));
        Ok(())
    }

    /// What the replay says of itself so far.
    pub fn summary(&self) -> Summary {
        let summary = self.replay.summary(&self.course);
        match &self.smoothed {
            Some(smoothed) => smoothed.told(summary),
            None => summary,
        }
    }

    fn take(&mut self, taken: &Taken) -> Result<(), Error> {
        let logged = &*self.logged;
        let drive = logged.drive();
        self.reckoning.take(drive, &self.reckoned)?;
        self.time = taken.time;
        let (pose, reckoned) = (self.replay.pose(), self.reckoning.pose());
        self.digest.take(&[pose.x(), pose.y(), pose.theta()]);
        if let Some(Judged { innovation, variance, d2, .. }) = taken.judged {
            self.digest.take(&[innovation, variance, d2]);
        }
        if taken.early {
            return Ok(());
        }
        let at = At {
            time: taken.time - logged.span()[0],
            estimate: [pose.x(), pose.y()],
            reckoning: [reckoned.x(), reckoned.y()],
            truth: drive.truth.position(taken.time),
        };
        let event = drive.rows[taken.row].event;
        let (landmark, range) = match event {
            Event::Range { landmark, range } | Event::RangeBearing { landmark, range, .. } => (landmark, range),
            Event::Position { .. } | Event::Heading { .. } => {
                self.record.read(logged, &at, &event, taken);
                return Ok(());
            }
            Event::Odometry { .. } | Event::Velocity { .. } | Event::Speed { .. } | Event::TurnRate { .. } => {
                let replay = &self.replay;
                self.record.moved(logged, &at, || {
                    let p = replay.covariance();
                    (p[(0, 0)] + p[(1, 1)]).max(0.0).sqrt()
                });
                return Ok(());
            }
        };
        let Some(place) = drive.landmarks.get(landmark) else { return Ok(()) };
        self.record.sighted(logged, &at, (landmark, [place.x, place.y]), range, taken.judged.as_ref());
        if let Some(judged) = taken.judged {
            let (used, time, from) = (judged.used, at.time, at.estimate);
            self.record.sighting = Some(LogSighting { time, landmark: place.id, at: [place.x, place.y], from, used });
        }
        Ok(())
    }
}

/// The smoothed track as a frame has it; `first` is the time of the log's first row.
fn drawn(smoothed: &Smoothed, first: f64) -> LogSmoothed {
    let mut drawn = LogSmoothed::default();
    for at in &smoothed.track {
        drawn.time.push(at.time - first);
        drawn.x.push(at.pose.x());
        drawn.y.push(at.pose.y());
        drawn.bound.push(2.0 * (at.p[(0, 0)] + at.p[(1, 1)]).max(0.0).sqrt());
    }
    drawn
}

#[cfg(test)]
mod tests;
