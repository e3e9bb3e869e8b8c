//! A robot that really drove: its log, replayed under the reader's settings.
//!
//! A lab like the others, but for its world, which comes from outside: a function of the log, the parameters, and the number of rows
//! taken. Beside the filter runs dead reckoning, which the filter has to beat.

pub(crate) mod frame;
mod logged;
mod params;
mod record;
mod table;

pub use frame::{
    LogBands, LogCorrelation, LogErrors, LogFrame, LogHistogram, LogInnovations, LogLandmark, LogNis, LogRanges,
    LogSighting, LogTimeline, LogTracks,
};
pub use logged::LoggedDrive;
pub use params::LogParams;
pub use table::{LogTable, LogTableKind};

use crate::declare::{Params, Plain};
use crate::lab::{Digest, Experiment, Kind};
use crate::shapes::{ellipse_of, rows};
use estimate::drive::{Event, Judged, Replay, Row, Settings, Summary};
use estimate::{Code, Error};
use nalgebra::{Matrix2, Matrix3};
use record::{At, Record};
use std::any::Any;
use std::sync::Arc;

/// The lab.
#[derive(Clone, Debug)]
pub struct RobotLog {
    logged: Arc<LoggedDrive>,
    params: LogParams,
    step: u32,
    replay: Replay,
    /// Without sightings: dead reckoning.
    reckoning: Replay,
    record: Record,
    digest: Digest,
}

