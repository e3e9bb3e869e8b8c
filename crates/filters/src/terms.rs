//! How large the terms of a correction are beside what is left of them: where they cancel, their rounding shows.

use crate::covariance::{MAX_ROUNDING, largest_variance};
use crate::sizes::Sizes;
use nalgebra::{DMatrix, DefaultAllocator, Dim, OMatrix, RawStorage, SquareMatrix};
use numerics::sqrt;

/// The smallest entry on the diagonal of `s`.
pub(crate) fn least_variance<M: Dim>(s: &SquareMatrix<f64, M, impl RawStorage<f64, M, M>>) -> f64 {
    (0..s.nrows()).fold(f64::INFINITY, |least, i| if s[(i, i)] < least { s[(i, i)] } else { least })
}

/// The largest terms of Joseph's form whose rounding does not show in a `posterior`.
pub(crate) fn tolerated<N: Dim>(posterior: &SquareMatrix<f64, N, impl RawStorage<f64, N, N>>) -> f64 {
    MAX_ROUNDING / f64::EPSILON * largest_variance(posterior)
}

/// An upper bound on [`largest_terms`] by Cauchy and Schwarz, without a square root: good enough wherever a reading
/// leaves a fair part of the variance.
pub(crate) fn bound_on_terms<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    k: &OMatrix<f64, N, M>,
    c: &OMatrix<f64, M, N>,
) -> f64
where
    DefaultAllocator: Sizes<N, M>,
{
    let squares = |sum: f64, e: &f64| sum + e * e;
    let (k, c) = (k.iter().fold(0.0, squares), c.iter().fold(0.0, squares));
    largest_variance(p) * (2.0 + 2.0 * p.nrows() as f64 * k * c)
}

/// An upper bound on the terms of CΣ̄Cᵀ, in the same way.
pub(crate) fn bound_on_sums<N: Dim, M: Dim>(p: &OMatrix<f64, N, N>, c: &OMatrix<f64, M, N>) -> f64
where
    DefaultAllocator: Sizes<N, M>,
{
    largest_variance(p) * (p.nrows() as f64 * c.iter().fold(0.0, |sum, e| sum + e * e))
}

/// The largest variance that (I − KC) Σ̄ (I − KC)ᵀ would have if nothing cancelled: its rounding is a part of that.
pub(crate) fn largest_terms(p: &DMatrix<f64>, k: &DMatrix<f64>, c: &DMatrix<f64>) -> f64 {
    let sigma = |i: usize| sqrt(p[(i, i)].max(0.0));
    let spread = |a: usize| (0..p.nrows()).map(|j| c[(a, j)].abs() * sigma(j)).sum::<f64>();
    let terms = |i: usize| sigma(i) + (0..c.nrows()).map(|a| k[(i, a)].abs() * spread(a)).sum::<f64>();
    (0..p.nrows()).map(|i| terms(i) * terms(i)).fold(0.0, f64::max)
}
