//! Pieces within a line: formulas, numbers, references, citations, coloured words, terms, links.

use std::collections::BTreeSet;

use minijinja::context;

use crate::attributes::Attributes;
use crate::diagnostic::Place;
use crate::glossary::KINDS;
use crate::html::escape;
use crate::number::Format;
use crate::piece::{NumberRef, Piece, Tex};
use crate::template::safe;
use crate::tex::Style;
use crate::tree::Node;
use crate::writer::Writer;

/// Classes of words that have no colour of a meaning: a common mistake, told in a box that corrects it, and where a
/// line of an algorithm comes from.
const SPANS: [&str; 2] = ["claim", "from"];

impl Writer<'_> {
    /// A piece, wherever it stands.
    pub(crate) fn piece(&mut self, piece: &Piece, node: &Node) {
        let place = &node.place;
        let html = match piece {
            Piece::Math(tex) => {
                let (formula, link) = self.formula(tex, Style::Inline, place);
                formula + &link
            }
            Piece::Number(number) => self.number(number, place),
            Piece::Ref(id) => self.reference(id, place).unwrap_or_default(),
            Piece::Cite(works) => self.citation(works, place),
            Piece::Span(attributes) => self.words_of(attributes, node),
            _ => self.own_block(piece, node),
        };
        self.push(&html);
    }

    /// A formula in the page's own letters, with the index of its other readings where there are any and its computed
    /// digits marked; and a link to these numbers for the keyboard, if it has any.
    pub(crate) fn formula(&mut self, tex: &[Tex], style: Style, place: &Place) -> (String, String) {
        let (tex, ids) = self.tex(tex, place);
        let Some(formula) = self.diagnostics.ok(place, self.site.typesetter.render(&tex, style)) else {
            return Default::default();
        };
        let space = if style == Style::Display { " " } else { "" };
        self.words.push_str(&format!("{space}{}{space}", formula.own().letters));
        let tag = if style == Style::Display { "div" } else { "span" };
        let own = formula.own();
        self.boxed = !formula.plain();
        let others = formula.others().zip(self.readings.as_mut()).map(|(others, readings)| {
            let next = readings.len();
            // Equal readings share an index.
            *readings.entry(others).or_insert(next)
        });
        let html = own.html.clone();
        if own.plain && others.is_none() && ids.is_empty() {
            return (html, String::new());
        }
        let numbers = ids.iter().cloned().collect::<Vec<_>>().join(" ");
        let link = match ids.first() {
            Some(first) if !self.plain => {
                self.fill_inline("formula_numbers", context! { first, numbers => &numbers }, place)
            }
            _ => String::new(),
        };
        (self.fill_inline("formula", context! { tag, numbers, other => others, html => safe(html) }, place), link)
    }

    /// TeX with its numbers filled in, and their ids.
    fn tex(&mut self, parts: &[Tex], place: &Place) -> (String, BTreeSet<String>) {
        let (mut tex, mut ids) = (String::new(), BTreeSet::new());
        for part in parts {
            match part {
                Tex::Source(source) => tex.push_str(source),
                Tex::Number(number) => {
                    // A draft shows a question mark where a number is missing.
                    let printed = self.printed(number, Format::tex, place).unwrap_or_else(|| "?".into());
                    tex.push_str(&format!("\\htmlData{{number={}}}{{{printed}}}", number.id));
                    if self.used.numbers.contains(&number.id) {
                        ids.insert(number.id.clone());
                    }
                }
            }
        }
        (tex, ids)
    }

    /// A computed number as `print` prints it; it counts as used.
    fn printed<T>(
        &mut self,
        number: &NumberRef,
        print: fn(Format, f64) -> Result<T, String>,
        place: &Place,
    ) -> Option<T> {
        let value = self.site.numbers.get(&number.id).map(|number| number.value);
        let printed = value.and_then(|value| print(Format::parse(&number.format)?, value));
        let printed = self.diagnostics.ok(place, printed)?;
        self.used.numbers.insert(number.id.clone());
        Some(printed)
    }

    /// A computed number in the text.
    fn number(&mut self, number: &NumberRef, place: &Place) -> String {
        let print = |format: Format, value| Ok((format.html(value)?, format.shade(value)));
        let Some((printed, shade)) = self.printed(number, print, place) else { return "?".into() };
        self.words.push_str(&printed.replace("<sup>", "^").replace("</sup>", ""));
        self.fill_inline(
            "computed",
            context! { id => &number.id, printed => safe(printed), shade, plain => self.plain },
            place,
        )
    }

    fn reference(&mut self, id: &str, place: &Place) -> Option<String> {
        let label = self.diagnostics.ok(place, self.labels.get(id, self.root))?;
        if label.number.is_empty() {
            self.diagnostics.report(place, format!("`{id}` has no number to refer to; write [words](#{id})"));
        }
        self.words.push_str(&label.text);
        Some(self.fill_inline("ref", context! { text => label.text, href => label.href, plain => self.plain }, place))
    }

    fn citation(&mut self, works: &[(String, Option<String>)], place: &Place) -> String {
        let (mut cited, mut words) = (Vec::new(), Vec::new());
        for (key, locator) in works {
            let work = self.site.references.get(key).ok_or_else(|| format!("unknown citation `@{key}`"));
            let Some(work) = self.diagnostics.ok(place, work) else { continue };
            self.used.references.insert(key.clone());
            words.push([work.label()].into_iter().chain(locator.clone()).collect::<Vec<_>>().join(", "));
            cited.push((key.clone(), work.label(), locator.clone()));
        }
        self.words.push_str(&format!("({})", words.join("; ")));
        self.fill_inline("cite", context! { works => cited, plain => self.plain }, place)
    }

    /// Coloured words, a glossed term, words with an id or a part to play.
    fn words_of(&mut self, attributes: &Attributes, node: &Node) -> String {
        let place = &node.place;
        let body = self.write(&node.children);
        let id = attributes.id.as_deref();
        let [class] = attributes.classes.as_slice() else {
            if !attributes.classes.is_empty() || id.is_none() {
                self.diagnostics.report(place, "a span has one class");
            }
            return self.fill_inline("span", context! { id, body => safe(body) }, place);
        };
        if SPANS.contains(&class.as_str()) {
            return self.fill_inline("span", context! { id, class, body => safe(body) }, place);
        }
        if class == "grow" {
            let [figure, stage, shows] =
                ["figure", "stage", "shows"].map(|key| attributes.value(key).unwrap_or_default());
            if !matches!(stage, "2" | "3") && (!stage.is_empty() || shows.is_empty()) {
                self.diagnostics.report(place, format!("a figure grows to stage 2 or 3, not to `{stage}`"));
            }
            let href = self.diagnostics.ok(place, self.labels.get(figure, self.root)).map(|label| label.href);
            return self.fill_inline("grow", context! { href, stage, shows, body => safe(body) }, place);
        }
        let key = match class.as_str() {
            "term" => attributes.value("key").unwrap_or_default(),
            kind if KINDS.contains(&kind) => kind,
            other => {
                let known = KINDS.join(", .");
                let spans = SPANS.join(", .");
                self.diagnostics
                    .report(place, format!("unknown class `.{other}`; there are .term, .{spans} and .{known}"));
                return body;
            }
        };
        let term = self.site.glossary.get(key);
        if term.is_none() && class == "term" {
            self.diagnostics.report(place, format!("unknown glossary key `{key}`"));
        }
        let of_term = term.and_then(|term| term.kin.as_ref()).map(|kin| kin.markdown.as_str());
        let kin = if class == "term" { of_term } else { Some(key) };
        let link = term.is_some() && !self.plain;
        if link {
            self.used.terms.insert(key.to_string());
        }
        self.fill_inline("word", context! { id, key, kin, link, body => safe(body) }, place)
    }

    /// The tags around a link's words.
    pub(crate) fn link(&mut self, href: &str, place: &Place) -> (String, &'static str) {
        if self.plain {
            return ("<span>".into(), "</span>");
        }
        let open = if let Some(id) = href.strip_prefix('#') {
            if !self.labels.knows(id) {
                self.diagnostics.report(place, format!("nothing here has the id `{id}`"));
            }
            let page = self.labels.elsewhere(id).map(|page| format!("{}{page}", self.root)).unwrap_or_default();
            format!("<a href=\"{page}#{}\">", escape(id))
        } else if let Some(source) = href.strip_prefix("source:") {
            let (path, anchor) = source.split_once('#').map_or((source, None), |(path, anchor)| (path, Some(anchor)));
            let listing = self.diagnostics.ok(place, self.site.sources.listing(path, anchor));
            let href = source_href(self.root, path, listing.map_or(1, |listing| listing.line));
            format!("<a class=\"source-link\" href=\"{href}\">")
        } else if href.starts_with("https://") || href.starts_with("http://") {
            format!("<a class=\"external\" href=\"{}\">", escape(href))
        } else {
            format!("<a href=\"{}\">", escape(href))
        };
        (open, "</a>")
    }
}

/// The page of a source, at a line, from a page `root` below the site's root.
pub(crate) fn source_href(root: &str, path: &str, line: usize) -> String {
    format!("{root}source/{}.html#L{line}", escape(path))
}
