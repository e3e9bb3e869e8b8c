//! End matter of a page: references, footnotes and terms; and the list of its numbers, which is a page of its own.

use std::collections::BTreeMap;

use minijinja::{Value, context};

use crate::diagnostic::Place;
use crate::inline::source_href;
use crate::syntax;
use crate::template::{safe, serde};
use crate::writer::{Heading, Writer};

impl Writer<'_> {
    /// Every work of `references.toml`, by author and year.
    pub(crate) fn reference_list(&mut self) -> String {
        let mut works: Vec<_> = self.site.references.iter().collect();
        works.sort_by_key(|(_, work)| work.label().to_lowercase());
        let works: Vec<_> = works.into_iter().map(|(key, work)| (key.clone(), serde(work))).collect();
        self.fill("references", context! { works }, &Place::new("content/references.toml", 1))
    }

    /// The sections after the text.
    pub fn end_matter(&mut self) -> String {
        let mut html = String::new();
        let glossary = self.glossary();
        if !self.used.listed_references && !self.used.references.is_empty() {
            let list = self.reference_list();
            html += &self.section("references", "References", list);
        }
        let notes = self.footnotes();
        if !notes.is_empty() {
            let list = format!("<ol class=\"footnote-list\">{}</ol>", notes.concat());
            html += &self.section("footnotes", "Notes", list);
        }
        html + &glossary
    }

    /// The index of a footnote, given at its first mention.
    pub(crate) fn footnote(&mut self, file: &str, label: &str) -> usize {
        let key = (file.to_string(), label.to_string());
        self.footnotes.iter().position(|(known, _)| *known == key).unwrap_or_else(|| {
            self.footnotes.push((key, String::new()));
            self.footnotes.len() - 1
        })
    }

    /// The footnotes of the page as list items, in order of mention.
    fn footnotes(&self) -> Vec<String> {
        let item = |(i, (_, html)): (usize, &(_, String))| {
            // The way back stands in the last paragraph.
            let (html, end) = html.trim().strip_suffix("</p>").map_or((html.trim(), ""), |html| (html, "</p>"));
            let values = context! { n => i + 1, html => safe(html.to_string()), end => safe(end.to_string()) };
            self.fill_inline("footnote", values, &Place::new("footnotes", 1))
        };
        self.footnotes.iter().enumerate().map(item).collect()
    }

    fn section(&mut self, id: &str, title: &str, body: String) -> String {
        let (number, html) = (String::new(), title.to_string());
        self.headings.push(Heading { level: 2, id: id.to_string(), number, html });
        self.fill("end", context! { id, title, body => safe(body) }, &Place::new(title, 1))
    }

    fn glossary(&mut self) -> String {
        let mut entries = BTreeMap::new();
        // A gloss may mention further terms.
        while let Some(key) = self.used.terms.iter().find(|key| !entries.contains_key(*key)).cloned() {
            let gloss = self.gloss(&key);
            entries.insert(key, gloss);
        }
        if entries.is_empty() {
            return String::new();
        }
        let entries: String = entries.into_values().collect();
        self.section("glossary", "Terms", format!("<dl class=\"glossary\">{entries}</dl>"))
    }

    fn gloss(&mut self, key: &str) -> String {
        let Some(term) = self.site.glossary.get(key) else { return String::new() };
        let place = &term.gloss.place;
        let gloss = safe(self.inline(&term.gloss.markdown, place));
        let symbol = term.symbol.as_ref().map(|tex| {
            let tex = self.diagnostics.ok(place, syntax::formula(tex)).unwrap_or_default();
            safe(self.symbol(&tex, place))
        });
        self.fill(
            "gloss",
            {
                let kin = term.kin.as_ref().map(|kin| kin.markdown.clone());
                context! { key => key.to_string(), kin, name => term.name.clone(), gloss, symbol }
            },
            place,
        )
    }

    /// The numbers used so far, for a page below this one: what each is, what computes it, and which check pins it.
    /// Empty where there are none.
    pub fn numbers(&mut self) -> String {
        let root = format!("../{}", self.root);
        let used: Vec<_> = self.used.numbers.iter().filter_map(|id| self.site.numbers.get(id).ok()).collect();
        if used.is_empty() {
            return String::new();
        }
        let names: Vec<_> =
            used.iter().map(|number| number.id.split('.').next().unwrap_or_default().to_string()).collect();
        let entries = used.into_iter().map(|number| {
            let place = Place::new(&*number.source, 1);
            let source = self.diagnostics.ok(&place, self.site.sources.function(&number.source));
            context! {
                id => number.id.clone(),
                value => number.value.to_string(),
                about => number.about.trim_end_matches('.').replace('\'', "\u{2019}"),
                source => source.map(|_| &number.source),
                href => source.map(|(path, line)| safe(source_href(&root, path, line))),
                check => number.check,
            }
        });
        // Numbers of one computation have the first word of their names in common.
        let mut groups: Vec<(String, Vec<Value>)> = Vec::new();
        for (name, entry) in names.into_iter().zip(entries) {
            match groups.last_mut() {
                Some((group, entries)) if *group == name => entries.push(entry),
                _ => groups.push((name, vec![entry])),
            }
        }
        self.fill("numbers", context! { groups, root }, &Place::new("numbers", 1))
    }
}
