//! Angles on the circle.

use core::f64::consts::{PI, TAU};

/// The angle congruent to `a` (mod 2π) in (−π, π], in radians.
///
/// Closed form and total: every finite `a` has an answer (the IEEE remainder is exact, so not even 1e308 loses digits
/// beyond those of 2π itself); a NaN or an infinity has none and gives NaN.
///
/// ```
/// use core::f64::consts::PI;
/// assert_eq!(geom::wrap(-PI), PI);
/// assert!((geom::wrap(7.0) - (7.0 - 2.0 * PI)).abs() < 1e-15);
/// ```
#[inline]
pub fn wrap(a: f64) -> f64 {
    if -PI < a && a <= PI {
        return a;
    }
    // Within a turn and a half the difference is exact (Sterbenz), hence the remainder itself, at a tenth of its cost.
    let r = if a.abs() < 3.0 * PI { a - libm::copysign(TAU, a) } else { remainder(a) };
    if r <= -PI { PI } else { r }
}

#[cold]
fn remainder(a: f64) -> f64 {
    libm::remainder(a, TAU)
}

/// The shortest signed turn from `b` to `a`, in (−π, π].
#[inline]
pub fn angle_diff(a: f64, b: f64) -> f64 {
    wrap(a - b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrap_is_the_identity_inside_and_keeps_the_upper_end() {
        for a in [-3.0, -0.0, 0.5, PI] {
            assert_eq!(wrap(a).to_bits(), a.to_bits());
        }
        assert_eq!(wrap(-PI), PI);
        assert_eq!(wrap(3.0 * PI), PI);
        assert_eq!(wrap(-3.0 * PI), PI);
    }

    #[test]
    fn within_a_turn_and_a_half_the_difference_is_the_remainder() {
        for i in 0..=4000 {
            let a = -3.0 * PI + f64::from(i) * (6.0 * PI / 4000.0);
            let r = libm::remainder(a, TAU);
            assert_eq!(wrap(a).to_bits(), if r <= -PI { PI } else { r }.to_bits(), "{a}");
        }
    }

    #[test]
    fn wrap_is_total_on_finite_input() {
        for a in [1e308, -1e308, f64::MIN_POSITIVE, 5e-324, 1e17, -4.0, 4.0] {
            let w = wrap(a);
            assert!(-PI < w && w <= PI, "wrap({a}) = {w}");
        }
        assert!(wrap(f64::INFINITY).is_nan() && wrap(f64::NAN).is_nan());
    }

    #[test]
    fn wrap_removes_whole_turns() {
        for k in -50..=50 {
            let w = wrap(1.25 + f64::from(k) * TAU);
            // One rounding of the product and one of the sum, at a magnitude of 50 turns.
            assert!((w - 1.25).abs() < 1e-13, "turn {k}: {w}");
        }
    }

    #[test]
    fn angle_diff_takes_the_short_way() {
        assert!((angle_diff(-3.1, 3.1) - (TAU - 6.2)).abs() < 1e-15);
        assert!((angle_diff(3.1, -3.1) + (TAU - 6.2)).abs() < 1e-15);
    }
}
