//! The sensors of a log, and what is told or said of each.

use crate::drive::gaps::median;
use crate::drive::row::{Drive, Event, Row};

/// A sensor of a log that corrects the estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sensor {
    /// Fixes of the position.
    Fix,
    /// Headings.
    Heading,
    /// Ranges.
    Range,
    /// Ranges with a bearing.
    Bearing,
}

impl Sensor {
    /// Which sensor a row is of; `None` of motion.
    pub fn of(event: &Event) -> Option<Self> {
        match event {
            Event::Position { .. } => Some(Self::Fix),
            Event::Heading { .. } => Some(Self::Heading),
            Event::Range { .. } => Some(Self::Range),
            Event::RangeBearing { .. } => Some(Self::Bearing),
            Event::Odometry { .. } | Event::Velocity { .. } | Event::Speed { .. } | Event::TurnRate { .. } => None,
        }
    }

    /// p, how many numbers a reading of it has.
    pub fn outputs(self) -> u32 {
        match self {
            Self::Fix | Self::Bearing => 2,
            Self::Heading | Self::Range => 1,
        }
    }
}

impl Drive {
    /// How many readings of a sensor bring a standard deviation of their own, and the least and the greatest of these;
    /// `None` where none does.
    pub fn own_sigmas(&self, sensor: Sensor) -> Option<(u32, [f64; 2])> {
        self.each_own(sensor).fold(None, |all, sigma| {
            let (count, [least, most]) = all.unwrap_or((0, [sigma; 2]));
            Some((count + 1, [least.min(sigma), most.max(sigma)]))
        })
    }

    /// The least of the standard deviations that readings of a sensor bring, their median and the greatest.
    pub(crate) fn claims(&self, sensor: Sensor) -> Option<[f64; 3]> {
        let (_, [least, most]) = self.own_sigmas(sensor)?;
        Some([least, median(self.each_own(sensor)), most])
    }

    fn each_own(&self, sensor: Sensor) -> impl Iterator<Item = f64> {
        self.rows.iter().filter_map(move |row: &Row| match (sensor, &row.event) {
            (Sensor::Fix, Event::Position { sigma, .. }) | (Sensor::Heading, Event::Heading { sigma, .. }) => *sigma,
            _ => None,
        })
    }
}

impl Event {
    /// Whether the row says how the robot moved, and not what a sensor read.
    pub fn is_motion(&self) -> bool {
        Sensor::of(self).is_none()
    }

    /// Whether the row reads a speed that is held.
    pub fn has_speed(&self) -> bool {
        matches!(self, Self::Velocity { .. } | Self::Speed { .. })
    }

    /// Whether a row says that the robot drives.
    pub(crate) fn drives(&self) -> bool {
        self.drives_and_turns() || matches!(self, Self::Speed { v } if *v != 0.0)
    }

    /// Whether a row reads a way and a turn, as two wheels do, and the robot drives.
    pub(crate) fn drives_and_turns(&self) -> bool {
        matches!(self, Self::Odometry { distance: way, .. } | Self::Velocity { v: way, .. } if *way != 0.0)
    }

    /// Whether a row says that the robot turns.
    pub(crate) fn turns(&self) -> bool {
        matches!(
            self,
            Self::Odometry { turn: rate, .. } | Self::Velocity { omega: rate, .. } | Self::TurnRate { omega: rate }
                if *rate != 0.0
        )
    }

    /// Whether the row reads a turn rate that is held.
    pub fn has_turn_rate(&self) -> bool {
        matches!(self, Self::Velocity { .. } | Self::TurnRate { .. })
    }
}

/// Something for each sensor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BySensor<T> {
    /// Of the fixes.
    pub fix: T,
    /// Of the headings.
    pub heading: T,
    /// Of ranges alone.
    pub range: T,
    /// Of ranges with a bearing.
    pub bearing: T,
}

impl<T: Copy> BySensor<T> {
    /// The same for all sensors.
    pub fn all(value: T) -> Self {
        Self { fix: value, heading: value, range: value, bearing: value }
    }

    /// What becomes of each.
    pub fn map<U>(self, of: impl Fn(T) -> U) -> BySensor<U> {
        BySensor { fix: of(self.fix), heading: of(self.heading), range: of(self.range), bearing: of(self.bearing) }
    }
}

impl<T: PartialEq> BySensor<T> {
    /// Whether it is the same for all sensors.
    pub fn is_one(&self) -> bool {
        self.fix == self.heading && self.heading == self.range && self.range == self.bearing
    }
}

impl<T> BySensor<T> {
    /// That of one sensor.
    pub fn of(&self, sensor: Sensor) -> &T {
        match sensor {
            Sensor::Fix => &self.fix,
            Sensor::Heading => &self.heading,
            Sensor::Range => &self.range,
            Sensor::Bearing => &self.bearing,
        }
    }

    /// That of one sensor, to change it.
    pub fn of_mut(&mut self, sensor: Sensor) -> &mut T {
        match sensor {
            Sensor::Fix => &mut self.fix,
            Sensor::Heading => &mut self.heading,
            Sensor::Range => &mut self.range,
            Sensor::Bearing => &mut self.bearing,
        }
    }

    /// Each, with the name by which a caller knows its sensor.
    pub fn each(&self) -> [(&'static str, &T); 4] {
        [("fix", &self.fix), ("heading", &self.heading), ("range", &self.range), ("bearing", &self.bearing)]
    }
}
