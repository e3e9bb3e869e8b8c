//! Times behind names, as the chapter writes them: x(k+1|k), x_{k|k-1}, u_t, muₜ₋₁, with the page's own | and −.

use crate::sign::begins_name;

/// A moment and, behind a bar, the last reading's: each from 1 to 6, and 0 where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Time {
    of: u8,
    by: u8,
}

impl Time {
    /// Whether it is of another moment than the last reading that it knows of: x(k+1|k).
    pub fn predicts(self) -> bool {
        self.by != 0 && self.by != self.of
    }
}

struct Reader<'a>(&'a str);

impl Reader<'_> {
    fn take(&mut self, signs: &[char]) -> bool {
        let rest = self.0.strip_prefix(signs);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    /// k, k+1, k-1, or the same of t.
    fn moment(&mut self) -> Option<u8> {
        let first = if self.take(&['k', 'ₖ']) {
            1
        } else if self.take(&['t', 'ₜ']) {
            4
        } else {
            return None;
        };
        let bare = self.0;
        let later = self.take(&['+', '₊']);
        if (later || self.take(&['-', '−', '–', '₋'])) && self.take(&['1', '₁']) {
            return Some(first + if later { 1 } else { 2 });
        }
        self.0 = bare;
        Some(first)
    }
}

/// The time at the beginning of a text, and how many bytes it takes. Without brackets nothing of a name or a number may
/// follow it.
pub(crate) fn time(text: &str) -> Option<(Time, usize)> {
    let mut reader = Reader(text);
    // The hat of a formula that is copied from the page.
    let hat = reader.take(&['^']);
    let low = !hat && reader.take(&['_']);
    // As in xk|k-1, where the bar says that k is no letter of the name.
    let close = !hat && !low && text.starts_with(['k', 't']);
    let closing = if reader.take(&['(']) {
        ')'
    } else if !hat && reader.take(&['[']) {
        ']'
    } else if low && reader.take(&['{']) {
        '}'
    } else if low || close || !hat && text.starts_with(['ₖ', 'ₜ']) {
        ' '
    } else {
        return None;
    };
    let of = reader.moment()?;
    let by = if reader.take(&['|', '∣']) { reader.moment()? } else { 0 };
    let goes_on = |c: char| begins_name(c) || c.is_ascii_digit() || c == '.';
    let ends = match closing {
        ' ' => !reader.0.starts_with(goes_on) || reader.0.starts_with(".T"),
        closing => reader.take(&[closing]),
    };
    (ends && (by != 0 || !close)).then(|| (Time { of, by }, text.len() - reader.0.len()))
}

#[cfg(test)]
mod tests {
    use super::{Time, time};

    #[test]
    fn a_time_is_read_in_each_of_the_books_spellings() {
        let (k, next, before) = (1, 2, 3);
        for (text, of, by, length) in [
            ("(k+1|k) + G", next, k, 7),
            ("(k|k)", k, k, 5),
            ("(k+1)", next, 0, 5),
            ("^(k+1∣k)", next, k, 10),
            ("_{k|k-1}'", k, before, 8),
            ("_{k−1|k−1}", before, before, 14),
            ("_k|k-1", k, before, 6),
            ("_k + 1", k, 0, 2),
            ("_k-H x", k, 0, 2),
            ("_k.T", k, 0, 2),
            ("_{t-1}", 6, 0, 6),
            ("ₜ₋₁", 6, 0, 9),
            ("[t]", 4, 0, 3),
            ("k-1|k-1 + B", before, before, 7),
        ] {
            assert_eq!(time(text), Some((Time { of, by }, length)), "{text}");
        }
        for text in
            ["_kalman", "_t2", "_tilde", "_k-1.5", "(k-2)", "(k+1|1)", "(t + 2", "(x)", "", "^k", "_", "k", "t-1"]
        {
            assert_eq!(time(text), None, "{text}");
        }
    }
}
