//! A robot that really drove: its log, replayed under the reader's settings.
//!
//! A lab like the others, but for its world, which comes from outside: a function of the log, the parameters, and the
//! number of rows taken. Beside the filter runs dead reckoning, which the filter has to beat.

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

use crate::shapes::{ellipse_of, rows};
use estimate::drive::{Event, Judged, Replay, Row, Settings, Summary};
use estimate::{Code, Error};
use lab::{Digest, Lab, Params, named};
use nalgebra::{Matrix2, Matrix3};
use record::{At, Record};
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
        let replay = Replay::new(logged.drive(), settings)?;
        let reckoning = Replay::new(logged.drive(), Settings { sightings: false, learn: false, ..settings })?;
        Ok(Self { logged, params, step: 0, replay, reckoning, record: Record::default(), digest: Digest::default() })
    }

    fn tried() -> Vec<LogParams> {
        vec![LogParams::default(), LogParams { gate: Some(0.999), learn: true, ..LogParams::default() }]
    }

    fn world(&self) -> Arc<LoggedDrive> {
        Arc::clone(&self.logged)
    }

    fn params(&self) -> &LogParams {
        &self.params
    }

    fn steps(&self) -> u32 {
        self.step
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
        let before = self.step;
        for _ in 0..n.min(self.logged.rows() - before) {
            if let Err(refused) = self.advance() {
                *self = Self::at(self.world(), self.params, before)?;
                return Err(refused);
            }
        }
        Ok(())
    }

    fn advance(&mut self) -> Result<(), Error> {
        let logged = Arc::clone(&self.logged);
        if let Some(row) = logged.drive().rows.get(self.step as usize) {
            self.take(row)?;
            self.step += 1;
        }
        Ok(())
    }

    fn frame(&self) -> LogFrame {
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

impl RobotLog {
    /// All rows that are left.
    ///
    /// # Errors
    /// [`Code::NotFinite`] or [`Code::InnovationNotPositiveDefinite`] where the numbers leave the range of floating
    /// point. The lab is then as it was.
    pub fn run_all(&mut self) -> Result<(), Error> {
        self.run(Self::LAST_STEP)
    }

    /// What the replay says of itself so far.
    pub fn summary(&self) -> Summary {
        self.replay.summary()
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
            event if event.is_motion() => {
                let replay = &self.replay;
                self.record.moved(logged, &at, || {
                    let p = replay.covariance();
                    (p[(0, 0)] + p[(1, 1)]).max(0.0).sqrt()
                });
                return Ok(());
            }
            _ => return Ok(()),
        };
        let Some(place) = drive.landmarks.get(landmark) else { return Ok(()) };
        self.record.sighted(logged, &at, (landmark, [place.x, place.y]), range, judged.as_ref());
        if let Some(judged) = judged {
            let (used, time, from) = (judged.used, at.time, at.estimate);
            self.record.sighting = Some(LogSighting { time, landmark: place.id, at: [place.x, place.y], from, used });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
