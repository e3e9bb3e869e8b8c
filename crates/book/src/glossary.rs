//! `content/glossary.toml` and `content/notation.toml`: the terms, and the two notations side by side.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

use crate::config::{DataFile, Text};
use crate::diagnostic::Diagnostics;

/// The four meanings that have a colour.
pub const KINDS: [&str; 4] = ["prediction", "posterior", "measurement", "truth"];

/// A glossed term, its texts as the file has them or, with their places, as the book uses them.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Term<T = Text> {
    /// What the text calls it by.
    pub key: T,
    /// The term as the glossary heads it.
    pub name: String,
    /// What it is, in Markdown.
    pub gloss: T,
    /// Its symbol in Choset's letters, TeX; may be empty.
    #[serde(default)]
    pub choset: String,
    /// Its symbol in Thrun's letters, TeX; may be empty.
    #[serde(default)]
    pub thrun: String,
    /// The meaning whose colour it has.
    pub kin: Option<T>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Terms {
    #[serde(default)]
    term: Vec<Term<Spanned<String>>>,
}

/// The glossary, by key.
pub fn glossary(file: &DataFile, diagnostics: &Diagnostics) -> BTreeMap<String, Term> {
    let mut terms = BTreeMap::new();
    for Term { key, name, gloss, choset, thrun, kin } in file.parse::<Terms>(diagnostics).term {
        let (key, gloss) = (Text::of(&key, file), Text::of(&gloss, file));
        let kin = kin.map(|kin| Text::of(&kin, file));
        let Text { markdown: called, place } = key.clone();
        if let Some(kin) = kin.as_ref().filter(|kin| !KINDS.contains(&kin.markdown.as_str())) {
            diagnostics.report(&kin.place, format!("kin of `{called}` is none of {}", KINDS.join(", ")));
        }
        let term = Term { key, name, gloss, choset, thrun, kin };
        if terms.insert(called.clone(), term).is_some() {
            diagnostics.report(&place, format!("two terms are called `{called}`"));
        }
    }
    terms
}

/// A row of the notation table.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NotationRow<T = Text> {
    /// TeX in Choset's letters.
    pub choset: T,
    /// TeX in Thrun's letters.
    pub thrun: T,
    /// What both mean, in Markdown.
    pub meaning: T,
}

#[derive(Default, Deserialize)]
struct Notation {
    #[serde(default)]
    row: Vec<NotationRow<Spanned<String>>>,
}

/// The rows of the notation table.
pub fn notation(file: &DataFile, diagnostics: &Diagnostics) -> Vec<NotationRow> {
    let text = |text: &Spanned<String>| Text::of(text, file);
    let rows = file.parse::<Notation>(diagnostics).row;
    let row = |row: &NotationRow<_>| NotationRow {
        choset: text(&row.choset),
        thrun: text(&row.thrun),
        meaning: text(&row.meaning),
    };
    rows.iter().map(row).collect()
}
