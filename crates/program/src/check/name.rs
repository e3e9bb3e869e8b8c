//! Names: what each is, and what one that is not known may have been meant for.

use super::Checker;
use crate::fault::{Span, line_of};
use crate::size::{Shape, Size};
use crate::token::TIMES;
use crate::tree::Name;
use crate::words::Words;
use crate::world::{Letter, World, X};

impl Checker<'_, '_> {
    /// What a name is; one that is not known is told once, with what it may have been meant for.
    pub(super) fn name(&mut self, name: Name, place: Span) -> Shape {
        if let Some(shape) = self.shapes[name] {
            return shape;
        }
        let text = self.names[name].as_str();
        let mut words = Words::new(text);
        let factors = self.factors(text);
        let later = self.tree.lines[self.line..].iter().find(|line| line.name == name && line.place.from > place.from);
        let is = |letter: Letter| self.notation.letter(letter) == text;
        if let Some(line) = later {
            words.text(" is not known here; line ").whole(i64::from(line_of(self.text, line.place.from)));
            words.text(" makes it.");
        } else if text == "k" || text == "t" || self.is_timed(text) {
            words.text(" is not known. ").text(TIMES);
        } else if !factors.0.is_empty() {
            words.text(" is not known. A product has a blank or a * between its factors: ").text(&factors.0).text(".");
        } else if let Some(whole) =
            self.like(text, |name| text.strip_prefix(name).is_some_and(|t| t == "t" || t == "T"))
        {
            words.text(" is not known. The transpose of ").text(whole).text(" is ").text(whole).text("'.");
        } else if self.world == World::Robot && (is(Letter::F) || is(Letter::H) || is(Letter::G)) {
            words.text(" is not given in this world: it is a derivative, jac(");
            words.text(if is(Letter::H) { "h, " } else { "f, " });
            words.text(if is(Letter::G) { "u" } else { &self.names[X] }).text(").");
        } else if let Some(letter) = Letter::ALL.into_iter().find(|letter| is(*letter)) {
            words.text(" is ").text(letter.meaning()).text(", and no line above makes it");
            let mut others = Words::new("; it is ");
            if self.notation.say_foreign(text, &mut others) {
                words.text(&others.0);
            }
            words.text(".");
        } else if self.notation.say_foreign(text, words.text(" is ")) {
            words.text(".");
        } else if let Some(other) = self.like(text, |name| name.eq_ignore_ascii_case(text)) {
            words = Words::new(text);
            words.text(" is not known, and ").text(other).text(" is: capitals are letters of their own.");
        } else {
            words = Words::new(text);
            words.text(" is not known: no line above makes it, and the world gives ");
            words.list(&self.names[..self.world.identity()]).text(".");
        }
        self.faults.words(place, words);
        // Once is enough.
        self.shapes[name] = Some(Shape::Unknown);
        Shape::Unknown
    }

    /// Whether it is a known name with a time run on: xk, or zt of a column, which one would hardly transpose.
    fn is_timed(&self, text: &str) -> bool {
        let is_column = |name: usize| matches!(self.shapes[name], Some(Shape::Of(_, Size::ONE)));
        let base = text.strip_suffix(['k', 't']).and_then(|base| self.names.iter().position(|name| name == base));
        base.is_some_and(|base| self.shapes[base].is_some() && (text.ends_with('k') || is_column(base)))
    }

    /// A name that is known, and like one that is not.
    fn like(&self, text: &str, is: impl Fn(&str) -> bool) -> Option<&str> {
        let known = |i: &usize| self.shapes[*i].is_some() && self.names[*i] != text && is(&self.names[*i]);
        (0..self.names.len()).find(known).map(|i| self.names[i].as_str())
    }

    /// A name as a product of names that are known, "F x" for "Fx"; empty where it is none.
    fn factors(&self, text: &str) -> Words {
        let (mut words, mut rest) = (Words::default(), text);
        while !rest.is_empty() {
            // I, n, p, m and π are no factors that one would write so.
            let constants = self.world.identity()..self.world.identity() + 6;
            let mut known = (0..self.names.len()).filter(|i| self.shapes[*i].is_some() && !constants.contains(i));
            let begins = |name: &str| !name.is_empty() && rest.starts_with(name);
            let Some(name) = known.find(|i| begins(&self.names[*i])) else {
                return Words::default();
            };
            let name = &self.names[name];
            words.text(if rest.len() < text.len() { " " } else { "" }).text(name);
            rest = rest.get(name.len()..).unwrap_or_default();
        }
        words
    }
}
