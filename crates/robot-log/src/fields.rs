//! The lines of a log as fields with their places, by csv-core.

use crate::error::Error;
use csv_core::{ReadFieldResult, Reader, ReaderBuilder, Terminator};

/// The longest field in bytes, blanks included. A number needs less than half.
const MAX_FIELD: usize = 64;

/// The most fields that are read of one line. The longest row has five.
const MAX_FIELDS: usize = 8;

/// A field without the blanks around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Field<'t> {
    pub text: &'t str,
    /// The character in the line at which it begins, counted from 1.
    pub column: u32,
}

/// A line that is no comment and not blank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line<'t> {
    /// Counted from 1.
    pub number: u32,
    pub fields: Vec<Field<'t>>,
    /// The column behind the last character, where a missing field would stand.
    pub end: u32,
}

/// Reads a text line by line.
pub(crate) struct Lines<'t> {
    text: &'t str,
    reader: Reader,
    /// The bytes read so far.
    read: usize,
    number: u32,
}

impl<'t> Lines<'t> {
    /// The lines of `text`, without its byte order mark.
    pub fn new(text: &'t str) -> Self {
        let reader = ReaderBuilder::new().quoting(false).terminator(Terminator::Any(b'\n')).build();
        Self { text: text.strip_prefix('\u{feff}').unwrap_or(text), reader, read: 0, number: 0 }
    }

    /// The next line that is no comment and not blank.
    ///
    /// # Errors
    /// A field is longer than [`MAX_FIELD`], or there are more than [`MAX_FIELDS`].
    pub fn next(&mut self) -> Result<Option<Line<'t>>, Error> {
        loop {
            // csv-core skips empty lines without a word; the count of lines has to see them.
            let rest = &self.text[self.read..];
            if rest.is_empty() {
                return Ok(None);
            }
            self.number += 1;
            let line = &rest[..rest.find('\n').unwrap_or(rest.len())];
            let content = line.trim_matches([' ', '\t', '\r']);
            if content.is_empty() || content.starts_with('#') {
                self.read += (line.len() + 1).min(rest.len());
                continue;
            }
            return self.split(line).map(Some);
        }
    }

    fn split(&mut self, line: &'t str) -> Result<Line<'t>, Error> {
        let start = self.read;
        let column = |byte: usize| line[..byte].chars().count() as u32 + 1;
        let mut fields = Vec::with_capacity(5);
        loop {
            let mut out = [0; MAX_FIELD];
            let from = self.read - start;
            let (result, taken, written) = self.reader.read_field(&self.text.as_bytes()[self.read..], &mut out);
            self.read += taken;
            let last = match result {
                ReadFieldResult::Field { record_end } => record_end,
                // The text ends without a line end: the field is complete all the same.
                ReadFieldResult::InputEmpty | ReadFieldResult::End => true,
                ReadFieldResult::OutputFull => {
                    let message = format!("the field is longer than {MAX_FIELD} bytes; a number was expected");
                    return Err(Error::new(self.number, column(from), message));
                }
            };
            let raw = &line[from..from + written];
            let text = raw.trim_matches([' ', '\t', '\r']);
            let blanks = raw.len() - raw.trim_start_matches([' ', '\t']).len();
            fields.push(Field { text, column: column(from + blanks) });
            if last {
                let end = column(line.trim_end_matches('\r').len());
                return Ok(Line { number: self.number, fields, end });
            }
            if fields.len() == MAX_FIELDS {
                let message = format!("the line has more than {MAX_FIELDS} fields; a row has at most five");
                return Err(Error::new(self.number, column(self.read - start), message));
            }
        }
    }
}
