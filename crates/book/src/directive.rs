//! The directives: which there are, what each must and may say, and what a cross-reference calls it.

use crate::attributes::Attributes;
use crate::diagnostic::{Diagnostics, Place};

/// What a directive may look like.
struct Rule {
    name: &'static str,
    must: &'static [&'static str],
    may: &'static [&'static str],
    /// What a cross-reference calls it; a directive without a word has no number.
    word: Option<&'static str>,
}

const fn rule(
    name: &'static str,
    must: &'static [&'static str],
    may: &'static [&'static str],
    word: Option<&'static str>,
) -> Rule {
    Rule { name, must, may, word }
}

const RULES: [Rule; 14] = [
    rule("derivation", &["id", "title"], &[], Some("Derivation")),
    rule("definition", &["term"], &["id"], Some("Definition")),
    rule("note", &["kind"], &["id", "title"], None),
    rule("margin", &[], &["id"], None),
    rule("figure", &["id", "widget"], &["title", "start"], Some("Figure")),
    rule("algorithm", &["id", "name"], &["in", "out", "cost"], Some("Algorithm")),
    rule("exercise", &["id", "title", "kind", "difficulty"], &[], Some("Exercise")),
    rule("hint", &[], &["id", "title"], None),
    rule("answer", &[], &["id", "title"], None),
    rule("starter", &[], &["id", "title"], None),
    rule("notation", &[], &["id"], None),
    rule("quiz", &["id"], &[], Some("Question")),
    rule("equation", &["id"], &["eq"], Some("Equation")),
    rule("references", &[], &[], None),
];

/// The word for a numbered directive, as in "Figure".
pub fn word(directive: &str) -> Option<&'static str> {
    RULES.iter().find(|rule| rule.name == directive)?.word
}

/// Whether the directive exists and has the attributes it needs; reports those it lacks and those it does not know.
pub fn check(name: &str, attributes: &Attributes, place: &Place, diagnostics: &Diagnostics) -> bool {
    let Some(rule) = RULES.iter().find(|rule| rule.name == name) else {
        let names: Vec<_> = RULES.iter().map(|rule| rule.name).collect();
        diagnostics.report(place, format!("unknown directive `:::{name}`; there are {}", names.join(", ")));
        return false;
    };
    let id = attributes.id.iter().map(|_| "id");
    let given: Vec<&str> = attributes.values.iter().map(|(key, _)| key.as_str()).chain(id).collect();
    for missing in rule.must.iter().filter(|key| !given.contains(key)) {
        diagnostics.report(place, format!("`:::{name}` needs `{missing}`"));
    }
    for unknown in given.iter().filter(|key| !rule.must.contains(key) && !rule.may.contains(key)) {
        diagnostics.report(place, format!("`:::{name}` has no `{unknown}`"));
    }
    for class in &attributes.classes {
        diagnostics.report(place, format!("`:::{name}` has no class `.{class}`"));
    }
    rule.must.iter().all(|key| given.contains(key))
}
