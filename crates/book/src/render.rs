//! A document to HTML: CommonMark's events, with every marker replaced by what it stands for.

use std::collections::{BTreeSet, HashMap};

use pulldown_cmark::{CodeBlockKind, CowStr, Event, HeadingLevel, Tag, TagEnd, html::push_html};

use crate::diagnostic::{Diagnostics, Place};
use crate::directive::Opened;
use crate::document::Document;
use crate::html::escape;
use crate::label::Labels;
use crate::scan::{CLOSE, OPEN, Piece};
use crate::site::Site;

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

/// What a page has used, for its end matter.
#[derive(Debug, Default)]
pub struct Used {
    /// Keys of the glossary.
    pub terms: BTreeSet<String>,
    /// Ids of numbers.
    pub numbers: BTreeSet<String>,
    /// Keys of references.
    pub references: BTreeSet<String>,
    /// Ids of quizzes.
    pub quizzes: BTreeSet<String>,
    /// Whether the page lists its references itself.
    pub listed_references: bool,
}

/// Renders the documents of one page.
pub struct Renderer<'a> {
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
    /// Used so far.
    pub used: Used,
    /// Formulas in Thrun's letters, where they differ, with their index on the page.
    pub thrun: HashMap<String, usize>,
    /// Footnotes in order of reference: label within its file, and HTML once its definition has been seen.
    footnotes: Vec<((String, String), String)>,
}

impl<'a> Renderer<'a> {
    /// A renderer for a page `root` below the site's root.
    pub fn new(site: &'a Site, labels: &'a Labels, diagnostics: &'a Diagnostics, root: &'a str) -> Self {
        let (headings, used, thrun, footnotes) = (Vec::new(), Used::default(), HashMap::new(), Vec::new());
        Self { site, labels, diagnostics, root, plain: false, headings, used, thrun, footnotes }
    }

    /// A document as HTML.
    pub fn document(&mut self, document: &Document) -> String {
        let mut walk = Walk::default();
        for (event, place) in document.events() {
            self.event(&mut walk, document, event, &place);
        }
        for opened in walk.opened.iter().rev() {
            self.diagnostics.report(&opened.place, format!("`:::{}` is not closed", opened.name));
        }
        let mut html = String::new();
        push_html(&mut html, walk.out.into_iter());
        // The empty corner of a table heads nothing.
        html.replace("<th></th>", "<td></td>")
    }

    /// A piece of Markdown with paragraphs, from an attribute or a data file.
    pub fn blocks(&mut self, markdown: &str, place: &Place) -> String {
        let document = Document::new(markdown, place, self.diagnostics);
        self.document(&document)
    }

    /// A piece of Markdown within a line.
    pub fn inline(&mut self, markdown: &str, place: &Place) -> String {
        let html = self.blocks(markdown.trim(), place);
        let html = html.trim();
        match html.strip_prefix("<p>").and_then(|html| html.strip_suffix("</p>")) {
            Some(inner) if !inner.contains("<p>") => inner.to_string(),
            _ if html.is_empty() => String::new(),
            _ => {
                self.diagnostics.report(place, format!("`{}` should be a single line of text", markdown.trim()));
                html.to_string()
            }
        }
    }

    /// As [`Self::inline`], without links: for titles, summaries and labels.
    pub fn title(&mut self, markdown: &str, place: &Place) -> String {
        let plain = std::mem::replace(&mut self.plain, true);
        let html = self.inline(markdown, place);
        self.plain = plain;
        html
    }

    /// The footnotes of the page as list items, in order of reference.
    pub fn footnotes(&self) -> Vec<String> {
        let item = |(i, (_, html)): (usize, &(_, String))| {
            let n = i + 1;
            let back = format!(
                "<a class=\"footnote-back\" href=\"#fnref-{n}\" aria-label=\"Back to the text\">\u{21a9}\u{fe0e}</a>"
            );
            let html = html.trim();
            let html =
                html.strip_suffix("</p>").map_or_else(|| format!("{html} {back}"), |html| format!("{html} {back}</p>"));
            format!("<li id=\"fn-{n}\">{html}</li>")
        };
        self.footnotes.iter().enumerate().map(item).collect()
    }

