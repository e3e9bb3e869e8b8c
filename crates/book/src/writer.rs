//! The tree to HTML: CommonMark's elements. What is ours is written by `inline`, `block` and `question`.

use std::collections::HashMap;

use pulldown_cmark::{Alignment, CodeBlockKind, HeadingLevel, Tag};

use crate::diagnostic::{Diagnostics, Place};
use crate::html::{CODE, escape, escape_text};
use crate::label::Labels;
use crate::parse::parse;
use crate::piece::Piece;
use crate::search::Entry;
use crate::site::Site;
use crate::tree::{Kind, Node};

mod held;
mod used;

pub use used::{Apart, Used};

/// A heading of the table of contents.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Heading {
    /// 2 or 3.
    pub level: u8,
    /// Its id.
    pub id: String,
    /// Its number, as in "15.2".
    pub number: String,
    /// Its title as HTML, without links.
    pub html: String,
}

/// Writes the texts of one page.
pub struct Writer<'a> {
    /// What the pages share.
    pub site: &'a Site,
    /// The page's labels.
    pub labels: &'a Labels,
    /// Where complaints go.
    pub diagnostics: &'a Diagnostics,
    /// From the page to the site's root.
    pub root: &'a str,
    /// Whether links are out of place here: in a title, a summary, a label.
    pub plain: bool,
    /// Headings so far.
    pub headings: Vec<Heading>,
    /// Where what the search finds begins among the words.
    pub entries: Vec<Entry>,
    /// Used so far.
    pub used: Used,
    /// Formulas in the letters of the other notations, where any of these differs, with their index on the page; `None`
    /// for a page that has its own letters alone.
    pub readings: Option<HashMap<Vec<String>, usize>>,
    /// The words of the page for the search, without tags.
    pub words: String,
    /// What the page shows of the chapter's other pages.
    pub(crate) apart: Apart<'a>,
    /// The directives that are open, outermost first.
    pub(crate) inside: Vec<String>,
    /// Footnotes in order of mention: file and label, and HTML once the definition has been seen.
    pub(crate) footnotes: Vec<((String, String), String)>,
    /// Whether the latest formula is a box, and not text.
    pub(crate) boxed: bool,
    html: String,
}

impl<'a> Writer<'a> {
    /// A writer for a page `root` below the site's root.
    pub fn new(site: &'a Site, labels: &'a Labels, diagnostics: &'a Diagnostics, root: &'a str) -> Self {
        Self {
            site,
            labels,
            diagnostics,
            root,
            plain: false,
            headings: Vec::new(),
            entries: Vec::new(),
            used: Used::default(),
            readings: Some(HashMap::new()),
            words: String::new(),
            apart: Apart::default(),
            inside: Vec::new(),
            footnotes: Vec::new(),
            boxed: false,
            html: String::new(),
        }
    }

    /// `nodes` as HTML.
    pub fn write(&mut self, nodes: &[Node]) -> String {
        let outer = std::mem::take(&mut self.html);
        self.nodes(nodes);
        std::mem::replace(&mut self.html, outer)
    }

    /// Markdown with paragraphs, from an attribute or a data file, as HTML.
    pub fn blocks(&mut self, markdown: &str, place: &Place) -> String {
        self.write(&parse(markdown, place, self.diagnostics))
    }

    /// Markdown within a line, as HTML.
    pub fn inline(&mut self, markdown: &str, place: &Place) -> String {
        match parse(markdown.trim(), place, self.diagnostics).as_slice() {
            [Node { kind: Kind::Element(Tag::Paragraph), children, .. }] => self.write(children),
            [] => String::new(),
            other => {
                self.diagnostics.report(place, format!("`{}` should be a single line of text", markdown.trim()));
                self.write(other)
            }
        }
    }

    /// As [`Self::inline`], without links: for titles, summaries and labels.
    pub fn title(&mut self, markdown: &str, place: &Place) -> String {
        let plain = std::mem::replace(&mut self.plain, true);
        let html = self.inline(markdown, place);
        self.plain = plain;
        self.words.push(' ');
        html
    }

    /// Adds HTML.
    pub(crate) fn push(&mut self, html: &str) {
        self.html.push_str(html);
    }

    /// Adds words, for the page and for the search.
    pub(crate) fn text(&mut self, text: &str) {
        self.words.push_str(text);
        self.push(&escape_text(text));
    }

    fn nodes(&mut self, nodes: &[Node]) {
        for (i, node) in nodes.iter().enumerate() {
            let before = i.checked_sub(1).and_then(|before| nodes.get(before));
            let follows = |is: fn(&Node) -> bool| nodes.get(i + 1).is_some_and(is);
            match &node.kind {
                Kind::Text(text) => self.beside(text, before, nodes.get(i + 1)),
                Kind::Piece(piece @ Piece::Math(_)) => self.held(piece, node, before, nodes.get(i + 1)),
                Kind::Code(code) => {
                    self.push("<code>");
                    self.text(code);
                    self.push("</code>");
                }
                // A space for every break that a text's lines end in: where lines end says nothing, and cost 0.7 kB.
                Kind::SoftBreak => self.text(" "),
                Kind::HardBreak => {
                    self.push("<br />");
                    self.text("\n");
                }
                Kind::Rule => self.begin("<hr />\n"),
                Kind::Footnote(label) => {
                    let n = self.footnote(&node.place.file, label) + 1;
                    self.push(&format!(
                        "<sup class=\"footnote-ref\"><a id=\"fnref-{n}\" href=\"#fn-{n}\">{n}</a></sup>"
                    ));
                }
                Kind::Element(tag) => self.element(tag, node),
                Kind::Piece(Piece::Step { title, id, number }) => {
                    if !before.is_some_and(Node::is_step) {
                        self.push("<ol class=\"steps\">\n");
                    }
                    self.step(title, id.as_deref().unwrap_or_default(), *number, node);
                    self.push(if follows(Node::is_step) { "</li>\n" } else { "</li></ol>\n" });
                }
                Kind::Piece(piece) => self.piece(piece, node),
            }
        }
    }

