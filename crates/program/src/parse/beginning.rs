//! What stands before the = of a line.

use super::{Parsed, Parser};
use crate::fault::Span;
use crate::token::Kind;
use crate::tree::Name;
use crate::words::Words;

/// What a line does not begin with, and why.
const NO_BEGINNING: [(&[&str], &str); 3] = [
    (&["return", "end"], "A program needs no end: what its names are then is its answer."),
    (&["import", "from", "using"], "A program needs no packages: leave this line out."),
    (&["def", "function", "for", "while", "if", "let"], "A program is lines, without loops, choices and functions."),
];

impl Parser<'_, '_> {
    /// Whether a line may begin with this name.
    pub(super) fn begins(&mut self, name: Name, place: Span) -> Parsed<()> {
        let is = |(beginnings, _): &&(&[&str], _)| beginnings.contains(&self.names[name].as_str());
        match NO_BEGINNING.iter().find(is) {
            Some((_, why)) => self.fail(place, why),
            None => Ok(()),
        }
    }

    /// Whether nothing but a = follows the name, or what does is told.
    pub(super) fn names_one(&mut self, name: Name, place: Span) -> Parsed<()> {
        match self.kind() {
            Kind::Sign('^' | '-' | '+' | 't') => {
                let mut words = Words::new("Before the = there is a name alone. Call a prediction ");
                words.text(&self.names[name]).text("m, say, and the result ").text(&self.names[name]).text(".");
                self.told(self.place(), words)
            }
            Kind::Name(_) => {
                self.fail(place, "A line begins with the name that it makes and a =; the name’s type is left out.")
            }
            _ => Ok(()),
        }
    }
}
