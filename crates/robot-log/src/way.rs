//! The way that wheels have driven, as a speed: where a gyro says how the robot turned, no row may say both.

use estimate::drive::{Event, Row};
use std::collections::HashMap;

/// The way of a file of which the turn is not taken, as a speed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Way {
    /// The time of its row before, and what has been driven since without time going on.
    pub since: Option<(f64, f64)>,
    /// Rows of speeds that are means over a step, by their places in the log, with half of that step, s.
    halves: HashMap<u32, f64>,
    /// Whether the row before has made such a speed.
    follows: bool,
}

impl Way {
    /// The row that a motion makes, the `place`th of the log: a speed from its own time on, a way from that of the row
    /// before. A first way, whose beginning no row says, makes none.
    pub fn speed(&mut self, time: f64, event: Option<Event>, place: usize) -> Option<Row> {
        let way = match event {
            Some(Event::Velocity { v, .. }) => return Some(Row::new(time, Event::Speed { v })),
            Some(Event::Odometry { distance, .. }) => distance,
            Some(other) => return Some(Row::new(time, other)),
            // The way begins here, or anew: what was driven before is not known.
            None => {
                (self.since, self.follows) = (Some((time, 0.0)), false);
                return None;
            }
        };
        let Some((before, waiting)) = self.since.replace((time, 0.0)) else {
            self.follows = false;
            return None;
        };
        let way = way + waiting;
        if time <= before {
            self.since = Some((before, way));
            return None;
        }
        // The first stays where its way begins.
        if core::mem::replace(&mut self.follows, true) {
            self.halves.insert(place as u32, (time - before) / 2.0);
        }
        Some(Row::new(before, Event::Speed { v: way / (time - before) }))
    }

    /// Brings each mean to the middle of its step: there the robot had that speed, if it changed its speed evenly.
    pub fn to_the_middle(&self, rows: &mut [Row]) {
        rows.iter_mut().for_each(|row| row.time += self.halves.get(&row.line).unwrap_or(&0.0));
        let read = |row: &Row| !row.event.is_motion();
        rows.sort_by(|one, next| one.time.total_cmp(&next.time).then(read(one).cmp(&read(next))));
    }
}
