//! A log written in the book's own format, whatever it was read from.

use super::table::write;
use estimate::drive::{Drive, Event};

/// What is written of a log next: its landmarks, its true poses, then its rows in the order of their lines, so that of
/// rows measured at one time the same one is taken first when the text is read.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    order: Vec<u32>,
    at: usize,
}

impl Rows {
    pub(super) fn new(drive: &Drive) -> Self {
        let mut order: Vec<u32> = (0..drive.rows.len() as u32).collect();
        order.sort_by_key(|row| drive.rows[*row as usize].line);
        Self { order, at: 0 }
    }

    /// The next `n` lines; `None` behind the last.
    pub(super) fn next(&mut self, drive: &Drive, n: u32) -> Option<String> {
        let (landmarks, poses) = (&drive.landmarks, drive.truth.poses());
        let all = landmarks.len() + poses.len() + self.order.len();
        if self.at == all {
            return None;
        }
        let mut text = String::new();
        let end = all.min(self.at + n as usize);
        for at in self.at..end {
            let pose = at.wrapping_sub(landmarks.len());
            let row = pose.wrapping_sub(poses.len());
            if let Some(it) = landmarks.get(at) {
                line("L", &[f64::from(it.id), it.x, it.y], None, &mut text);
            } else if let Some(it) = poses.get(pose) {
                line("G", &[it.time, it.x, it.y, it.theta], None, &mut text);
            } else {
                let row = &drive.rows[self.order[row] as usize];
                event(drive, row.time, &row.event, &mut text);
            }
        }
        self.at = end;
        Some(text)
    }
}

fn event(drive: &Drive, time: f64, event: &Event, to: &mut String) {
    let id = |at: usize| f64::from(drive.landmarks[at].id);
    let even = drive.motion.is_even();
    match *event {
        Event::Odometry { distance, turn } => {
            line(if even { "D" } else { "O" }, &[time, distance, turn], None, to);
        }
        Event::Velocity { v, omega } => line(if even { "VE" } else { "V" }, &[time, v, omega], None, to),
        Event::Speed { v } => line(if even { "SE" } else { "S" }, &[time, v], None, to),
        Event::TurnRate { omega } => line(if even { "TE" } else { "T" }, &[time, omega], None, to),
        Event::Position { x, y, sigma } => line("P", &[time, x, y], sigma, to),
        Event::Heading { theta, sigma } => line("H", &[time, theta], sigma, to),
        Event::Range { landmark, range } => line("R", &[time, id(landmark), range], None, to),
        Event::RangeBearing { landmark, range, bearing } => {
            line("B", &[time, id(landmark), range, bearing], None, to);
        }
    }
}

/// A row: its letter, its numbers, and its own standard deviation if it has one.
fn line(letter: &str, numbers: &[f64], sigma: Option<f64>, to: &mut String) {
    to.push_str(letter);
    for number in numbers.iter().copied().chain(sigma) {
        to.push(',');
        write(&[Some(number)], to);
    }
    to.push('\n');
}
