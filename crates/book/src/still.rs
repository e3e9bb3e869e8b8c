//! Still pictures of the widgets, drawn by their own view code before the book is built.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::diagnostic::BuildError;

/// The custom elements a figure can hold.
pub const WIDGETS: [&str; 4] = ["observer-bench", "odometry-hook", "observability-probe", "kalman-picture"];

/// A still picture and what it shows in words.
#[derive(Clone, Debug, Default)]
pub struct Still {
    /// Inline SVG.
    pub svg: String,
    /// Description for those who do not see it.
    pub words: String,
}

/// The stills, by widget; by figure where one opens in a state of its own.
pub type Stills = BTreeMap<String, Still>;

/// Reads each `<name>.svg` and `<name>.txt` of `folder`; a widget's that is missing is an error when `strict`.
///
/// # Errors
/// [`BuildError`] when a file is missing under `strict`, or cannot be read.
pub fn load(folder: &Path, strict: bool) -> Result<Stills, BuildError> {
    let mut stills = Stills::new();
    let mut names: BTreeSet<String> = WIDGETS.map(String::from).into();
    if let Ok(entries) = std::fs::read_dir(folder) {
        let drawn = entries.flatten().filter_map(|entry| entry.file_name().into_string().ok());
        names.extend(drawn.filter_map(|name| name.strip_suffix(".svg").map(String::from)));
    }
    for name in names {
        let read = |extension: &str| {
            let path = folder.join(format!("{name}.{extension}"));
            match path.exists() {
                true => std::fs::read_to_string(&path)
                    .map(Some)
                    .map_err(|e| BuildError::File(path.display().to_string(), e)),
                false if strict => {
                    Err(BuildError::Missing(format!("no still {}: run `node web/stills.mjs`", path.display())))
                }
                false => Ok(None),
            }
        };
        if let (Some(svg), Some(words)) = (read("svg")?, read("txt")?) {
            stills.insert(name, Still { svg: prepare(&svg), words: words.trim().to_string() });
        }
    }
    Ok(stills)
}

/// The `<svg>` alone, hidden from screen readers (the words stand beside it), its shape known before its styles load.
fn prepare(svg: &str) -> String {
    let svg = &svg[svg.find("<svg").unwrap_or(0)..];
    let tag = &svg[..svg.find('>').unwrap_or(0)];
    let mut attributes = String::new();
    for attribute in ["aria-hidden=\"true\"", "focusable=\"false\""] {
        if !tag.contains(attribute.split('=').next().unwrap_or_default()) {
            attributes += &format!(" {attribute}");
        }
    }
    let numbers: Vec<f64> = tag
        .split_once("viewBox=\"")
        .and_then(|(_, rest)| rest.split_once('"'))
        .map(|(numbers, _)| numbers.split([' ', ',']).filter_map(|number| number.parse().ok()).collect())
        .unwrap_or_default();
    if let ([_, _, width, height], false) = (numbers.as_slice(), tag.contains(" width=")) {
        attributes += &format!(" width=\"{width}\" height=\"{height}\"");
    }
    format!("<svg{attributes}{}", &svg["<svg".len().min(svg.len())..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_still_is_hidden_from_readers_and_knows_its_size() {
        let svg = prepare("<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 640 400\"><path/></svg>");
        assert_eq!(
            svg,
            "<svg aria-hidden=\"true\" focusable=\"false\" width=\"640\" height=\"400\" viewBox=\"0 0 640 400\"><path/></svg>"
        );
    }
}
