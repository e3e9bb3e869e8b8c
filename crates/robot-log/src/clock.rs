//! Which columns of a file are its clock's: the time, its fraction, and its day.

use crate::fields::Line;
use crate::names::Name;
use crate::source::Source;
use crate::stamp;
use crate::table::LOOKED_AT;

/// The one column that is called a time and whose stamps are dates.
pub(crate) fn dated(source: &Source, text: &str) -> Option<usize> {
    let first = source.table.as_ref()?.lines(text).find_map(Result::ok)?;
    let is_date = |at: &usize| {
        let cell = first.fields.get(*at).map_or("", |field| field.text);
        stamp::seconds(cell).is_some() && !stamp::is_time_of_day(cell)
    };
    let timed = |at: &usize| source.names[*at].has_one(&["time", "timestamp"]);
    let mut all = (0..source.names.len()).filter(|at| timed(at) && is_date(at));
    all.next().filter(|_| all.next().is_none())
}

/// Whether a column holds the whole seconds of a stamp.
pub(crate) fn is_seconds(name: &Name) -> bool {
    name.words.last().is_some_and(|word| matches!(word.as_str(), "sec" | "secs"))
}

pub(crate) fn stamped(names: &[Name]) -> bool {
    names.iter().any(|name| name.has_one(&["nanosec", "nanosecs", "nsec", "nsecs"]))
}

/// The column with the fraction of a stamp whose seconds are in another: it is called as that one is, but for its unit.
pub(crate) fn found_fraction(names: &[Name], time: usize) -> Option<usize> {
    let (last, path) = names[time].words.split_last()?;
    if !matches!(last.as_str(), "sec" | "secs" | "seconds" | "s") {
        return None;
    }
    let parts = ["nanosec", "nanosecs", "nsec", "nsecs", "nanoseconds", "ns", "usec", "usecs", "us", "msec", "ms"];
    names.iter().position(|name| {
        let Some((last, other)) = name.words.split_last() else { return false };
        other == path && parts.contains(&last.as_str())
    })
}

/// The column of the day where the times are those of a day: one that is called so, and holds days.
pub(crate) fn day_beside(source: &Source, text: &str) -> Option<usize> {
    let (time, table) = (source.columns.first().copied().flatten()?, source.table.as_ref()?);
    let lines: Vec<Line<'_>> = table.lines(text).filter_map(Result::ok).take(LOOKED_AT).collect();
    let first = lines.first()?;
    if !first.fields.get(time).is_some_and(|field| stamp::is_time_of_day(field.text)) {
        return None;
    }
    let days = |at: usize| lines.iter().filter_map(move |line| line.fields.get(at)).map(|field| field.text);
    (0..source.names.len()).find(|at| {
        let said = ["date", "day", "datum", "tag", "jour", "fecha", "dia", "data", "giorno"];
        source.names[*at].has_one(&said) && !stamp::orders(days(*at)).is_empty()
    })
}