    fn event<'e>(&mut self, walk: &mut Walk<'e>, document: &'e Document, event: Event<'e>, place: &Place) {
        match event {
            Event::Text(text) => {
                if let Some(code) = &mut walk.code {
                    code.1.push_str(&text);
                } else {
                    self.text(walk, document, &text);
                }
            }
            Event::Html(html) | Event::InlineHtml(html) => match block_marker(&html) {
                Some(index) => {
                    if let Some((piece, place)) = document.scanned.pieces.get(index) {
                        let html = self.block_piece(&mut walk.opened, piece, place);
                        walk.html(html);
                    }
                }
                None => {
                    self.diagnostics.report(place, format!("raw HTML `{}` is not part of the grammar", html.trim()))
                }
            },
            Event::Start(Tag::HtmlBlock) | Event::End(TagEnd::HtmlBlock) => {}
            Event::Start(Tag::Heading { level, id, .. }) => {
                walk.heading = Some((walk.out.len(), level, id.map(String::from).unwrap_or_default()));
                self.plain = true;
            }
            Event::End(TagEnd::Heading(_)) => {
                self.plain = false;
                self.heading(walk);
            }
            Event::Start(Tag::CodeBlock(kind)) => {
                let language = match &kind {
                    CodeBlockKind::Fenced(language) => language.to_string(),
                    CodeBlockKind::Indented => String::new(),
                };
                walk.code = Some((language, String::new()));
            }
            Event::End(TagEnd::CodeBlock) => {
                if let Some((language, code)) = walk.code.take() {
                    let class = if language.is_empty() {
                        String::new()
                    } else {
                        format!(" class=\"language-{}\"", escape(&language))
                    };
                    let code = self.site.highlighter.html(&code, &language);
                    walk.html(format!("<pre class=\"code scroll-box\"><code{class}>{code}</code></pre>\n"));
                }
            }
            Event::Start(Tag::Link { dest_url, .. }) => {
                let (open, close) = self.link(&dest_url, place);
                walk.links.push(close);
                walk.html(open);
            }
            Event::End(TagEnd::Link) => {
                let close = walk.links.pop().unwrap_or_default();
                walk.html(close);
            }
            Event::Start(Tag::Image { .. }) => {
                self.diagnostics.report(place, "images are figures: use :::figure");
            }
            Event::End(TagEnd::Image) => {}
            Event::Start(Tag::BlockQuote(_)) if self.headings.is_empty() && walk.opened.is_empty() => {
                walk.html("<blockquote class=\"epigraph\">\n".into());
            }
            Event::Start(Tag::Table(alignment)) => {
                walk.html("<div class=\"table-box scroll-box\">".into());
                walk.out.push(Event::Start(Tag::Table(alignment)));
            }
            Event::End(TagEnd::Table) => {
                walk.out.push(Event::End(TagEnd::Table));
                walk.html("</div>\n".into());
            }
            Event::FootnoteReference(label) => {
                let n = self.footnote(&document.file, &label) + 1;
                walk.html(format!("<sup class=\"footnote-ref\"><a id=\"fnref-{n}\" href=\"#fn-{n}\">{n}</a></sup>"));
            }
            Event::Start(Tag::FootnoteDefinition(label)) => walk.footnote = Some((walk.out.len(), label.to_string())),
            Event::End(TagEnd::FootnoteDefinition) => {
                if let Some((start, label)) = walk.footnote.take() {
                    let mut html = String::new();
                    push_html(&mut html, walk.out.drain(start..));
                    let n = self.footnote(&document.file, &label);
                    self.footnotes[n].1 = html;
                }
            }
            event => walk.out.push(event),
        }
    }

    /// The index of a footnote, given at its first mention.
    fn footnote(&mut self, file: &str, label: &str) -> usize {
        let key = (file.to_string(), label.to_string());
        self.footnotes.iter().position(|(known, _)| *known == key).unwrap_or_else(|| {
            self.footnotes.push((key, String::new()));
            self.footnotes.len() - 1
        })
    }

    /// Text, its markers replaced.
    fn text(&mut self, walk: &mut Walk<'_>, document: &Document, text: &str) {
        let mut rest = text;
        while let Some(start) = rest.find(OPEN) {
            let Some(end) = rest[start..].find(CLOSE) else { break };
            walk.text(&rest[..start]);
            let index = rest[start + OPEN.len_utf8()..start + end].parse().ok();
            if let Some((piece, place)) = index.and_then(|index: usize| document.scanned.pieces.get(index)) {
                let html = self.inline_piece(&mut walk.spans, piece, place);
                walk.inline_html(html);
                // A browser would break the line between a formula and the full stop behind it.
                let behind = &rest[start + end + CLOSE.len_utf8()..];
                if matches!(piece, Piece::Math(_))
                    && behind.starts_with(['.', ',', ';', ':', '!', '?', ')', '’', '”', '-'])
                {
                    walk.text("\u{2060}");
                }
            }
            rest = &rest[start + end + CLOSE.len_utf8()..];
        }
        walk.text(rest);
    }

    fn heading(&mut self, walk: &mut Walk<'_>) {
        let Some((start, level, id)) = walk.heading.take() else { return };
        let mut title = String::new();
        push_html(&mut title, walk.out.drain(start..));
        let title = title.trim().to_string();
        let number = self.labels.get(&id, self.root).map(|label| label.number).unwrap_or_default();
        let id = escape(&id);
        let mark = match number.as_str() {
            "" => String::new(),
            number => format!("<span class=\"section-number\">{number}</span> "),
        };
        let link = format!("<a class=\"heading-link\" href=\"#{id}\" aria-label=\"Link to this section\">#</a>");
        walk.html(format!("<{level} id=\"{id}\">{mark}{title} {link}</{level}>\n"));
        if level <= HeadingLevel::H3 {
            self.headings.push(Heading { level: level as u8, id, number, html: title });
        } else if self.headings.is_empty() {
            self.headings.push(Heading { level: 2, id, number, html: title });
        }
    }

    /// The tags around a link's text.
    fn link(&mut self, href: &str, place: &Place) -> (String, String) {
        if self.plain {
            return ("<span>".into(), "</span>".into());
        }
        let open = if let Some(id) = href.strip_prefix('#') {
            if !self.labels.knows(id) {
                self.diagnostics.report(place, format!("nothing here has the id `{id}`"));
            }
            format!("<a href=\"#{}\">", escape(id))
        } else if let Some(source) = href.strip_prefix("source:") {
            let (path, anchor) = source.split_once('#').map_or((source, None), |(path, anchor)| (path, Some(anchor)));
            let listing = self.diagnostics.ok(place, self.site.sources.listing(path, anchor));
            format!(
                "<a class=\"source-link\" href=\"{}\">",
                self.source_href(path, listing.map_or(1, |listing| listing.line))
            )
        } else if href.starts_with("https://") || href.starts_with("http://") {
            format!("<a class=\"external\" href=\"{}\">", escape(href))
        } else {
            format!("<a href=\"{}\">", escape(href))
        };
        (open, "</a>".into())
    }

    /// The page of a source, at a line.
    pub fn source_href(&self, path: &str, line: usize) -> String {
        format!("{}source/{}.html#L{line}", self.root, escape(path))
    }
}

/// The state of one walk over a document.
#[derive(Default)]
struct Walk<'e> {
    out: Vec<Event<'e>>,
    opened: Vec<Opened>,
    spans: Vec<String>,
    links: Vec<String>,
    heading: Option<(usize, HeadingLevel, String)>,
    code: Option<(String, String)>,
    footnote: Option<(usize, String)>,
}

impl Walk<'_> {
    fn html(&mut self, html: String) {
        self.out.push(Event::Html(CowStr::from(html)));
    }

    fn inline_html(&mut self, html: String) {
        self.out.push(Event::InlineHtml(CowStr::from(html)));
    }

    fn text(&mut self, text: &str) {
        if !text.is_empty() {
            self.out.push(Event::Text(CowStr::from(text.to_string())));
        }
    }
}

/// The index in a block marker, `<!--12-->`.
fn block_marker(html: &str) -> Option<usize> {
    html.trim().strip_prefix("<!--")?.strip_suffix("-->")?.parse().ok()
}
