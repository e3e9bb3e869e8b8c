//! The compiled sources: listings by anchor, and where a function stands.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;

use crate::diagnostic::BuildError;
use crate::file;

/// Every Rust source a page may show or link, by its path from the repository's root.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: BTreeMap<String, String>,
}

/// Folders whose sources have pages.
const FOLDERS: &[&str] = &[
    "crates/geom/src",
    "crates/filters/src",
    "crates/sim/src",
    "crates/estimate/src",
    "crates/estimate/examples",
    "crates/estimate/tests",
    "crates/lab/src",
    "crates/labs/src",
    "crates/chapter-kalman/src",
    "crates/estimate-wasm/src",
    "tests",
];

/// Lines taken from a source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listing {
    /// The code without anchor lines, its common indent removed.
    pub code: String,
    /// Its first line in the file.
    pub line: usize,
}

impl Sources {
    /// Reads the sources under `root`.
    ///
    /// # Errors
    /// [`BuildError::File`] when a file cannot be read.
    pub fn load(root: &Path) -> Result<Self, BuildError> {
        let mut sources = Self::default();
        for folder in FOLDERS.iter().filter(|folder| root.join(folder).is_dir()) {
            for name in file::below(&root.join(folder))?.iter().filter(|name| name.ends_with(".rs")) {
                let path = format!("{folder}/{name}");
                let text = file::read(&root.join(&path))?;
                sources.insert(path, text);
            }
        }
        Ok(sources)
    }

    /// Adds a file.
    pub fn insert(&mut self, path: impl Into<String>, text: impl Into<String>) {
        self.files.insert(path.into(), text.into());
    }

    /// Path and text of each file as its page shows it: a book without answers has empty lines where an exercise is
    /// solved.
    pub fn pages(&self, answers: bool) -> impl Iterator<Item = (&str, Cow<'_, str>)> {
        self.iter().map(move |(path, text)| (path, if answers { text.into() } else { without_answers(text).into() }))
    }

    /// Path and text of each file.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.files.iter().map(|(path, text)| (path.as_str(), text.as_str()))
    }

    /// The listing `path#anchor`, or the whole file.
    ///
    /// # Errors
    /// A message when there is no such file or anchor, or the anchor does not end.
    pub fn listing(&self, path: &str, anchor: Option<&str>) -> Result<Listing, String> {
        let text = self.files.get(path).ok_or_else(|| format!("no source `{path}` to list"))?;
        let Some(anchor) = anchor else {
            let code: Vec<_> = text.lines().filter(|line| !is_anchor(line)).collect();
            return Ok(Listing { code: code.join("\n"), line: 1 });
        };
        let names = |line: &str, mark: &str| line.trim().strip_prefix(mark).map(str::trim) == Some(anchor);
        let missing = |what: &str| {
            let there: Vec<_> =
                text.lines().filter_map(|line| line.trim().strip_prefix("// ANCHOR:")).map(str::trim).collect();
            format!("{what} `{anchor}` in {path}; it has the anchors [{}]", there.join(", "))
        };
        let lines: Vec<&str> = text.lines().collect();
        let start = lines.iter().position(|l| names(l, "// ANCHOR:")).ok_or_else(|| missing("no anchor"))?;
        let length = lines[start..]
            .iter()
            .position(|l| names(l, "// ANCHOR_END:"))
            .ok_or_else(|| missing("no end of anchor"))?;
        let body: Vec<&str> =
            lines[start + 1..start + length].iter().copied().filter(|line| !is_anchor(line)).collect();
        let indents =
            body.iter().filter(|line| !line.trim().is_empty()).map(|line| line.len() - line.trim_start().len());
        let indent = indents.min().unwrap_or(0);
        let code: Vec<_> = body.iter().map(|line| line.get(indent..).unwrap_or("")).collect();
        Ok(Listing { code: code.join("\n").trim_matches('\n').to_string(), line: start + 2 })
    }

    /// File and line of the function `crate::module::name`: in the module's own file if it has one, else anywhere in
    /// the crate.
    ///
    /// # Errors
    /// A message when no file defines it.
    pub fn function(&self, function: &str) -> Result<(&str, usize), String> {
        let (module, name) = function.rsplit_once("::").ok_or_else(|| format!("`{function}` names no function"))?;
        let mut parts = module.split("::");
        let krate = format!("crates/{}/src/", parts.next().unwrap_or_default().replace('_', "-"));
        let modules: Vec<_> = parts.collect();
        let stem = format!("{krate}{}", modules.join("/"));
        let declares = |line: &str| {
            ["fn ", "const ", "struct ", "enum "].iter().any(|keyword| {
                line.split(keyword).nth(1).is_some_and(|rest| {
                    rest.strip_prefix(name).is_some_and(|rest| rest.starts_with(['(', '<', ':', ' ']))
                })
            })
        };
        let found = |path: &str| {
            let (path, text) = self.files.get_key_value(path)?;
            Some((path.as_str(), text.lines().position(declares)? + 1))
        };
        let near = self.files.keys().filter(|path| path.starts_with(&stem)).find_map(|path| found(path));
        let anywhere = || self.files.keys().filter(|path| path.starts_with(&krate)).find_map(|path| found(path));
        // The path may name a whole module.
        let file = format!("{stem}/{name}.rs");
        let file = || self.files.get_key_value(&file).map(|(path, _)| (path.as_str(), 1));
        near.or_else(anywhere).or_else(file).ok_or_else(|| format!("no source defines `{function}`"))
    }

    /// Line of the first line of `path` that contains `needle`.
    pub fn line_of(&self, path: &str, needle: &str) -> Option<usize> {
        Some(self.files.get(path)?.lines().position(|line| line.contains(needle))? + 1)
    }
}

