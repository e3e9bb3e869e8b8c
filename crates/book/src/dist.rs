//! The built site in memory, the list of it that the service worker caches, and how it is written.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::asset::Assets;
use crate::diagnostic::BuildError;
use crate::hash::fnv1a;
use crate::link;
use crate::search::SearchEntry;

/// The built site: path to bytes.
#[derive(Debug, Default)]
pub struct Dist {
    /// Every file by its path.
    pub files: BTreeMap<String, Vec<u8>>,
    /// Paths of files that somebody else puts beside these, so that links may lead to them.
    pub(crate) elsewhere: BTreeSet<String>,
    /// What the search finds.
    pub(crate) search: Vec<SearchEntry>,
}

/// An entry of the list the service worker caches.
#[derive(Debug, Serialize)]
struct Cached {
    url: String,
    hash: String,
    bytes: usize,
    group: &'static str,
}

impl Dist {
    pub(crate) fn put(&mut self, path: &str, bytes: Vec<u8>) {
        self.files.insert(path.to_string(), bytes);
    }

    /// The service worker and the list it caches.
    pub(crate) fn service_worker(&mut self, assets: &Assets) -> Result<(), BuildError> {
        let cached = |(path, bytes): (&String, &Vec<u8>)| Cached {
            url: match path.strip_suffix("index.html") {
                Some("") => "./".into(),
                folder => folder.unwrap_or(path).into(),
            },
            hash: format!("{:016x}", fnv1a(bytes)),
            bytes: bytes.len(),
            group: match path {
                path if path.starts_with("source/") => "source",
                path if path.starts_with("assets/") => "asset",
                path if path.ends_with(".html") => "page",
                _ => "data",
            },
        };
        let json = serde_json::to_string(&self.files.iter().map(cached).collect::<Vec<_>>())?;
        if let Some(template) = assets.service_worker() {
            let version = format!("{:016x}", fnv1a(json.as_bytes()));
            let worker = template.replace("__PRECACHE__", &json).replace("__VERSION__", &version);
            self.put("sw.js", worker.into_bytes());
        }
        self.put("precache.json", json.into_bytes());
        Ok(())
    }

    /// The pages as text.
    pub fn pages(&self) -> BTreeMap<String, String> {
        let pages = self.files.iter().filter(|(path, _)| path.ends_with(".html"));
        pages.map(|(path, bytes)| (path.clone(), String::from_utf8_lossy(bytes).into_owned())).collect()
    }

    /// How many elements a page has; none if there is no such page.
    pub fn elements(&self, path: &str) -> usize {
        let page = self.files.get(path).map_or(&[][..], Vec::as_slice);
        page.windows(2).filter(|pair| pair[0] == b'<' && pair[1].is_ascii_alphabetic()).count()
    }

    /// What is wrong with links, ids and tags.
    pub fn faults(&self) -> Vec<String> {
        let files: BTreeSet<String> = self.files.keys().chain(&self.elsewhere).cloned().collect();
        link::faults(&self.pages(), &files)
    }

    /// Writes everything into `folder`, whose former content goes; a folder that holds something else is left alone.
    ///
    /// # Errors
    /// [`BuildError`] when the folder is not ours, or a file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), BuildError> {
        let used = std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some());
        if used && !folder.join("precache.json").exists() {
            return Err(BuildError::Missing(format!("{} holds something else than a built site", folder.display())));
        }
        if used {
            std::fs::remove_dir_all(folder).map_err(BuildError::file(folder))?;
        }
        for (path, bytes) in &self.files {
            let path: PathBuf = folder.join(path);
            if let Some(parent) = path.parent() {
                std::fs::create_dir_all(parent).map_err(BuildError::file(parent))?;
            }
            std::fs::write(&path, bytes).map_err(BuildError::file(&path))?;
        }
        Ok(())
    }
}
