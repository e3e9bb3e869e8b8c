//! The first pass over a Markdown text: every [`Piece`] is taken out and replaced by a mark, so that the rules of
//! CommonMark (tables, emphasis, smart quotes) do not apply inside it. A piece in a line becomes a private-use
//! character pair around an index, a piece on a line of its own becomes an HTML comment.

use crate::attributes::Attributes;
use crate::diagnostic::{Diagnostics, Place};
use crate::piece::Piece;
use crate::syntax;

/// A text with its pieces taken out.
#[derive(Clone, Debug, Default)]
pub struct Scanned {
    /// What CommonMark reads.
    pub text: String,
    /// What each mark stands for, and its place.
    pub marks: Vec<(Mark, Place)>,
    /// The source line of each line of `text`.
    pub lines: Vec<usize>,
}

/// What a mark stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A piece, or the start of one that holds text.
    Piece(Piece),
    /// The end of a span.
    SpanEnd,
    /// `:::`, the end of a directive.
    DirectiveEnd,
}

/// Opens a mark in a line.
pub const OPEN: char = '\u{e000}';
/// Closes a mark in a line.
pub const CLOSE: char = '\u{e001}';

/// The index in the mark of a line, `<!--12-->`.
pub fn line_mark(html: &str) -> Option<usize> {
    html.trim().strip_prefix("<!--")?.strip_suffix("-->")?.parse().ok()
}

/// Takes the pieces out of `text`, whose first line is `start` in its file.
pub fn scan(text: &str, start: &Place, diagnostics: &Diagnostics) -> Scanned {
    let mut scanner = Scanner { out: Scanned::default(), diagnostics, file: start.file.clone(), line: start.line };
    scanner.document(text);
    scanner.out
}

struct Scanner<'a> {
    out: Scanned,
    diagnostics: &'a Diagnostics,
    file: String,
    line: usize,
}

impl Scanner<'_> {
    fn place(&self) -> Place {
        Place::new(self.file.clone(), self.line)
    }

    /// The index of a new mark at the present line.
    fn mark(&mut self, mark: Mark) -> usize {
        let place = self.place();
        self.out.marks.push((mark, place));
        self.out.marks.len() - 1
    }

    /// Code blocks are left as they are, directive lines become comments, the rest is read as paragraphs.
    fn document(&mut self, text: &str) {
        let lines: Vec<&str> = text.lines().collect();
        let mut i = 0;
        while i < lines.len() {
            let trimmed = lines[i].trim();
            i += if let Some(fence) = fence(trimmed) {
                let end = (i + 1..lines.len()).find(|&j| lines[j].trim().starts_with(fence)).unwrap_or(lines.len() - 1);
                for line in &lines[i..=end] {
                    self.emit(line);
                    self.line += 1;
                }
                end + 1 - i
            } else if trimmed.starts_with("$$") {
                self.display_math(&lines[i..])
            } else if let Some(mark) = own_line(trimmed) {
                if let Some(mark) = self.diagnostics.ok(&self.place(), mark) {
                    self.block(lines[i], mark);
                }
                self.line += 1;
                1
            } else {
                let end = (i + 1..lines.len()).find(|&j| ends_paragraph(lines[j])).unwrap_or(lines.len());
                self.paragraph(&lines[i..end].join("\n"));
                self.line += end - i;
                end - i
            };
        }
    }

    /// A line of `text` as it is.
    fn emit(&mut self, line: &str) {
        self.out.text.push_str(line);
        self.out.text.push('\n');
        self.out.lines.push(self.line);
    }

    /// A comment in the place of `line`, indented as `line` is, so that it stays in its list item.
    fn block(&mut self, line: &str, mark: Mark) {
        let indent = &line[..line.len() - line.trim_start().len()];
        let index = self.mark(mark);
        self.emit(&format!("{indent}<!--{index}-->"));
    }

    /// `$$ … $$` over whole lines; answers how many it took.
    fn display_math(&mut self, lines: &[&str]) -> usize {
        let first = lines[0].trim();
        let one = first.len() > 4 && first.ends_with("$$");
        let last = if one { Some(0) } else { (1..lines.len()).find(|&j| lines[j].trim().ends_with("$$")) };
        let Some(last) = last else {
            self.diagnostics.report(&self.place(), "`$$` is not closed");
            self.line += lines.len();
            return lines.len();
        };
        let joined = lines[..=last].join("\n");
        let tex = syntax::formula(joined.trim().trim_start_matches("$$").trim_end_matches("$$").trim());
        if let Some(tex) = self.diagnostics.ok(&self.place(), tex) {
            self.block(lines[0], Mark::Piece(Piece::DisplayMath(tex)));
        }
        self.line += last + 1;
        last + 1
    }

    /// Text with pieces in its lines. It may span lines; a mark never does.
    fn paragraph(&mut self, text: &str) {
        let first = self.line;
        let mut out = String::with_capacity(text.len());
        self.out.lines.push(first);
        self.inline(text, &mut out);
        self.line = first;
        self.out.text.push_str(&out);
        self.out.text.push('\n');
    }

    fn inline(&mut self, text: &str, out: &mut String) {
        let mut at = 0;
        while let Some(c) = text[at..].chars().next() {
            let rest = &text[at..];
            let (length, piece) = match c {
                '$' => self.math(rest),
                '{' if rest.starts_with("{{") => self.braces(rest),
                '[' => match self.bracket(rest, out) {
                    Some(taken) => taken,
                    None => self.copy(&rest[..1], out),
                },
                _ => self.copy(&rest[..verbatim(rest)], out),
            };
            if let Some(piece) = piece {
                let index = self.mark(Mark::Piece(piece));
                out.push_str(&in_line(index));
            }
            self.line += rest[..length].matches('\n').count();
            at += length;
        }
    }

    /// Passes `text` on, and the number of each line that begins in it.
    fn copy(&mut self, text: &str, out: &mut String) -> (usize, Option<Piece>) {
        out.push_str(text);
        self.out.lines.extend((1..=text.matches('\n').count()).map(|n| self.line + n));
        (text.len(), None)
    }

    fn math(&mut self, rest: &str) -> (usize, Option<Piece>) {
        let fence = if rest.starts_with("$$") { "$$" } else { "$" };
        let body = &rest[fence.len()..];
        let Some((end, _)) = body.match_indices(fence).find(|&(at, _)| !body[..at].ends_with('\\')) else {
            let message = "`$` is not closed in this paragraph; a dollar sign is written `\\$`";
            self.diagnostics.report(&self.place(), message);
            return (fence.len(), None);
        };
        let tex = body[..end].split_whitespace().collect::<Vec<_>>().join(" ");
        let tex = self.diagnostics.ok(&self.place(), syntax::formula(&tex));
        (fence.len() * 2 + end, tex.map(Piece::Math))
    }

    fn braces(&mut self, rest: &str) -> (usize, Option<Piece>) {
        let Some(end) = rest.find("}}") else {
            self.diagnostics.report(&self.place(), "`{{` is not closed in this paragraph");
            return (2, None);
        };
        (end + 2, self.diagnostics.ok(&self.place(), syntax::inline(&rest[2..end])))
    }

    /// `[@key]` or `[words]{…}`; nothing when the bracket belongs to CommonMark.
    fn bracket(&mut self, rest: &str, out: &mut String) -> Option<(usize, Option<Piece>)> {
        let close = syntax::closing_bracket(rest)?;
        let (inside, after) = (&rest[1..close], &rest[close + 1..]);
        if inside.starts_with('@') && !after.starts_with('(') {
            return Some((close + 1, self.diagnostics.ok(&self.place(), syntax::citation(inside))));
        }
        if !(after.starts_with("{.") || after.starts_with("{#")) {
            return None;
        }
        let brace = after.find('}')?;
        let length = close + 1 + brace + 1;
        let Some(attributes) = self.diagnostics.ok(&self.place(), Attributes::parse(&after[1..brace])) else {
            return Some((length, None));
        };
        let line = self.line;
        let open = self.mark(Mark::Piece(Piece::Span(attributes)));
        out.push_str(&in_line(open));
        self.inline(inside, out);
        self.line = line;
        let end = self.mark(Mark::SpanEnd);
        out.push_str(&in_line(end));
        Some((length, None))
    }
}

