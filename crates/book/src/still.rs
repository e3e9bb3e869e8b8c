//! Still pictures of the widgets, drawn by their own view code before the book is built.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::diagnostic::BuildError;
use crate::file;
use crate::hash::fnv1a;
use lab::Figure;

/// A still picture and what it shows in words.
#[derive(Clone, Debug, Default)]
pub struct Still {
    /// Inline SVG.
    pub svg: String,
    /// Description for those who do not see it.
    pub words: String,
    /// The same with its panels in a file of their own, for figures that a page's first view does not show.
    pub apart: Option<Apart>,
}

/// A still whose panels are images, each a view of one file.
#[derive(Clone, Debug)]
pub struct Apart {
    /// Inline HTML, in which [`FILE`] stands for the file's address.
    html: String,
    /// The file's name among the assets, with a hash of what it holds.
    pub file: String,
    /// The file.
    pub picture: String,
}

/// What `web/build/apart.mjs` writes for the file's address.
const FILE: &str = "src=\"picture.svg";

impl Apart {
    /// The still called `name`: HTML with the images, and the file.
    pub fn new(name: &str, html: String, picture: String) -> Self {
        Self { html, file: format!("still-{name}-{:016x}.svg", fnv1a(picture.as_bytes())), picture }
    }

    /// Inline HTML for a page `root` below the site's root.
    pub fn html(&self, root: &str) -> String {
        self.html.replace(FILE, &format!("src=\"{root}assets/{}", self.file))
    }
}

/// The stills, by widget; by figure where one opens in a state of its own.
pub type Stills = BTreeMap<String, Still>;

/// Reads each `<name>.svg` and `<name>.txt` of `folder`; one of a widget that is missing is an error when `strict`.
///
/// # Errors
/// [`BuildError`] when a file is missing under `strict`, or cannot be read.
pub fn load(folder: &Path, figures: &[Figure], strict: bool) -> Result<Stills, BuildError> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let drawn = entries.filter_map(|entry| entry.file_name().to_str()?.strip_suffix(".svg").map(String::from));
    let names: BTreeSet<String> = drawn.chain(figures.iter().map(|figure| figure.name().into())).collect();
    let mut stills = Stills::new();
    for name in names {
        let [svg, words] = ["svg", "txt"].map(|extension| folder.join(format!("{name}.{extension}")));
        if let Some(missing) = [&svg, &words].into_iter().find(|path| !path.exists()) {
            if strict {
                let message = format!("no still {}: run `node web/build/stills.mjs`", missing.display());
                return Err(BuildError::Missing(message));
            }
            continue;
        }
        let [html, picture] = ["html", "svg"].map(|extension| folder.join(format!("apart/{name}.{extension}")));
        let apart = match html.exists() {
            true => Some(Apart::new(&name, file::read(&html)?, file::read(&picture)?)),
            false => None,
        };
        stills.insert(name, Still { svg: file::read(&svg)?, words: file::read(&words)?.trim().to_string(), apart });
    }
    Ok(stills)
}
