//! Inline pieces: formulas, numbers, references, citations, coloured words, terms.

use std::collections::BTreeSet;

use crate::attributes::Attributes;
use crate::diagnostic::Place;
use crate::glossary::KINDS;
use crate::html::{escape, id_attribute};
use crate::number::Format;
use crate::render::Renderer;
use crate::scan::Piece;
use crate::tex::{Formula, Style};

impl Renderer<'_> {
    /// The HTML of an inline piece; `spans` holds the closing tags of spans that are open.
    pub(crate) fn inline_piece(&mut self, spans: &mut Vec<String>, piece: &Piece, place: &Place) -> String {
        match piece {
            Piece::Math(tex) => self.formula(tex, Style::Inline, place),
            Piece::Number { id, format } => self.number(id, format, place),
            Piece::Ref(id) => self.reference(id, place).unwrap_or_default(),
            Piece::Cite(works) => self.citation(works, place),
            Piece::Notation { choset, thrun } => {
                let (choset, thrun) = (self.inline(choset, place), self.inline(thrun, place));
                match choset == thrun {
                    true => choset,
                    false => {
                        format!("<span class=\"in-choset\">{choset}</span><span class=\"in-thrun\">{thrun}</span>")
                    }
                }
            }
            Piece::Open(attributes) => {
                let (open, close) = self.span(attributes, place);
                spans.push(close);
                open
            }
            Piece::Close => spans.pop().unwrap_or_default(),
            _ => String::new(),
        }
    }

    /// A formula in Choset's letters, with the index of its other reading where there is one, its generated digits marked, and a way to them for the keyboard.
    pub(crate) fn formula(&mut self, tex: &str, style: Style, place: &Place) -> String {
        let (tex, ids) = self.fill(tex, place);
        let Some(formula) = self.diagnostics.ok(place, self.site.typesetter.render(&tex, style)) else {
            return String::new();
        };
        let tag = if style == Style::Display { "div" } else { "span" };
        let (html, other) = match formula {
            Formula::Same(html) => (html, String::new()),
            Formula::Differs { choset, thrun } => {
                let n = self.other_reading(thrun);
                (format!("<{tag} class=\"in-choset\">{choset}</{tag}>"), format!(" data-thrun=\"{n}\""))
            }
        };
        if ids.is_empty() {
            return format!("<{tag} class=\"formula\"{other}>{html}</{tag}>");
        }
        let list = escape(&ids.iter().cloned().collect::<Vec<_>>().join(" "));
        let first = ids.first().map(|id| escape(id)).unwrap_or_default();
        let link = match self.plain {
            true => String::new(),
            false => format!(
                "<a class=\"formula-numbers\" href=\"#number-{first}\" data-numbers=\"{list}\" \
                 aria-label=\"Where these numbers come from\"></a>"
            ),
        };
        format!("<{tag} class=\"formula\"{other} data-numbers=\"{list}\">{html}</{tag}>{link}")
    }

    /// The index of a formula in Thrun's letters; equal ones share it.
    fn other_reading(&mut self, thrun: String) -> usize {
        let next = self.thrun.len();
        *self.thrun.entry(thrun).or_insert(next)
    }

    /// TeX with its numbers filled in, and their ids.
    fn fill(&mut self, tex: &str, place: &Place) -> (String, BTreeSet<String>) {
        let mut filled = String::with_capacity(tex.len());
        let mut ids = BTreeSet::new();
        let mut rest = tex;
        while let Some(start) = rest.find("{{number ") {
            let Some(end) = rest[start..].find("}}") else { break };
            let mut words = rest[start + 2..start + end].split_whitespace().skip(1);
            let (id, format) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
            let value = self.site.numbers.get(id).map(|number| number.value);
            let printed = value.and_then(|value| Format::parse(format)?.tex(value));
            // A draft shows a question mark where a number is missing.
            let printed = self.diagnostics.ok(place, printed).unwrap_or_else(|| "?".into());
            filled.push_str(&rest[..start]);
            filled.push_str(&format!("\\htmlData{{number={id}}}{{{printed}}}"));
            if self.site.numbers.get(id).is_ok() {
                ids.insert(id.to_string());
                self.used.numbers.insert(id.to_string());
            }
            rest = &rest[start + end + 2..];
        }
        filled.push_str(rest);
        (filled, ids)
    }

    /// A generated number in the text.
    fn number(&mut self, id: &str, format: &str, place: &Place) -> String {
        let value = self.site.numbers.get(id).map(|number| number.value);
        let printed = value.and_then(|value| Format::parse(format)?.html(value));
        let Some(printed) = self.diagnostics.ok(place, printed) else { return "?".into() };
        self.used.numbers.insert(id.to_string());
        let id = escape(id);
        match self.plain {
            true => format!("<span class=\"number\" data-number=\"{id}\">{printed}</span>"),
            false => format!("<a class=\"number\" href=\"#number-{id}\" data-number=\"{id}\">{printed}</a>"),
        }
    }

    fn reference(&mut self, id: &str, place: &Place) -> Option<String> {
        let label = self.diagnostics.ok(place, self.labels.get(id, self.root))?;
        if label.number.is_empty() {
            self.diagnostics.report(place, format!("`{id}` has no number to refer to; write [words](#{id})"));
        }
        Some(match self.plain {
            true => format!("<span class=\"ref\">{}</span>", escape(&label.text)),
            false => format!("<a class=\"ref\" href=\"{}\">{}</a>", escape(&label.href), escape(&label.text)),
        })
    }

    fn citation(&mut self, works: &[(String, Option<String>)], place: &Place) -> String {
        let mut cited = Vec::new();
        for (key, locator) in works {
            let work = self.site.references.get(key).ok_or_else(|| format!("unknown citation `@{key}`"));
            let Some(work) = self.diagnostics.ok(place, work) else { continue };
            self.used.references.insert(key.clone());
            let locator = locator.as_ref().map(|locator| format!(", {}", escape(locator))).unwrap_or_default();
            cited.push(match self.plain {
                true => format!("{}{locator}", work.label()),
                false => format!("<a class=\"citation\" href=\"#ref-{}\">{}</a>{locator}", escape(key), work.label()),
            });
        }
        format!("<span class=\"cite\">({})</span>", cited.join("; "))
    }

    /// The tags around coloured words or a glossed term.
    fn span(&mut self, attributes: &Attributes, place: &Place) -> (String, String) {
        let id = id_attribute(attributes.id.as_deref());
        let [class] = attributes.classes.as_slice() else {
            if !attributes.classes.is_empty() || attributes.id.is_none() {
                self.diagnostics.report(place, "a span has one class");
            }
            return (format!("<span{id}>"), "</span>".into());
        };
        let key = match class.as_str() {
            "term" => attributes.value("key").unwrap_or_default(),
            kind if KINDS.contains(&kind) => kind,
            other => {
                self.diagnostics
                    .report(place, format!("unknown class `.{other}`; there are .term and .{}", KINDS.join(", .")));
                return (String::new(), String::new());
            }
        };
        let term = self.site.glossary.get(key);
        if term.is_none() && class == "term" {
            self.diagnostics.report(place, format!("unknown glossary key `{key}`"));
        }
        let kin = match class.as_str() {
            "term" => term.and_then(|term| term.kin.as_deref()),
            kind => Some(kind),
        };
        let colour = kin.map(|kin| format!(" term-{kin}")).unwrap_or_default();
        let data = kin.map(|kin| format!(" data-kin=\"{kin}\"")).unwrap_or_default();
        if term.is_none() || self.plain {
            return (format!("<span{id} class=\"word{colour}\"{data}>"), "</span>".into());
        }
        self.used.terms.insert(key.to_string());
        let key = escape(key);
        let open = format!("<a{id} class=\"term{colour}\" href=\"#gloss-{key}\" data-term=\"{key}\"{data}>");
        (open, "</a>".into())
    }
}
