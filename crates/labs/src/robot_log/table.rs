//! A log and its replay as tables, row by row: for a reader who goes on with the numbers elsewhere.

use super::rows::Rows;
use super::{LogParams, LoggedDrive};
use estimate::Error;
use estimate::drive::{Course, Drive, Event, Replay, Settings, Taken};
use lab::Params;
use std::fmt::Write;
use std::sync::Arc;

/// What a table tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LogTableKind {
    /// The estimate at each row of motion, before the readings of its time: what is compared with the truth.
    Track,
    /// What the filter made of each reading, and the estimate after it.
    Innovations,
    /// The log itself in the book's own format, whatever it was read from: no parameter changes it.
    Log,
}

/// A table that is written as CSV while it goes on. Every number has the digits that give its bits back; lengths are
/// in metres, times in seconds by the log's own clock, angles in radians.
#[derive(Clone, Debug)]
pub struct LogTable {
    logged: Arc<LoggedDrive>,
    written: Written,
}

#[derive(Clone, Debug)]
enum Written {
    Replayed(Box<Replayed>),
    Logged(Rows),
}

impl LogTable {
    /// A table before its first row.
    ///
    /// # Errors
    /// As [`lab::Lab::start`].
    pub fn new(logged: Arc<LoggedDrive>, params: LogParams, kind: LogTableKind) -> Result<Self, Error> {
        params.check()?;
        let written = match kind {
            LogTableKind::Log => Written::Logged(Rows::new(logged.drive())),
            _ => {
                let course = Course::new(logged.drive(), Settings::from(params))?;
                Written::Replayed(Box::new(Replayed { kind, replay: Replay::new(&course), course }))
            }
        };
        Ok(Self { logged, written })
    }

    /// What the next `n` rows of the log add to the table, before the first of them its header; `None` behind the last.
    ///
    /// # Errors
    /// As [`lab::Lab::run`]; the table is then as it was.
    pub fn next(&mut self, n: u32) -> Result<Option<String>, Error> {
        match &mut self.written {
            Written::Replayed(table) => table.next(&self.logged, n),
            Written::Logged(rows) => Ok(rows.next(self.logged.drive(), n)),
        }
    }
}

/// What the replay makes of a log.
#[derive(Clone, Debug)]
struct Replayed {
    kind: LogTableKind,
    course: Course,
    replay: Replay,
}

impl Replayed {
    fn next(&mut self, logged: &LoggedDrive, n: u32) -> Result<Option<String>, Error> {
        let left = logged.rows() - self.replay.rows();
        if left == 0 {
            return Ok(None);
        }
        let mut text = String::new();
        if self.replay.rows() == 0 {
            text.push_str(if self.kind == LogTableKind::Track { TRACK } else { INNOVATIONS });
        }
        let before = self.replay;
        for _ in 0..left.min(n) {
            let taken = self.replay.take(logged.drive(), &self.course).inspect_err(|_| self.replay = before)?;
            if let Some(taken) = taken {
                self.write(logged.drive(), &taken, &mut text);
            }
        }
        Ok(Some(text))
    }

    /// x, y, θ and the standard deviation of each.
    fn estimate(&self) -> [Option<f64>; 6] {
        let pose = self.replay.pose();
        let [x, y, theta] = [pose.x(), pose.y(), pose.theta()].map(Some);
        let [of_x, of_y, of_theta] = [0, 1, 2].map(|i| self.sigma(i));
        [x, y, theta, of_x, of_y, of_theta]
    }

    /// The standard deviation of a state, where there is such a one.
    fn sigma(&self, i: usize) -> Option<f64> {
        let p = self.replay.covariance();
        (i < p.nrows()).then(|| p[(i, i)].max(0.0).sqrt())
    }

    fn write(&self, drive: &Drive, taken: &Taken, to: &mut String) {
        if taken.early {
            return;
        }
        let mut cells: Vec<Option<f64>> = vec![Some(taken.time)];
        match (self.kind, drive.rows[taken.row].event, taken.judged) {
            (LogTableKind::Track, event, _) if event.is_motion() => {
                cells.extend(self.estimate());
                let epsilon = self.replay.epsilon();
                cells.extend([epsilon, epsilon.and_then(|_| self.sigma(3))]);
                let truth = drive.truth.position(taken.time);
                cells.extend([0, 1].map(|i| truth.map(|at| at[i])));
            }
            (LogTableKind::Innovations, event, Some(judged)) => {
                let Some((sensor, landmark, measured)) = told(&event) else { return };
                let id = landmark.and_then(|at| drive.landmarks.get(at)).map(|it| f64::from(it.id));
                let nu = [Some(judged.innovation), judged.bearing.or(judged.of_y)];
                let expected = |i: usize| measured[i].zip(nu[i]).map(|(measured, nu)| measured - nu);
                write(&[Some(taken.time)], to);
                let _ = write!(to, ",{sensor},");
                write(&[id, measured[0], expected(0), nu[0], Some(judged.variance.sqrt())], to);
                to.push(',');
                write(&[measured[1], expected(1), nu[1]], to);
                to.push(',');
                cells = [judged.d2, f64::from(judged.outputs), f64::from(u8::from(judged.used))].map(Some).to_vec();
                cells.extend(self.estimate());
            }
            _ => return,
        }
        write(&cells, to);
        to.push('\n');
    }
}

/// Of the learned scale there is what the ranges are too long by, as a part of them, and of no other reading.
const TRACK: &str = "time,x,y,theta,sigma_x,sigma_y,sigma_theta,range_scale_error,sigma_range_scale_error,true_x,\
                     true_y\n";
/// Of a reading's first number there is σ of ν too; of a bearing or the y of a fix, what was measured and expected.
const INNOVATIONS: &str = "time,sensor,landmark,measured,expected,innovation,sigma,measured_2,expected_2,innovation_2,\
                           d2,outputs,used,x_after,y_after,theta_after,sigma_x_after,sigma_y_after,sigma_theta_after\n";

/// The sensor of a reading, the index of its landmark, and what was measured.
fn told(event: &Event) -> Option<(&'static str, Option<usize>, [Option<f64>; 2])> {
    Some(match *event {
        Event::Position { x, y, .. } => ("fix", None, [Some(x), Some(y)]),
        Event::Heading { theta, .. } => ("heading", None, [Some(theta), None]),
        Event::Range { landmark, range } => ("range", Some(landmark), [Some(range), None]),
        Event::RangeBearing { landmark, range, bearing } => ("bearing", Some(landmark), [Some(range), Some(bearing)]),
        _ => return None,
    })
}

/// Numbers with commas between them; what there is not is empty.
pub(super) fn write(cells: &[Option<f64>], to: &mut String) {
    for (i, cell) in cells.iter().enumerate() {
        if i > 0 {
            to.push(',');
        }
        // A String takes whatever is written.
        let _ = match cell {
            // Hundreds of zeros are no field that a log may have.
            Some(number) if *number != 0.0 && !(1e-7..1e21).contains(&number.abs()) => write!(to, "{number:e}"),
            Some(number) => write!(to, "{number}"),
            None => Ok(()),
        };
    }
}
