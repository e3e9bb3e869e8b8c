//! `content/glossary.toml`: the terms that a reader may touch.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::config::{DataFile, Text};
use crate::diagnostic::Diagnostics;

/// The four meanings that have a colour.
pub const KINDS: [&str; 4] = ["prediction", "posterior", "measurement", "truth"];

/// A glossed term.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Term {
    /// What the text calls it by.
    pub key: Text,
    /// The term as the glossary heads it.
    pub name: String,
    /// What it is, in Markdown.
    pub gloss: Text,
    /// Its symbol, TeX in the letters of the reader's notation.
    pub symbol: Option<String>,
    /// The meaning whose colour it has.
    pub kin: Option<Text>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Terms {
    #[serde(default)]
    term: Vec<Term>,
}

/// The glossary, by key.
pub fn glossary(file: &DataFile, diagnostics: &Diagnostics) -> BTreeMap<String, Term> {
    let mut terms = BTreeMap::new();
    for term in file.parse::<Terms>(diagnostics).term {
        let Text { markdown: key, place } = term.key.clone();
        if let Some(kin) = term.kin.as_ref().filter(|kin| !KINDS.contains(&kin.markdown.as_str())) {
            diagnostics.report(&kin.place, format!("kin of `{key}` is none of {}", KINDS.join(", ")));
        }
        if terms.insert(key.clone(), term).is_some() {
            diagnostics.report(&place, format!("two terms are called `{key}`"));
        }
    }
    terms
}
