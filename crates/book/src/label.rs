//! What the elements of a page are called: "Figure 3", "Section 15.2", "Derivation 2, step 4".

use std::collections::BTreeMap;

use lab::Check;
use pulldown_cmark::{HeadingLevel, Tag};

use crate::diagnostic::{Diagnostics, Place};
use crate::directive;
use crate::piece::Piece;
use crate::tree::{self, Kind, Node};

/// The label of one id.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// As a cross-reference prints it.
    pub text: String,
    /// The number alone.
    pub number: String,
    /// Where it leads, from the page.
    pub href: String,
    /// The page it stands on, by its address from the site's root; empty for the page that is being written.
    page: String,
}

/// The labels of a page by id, and where each id stands.
#[derive(Clone, Debug, Default)]
pub struct Labels {
    by_id: BTreeMap<String, (Label, Place)>,
    /// The numbers of the checks, which have a page of their own.
    checks: Vec<u8>,
}

/// The texts of one page, and its address.
pub type Texts<'a> = (&'a str, &'a [Vec<Node>]);

/// Ids that the page's template uses itself.
const RESERVED: [&str; 5] = ["main", "search", "footnotes", "glossary", "your-answers"];

impl Labels {
    /// Numbers everything in `pages`, the sections of the first under `chapter` (no numbers when `None`). What is not a
    /// section is numbered through all of them. The `checks` are numbered already.
    pub fn collect(pages: &[Texts<'_>], chapter: Option<u32>, checks: &[Check], diagnostics: &Diagnostics) -> Self {
        let mut collector = Collector {
            labels: Self { checks: checks.iter().map(|check| check.id).collect(), ..Self::default() },
            diagnostics,
            chapter,
            section: 0,
            subsection: 0,
            directives: BTreeMap::new(),
            derivation: String::new(),
            page: "",
        };
        for (i, (page, texts)) in pages.iter().enumerate() {
            collector.page = page;
            collector.chapter = chapter.filter(|_| i == 0);
            texts.iter().for_each(|text| tree::walk(text, &mut |node| collector.node(node)));
        }
        let labels = collector.labels;
        for id in RESERVED {
            if let Some((_, place)) = labels.by_id.get(id) {
                diagnostics.report(place, format!("the id `{id}` belongs to the page itself"));
            }
        }
        labels
    }

    /// The label of `id`. On every page `check-7` is a check; `root` leads from the page to the site's root.
    ///
    /// # Errors
    /// A message when nothing has this id.
    pub fn get(&self, id: &str, root: &str) -> Result<Label, String> {
        let check = id.strip_prefix("check-").and_then(|n| n.parse().ok()).filter(|n| self.checks.contains(n));
        if let Some(n) = check {
            let text = format!("Check\u{a0}{n}");
            let page = "check/".to_string();
            return Ok(Label { text, number: n.to_string(), href: format!("{root}{page}#{id}"), page });
        }
        let (label, _) = self.by_id.get(id).ok_or_else(|| format!("nothing here has the id `{id}`"))?;
        let href =
            if label.page.is_empty() { label.href.clone() } else { format!("{root}{}{}", label.page, label.href) };
        Ok(Label { href, ..label.clone() })
    }

    /// The labels as the page at `address` has them, on which the elements `shown` stand once more.
    pub fn on(&self, address: &str, shown: &[String]) -> Self {
        let mut here = self.clone();
        for (id, (label, _)) in &mut here.by_id {
            if label.page == address || shown.contains(id) {
                label.page.clear();
            }
        }
        here
    }

    /// The page on which `id` stands; nothing where it is the page that is being written, or nowhere.
    pub fn elsewhere(&self, id: &str) -> Option<&str> {
        self.by_id.get(id).map(|(label, _)| label.page.as_str()).filter(|page| !page.is_empty())
    }

    /// Whether a link to `#id` leads somewhere on the page.
    pub fn knows(&self, id: &str) -> bool {
        self.by_id.contains_key(id) || RESERVED.contains(&id)
    }
}

/// Labels in the making, and the numbers given out so far.
struct Collector<'a> {
    labels: Labels,
    diagnostics: &'a Diagnostics,
    chapter: Option<u32>,
    section: usize,
    subsection: usize,
    directives: BTreeMap<&'static str, usize>,
    /// The number of the latest derivation.
    derivation: String,
    /// The address of the page that is being read.
    page: &'a str,
}

