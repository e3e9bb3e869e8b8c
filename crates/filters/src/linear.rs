//! The algebra of the linear filter, once, for sizes fixed at compile time and for sizes known at run time only.
//!
//! Sister volume, chapter 6; the Joseph form after Bucy and Joseph (1968). [`Gaussian`](crate::Gaussian) and
//! [`Kf`](crate::Kf) put it together.

use crate::covariance::{MAX_CANCELLED, at_run_time, copy, mend, plainly_positive};
use crate::error::Error;
use crate::sizes::Sizes;
use crate::square_root::{self, Correction};
use crate::terms::{bound_on_sums, bound_on_terms, least_variance, tolerated};
use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};
use numerics::{MIN_PIVOT, Spd};

/// Σ̄ = A Σ Aᵀ + R (n×n), exactly symmetric and, to rounding, positive semidefinite even where the terms all but
/// cancel. Σ and R are symmetric, and one triangle of each is read.
///
/// # Errors
/// [`Error::NotFinite`] when an argument is not finite or a product overflows.
///
/// # Example
/// ```
/// use nalgebra::Matrix2;
/// let (a, p) = (Matrix2::new(1.0, 0.5, 0.0, 1.0), Matrix2::new(1.0, 0.0, 0.0, 2.0));
/// let r = Matrix2::new(0.2, 0.05, 0.05, 0.1);
/// assert_eq!(filters::linear::predicted_covariance(&a, &p, &r)?, Matrix2::new(1.7, 1.05, 1.05, 2.1));
/// # Ok::<(), filters::Error>(())
/// ```
pub fn predicted_covariance<N: Dim>(
    a: &OMatrix<f64, N, N>,
    p: &OMatrix<f64, N, N>,
    r: &OMatrix<f64, N, N>,
) -> Result<OMatrix<f64, N, N>, Error>
where
    DefaultAllocator: Sizes<N>,
{
    let mut predicted = congruence(a, p, r);
    mend(&mut predicted)?;
    Ok(predicted)
}

/// S = C Σ̄ Cᵀ + Q (m×m), exactly symmetric, as it is multiplied out. Where the terms cancel it may have a negative
/// eigenvalue, and has none in what [`gain`] answers.
pub fn innovation_covariance<N: Dim, M: Dim>(
    c: &OMatrix<f64, M, N>,
    p: &OMatrix<f64, N, N>,
    q: &OMatrix<f64, M, M>,
) -> OMatrix<f64, M, M>
where
    DefaultAllocator: Sizes<N, M>,
{
    congruence(c, p, q)
}

/// M P Mᵀ + R (r×r) for a symmetric P, exactly symmetric: one triangle is computed and the other copied from it.
#[inline]
pub(crate) fn congruence<N: Dim, R: Dim>(
    m: &OMatrix<f64, R, N>,
    p: &OMatrix<f64, N, N>,
    r: &OMatrix<f64, R, R>,
) -> OMatrix<f64, R, R>
where
    DefaultAllocator: Allocator<N, N> + Allocator<R, N> + Allocator<R, R>,
{
    image(&(m * p), m, r)
}

/// X Mᵀ + R (r×r) for X = MP: the second half of a [`congruence`].
#[inline]
fn image<N: Dim, R: Dim>(x: &OMatrix<f64, R, N>, m: &OMatrix<f64, R, N>, r: &OMatrix<f64, R, R>) -> OMatrix<f64, R, R>
where
    DefaultAllocator: Allocator<R, N> + Allocator<R, R>,
{
    let mut image = r.clone_owned();
    for j in 0..m.nrows() {
        for i in j..m.nrows() {
            let entry = (0..m.ncols()).fold(r[(i, j)], |sum, k| sum + x[(i, k)] * m[(j, k)]);
            image[(i, j)] = entry;
            image[(j, i)] = entry;
        }
    }
    image
}

/// I − KC (n×n): the part of a prediction error that a correction with the gain K leaves.
pub fn complement<N: Dim, M: Dim>(k: &OMatrix<f64, N, M>, c: &OMatrix<f64, M, N>) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Sizes<N, M>,
{
    let n = k.shape_generic().0;
    OMatrix::identity_generic(n, n) - k * c
}

/// The covariance that **any** gain K leaves behind, in Joseph's form (I − KC) Σ̄ (I − KC)ᵀ + K Q Kᵀ (n×n).
///
/// A sum of two squares, hence positive semidefinite but for the rounding of its products; Σ̄ − KCΣ̄ equals it at the
/// optimal gain only.
pub fn joseph<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    k: &OMatrix<f64, N, M>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Sizes<N, M>,
{
    joseph_with(p, &(c * p), k, c, q)
}

/// [`joseph`] for a caller that has CΣ̄ already. With X = (I − KC) Σ̄ = Σ̄ − K(CΣ̄) it is X − (XCᵀ) Kᵀ + (KQ) Kᵀ: no
/// product of two n×n matrices is left, and X, small where the reading is precise, is still multiplied by what I − KC
/// leaves of it. The last term is added by itself: as a part of XCᵀ − KQ it would be lost in the rounding of X where Q
/// is smallest.
#[inline]
fn joseph_with<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    cp: &OMatrix<f64, M, N>,
    k: &OMatrix<f64, N, M>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Sizes<N, M>,
{
    let x = p - k * cp;
    let (xc, kq) = (&x * c.transpose(), k * q);
    let mut posterior = x;
    for j in 0..p.nrows() {
        for i in j..p.nrows() {
            let left = (0..c.nrows()).fold(posterior[(i, j)], |left, a| left - xc[(i, a)] * k[(j, a)]);
            let entry = (0..c.nrows()).fold(left, |sum, a| sum + kq[(i, a)] * k[(j, a)]);
            posterior[(i, j)] = entry;
            posterior[(j, i)] = entry;
        }
    }
    posterior
}

