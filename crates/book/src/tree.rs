//! The tree of a text: CommonMark's elements and our own pieces, each with its place.

use pulldown_cmark::Tag;

use crate::diagnostic::Place;
use crate::piece::Piece;

/// A part of a text and what stands in it.
#[derive(Clone, Debug)]
pub struct Node {
    /// Where it stands.
    pub place: Place,
    /// What it is.
    pub kind: Kind,
    /// What stands in it, in order.
    pub children: Vec<Node>,
}

/// What a node is.
#[derive(Clone, Debug)]
pub enum Kind {
    /// A paragraph, a list, emphasis and so on.
    Element(Tag<'static>),
    /// Words.
    Text(String),
    /// Code within a line.
    Code(String),
    /// The end of a line in the source.
    SoftBreak,
    /// The end of a line on the page.
    HardBreak,
    /// A thematic break.
    Rule,
    /// The mention of a footnote, by its label.
    Footnote(String),
    /// What CommonMark does not know.
    Piece(Piece),
}

impl Node {
    /// A node without children.
    pub fn new(kind: Kind, place: Place) -> Self {
        Self { place, kind, children: Vec::new() }
    }

    /// Whether it is a directive called `name`.
    pub fn is_directive(&self, name: &str) -> bool {
        matches!(&self.kind, Kind::Piece(Piece::Directive { name: own, .. }) if own == name)
    }

    /// Whether it is a step of a derivation.
    pub fn is_step(&self) -> bool {
        matches!(self.kind, Kind::Piece(Piece::Step { .. }))
    }
}

/// Shows `see` every node of `nodes`, parents before children, in the order of the text.
pub fn walk<'a>(nodes: &'a [Node], see: &mut impl FnMut(&'a Node)) {
    for node in nodes {
        see(node);
        walk(&node.children, see);
    }
}
