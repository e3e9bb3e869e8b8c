//! `content/book.toml`, and how the data files beside it are read.

use std::cell::RefCell;
use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};
use toml::Spanned;

use crate::diagnostic::{BuildError, Diagnostics, Place};
use crate::file;

/// The book: its title page, its chapters, its pages.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// Title of the book.
    pub title: String,
    /// Subtitle of the book.
    #[serde(default)]
    pub subtitle: String,
    /// Authors, in order.
    #[serde(default)]
    pub authors: Vec<String>,
    /// Language code.
    #[serde(default)]
    pub language: String,
    /// What the book is, in a sentence or two, for the cover and for search engines.
    #[serde(default)]
    pub description: String,
    /// File of the TeX macros.
    pub macros: String,
    /// Chapters, in order.
    #[serde(default, rename = "chapter")]
    pub chapters: Vec<Chapter>,
    /// Pages beside the chapters.
    #[serde(default, rename = "page")]
    pub pages: Vec<Page>,
}

/// A chapter: the folder `content/<slug>/` shown as one page.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Chapter {
    /// Folder in `content/` and in the site.
    pub slug: String,
    /// Number in the book.
    pub number: u32,
    /// Title.
    pub title: String,
    /// Part of the book, as in "Part IV".
    #[serde(default)]
    pub part: String,
    /// Title of that part.
    #[serde(default)]
    pub part_title: String,
    /// How hard it is, as in "Intermediate".
    #[serde(default)]
    pub difficulty: String,
    /// A sentence or two, for the head of the page and for search engines.
    pub description: String,
    /// Its parts with pages of their own, in order.
    #[serde(default)]
    pub apart: Vec<Page>,
}

/// A page: `content/pages/<slug>.md`; a chapter's: the folder `content/<chapter>/<slug>/`.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Page {
    /// Name of the file and of the folder in the site.
    pub slug: String,
    /// Title.
    pub title: String,
    /// A sentence, for search engines.
    pub description: String,
}

/// A data file of `content/`.
#[derive(Clone, Debug, Default)]
pub struct DataFile {
    /// Path from the root, as errors name it.
    name: String,
    text: String,
}

thread_local! {
    /// The file that is being parsed: each [`Text`] of it asks where it stands.
    static PARSED: RefCell<DataFile> = RefCell::default();
}

impl DataFile {
    /// Reads `content/<name>` under `root`; a file that is not there is empty.
    ///
    /// # Errors
    /// [`BuildError::File`] when it is there and cannot be read.
    pub fn read(root: &Path, name: &str) -> Result<Self, BuildError> {
        let name = format!("content/{name}");
        let path = root.join(&name);
        let text = if path.exists() { file::read(&path)? } else { String::new() };
        Ok(Self { name, text })
    }

    /// Reads every file of `content/<folder>/` whose name ends in `.toml`.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn all(root: &Path, folder: &str) -> Result<Vec<Self>, BuildError> {
        let names = file::below(&root.join("content").join(folder))?.into_iter().filter(|name| name.ends_with(".toml"));
        names.map(|name| Self::read(root, &format!("{folder}/{name}"))).collect()
    }

    /// A data file from memory.
    #[cfg(test)]
    pub fn from_text(name: &str, text: &str) -> Self {
        Self { name: name.to_string(), text: text.to_string() }
    }

    /// The file as `T`, or a complaint with its line.
    pub fn parse<T: DeserializeOwned + Default>(&self, diagnostics: &Diagnostics) -> T {
        PARSED.set(self.clone());
        toml::from_str(&self.text).unwrap_or_else(|error: toml::de::Error| {
            let place = self.place(error.span().map_or(0, |span| span.start));
            diagnostics.report(&place, error.message());
            T::default()
        })
    }

    /// The place of a byte; for a string over several lines, its first line of text.
    fn place(&self, start: usize) -> Place {
        let opening = self.text.get(start..start + 4).unwrap_or("");
        let below = usize::from(opening == "'''\n" || opening == "\"\"\"\n");
        let line = self.text.get(..start).unwrap_or("").matches('\n').count() + 1;
        Place::new(self.name.clone(), line + below)
    }
}

/// A piece of Markdown in a data file.
#[derive(Clone, Debug, Default)]
pub struct Text {
    /// The Markdown.
    pub markdown: String,
    /// Where it stands.
    pub place: Place,
}

impl<'de> Deserialize<'de> for Text {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let value = Spanned::<String>::deserialize(from)?;
        let place = PARSED.with_borrow(|file| file.place(value.span().start));
        Ok(Self { markdown: value.into_inner(), place })
    }
}
