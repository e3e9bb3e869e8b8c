//! The lines of a log as fields with their places.

use crate::error::Error;

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

/// Words for a value that is not there, as programs and spreadsheets write them, in small letters.
const NONE: [&str; 12] = ["", "nan", "null", "none", "na", "n/a", "-", "--", "#n/a", "#n/d", "#nv", "#na"];

/// Whether a field says that there is no number: by one of these words, by the name of a fault as spreadsheets write
/// it, `#WERT!`, `#DIV/0!`, `#NAME?`, or by a column that was too narrow to be shown, `###`.
pub(crate) fn is_none(text: &str) -> bool {
    let fault = |name: &str| name.len() < 12 && name.ends_with(['!', '?']) && !name.contains(' ');
    let narrow = |name: &str| name.len() > 1 && name.bytes().all(|b| b == b'#');
    NONE.iter().any(|none| text.eq_ignore_ascii_case(none))
        || text.strip_prefix('#').is_some_and(|name| fault(name) || narrow(name))
}

/// Whether a line of a table is for people alone. A spreadsheet's `#N/A` in the first column is none.
pub(crate) fn is_comment(line: &str) -> bool {
    let first = line.split([',', ';', '\t']).next().unwrap_or(line);
    line.starts_with('#') && !(first.len() < line.len() && is_none(first.trim()))
}

/// Reads a text line by line.
pub(crate) struct Lines<'t> {
    /// What has not been read yet.
    rest: &'t str,
    number: u32,
}

impl<'t> Lines<'t> {
    /// The lines of `text`, without its byte order mark.
    pub fn new(text: &'t str) -> Self {
        Self { rest: text.strip_prefix('\u{feff}').unwrap_or(text), number: 0 }
    }

    /// The next line that is no comment and not blank.
    ///
    /// # Errors
    /// A field behind the first is longer than [`MAX_FIELD`], or there are more than [`MAX_FIELDS`].
    pub fn next(&mut self) -> Result<Option<Line<'t>>, Error> {
        while !self.rest.is_empty() {
            let (line, rest) = self.rest.split_once('\n').unwrap_or((self.rest, ""));
            (self.rest, self.number) = (rest, self.number + 1);
            let content = line.trim_matches([' ', '\t', '\r']);
            if !content.is_empty() && !content.starts_with('#') {
                return self.split(line).map(Some);
            }
        }
        Ok(None)
    }

    fn split(&self, line: &'t str) -> Result<Line<'t>, Error> {
        let column = |byte: usize| line[..byte].chars().count() as u32 + 1;
        let (mut fields, mut from) = (Vec::with_capacity(5), 0);
        for raw in line.split(',') {
            if fields.len() == MAX_FIELDS {
                let message = format!("the line has more than {MAX_FIELDS} fields; a row has at most five");
                return Err(Error::new(self.number, column(from), message));
            }
            // A line without commas is one field: what parts it instead is told where its letter is looked at.
            if raw.len() > MAX_FIELD && !fields.is_empty() {
                let message = format!("the field is longer than {MAX_FIELD} bytes; a number was expected");
                return Err(Error::new(self.number, column(from), message));
            }
            let blanks = raw.len() - raw.trim_start_matches([' ', '\t']).len();
            fields.push(Field { text: raw.trim_matches([' ', '\t', '\r']), column: column(from + blanks) });
            from += raw.len() + 1;
        }
        Ok(Line { number: self.number, fields, end: column(line.trim_end_matches('\r').len()) })
    }
}
