//! Readings that a log has twice, as where one file was opened under two names: each would count twice.

use crate::sensed::READ;
use estimate::drive::{Event, Row};

/// So many copies are said, and where they are more than this share of their readings: a sensor of few digits may read
/// the same twice in a moment.
const LEAST: usize = 5;
const SHARE: f64 = 0.1;

/// What is said of readings with the time and the values of another.
pub(crate) fn twice(rows: &[Row]) -> Vec<String> {
    let said = |(what, is): &(&str, fn(&Event) -> bool)| {
        let read: Vec<&Row> = rows.iter().filter(|row| is(&row.event)).collect();
        let at_once = read.chunk_by(|one, next| one.time == next.time);
        let copies: usize = at_once.map(copied).sum();
        (copies >= LEAST && copies as f64 > SHARE * read.len() as f64).then(|| {
            format!(
                "{copies} of {} {what} have the time and the values of another, and count twice: is a file opened \
                 under two names, or written twice?",
                read.len()
            )
        })
    };
    READ.iter().filter_map(said).collect()
}

/// Within a moment a copy is looked for among so many rows before: a log whose times are all the same ends too.
const NEAR: usize = 16;

/// How many of the rows of one moment are copies of an earlier one.
fn copied(rows: &[&Row]) -> usize {
    let before = |i: usize| &rows[i.saturating_sub(NEAR)..i];
    (1..rows.len()).filter(|i| before(*i).iter().any(|row| row.event == rows[*i].event)).count()
}
