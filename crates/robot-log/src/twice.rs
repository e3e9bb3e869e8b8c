//! Readings that a log has twice, as where one file was opened under two names or written twice: counted twice, each
//! would be trusted √2 times too much.

use crate::sensed::READ;
use estimate::drive::{Event, Row};

/// So many copies are left out, and where they are more than this share of their readings: a sensor of few digits may
/// read the same twice in a moment.
const LEAST: usize = 5;
const SHARE: f64 = 0.1;

/// Leaves out the readings with the time and the values of another, and says so.
pub(crate) fn left_out(rows: &mut Vec<Row>) -> Vec<String> {
    READ.iter().filter_map(|(what, is)| left_out_of(rows, what, *is)).collect()
}

fn left_out_of(rows: &mut Vec<Row>, what: &str, is: fn(&Event) -> bool) -> Option<String> {
    let read: Vec<usize> = (0..rows.len()).filter(|at| is(&rows[*at].event)).collect();
    let at_once = read.chunk_by(|one, next| rows[*one].time == rows[*next].time);
    let copies: Vec<usize> = at_once.flat_map(|moment| copies_in(moment, rows)).collect();
    if copies.len() < LEAST || copies.len() as f64 <= SHARE * read.len() as f64 {
        return None;
    }
    let (mut at, mut out) = (0, copies.iter().copied().peekable());
    rows.retain(|_| {
        at += 1;
        out.next_if_eq(&(at - 1)).is_none()
    });
    Some(format!(
        "{} of {} {what} have the time and the values of another and are left out: is a file opened under two names, \
         or written twice?",
        copies.len(),
        read.len()
    ))
}

/// Within a moment a copy is looked for among so many rows before: a log whose times are all the same ends too.
const NEAR: usize = 16;

/// Those of one moment that say what an earlier one says.
fn copies_in(moment: &[usize], rows: &[Row]) -> Vec<usize> {
    let said = |i: &usize| (i.saturating_sub(NEAR)..*i).any(|j| rows[moment[j]].event == rows[moment[*i]].event);
    (1..moment.len()).filter(said).map(|i| moment[i]).collect()
}
