//! A test for NaNs and infinities.

/// True when no number is a NaN or an infinity.
///
/// Zero times a finite number is zero, and zero times a NaN or an infinity is a NaN. So the sum of these products tells
/// with a single comparison.
///
/// # Example
/// ```
/// assert!(numerics::all_finite(&[1.0, -2.5]));
/// assert!(!numerics::all_finite(&[1.0, f64::NAN]));
/// ```
#[inline]
pub fn all_finite<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> bool {
    numbers.into_iter().fold(0.0, |sum, number| sum + 0.0 * number) == 0.0
}

#[cfg(test)]
mod tests {
    use super::all_finite;

    #[test]
    fn it_agrees_with_the_standard_library_on_every_kind_of_number() {
        let specials = [0.0, -0.0, 5e-324, -f64::MIN_POSITIVE, 1.0, -2.5, f64::MAX, f64::MIN];
        assert!(all_finite(&specials) && all_finite(&[]));
        for bad in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::from_bits(0x7ff0_0000_0000_0001)] {
            assert!(!bad.is_finite() && !all_finite(&[1.0, bad, -1.0]), "{bad}");
        }
    }
}
