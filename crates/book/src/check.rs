//! The page that runs the chapter's checks again in the reader's own browser.

use labs::checks::Check;
use minijinja::{Value, context};

use crate::source::Sources;

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

/// The file that holds the checks as tests.
const TESTS: &str = "tests/thirteen_checks.rs";

/// The rows of the page, which lies one level below the site's root.
pub fn rows(checks: &[Check], sources: &Sources) -> Vec<Value> {
    let list = |values: &[f64]| values.iter().map(|&value| short(value)).collect::<Vec<_>>().join(", ");
    let row = |check: &Check| {
        let line = sources.line_of(TESTS, &format!("fn check_{}_", check.id)).unwrap_or(1);
        context! {
            id => check.id,
            title => check.title,
            expected => list(&check.expected),
            actual => list(&check.actual),
            tolerance => short(check.tolerance),
            source => format!("../source/{TESTS}.html#L{line}"),
        }
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
