//! `content/references.toml`: the works cited.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// The works, by key.
pub type References = BTreeMap<String, Reference>;

/// One work.
#[derive(Clone, Debug, Deserialize, Serialize)]
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
}

#[cfg(test)]
mod tests {
    use minijinja::context;

    use super::*;
    use crate::template::{Templates, serde};

    #[test]
    fn a_citation_names_up_to_two_authors() {
        let work = |authors: &str| {
            let text = format!("authors = {authors}\nyear = 1960\ntitle = 'A New Approach'\ndoi = '10.1/x'");
            toml::from_str::<Reference>(&text).unwrap()
        };
        assert_eq!(work("['R. E. Kalman']").label(), "Kalman\u{a0}1960");
        assert_eq!(work("['R. E. Kalman', 'R. S. Bucy']").label(), "Kalman and Bucy\u{a0}1960");
        assert_eq!(work("['S. Thrun', 'W. Burgard', 'D. Fox']").label(), "Thrun et al.\u{a0}1960");
        let works = vec![("kalman".to_string(), serde(work("['R. E. Kalman']")))];
        let templates = Templates::load(std::path::Path::new("nowhere")).unwrap();
        let list = templates.fill("references", context! { works }).unwrap();
        assert!(list.contains("https://doi.org/10.1/x"), "{list}");
    }
}
