//! The page that runs the chapter's checks again in the reader's own browser.

use serde::Serialize;

use crate::source::Sources;

/// A check as computed when the book was built.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Check {
    /// 1 to 13.
    pub id: u8,
    /// What it claims.
    pub title: String,
    /// The value it should have.
    pub expected: String,
    /// The value it had, natively.
    pub actual: String,
    /// The largest difference allowed between the two.
    pub tolerance: String,
}

impl From<labs::checks::Check> for Check {
    fn from(check: labs::checks::Check) -> Self {
        let list = |values: &[f64]| values.iter().map(|&value| short(value)).collect::<Vec<_>>().join(", ");
        let title = check.title.to_string();
        let (expected, actual) = (list(&check.expected), list(&check.actual));
        Self { id: check.id, title, expected, actual, tolerance: short(check.tolerance) }
    }
}

/// A value in six significant digits, as the page's script prints it too.
fn short(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-4..1e6).contains(&size) {
        let decimals = if value == 0.0 { 0 } else { (5 - size.log10().floor() as i32).clamp(0, 12) as usize };
        let text = format!("{value:.decimals$}");
        let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        text.replace('-', "\u{2212}")
    } else {
        let text = format!("{value:.5e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        let digits = if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
        format!("{digits}e{power}").replace('-', "\u{2212}")
    }
}

/// A row of the page.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The check.
    #[serde(flatten)]
    pub check: Check,
    /// The page of its test, at its line.
    pub source: String,
}

/// The file that holds the checks as tests.
const TESTS: &str = "tests/thirteen_checks.rs";

/// The rows of the page, which lies one level below the site's root.
pub fn rows(checks: &[Check], sources: &Sources) -> Vec<Row> {
    let row = |check: &Check| {
        let line = sources.line_of(TESTS, &format!("fn check_{}_", check.id)).unwrap_or(1);
        Row { check: check.clone(), source: format!("../source/{TESTS}.html#L{line}") }
    };
    checks.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_short_and_exact_where_they_can_be() {
        let cases = [
            (2.0, "2"),
            (0.5, "0.5"),
            (-1.3, "\u{2212}1.3"),
            (1.2759615384615385, "1.27596"),
            (1e-12, "1e\u{2212}12"),
            (0.0, "0"),
        ];
        for (value, expected) in cases {
            assert_eq!(short(value), expected);
        }
    }
}
