//! What the search finds on a page: its sections, and of these the definitions and exercises by themselves.

use serde::Serialize;

use crate::html::CODE;

/// Where the words of something that the search finds begin among the words of a page. They go as far as the next
/// begins.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The id to go to. Several entries of one id are one text.
    pub id: String,
    /// The number of a section, as in "15.2".
    pub section: String,
    /// Where its title and its text begin.
    pub words: (usize, usize),
}

/// What the search finds as one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SearchEntry {
    /// Page and id.
    pub id: String,
    /// The page, from the site's root.
    pub page: String,
    /// The title of the page, if that is no chapter.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub of: String,
    /// Its title in words.
    pub title: String,
    /// Number of the section, as in "15.2".
    pub section: String,
    /// Its words, without its code.
    pub text: String,
    /// Its listings, its other blocks of code and what its programs print.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub code: String,
}

/// The entries of the page at `address`, in order.
pub fn found(entries: &[Entry], words: &str, address: &str) -> Vec<SearchEntry> {
    // Every second part is code.
    let parts = |from: usize, to: usize, first: usize| {
        let between = words.get(from..to).unwrap_or_default().split(CODE).skip(first).step_by(2);
        between.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
    };
    let ends = entries.iter().skip(1).map(|next| next.words.0).chain([words.len()]);
    let mut found: Vec<SearchEntry> = Vec::new();
    for (entry, end) in entries.iter().zip(ends) {
        let id = format!("{address}#{}", entry.id);
        let (starts, begins) = entry.words;
        let (text, code) = (parts(begins, end, 0), parts(begins, end, 1));
        match found.iter_mut().find(|other| other.id == id) {
            Some(other) => {
                join(&mut other.text, &text);
                join(&mut other.code, &code);
            }
            None => found.push(SearchEntry {
                id,
                page: address.to_string(),
                of: String::new(),
                title: parts(starts, begins, 0),
                section: entry.section.clone(),
                text,
                code,
            }),
        }
    }
    found
}

fn join(words: &mut String, more: &str) {
    if !words.is_empty() && !more.is_empty() {
        words.push(' ');
    }
    words.push_str(more);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_definition_is_found_by_itself_and_the_section_goes_on_behind_it() {
        let words = "Terms Before. Innovation The surprise. After.";
        let at = |word: &str| words.find(word).unwrap();
        let entry = |id: &str, title: &str, text: &str| Entry {
            id: id.into(),
            section: String::new(),
            words: (at(title), at(text)),
        };
        let entries =
            [entry("terms", "Terms", "Before"), entry("def", "Innovation", "The"), entry("terms", "After", "After")];
        let found = found(&entries, words, "page/");
        let told: Vec<_> = found.iter().map(|it| (it.id.as_str(), it.title.as_str(), it.text.as_str())).collect();
        assert_eq!(told, [("page/#terms", "Terms", "Before. After."), ("page/#def", "Innovation", "The surprise.")]);
    }
}
