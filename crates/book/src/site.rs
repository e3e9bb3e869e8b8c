//! Everything a page is made of besides its own text.

use std::collections::BTreeMap;
use std::path::Path;

use lab::{Check, Figure};

use crate::cache::Cache;
use crate::code::Highlighter;
use crate::config::{Config, DataFile};
use crate::diagnostic::{BuildError, Diagnostics};
use crate::glossary::{self, Term};
use crate::notation::{self, Row};
use crate::number::Numbers;
use crate::output::Outputs;
use crate::quiz::{self, Quiz};
use crate::reference::References;
use crate::source::Sources;
use crate::still::Stills;
use crate::template::Templates;
use crate::tex::Typesetter;

/// The data a page draws on.
pub struct Site {
    /// `book.toml`
    pub config: Config,
    /// Renders formulas.
    pub typesetter: Typesetter,
    /// The figures that a text can show.
    pub figures: &'static [Figure],
    /// What the labs computed.
    pub numbers: Numbers,
    /// The checks as computed natively: a page of their own runs them again.
    pub checks: Vec<Check>,
    /// Works cited.
    pub references: References,
    /// Terms.
    pub glossary: BTreeMap<String, Term>,
    /// Rows of the notation table.
    pub notation: Vec<Row>,
    /// Whether the pages hold the answers to questions and exercises, and check the reader's.
    pub answers: bool,
    /// Questions.
    pub quizzes: BTreeMap<String, Quiz>,
    /// What an earlier build computed.
    pub cache: Cache,
    /// Compiled sources.
    pub sources: Sources,
    /// Program output.
    pub outputs: Outputs,
    /// Still pictures.
    pub stills: Stills,
    /// Colours code.
    pub highlighter: Highlighter,
    /// What blocks look like.
    pub templates: Templates,
}

impl Site {
    /// The figure called `name`.
    pub fn figure(&self, name: &str) -> Option<&'static Figure> {
        self.figures.iter().find(|figure| figure.name() == name)
    }

    /// Reads `content/` and the sources under `root`.
    ///
    /// # Errors
    /// [`BuildError::File`] when a file cannot be read. What is wrong inside the files goes to `diagnostics`.
    pub fn load(
        root: &Path,
        numbers: Numbers,
        figures: &'static [Figure],
        outputs: Outputs,
        stills: Stills,
        diagnostics: &Diagnostics,
    ) -> Result<Self, BuildError> {
        let data = |name: &str| DataFile::read(root, name);
        let config: Config = data("book.toml")?.parse(diagnostics);
        let macros = data(if config.macros.is_empty() { "macros.toml" } else { &config.macros })?;
        Ok(Self {
            typesetter: Typesetter::new(&macros.parse(diagnostics)),
            references: data("references.toml")?.parse(diagnostics),
            glossary: glossary::glossary(&data("glossary.toml")?, diagnostics),
            notation: data("notation.toml")?.parse::<notation::Table>(diagnostics).row,
            quizzes: quiz::quizzes(&DataFile::all(root, "quizzes")?, &numbers, figures, diagnostics),
            checks: Vec::new(),
            answers: true,
            cache: Cache::nothing(),
            sources: Sources::load(root)?,
            highlighter: Highlighter::default(),
            templates: Templates::load(root)?,
            config,
            figures,
            numbers,
            outputs,
            stills,
        })
    }
}