/// The optimal gain of a reading, and the covariance that it leaves.
pub struct Gain<N: Dim, M: Dim>
where
    DefaultAllocator: Sizes<N, M>,
{
    /// K = Σ̄ Cᵀ S⁻¹ (n×m).
    pub k: OMatrix<f64, N, M>,
    /// S = C Σ̄ Cᵀ + Q (m×m), positive semidefinite to rounding, with a positive diagonal.
    pub s: OMatrix<f64, M, M>,
    /// The corrected covariance (n×n).
    pub p: OMatrix<f64, N, N>,
    /// Whether the numbers gave cause to look closer.
    pub doubted: bool,
    factor: Spd<M>,
}

impl<N: Dim, M: Dim> Gain<N, M>
where
    DefaultAllocator: Sizes<N, M>,
{
    /// d² = νᵀS⁻¹ν of an innovation; `None` where S is singular to working accuracy, or d² too large for a number.
    #[inline]
    pub fn d2(&self, innovation: &OVector<f64, M>) -> Option<f64> {
        let d2 = self.factor.squared_length(innovation);
        (self.factor.pivot() > 0.0 && d2.is_finite()).then_some(d2)
    }
}

/// The optimal gain for the predicted covariance `p` and a reading z = C x + noise of covariance Q, with the covariance
/// that it leaves.
///
/// Where S is so ill-conditioned that a factor of it would lose more than half of its digits (a pivot below
/// [`MIN_PIVOT`]), or the reading leaves so little of the variance that the rounding of the terms of Joseph's form
/// would show, S, gain and covariance come from an orthogonal factorization of square roots instead, which keeps them.
///
/// # Errors
/// [`Error::InnovationNotPositiveDefinite`] when S is singular even to that, [`Error::NotFinite`] when an argument is
/// not finite or a product overflows.
///
/// # Example
/// ```
/// use nalgebra::{Matrix1, Matrix2, RowVector2};
/// let p = Matrix2::new(1.7, 1.05, 1.05, 2.1);
/// let gain = filters::linear::gain(&p, &RowVector2::new(0.0, 1.0), &Matrix1::new(0.5))?;
/// assert!((gain.s[0] - 2.6).abs() < 1e-15 && (gain.k[1] - 21.0 / 26.0).abs() < 1e-15);
/// # Ok::<(), filters::Error>(())
/// ```
#[inline]
pub fn gain<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> Result<Gain<N, M>, Error>
where
    DefaultAllocator: Sizes<N, M>,
{
    gain_in_line(p, c, q)
}

/// A variance of S that a closer look changes by a smaller part is the one that was factored.
const SAME_S: f64 = 1e-9;

/// [`gain`] in line: of few states, an answer that is handed over in memory may cost more than its arithmetic.
#[inline(always)]
pub(crate) fn gain_in_line<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> Result<Gain<N, M>, Error>
where
    DefaultAllocator: Sizes<N, M>,
{
    let cp = c * p;
    let mut s = image(&cp, c, q);
    let mut factor = Spd::assumed(s.clone());
    let mut k = factor.solve(&cp).transpose();
    let mut posterior = joseph_with(p, &cp, &k, c, q);
    // Each entry of K has its square in the diagonal of KQKᵀ: a finite covariance has a finite gain.
    let sound = factor.pivot() >= MIN_PIVOT
        && bound_on_terms(p, &k, c) <= tolerated(&posterior)
        && bound_on_sums(p, c) <= MAX_CANCELLED * least_variance(&s)
        && plainly_positive(&posterior);
    let mut doubted = false;
    if !sound {
        let given = (p.clone(), c.clone(), q.clone());
        let better = examined(given, factor.pivot(), (s.clone(), k.clone(), posterior.clone()))?;
        let close = |i: usize| (better.s[(i, i)] - s[(i, i)]).abs() <= SAME_S * s[(i, i)];
        let same = factor.pivot() >= MIN_PIVOT && (0..s.nrows()).all(close);
        copy(&mut s, &better.s);
        copy(&mut k, &better.k);
        copy(&mut posterior, &better.p);
        // d² is of the S that is answered.
        if !same {
            factor = Spd::assumed(s.clone());
        }
        doubted = better.doubted;
    }
    Ok(Gain { k, s, p: posterior, doubted, factor })
}

/// The rare way of [`gain`], compiled once for all sizes. It takes copies: a matrix whose address is taken would have
/// to be kept in memory on the usual way too.
#[cold]
#[inline(never)]
fn examined<N: Dim, M: Dim>(
    (p, c, q): (OMatrix<f64, N, N>, OMatrix<f64, M, N>, OMatrix<f64, M, M>),
    pivot: f64,
    (s, k, posterior): (OMatrix<f64, M, M>, OMatrix<f64, N, M>, OMatrix<f64, N, N>),
) -> Result<Correction, Error>
where
    DefaultAllocator: Sizes<N, M>,
{
    let found = Correction { s: at_run_time(&s), k: at_run_time(&k), p: at_run_time(&posterior), doubted: true };
    square_root::examined([at_run_time(&p), at_run_time(&c), at_run_time(&q)], pivot, found)
}

#[cfg(test)]
mod tests;