/// The mark of a piece in a line.
fn in_line(index: usize) -> String {
    format!("{OPEN}{index}{CLOSE}")
}

/// What a whole line stands for; nothing for a line of text.
fn own_line(line: &str) -> Option<Result<Mark, String>> {
    if let Some(rest) = line.strip_prefix(":::") {
        let rest = rest.trim();
        return Some(if rest.is_empty() { Ok(Mark::DirectiveEnd) } else { syntax::directive(rest).map(Mark::Piece) });
    }
    if let Some(rest) = line.strip_prefix("::").filter(|rest| rest.starts_with(char::is_alphabetic)) {
        return Some(syntax::part(rest).map(Mark::Piece));
    }
    let inside = line.strip_prefix("{{")?.strip_suffix("}}")?;
    syntax::listing(inside).map(|piece| Ok(Mark::Piece(piece)))
}

/// The fence a line opens, if it does.
fn fence(line: &str) -> Option<&str> {
    ["```", "~~~"].into_iter().find(|fence| line.starts_with(fence))
}

/// Whether a paragraph cannot go on over this line.
fn ends_paragraph(line: &str) -> bool {
    let line = line.trim();
    line.is_empty()
        || line.starts_with("$$")
        || fence(line).is_some()
        || ["::", "{{listing ", "{{output "].iter().any(|start| line.starts_with(start))
}

/// How many bytes `text` starts with that hold no piece: an escape, a code span, or one character.
fn verbatim(text: &str) -> usize {
    let length = |text: &str| text.chars().next().map_or(0, char::len_utf8);
    match text.strip_prefix('\\') {
        Some(escaped) => 1 + length(escaped),
        None if text.starts_with('`') => {
            let ticks = text.len() - text.trim_start_matches('`').len();
            text[ticks..].find(&text[..ticks]).map_or(ticks, |end| ticks + end + ticks)
        }
        None => length(text),
    }
}

#[cfg(test)]
mod tests;
