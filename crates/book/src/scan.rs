//! First pass over a Markdown text: everything CommonMark does not know is taken out and replaced by a marker, so that
//! CommonMark's own rules (tables, emphasis, lists) cannot tear it apart. Inline pieces become a private-use character
//! pair around an index, block pieces a comment line.

use crate::attributes::Attributes;
use crate::diagnostic::{Diagnostics, Place};
use crate::syntax::{citation, closing_bracket, directive, inline_directive, inner_directive};

/// What a marker stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// `$…$`, or `$$…$$` within a line
    Math(String),
    /// `$$…$$` on lines of its own
    DisplayMath(String),
    /// `{{number id format}}`
    Number { id: String, format: String },
    /// `{{ref id}}`
    Ref(String),
    /// `[@key, locator; @key]`
    Cite(Vec<(String, Option<String>)>),
    /// `{{notation choset|thrun}}`
    Notation { choset: String, thrun: String },
    /// the start of `[words]{…}`
    Open(Attributes),
    /// its end
    Close,
    /// `:::name{…}`
    Directive { name: String, attributes: Attributes },
    /// `:::`
    End,
    /// `::step[title]{#id}`
    Step { title: String, id: Option<String> },
    /// `::after[title]`
    After(String),
    /// `{{listing path#anchor}}`
    Listing { path: String, anchor: Option<String> },
    /// `{{output example}}`
    Output(String),
}

/// A text with its pieces taken out.
#[derive(Clone, Debug, Default)]
pub struct Scanned {
    /// What CommonMark reads.
    pub text: String,
    /// The piece and line behind each marker.
    pub pieces: Vec<(Piece, Place)>,
    /// The source line of each line of `text`.
    pub lines: Vec<usize>,
}

