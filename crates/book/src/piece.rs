//! What the content says beyond CommonMark: formulas, numbers, references, citations, spans, directives.

use crate::attributes::Attributes;

/// One piece of a text that CommonMark does not know.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// `$…$`, or `$$…$$` within a line
    Math(Vec<Tex>),
    /// `$$…$$` on lines of its own
    DisplayMath(Vec<Tex>),
    /// `{{number id format}}`
    Number(NumberRef),
    /// `{{ref id}}`
    Ref(String),
    /// `[@key, locator; @key]`: each key with its locator
    Cite(Vec<(String, Option<String>)>),
    /// `[words]{…}`
    Span(Attributes),
    /// `:::name{…}`
    Directive {
        /// Its name.
        name: String,
        /// What stands in braces.
        attributes: Attributes,
    },
    /// `::step[title]{#id}`
    Step {
        /// Its title, in Markdown.
        title: String,
        /// Its id, where the text gives one.
        id: Option<String>,
        /// Which step of its derivation it is, counted from one.
        number: usize,
    },
    /// `::after[title]`
    After(String),
    /// `{{listing path#anchor}}`
    Listing {
        /// The source's path.
        path: String,
        /// The anchor, for a part of the source.
        anchor: Option<String>,
    },
    /// `{{output example}}`
    Output(String),
}

/// A computed number and how it is printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberRef {
    /// The number's id.
    pub id: String,
    /// Its format, as in `.3f`.
    pub format: String,
}

/// A part of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tex {
    /// TeX as it stands.
    Source(String),
    /// `{{number id format}}`
    Number(NumberRef),
}