impl RobotLog {
    /// The lab's name in links and stored states.
    pub const NAME: &'static str = "robot-log";
    /// The last step of the longest log.
    pub const LAST_STEP: u32 = 2_000_000;
    /// What is known of the lab.
    pub const KIND: &'static Kind = &Kind {
        name: Self::NAME,
        parameters: LogParams::PARAMETERS,
        params: LogParams::SHAPE,
        frame: LogFrame::SHAPE,
        last_step: Self::LAST_STEP,
        defaults: || LogParams::default().numbers(),
    };

    /// The log before its first row.
    ///
    /// # Errors
    /// [`Code::Limit`] or [`Code::NotFinite`], naming the parameter.
    pub fn new(logged: Arc<LoggedDrive>, params: LogParams) -> Result<Self, Error> {
        params.check()?;
        let settings = Settings::from(params);
        let replay = Replay::new(logged.drive(), settings)?;
        let reckoning = Replay::new(logged.drive(), Settings { sightings: false, learn: false, ..settings })?;
        Ok(Self { logged, params, step: 0, replay, reckoning, record: Record::default(), digest: Digest::default() })
    }

    /// The log after `step` rows.
    ///
    /// # Errors
    /// As [`RobotLog::new`] and [`RobotLog::run`]; [`Code::Limit`] naming `step` where the log is shorter.
    pub fn at(logged: Arc<LoggedDrive>, params: LogParams, step: u32) -> Result<Self, Error> {
        if step > logged.rows() {
            let message = format!("is {step}; the log has {} rows of motion and sightings", logged.rows());
            return Err(Error::new(Code::Limit, "step", message));
        }
        let mut lab = Self::new(logged, params)?;
        if step > 0 {
            lab.run(step)?;
        }
        Ok(lab)
    }

    /// The next `n` rows, or what is left of them.
    ///
    /// # Errors
    /// [`Code::Limit`] when `n` is 0 or more than [`RobotLog::LAST_STEP`]; [`Code::NotFinite`] or
    /// [`Code::InnovationNotPositiveDefinite`] where the numbers leave the range of floating point. The lab is then as it was.
    pub fn run(&mut self, n: u32) -> Result<(), Error> {
        if n == 0 || n > Self::LAST_STEP {
            let message = format!("is {n}; it must be at least 1 and at most {}", Self::LAST_STEP);
            return Err(Error::new(Code::Limit, "n", message));
        }
        let (before, logged) = (self.step, Arc::clone(&self.logged));
        let rows = &logged.drive().rows[before as usize..];
        for row in rows.iter().take(n as usize) {
            if let Err(refused) = self.take(row) {
                *self = Self::at(logged, self.params, before)?;
                return Err(refused);
            }
            self.step += 1;
        }
        Ok(())
    }

    /// All rows that are left.
    ///
    /// # Errors
    /// As [`RobotLog::run`].
    pub fn run_all(&mut self) -> Result<(), Error> {
        self.run(Self::LAST_STEP)
    }

    fn take(&mut self, row: &Row) -> Result<(), Error> {
        let logged = &*self.logged;
        let drive = logged.drive();
        let judged = self.replay.take(drive, row)?;
        self.reckoning.take(drive, row)?;
        let (pose, reckoned) = (self.replay.pose(), self.reckoning.pose());
        self.digest.take(&[pose.x(), pose.y(), pose.theta()]);
        if let Some(Judged { innovation, variance, d2, .. }) = judged {
            self.digest.take(&[innovation, variance, d2]);
        }
        if row.time < self.replay.start() {
            return Ok(());
        }
        let at = At {
            time: row.time - logged.span()[0],
            estimate: [pose.x(), pose.y()],
            reckoning: [reckoned.x(), reckoned.y()],
            truth: drive.truth.position(row.time),
        };
        let (landmark, range) = match row.event {
            Event::Range { landmark, range } | Event::RangeBearing { landmark, range, .. } => (landmark, range),
            Event::Odometry { .. } | Event::Velocity { .. } => {
                let replay = &self.replay;
                self.record.moved(logged, &at, || {
                    let p = replay.covariance();
                    (p[(0, 0)] + p[(1, 1)]).max(0.0).sqrt()
                });
                return Ok(());
            }
        };
        let Some(place) = drive.landmarks.get(landmark) else { return Ok(()) };
        self.record.sighted(logged, &at, (landmark, [place.x, place.y]), range, judged.as_ref());
        if let Some(judged) = judged {
            let (used, time, from) = (judged.used, at.time, at.estimate);
            self.record.sighting = Some(LogSighting { time, landmark: place.id, at: [place.x, place.y], from, used });
        }
        Ok(())
    }

    /// What the replay says of itself so far.
    pub fn summary(&self) -> Summary {
        self.replay.summary()
    }

    /// The present frame.
    pub fn frame(&self) -> LogFrame {
        let Self { logged, params, step, replay, reckoning, record, .. } = self;
        let [first, last] = logged.span();
        let time = match *step {
            0 => first,
            taken => logged.drive().rows[taken as usize - 1].time,
        };
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
            step: *step,
            params: *params,
            rows: logged.rows(),
            time: time - first,
            duration: last - first,
            timeline: logged.timeline(),
            landmarks: logged.drive().landmarks.clone(),
            bearings: logged.bearings(),
            truth,
            reckoning: pose(reckoning),
            estimate: pose(replay),
            p: rows(&p),
            ellipse: ellipse_of(&position),
            sighting: record.sighting,
            tracks,
            every: logged.sighting_stride(),
            ranges: record.ranges.clone(),
            range_line: record.range_line(),
            innovations: record.innovations.clone(),
            innovation_line: record.innovation_line(),
            errors: record.errors.clone(),
            nis: record.nis(logged),
            histogram: record.histogram(),
            correlation: record.correlation(),
            by_landmark: record.by_landmark(logged),
            summary: self.summary(),
            bands: record.bands(),
            reckoned_rmse: reckoning.summary().rmse,
        }
    }
}

impl Experiment for RobotLog {
    fn kind(&self) -> &'static Kind {
        Self::KIND
    }

    fn set_params(&mut self, params: &[f64]) -> Result<(), Error> {
        *self = Self::at(Arc::clone(&self.logged), LogParams::read(&mut params.iter()), self.step)?;
        Ok(())
    }

    fn run_on(&mut self, n: u32) -> Result<(), Error> {
        self.run(n)
    }

    fn state_numbers(&self) -> (Vec<f64>, u32) {
        (self.params.numbers(), self.step)
    }

    fn frame_numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.frame().write(&mut numbers);
        numbers
    }

    fn hash(&self) -> u64 {
        self.digest.value()
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

#[cfg(test)]
mod tests;
