//! What a page has used, so that its end matter can say where it comes from.

use std::collections::{BTreeMap, BTreeSet};

/// What a page has used, for its end matter.
#[derive(Debug, Default)]
pub struct Used {
    /// Keys of the glossary.
    pub terms: BTreeSet<String>,
    /// Ids of numbers.
    pub numbers: BTreeSet<String>,
    /// Keys of references.
    pub references: BTreeSet<String>,
    /// Ids of quizzes.
    pub quizzes: BTreeSet<String>,
    /// Whether the page lists its references itself.
    pub listed_references: bool,
    /// Whether a figure that moves has come.
    pub widget: bool,
    /// Stills' panels in files of their own, by name among the assets.
    pub pictures: BTreeMap<String, String>,
}