impl Collector<'_> {
    fn node(&mut self, node: &Node) {
        match &node.kind {
            Kind::Element(Tag::Heading { level, id, .. }) => {
                if !matches!(level, HeadingLevel::H2 | HeadingLevel::H3 | HeadingLevel::H4) {
                    self.diagnostics.report(&node.place, "headings of a page are ##, ### or ####");
                }
                let number = self.next_section(*level);
                match id {
                    Some(id) => self.insert(id, "Section", &number, &node.place),
                    None => self.diagnostics.report(&node.place, "this heading has no {#id}"),
                }
            }
            Kind::Piece(Piece::Directive { name, attributes }) => {
                let word = directive::word(name).unwrap_or_default();
                let counter = self.directives.entry(word).or_default();
                *counter += 1;
                let number = if word.is_empty() { String::new() } else { counter.to_string() };
                if let Some(id) = &attributes.id {
                    let id = if name == "quiz" { format!("quiz-{id}") } else { id.clone() };
                    self.insert(&id, word, &number, &node.place);
                }
                if name == "derivation" {
                    self.derivation = number;
                }
            }
            Kind::Piece(Piece::Step { id: Some(id), number, .. }) => {
                let text = format!("Derivation\u{a0}{}, step\u{a0}{number}", self.derivation);
                self.put(id, text, &number.to_string(), &node.place);
            }
            Kind::Piece(Piece::Span(attributes)) => {
                if let Some(id) = &attributes.id {
                    self.insert(id, "", "", &node.place);
                }
            }
            _ => {}
        }
    }

    fn insert(&mut self, id: &str, word: &str, number: &str, place: &Place) {
        let text = if number.is_empty() { "here".to_string() } else { format!("{word}\u{a0}{number}") };
        self.put(id, text, number, place);
    }

    fn put(&mut self, id: &str, text: String, number: &str, place: &Place) {
        if let Some((_, first)) = self.labels.by_id.get(id) {
            self.diagnostics.report(place, format!("the id `{id}` is taken by {first}"));
        } else {
            let label = Label { text, number: number.to_string(), href: format!("#{id}"), page: self.page.to_string() };
            self.labels.by_id.insert(id.to_string(), (label, place.clone()));
        }
    }

    fn next_section(&mut self, level: HeadingLevel) -> String {
        let Some(chapter) = self.chapter else { return String::new() };
        match level {
            HeadingLevel::H2 => (self.section, self.subsection) = (self.section + 1, 0),
            HeadingLevel::H3 => self.subsection += 1,
            _ => return String::new(),
        }
        let sub = if level == HeadingLevel::H3 { format!(".{}", self.subsection) } else { String::new() };
        format!("{chapter}.{}{sub}", self.section)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::parse;

    fn labels(texts: &[&str]) -> (Labels, String) {
        let diagnostics = Diagnostics::default();
        let name = |i| Place::new(format!("{i}.md"), 1);
        let texts: Vec<_> = texts.iter().enumerate().map(|(i, text)| parse(text, &name(i), &diagnostics)).collect();
        let checks = [1, 7].map(|id| Check::new(id, "A check", vec![1.0], vec![1.0], 0.0));
        let labels = Labels::collect(&[("one/", &texts)], Some(15), &checks, &diagnostics).on("one/", &[]);
        (labels, diagnostics.check().err().map(|error| error.to_string()).unwrap_or_default())
    }

    #[test]
    fn numbers_run_on_over_the_files_of_a_chapter() {
        let (labels, errors) = labels(&[
            "## A {#a}\n\n### B {#b}\n\n:::figure{#f}\n:::\n",
            "## C {#c}\n\n:::figure{#g}\n:::\n\n:::derivation{#d}\n::step[One]\n::step[Two]{#two}\n:::\n",
        ]);
        assert_eq!(errors, "");
        let text = |id| labels.get(id, "../").unwrap().text.replace('\u{a0}', " ");
        assert_eq!(text("b"), "Section 15.1.1");
        assert_eq!(text("c"), "Section 15.2");
        assert_eq!(text("g"), "Figure 2");
        assert_eq!(text("two"), "Derivation 1, step 2");
        assert_eq!(text("d-step-1"), "Derivation 1, step 1");
        assert_eq!(labels.get("check-7", "../").unwrap().href, "../check/#check-7");
        assert!(labels.get("check-2", "../").is_err());
    }

    #[test]
    fn an_id_is_given_once() {
        let (_, errors) = labels(&["## A {#a}\n", "\n\n## B {#a}\n\n## C\n"]);
        assert!(errors.contains("1.md:3: the id `a` is taken by 0.md:1"), "{errors}");
        assert!(errors.contains("1.md:5: this heading has no {#id}"), "{errors}");
    }
}
