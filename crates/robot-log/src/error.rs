//! Where a log is wrong, and what was expected there.

use core::fmt;

/// Why a log was refused. The whole log is refused: half a log would be filtered as if it were the drive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// The file, counted from 0 in the order in which they were given; 0 where there is one, or where the fault is of
    /// all together.
    pub file: usize,
    /// The line, counted from 1; 0 where the fault is of all files together, and stands in none of them.
    pub line: u32,
    /// The character in the line at which the fault begins, counted from 1; 0 where there is no line.
    pub column: u32,
    /// What was found and what was expected.
    pub message: String,
}

impl Error {
    pub(crate) fn new(line: u32, column: u32, message: impl Into<String>) -> Self {
        Self { file: 0, line, column, message: message.into() }
    }

    /// A fault of the files together, such as one that is missing.
    pub(crate) fn of_all(message: impl Into<String>) -> Self {
        Self::new(0, 0, message)
    }

    /// The same fault in another file.
    pub(crate) fn within(self, file: usize) -> Self {
        Self { file, ..self }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.line == 0 {
            return f.write_str(&self.message);
        }
        write!(f, "line {}, column {}: {}", self.line, self.column, self.message)
    }
}

impl std::error::Error for Error {}
