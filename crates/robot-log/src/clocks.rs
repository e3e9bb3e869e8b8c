//! The clocks of a file that has several: what follows from each for its rows, so that a reader can tell which is
//! meant.

use crate::cells::Cells;
use crate::columns::{found, unit};
use crate::counter::Jumps;
use crate::evidence;
use crate::source::Source;

/// What follows from each column that may be the time: the rate and the span of the rows, and whose own it is.
pub(crate) fn clocks(source: &Source, file: &str, text: &str) -> Vec<String> {
    let timed = source.role.values().first().is_some_and(|value| value.name == "time");
    let (Some(clocks), Some(table)) = (source.doubts.first().filter(|_| timed), source.table.as_ref()) else {
        return Vec::new();
    };
    let told = |at: &usize| {
        let mut tried = source.clone();
        tried.columns[0] = Some(*at);
        for (i, value) in source.role.values().iter().enumerate() {
            if matches!(value.name, "fraction" | "day") {
                tried.columns[i] = found(&tried, value, file, text).first().copied();
                tried.units[i] = unit(&tried, i, file, text);
            }
        }
        tried.units[0] = unit(&tried, 0, file, text);
        let mut said = if tried.units[0].is_some() { evidence::rate(times(&tried, text)) } else { Vec::new() };
        let own = own(source, *at, clocks);
        match own.as_slice() {
            [] => {}
            [one] => said.push(format!("the clock of {one}")),
            [first @ .., last] => said.push(format!("the clock of {} and {last}", first.join(", "))),
        }
        if said.is_empty() { "its unit is not known".into() } else { said.join(", ") }
    };
    if table.nameless { Vec::new() } else { clocks.iter().map(told).collect() }
}

fn times(source: &Source, text: &str) -> Vec<f64> {
    let Some(table) = &source.table else { return Vec::new() };
    let jumps = Jumps::default();
    let lines = table.lines(text).filter_map(Result::ok);
    lines.filter_map(|line| Cells { file: 0, line: &line, source, absent: &[], jumps: &jumps }.time().ok()).collect()
}

/// What is read beside the clock in a column, of several: what is called as it is at the beginning, as in
/// `locationTimestamp`, `locationLatitude`, and no other of the clocks.
fn own(source: &Source, clock: usize, clocks: &[usize]) -> Vec<&'static str> {
    const READ: [(&str, &str); 5] = [
        ("latitude", "the positions"),
        ("x", "the positions"),
        ("v", "the speed"),
        ("heading", "the heading"),
        ("omega", "the turn rate"),
    ];
    let first = |at: usize| source.names[at].words.first();
    let alone = clocks.iter().filter(|at| first(**at) == first(clock)).count() == 1;
    let is_of = |value: &str| {
        let at = source.role.index(value)?;
        let column = source.columns[at].or_else(|| source.doubts[at].first().copied())?;
        Some(first(column) == first(clock))
    };
    READ.into_iter().filter(|(value, _)| alone && is_of(value) == Some(true)).map(|(_, words)| words).collect()
}
