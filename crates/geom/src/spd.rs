//! Solves with a symmetric positive definite matrix, and says how far from singular it was.

use nalgebra::allocator::Allocator;
use nalgebra::{Cholesky, DefaultAllocator, Dim, OMatrix};

/// The smallest pivot an [`Spd`] is trusted with, in the sense of [`Spd::pivot`]: below it a solve keeps fewer than
/// eight of its sixteen digits.
pub const MIN_PIVOT: f64 = 1e-8;

/// A Cholesky factor S = LLᵀ of a finite, numerically positive definite S.
pub struct Spd<D: Dim>
where
    DefaultAllocator: Allocator<D, D>,
{
    factor: Cholesky<f64, D>,
    pivot: f64,
}

impl<D: Dim> Spd<D>
where
    DefaultAllocator: Allocator<D, D>,
{
    /// Factors `s`, of which the lower triangle is read; `None` when an entry is not finite or a pivot not positive.
    pub fn new(s: OMatrix<f64, D, D>) -> Option<Self> {
        // nalgebra's Cholesky answers an infinite matrix with an infinite factor.
        if s.iter().any(|e| !e.is_finite()) {
            return None;
        }
        let factor = Cholesky::new(s.clone())?;
        let l = factor.l_dirty();
        let mut pivot = 1.0_f64;
        for i in 0..s.nrows() {
            pivot = pivot.min(l[(i, i)] * l[(i, i)] / s[(i, i)]);
        }
        Some(Self { factor, pivot })
    }

    /// The smallest Lᵢᵢ² / Sᵢᵢ, in (0, 1]: the part of component i's variance that the components before it do not
    /// explain, whatever the units. Near 2⁻⁵² nothing but rounding is left.
    pub fn pivot(&self) -> f64 {
        self.pivot
    }

    /// ln det S.
    pub fn ln_determinant(&self) -> f64 {
        let l = self.factor.l_dirty();
        (0..l.nrows()).map(|i| 2.0 * libm::log(l[(i, i)])).sum()
    }

    /// S⁻¹ B.
    pub fn solve<C: Dim>(&self, b: &OMatrix<f64, D, C>) -> OMatrix<f64, D, C>
    where
        DefaultAllocator: Allocator<D, C>,
    {
        self.factor.solve(b)
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
