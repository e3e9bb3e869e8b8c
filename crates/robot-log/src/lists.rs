//! Fields that hold a list: `(2.5, 3.1)`, as a message with an array of ranges is written. Such a row is as many rows.

use crate::error::Error;
use crate::fields::{Field, Line};

/// What a field holds: the parts of its list, or itself.
pub(crate) fn parts(text: &str) -> Vec<&str> {
    let inner = |open: char, close: char| text.strip_prefix(open).and_then(|text| text.strip_suffix(close));
    let list = inner('(', ')').or_else(|| inner('[', ']'));
    list.map_or_else(|| vec![text], |list| list.split([',', ';']).map(str::trim).filter(|it| !it.is_empty()).collect())
}

fn is_list(text: &str) -> bool {
    (text.starts_with('(') && text.ends_with(')')) || (text.starts_with('[') && text.ends_with(']'))
}

/// The rows that a line stands for, where the fields of these columns are lists; `None` where none is.
///
/// # Errors
/// The lists have different lengths.
pub(crate) fn rows<'t>(line: &Line<'t>, columns: &[usize]) -> Result<Option<Vec<Line<'t>>>, Error> {
    let field = |at: &usize| line.fields.get(*at).filter(|field| is_list(field.text)).copied();
    let lists: Vec<(usize, Field<'t>)> = columns.iter().filter_map(|at| Some((*at, field(at)?))).collect();
    let Some((_, first)) = lists.first() else { return Ok(None) };
    let length = parts(first.text).len();
    if let Some((_, other)) = lists.iter().find(|(_, field)| parts(field.text).len() != length) {
        let message = format!("the list has {} numbers, and another of its row {length}", parts(other.text).len());
        return Err(Error::new(line.number, other.column, message));
    }
    let row = |i: usize| {
        let mut row = line.clone();
        lists.iter().for_each(|(at, field)| row.fields[*at].text = parts(field.text)[i]);
        row
    };
    Ok(Some((0..length).map(row).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line<'t>(texts: &[&'t str]) -> Line<'t> {
        let fields = texts.iter().map(|text| Field { text, column: 7 }).collect();
        Line { number: 3, fields, end: 9 }
    }

    #[test]
    fn lists_of_one_length_are_rows_and_others_are_a_fault() {
        let texts = |row: &Line<'_>| row.fields.iter().map(|field| field.text.to_string()).collect::<Vec<_>>();
        let read = rows(&line(&["1", "(5, 6)", "[0.5,0.25]"]), &[1, 2]).expect("sound").expect("lists");
        assert_eq!(read.iter().map(texts).collect::<Vec<_>>(), [["1", "5", "0.5"], ["1", "6", "0.25"]]);
        assert_eq!(rows(&line(&["1", "5", "0.5"]), &[1, 2]), Ok(None));
        assert_eq!(rows(&line(&["1", "()", "[]"]), &[1, 2]), Ok(Some(Vec::new())));
        assert_eq!(rows(&line(&["1", "(5, 6)", "(1)"]), &[1, 2]).expect_err("unequal").column, 7);
    }
}
