//! Scaling without rounding.

/// The power of two above `size` and at most twice it, by which to divide without rounding; 1 for zero.
pub fn power_of_two(size: f64) -> f64 {
    if size == 0.0 {
        return 1.0;
    }
    let (_, exponent) = libm::frexp(size);
    // Kept where both the power and its use as a divisor are normal numbers.
    libm::ldexp(1.0, exponent.clamp(-1000, 1000))
}

#[cfg(test)]
mod tests {
    use super::power_of_two;

    #[test]
    fn the_power_exceeds_the_size_and_is_at_most_twice_as_large() {
        assert_eq!([0.0, 1.0, 1.5, 3.0, 4.0].map(power_of_two), [1.0, 2.0, 2.0, 4.0, 8.0]);
        assert!([5e-324, f64::MAX].map(power_of_two).iter().all(|p| p.is_normal() && p.recip().is_normal()));
    }
}
