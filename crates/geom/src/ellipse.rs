//! The covariance ellipse {x : xᵀP⁻¹x = radius²} of a 2×2 covariance, in closed form.

use core::f64::consts::FRAC_PI_2;
use nalgebra::Matrix2;
use numerics::sqrt;

/// An ellipse about the origin: half-axes in the unit of the state, angle of the major axis in (−π/2, π/2].
///
/// # Example
/// ```
/// use geom::Ellipse;
/// let ellipse = Ellipse::from_covariance(&nalgebra::Matrix2::new(4.0, 0.0, 0.0, 1.0), 1.0);
/// assert_eq!(ellipse, Ellipse { semi_major: 2.0, semi_minor: 1.0, angle: 0.0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Half the long axis: radius · √λ₁.
    pub semi_major: f64,
    /// Half the short axis: radius · √λ₂, zero when the covariance is singular.
    pub semi_minor: f64,
    /// Direction of the long axis, radians; 0 for a circle.
    pub angle: f64,
}

impl Ellipse {
    /// The ellipse {x : xᵀP⁻¹x = radius²} of a symmetric positive semidefinite `p`.
    ///
    /// Only the lower triangle of `p` is read. λ₂ is det P / λ₁, since the difference of the trace and λ₁ would have no
    /// correct digit of a thin ellipse's width. The determinant's products are not rounded before they are subtracted
    /// (a fused multiply-add). A negative eigenvalue is taken as zero: rounding can make one, and so can a wrong
    /// filter.
    pub fn from_covariance(p: &Matrix2<f64>, radius: f64) -> Self {
        let largest = p[(0, 0)].abs().max(p[(1, 1)].abs()).max(p[(1, 0)].abs());
        let point = Self { semi_major: 0.0, semi_minor: 0.0, angle: 0.0 };
        if largest == 0.0 {
            return point;
        }
        // Scaled by the largest entry's power of two, no product here can overflow and no digit is lost.
        let scale = libm::ldexp(1.0, libm::frexp(largest).1 - 1);
        let (a, b, c) = (p[(0, 0)] / scale, p[(1, 0)] / scale, p[(1, 1)] / scale);
        let half_difference = 0.5 * (a - c);
        let major = 0.5 * (a + c) + numerics::hypot(half_difference, b);
        if major <= 0.0 {
            return point;
        }
        let bb = b * b;
        let det = libm::fma(a, c, -bb) - libm::fma(b, b, -bb);
        // Where both are negative, rounding can leave a little of λ₁; λ₂ is never the larger.
        let minor = (det / major).max(0.0).min(major);
        let angle = 0.5 * libm::atan2(b, half_difference);
        let root = sqrt(scale);
        Self {
            semi_major: radius * (root * sqrt(major)),
            semi_minor: radius * (root * sqrt(minor)),
            // + 0.0 turns the −0 of a circle into 0.
            angle: if angle <= -FRAC_PI_2 { FRAC_PI_2 } else { angle + 0.0 },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_4, FRAC_PI_6};

    fn of(a: f64, b: f64, c: f64) -> Ellipse {
        Ellipse::from_covariance(&Matrix2::new(a, b, b, c), 1.0)
    }

    #[test]
    fn axes_and_angle_of_a_turned_ellipse() {
        let (s, c) = libm::sincos(FRAC_PI_6);
        let (l1, l2) = (9.0, 4.0);
        let e = of(l1 * c * c + l2 * s * s, (l1 - l2) * s * c, l1 * s * s + l2 * c * c);
        assert!((e.semi_major - 3.0).abs() < 1e-14);
        assert!((e.semi_minor - 2.0).abs() < 1e-14);
        assert!((e.angle - FRAC_PI_6).abs() < 1e-14);
    }

    #[test]
    fn the_angle_stays_in_its_half_open_interval() {
        assert_eq!(of(4.0, 0.0, 1.0).angle, 0.0);
        assert_eq!(of(1.0, 0.0, 4.0).angle, FRAC_PI_2);
        assert_eq!(of(1.0, -0.0, 4.0).angle, FRAC_PI_2);
        assert_eq!(of(1.0, -5e-324, 4.0).angle, FRAC_PI_2);
        assert_eq!(of(2.0, 1.0, 2.0).angle, FRAC_PI_4);
        assert_eq!(of(2.0, -1.0, 2.0).angle, -FRAC_PI_4);
        assert_eq!(of(2.0, -0.0, 2.0).angle.to_bits(), 0);
    }

    #[test]
    fn a_thin_ellipse_keeps_its_width() {
        // λ₂ is 2.5e-13 of λ₁; λ₁ + λ₂ − λ₁ would know it to four digits only.
        let e = of(1.0, 1.0 - 1e-12, 1.0);
        let exact = (1.0 - (1.0 - 1e-12_f64)).sqrt();
        assert!((e.semi_minor / exact - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_determinant_keeps_its_digits_where_its_products_cancel() {
        // n = 94906265, m = n − 2: every entry is a whole number below 2⁵³ and det P = n², a hair of either product.
        let (n, m) = (94_906_265.0, 94_906_263.0);
        let e = of(n * n, n * m, m * m + 1.0);
        let (trace, det) = (n * n + m * m + 1.0, n * n);
        // λ₂ = det / λ₁ and λ₁ = trace − λ₂, where λ₂ ≈ 1/2 is lost in the trace's rounding.
        assert!((e.semi_minor / (det / trace).sqrt() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn singular_zero_negative_and_huge_covariances_have_answers() {
        assert_eq!(of(1.0, 1.0, 1.0).semi_minor, 0.0);
        assert_eq!(of(0.0, 0.0, 0.0), Ellipse { semi_major: 0.0, semi_minor: 0.0, angle: 0.0 });
        assert_eq!(of(-1.0, 0.0, -4.0), Ellipse { semi_major: 0.0, semi_minor: 0.0, angle: 0.0 });
        let e = of(-7.0, 0.77, -0.084_700_000_000_000_07);
        assert!(e.semi_minor <= e.semi_major && e.semi_major < 1e-7, "{e:?}");
        assert_eq!((of(4.0, 0.0, -1.0).semi_major, of(4.0, 0.0, -1.0).semi_minor), (2.0, 0.0));
        let e = of(1e308, 0.0, 1e300);
        assert!((e.semi_major / 1e154 - 1.0).abs() < 1e-15 && (e.semi_minor / 1e150 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_radius_scales_both_axes() {
        let p = Matrix2::new(4.0, 0.0, 0.0, 1.0);
        let e = Ellipse::from_covariance(&p, 2.5);
        assert_eq!((e.semi_major, e.semi_minor), (5.0, 2.5));
    }
}
