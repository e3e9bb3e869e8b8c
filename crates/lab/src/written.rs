//! A text that a reader writes, as a parameter: bounded, and kept in place, so that parameters stay values.

use crate::parameter::Knob;
use crate::shape::{Plain, Shape, put};
use std::slice::Iter;

/// A text of at most `MOST` bytes without control characters other than line feeds and tabs.
#[derive(Clone, Copy, PartialEq)]
pub struct Written<const MOST: usize> {
    bytes: [u8; MOST],
    length: usize,
}

impl<const MOST: usize> Written<MOST> {
    /// The text; none where it is too long, or has other control characters.
    pub fn new(text: &str) -> Option<Self> {
        let mut bytes = [0; MOST];
        bytes.get_mut(..text.len())?.copy_from_slice(text.as_bytes());
        is_plain(text).then_some(Self { bytes, length: text.len() })
    }

    /// The text.
    pub fn as_str(&self) -> &str {
        core::str::from_utf8(&self.bytes[..self.length]).unwrap_or_default()
    }
}

/// Whether a text has no control characters other than line feeds and tabs.
pub fn is_plain(text: &str) -> bool {
    text.chars().all(|c| !c.is_control() || c == '\n' || c == '\t')
}

impl<const MOST: usize> Default for Written<MOST> {
    fn default() -> Self {
        Self { bytes: [0; MOST], length: 0 }
    }
}

impl<const MOST: usize> core::fmt::Debug for Written<MOST> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.as_str().fmt(f)
    }
}

impl<const MOST: usize> Plain for Written<MOST> {
    const SHAPE: Shape = Shape::Text;

    fn write(&self, to: &mut Vec<f64>) {
        self.as_str().write(to);
    }
}

impl Plain for str {
    const SHAPE: Shape = Shape::Text;

    fn write(&self, to: &mut Vec<f64>) {
        put(to, self.chars().count() as f64);
        to.extend(self.chars().map(|letter| f64::from(u32::from(letter))));
    }
}

impl Plain for String {
    const SHAPE: Shape = Shape::Text;

    fn write(&self, to: &mut Vec<f64>) {
        self.as_str().write(to);
    }
}

impl<const MOST: usize> Knob for Written<MOST> {
    /// The greatest length, in bytes.
    const LIMITS: [f64; 3] = [0.0, MOST as f64, 1.0];

    /// The border refuses a text that does not fit; of one that comes here all the same nothing is read.
    fn read(from: &mut Iter<'_, f64>) -> Self {
        let length = from.next().map_or(0, |length| *length as usize);
        let text: String = from.take(length).filter_map(|letter| char::from_u32(*letter as u32)).collect();
        Self::new(&text).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Short = Written<8>;

    #[test]
    fn a_text_comes_back_and_one_that_does_not_fit_is_none() {
        for text in ["", "x = F x", "ν\n\tPᵀ"] {
            let written = Short::new(text).expect("it fits");
            let mut numbers = Vec::new();
            written.write(&mut numbers);
            assert_eq!(Short::SHAPE.length(&numbers), numbers.len());
            assert_eq!(Short::read(&mut numbers.iter()).as_str(), text);
        }
        assert_eq!(Short::new("123456789"), None);
        assert_eq!(Short::new("νννν ᵀ"), None);
        assert_eq!(Short::new("a\u{7}"), None);
    }
}
