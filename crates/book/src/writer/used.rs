//! What a page has used, so that its end matter can say where it comes from, and what it shows of other pages.

use std::collections::{BTreeMap, BTreeSet};

use crate::tree::Node;

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

/// What a page shows of the chapter's other pages.
#[derive(Debug, Default)]
pub struct Apart<'a> {
    /// Figures of the other pages.
    pub figures: Vec<&'a Node>,
    /// The texts of the other pages, by their addresses.
    pub texts: BTreeMap<&'a str, &'a [Vec<Node>]>,
}
