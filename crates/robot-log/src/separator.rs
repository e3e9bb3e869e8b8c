//! What parts the fields of a line, and the fields that it parts.

use crate::fields::is_none;
use crate::row::number;
use crate::stamp;

/// The most columns of a table.
pub(crate) const MAX_COLUMNS: usize = 1024;

/// What parts the fields of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Separator {
    Char(char),
    /// One blank or more, tabs among them.
    Blanks,
}

/// What parts the fields of a line: what makes numbers of them; between words, what stands there. There a tab comes
/// before a comma, which may be a decimal one or stand within a name, but not where every comma has its tab.
pub(crate) fn separator(line: &str) -> Separator {
    use Separator::{Blanks, Char};
    const ALL: [Separator; 5] = [Char(';'), Char(','), Char('\t'), Char('|'), Blanks];
    let parts = |by: Separator| split(line, by).nth(1).is_some();
    let numbers = |by: Separator| split(line, by).all(|(_, field)| is_number(unquoted(field)));
    let found = ALL.into_iter().find(|by| parts(*by) && numbers(*by));
    let tab = || Some(Char('\t')).filter(|by| parts(*by) && ![",\t", "\t,", ";"].iter().any(|it| line.contains(it)));
    found.or_else(tab).or_else(|| ALL.into_iter().find(|by| parts(*by))).unwrap_or(Separator::Blanks)
}

/// Whether a field may be among numbers: a row may leave one out.
pub(crate) fn is_number(field: &str) -> bool {
    is_none(field) || number(field).is_some() || stamp::seconds(field).is_some()
}

/// How many fields of a line are numbers.
pub(crate) fn numbers(line: &str, separator: Separator) -> usize {
    let full = |field: &str| !is_none(field) && is_number(field);
    split(line, separator).take(MAX_COLUMNS + 1).filter(|(_, field)| full(unquoted(field))).count()
}

/// The fields of a line without the blanks around them, each with the byte at which it begins.
pub(crate) fn split(line: &str, separator: Separator) -> Box<dyn Iterator<Item = (usize, &str)> + '_> {
    let at = |part: &str| part.as_ptr() as usize - line.as_ptr() as usize;
    match separator {
        Separator::Blanks => Box::new(line.split_whitespace().map(move |field| (at(field), field))),
        Separator::Char(c) => Box::new(parted(line, c).map(move |field| {
            let field = field.trim();
            (at(field), field)
        })),
    }
}

/// A line parted at a separator, but not within the double quotes of a field. Quotes that are not closed before a
/// separator or the end are letters.
fn parted(line: &str, separator: char) -> impl Iterator<Item = &str> {
    let mut rest = Some(line);
    std::iter::from_fn(move || {
        let line = rest?;
        let end = quoted_end(line, separator).or_else(|| line.find(separator)).unwrap_or(line.len());
        rest = line[end..].strip_prefix(separator);
        Some(&line[..end])
    })
}

/// Where a field ends that a line begins with and that has double quotes around it; two of them within are one.
fn quoted_end(line: &str, separator: char) -> Option<usize> {
    let inner = line.trim_start().strip_prefix('"')?;
    let mut rest = inner;
    loop {
        let behind = &rest[rest.find('"')? + 1..];
        if let Some(more) = behind.strip_prefix('"') {
            rest = more;
            continue;
        }
        let next = behind.trim_start_matches(' ');
        return (next.is_empty() || next.starts_with(separator)).then_some(line.len() - next.len());
    }
}

/// A field without a pair of quotes around it, as spreadsheets write names.
pub(crate) fn unquoted(field: &str) -> &str {
    let inner = |quote: char| field.strip_prefix(quote).and_then(|field| field.strip_suffix(quote));
    inner('"').or_else(|| inner('\'')).map_or(field, str::trim)
}
