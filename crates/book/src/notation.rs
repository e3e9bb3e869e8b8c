//! The notations that a page can be read in, and the table that sets them side by side.

use serde::Deserialize;

use crate::config::Text;

/// The key by which macros, pages and styles know a notation, and its name on the page's switch. The first is the
/// page's own; the formulas of the others are fetched when a reader chooses one.
pub const NOTATIONS: [(&str, &str); COUNT] = [("choset", "Choset"), ("thrun", "Thrun"), ("common", "Common")];

/// How many notations there are.
pub const COUNT: usize = 3;

/// A symbol in the letters of each notation, TeX.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Letters {
    choset: String,
    thrun: String,
    /// Choset's where it is not given.
    common: Option<String>,
}

impl Letters {
    /// In the letters of the notation with this place in [`NOTATIONS`].
    pub fn of(&self, notation: usize) -> &str {
        match notation {
            1 => &self.thrun,
            2 => self.common.as_ref().unwrap_or(&self.choset),
            _ => &self.choset,
        }
    }
}

/// A row of the notation table.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// TeX, which the table shows in the letters of each notation.
    pub symbol: Text,
    /// What it means, in Markdown.
    pub meaning: Text,
}

/// `content/notation.toml`.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// The rows, in order.
    #[serde(default)]
    pub row: Vec<Row>,
}
