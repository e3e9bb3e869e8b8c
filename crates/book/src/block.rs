//! Pieces on lines of their own: directives, steps, equations, listings. What each looks like is in
//! `templates/blocks.html`.

use minijinja::{Value, context};

use crate::attributes::Attributes;
use crate::code::marked;
use crate::diagnostic::Place;
use crate::directive;
use crate::html::CODE;
use crate::inline::source_href;
use crate::notation::Row;
use crate::output::Outputs;
use crate::piece::{Piece, Tex};
use crate::search::Entry;
use crate::syntax::statements;
use crate::template::safe;
use crate::tex::{Formula, Style};
use crate::tree::Node;
use crate::writer::Writer;
use lab::Figure;

/// Kinds of notes and what each is headed with.
const NOTES: [(&str, &str); 4] =
    [("correction", "A common mistake"), ("honesty", "Said honestly"), ("hazard", "Take care"), ("aside", "")];

/// Kinds of exercises.
const EXERCISES: [&str; 3] = ["foundation", "conceptual", "practical"];

/// A level of difficulty, of four.
pub(crate) fn dots(level: usize) -> String {
    let level = level.min(4);
    format!("{}{}", "●".repeat(level), "○".repeat(4 - level))
}

impl Writer<'_> {
    /// The HTML of a piece on a line of its own.
    pub(crate) fn own_block(&mut self, piece: &Piece, node: &Node) -> String {
        let place = &node.place;
        match piece {
            Piece::Directive { name, attributes } => self.directive(name, attributes, node),
            Piece::After(title) => {
                let title = safe(self.title(title, place));
                let body = safe(self.write(&node.children));
                self.fill("after", context! { title, body }, place)
            }
            Piece::DisplayMath(tex) => {
                let statements = statements(tex);
                let class = if statements.len() > 1 { " statements" } else { "" };
                // The link to the numbers stays outside the box that scrolls.
                let (formula, link): (String, String) =
                    statements.iter().map(|tex| self.formula(tex, Style::Display, place)).unzip();
                let body = format!("<div class=\"equation-body scroll-box{class}\">{formula}</div>{link}");
                match self.inside.last().is_some_and(|name| name == "equation") {
                    true => body,
                    false => format!("<div class=\"equation\">{body}</div>\n"),
                }
            }
            Piece::Listing { path, anchor } => self.listing(path, anchor.as_deref(), place),
            Piece::Output(example) => {
                let Some(text) = self.diagnostics.ok(place, self.site.outputs.get(example)) else {
                    return String::new();
                };
                let command = Outputs::command(example);
                self.words.push_str(&format!("{CODE}{command} {text}{CODE} "));
                self.fill("output", context! { command, text => safe(marked(text.trim_end())) }, place)
            }
            _ => String::new(),
        }
    }

    /// A step of a derivation, without the end of its list item.
    pub(crate) fn step(&mut self, title: &str, id: &str, number: usize, node: &Node) {
        let title = safe(self.title(title, &node.place));
        let body = safe(self.write(&node.children));
        let step = self.fill("step", context! { title, id, number, body }, &node.place);
        self.push(step.trim_end_matches('\n'));
        self.push("\n");
    }

    fn directive(&mut self, name: &str, attributes: &Attributes, node: &Node) -> String {
        let place = &node.place;
        if !directive::check(name, attributes, place, self.diagnostics) {
            return self.write(&node.children);
        }
        let in_exercise = self.inside.last().is_some_and(|parent| parent == "exercise");
        if matches!(name, "hint" | "answer" | "starter") && !in_exercise {
            self.diagnostics.report(place, format!("`:::{name}` stands in an exercise"));
        }
        if name == "answer" && !self.site.answers {
            return String::new();
        }
        let id = attributes.id.as_deref().unwrap_or_default();
        let text = |key: &str| attributes.value(key).unwrap_or_default();
        let label = self.labels.get(id, self.root).ok();
        let number = label.as_ref().map(|label| label.number.clone());
        let title_starts = self.words.len();
        // A definition without an id has no number to show.
        let label = label.map(|label| label.text).unwrap_or_default();
        if name != "quiz" {
            self.words.push_str(&format!(" {label} "));
        }
        let (template, own) = match name {
            "derivation" => ("derivation", context! { title => safe(self.title(text("title"), place)) }),
            "definition" => ("definition", context! { term => safe(self.title(text("term"), place)) }),
            "note" => ("note", self.note(text("kind"), text("title"), place)),
            "figure" => ("figure", self.figure(id, attributes, place)),
            "algorithm" => ("algorithm", self.algorithm(attributes, place)),
            "exercise" => ("exercise", self.exercise(attributes, place)),
            "hint" | "answer" | "starter" => {
                let word = match name {
                    "hint" => "Hint",
                    "answer" => "Worked answer",
                    _ => "Starter",
                };
                ("details", context! { name, word, title => safe(self.title(text("title"), place)) })
            }
            "notation" => ("notation", context! { rows => self.notation() }),
            "quiz" => return self.quiz(id, place),
            "equation" => ("equation", context! { number, eq => text("eq") }),
            "references" => {
                self.used.listed_references = true;
                return self.reference_list();
            }
            "own-log" => ("own_log", context! {}),
            "exercises" => ("exercises", context! { exercises => self.exercises(text("page"), text("beside"), place) }),
            "contents" => ("contents", context! { sections => self.contents(text("page"), place) }),
            "asked-figures" => {
                let figures = self.apart.figures.clone();
                return figures.into_iter().map(|figure| self.write(std::slice::from_ref(figure))).collect();
            }
            _ => ("margin", context! {}),
        };
        let section = self.headings.last().map(|heading| (heading.id.clone(), heading.number.clone()));
        let section = section.filter(|_| matches!(name, "definition" | "exercise") && !id.is_empty());
        if section.is_some() {
            let words = (title_starts, self.words.len());
            self.entries.push(Entry { id: id.to_string(), section: String::new(), words });
        }
        self.inside.push(name.to_string());
        let body = safe(self.write(&node.children));
        self.inside.pop();
        // What follows belongs to the section again.
        if let Some((id, section)) = section {
            self.entries.push(Entry { id, section, words: (self.words.len(), self.words.len()) });
        }
        self.fill(template, context! { id, label, body, ..own }, place)
    }

    /// A block of `templates/blocks.html`, filled.
    pub(crate) fn fill(&mut self, template: &str, values: Value, place: &Place) -> String {
        self.words.push(' ');
        self.fill_inline(template, values, place) + "\n"
    }

    /// A piece within a line of `templates/blocks.html`, filled.
    pub(crate) fn fill_inline(&self, template: &str, values: Value, place: &Place) -> String {
        self.diagnostics.ok(place, self.site.templates.fill(template, values)).unwrap_or_default()
    }

    fn note(&mut self, kind: &str, title: &str, place: &Place) -> Value {
        let word = NOTES.iter().find(|(known, _)| *known == kind).map(|(_, word)| *word);
        if word.is_none() {
            let kinds: Vec<_> = NOTES.iter().map(|(kind, _)| *kind).collect();
            self.diagnostics.report(place, format!("no note is of kind `{kind}`; there are {}", kinds.join(", ")));
        }
        context! { kind, word, title => safe(self.title(title, place)) }
    }

    fn figure(&mut self, id: &str, attributes: &Attributes, place: &Place) -> Value {
        let widget = attributes.value("widget").unwrap_or_default();
        let tag = self.site.figure(widget).map(Figure::tag);
        if tag.is_none() {
            let known: Vec<_> = self.site.figures.iter().map(Figure::name).collect();
            self.diagnostics.report(place, format!("no widget is called `{widget}`; there are {}", known.join(", ")));
        }
        let start = attributes.value("start");
        if let Some(start) = start {
            let read = serde_json::from_str::<serde_json::Map<String, serde_json::Value>>(start);
            self.diagnostics.ok(place, read.map_err(|error| format!("`start` is no JSON object: {error}")));
        }
        let opens = attributes.value("opens");
        if opens.is_some_and(|how| how != "small") {
            self.diagnostics.report(place, "a figure `opens` \"small\", or it is whole");
        }
        // Once more on another page, beside what asks for it, it is whole.
        let small = opens.is_some() && self.apart.figures.is_empty();
        let title = safe(self.title(attributes.value("title").unwrap_or_default(), place));
        let still = self.site.stills.get(id).or_else(|| self.site.stills.get(widget)).cloned().unwrap_or_default();
        // The first figure is there at once; the drawings of the others come when a reader comes near.
        let later = std::mem::replace(&mut self.used.widget, true);
        let html = match still.apart.filter(|_| later) {
            Some(apart) => {
                let html = apart.html(self.root);
                self.used.pictures.insert(apart.file, apart.picture);
                html
            }
            None => still.svg,
        };
        context! { widget, tag, title, start, small, still => safe(html), words => still.words }
    }

    fn algorithm(&mut self, attributes: &Attributes, place: &Place) -> Value {
        let name = safe(self.title(attributes.value("name").unwrap_or_default(), place));
        let facts = [("in", "In"), ("out", "Out"), ("cost", "Cost")].into_iter().filter_map(|(key, word)| {
            let fact = safe(self.inline(attributes.value(key)?, place));
            self.words.push(' ');
            Some((word, fact))
        });
        context! { name, run => attributes.value("run"), facts => facts.collect::<Vec<_>>() }
    }

    fn exercise(&mut self, attributes: &Attributes, place: &Place) -> Value {
        let text = |key: &str| attributes.value(key).unwrap_or_default();
        let (kind, difficulty) = (text("kind"), text("difficulty"));
        if !EXERCISES.contains(&kind) {
            let message = format!("no exercise is of kind `{kind}`; there are {}", EXERCISES.join(", "));
            self.diagnostics.report(place, message);
        }
        let level = difficulty.parse().ok().filter(|level| (1..=4).contains(level));
        if level.is_none() {
            self.diagnostics.report(place, format!("difficulty is 1, 2, 3 or 4, not `{difficulty}`"));
        }
        let level = level.unwrap_or(1);
        context! { kind, level, dots => dots(level), title => safe(self.title(text("title"), place)) }
    }

    fn listing(&mut self, path: &str, anchor: Option<&str>, place: &Place) -> String {
        let Some(listing) = self.diagnostics.ok(place, self.site.sources.listing(path, anchor)) else {
            return String::new();
        };
        self.words.push_str(&format!("{CODE}{path} {}{CODE} ", listing.code));
        let code = safe(self.site.highlighter.html(&listing.code, "rust"));
        let href = safe(source_href(self.root, path, listing.line));
        self.fill("listing", context! { href, path, code }, place)
    }

    /// The notations side by side: each in its own letters, whatever the reader has chosen.
    fn notation(&mut self) -> Vec<Vec<Value>> {
        let site = self.site;
        let row = |row: &Row| {
            let symbol = self.site.typesetter.render(&row.symbol.markdown, Style::Inline);
            let symbol = self.diagnostics.ok(&row.symbol.place, symbol);
            if let Some(formula) = &symbol {
                self.words.push_str(&formula.own().letters);
                self.words.push(' ');
            }
            let meaning = self.inline(&row.meaning.markdown, &row.meaning.place);
            self.words.push(' ');
            symbol.into_iter().flat_map(Formula::html).chain([meaning]).map(safe).collect()
        };
        site.notation.iter().map(row).collect()
    }

    /// A formula of the data files, which stands in a line.
    pub(crate) fn symbol(&mut self, tex: &[Tex], place: &Place) -> String {
        let (formula, link) = self.formula(tex, Style::Inline, place);
        self.words.push(' ');
        formula + &link
    }
}
