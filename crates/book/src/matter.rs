//! End matter of a page: references, footnotes, terms, and where the numbers come from.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::diagnostic::Place;
use crate::html::escape;
use crate::render::Renderer;
use crate::tex::Style;

impl Renderer<'_> {
    /// Every work of `references.toml`, by author and year.
    pub(crate) fn reference_list(&self) -> String {
        let mut works: Vec<_> = self.site.references.iter().collect();
        works.sort_by_key(|(_, work)| work.label().to_lowercase());
        let items =
            works.into_iter().map(|(key, work)| format!("<li id=\"ref-{}\">{}</li>\n", escape(key), work.entry()));
        format!("<ul class=\"reference-list\">\n{}</ul>\n", items.collect::<String>())
    }

    /// The sections after the text.
    pub fn end_matter(&mut self) -> String {
        let mut html = String::new();
        // The glosses may use numbers and terms themselves, so they come before the numbers.
        let glossary = self.glossary();
        if !self.used.listed_references && !self.used.references.is_empty() {
            html += &section("references", "References", &self.reference_list());
        }
        let notes = self.footnotes();
        if !notes.is_empty() {
            html += &section("footnotes", "Notes", &format!("<ol class=\"footnote-list\">{}</ol>", notes.concat()));
        }
        html + &glossary + &self.number_list()
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
        section("glossary", "Terms", &format!("<dl class=\"glossary\">{entries}</dl>"))
    }

    fn gloss(&mut self, key: &str) -> String {
        let Some(term) = self.site.glossary.get(key) else { return String::new() };
        let gloss = self.inline(&term.gloss.markdown, &term.gloss.place);
        let mut symbols = Vec::new();
        for (name, tex) in [("Choset", &term.choset), ("Thrun", &term.thrun)] {
            if !tex.is_empty() {
                symbols.push(format!("{name} {}", self.formula(tex, Style::Inline, &term.gloss.place)));
            }
        }
        let symbols = match symbols.is_empty() {
            true => String::new(),
            false => format!(" <span class=\"gloss-notation\">{}</span>", symbols.join(" · ")),
        };
        let kin = term.kin.as_ref().map(|kin| format!(" data-kin=\"{kin}\"")).unwrap_or_default();
        format!(
            "<div class=\"gloss\" id=\"gloss-{}\"{kin}><dt>{}</dt><dd>{gloss}{symbols}</dd></div>\n",
            escape(key),
            escape(&term.name)
        )
    }

    fn number_list(&mut self) -> String {
        let mut entries = String::new();
        for id in &self.used.numbers {
            let Ok(number) = self.site.numbers.get(id) else { continue };
            let place = Place::new(number.source.clone(), 1);
            let source = self.diagnostics.ok(&place, self.site.sources.function(&number.source));
            let source = source.map(|(path, line)| {
                format!(
                    " <a class=\"number-source\" href=\"{}\"><code>{}</code></a>",
                    self.source_href(path, line),
                    escape(&number.source)
                )
            });
            let check = number.check.map(|check| {
                format!(" <a class=\"number-check\" href=\"{}check/#check-{check}\">Check\u{a0}{check}</a>", self.root)
            });
            let _ = writeln!(
                entries,
                "<div class=\"number-entry\" id=\"number-{0}\"><dt><code>{0}</code> <span class=\"number-value\">{1}</span></dt><dd>{2}.{3}{4}</dd></div>",
                escape(id),
                number.value,
                escape(number.about.trim_end_matches('.')),
                source.unwrap_or_default(),
                check.unwrap_or_default()
            );
        }
        if entries.is_empty() {
            return String::new();
        }
        let count = self.used.numbers.len();
        let summary = format!("The {count} computed {} of this page", if count == 1 { "number" } else { "numbers" });
        let list = format!("<details class=\"numbers\"><summary>{summary}</summary><dl>\n{entries}</dl></details>");
        section("numbers", "Where the numbers come from", &list)
    }
}

fn section(id: &str, title: &str, body: &str) -> String {
    format!(
        "<section class=\"end-matter end-{id}\" data-part=\"{id}\" id=\"{id}\"><h2>{title}</h2>\n{body}</section>\n"
    )
}
