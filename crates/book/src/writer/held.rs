//! What a browser must not break a line between: a formula and the punctuation that touches it, a number and its unit.

use super::Writer;
use crate::piece::Piece;
use crate::tree::{Kind, Node};

/// The marks that belong to the formula before them, and to the one behind them.
const CLOSING: [char; 10] = ['.', ',', ';', ':', '!', '?', ')', '’', '”', '-'];
const OPENING: [char; 4] = ['(', '[', '‘', '“'];

fn is_formula(node: &Node) -> bool {
    matches!(node.kind, Kind::Piece(Piece::Math(_)))
}

/// What is left of a text behind a formula when the formula has taken its marks, or its unit.
fn after_formula(text: &str) -> &str {
    match text.strip_prefix(' ').and_then(unit) {
        Some((_, rest)) => rest,
        None => text.trim_start_matches(CLOSING),
    }
}

/// What is left of a text before a formula when the formula has taken its marks.
fn before_formula(text: &str) -> &str {
    text.trim_end_matches(OPENING)
}

/// Units that stand behind a number.
const UNITS: [&str; 17] =
    ["%", "cm", "km", "m", "m²", "m/s", "m²/s", "m²/s²", "m/√s", "mm", "s", "s²", "ms", "min", "rad", "rad²", "rad/√s"];

/// The unit that a text begins with, and the rest.
fn unit(text: &str) -> Option<(&str, &str)> {
    let end = text.find(|c: char| c.is_whitespace() || (c != '-' && CLOSING.contains(&c))).unwrap_or(text.len());
    UNITS.contains(&&text[..end]).then(|| text.split_at(end))
}

/// `text` with no break between a number and its unit.
fn bound(text: &str) -> String {
    let bytes = text.as_bytes();
    let binds = |i: usize| i > 0 && bytes[i - 1].is_ascii_digit() && unit(&text[i + 1..]).is_some();
    text.char_indices().map(|(i, c)| if c == ' ' && binds(i) { '\u{a0}' } else { c }).collect()
}

impl Writer<'_> {
    /// A text between two neighbours: without the marks that a formula beside it has taken, and with no break between a
    /// number and its unit.
    pub(super) fn beside(&mut self, text: &str, before: Option<&Node>, after: Option<&Node>) {
        let text = if before.is_some_and(is_formula) { after_formula(text) } else { text };
        let text = if after.is_some_and(is_formula) { before_formula(text) } else { text };
        let number = before.is_some_and(|it| matches!(it.kind, Kind::Piece(Piece::Number(_))));
        match text.strip_prefix(' ').filter(|rest| number && unit(rest).is_some()) {
            Some(rest) => self.text(&format!("\u{a0}{}", bound(rest))),
            None => self.text(&bound(text)),
        }
    }

    /// A formula and the marks that touch it, between which a browser would break the line.
    pub(super) fn held(&mut self, piece: &Piece, node: &Node, before: Option<&Node>, after: Option<&Node>) {
        let text = |node: Option<&'_ Node>| match node.map(|node| &node.kind) {
            Some(Kind::Text(text)) => text.clone(),
            _ => String::new(),
        };
        let (left, right) = (text(before), text(after));
        let left = &left[before_formula(&left).len()..];
        let right = right[..right.len() - after_formula(&right).len()].replace(' ', "\u{a0}");
        let start = self.html.len();
        self.text(left);
        self.piece(piece, node);
        self.text(&right);
        if self.boxed && !(left.is_empty() && right.is_empty()) {
            self.html.insert_str(start, "<span class=\"held\">");
            self.push("</span>");
        }
    }
}
