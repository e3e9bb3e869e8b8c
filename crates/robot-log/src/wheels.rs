//! Encoders of two wheels: what they count becomes the way and the turn of a robot with a differential drive.

use crate::counter::Jumps;
use crate::unit::Unit;
use estimate::drive::Event;

/// Whether an encoder counts on, or anew from each row to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counting {
    /// The count since the start.
    Total,
    /// The count since the row before.
    Step,
    /// The count since the start, and a jump that no motion makes is another start: it says nothing of the way.
    Restarted,
}

/// What is known of the wheels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wheels {
    /// Ticks of a whole turn of the wheel.
    pub ticks: Option<f64>,
    /// The wheel's radius, m.
    pub radius: Option<f64>,
    /// The distance between the two wheels, m.
    pub base: Option<f64>,
    /// How the encoders count.
    pub counting: Option<Counting>,
}

/// The names of the numbers.
pub const WHEEL_NUMBERS: [&str; 3] = ["ticks", "radius", "base"];

impl Wheels {
    /// One of the numbers.
    pub fn number(&self, name: &str) -> Option<f64> {
        match name {
            "ticks" => self.ticks,
            "radius" => self.radius,
            "base" => self.base,
            _ => None,
        }
    }

    /// Sets one of the numbers, which must be above 0. Answers whether there is such a one.
    pub(crate) fn set(&mut self, name: &str, number: f64) -> bool {
        let place = match name {
            "ticks" => &mut self.ticks,
            "radius" => &mut self.radius,
            "base" => &mut self.base,
            _ => return false,
        };
        let sound = number.is_finite() && number > 0.0;
        if sound {
            *place = Some(number);
        }
        sound
    }

    /// What has to be said before wheels in this unit can be read.
    pub(crate) fn lacks(&self, unit: &str) -> Option<String> {
        let said = |what: &str| match what {
            "counting" => self.counting.is_some(),
            number => self.number(number).is_some(),
        };
        let words = |what: &&str| match *what {
            "ticks" => "how many ticks there are in one turn of a wheel",
            "radius" => "a wheel\u{2019}s radius",
            "base" => "the distance between the wheels",
            _ => "whether each row counts from the start of the log or from the row before",
        };
        let lacking: Vec<&str> = needed(Some(unit)).iter().filter(|what| !said(what)).map(words).collect();
        (!lacking.is_empty()).then(|| format!("Encoders need {}.", lacking.join(", ")))
    }

    /// What two wheels have done, or how fast they are; `before` is what they had counted in the row before. The first
    /// row of totals has none before it and says nothing.
    pub(crate) fn event(
        &self,
        unit: &Unit,
        [left, right]: [f64; 2],
        before: Option<[f64; 2]>,
        jumps: &Jumps,
    ) -> Option<Event> {
        let metres = match unit.name {
            "ticks" => core::f64::consts::TAU / self.ticks? * self.radius?,
            name if is_angle(name) => self.radius?,
            _ => 1.0,
        };
        let before = match self.counting {
            Some(Counting::Total | Counting::Restarted) if !is_speed(unit.name) => before?,
            _ => [0.0, 0.0],
        };
        let (left, right) = (jumps.step(before[0], left) * metres, jumps.step(before[1], right) * metres);
        let (along, turned) = ((left + right) / 2.0, (right - left) / self.base?);
        Some(match is_speed(unit.name) {
            true => Event::Velocity { v: along, omega: turned },
            false => Event::Odometry { distance: along, turn: turned },
        })
    }
}

/// What has to be said of wheels in a unit: numbers of [`WHEEL_NUMBERS`], and how they count; of all units, where it is
/// not known yet.
pub(crate) fn needed(unit: Option<&str>) -> &'static [&'static str] {
    match unit {
        None | Some("ticks") => &["ticks", "radius", "base", "counting"],
        Some(unit) if is_speed(unit) && is_angle(unit) => &["radius", "base"],
        Some(unit) if is_speed(unit) => &["base"],
        Some(unit) if is_angle(unit) => &["radius", "base", "counting"],
        Some(_) => &["base", "counting"],
    }
}

/// Whether a unit is of a wheel's angle, which becomes a way by the radius.
fn is_angle(unit: &str) -> bool {
    matches!(unit, "ticks" | "rad" | "deg" | "rad/s" | "rpm")
}

pub(crate) fn is_speed(unit: &str) -> bool {
    matches!(unit, "rad/s" | "rpm" | "m/s" | "mm/s" | "km/h")
}
