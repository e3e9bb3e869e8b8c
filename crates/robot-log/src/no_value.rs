//! Speeds and turn rates that are none: a bus writes the greatest number of a signal, as 655.35 km/h, where a sensor
//! has no value.

use estimate::drive::{Event, Row};

/// No value is taken for none that is not beyond this, m/s and rad/s.
const LEAST: [f64; 2] = [60.0, 5.0];
/// It is so many times as large as any other.
const TIMES: f64 = 3.0;
/// Two numbers have such a meaning, no value and a fault, and are this near to one another.
const ALIKE: f64 = 0.99;
const MEANINGS: usize = 2;

/// Leaves out the speeds and the turn rates that are such numbers, and says so.
pub(crate) fn left_out(rows: &mut Vec<Row>) -> Vec<String> {
    let speed = least_of(rows.iter().filter_map(|row| speed(&row.event)).collect(), LEAST[0]);
    let rate = least_of(rows.iter().filter_map(|row| rate(&row.event)).collect(), LEAST[1]);
    if speed.is_none() && rate.is_none() {
        return Vec::new();
    }
    let none = |of: Option<f64>, least: Option<f64>| of.zip(least).is_some_and(|(it, least)| it.abs() >= least);
    let mut counts = [0; 2];
    rows.retain_mut(|row| {
        let [no_speed, no_rate] = [none(self::speed(&row.event), speed), none(self::rate(&row.event), rate)];
        counts = [counts[0] + usize::from(no_speed), counts[1] + usize::from(no_rate)];
        match (row.event, no_speed, no_rate) {
            (_, false, false) => true,
            (Event::Velocity { omega, .. }, true, false) => {
                row.event = Event::TurnRate { omega };
                true
            }
            (Event::Velocity { v, .. }, false, true) => {
                row.event = Event::Speed { v };
                true
            }
            _ => false,
        }
    });
    let said = |(count, least, what, unit): (usize, Option<f64>, &str, &str)| {
        let least = least.filter(|_| count > 0)?;
        let row = if count == 1 { "row" } else { "rows" };
        Some(format!(
            "The {what} of {count} {row} is left out: {least:.4} {unit} is more than {TIMES} times as much as in any \
             other row, as a bus writes where a sensor has no value."
        ))
    };
    let all = [(counts[0], speed, "speed", "m/s"), (counts[1], rate, "turn rate", "rad/s")];
    all.into_iter().filter_map(said).collect()
}

fn speed(event: &Event) -> Option<f64> {
    match *event {
        Event::Velocity { v, .. } | Event::Speed { v } => Some(v),
        _ => None,
    }
}

fn rate(event: &Event) -> Option<f64> {
    match *event {
        Event::Velocity { omega, .. } | Event::TurnRate { omega } => Some(omega),
        _ => None,
    }
}

/// From which size on numbers mean that there is none: the same one or two numbers in less than half of the rows, and
/// far beyond all others.
fn least_of(mut all: Vec<f64>, beyond: f64) -> Option<f64> {
    all.sort_by(|one, other| one.abs().total_cmp(&other.abs()));
    let most = all.last()?.abs();
    let from = all.partition_point(|it| it.abs() < ALIKE * most);
    let (others, same) = all.split_at(from);
    let greatest = others.last()?.abs();
    let mut kinds = same.to_vec();
    kinds.dedup();
    let sound = most > beyond && greatest > 0.0 && most > TIMES * greatest && same.len() < others.len();
    (sound && kinds.len() <= MEANINGS && (same.len() > kinds.len() || kinds.len() == 1)).then(|| same[0].abs())
}
