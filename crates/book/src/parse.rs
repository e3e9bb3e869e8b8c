//! Markdown to the tree: CommonMark's events, with a node in the place of every mark that the scan left.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::diagnostic::{Diagnostics, Place};
use crate::piece::Piece;
use crate::scan::{self, CLOSE, Mark, OPEN, Scanned};
use crate::tree::{Kind, Node};

/// The tree of `text`, which starts at `start`.
pub fn parse(text: &str, start: &Place, diagnostics: &Diagnostics) -> Vec<Node> {
    let scanned = scan::scan(text, start, diagnostics);
    let options = Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_SMART_PUNCTUATION
        | Options::ENABLE_HEADING_ATTRIBUTES;
    let text = &scanned.text;
    let starts: Vec<usize> = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
    let mut builder = Builder { scanned: &scanned, diagnostics, done: Vec::new(), open: Vec::new() };
    for (event, range) in Parser::new_ext(text, options).into_offset_iter() {
        let line = starts.partition_point(|&start| start <= range.start).saturating_sub(1);
        let line = scanned.lines.get(line).or(scanned.lines.last()).copied().unwrap_or(1);
        builder.event(event, Place::new(start.file.clone(), line));
    }
    while builder.close_unfinished() {}
    builder.done
}

struct Builder<'a> {
    scanned: &'a Scanned,
    diagnostics: &'a Diagnostics,
    done: Vec<Node>,
    /// The nodes whose end has not come, outermost first.
    open: Vec<Node>,
}

impl Builder<'_> {
    fn event(&mut self, event: Event<'_>, place: Place) {
        let leaf = match event {
            Event::Start(Tag::HtmlBlock) | Event::End(TagEnd::HtmlBlock) => return,
            Event::Start(tag) => {
                if matches!(tag, Tag::Image { .. }) {
                    self.diagnostics.report(&place, "images are figures: use :::figure");
                }
                return self.open.push(Node::new(Kind::Element(tag.into_static()), place));
            }
            Event::End(_) => {
                while self.close_unfinished() {}
                return self.close();
            }
            Event::Html(html) | Event::InlineHtml(html) => {
                match scan::line_mark(&html).and_then(|index| self.scanned.marks.get(index)) {
                    Some((mark, place)) => self.mark(mark, place),
                    None => self
                        .diagnostics
                        .report(&place, format!("raw HTML `{}` is not part of the grammar", html.trim())),
                }
                return;
            }
            Event::Text(text) => {
                let in_code = matches!(self.open.last(), Some(Node { kind: Kind::Element(Tag::CodeBlock(_)), .. }));
                if !in_code {
                    return self.text(&text, &place);
                }
                Kind::Text(text.to_string())
            }
            Event::Code(code) => Kind::Code(code.to_string()),
            Event::SoftBreak => Kind::SoftBreak,
            Event::HardBreak => Kind::HardBreak,
            Event::Rule => Kind::Rule,
            Event::FootnoteReference(label) => Kind::Footnote(label.to_string()),
            // Not among the options.
            Event::InlineMath(_) | Event::DisplayMath(_) | Event::TaskListMarker(_) => return,
        };
        self.add(Node::new(leaf, place));
    }

    fn add(&mut self, node: Node) {
        self.open.last_mut().map_or(&mut self.done, |parent| &mut parent.children).push(node);
    }

    /// Ends the innermost open node.
    fn close(&mut self) {
        if let Some(node) = self.open.pop() {
            self.add(node);
        }
    }

    /// Ends the innermost open node if it is a piece, and reports one that should have ended before.
    fn close_unfinished(&mut self) -> bool {
        let Some(Node { kind: Kind::Piece(piece), place, .. }) = self.open.last() else { return false };
        match piece {
            Piece::Directive { name, .. } => self.diagnostics.report(place, format!("`:::{name}` is not closed")),
            Piece::Span(_) => self.diagnostics.report(place, "a span ends in the same words that it begins in"),
            _ => {}
        }
        self.close();
        true
    }

    /// Text, with a node in the place of each mark.
    fn text(&mut self, text: &str, place: &Place) {
        let mut rest = text;
        while let Some((before, after)) = rest.split_once(OPEN) {
            let Some((index, after)) = after.split_once(CLOSE) else { break };
            self.words(before, place);
            if let Some((mark, place)) = index.parse().ok().and_then(|index: usize| self.scanned.marks.get(index)) {
                self.mark(mark, place);
            }
            rest = after;
        }
        self.words(rest, place);
    }

    fn words(&mut self, words: &str, place: &Place) {
        // The two stars may come one by one.
        let before = self.open.last().and_then(|parent| parent.children.last()).map(|node| &node.kind);
        let starred = matches!(before, Some(Kind::Text(before)) if before.ends_with('*') && words.starts_with('*'));
        if starred || words.contains("**") {
            self.diagnostics.report(place, "`**` makes nothing bold here: it stands about a span, `**[…]{#id}**`");
        }
        if !words.is_empty() {
            self.add(Node::new(Kind::Text(words.to_string()), place.clone()));
        }
    }

    fn mark(&mut self, mark: &Mark, place: &Place) {
        let innermost = self.open.last().and_then(|node| match &node.kind {
            Kind::Piece(piece) => Some(piece),
            _ => None,
        });
        match mark {
            Mark::SpanEnd => {
                if let Some(Piece::Span(_)) = innermost {
                    self.close();
                }
            }
            Mark::DirectiveEnd => {
                if let Some(Piece::Step { .. } | Piece::After(_)) = innermost {
                    self.close();
                }
                match self.open.last() {
                    Some(Node { kind: Kind::Piece(Piece::Directive { .. }), .. }) => self.close(),
                    _ => self.diagnostics.report(place, "`:::` closes nothing"),
                }
            }
            Mark::Piece(Piece::Step { title, id, .. }) => self.step(title, id.clone(), place),
            Mark::Piece(piece @ Piece::After(_)) => match innermost {
                Some(Piece::Step { .. }) => {
                    self.close();
                    self.open.push(Node::new(Kind::Piece(piece.clone()), place.clone()));
                }
                _ => self.diagnostics.report(place, "`::after` follows the steps of a derivation"),
            },
            Mark::Piece(piece) => {
                let node = Node::new(Kind::Piece(piece.clone()), place.clone());
                match piece {
                    Piece::Span(_) | Piece::Directive { .. } => self.open.push(node),
                    _ => self.add(node),
                }
            }
        }
    }

    /// Begins a step, and ends the one before.
    fn step(&mut self, title: &str, id: Option<String>, place: &Place) {
        if self.open.last().is_some_and(Node::is_step) {
            self.close();
        }
        let Some(derivation) = self.open.last().filter(|node| node.is_directive("derivation")) else {
            self.diagnostics.report(place, "`::step` stands in a derivation, before `::after`");
            return;
        };
        let number = 1 + derivation.children.iter().filter(|child| child.is_step()).count();
        let own = match &derivation.kind {
            Kind::Piece(Piece::Directive { attributes, .. }) => attributes.id.as_deref(),
            _ => None,
        };
        let id = id.unwrap_or_else(|| format!("{}-step-{number}", own.unwrap_or("derivation")));
        let step = Piece::Step { title: title.to_string(), id: Some(id), number };
        self.open.push(Node::new(Kind::Piece(step), place.clone()));
    }
}
