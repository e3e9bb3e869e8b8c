//! `content/references.toml`: the works cited.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::html::escape;

/// The works, by key.
pub type References = BTreeMap<String, Reference>;

/// One work.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reference {
    /// Authors as printed in the list.
    pub authors: Vec<String>,
    /// Year of publication.
    pub year: u32,
    /// Title.
    pub title: String,
    /// Where it appeared.
    #[serde(default)]
    pub venue: String,
    /// Digital object identifier, without a resolver.
    #[serde(default)]
    pub doi: String,
    /// Address, where there is no DOI.
    #[serde(default)]
    pub url: String,
    /// A word on what to read it for.
    #[serde(default)]
    pub note: String,
    /// The name a citation prints, where the rule (last name; two names; first and "et al.") is not wanted.
    #[serde(default)]
    pub short: String,
}

impl Reference {
    /// "Kalman 1960".
    pub fn label(&self) -> String {
        let last: Vec<&str> = self.authors.iter().map(|name| name.rsplit(' ').next().unwrap_or(name)).collect();
        let names = match last.as_slice() {
            _ if !self.short.is_empty() => self.short.clone(),
            [] => self.title.clone(),
            [one] => (*one).to_string(),
            [one, two] => format!("{one} and {two}"),
            [first, ..] => format!("{first} et al."),
        };
        format!("{names}\u{a0}{}", self.year)
    }

    /// The entry of the list, as HTML.
    pub fn entry(&self) -> String {
        let mut entry = format!(
            "<span class=\"reference-authors\">{}</span> ({}). <cite>{}</cite>.",
            escape(&self.authors.join(", ")),
            self.year,
            escape(&self.title)
        );
        if !self.venue.is_empty() {
            entry += &format!(" {}.", escape(&self.venue));
        }
        let link = match (self.doi.as_str(), self.url.as_str()) {
            ("", "") => String::new(),
            ("", url) => format!(" <a class=\"reference-link\" href=\"{0}\">{0}</a>", escape(url)),
            (doi, _) => format!(" <a class=\"reference-link\" href=\"https://doi.org/{0}\">doi:{0}</a>", escape(doi)),
        };
        entry += &link;
        if !self.note.is_empty() {
            entry += &format!(" <span class=\"reference-note\">{}</span>", escape(&self.note));
        }
        entry
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_citation_names_up_to_two_authors() {
        let work = |authors: &str| {
            let text = format!("authors = {authors}\nyear = 1960\ntitle = 'A New Approach'\ndoi = '10.1/x'");
            toml::from_str::<Reference>(&text).unwrap()
        };
        assert_eq!(work("['R. E. Kalman']").label(), "Kalman\u{a0}1960");
        assert_eq!(work("['R. E. Kalman', 'R. S. Bucy']").label(), "Kalman and Bucy\u{a0}1960");
        assert_eq!(work("['S. Thrun', 'W. Burgard', 'D. Fox']").label(), "Thrun et al.\u{a0}1960");
        assert!(work("['R. E. Kalman']").entry().contains("https://doi.org/10.1/x"));
    }
}