/// A text without the lines of its anchors `answer`; the lines behind them keep their numbers.
fn without_answers(text: &str) -> String {
    let mut inside = false;
    let kept = text.lines().map(|line| {
        inside |= line.trim() == "// ANCHOR: answer";
        let kept = if inside { "" } else { line };
        inside &= line.trim() != "// ANCHOR_END: answer";
        format!("{kept}\n")
    });
    kept.collect()
}

fn is_anchor(line: &str) -> bool {
    let line = line.trim();
    line.starts_with("// ANCHOR:") || line.starts_with("// ANCHOR_END:")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sources() -> Sources {
        let mut sources = Sources::default();
        let text = "//! Head.\nimpl A {\n    // ANCHOR: step\n    fn step() {\n        // ANCHOR: inner\n\
            \x20       1;\n        // ANCHOR_END: inner\n    }\n    // ANCHOR_END: step\n}\n";
        sources.insert("crates/estimate/src/lti.rs", text);
        sources
    }

    #[test]
    fn a_listing_loses_its_anchors_and_its_indent() {
        let listing = sources().listing("crates/estimate/src/lti.rs", Some("step")).unwrap();
        assert_eq!(listing, Listing { code: "fn step() {\n    1;\n}".into(), line: 4 });
    }

    #[test]
    fn a_missing_anchor_is_an_error_that_names_those_there_are() {
        let error = sources().listing("crates/estimate/src/lti.rs", Some("none")).unwrap_err();
        assert!(error.contains("`none`") && error.contains("step, inner"), "{error}");
        assert!(sources().listing("crates/x.rs", None).is_err());
    }

    #[test]
    fn a_function_is_found_in_its_module() {
        assert_eq!(sources().function("estimate::lti::step").unwrap(), ("crates/estimate/src/lti.rs", 4));
        let mut sources = sources();
        sources.insert("crates/estimate/src/slam/linear.rs", "//! Linear SLAM.\n");
        assert_eq!(sources.function("estimate::slam::linear").unwrap(), ("crates/estimate/src/slam/linear.rs", 1));
        assert!(sources.function("estimate::lti::other").is_err());
    }
}
