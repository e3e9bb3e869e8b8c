//! The square root, with the standard library and without.

/// √x, correctly rounded: with the feature `std` the machine's, as IEEE 754 asks of it; without, `libm`'s, whose bits
/// are the same.
///
/// # Example
/// ```
/// assert_eq!(numerics::sqrt(2.25), 1.5);
/// assert!(numerics::sqrt(-1.0).is_nan());
/// ```
#[inline]
pub fn sqrt(x: f64) -> f64 {
    #[cfg(feature = "std")]
    let root = x.sqrt();
    #[cfg(not(feature = "std"))]
    let root = libm::sqrt(x);
    root
}

#[cfg(test)]
mod tests {
    use super::sqrt;

    #[test]
    fn the_machine_s_root_has_the_bits_of_libm_s() {
        let mut x = 1e-320_f64;
        while x < 1e308 {
            assert_eq!(sqrt(x).to_bits(), libm::sqrt(x).to_bits(), "{x:e}");
            x *= 1.37;
        }
        for x in [0.0, -0.0, 5e-324, f64::INFINITY, f64::MAX, f64::MIN_POSITIVE] {
            assert_eq!(sqrt(x).to_bits(), libm::sqrt(x).to_bits(), "{x:e}");
        }
    }
}
