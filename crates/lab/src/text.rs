//! Text that is put together while the program is compiled.

/// At most `N` bytes of text.
pub struct Text<const N: usize> {
    bytes: [u8; N],
    len: usize,
}

impl<const N: usize> Text<N> {
    /// No text.
    #[allow(clippy::new_without_default)]
    pub const fn new() -> Self {
        Self { bytes: [0; N], len: 0 }
    }

    /// Appends a byte.
    pub const fn put_byte(&mut self, byte: u8) {
        self.bytes[self.len] = byte;
        self.len += 1;
    }

    /// Appends a text.
    pub const fn put(&mut self, text: &str) {
        let end = self.len + text.len();
        assert!(end <= N, "a text is longer than the room that its type has for it: make N larger");
        let (_, rest) = self.bytes.split_at_mut(self.len);
        let (place, _) = rest.split_at_mut(text.len());
        place.copy_from_slice(text.as_bytes());
        self.len = end;
    }

    /// Appends texts.
    pub const fn put_all(&mut self, mut parts: &[&str]) {
        while let [part, rest @ ..] = parts {
            self.put(part);
            parts = rest;
        }
    }

    /// A number with as many decimals as it needs, at most nine.
    pub const fn put_number(&mut self, value: f64) {
        if value < 0.0 {
            self.put("-");
        }
        let (mut scaled, mut decimals) = (value.abs(), 0);
        while decimals < 9 && (scaled - (scaled + 0.5) as u64 as f64).abs() > 1e-9 {
            scaled *= 10.0;
            decimals += 1;
        }
        let (mut rest, mut digits, mut count) = ((scaled + 0.5) as u64, [0; 20], 0);
        while rest > 0 || count <= decimals {
            digits[count] = b'0' + (rest % 10) as u8;
            rest /= 10;
            count += 1;
        }
        while count > 0 {
            count -= 1;
            self.put_byte(digits[count]);
            if count == decimals && decimals > 0 {
                self.put(".");
            }
        }
    }

    /// The text.
    pub const fn as_str(&self) -> &str {
        match core::str::from_utf8(self.bytes.split_at(self.len).0) {
            Ok(text) => text,
            Err(_) => panic!("texts are joined whole"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_with_the_decimals_they_need() {
        let written = |value: f64| {
            let mut text = Text::<32>::new();
            text.put_number(value);
            text.as_str().to_string()
        };
        let cases = [
            (0.0, "0"),
            (6.0, "6"),
            (0.01, "0.01"),
            (0.0005, "0.0005"),
            (-8.0, "-8"),
            (100_000.0, "100000"),
            (0.15, "0.15"),
        ];
        for (value, expected) in cases {
            assert_eq!(written(value), expected);
        }
        assert_eq!(written(core::f64::consts::FRAC_PI_2), "1.570796327");
    }
}
