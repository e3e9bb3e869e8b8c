//! A Markdown file, scanned and ready to be walked.

use pulldown_cmark::{Event, Options, Parser};

use crate::diagnostic::{Diagnostics, Place};
use crate::scan::{self, Scanned};

/// One file of a page.
#[derive(Clone, Debug)]
pub struct Document {
    /// Path from the root, as errors name it.
    pub file: String,
    /// The text without its pieces, and the pieces.
    pub scanned: Scanned,
}

impl Document {
    /// Scans `text`, which starts at `start`.
    pub fn new(text: &str, start: &Place, diagnostics: &Diagnostics) -> Self {
        Self { file: start.file.clone(), scanned: scan::scan(text, start, diagnostics) }
    }

    /// CommonMark's events, each with its place.
    pub fn events(&self) -> impl Iterator<Item = (Event<'_>, Place)> {
        let options = Options::ENABLE_TABLES
            | Options::ENABLE_FOOTNOTES
            | Options::ENABLE_SMART_PUNCTUATION
            | Options::ENABLE_HEADING_ATTRIBUTES;
        let text = &self.scanned.text;
        let starts: Vec<usize> = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        Parser::new_ext(text, options).into_offset_iter().map(move |(event, range)| {
            let line = starts.partition_point(|&start| start <= range.start).saturating_sub(1);
            let line = self.scanned.lines.get(line).or(self.scanned.lines.last()).copied().unwrap_or(1);
            (event, Place::new(self.file.clone(), line))
        })
    }
}
