//! The way that wheels have driven, as a speed: where a gyro says how the robot turned, no row may say both.

use estimate::drive::{Event, Row};

/// The way of a file of which the turn is not taken, as a speed.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Way {
    /// The time of its row before, and what has been driven since without time going on.
    since: Option<(f64, f64)>,
}

impl Way {
    /// The row that a motion makes: a speed from its own time on, a way from that of the row before. A first way, whose
    /// beginning no row says, makes none.
    pub fn speed(&mut self, time: f64, event: Option<Event>) -> Option<Row> {
        let way = match event {
            Some(Event::Velocity { v, .. }) => return Some(Row::new(time, Event::Speed { v })),
            Some(Event::Odometry { distance, .. }) => distance,
            Some(other) => return Some(Row::new(time, other)),
            // The way begins here, or anew: what was driven before is not known.
            None => {
                self.since = Some((time, 0.0));
                return None;
            }
        };
        let (before, waiting) = self.since.replace((time, 0.0))?;
        let way = way + waiting;
        if time <= before {
            self.since = Some((before, way));
            return None;
        }
        Some(Row::new(before, Event::Speed { v: way / (time - before) }))
    }
}
