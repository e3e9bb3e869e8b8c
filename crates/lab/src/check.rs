//! A claim of a chapter, computed.

use serde::Serialize;

/// One check: a claim, what was computed, and whether they agree.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// Its number in the chapter, from 1 on.
    pub id: u8,
    /// What is claimed.
    pub title: &'static str,
    /// The claim, in numbers.
    pub expected: Vec<f64>,
    /// The same numbers, computed.
    pub actual: Vec<f64>,
    /// The largest difference allowed between the two.
    pub tolerance: f64,
    /// Whether every difference is within the tolerance.
    pub passed: bool,
}

impl Check {
    /// A check that passes when both lists are of one length and agree, entry by entry, within `tolerance`.
    pub fn new(id: u8, title: &'static str, expected: Vec<f64>, actual: Vec<f64>, tolerance: f64) -> Self {
        let close = |(e, a): (&f64, &f64)| (e - a).abs() <= tolerance;
        let passed = expected.len() == actual.len() && expected.iter().zip(&actual).all(close);
        Self { id, title, expected, actual, tolerance, passed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_check_fails_on_a_difference_a_nan_or_a_missing_number() {
        let check =
            |expected: &[f64], actual: &[f64]| Check::new(1, "", expected.to_vec(), actual.to_vec(), 0.1).passed;
        assert!(check(&[1.0, 2.0], &[1.05, 1.95]));
        assert!(!check(&[1.0, 2.0], &[1.05, 2.2]));
        assert!(!check(&[1.0], &[f64::NAN]));
        assert!(!check(&[1.0, 2.0], &[1.0]));
    }
}
