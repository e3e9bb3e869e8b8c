//! A chapter or a single file as HTML, with its contents, its entries of the search and its figures.

use std::path::Path;

use serde::Serialize;

use crate::apart;
use crate::config::Chapter;
use crate::diagnostic::{BuildError, Diagnostics, Place};
use crate::figure::{self, Figure};
use crate::file;
use crate::label::Labels;
use crate::parse::parse;
use crate::reading::ReadingTime;
use crate::search::{SearchEntry, found};
use crate::site::Site;
use crate::tree::Node;
use crate::writer::{Apart, Heading, Used, Writer};

/// A rendered text, before the template.
#[derive(Debug, Default)]
pub struct Text {
    /// The article's HTML, end matter included.
    pub body: String,
    /// Headings of levels 2 and 3.
    pub contents: Vec<Section>,
    /// What the search finds.
    pub search: Vec<SearchEntry>,
    /// What the text used.
    pub used: Used,
    /// The formulas in the letters of the other notations, where any of these differs, by the index in `data-other`;
    /// empty where that notation reads as the page does. A file for each holds them until a reader asks.
    pub readings: Vec<Vec<String>>,
    /// Its figures, each for a page of its own.
    pub figures: Vec<Figure>,
    /// The list of the numbers it prints, for a page of its own; empty where it prints none.
    pub numbers: String,
    /// How long it takes to read, and to work its exercises.
    pub reading: [String; 2],
}

/// An entry of the table of contents.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Section {
    /// The heading.
    #[serde(flatten)]
    pub heading: Heading,
    /// The headings below it.
    pub sections: Vec<Heading>,
}

/// The Markdown files of a chapter, in order: path from the root and text.
///
/// # Errors
/// [`BuildError::File`] when the folder or a file cannot be read.
pub fn files(root: &Path, folder: &str) -> Result<Vec<(String, String)>, BuildError> {
    let folder_path = root.join(folder);
    let names = file::below(&folder_path)?.into_iter().filter(|name| name.ends_with(".md") && !name.contains('/'));
    names.map(|name| Ok((format!("{folder}/{name}"), file::read(&folder_path.join(name))?))).collect()
}

/// The pages of a chapter, each with its address and its files: the chapter itself, and its parts with pages of their
/// own.
///
/// # Errors
/// As [`files`].
pub fn pages(root: &Path, chapter: &Chapter) -> Result<Vec<Sources>, BuildError> {
    let parts = chapter.apart.iter().map(|part| format!("{}/{}", chapter.slug, part.slug));
    let folders = [chapter.slug.clone()].into_iter().chain(parts);
    folders.map(|folder| Ok((format!("{folder}/"), files(root, &format!("content/{folder}"))?))).collect()
}

/// The address of a page, and its Markdown files: path from the root and text.
pub type Sources = (String, Vec<(String, String)>);

/// Renders `files` as one page at `address`, its sections numbered under `chapter`.
pub fn text(
    site: &Site,
    files: &[(String, String)],
    chapter: Option<u32>,
    address: &str,
    diagnostics: &Diagnostics,
) -> Text {
    texts(site, &[(address.to_string(), files.to_vec())], chapter, diagnostics).remove(0)
}

/// Renders the pages of a chapter, each given by its address and files. The first has the chapter's sections; the
/// others are parts with pages of their own. What is referred to is found on any of them.
pub fn texts(site: &Site, pages: &[Sources], chapter: Option<u32>, diagnostics: &Diagnostics) -> Vec<Text> {
    let parse = |(path, text): &(String, String)| parse(text, &Place::new(path.clone(), 1), diagnostics);
    let parsed: Vec<Vec<Vec<Node>>> = pages.iter().map(|(_, files)| files.iter().map(parse).collect()).collect();
    let all: Vec<_> = pages.iter().zip(&parsed).map(|((address, _), texts)| (address.as_str(), &texts[..])).collect();
    let labels = Labels::collect(&all, chapter, &site.checks, diagnostics);
    let write = |(i, (address, files)): (usize, &Sources)| {
        let texts = &parsed[i];
        let mut shown = Apart { texts: all[1..].iter().copied().collect(), ..Apart::default() };
        if i > 0 {
            let asked = apart::asked(site, texts);
            let figures = parsed.iter().flat_map(|texts| apart::all(texts, "figure"));
            shown.figures = figures.filter(|figure| asked.iter().any(|id| id == apart::id(figure))).collect();
        }
        one(site, (address, files), texts, (&labels, shown), diagnostics)
    };
    pages.iter().enumerate().map(write).collect()
}

/// One page.
fn one<'a>(
    site: &'a Site,
    (address, files): (&str, &[(String, String)]),
    texts: &[Vec<Node>],
    (labels, shown): (&Labels, Apart<'a>),
    diagnostics: &'a Diagnostics,
) -> Text {
    let here: Vec<String> = shown.figures.iter().map(|figure| apart::id(figure).to_string()).collect();
    let labels = labels.on(address, &here);
    let root = root_of(address);
    let mut writer = Writer::new(site, &labels, diagnostics, &root);
    writer.apart = shown;
    let mut body = String::new();
    for (text, (path, _)) in texts.iter().zip(files) {
        body += &format!("<section data-part=\"{}\">\n{}</section>\n", part(path), writer.write(text));
    }
    let search = found(&writer.entries, &writer.words, address);
    body += &writer.end_matter();
    let numbers = writer.numbers();
    let mut readings: Vec<_> = writer.readings.take().unwrap_or_default().into_iter().collect();
    readings.sort_by_key(|(_, n)| *n);
    Text {
        body,
        contents: contents(&writer.headings),
        search,
        used: writer.used,
        readings: readings.into_iter().map(|(html, _)| html).collect(),
        figures: figure::figures(site, texts, (address, &labels), diagnostics),
        numbers,
        reading: ReadingTime::of(&texts.concat()).words(),
    }
}

/// The name of a part of a text: its file's, without folder, order and ending. `web/build/heights.json` knows it by
/// this name.
fn part(path: &str) -> &str {
    let name = path.rsplit('/').next().unwrap_or(path).trim_end_matches(".md");
    name.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start_matches('-')
}

/// From a page's address to the site's root: `kalman/` is one level down.
pub fn root_of(address: &str) -> String {
    "../".repeat(address.matches('/').count())
}

/// Headings of level 3 under their heading of level 2.
fn contents(headings: &[Heading]) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for heading in headings {
        match sections.last_mut() {
            Some(section) if heading.level > 2 => section.sections.push(heading.clone()),
            _ => sections.push(Section { heading: heading.clone(), sections: Vec::new() }),
        }
    }
    sections
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_named_by_its_file() {
        assert_eq!(part("content/kalman/08-kalman.md"), "kalman");
        assert_eq!(part("page.md"), "page");
    }

    #[test]
    fn the_root_is_as_far_up_as_the_page_is_down() {
        assert_eq!(root_of("index.html"), "");
        assert_eq!(root_of("kalman/"), "../");
        assert_eq!(root_of("source/crates/geom/src/angle.rs.html"), "../../../../");
    }
}
