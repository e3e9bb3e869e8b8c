//! What is wrong with the content, each complaint with its file and line.

use std::cell::RefCell;
use std::fmt;
use std::path::Path;

/// A place in the content.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Path from the repository's root.
    pub file: String,
    /// Line, counted from one.
    pub line: usize,
}

impl Place {
    /// The place `file:line`.
    pub fn new(file: impl Into<String>, line: usize) -> Self {
        Self { file: file.into(), line }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.file, self.line)
    }
}

/// One complaint.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Diagnostic {
    /// Where.
    pub place: Place,
    /// What is wrong and, where it helps, what would be right.
    pub message: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.message)
    }
}

/// All complaints of a build: an author mends them in one go rather than one at a time.
#[derive(Debug, Default)]
pub struct Diagnostics {
    list: RefCell<Vec<Diagnostic>>,
}

impl Diagnostics {
    /// Adds a complaint.
    pub fn report(&self, place: &Place, message: impl Into<String>) {
        let diagnostic = Diagnostic { place: place.clone(), message: message.into() };
        let mut list = self.list.borrow_mut();
        if !list.contains(&diagnostic) {
            list.push(diagnostic);
        }
    }

    /// Unwraps `result`, or reports its error at `place`.
    pub fn ok<T>(&self, place: &Place, result: Result<T, String>) -> Option<T> {
        result.map_err(|message| self.report(place, message)).ok()
    }

    /// `Err` with every complaint, sorted by place, when there is one.
    ///
    /// # Errors
    /// [`BuildError::Content`].
    pub fn check(&self) -> Result<(), BuildError> {
        let mut list = self.list.borrow().clone();
        list.sort();
        if list.is_empty() { Ok(()) } else { Err(BuildError::Content(list)) }
    }
}

/// Why a build failed.
#[derive(Debug)]
pub enum BuildError {
    /// The content is at fault.
    Content(Vec<Diagnostic>),
    /// A file could not be read or written.
    File(String, std::io::Error),
    /// Something the build needs is missing or broken: a template, an asset, a still.
    Missing(String),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Content(list) => {
                for diagnostic in list {
                    writeln!(f, "{diagnostic}")?;
                }
                write!(f, "{} {} in the content", list.len(), if list.len() == 1 { "error" } else { "errors" })
            }
            Self::File(path, error) => write!(f, "{path}: {error}"),
            Self::Missing(what) => f.write_str(what),
        }
    }
}

impl BuildError {
    /// What becomes of an error of reading or writing `path`.
    pub fn file(path: &Path) -> impl Fn(std::io::Error) -> Self {
        |error| Self::File(path.display().to_string(), error)
    }
}

impl std::error::Error for BuildError {}

impl From<serde_json::Error> for BuildError {
    fn from(error: serde_json::Error) -> Self {
        Self::Missing(error.to_string())
    }
}
