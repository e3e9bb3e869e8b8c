//! Solves with a symmetric positive definite matrix, and says how far from singular it was.

use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix};

/// The smallest pivot an [`Spd`] is trusted with, in the sense of [`Spd::pivot`]: below it a solve keeps fewer than
/// eight of its sixteen digits.
pub const MIN_PIVOT: f64 = 1e-8;

/// A Cholesky factor S = LLᵀ of a finite, numerically positive definite S.
///
/// Not nalgebra's: that one takes its square roots from `libm`, which computes them in software in wasm, ten times as
/// long as the rest of the step; and it answers an infinite matrix with an infinite factor.
pub struct Spd<D: Dim>
where
    DefaultAllocator: Allocator<D, D>,
{
    /// In the lower triangle; the upper one is that of S.
    l: OMatrix<f64, D, D>,
    pivot: f64,
}

impl<D: Dim> Spd<D>
where
    DefaultAllocator: Allocator<D, D>,
{
    /// Factors `s`, of which the lower triangle is read; `None` when an entry is not finite or a pivot not positive.
    pub fn new(s: OMatrix<f64, D, D>) -> Option<Self> {
        if s.iter().any(|e| !e.is_finite()) {
            return None;
        }
        let (n, mut l, mut pivot) = (s.nrows(), s, 1.0_f64);
        for j in 0..n {
            let variance = l[(j, j)];
            let unexplained = (0..j).fold(variance, |rest, k| rest - l[(j, k)] * l[(j, k)]);
            // Written so that a NaN, which an overflow leaves, is refused too.
            let positive = unexplained > 0.0 && unexplained.is_finite();
            if !positive {
                return None;
            }
            pivot = pivot.min(unexplained / variance);
            let root = unexplained.sqrt();
            l[(j, j)] = root;
            for i in j + 1..n {
                l[(i, j)] = (0..j).fold(l[(i, j)], |rest, k| rest - l[(i, k)] * l[(j, k)]) / root;
            }
        }
        Some(Self { l, pivot })
    }

    /// The smallest Lᵢᵢ² / Sᵢᵢ, in (0, 1]: the part of component i's variance that the components before it do not
    /// explain, whatever the units. Near 2⁻⁵² nothing but rounding is left.
    pub fn pivot(&self) -> f64 {
        self.pivot
    }

    /// L.
    pub fn root(&self) -> OMatrix<f64, D, D> {
        self.l.lower_triangle()
    }

    /// ln det S.
    pub fn ln_determinant(&self) -> f64 {
        (0..self.l.nrows()).map(|i| 2.0 * libm::log(self.l[(i, i)])).sum()
    }

    /// S⁻¹ B.
    pub fn solve<C: Dim>(&self, b: &OMatrix<f64, D, C>) -> OMatrix<f64, D, C>
    where
        DefaultAllocator: Allocator<D, C>,
    {
        let (l, n, mut x) = (&self.l, self.l.nrows(), b.clone());
        for c in 0..x.ncols() {
            for i in 0..n {
                x[(i, c)] = (0..i).fold(x[(i, c)], |rest, k| rest - l[(i, k)] * x[(k, c)]) / l[(i, i)];
            }
            for i in (0..n).rev() {
                x[(i, c)] = (i + 1..n).fold(x[(i, c)], |rest, k| rest - l[(k, i)] * x[(k, c)]) / l[(i, i)];
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
    }

    #[test]
    fn what_is_not_positive_definite_or_not_finite_is_refused() {
        assert!(Spd::new(Matrix2::new(1.0, 2.0, 2.0, 1.0)).is_none());
        assert!(Spd::new(Matrix2::new(0.0, 0.0, 0.0, 1.0)).is_none());
        assert!(Spd::new(Matrix2::new(f64::INFINITY, 0.0, 0.0, 1.0)).is_none());
        assert!(Spd::new(dmatrix![1.0, 0.0; 0.0, f64::NAN]).is_none());
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
