//! A whole log in the book's own format, checked and in the order of its replay.

use crate::error::Error;
use crate::fields::{Line, Lines};
use crate::gathering::{CellPlace, Gathering, Unplaced};
use crate::log::{Log, MAX_BYTES};
use crate::row::{Read, read};

/// Reads a log.
///
/// # Errors
/// Where the text is no log, with line, column and what was expected: it is too large or no text, a row has an unknown
/// letter, too few or too many fields, a field that is no finite number, a negative range, a standard deviation that is
/// not above 0, a time beyond 10¹¹ s; a landmark is named twice or a sighting names none; `O` rows and rows of held
/// motion (`V`, `S`, `T`) are mixed; there is no motion. A fault of the whole log names its last row.
pub fn parse(text: &str) -> Result<Log, Error> {
    if text.len() > MAX_BYTES {
        let message = format!("the log has {} bytes; at most {MAX_BYTES} were expected", text.len());
        return Err(Error::new(1, 1, message));
    }
    let mut to = Gathering::default();
    gather(text, 0, &mut to)?;
    to.finish(false).map(|(log, _)| log)
}

/// Takes the rows of a file that is in the book's own format.
pub(crate) fn gather(text: &str, file: usize, to: &mut Gathering) -> Result<(), Error> {
    let mut lines = Lines::new(text);
    while let Some(line) = lines.next().map_err(|e| e.within(file))? {
        check_text(&line).map_err(|e| e.within(file))?;
        let row = read(&line).map_err(|e| e.within(file))?;
        let place = |field| CellPlace::of(file, &line, field);
        let start = CellPlace { column: 1, ..place(0) };
        to.begin(start)?;
        match row {
            Read::Landmark(landmark) => to.landmark(place(1), landmark)?,
            Read::Truth(pose) => to.truth(pose),
            Read::Motion(row, even) => to.motion(start, row, even)?,
            Read::Pose(row) => to.reading(row),
            Read::Sighting(row, id) => to.sighting(place(2), row, id, Unplaced::Refused),
        }
    }
    Ok(())
}

/// Refuses a line with characters that no text has; a file in UTF-16 or a picture is full of them.
pub(crate) fn check_text(line: &Line<'_>) -> Result<(), Error> {
    let not_text = |c: char| (c.is_control() && c != '\t') || c == '\u{fffd}';
    match line.fields.iter().find(|field| field.text.contains(not_text)) {
        None => Ok(()),
        Some(at) => {
            let message = "a control character or one outside UTF-8 was found; a log is plain text in UTF-8";
            Err(Error::new(line.number, at.column, message))
        }
    }
}
