//! A factorization of symmetric positive definite matrices, with solves and a measure of how near to singular they are.

use crate::sqrt;
use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};

/// The smallest pivot an [`Spd`] is trusted with, in the sense of [`Spd::pivot`]: below it a solve keeps fewer than
/// eight of its sixteen digits.
pub const MIN_PIVOT: f64 = 1e-8;

/// A factorization S = LDLᵀ of a finite, numerically positive definite S, with ones on the diagonal of L.
///
/// Not nalgebra's Cholesky: without the standard library that one takes its square roots from `libm`, which may compute
/// them in software; and it answers an infinite matrix with an infinite factor. Without square roots, and with one
/// division for each pivot, a solve costs little more than its products.
///
/// # Example
/// ```
/// use nalgebra::{Matrix2, Vector2};
/// let spd = numerics::Spd::new(Matrix2::new(4.0, 2.0, 2.0, 3.0)).expect("positive definite");
/// assert_eq!(spd.solve(&Vector2::new(8.0, 8.0)), Vector2::new(1.0, 2.0));
/// // What is left of the second variance, 3, once the first component is known, is 3 − 2²/4.
/// assert_eq!(spd.pivot(), 2.0 / 3.0);
/// assert!(numerics::Spd::new(Matrix2::new(1.0, 2.0, 2.0, 1.0)).is_none());
/// ```
pub struct Spd<M: Dim>
where
    DefaultAllocator: Allocator<M, M>,
{
    /// L below the diagonal, D⁻¹ on it, DLᵀ above.
    factor: OMatrix<f64, M, M>,
    pivot: f64,
}

impl<M: Dim> Spd<M>
where
    DefaultAllocator: Allocator<M, M>,
{
    /// Factors `s`, of which the lower triangle is read; `None` when an entry of it is not finite, or a pivot is
    /// smaller than the smallest normal number.
    #[inline]
    pub fn new(s: OMatrix<f64, M, M>) -> Option<Self> {
        let factored = Self::assumed(s);
        (factored.pivot > 0.0).then_some(factored)
    }

    /// Factors `s` as if it were positive definite. If it is not, [`Spd::pivot`] is 0 and no other answer of this
    /// factor means anything. A step can so compute its whole result first, and check the pivot once at the end.
    #[inline]
    pub fn assumed(s: OMatrix<f64, M, M>) -> Self {
        let (n, mut f, mut pivot) = (s.nrows(), s, 1.0_f64);
        for j in 0..n {
            let variance = f[(j, j)];
            let unexplained = (0..j).fold(variance, |rest, k| rest - f[(j, k)] * f[(k, j)]);
            // A NaN or an infinity in `s` leaves a pivot outside this range; within it the reciprocal is finite.
            if !(f64::MIN_POSITIVE..=f64::MAX).contains(&unexplained) {
                return Self { factor: f, pivot: 0.0 };
            }
            let reciprocal = 1.0 / unexplained;
            let part = unexplained / variance;
            if j > 0 && part < pivot {
                pivot = part;
            }
            f[(j, j)] = reciprocal;
            for i in j + 1..n {
                let unscaled = (0..j).fold(f[(i, j)], |rest, k| rest - f[(i, k)] * f[(k, j)]);
                f[(j, i)] = unscaled;
                f[(i, j)] = unscaled * reciprocal;
            }
        }
        Self { factor: f, pivot }
    }

    /// The smallest Dᵢᵢ / Sᵢᵢ, in (0, 1]: the part of component i's variance that the components before it do not
    /// explain, whatever the units. Near 2⁻⁵² nothing but rounding is left.
    #[inline]
    pub fn pivot(&self) -> f64 {
        self.pivot
    }

    /// The Cholesky factor L√D, whose product with its transpose is S.
    pub fn root(&self) -> OMatrix<f64, M, M> {
        let mut root = self.factor.lower_triangle();
        for j in 0..root.ncols() {
            let sigma = sqrt(1.0 / root[(j, j)]);
            for i in j + 1..root.nrows() {
                root[(i, j)] *= sigma;
            }
            root[(j, j)] = sigma;
        }
        root
    }

    /// ln det S.
    pub fn ln_determinant(&self) -> f64 {
        -(0..self.factor.nrows()).map(|i| libm::log(self.factor[(i, i)])).sum::<f64>()
    }

    /// vᵀS⁻¹v, the squared Mahalanobis length of `v`.
    #[inline]
    pub fn squared_length(&self, v: &OVector<f64, M>) -> f64
    where
        DefaultAllocator: Allocator<M>,
    {
        v.dot(&self.solve(v))
    }

    /// S⁻¹ B.
    #[inline]
    pub fn solve<C: Dim>(&self, b: &OMatrix<f64, M, C>) -> OMatrix<f64, M, C>
    where
        DefaultAllocator: Allocator<M, C>,
    {
        let (f, n, mut x) = (&self.factor, self.factor.nrows(), b.clone());
        for c in 0..x.ncols() {
            for i in 1..n {
                x[(i, c)] = (0..i).fold(x[(i, c)], |rest, k| rest - f[(i, k)] * x[(k, c)]);
            }
            for i in (0..n).rev() {
                x[(i, c)] = (i + 1..n).fold(f[(i, i)] * x[(i, c)], |rest, k| rest - f[(k, i)] * x[(k, c)]);
            }
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Vector2, dmatrix};

    #[test]
    fn solve_inverts_the_product() {
        let s = Matrix2::new(4.0, 1.0, 1.0, 3.0);
        let b = Vector2::new(1.0, -2.0);
        let x = Spd::new(s).expect("positive definite").solve(&b);
        assert!((s * x - b).norm() < 1e-15);
        let length = Spd::new(s).expect("positive definite").squared_length(&b);
        assert!((length - b.dot(&x)).abs() < 1e-15 && (length - 23.0 / 11.0).abs() < 1e-14);
    }

    #[test]
    fn a_matrix_that_is_not_positive_definite_or_not_finite_is_refused() {
        assert!(Spd::new(Matrix2::new(1.0, 2.0, 2.0, 1.0)).is_none());
        assert!(Spd::new(Matrix2::new(0.0, 0.0, 0.0, 1.0)).is_none());
        assert!(Spd::new(Matrix2::new(f64::INFINITY, 0.0, 0.0, 1.0)).is_none());
        assert!(Spd::new(dmatrix![1.0, 0.0; 0.0, f64::NAN]).is_none());
    }

    #[test]
    fn a_matrix_wrongly_assumed_positive_definite_has_a_pivot_of_zero() {
        let s = Matrix2::new(4.0, 1.0, 1.0, 3.0);
        assert!((Spd::assumed(s).pivot() - 2.75 / 3.0).abs() < 1e-15);
        for bad in [Matrix2::new(1.0, 2.0, 2.0, 1.0), Matrix2::zeros(), s * f64::INFINITY, s * f64::NAN] {
            assert_eq!(Spd::assumed(bad).pivot(), 0.0, "{bad}");
        }
    }

    #[test]
    fn the_pivot_does_not_depend_on_units() {
        let s = Matrix2::new(1.0, 0.6, 0.6, 1.0);
        let scaled = Matrix2::new(1e-12, 0.6, 0.6, 1e12);
        for m in [s, scaled] {
            let pivot = Spd::new(m).expect("positive definite").pivot();
            assert!((pivot - 0.64).abs() < 1e-15, "{pivot}");
        }
    }
}
