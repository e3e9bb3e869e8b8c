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
    /// How far they may part.
    pub tolerance: String,
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

/// Where the checks are tests.
const TESTS: &str = "tests/thirteen_checks.rs";

/// The rows of the page, which lies one level below the site's root.
pub fn rows(checks: &[Check], sources: &Sources) -> Vec<Row> {
    let row = |check: &Check| {
        let line = sources.line_of(TESTS, &format!("fn check_{:02}_", check.id)).unwrap_or(1);
        Row { check: check.clone(), source: format!("../source/{TESTS}.html#L{line}") }
    };
    checks.iter().map(row).collect()
}
