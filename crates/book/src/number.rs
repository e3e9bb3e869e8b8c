//! Numbers of the prose: where they come from, and how they are printed.

use std::collections::BTreeMap;

pub use lab::Number;

/// Every number the content may print, by id.
#[derive(Clone, Debug, Default)]
pub struct Numbers {
    by_id: BTreeMap<String, Number>,
}

impl FromIterator<Number> for Numbers {
    fn from_iter<I: IntoIterator<Item = Number>>(numbers: I) -> Self {
        Self { by_id: numbers.into_iter().map(|number| (number.id.clone(), number)).collect() }
    }
}

impl Numbers {
    /// The number called `id`.
    ///
    /// # Errors
    /// A message naming the nearest ids there are.
    pub fn get(&self, id: &str) -> Result<&Number, String> {
        self.by_id.get(id).ok_or_else(|| {
            let stem = id.split('.').next().unwrap_or(id);
            let kin: Vec<_> = self.by_id.keys().filter(|known| known.starts_with(stem)).take(12).cloned().collect();
            let hint = if kin.is_empty() { String::new() } else { format!("; there are {}", kin.join(", ")) };
            format!("unknown number `{id}`{hint}")
        })
    }
}

/// How a number is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// `.3f`: three decimals
    Fixed(usize),
    /// `.2e`: a power of ten with two decimals
    Power(usize),
    /// `%.1`: percent with one decimal
    Percent(usize),
    /// `int`: a whole number
    Whole,
    /// `side.0`: a share in per cent, with an arrow up where it is above zero and one down where it is below
    Side(usize),
}

impl Format {
    /// Reads `.3f`, `.2e`, `%.1`, `int` or `side.0`.
    ///
    /// # Errors
    /// A message when `text` is none of these.
    pub fn parse(text: &str) -> Result<Self, String> {
        let formats: [(&str, &str, fn(usize) -> Self); 4] =
            [(".", "f", Self::Fixed), (".", "e", Self::Power), ("%.", "", Self::Percent), ("side.", "", Self::Side)];
        let with_decimals = formats.into_iter().find_map(|(start, end, format)| {
            let decimals = text.strip_prefix(start)?.strip_suffix(end)?.parse().ok()?;
            (decimals <= 17).then(|| format(decimals))
        });
        let format = if text == "int" { Some(Self::Whole) } else { with_decimals };
        format.ok_or_else(|| format!("unknown number format `{text}`; use .3f, .2e, %.1, int or side.0"))
    }

    /// `value` as TeX.
    ///
    /// # Errors
    /// A message when the value is not finite, or not whole under `int`.
    pub fn tex(self, value: f64) -> Result<String, String> {
        let (digits, power) = self.digits(value)?;
        Ok(match (self, power) {
            (Self::Percent(_), _) => format!(r"{digits}\,\%"),
            (Self::Side(_), _) => digits.replace('↑', r"\uparrow ").replace('↓', r"\downarrow "),
            (_, Some(power)) => format!(r"{digits}\times 10^{{{power}}}"),
            _ => digits,
        })
    }

    /// `value` as HTML, with a true minus sign.
    ///
    /// # Errors
    /// As [`Self::tex`].
    pub fn html(self, value: f64) -> Result<String, String> {
        let (digits, power) = self.digits(value)?;
        Ok(match (self, power) {
            (Self::Percent(_), _) => format!("{digits}\u{202f}%"),
            (_, Some(power)) => format!("{digits}\u{202f}×\u{202f}10<sup>{power}</sup>"),
            _ => digits,
        }
        .replace('-', "\u{2212}"))
    }

    /// How dark the ground of a share is, in quarters of the whole; no other number has a shade.
    pub fn shade(self, value: f64) -> Option<u8> {
        let quarter = (value.abs() / 25.0).floor().min(3.0);
        matches!(self, Self::Side(_)).then_some(quarter as u8)
    }

    /// The digits, and the power of ten where the format has one.
    fn digits(self, value: f64) -> Result<(String, Option<i32>), String> {
        if !value.is_finite() {
            return Err(format!("a number to print is {value}"));
        }
        let fixed = |value: f64, decimals: usize| {
            let text = format!("{value:.decimals$}");
            // A rounded −0.00 is printed 0.00.
            if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
                text.replace('-', "")
            } else {
                text
            }
        };
        Ok(match self {
            Self::Fixed(decimals) => (fixed(value, decimals), None),
            Self::Percent(decimals) => (fixed(100.0 * value, decimals), None),
            Self::Whole if (value - value.round()).abs() > 1e-9 => {
                return Err(format!("{value} is not a whole number"));
            }
            Self::Whole => (fixed(value, 0), None),
            Self::Side(decimals) if value == 0.0 => (fixed(value, decimals), None),
            Self::Side(decimals) => {
                (format!("{}{}", if value < 0.0 { '↓' } else { '↑' }, fixed(value.abs(), decimals)), None)
            }
            Self::Power(decimals) => {
                let text = format!("{value:.decimals$e}");
                let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
                (digits.to_string(), Some(power.parse().unwrap_or(0)))
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn html(value: f64, format: &str) -> String {
        Format::parse(format).unwrap().html(value).unwrap()
    }

    #[test]
    fn numbers_print_as_the_prose_wants_them() {
        assert_eq!(html(1.2759615384615385, ".4f"), "1.2760");
        assert_eq!(html(-1.3, ".3f"), "\u{2212}1.300");
        assert_eq!(html(-0.0004, ".2f"), "0.00");
        assert_eq!(html(0.00945, "%.3"), "0.945\u{202f}%");
        assert_eq!(html(2.0, "int"), "2");
        assert_eq!(html(93.6, "side.0"), "↑94");
        assert_eq!(html(-2.4, "side.0"), "↓2");
        assert_eq!(html(4.2e-16, ".1e"), "4.2\u{202f}×\u{202f}10<sup>\u{2212}16</sup>");
        assert_eq!(Format::parse(".0e").unwrap().tex(2e-16).unwrap(), r"2\times 10^{-16}");
    }

    #[test]
    fn a_share_is_the_darker_the_larger_it_is_on_either_side() {
        let shade = |value| Format::Side(0).shade(value);
        assert_eq!(
            [24.9, -25.0, 50.0, 74.9, -75.0, 100.0].map(shade),
            [Some(0), Some(1), Some(2), Some(2), Some(3), Some(3)]
        );
        assert_eq!(Format::Fixed(0).shade(90.0), None);
    }

    #[test]
    fn what_cannot_be_printed_is_refused() {
        assert!(Format::parse("3f").is_err());
        assert!(Format::Whole.html(1.5).is_err());
        assert!(Format::Fixed(2).html(f64::NAN).is_err());
    }
}
