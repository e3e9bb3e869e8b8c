//! Files that end within their last row: a logger that was switched off wrote no more of it.

use crate::table::Table;

/// Of fewer rows nobody knows how many digits are usual.
const LEAST: usize = 5;

/// The line of a last row that may be cut: it does not end, and it lacks fields, or its last number has fewer decimals
/// than in every other row.
pub(crate) fn cut(table: &Table, text: &str) -> Option<u32> {
    if text.ends_with(['\n', '\r']) {
        return None;
    }
    let mut column: Vec<(u32, &str)> = table.column(text, table.names.len().checked_sub(1)?).collect();
    let (end, _) = table.column(text, 0).last()?;
    let (line, last) = column.pop()?;
    if column.len() < LEAST {
        return None;
    }
    if line < end {
        return Some(end);
    }
    let whole = table.lines(text).last().is_some_and(|line| line.is_ok());
    let fewest = column.iter().filter_map(|(_, number)| decimals(number)).min()?;
    (whole && decimals(last)? < fewest).then_some(line)
}

/// How many digits stand behind the point of a number; `None` of a text and of one with an exponent.
fn decimals(text: &str) -> Option<usize> {
    let digits = |text: &str| text.bytes().all(|it| it.is_ascii_digit());
    let (whole, fraction) = text.split_once(['.', ',']).unwrap_or((text, ""));
    let number = whole.strip_prefix('-').unwrap_or(whole);
    (!number.is_empty() && digits(number) && digits(fraction)).then_some(fraction.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(last: &str) -> Option<u32> {
        let rows: String = (0..6).map(|i| format!("{i}.0,0.12{i}\n")).collect();
        let text = format!("t,v\n{rows}6.0,{last}");
        cut(&Table::new(&text).expect("a table"), &text)
    }

    #[test]
    fn a_last_number_with_fewer_decimals_than_all_others_is_cut_unless_its_line_ends() {
        assert_eq!(found("0.1"), Some(8));
        assert_eq!(found("-0"), Some(8));
        let rows: String = (0..6).map(|i| format!("{i}.0,0.12{i}\n")).collect();
        let lacking = format!("t,v\n{rows}6.");
        assert_eq!(cut(&Table::new(&lacking).expect("a table"), &lacking), Some(8));
        assert_eq!([found("0.1\n"), found("0.129"), found("1e-3"), found("nan")], [None; 4]);
    }
}
