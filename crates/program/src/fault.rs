//! What is wrong with a program, and where.

use crate::words::Words;
use alloc::string::String;
use alloc::vec::Vec;

/// Faults that are said at once; of more a reader would read none.
pub const MOST_FAULTS: usize = 50;

/// From where to where something stands in the text, in bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Place {
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
    text: &'a str,
    found: Vec<(Place, String)>,
}

impl<'a> Faults<'a> {
    pub fn new(text: &'a str) -> Self {
        Self { text, found: Vec::new() }
    }

    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    pub fn say(&mut self, place: Place, words: &str) {
        // One fault at a place: the first is the cause of the others.
        if self.found.len() < MOST_FAULTS && self.found.iter().all(|(other, _)| other.from != place.from) {
            let at = self.found.iter().position(|(other, _)| other.from > place.from);
            self.found.insert(at.unwrap_or(self.found.len()), (place, words.into()));
        }
    }

    pub fn words(&mut self, place: Place, words: &Words) {
        self.say(place, &words.0);
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
pub(crate) fn shown(text: &str, place: Place, message: String) -> Fault {
    let before = text.get(..place.from).unwrap_or(text);
    let begins = before.rfind('\n').map_or(0, |at| at + 1);
    let line = before.bytes().filter(|byte| *byte == b'\n').count() + 1;
    let marked = text.get(place.from..place.to).unwrap_or_default();
    let length = marked.split('\n').next().unwrap_or_default().chars().count();
    Fault {
        line: line as u32,
        column: before.get(begins..).unwrap_or_default().chars().count() as u32 + 1,
        length: length as u32,
        message,
    }
}

/// The line of a place, from 1.
pub(crate) fn line_of(text: &str, at: usize) -> u32 {
    text.bytes().take(at).filter(|byte| *byte == b'\n').count() as u32 + 1
}