/// Opens an inline marker.
pub const OPEN: char = '\u{e000}';
/// Closes an inline marker.
pub const CLOSE: char = '\u{e001}';

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

    fn piece(&mut self, piece: Piece, place: Place) -> usize {
        self.out.pieces.push((piece, place));
        self.out.pieces.len() - 1
    }

    /// Blocks: fences are passed on untouched, directive lines become comments, the rest is read as paragraphs.
    fn document(&mut self, text: &str) {
        let lines: Vec<&str> = text.lines().collect();
        let mut i = 0;
        while i < lines.len() {
            let line = lines[i];
            let trimmed = line.trim();
            let taken = if let Some(fence) = fence(trimmed) {
                let end = (i + 1..lines.len()).find(|&j| lines[j].trim().starts_with(fence)).unwrap_or(lines.len() - 1);
                for line in &lines[i..=end] {
                    self.emit(line);
                    self.line += 1;
                }
                end + 1 - i
            } else if trimmed.starts_with("$$") {
                self.display_math(&lines[i..])
            } else if let Some(piece) = self.block_piece(trimmed) {
                if let Some(piece) = piece {
                    self.block(line, piece);
                }
                self.line += 1;
                1
            } else {
                let end = (i + 1..lines.len()).find(|&j| ends_paragraph(lines[j])).unwrap_or(lines.len());
                self.paragraph(&lines[i..end].join("\n"));
                self.line += end - i;
                end - i
            };
            i += taken;
        }
    }

    /// A line of `text` as it is.
    fn emit(&mut self, line: &str) {
        self.out.text.push_str(line);
        self.out.text.push('\n');
        self.out.lines.push(self.line);
    }

    /// A comment line for a block piece, indented as `line` is so that it stays in its list item.
    fn block(&mut self, line: &str, piece: Piece) {
        let indent = &line[..line.len() - line.trim_start().len()];
        let place = self.place();
        let index = self.piece(piece, place);
        self.emit(&format!("{indent}<!--{index}-->"));
    }

    /// `$$ … $$` over whole lines; answers how many it took.
    fn display_math(&mut self, lines: &[&str]) -> usize {
        let first = lines[0].trim();
        let one = first.len() > 4 && first.ends_with("$$");
        let closing = |&j: &usize| lines[j].trim().ends_with("$$");
        let last = if one { Some(0) } else { (1..lines.len()).find(closing) };
        let Some(last) = last else {
            self.diagnostics.report(&self.place(), "`$$` is not closed");
            self.line += lines.len();
            return lines.len();
        };
        let joined = lines[..=last].join("\n");
        let tex = joined.trim().trim_start_matches("$$").trim_end_matches("$$").trim().to_string();
        self.block(lines[0], Piece::DisplayMath(tex));
        self.line += last + 1;
        last + 1
    }

    /// The piece a whole line makes: `None` for a line of text, `Some(None)` for one that was meant as a directive.
    fn block_piece(&mut self, line: &str) -> Option<Option<Piece>> {
        let read = if let Some(rest) = line.strip_prefix(":::") {
            directive(rest)
        } else if let Some(rest) = line.strip_prefix("::").filter(|rest| rest.starts_with(char::is_alphabetic)) {
            inner_directive(rest)
        } else if let Some(rest) = line.strip_prefix("{{").and_then(|rest| rest.strip_suffix("}}")) {
            let (name, argument) = rest.trim().split_once(' ').unwrap_or((rest.trim(), ""));
            let argument = argument.trim().to_string();
            match name {
                "listing" => Ok(match argument.split_once('#') {
                    Some((path, anchor)) => Piece::Listing { path: path.to_string(), anchor: Some(anchor.to_string()) },
                    None => Piece::Listing { path: argument, anchor: None },
                }),
                "output" => Ok(Piece::Output(argument)),
                _ => return None,
            }
        } else {
            return None;
        };
        Some(self.diagnostics.ok(&self.place(), read))
    }

    /// Text with inline pieces. It may span lines; a marker never does.
    fn paragraph(&mut self, text: &str) {
        let first = self.line;
        let mut out = String::with_capacity(text.len());
        let mut lines = vec![first];
        self.inline(text, &mut out, &mut lines, first);
        self.line = first;
        self.out.text.push_str(&out);
        self.out.text.push('\n');
        self.out.lines.extend(lines);
    }

    fn inline(&mut self, text: &str, out: &mut String, lines: &mut Vec<usize>, first: usize) {
        let mut at = 0;
        self.line = first;
        while let Some(c) = text[at..].chars().next() {
            let rest = &text[at..];
            let (length, piece) = match c {
                '\\' | '`' => {
                    let length = verbatim(rest);
                    out.push_str(&rest[..length]);
                    lines.extend((1..=rest[..length].matches('\n').count()).map(|n| self.line + n));
                    (length, None)
                }
                '$' => self.math(rest),
                '{' if rest.starts_with("{{") => self.braces(rest),
                '[' => self.bracket(rest, out, lines),
                _ => {
                    out.push(c);
                    if c == '\n' {
                        lines.push(self.line + 1);
                    }
                    (c.len_utf8(), None)
                }
            };
            if let Some(piece) = piece {
                let place = self.place();
                let index = self.piece(piece, place);
                out.push_str(&marker(index));
            }
            self.line += rest[..length].matches('\n').count();
            at += length;
        }
    }

    fn math(&mut self, rest: &str) -> (usize, Option<Piece>) {
        let fence = if rest.starts_with("$$") { "$$" } else { "$" };
        let body = &rest[fence.len()..];
        let mut end = 0;
        loop {
            let Some(found) = body[end..].find(fence) else {
                self.diagnostics
                    .report(&self.place(), "`$` is not closed in this paragraph; a dollar sign is written `\\$`");
                return (fence.len(), None);
            };
            end += found;
            if !body[..end].ends_with('\\') {
                break;
            }
            end += fence.len();
        }
        let tex = body[..end].split_whitespace().collect::<Vec<_>>().join(" ");
        (fence.len() * 2 + end, Some(Piece::Math(tex)))
    }

    fn braces(&mut self, rest: &str) -> (usize, Option<Piece>) {
        let Some(end) = rest.find("}}") else {
            self.diagnostics.report(&self.place(), "`{{` is not closed in this paragraph");
            return (2, None);
        };
        let read = inline_directive(rest[2..end].trim());
        (end + 2, self.diagnostics.ok(&self.place(), read))
    }

    /// `[@key]`, `[words]{…}`, or a bracket that belongs to CommonMark.
    fn bracket(&mut self, rest: &str, out: &mut String, lines: &mut Vec<usize>) -> (usize, Option<Piece>) {
        let plain = |out: &mut String| {
            out.push('[');
            (1, None)
        };
        let Some(close) = closing_bracket(rest) else { return plain(out) };
        let inside = &rest[1..close];
        let after = &rest[close + 1..];
        if inside.starts_with('@') && !after.starts_with('(') {
            let read = citation(inside);
            return (close + 1, self.diagnostics.ok(&self.place(), read));
        }
        if !(after.starts_with("{.") || after.starts_with("{#")) {
            return plain(out);
        }
        let Some(brace) = after.find('}') else { return plain(out) };
        let Some(attributes) = self.diagnostics.ok(&self.place(), Attributes::parse(&after[1..brace])) else {
            return (close + 1 + brace + 1, None);
        };
        let place = self.place();
        let open = self.piece(Piece::Open(attributes), place.clone());
        out.push_str(&marker(open));
        self.inline(inside, out, lines, place.line);
        self.line = place.line;
        let end = self.piece(Piece::Close, place);
        out.push_str(&marker(end));
        (close + 1 + brace + 1, None)
    }
}

