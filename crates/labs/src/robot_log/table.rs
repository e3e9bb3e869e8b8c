//! A replay as a table, row by row: for a reader who goes on with the numbers elsewhere.

use super::{LogParams, LoggedDrive};
use estimate::Error;
use estimate::drive::{Event, Replay, Row, Settings};
use lab::Params;
use std::fmt::Write;
use std::sync::Arc;

/// What a table tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LogTableKind {
    /// The estimate at each row of motion.
    Track,
    /// What the filter made of each sighting.
    Innovations,
}

/// A replay that is written as CSV while it goes on. Every number has the digits that give its bits back; lengths are
/// in metres, times in seconds by the log's own clock, angles in radians.
#[derive(Clone, Debug)]
pub struct LogTable {
    logged: Arc<LoggedDrive>,
    kind: LogTableKind,
    replay: Replay,
    step: usize,
}

impl LogTable {
    /// A table before its first row.
    ///
    /// # Errors
    /// As [`lab::Lab::start`].
    pub fn new(logged: Arc<LoggedDrive>, params: LogParams, kind: LogTableKind) -> Result<Self, Error> {
        params.check()?;
        let replay = Replay::new(logged.drive(), Settings::from(params))?;
        Ok(Self { logged, kind, replay, step: 0 })
    }

    /// What the next `n` rows of the log add to the table, before the first of them its header; `None` behind the last.
    ///
    /// # Errors
    /// As [`lab::Lab::run`]; the table is then as it was.
    pub fn next(&mut self, n: u32) -> Result<Option<String>, Error> {
        let logged = Arc::clone(&self.logged);
        let rows = &logged.drive().rows[self.step..];
        if rows.is_empty() {
            return Ok(None);
        }
        let mut text = String::new();
        if self.step == 0 {
            text.push_str(match self.kind {
                LogTableKind::Track => {
                    "time,x,y,theta,sigma_x,sigma_y,sigma_theta,epsilon,sigma_epsilon,true_x,true_y\n"
                }
                LogTableKind::Innovations => "time,landmark,range,expected,innovation,sigma,d2,outputs,used\n",
            });
        }
        let before = self.replay;
        let rows = &rows[..rows.len().min(n as usize)];
        for row in rows {
            if let Err(refused) = self.take(row, &mut text) {
                self.replay = before;
                return Err(refused);
            }
        }
        self.step += rows.len();
        Ok(Some(text))
    }

    fn take(&mut self, row: &Row, to: &mut String) -> Result<(), Error> {
        let drive = self.logged.drive();
        let judged = self.replay.take(drive, row)?;
        if row.time < self.replay.start() {
            return Ok(());
        }
        let mut cells: Vec<Option<f64>> = vec![Some(row.time)];
        match (self.kind, row.event, judged) {
            (LogTableKind::Track, event, _) if event.is_motion() => {
                let (pose, p) = (self.replay.pose(), self.replay.covariance());
                let sigma = |i: usize| (i < p.nrows()).then(|| p[(i, i)].max(0.0).sqrt());
                cells.extend([pose.x(), pose.y(), pose.theta()].map(Some));
                cells.extend([0, 1, 2].map(sigma));
                cells.extend([self.replay.epsilon(), sigma(3)]);
                let truth = drive.truth.position(row.time);
                cells.extend([0, 1].map(|i| truth.map(|at| at[i])));
            }
            (
                LogTableKind::Innovations,
                Event::Range { landmark, range } | Event::RangeBearing { landmark, range, .. },
                Some(judged),
            ) => {
                let id = drive.landmarks.get(landmark).map(|it| f64::from(it.id));
                let expected = range - judged.innovation;
                let sigma = judged.variance.sqrt();
                cells.extend([id, Some(range), Some(expected), Some(judged.innovation), Some(sigma)]);
                cells.extend([judged.d2, f64::from(judged.outputs), f64::from(u8::from(judged.used))].map(Some));
            }
            _ => return Ok(()),
        }
        for (i, cell) in cells.into_iter().enumerate() {
            if i > 0 {
                to.push(',');
            }
            if let Some(number) = cell {
                // A String takes whatever is written.
                let _ = write!(to, "{number}");
            }
        }
        to.push('\n');
        Ok(())
    }
}
