//! Scripts, styles and fonts, built beforehand and named by a manifest.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::diagnostic::BuildError;
use crate::file;

/// The assets of the site.
#[derive(Clone, Debug, Default)]
pub struct Assets {
    folder: Option<PathBuf>,
    /// Logical name, as in `site.css`, to the name with its hash.
    pub by_name: BTreeMap<String, String>,
    /// Scripts and styles that stand inside a page, by logical name.
    pub inline: BTreeMap<String, Inline>,
}

/// A script or style to stand inside a page.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Inline {
    /// The script or style.
    pub text: String,
    /// Its hash in base 64, for the page's policy.
    pub sha256: String,
}

/// Assets that every page of a released site needs.
const NEEDED: [&str; 3] = ["site.css", "katex.css", "page.js"];

impl Assets {
    /// Reads `folder/manifest.json`; a folder without one is an error when `strict`, and no assets otherwise.
    ///
    /// # Errors
    /// [`BuildError`] when the manifest is missing or lacks an asset under `strict`, or cannot be read.
    pub fn load(folder: &Path, strict: bool) -> Result<Self, BuildError> {
        let path = folder.join("manifest.json");
        if !path.exists() && !strict {
            return Ok(Self::default());
        }
        let name = path.display().to_string();
        let by_name: BTreeMap<String, String> = read(&path)?;
        let inline = folder.join("inline.json");
        let inline = if inline.exists() || strict { read(&inline)? } else { BTreeMap::new() };
        if let Some(missing) = NEEDED.iter().find(|asset| strict && !by_name.contains_key(**asset)) {
            return Err(BuildError::Missing(format!("{name} names no {missing}: run `node web/build/build.mjs`")));
        }
        Ok(Self { folder: Some(folder.to_path_buf()), by_name, inline })
    }

    /// Every file of the folder with its path below it, except the lists and the service worker's template.
    ///
    /// # Errors
    /// [`BuildError::File`] when one cannot be read.
    pub fn files(&self) -> Result<Vec<(String, Vec<u8>)>, BuildError> {
        let Some(folder) = &self.folder else { return Ok(Vec::new()) };
        let mut names = file::below(folder)?;
        names.retain(|name| !["manifest.json", "inline.json", "sw.js"].contains(&name.as_str()));
        let read = |name: String| {
            let path = folder.join(&name);
            Ok((name, std::fs::read(&path).map_err(BuildError::file(&path))?))
        };
        names.into_iter().map(read).collect()
    }

    /// The service worker's template, where there is one.
    pub fn service_worker(&self) -> Option<String> {
        std::fs::read_to_string(self.folder.as_ref()?.join("sw.js")).ok()
    }

    /// Addresses by logical name, for a page `root` below the site's root.
    pub fn hrefs(&self, root: &str) -> BTreeMap<String, String> {
        self.by_name.iter().map(|(name, file)| (name.clone(), format!("{root}assets/{file}"))).collect()
    }
}

/// A list by logical name.
fn read<T: serde::de::DeserializeOwned>(path: &Path) -> Result<BTreeMap<String, T>, BuildError> {
    serde_json::from_str(&file::read(path)?).map_err(|e| BuildError::Missing(format!("{}: {e}", path.display())))
}
