//! The directives: which there are, what each must and may say, and what a cross-reference calls it.

use crate::attributes::Attributes;
use crate::diagnostic::{Diagnostics, Place};

/// Each directive: its name, the attributes it must have, those it may have besides, and what a cross-reference calls
/// it. One that a cross-reference has no word for has no number.
const RULES: [(&str, &str, &str, &str); 18] = [
    ("derivation", "id title", "", "Derivation"),
    ("definition", "term", "id", "Definition"),
    ("note", "kind", "id title", ""),
    ("margin", "", "id", ""),
    ("figure", "id widget", "title start opens", "Figure"),
    ("algorithm", "id name", "in out cost run", "Algorithm"),
    ("exercise", "id title kind difficulty", "beside", "Exercise"),
    ("hint", "", "id title", ""),
    ("answer", "", "id title", ""),
    ("starter", "", "id title", ""),
    ("notation", "", "id", ""),
    ("quiz", "id", "", "Question"),
    ("equation", "id", "eq", "Equation"),
    ("references", "", "", ""),
    ("own-log", "", "", ""),
    ("exercises", "page", "beside", ""),
    ("asked-figures", "", "", ""),
    ("contents", "page", "", ""),
];

/// The word for a numbered directive, as in "Figure".
pub fn word(directive: &str) -> Option<&'static str> {
    RULES.iter().find(|rule| rule.0 == directive).map(|rule| rule.3).filter(|word| !word.is_empty())
}

/// Whether the directive exists and has the attributes it needs; reports those it lacks and those it does not know.
pub fn check(name: &str, attributes: &Attributes, place: &Place, diagnostics: &Diagnostics) -> bool {
    let Some((_, must, may, _)) = RULES.iter().find(|rule| rule.0 == name) else {
        let names: Vec<_> = RULES.iter().map(|rule| rule.0).collect();
        diagnostics.report(place, format!("unknown directive `:::{name}`; there are {}", names.join(", ")));
        return false;
    };
    let id = attributes.id.iter().map(|_| "id");
    let given: Vec<&str> = attributes.values.iter().map(|(key, _)| key.as_str()).chain(id).collect();
    let missing: Vec<&str> = must.split_whitespace().filter(|key| !given.contains(key)).collect();
    for missing in &missing {
        diagnostics.report(place, format!("`:::{name}` needs `{missing}`"));
    }
    for unknown in given.iter().filter(|given| !must.split(' ').chain(may.split(' ')).any(|key| key == **given)) {
        diagnostics.report(place, format!("`:::{name}` has no `{unknown}`"));
    }
    for class in &attributes.classes {
        diagnostics.report(place, format!("`:::{name}` has no class `.{class}`"));
    }
    missing.is_empty()
}
