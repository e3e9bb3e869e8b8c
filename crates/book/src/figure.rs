//! A figure alone, for a page of its own that other pages can embed.

use serde::Serialize;

use crate::attributes::Attributes;
use crate::diagnostic::{Diagnostics, Place};
use crate::document::Document;
use crate::label::Labels;
use crate::render::Renderer;
use crate::scan::Piece;
use crate::site::Site;

/// What the page of a figure shows.
#[derive(Clone, Debug, Serialize)]
pub struct Figure {
    /// Its id in the chapter, under which an address holds its state.
    pub id: String,
    /// The custom element.
    pub widget: String,
    /// What a cross-reference calls it, as in "Figure 2".
    pub label: String,
    /// Its title as HTML.
    pub title: String,
    /// The state it opens in, as JSON, where the text gives one.
    pub start: Option<String>,
    /// Its still picture, and what that shows in words.
    pub still: String,
    /// The still in words.
    pub words: String,
    /// Its caption as HTML, without links.
    pub caption: String,
}

/// From a figure's own page, `figure/<widget>/`, to the site's root.
const ROOT: &str = "../../";

/// The figures of a page, in order. `files` are the texts of `documents`.
pub fn figures(
    site: &Site,
    files: &[(String, String)],
    documents: &[Document],
    labels: &Labels,
    diagnostics: &Diagnostics,
) -> Vec<Figure> {
    let mut figures = Vec::new();
    for ((_, text), document) in files.iter().zip(documents) {
        let mut open: Option<(&Attributes, &Place)> = None;
        for (piece, place) in &document.scanned.pieces {
            match piece {
                Piece::Directive { name, attributes } if name == "figure" => open = Some((attributes, place)),
                Piece::End => {
                    let Some((attributes, start)) = open.take() else { continue };
                    let lines = place.line.saturating_sub(start.line + 1);
                    let caption: Vec<&str> = text.lines().skip(start.line).take(lines).collect();
                    let mut renderer = Renderer::new(site, labels, diagnostics, ROOT);
                    renderer.plain = true;
                    figures.push(figure(&mut renderer, attributes, &caption.join("\n"), start));
                }
                _ => {}
            }
        }
    }
    figures
}

fn figure(renderer: &mut Renderer<'_>, attributes: &Attributes, caption: &str, place: &Place) -> Figure {
    let value = |key: &str| attributes.value(key).unwrap_or_default().to_string();
    let (id, widget) = (attributes.id.clone().unwrap_or_default(), value("widget"));
    let stills = &renderer.site.stills;
    let still = stills.get(&id).or_else(|| stills.get(&widget)).cloned().unwrap_or_default();
    Figure {
        label: renderer.labels.get(&id, ROOT).map(|label| label.text).unwrap_or_default(),
        title: renderer.title(&value("title"), place),
        start: attributes.value("start").map(String::from),
        caption: renderer.blocks(caption, &Place::new(place.file.clone(), place.line + 1)),
        still: still.svg,
        words: still.words,
        id,
        widget,
    }
}
