//! A formula and the punctuation that touches it. A browser would break the line between them.

use super::Writer;
use crate::piece::Piece;
use crate::tree::{Kind, Node};

/// The marks that belong to the formula before them, and to the one behind them.
const CLOSING: [char; 10] = ['.', ',', ';', ':', '!', '?', ')', '’', '”', '-'];
const OPENING: [char; 4] = ['(', '[', '‘', '“'];

pub(super) fn is_formula(node: &Node) -> bool {
    matches!(node.kind, Kind::Piece(Piece::Math(_)))
}

/// What is left of a text behind a formula when the formula has taken its marks.
pub(super) fn after_formula(text: &str) -> &str {
    text.trim_start_matches(CLOSING)
}

/// What is left of a text before a formula when the formula has taken its marks.
pub(super) fn before_formula(text: &str) -> &str {
    text.trim_end_matches(OPENING)
}

impl Writer<'_> {
    /// A formula and the marks that touch it, between which a browser would break the line.
    pub(super) fn held(&mut self, piece: &Piece, node: &Node, before: Option<&Node>, after: Option<&Node>) {
        let text = |node: Option<&'_ Node>| match node.map(|node| &node.kind) {
            Some(Kind::Text(text)) => text.clone(),
            _ => String::new(),
        };
        let (left, right) = (text(before), text(after));
        let left = &left[before_formula(&left).len()..];
        let right = &right[..right.len() - after_formula(&right).len()];
        let start = self.html.len();
        self.text(left);
        self.piece(piece, node);
        self.text(right);
        if self.boxed && !(left.is_empty() && right.is_empty()) {
            self.html.insert_str(start, "<span class=\"held\">");
            self.push("</span>");
        }
    }
}
