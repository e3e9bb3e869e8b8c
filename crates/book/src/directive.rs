//! Block pieces: what opens, what closes, and what each directive may say.

use crate::attributes::Attributes;
use crate::diagnostic::Place;
use crate::html::{escape, id_attribute};
use crate::render::Renderer;
use crate::scan::Piece;
use crate::tex::Style;

/// A directive that is open.
#[derive(Clone, Debug)]
pub(crate) struct Opened {
    pub(crate) name: String,
    pub(crate) place: Place,
    id: Option<String>,
    close: String,
    /// Steps given so far, and whether their list is open, or the part after it.
    steps: usize,
    part: Part,
}

/// Where in a derivation we are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Body,
    Steps,
    After,
}

/// Each directive with the attributes it must and may have.
const GRAMMAR: [(&str, &[&str], &[&str]); 14] = [
    ("derivation", &["id", "title"], &[]),
    ("definition", &["term"], &["id"]),
    ("note", &["kind"], &["id", "title"]),
    ("margin", &[], &["id"]),
    ("figure", &["id", "widget"], &["title", "start"]),
    ("algorithm", &["id", "name"], &["in", "out", "cost"]),
    ("exercise", &["id", "title", "kind", "difficulty"], &[]),
    ("hint", &[], &["id", "title"]),
    ("answer", &[], &["id", "title"]),
    ("starter", &[], &["id", "title"]),
    ("notation", &[], &["id"]),
    ("quiz", &["id"], &[]),
    ("equation", &["id"], &["eq"]),
    ("references", &[], &[]),
];

