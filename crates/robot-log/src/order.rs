//! The order of a file's rows. Parts of it may stand the other way round: of a recording in two pieces, put together
//! with the second one first. Then they are read in the order of their times. A second run is none of that: its times
//! are among those of the first, or far away from them.

use core::ops::Range;

/// A clock that goes back further than this, s, and on from there for so many rows, has begun anew.
pub(crate) const BACK: f64 = 5.0;
pub(crate) const ROWS: u32 = 20;
/// More parts than these are no order.
const MOST: usize = 64;

/// Lines of a file, from one on and up to another, and their times.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Part {
    line: u32,
    until: u32,
    rows: u32,
    from: f64,
    to: f64,
}

/// The parts of a file in the order of their times.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Order(Vec<Part>);

impl Order {
    /// The order of rows whose lines and times are given; `None` where they stand in it, and where no parts as a whole
    /// are exchanged: their times overlap, or leave more out than they have.
    pub fn of(times: impl Iterator<Item = (u32, f64)>) -> Option<Self> {
        let mut parts: Vec<Part> = Vec::new();
        let (mut before, mut left): (Option<f64>, Option<f64>) = (None, None);
        for (line, time) in times {
            let back = before.filter(|before| time < before - BACK);
            if before.is_none() || back.is_some() || left.is_some_and(|left| time > left) {
                if let Some(last) = parts.last_mut() {
                    last.until = line;
                }
                left = back;
                parts.push(Part { line, until: u32::MAX, rows: 0, from: time, to: time });
                if parts.len() > MOST {
                    return None;
                }
            }
            let part = parts.last_mut()?;
            (part.rows, part.from, part.to) = (part.rows + 1, part.from.min(time), part.to.max(time));
            before = Some(time);
        }
        let span: f64 = parts.iter().map(|part| part.to - part.from).sum();
        let sound = parts.len() > 1 && parts.iter().all(|part| part.rows >= ROWS);
        parts.sort_by(|a, b| a.from.total_cmp(&b.from));
        let follow = parts.windows(2).all(|pair| (0.0..=span).contains(&(pair[1].from - pair[0].to)));
        (sound && follow).then_some(Self(parts))
    }

    /// The lines of its parts.
    pub fn lines(&self) -> Vec<Range<u32>> {
        let first = self.0.iter().map(|part| part.line).min();
        // What stands above the first row with a time is read with it.
        let begin = |line: u32| if Some(line) == first { 0 } else { line };
        self.0.iter().map(|part| begin(part.line)..part.until).collect()
    }

    /// What is said of it.
    pub fn note(&self, name: &str) -> String {
        let Self(parts) = self;
        // One stands behind a later one.
        let early = parts.windows(2).find(|pair| pair[0].line > pair[1].line).map_or(parts[0], |pair| pair[0]);
        let [from, to] = [early.from, early.to].map(|time| (100.0 * time).round() / 100.0);
        format!(
            "{name}: its rows are in another order than their times: those from line {} on, {from} to {to} s, are \
             earlier than rows above them. They are read by their times. If the clock began anew there, part the file \
             at this line.",
            early.line
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(parts: &[(u32, u32)]) -> Option<Vec<f64>> {
        let times = parts.iter().flat_map(|(from, to)| (10 * from..10 * to).map(|tenth| f64::from(tenth) / 10.0));
        let order = Order::of(times.enumerate().map(|(i, time)| (i as u32 + 2, time)))?;
        Some(order.0.iter().map(|part| part.from).collect())
    }

    #[test]
    fn parts_that_fit_before_and_behind_one_another_have_an_order_and_a_second_run_has_none() {
        assert_eq!(of(&[(10, 20), (0, 10)]), Some(vec![0.0, 10.0]));
        assert_eq!(of(&[(20, 30), (10, 20), (0, 10)]), Some(vec![0.0, 10.0, 20.0]));
        assert_eq!(of(&[(10, 20), (0, 10), (20, 30)]), Some(vec![0.0, 10.0, 20.0]));
        assert_eq!(of(&[(10, 20), (30, 40), (20, 30)]), None, "a part that fits into the middle of another");
        assert_eq!(of(&[(0, 20)]), None, "in order");
        assert_eq!(of(&[(0, 20), (0, 10)]), None, "a second run");
        assert_eq!(of(&[(10, 20), (0, 11)]), None, "they overlap");
        assert_eq!(of(&[(5000, 5010), (0, 10)]), None, "far away from each other");
        assert_eq!(of(&[(10, 20), (8, 9)]), None, "ten rows are astray");
    }
}
