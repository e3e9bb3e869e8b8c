//! The length of a vector in the plane.

use crate::sqrt;

/// √(x² + y²) without overflow.
///
/// Squares of ordinary size go through the machine's square root, which IEEE 754 rounds correctly everywhere; `libm`
/// computes the rest.
///
/// # Example
/// ```
/// assert_eq!(numerics::hypot(3.0, -4.0), 5.0);
/// assert!(numerics::hypot(3e200, 4e200) > 4e200, "no overflow on the way");
/// ```
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    let squared = x * x + y * y;
    if (1e-280..1e280).contains(&squared) { sqrt(squared) } else { scaled(x, y) }
}

#[cold]
fn scaled(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

#[cfg(test)]
mod tests {
    use super::hypot;

    #[test]
    fn extremes_and_specials_are_libm_s() {
        for (x, y) in [(0.0, -0.0), (5e-324, 0.0), (1e-160, 1e-160), (1e308, -1e308), (f64::INFINITY, f64::NAN)] {
            assert_eq!(hypot(x, y).to_bits(), libm::hypot(x, y).to_bits());
        }
        assert!(hypot(f64::NAN, 1.0).is_nan());
    }

    #[test]
    fn ordinary_lengths_are_right_to_the_last_but_one_digit() {
        for i in 0..1000 {
            let (x, y) = (0.37 * f64::from(i), 1e3 / f64::from(i + 1));
            assert!((hypot(x, y) / libm::hypot(x, y) - 1.0).abs() <= f64::EPSILON);
        }
    }
}
