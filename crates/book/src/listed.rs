//! The list of figures for scripts: what `labs` lists, and which figures of the text open in a state of their own.

use std::collections::BTreeSet;
use std::path::Path;

use lab::Figure;
use serde_json::{Value, json};

use crate::config::{Config, DataFile};
use crate::diagnostic::{BuildError, Diagnostics, Place};
use crate::file;
use crate::page;
use crate::parse::parse;
use crate::piece::Piece;
use crate::tree::{self, Kind};

/// A script with the figures of the list, in its order.
fn script(figures: &[Figure]) -> String {
    let of = |figure: &Figure| {
        json!({
            "name": figure.name(), "tag": figure.tag(), "lab": figure.class,
                "build": figure.build, "world": figure.world,
            "was": figure.was,
        })
    };
    let list: Vec<Value> = figures.iter().map(of).collect();
    format!(
        "// Written by the book's program from the list in crates/labs/src/figures.rs.\n\
         /** @type {{import('../web/widgets/index.js').Listed[]}} */\nexport const FIGURES = {list:#}\n",
        list = Value::Array(list)
    )
}

/// The builds of the module that hold the labs of figures, in the order of the list.
pub fn builds(figures: &[Figure]) -> Vec<&'static str> {
    let mut seen = BTreeSet::new();
    figures.iter().map(|figure| figure.build).filter(|build| seen.insert(*build)).collect()
}

/// The figures of the text that open in a state of their own: id, name and state of each.
///
/// # Errors
/// [`BuildError`] when a file cannot be read.
fn opened(root: &Path) -> Result<Value, BuildError> {
    // What is wrong with the text is told by the build of its pages.
    let diagnostics = Diagnostics::default();
    let config: Config = DataFile::read(root, "book.toml")?.parse(&diagnostics);
    let mut files = Vec::new();
    for chapter in &config.chapters {
        files.extend(page::files(root, &format!("content/{}", chapter.slug))?);
    }
    for page in &config.pages {
        let path = format!("content/pages/{}.md", page.slug);
        files.push((path.clone(), file::read(&root.join(path))?));
    }
    let mut opened = Vec::new();
    for (path, text) in files {
        let nodes = parse(&text, &Place::new(path, 1), &diagnostics);
        tree::walk(&nodes, &mut |node| {
            let Kind::Piece(Piece::Directive { attributes, .. }) = &node.kind else { return };
            if let (true, Some(id), Some(widget), Some(start)) = (
                node.is_directive("figure"),
                &attributes.id,
                attributes.value("widget"),
                attributes.value("start").and_then(|start| serde_json::from_str::<Value>(start).ok()),
            ) {
                opened.push(json!({ "id": id, "name": widget, "start": start }));
            }
        });
    }
    Ok(Value::Array(opened))
}

/// Writes `figures.js` and `opened.json` into `folder`, each only where it has changed.
///
/// # Errors
/// [`BuildError`] when a file cannot be read or written.
pub fn write(root: &Path, figures: &[Figure], folder: &Path) -> Result<(), BuildError> {
    for (name, text) in [("figures.js", script(figures)), ("opened.json", format!("{:#}\n", opened(root)?))] {
        let path = folder.join(name);
        if std::fs::read_to_string(&path).ok().as_ref() != Some(&text) {
            std::fs::create_dir_all(folder).map_err(BuildError::file(folder))?;
            std::fs::write(&path, text).map_err(BuildError::file(&path))?;
        }
    }
    Ok(())
}
