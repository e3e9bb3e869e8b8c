//! The numbers of landmarks that have names: `A1`, `kitchen`.

use std::collections::HashMap;

/// The landmarks of a log's tables, which either all have numbers or all have names.
#[derive(Clone, Debug, Default)]
pub(crate) struct Landmarks {
    /// In the order in which they came: the first has the number 1.
    names: Vec<String>,
    numbers: HashMap<String, u32>,
    /// Whether one had a number.
    numbered: bool,
}

impl Landmarks {
    /// The number of a name.
    ///
    /// # Errors
    /// Others have numbers: nobody knows which of these would be free.
    pub fn named(&mut self, name: &str) -> Result<u32, String> {
        if self.numbered {
            return Err(format!("the landmark is called \u{201c}{name}\u{201d}, where others have whole numbers"));
        }
        let next = self.names.len() as u32 + 1;
        let number = *self.numbers.entry(name.to_string()).or_insert(next);
        if number == next {
            self.names.push(name.to_string());
        }
        Ok(number)
    }

    /// Takes a landmark's own number.
    ///
    /// # Errors
    /// Others have names.
    pub fn numbered(&mut self, number: u32) -> Result<u32, String> {
        self.numbered = true;
        match self.names.first() {
            None => Ok(number),
            Some(name) => {
                Err(format!("the landmark has the number {number}, where others have names as \u{201c}{name}\u{201d}"))
            }
        }
    }

    /// The names: the first one's number is 1, and so on. None where landmarks have numbers.
    pub fn names(self) -> Vec<String> {
        self.names
    }

    /// Which number each name has here, in a sentence.
    pub fn note(&self) -> Option<String> {
        const MOST: usize = 12;
        let each: Vec<String> =
            self.names.iter().zip(1..).take(MOST).map(|(name, number)| format!("{name} is {number}")).collect();
        let more = if self.names.len() > MOST { ", and so on" } else { "" };
        (!each.is_empty()).then(|| format!("Landmarks have names, and numbers here: {}{more}.", each.join(", ")))
    }
}