    /// Adds the start of a block, on a line of its own.
    fn begin(&mut self, open: &str) {
        if !self.html.is_empty() && !self.html.ends_with('\n') {
            self.html.push('\n');
        }
        self.push(open);
    }

    /// A block between its tags.
    fn block(&mut self, open: &str, children: &[Node], close: &str) {
        self.begin("");
        self.span(open, children, close);
        self.words.push(' ');
    }

    /// Words between their tags.
    fn span(&mut self, open: &str, children: &[Node], close: &str) {
        self.push(open);
        self.nodes(children);
        self.push(close);
    }

    fn element(&mut self, tag: &Tag<'static>, node: &Node) {
        let children = &node.children;
        match tag {
            Tag::Paragraph => self.block("<p>", children, "</p>\n"),
            Tag::Heading { level, id, .. } => self.heading(*level, id.as_deref().unwrap_or_default(), children),
            Tag::BlockQuote(_) => {
                let epigraph = self.headings.is_empty() && self.inside.is_empty();
                let open = if epigraph { "<blockquote class=\"epigraph\">\n" } else { "<blockquote>\n" };
                self.block(open, children, "</blockquote>\n");
            }
            Tag::List(None) => self.block("<ul>\n", children, "</ul>\n"),
            Tag::List(Some(1)) => self.block("<ol>\n", children, "</ol>\n"),
            Tag::List(Some(n)) => self.block(&format!("<ol start=\"{n}\">\n"), children, "</ol>\n"),
            Tag::Item => self.block("<li>", children, "</li>\n"),
            Tag::CodeBlock(kind) => self.code(kind, children),
            Tag::Table(columns) => self.table(columns, children),
            Tag::Emphasis => self.span("<em>", children, "</em>"),
            Tag::Strong => self.span("<strong>", children, "</strong>"),
            Tag::Link { dest_url, .. } => {
                let (open, close) = self.link(dest_url, &node.place);
                self.span(&open, children, close);
            }
            Tag::FootnoteDefinition(label) => {
                let html = self.write(children);
                let n = self.footnote(&node.place.file, label);
                self.footnotes[n].1 = html;
            }
            // Not among the options, or reported when it was read.
            _ => self.nodes(children),
        }
    }

    fn heading(&mut self, level: HeadingLevel, id: &str, children: &[Node]) {
        let title_starts = self.words.len();
        let plain = std::mem::replace(&mut self.plain, true);
        let html = self.write(children).trim().to_string();
        self.plain = plain;
        self.words.push(' ');
        let number = self.labels.get(id, self.root).map(|label| label.number).unwrap_or_default();
        let mark = match number.as_str() {
            "" => String::new(),
            number => format!("<span class=\"section-number\">{number}</span> "),
        };
        let id = escape(id);
        let link = format!("<a class=\"heading-link\" href=\"#{id}\" aria-label=\"Link to this section\">#</a>");
        self.push(&format!("<{level} id=\"{id}\">{mark}{html} {link}</{level}>\n"));
        if level <= HeadingLevel::H3 {
            let words = (title_starts, self.words.len());
            self.entries.push(Entry { id: id.clone(), section: number.clone(), words });
            self.headings.push(Heading { level: level as u8, id, number, html });
        }
    }

    fn code(&mut self, kind: &CodeBlockKind<'_>, children: &[Node]) {
        let language = match kind {
            CodeBlockKind::Fenced(language) => language.as_ref(),
            CodeBlockKind::Indented => "",
        };
        let code: String =
            children.iter().map(|child| if let Kind::Text(text) = &child.kind { text } else { "" }).collect();
        self.words.push_str(&format!("{CODE}{code}{CODE} "));
        let class = match language {
            "" => String::new(),
            language => format!(" class=\"language-{}\"", escape(language)),
        };
        let code = self.site.highlighter.html(&code, language);
        self.push(&format!("<pre class=\"code scroll-box\"><code{class}>{code}</code></pre>\n"));
    }

    fn table(&mut self, columns: &[Alignment], rows: &[Node]) {
        self.push("<div class=\"table-box scroll-box\"><table>");
        // Under an empty corner the cells of the first column name their rows.
        let corner = rows.first().and_then(|row| row.children.first()).is_some_and(|cell| cell.children.is_empty());
        for row in rows {
            let head = matches!(row.kind, Kind::Element(Tag::TableHead));
            self.push(if head { "<thead><tr>" } else { "<tr>" });
            for (i, (cell, column)) in row.children.iter().zip(columns).enumerate() {
                let names_row = corner && i == 0 && !head;
                let heads = !cell.children.is_empty() && (head || names_row);
                let scope = if heads && names_row { " scope=\"row\"" } else { "" };
                let tag = if heads { "th" } else { "td" };
                let style = match column {
                    Alignment::None => "",
                    Alignment::Left => " style=\"text-align: left\"",
                    Alignment::Center => " style=\"text-align: center\"",
                    Alignment::Right => " style=\"text-align: right\"",
                };
                self.span(&format!("<{tag}{scope}{style}>"), &cell.children, &format!("</{tag}>"));
                self.words.push(' ');
            }
            self.push(if head { "</tr></thead><tbody>\n" } else { "</tr>\n" });
        }
        self.push("</tbody></table>\n</div>\n");
    }
}
