//! What the elements of a page are called: "Figure 3", "Section 15.2", "Derivation 2, step 4".

use std::collections::BTreeMap;

use pulldown_cmark::{Event, HeadingLevel, Tag};

use crate::diagnostic::{Diagnostics, Place};
use crate::document::Document;
use crate::scan::Piece;

/// The label of one id.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// As a cross-reference prints it.
    pub text: String,
    /// The number alone.
    pub number: String,
    /// Where it leads, from the page.
    pub href: String,
}

/// The labels of a page by id, and where each id stands.
#[derive(Clone, Debug, Default)]
pub struct Labels {
    by_id: BTreeMap<String, (Label, Place)>,
}

/// The checks of the chapter, which have a page of their own.
pub const CHECKS: u8 = 13;

/// Ids the template gives out.
const RESERVED: [&str; 5] = ["main", "search", "footnotes", "glossary", "numbers"];

impl Labels {
    /// Numbers everything in `documents`, the sections under `chapter` (no numbers when `None`).
    pub fn collect(documents: &[Document], chapter: Option<u32>, diagnostics: &Diagnostics) -> Self {
        let mut labels = Self::default();
        let mut counters = Counters { chapter, ..Counters::default() };
        for document in documents {
            for (event, place) in document.events() {
                if let Event::Start(Tag::Heading { level, id, .. }) = event {
                    labels.heading(level, id.as_deref(), &mut counters, &place, diagnostics);
                }
            }
            labels.pieces(document, &mut counters, diagnostics);
        }
        for id in RESERVED {
            if let Some((_, place)) = labels.by_id.get(id) {
                diagnostics.report(place, format!("the id `{id}` belongs to the page itself"));
            }
        }
        labels
    }

    fn heading(
        &mut self,
        level: HeadingLevel,
        id: Option<&str>,
        counters: &mut Counters,
        place: &Place,
        diagnostics: &Diagnostics,
    ) {
        if !matches!(level, HeadingLevel::H2 | HeadingLevel::H3 | HeadingLevel::H4) {
            diagnostics.report(place, "headings of a page are ##, ### or ####");
        }
        let number = counters.section(level);
        match id {
            Some(id) => self.insert(id, "Section", &number, place, diagnostics),
            None => diagnostics.report(place, "this heading has no {#id}"),
        }
    }

    fn pieces(&mut self, document: &Document, counters: &mut Counters, diagnostics: &Diagnostics) {
        let mut derivation: Option<(String, String, usize)> = None;
        let mut depth = 0;
        for (piece, place) in &document.scanned.pieces {
            match piece {
                Piece::Directive { name, attributes } => {
                    depth += 1;
                    let kind = kind(name);
                    let number = kind.map(|kind| counters.next(kind)).unwrap_or_default();
                    let id = attributes.id.clone();
                    if name == "quiz" {
                        if let Some(id) = &id {
                            self.insert(&format!("quiz-{id}"), "Question", &number, place, diagnostics);
                        }
                    } else if let Some(id) = &id {
                        self.insert(id, kind.unwrap_or("here"), &number, place, diagnostics);
                    }
                    if name == "derivation" {
                        derivation = id.map(|id| (id, number, 0));
                        depth = 1;
                    }
                }
                Piece::End => {
                    depth -= 1;
                    if depth == 0 {
                        derivation = None;
                    }
                }
                Piece::Step { id, .. } => {
                    if let Some((of, number, step)) = &mut derivation {
                        *step += 1;
                        let id = id.clone().unwrap_or_else(|| format!("{of}-step-{step}"));
                        let text = format!("Derivation\u{a0}{number}, step\u{a0}{step}");
                        let label = Label { text, number: step.to_string(), href: format!("#{id}") };
                        self.put(id, label, place, diagnostics);
                    }
                }
                Piece::Open(attributes) => {
                    if let Some(id) = &attributes.id {
                        self.insert(id, "here", "", place, diagnostics);
                    }
                }
                _ => {}
            }
        }
    }

    fn insert(&mut self, id: &str, kind: &str, number: &str, place: &Place, diagnostics: &Diagnostics) {
        let text = match (kind, number) {
            ("Section", "") | ("here", _) => "here".to_string(),
            _ => format!("{kind}\u{a0}{number}"),
        };
        let label = Label { text, number: number.to_string(), href: format!("#{id}") };
        self.put(id.to_string(), label, place, diagnostics);
    }

    fn put(&mut self, id: String, label: Label, place: &Place, diagnostics: &Diagnostics) {
        if let Some((_, first)) = self.by_id.get(&id) {
            diagnostics.report(place, format!("the id `{id}` is taken by {first}"));
        } else {
            self.by_id.insert(id, (label, place.clone()));
        }
    }

    /// The label of `id`; `check-7` names a check wherever it is asked for, `root` leading to the site's root.
    ///
    /// # Errors
    /// A message when nothing has this id.
    pub fn get(&self, id: &str, root: &str) -> Result<Label, String> {
        let check = id.strip_prefix("check-").and_then(|n| n.parse().ok()).filter(|n| (1..=CHECKS).contains(n));
        if let Some(n) = check {
            let text = format!("Check\u{a0}{n}");
            return Ok(Label { text, number: n.to_string(), href: format!("{root}check/#{id}") });
        }
        self.by_id.get(id).map(|(label, _)| label.clone()).ok_or_else(|| format!("nothing here has the id `{id}`"))
    }

    /// Whether a link to `#id` leads somewhere on the page.
    pub fn knows(&self, id: &str) -> bool {
        self.by_id.contains_key(id) || RESERVED.contains(&id)
    }
}

/// The word for a numbered directive.
fn kind(directive: &str) -> Option<&'static str> {
    Some(match directive {
        "figure" => "Figure",
        "derivation" => "Derivation",
        "definition" => "Definition",
        "algorithm" => "Algorithm",
        "exercise" => "Exercise",
        "equation" => "Equation",
        "quiz" => "Question",
        _ => return None,
    })
}

/// Numbers given out so far.
#[derive(Default)]
struct Counters {
    chapter: Option<u32>,
    section: usize,
    subsection: usize,
    directives: BTreeMap<&'static str, usize>,
}

impl Counters {
    fn next(&mut self, kind: &'static str) -> String {
        let counter = self.directives.entry(kind).or_default();
        *counter += 1;
        counter.to_string()
    }

    fn section(&mut self, level: HeadingLevel) -> String {
        let Some(chapter) = self.chapter else { return String::new() };
        match level {
            HeadingLevel::H2 => {
                self.section += 1;
                self.subsection = 0;
                format!("{chapter}.{}", self.section)
            }
            HeadingLevel::H3 => {
                self.subsection += 1;
                format!("{chapter}.{}.{}", self.section, self.subsection)
            }
            _ => String::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(texts: &[&str]) -> (Labels, String) {
        let diagnostics = Diagnostics::default();
        let name = |i| Place::new(format!("{i}.md"), 1);
        let documents: Vec<_> =
            texts.iter().enumerate().map(|(i, text)| Document::new(text, &name(i), &diagnostics)).collect();
        let labels = Labels::collect(&documents, Some(15), &diagnostics);
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
        assert!(labels.get("check-14", "../").is_err());
    }

    #[test]
    fn an_id_is_given_once() {
        let (_, errors) = labels(&["## A {#a}\n", "\n\n## B {#a}\n\n## C\n"]);
        assert!(errors.contains("1.md:3: the id `a` is taken by 0.md:1"), "{errors}");
        assert!(errors.contains("1.md:5: this heading has no {#id}"), "{errors}");
    }
}