/// The marker of inline piece `index`.
pub fn marker(index: usize) -> String {
    format!("{OPEN}{index}{CLOSE}")
}

/// The fence a line opens, if it does.
fn fence(line: &str) -> Option<&str> {
    ["```", "~~~"].into_iter().find(|fence| line.starts_with(fence))
}

/// Whether a paragraph cannot go on over this line.
fn ends_paragraph(line: &str) -> bool {
    let line = line.trim();
    line.is_empty()
        || line.starts_with("::")
        || line.starts_with("$$")
        || fence(line).is_some()
        || line.starts_with("{{listing ")
        || line.starts_with("{{output ")
}

/// The length of the escape or code span that `text` starts with.
fn verbatim(text: &str) -> usize {
    if let Some(escaped) = text.strip_prefix('\\') {
        return 1 + escaped.chars().next().map_or(0, char::len_utf8);
    }
    let ticks = text.len() - text.trim_start_matches('`').len();
    text[ticks..].find(&text[..ticks]).map_or(ticks, |end| ticks + end + ticks)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scanned(text: &str) -> (Scanned, Vec<String>) {
        let diagnostics = Diagnostics::default();
        let scanned = scan(text, &Place::new("a.md", 1), &diagnostics);
        let errors = match diagnostics.check() {
            Err(crate::BuildError::Content(list)) => list.iter().map(ToString::to_string).collect(),
            _ => Vec::new(),
        };
        (scanned, errors)
    }

    fn pieces(text: &str) -> Vec<Piece> {
        let (scanned, errors) = scanned(text);
        assert_eq!(errors, Vec::<String>::new());
        scanned.pieces.into_iter().map(|(piece, _)| piece).collect()
    }

    #[test]
    fn a_formula_keeps_its_bars_and_its_numbers() {
        let (scanned, _) = scanned("| a | $x(k \\mid k) = |y|$ |\n");
        assert_eq!(scanned.text, "| a | \u{e000}0\u{e001} |\n");
        assert_eq!(pieces("$S = {{number step1.S .1f}}$"), [Piece::Math("S = {{number step1.S .1f}}".into())]);
    }

    #[test]
    fn code_is_left_alone_and_a_dollar_can_be_escaped() {
        assert_eq!(pieces("`{{number x .1f}} $x$` costs \\$5\n\n```\n:::note\n$x$\n```\n"), []);
    }

    #[test]
    fn lines_are_counted_through_display_math_and_spans() {
        let (scanned, _) = scanned("one\n$$\na\n$$\n[two\nlines]{.term key=\"x\"} $z$\n");
        let lines: Vec<_> = scanned.pieces.iter().map(|(_, place)| place.line).collect();
        assert_eq!(lines, [2, 5, 5, 6]);
        assert_eq!(scanned.lines, [1, 2, 5, 6]);
    }

    #[test]
    fn directives_name_their_errors() {
        let (_, errors) = scanned("ok\n\n{{nothing x}} and [@a] and $open\n\n::leap[x]\n");
        assert_eq!(errors.len(), 3, "{errors:?}");
        assert!(errors[0].starts_with("a.md:3: "), "{errors:?}");
        assert!(errors[2].starts_with("a.md:5: unknown directive `::leap`"), "{errors:?}");
    }

    #[test]
    fn citations_and_links_are_told_apart() {
        assert_eq!(pieces("[text](#id) [^1]"), []);
        assert_eq!(
            pieces("[@a, §8.2; @b]"),
            [Piece::Cite(vec![("a".into(), Some("§8.2".into())), ("b".into(), None)])]
        );
    }
}
