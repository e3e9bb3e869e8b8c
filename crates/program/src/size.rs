//! Sizes before there is a system: sums of whole numbers and of the world's letters n, p and m.

use crate::words::Words;

/// The letters of sizes: states, readings and inputs.
pub(crate) const LETTERS: [&str; 3] = ["n", "p", "m"];

/// Rows or columns of one matrix.
pub(crate) const MOST_SIDE: i32 = 60;

/// k + a n + b p + c m, each within ±127, in the four bytes of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Size(i32);

impl Size {
    pub const ONE: Self = Self(1);

    pub const fn number(number: i8) -> Self {
        Self(number as i32)
    }

    /// One of the [`LETTERS`].
    pub const fn letter(which: usize) -> Self {
        Self(1 << (8 * (which + 1)))
    }

    pub fn plus(self, by: i32, other: Self) -> Self {
        Self(self.0.wrapping_add(by.wrapping_mul(other.0)))
    }

    /// k, a, b and c.
    #[inline(never)]
    pub fn counts(self) -> [i32; 4] {
        let (mut counts, mut rest) = ([0; 4], self.0);
        for count in &mut counts {
            *count = i32::from(rest as i8);
            rest = rest.wrapping_sub(*count) >> 8;
        }
        counts
    }
}

/// As a formula writes it, in brackets where it is a sum.
fn say(counts: [i32; 4], words: &mut Words) {
    let mut terms = 0;
    for count in counts {
        terms += usize::from(count != 0);
    }
    words.text(if terms > 1 { "(" } else { "" });
    let mut first = true;
    for i in [1, 2, 3, 0] {
        let count = counts[i];
        if count == 0 && (i > 0 || terms > 0) {
            continue;
        }
        words.text(if count > 0 && !first { "+" } else { "" });
        if i > 0 && count == -1 {
            words.text("−");
        } else if i == 0 || count != 1 {
            words.whole(i64::from(count));
        }
        words.text(if i > 0 { LETTERS[i - 1] } else { "" });
        first = false;
    }
    words.text(if terms > 1 { ")" } else { "" });
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
pub(crate) struct Inferred(pub [i32; 3]);

impl Inferred {
    pub const NOTHING: Self = Self([-1; 3]);

    /// A size's counts with all that is known put in.
    pub fn counts(&self, size: Size) -> [i32; 4] {
        let mut counts = size.counts();
        for (i, value) in self.0.into_iter().enumerate() {
            if value >= 0 {
                counts[0] += counts[i + 1] * value;
                counts[i + 1] = 0;
            }
        }
        counts
    }

    pub fn known(&self, size: Size) -> Option<i32> {
        match self.counts(size) {
            [number, 0, 0, 0] => Some(number),
            _ => None,
        }
    }

    /// Whether it is more than a matrix may have.
    pub fn is_beyond(&self, size: Size) -> bool {
        let mut beyond = false;
        for count in size.counts() {
            beyond |= count > MOST_SIDE;
        }
        beyond || self.known(size).unwrap_or(0) > MOST_SIDE
    }

    /// "2×1", "n×p".
    pub fn say(&self, shape: Shape, words: &mut Words) {
        if let Shape::Of(rows, columns) = shape {
            say(self.counts(rows), words);
            words.text("×");
            say(self.counts(columns), words);
        } else {
            words.text("I");
        }
    }

    /// Whether two sizes can be one; a single letter that is not known yet becomes what makes them so.
    #[inline(never)]
    pub fn unify(&mut self, a: Size, b: Size) -> bool {
        let off = self.counts(a.plus(-1, b));
        let open = match off {
            [number, 0, 0, 0] => return number == 0,
            [_, _, 0, 0] => 1,
            [_, 0, _, 0] => 2,
            [_, 0, 0, _] => 3,
            _ => return false,
        };
        // Only a single letter is found so.
        let value = -off[0] * off[open];
        // A system may be without inputs. That it has a single state no formula says: there a size is wrong.
        let fits = off[open].abs() == 1 && value >= [2, 1, 0][open - 1];
        if fits {
            self.0[open - 1] = value;
        }
        fits
    }
}
