//! Sizes before there is a system: sums of whole numbers and of the world's letters n, p and m.

use crate::words::Words;

/// The letters of sizes: states, readings and inputs.
pub(crate) const LETTERS: [&str; 3] = ["n", "p", "m"];

/// a n + b p + c m + k, as [a, b, c, k].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Size(pub [i16; 4]);

impl Size {
    pub const ONE: Self = Self::number(1);

    pub const fn number(number: i16) -> Self {
        Self([0, 0, 0, number])
    }

    /// One of the [`LETTERS`].
    pub const fn letter(which: usize) -> Self {
        let mut letters = [0; 4];
        letters[which] = 1;
        Self(letters)
    }

    pub fn plus(self, by: i16, other: Self) -> Self {
        let mut sum = self.0;
        for (sum, more) in sum.iter_mut().zip(other.0) {
            *sum = sum.saturating_add(more.saturating_mul(by));
        }
        Self(sum)
    }

    pub fn known(self) -> Option<i16> {
        let [n, p, m, number] = self.0;
        (n == 0 && p == 0 && m == 0).then_some(number)
    }

    /// Whether it is more than so many, or counts a letter as often.
    pub fn is_beyond(self, most: i16) -> bool {
        self.0.iter().any(|count| *count > most)
    }

    /// As a formula writes it, in brackets where it is a sum.
    fn say(self, words: &mut Words) {
        let terms = self.0.iter().filter(|count| **count != 0).count();
        words.text(if terms > 1 { "(" } else { "" });
        let mut first = true;
        for (i, count) in self.0.into_iter().enumerate() {
            if count == 0 && (i < 3 || terms > 0) {
                continue;
            }
            words.text(if count > 0 && !first { "+" } else { "" });
            if i < 3 && count == -1 {
                words.text("−");
            } else if i == 3 || count != 1 {
                words.whole(i64::from(count));
            }
            words.text(LETTERS.get(i).copied().unwrap_or_default());
            first = false;
        }
        words.text(if terms > 1 { ")" } else { "" });
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
}

/// What has been found of the letters so far; −1 of those that nothing tells yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found(pub [i16; 3]);

impl Found {
    pub const NOTHING: Self = Self([-1; 3]);

    /// A size with all that is known put in.
    pub fn size(&self, size: Size) -> Size {
        let mut known = size;
        for (i, value) in self.0.into_iter().enumerate() {
            if value >= 0 {
                known.0[3] = known.0[3].saturating_add(known.0[i].saturating_mul(value));
                known.0[i] = 0;
            }
        }
        known
    }

    /// "2×1", "n×p".
    pub fn say(&self, shape: Shape, words: &mut Words) {
        match shape {
            Shape::Of(rows, columns) => {
                self.size(rows).say(words);
                words.text("×");
                self.size(columns).say(words);
            }
            _ => {
                words.text("I");
            }
        }
    }

    /// Whether two sizes can be one; a single letter that is not known yet becomes what makes them so.
    pub fn unify(&mut self, a: Size, b: Size) -> bool {
        let off = self.size(a.plus(-1, b)).0;
        let mut open = None;
        for i in 0..3 {
            if off[i] != 0 {
                if open.is_some() {
                    return false;
                }
                open = Some(i);
            }
        }
        let Some(i) = open else { return off[3] == 0 };
        let value = -off[3] / off[i];
        // A system may be without inputs. That it has a single state no formula says: there a size is wrong.
        let fits = value * off[i] == -off[3] && value >= [2, 1, 0][i];
        if fits {
            self.0[i] = value;
        }
        fits
    }
}