impl Renderer<'_> {
    /// The HTML of a block piece; `opened` holds the directives that are open.
    pub(crate) fn block_piece(&mut self, opened: &mut Vec<Opened>, piece: &Piece, place: &Place) -> String {
        match piece {
            Piece::Directive { name, attributes } => self.open(opened, name, attributes, place),
            Piece::End => match opened.pop() {
                Some(open) => format!("{}{}\n", end_part(&open), open.close),
                None => {
                    self.diagnostics.report(place, "`:::` closes nothing");
                    String::new()
                }
            },
            Piece::Step { title, id } => self.step(opened, title, id.as_deref(), place),
            Piece::After(title) => self.after(opened, title, place),
            Piece::DisplayMath(tex) => {
                let formula = self.formula(tex, Style::Display, place);
                // The link to the numbers stays outside the box that scrolls.
                let (formula, link) = formula
                    .split_once("<a class=\"formula-numbers\"")
                    .map_or((formula.as_str(), String::new()), |(formula, link)| {
                        (formula, format!("<a class=\"formula-numbers\"{link}"))
                    });
                let body = format!("<div class=\"equation-body scroll-box\">{formula}</div>{link}");
                match opened.last() {
                    Some(open) if open.name == "equation" => body,
                    _ => format!("<div class=\"equation\">{body}</div>\n"),
                }
            }
            Piece::Listing { path, anchor } => self.listing(path, anchor.as_deref(), place),
            Piece::Output(example) => self.output(example, place),
            _ => String::new(),
        }
    }

    fn open(&mut self, opened: &mut Vec<Opened>, name: &str, attributes: &Attributes, place: &Place) -> String {
        let open = Opened {
            name: name.to_string(),
            place: place.clone(),
            id: attributes.id.clone(),
            close: String::new(),
            steps: 0,
            part: Part::Body,
        };
        opened.push(open);
        if !self.grammatical(name, attributes, place) {
            return String::new();
        }
        let inside = |parent: &str| opened.iter().rev().nth(1).is_some_and(|open| open.name == parent);
        if matches!(name, "hint" | "answer" | "starter") && !inside("exercise") {
            self.diagnostics.report(place, format!("`:::{name}` stands in an exercise"));
        }
        let id = id_attribute(attributes.id.as_deref());
        let label = attributes.id.as_deref().and_then(|id| self.labels.get(id, self.root).ok());
        let label =
            label.map(|label| format!("<span class=\"label\">{}</span> ", escape(&label.text))).unwrap_or_default();
        let text = |key: &str| attributes.value(key).unwrap_or_default();
        let (html, close) = match name {
            "derivation" => (
                format!(
                    "<details class=\"derivation\"{id}><summary>{label}<span class=\"title\">{}</span></summary><div class=\"derivation-body\">\n",
                    self.title(text("title"), place)
                ),
                "</div></details>".to_string(),
            ),
            "definition" => {
                let term = self.title(text("term"), place);
                // A definition without an id has no number to show.
                (
                    format!(
                        "<div class=\"definition\"{id}><p class=\"definition-head\">{label}<dfn>{term}</dfn></p>\n"
                    ),
                    "</div>".into(),
                )
            }
            "note" => (self.note(&id, text("kind"), text("title"), place), "</div>".into()),
            "margin" => (format!("<div class=\"margin-note\" role=\"note\"{id}>\n"), "</div>".into()),
            "figure" => (self.figure(&id, &label, attributes, place), "</figcaption></figure>".into()),
            "algorithm" => (self.algorithm(&id, &label, attributes, place), "</div></figure>".into()),
            "exercise" => (self.exercise(&id, &label, attributes, place), "</div>".into()),
            "hint" | "answer" | "starter" => {
                let word = match name {
                    "hint" => "Hint",
                    "answer" => "Worked answer",
                    _ => "Starter",
                };
                let title = match text("title") {
                    "" => word.to_string(),
                    title => format!("{word}: {}", self.title(title, place)),
                };
                let open =
                    format!("<details class=\"{name}\"{id}><summary>{title}</summary><div class=\"details-body\">\n");
                (open, "</div></details>".into())
            }
            "notation" => (self.notation(&id), String::new()),
            "quiz" => (self.quiz(attributes.id.as_deref().unwrap_or_default(), place), String::new()),
            "equation" => {
                let number = label.replace("<span class=\"label\">Equation\u{a0}", "(").replace("</span> ", ")");
                let href = escape(attributes.id.as_deref().unwrap_or_default());
                let source = match text("eq") {
                    "" => String::new(),
                    eq => format!("<span class=\"equation-source\">Choset ({})</span>", escape(eq)),
                };
                (
                    format!("<div class=\"equation numbered\"{id}>"),
                    format!(
                        "<a class=\"equation-number\" href=\"#{href}\" aria-label=\"Equation {number}\">{number}</a>{source}</div>"
                    ),
                )
            }
            "references" => {
                self.used.listed_references = true;
                (self.reference_list(), String::new())
            }
            _ => (String::new(), String::new()),
        };
        if let Some(open) = opened.last_mut() {
            open.close = close;
        }
        html
    }

    /// Whether the directive exists and has the attributes it needs and no others.
    fn grammatical(&self, name: &str, attributes: &Attributes, place: &Place) -> bool {
        let Some((_, must, may)) = GRAMMAR.iter().find(|(known, _, _)| *known == name) else {
            let names: Vec<_> = GRAMMAR.iter().map(|(name, _, _)| *name).collect();
            self.diagnostics.report(place, format!("unknown directive `:::{name}`; there are {}", names.join(", ")));
            return false;
        };
        let id = attributes.id.iter().map(|_| "id");
        let given: Vec<&str> = attributes.values.iter().map(|(key, _)| key.as_str()).chain(id).collect();
        for missing in must.iter().filter(|key| !given.contains(key)) {
            self.diagnostics.report(place, format!("`:::{name}` needs `{missing}`"));
        }
        for unknown in given.iter().filter(|key| !must.contains(key) && !may.contains(key)) {
            self.diagnostics.report(place, format!("`:::{name}` has no `{unknown}`"));
        }
        for class in &attributes.classes {
            self.diagnostics.report(place, format!("`:::{name}` has no class `.{class}`"));
        }
        must.iter().all(|key| given.contains(key))
    }

    fn step(&mut self, opened: &mut [Opened], title: &str, id: Option<&str>, place: &Place) -> String {
        let title = self.title(title, place);
        let Some(open) = opened.last_mut().filter(|open| open.name == "derivation" && open.part != Part::After) else {
            self.diagnostics.report(place, "`::step` stands in a derivation, before `::after`");
            return String::new();
        };
        let before = if open.part == Part::Steps { "</li>\n" } else { "<ol class=\"steps\">\n" };
        open.part = Part::Steps;
        open.steps += 1;
        let n = open.steps;
        let default = || format!("{}-step-{n}", open.id.as_deref().unwrap_or("derivation"));
        let id = escape(&id.map_or_else(default, String::from));
        format!(
            "{before}<li class=\"step\" id=\"{id}\"><p class=\"step-head\"><a class=\"step-link\" href=\"#{id}\">Step\u{a0}{n}</a> \
             <span class=\"step-title\">{title}</span></p>\n"
        )
    }

    fn after(&mut self, opened: &mut [Opened], title: &str, place: &Place) -> String {
        let title = match title {
            "" => String::new(),
            title => format!("<p class=\"after-title\">{}</p>\n", self.title(title, place)),
        };
        let Some(open) = opened.last_mut().filter(|open| open.part == Part::Steps) else {
            self.diagnostics.report(place, "`::after` follows the steps of a derivation");
            return String::new();
        };
        let end = end_part(open);
        open.part = Part::After;
        format!("{end}<div class=\"after-steps\">\n{title}")
    }
}

/// What closes the part of a derivation that is open.
fn end_part(open: &Opened) -> &'static str {
    match open.part {
        Part::Body => "",
        Part::Steps => "</li></ol>\n",
        Part::After => "</div>\n",
    }
}
