//! `content/glossary.toml` and `content/notation.toml`: the terms, and the two notations side by side.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

use crate::config::{DataFile, Text};
use crate::diagnostic::Diagnostics;

/// The four meanings that have a colour.
pub const KINDS: [&str; 4] = ["prediction", "posterior", "measurement", "truth"];

/// A glossed term.
#[derive(Clone, Debug)]
pub struct Term {
    /// The term as the glossary heads it.
    pub name: String,
    /// What it is, in Markdown.
    pub gloss: Text,
    /// Its symbol in Choset's letters, TeX; may be empty.
    pub choset: String,
    /// Its symbol in Thrun's letters, TeX; may be empty.
    pub thrun: String,
    /// The meaning whose colour it has.
    pub kin: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawTerm {
    key: Spanned<String>,
    name: String,
    gloss: Spanned<String>,
    #[serde(default)]
    choset: String,
    #[serde(default)]
    thrun: String,
    kin: Option<Spanned<String>>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawGlossary {
    #[serde(default)]
    term: Vec<RawTerm>,
}

/// The glossary, by key.
pub fn glossary(file: &DataFile, diagnostics: &Diagnostics) -> BTreeMap<String, Term> {
    let raw: RawGlossary = file.parse(diagnostics);
    let mut terms = BTreeMap::new();
    for raw in raw.term {
        let (place, key) = (file.place(&raw.key), raw.key.into_inner());
        if let Some(kin) = raw.kin.as_ref().filter(|kin| !KINDS.contains(&kin.get_ref().as_str())) {
            diagnostics.report(&file.place(kin), format!("kin of `{key}` is none of {}", KINDS.join(", ")));
        }
        let gloss = Text::of(&raw.gloss, file);
        let kin = raw.kin.map(Spanned::into_inner);
        let term = Term { name: raw.name, gloss, choset: raw.choset, thrun: raw.thrun, kin };
        if terms.insert(key.clone(), term).is_some() {
            diagnostics.report(&place, format!("two terms are called `{key}`"));
        }
    }
    terms
}

/// A row of the notation table.
#[derive(Clone, Debug)]
pub struct NotationRow {
    /// TeX in Choset's letters.
    pub choset: Text,
    /// TeX in Thrun's letters.
    pub thrun: Text,
    /// What both mean, in Markdown.
    pub meaning: Text,
}

#[derive(Default, Deserialize)]
struct RawNotation {
    #[serde(default)]
    row: Vec<RawRow>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawRow {
    choset: Spanned<String>,
    thrun: Spanned<String>,
    meaning: Spanned<String>,
}

/// The rows of the notation table.
pub fn notation(file: &DataFile, diagnostics: &Diagnostics) -> Vec<NotationRow> {
    let raw: RawNotation = file.parse(diagnostics);
    let row = |raw: &RawRow| NotationRow {
        choset: Text::of(&raw.choset, file),
        thrun: Text::of(&raw.thrun, file),
        meaning: Text::of(&raw.meaning, file),
    };
    raw.row.iter().map(row).collect()
}
