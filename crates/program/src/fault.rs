//! What is wrong with a program, and where.

use crate::words::Words;
use alloc::string::String;
use alloc::vec::Vec;

/// Faults that are said at once; of more a reader would read none.
pub const MOST_FAULTS: usize = 50;

/// From where to where something stands in the text, in bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Span {
    pub from: usize,
    pub to: usize,
}

/// One fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The line, from 1.
    pub line: u32,
    /// Where it begins in its line, from 1, in characters.
    pub column: u32,
    /// How many characters it takes, at least 1 where there is one.
    pub length: u32,
    /// What is wrong, as a sentence.
    pub message: String,
}

/// The faults of a text.
pub(crate) struct Faults<'a> {
    pub text: &'a str,
    /// Whether all that is wrong is that no line makes an answer: no line is at fault.
    pub lacking: bool,
    found: Vec<(Span, String)>,
}

impl<'a> Faults<'a> {
    pub fn new(text: &'a str) -> Self {
        Self { text, lacking: false, found: Vec::new() }
    }

    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    pub fn say(&mut self, place: Span, words: &str) {
        self.words(place, Words::new(words));
    }

    pub fn words(&mut self, place: Span, words: Words) {
        let mut at = 0;
        for (other, _) in &self.found {
            at += usize::from(other.from < place.from);
            // One fault at a place: the first is the cause of the others.
            if other.from == place.from {
                return;
            }
        }
        if self.found.len() < MOST_FAULTS {
            self.found.insert(at, (place, words.0));
        }
    }

    /// In the order of the text.
    pub fn sorted(self) -> Vec<Fault> {
        let mut all = Vec::with_capacity(self.found.len());
        for (place, message) in self.found {
            all.push(shown(self.text, place, message));
        }
        all
    }
}

/// A fault at a place of a text.
pub(crate) fn shown(text: &str, place: Span, message: String) -> Fault {
    let (mut line, mut column, mut length) = (1, 1, 0);
    for (at, c) in text.char_indices() {
        if at >= place.to || at >= place.from && c == '\n' {
            break;
        }
        if at >= place.from {
            length += 1;
        } else if c == '\n' {
            (line, column) = (line + 1, 1);
        } else {
            column += 1;
        }
    }
    Fault { line, column, length, message }
}

/// The line of a place, from 1.
pub(crate) fn line_of(text: &str, at: usize) -> u32 {
    let mut line = 1;
    for (i, byte) in text.bytes().enumerate() {
        line += u32::from(i < at && byte == b'\n');
    }
    line
}
