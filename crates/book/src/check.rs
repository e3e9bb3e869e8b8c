//! The page that runs the chapter's checks again in the reader's own browser.

use lab::Check;
use minijinja::{Value, context};

use crate::source::Sources;

/// A value in seven significant digits, but none beyond the tolerance, as the page's script prints it too: two values
/// that agree look alike.
fn short(value: f64, tolerance: f64) -> String {
    let size = value.abs();
    let finest = (-tolerance.log10() - 1e-9).ceil().clamp(0.0, 12.0) as usize;
    if value == 0.0 || (1e-4..1e6).contains(&size) {
        let decimals = if value == 0.0 { 0 } else { (6 - size.log10().floor() as i32).clamp(0, 12) as usize };
        let decimals = if tolerance < 1.0 { decimals.min(finest) } else { decimals };
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
    let list = |values: &[f64], tolerance: f64| {
        values.iter().map(|&value| short(value, tolerance)).collect::<Vec<_>>().join(", ")
    };
    // A bar says what is expected of a number that nothing but noise fills.
    let expected = |check: &Check| match check.tolerance {
        bar if bar >= 1.0 => format!("at most {} each", short(bar, bar)),
        tolerance => list(&check.expected, tolerance),
    };
    let row = |check: &Check| {
        let line = sources.line_of(TESTS, &format!("fn check_{}_", check.id)).unwrap_or(1);
        context! {
            id => check.id,
            title => check.title.replace(" − ", "\u{a0}−\u{a0}"),
            expected => expected(check),
            actual => list(&check.actual, check.tolerance),
            tolerance => short(check.tolerance, check.tolerance),
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
            (2.0, 1e-12, "2"),
            (0.5, 1e-12, "0.5"),
            (-1.3, 1e-12, "\u{2212}1.3"),
            (1.2759615384615385, 1e-12, "1.275962"),
            (-0.1799695, 1e-7, "\u{2212}0.1799695"),
            (-0.179969491, 1e-7, "\u{2212}0.1799695"),
            (1e-12, 1e-12, "1e\u{2212}12"),
            (0.0, 1e-12, "0"),
        ];
        for (value, tolerance, expected) in cases {
            assert_eq!(short(value, tolerance), expected);
        }
    }
}
