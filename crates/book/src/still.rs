//! Still pictures of the widgets, drawn by their own view code before the book is built.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::diagnostic::BuildError;
use crate::file;

/// The custom elements a figure can hold.
pub const WIDGETS: [&str; 5] =
    ["observer-bench", "odometry-hook", "observability-probe", "kalman-picture", "robot-log"];

/// The drawings that do not move, of `web/drawings`.
pub const DRAWINGS: [&str; 1] = ["covariance"];

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

/// Reads each `<name>.svg` and `<name>.txt` of `folder`; one of a widget or a drawing that is missing is an error when `strict`.
///
/// # Errors
/// [`BuildError`] when a file is missing under `strict`, or cannot be read.
pub fn load(folder: &Path, strict: bool) -> Result<Stills, BuildError> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let drawn = entries.filter_map(|entry| entry.file_name().to_str()?.strip_suffix(".svg").map(String::from));
    let names: BTreeSet<String> = drawn.chain(WIDGETS.iter().chain(&DRAWINGS).map(|name| name.to_string())).collect();
    let mut stills = Stills::new();
    for name in names {
        let [svg, words] = ["svg", "txt"].map(|extension| folder.join(format!("{name}.{extension}")));
        if let Some(missing) = [&svg, &words].into_iter().find(|path| !path.exists()) {
            if strict {
                let message = format!("no still {}: run `node web/stills.mjs`", missing.display());
                return Err(BuildError::Missing(message));
            }
            continue;
        }
        stills.insert(name, Still { svg: file::read(&svg)?, words: file::read(&words)?.trim().to_string() });
    }
    Ok(stills)
}
