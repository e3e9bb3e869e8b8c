//! Sentences, put together without the machinery of formats, which would weigh more than the rest of the language.
//!
//! What is called from many places of this crate is `inline(never)`: the light builds' threshold would put it in line,
//! half a kilobyte more.

use alloc::string::String;

/// A sentence under way.
#[derive(Clone, Debug, Default)]
pub struct Words(pub String);

impl Words {
    /// A sentence that begins so.
    pub fn new(text: &str) -> Self {
        Self(text.into())
    }

    /// Appends a text.
    #[inline(never)]
    pub fn text(&mut self, text: &str) -> &mut Self {
        self.0.push_str(text);
        self
    }

    /// Appends a whole number.
    pub fn whole(&mut self, number: i64) -> &mut Self {
        if number < 0 {
            self.0.push('−');
        }
        let (mut rest, mut digits, mut count) = (number.unsigned_abs(), [0_u8; 20], 0);
        loop {
            digits[count] = b'0' + (rest % 10) as u8;
            rest /= 10;
            count += 1;
            if rest == 0 {
                break;
            }
        }
        while count > 0 {
            count -= 1;
            self.0.push(char::from(digits[count]));
        }
        self
    }

    /// Appends a number with four significant digits: 0.03172, 12.5, 1.7·10⁹.
    pub fn number(&mut self, x: f64) -> &mut Self {
        if !x.is_finite() {
            return self.text(if x.is_nan() { "not a number" } else { "infinite" });
        }
        if x < 0.0 {
            self.text("−");
        }
        let size = libm::fabs(x);
        if size == 0.0 {
            return self.text("0");
        }
        let power = |exponent: i32| libm::pow(10.0, f64::from(exponent));
        let mut exponent = 0;
        while power(exponent + 1) <= size {
            exponent += 1;
        }
        while power(exponent) > size {
            exponent -= 1;
        }
        let mut digits = libm::round(size / power(exponent - 3)) as i64;
        if digits >= 10_000 {
            (digits, exponent) = (digits / 10, exponent + 1);
        }
        let mut places = 3;
        while places > 0 && digits % 10 == 0 {
            (digits, places) = (digits / 10, places - 1);
        }
        if (-4..6).contains(&exponent) {
            let below = places - exponent;
            self.decimal(digits, below);
        } else {
            self.decimal(digits, places);
            self.text("·10");
            self.raised(exponent);
        }
        self
    }

    /// Digits with so many of them behind the point; zeros for a negative count.
    fn decimal(&mut self, digits: i64, below: i32) {
        if below <= 0 {
            self.whole(digits * (0..-below).fold(1, |power, _| 10 * power));
            return;
        }
        let unit = (0..below).fold(1, |power: i64, _| 10 * power);
        self.whole(digits / unit).text(".");
        let rest = digits % unit;
        let mut place = unit / 10;
        while place > 1 && rest < place {
            self.text("0");
            place /= 10;
        }
        self.whole(rest);
    }

    fn raised(&mut self, exponent: i32) {
        const RAISED: [&str; 10] = ["⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"];
        if exponent < 0 {
            self.text("⁻");
        }
        let size = exponent.unsigned_abs() as usize;
        for unit in [100, 10, 1] {
            if size >= unit {
                self.text(RAISED[size / unit % 10]);
            }
        }
    }

    /// Appends "a", "a and b", "a, b and c".
    pub fn list(&mut self, parts: &[String]) -> &mut Self {
        for (i, part) in parts.iter().enumerate() {
            self.text(if i == 0 {
                ""
            } else if i + 1 == parts.len() {
                " and "
            } else {
                ", "
            })
            .text(part);
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::Words;

    #[test]
    fn numbers_have_four_digits_and_no_more_zeros_than_they_need() {
        let cases = [
            (0.0, "0"),
            (2.0, "2"),
            (-0.5, "−0.5"),
            (0.031_724_9, "0.03172"),
            (0.000_2, "0.0002"),
            (12.5, "12.5"),
            (1.05, "1.05"),
            (999.96, "1000"),
            (123_456.0, "123500"),
            (1.7e9, "1.7·10⁹"),
            (-3e-12, "−3·10⁻¹²"),
            (9.9999e15, "1·10¹⁶"),
            (f64::INFINITY, "infinite"),
        ];
        for (x, expected) in cases {
            assert_eq!(Words::default().number(x).0, expected, "{x:e}");
        }
    }
}
