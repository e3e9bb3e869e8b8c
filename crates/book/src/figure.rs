//! A figure alone, for a page of its own that other pages can embed.

use serde::Serialize;

use crate::diagnostic::Diagnostics;
use crate::label::Labels;
use crate::piece::Piece;
use crate::site::Site;
use crate::tree::{self, Kind, Node};
use crate::writer::Writer;

/// What the page of a figure shows.
#[derive(Clone, Debug, Serialize)]
pub struct Figure {
    /// The address of the page that has it, from the site's root.
    pub page: String,
    /// Its id there, under which an address holds its state.
    pub id: String,
    /// Its name, as the one list of figures has it.
    pub widget: String,
    /// The custom element.
    pub tag: String,
    /// What a cross-reference calls it, as in "Figure 2".
    pub label: String,
    /// Its title as HTML.
    pub title: String,
    /// Its title in words.
    pub name: String,
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

/// The address of the page of the figure called `name`.
pub fn address(name: &str) -> String {
    format!("figure/{name}/")
}

/// The figures of a page, in order.
pub fn figures(
    site: &Site,
    texts: &[Vec<Node>],
    (address, labels): (&str, &Labels),
    diagnostics: &Diagnostics,
) -> Vec<Figure> {
    let mut figures = Vec::new();
    for text in texts {
        tree::walk(text, &mut |node| {
            if node.is_directive("figure") {
                let mut writer = Writer::new(site, labels, diagnostics, ROOT);
                // The page has no glossary and no notation switch, and its one link leads to the chapter.
                writer.plain = true;
                writer.readings = None;
                figures.extend(figure(&mut writer, address, node));
            }
        });
    }
    figures
}

fn figure(writer: &mut Writer<'_>, page: &str, node: &Node) -> Option<Figure> {
    let Kind::Piece(Piece::Directive { attributes, .. }) = &node.kind else { return None };
    let value = |key: &str| attributes.value(key).unwrap_or_default().to_string();
    let widget = attributes.value("widget")?.to_string();
    let id = attributes.id.clone().unwrap_or_default();
    let stills = &writer.site.stills;
    let still = stills.get(&id).or_else(|| stills.get(&widget)).cloned().unwrap_or_default();
    let title = writer.title(&value("title"), &node.place);
    Some(Figure {
        page: page.into(),
        name: writer.words.trim().to_string(),
        title,
        label: writer.labels.get(&id, ROOT).map(|label| label.text).unwrap_or_default(),
        start: attributes.value("start").map(String::from),
        caption: writer.write(&node.children),
        still: still.svg,
        words: still.words,
        id,
        tag: writer.site.figure(&widget).map(|figure| figure.tag().into()).unwrap_or_default(),
        widget,
    })
}
