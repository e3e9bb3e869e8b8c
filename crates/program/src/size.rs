//! Sizes before there is a system: sums of whole numbers and of the world's letters n, p and m.

use crate::words::Words;

/// The letters of sizes: states, readings and inputs.
pub(crate) const LETTERS: [&str; 3] = ["n", "p", "m"];

/// k + a n + b p + c m.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Size {
    pub number: i32,
    pub letters: [i32; 3],
}

impl Size {
    pub const ONE: Self = Self::number(1);

    pub const fn number(number: i32) -> Self {
        Self { number, letters: [0; 3] }
    }

    /// One of the [`LETTERS`].
    pub const fn letter(which: usize) -> Self {
        let mut letters = [0; 3];
        letters[which] = 1;
        Self { number: 0, letters }
    }

    pub fn plus(self, by: i32, other: Self) -> Self {
        let mut sum = self;
        sum.number += by * other.number;
        (0..3).for_each(|i| sum.letters[i] += by * other.letters[i]);
        sum
    }

    /// Whether it is more than so many, or counts a letter as often.
    pub fn is_beyond(self, most: i32) -> bool {
        self.number > most || self.letters.iter().any(|count| count.abs() > most)
    }

    pub fn known(self) -> Option<i32> {
        (self.letters == [0; 3]).then_some(self.number)
    }

    /// As a formula writes it.
    fn say(self, words: &mut Words) {
        let mut first = true;
        for (letter, count) in LETTERS.iter().zip(self.letters) {
            if count != 0 {
                words.text(if count < 0 {
                    "−"
                } else if first {
                    ""
                } else {
                    "+"
                });
                if count.abs() != 1 {
                    words.whole(i64::from(count.abs()));
                }
                words.text(letter);
                first = false;
            }
        }
        if first || self.number != 0 {
            if !first && self.number > 0 {
                words.text("+");
            }
            words.whole(i64::from(self.number));
        }
    }

    fn is_sum(self) -> bool {
        self.letters.iter().filter(|count| **count != 0).count() + usize::from(self.number != 0) > 1
    }
}

/// Rows and columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Of what could not be read: it fits everywhere, so that one fault is said once.
    Unknown,
    /// Of I, which takes the size of what it is added to.
    Identity,
    Of(Size, Size),
}

impl Shape {
    pub const NUMBER: Self = Self::Of(Size::ONE, Size::ONE);

    /// "2×1", "n×p".
    pub fn say(self, words: &mut Words) {
        let Self::Of(rows, columns) = self else {
            words.text("I");
            return;
        };
        for (i, side) in [rows, columns].into_iter().enumerate() {
            words.text(if i == 0 { "" } else { "×" });
            if side.is_sum() {
                words.text("(");
                side.say(words);
                words.text(")");
            } else {
                side.say(words);
            }
        }
    }
}

/// What has been found of the letters so far.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Found([Option<i32>; 3]);

impl Found {
    pub fn of(sizes: [i32; 3]) -> Self {
        Self(sizes.map(Some))
    }

    pub fn get(&self, letter: usize) -> Option<i32> {
        self.0[letter]
    }

    /// A size with all that is known put in.
    pub fn size(&self, size: Size) -> Size {
        let mut known = size;
        for (i, value) in self.0.iter().enumerate() {
            if let Some(value) = value {
                known.number += size.letters[i] * value;
                known.letters[i] = 0;
            }
        }
        known
    }

    pub fn shape(&self, shape: Shape) -> Shape {
        match shape {
            Shape::Of(rows, columns) => Shape::Of(self.size(rows), self.size(columns)),
            other => other,
        }
    }

    /// Whether two sizes can be one; a single letter that is not known yet becomes what makes them so.
    pub fn unify(&mut self, a: Size, b: Size) -> bool {
        let off = self.size(a.plus(-1, b));
        let mut open = (0..3).filter(|i| off.letters[*i] != 0);
        match (open.next(), open.next()) {
            (None, _) => off.number == 0,
            (Some(i), None) => {
                let value = -off.number / off.letters[i];
                // A system may be without inputs.
                let least = i32::from(i != 2);
                let fits = value * off.letters[i] == -off.number && value >= least;
                if fits {
                    self.0[i] = Some(value);
                }
                fits
            }
            _ => false,
        }
    }
}
