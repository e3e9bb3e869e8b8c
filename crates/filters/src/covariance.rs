//! What counts as a covariance, and what is done with a matrix that is one only up to rounding.
//!
//! A covariance is symmetric and has no negative eigenvalue. Products like AΣAᵀ have both properties on paper; in
//! floating point each entry is off by a few units in the last place of the *largest* term of its sum. Where the terms
//! cancel, that may leave an eigenvalue below zero. It does no harm while it is small beside
//! the variances, but a filter may shrink those by any factor and leave the negative eigenvalue as it is. So every
//! covariance is checked where it enters and where it is carried on. One of three things happens: it is **accepted** as
//! it is; it is **mended**, which takes the negative eigenvalues away or computes it anew from square roots; or it is
//! **refused** with an error.
//!
//! | tolerance | is a part of | where it is asked | within it | beyond it |
//! |---|---|---|---|---|
//! | [`SYMMETRY_TOLERANCE`] 10⁻⁹ | the largest entry | a caller's covariance | mended: (M + Mᵀ)/2 | refused |
//! | [`SEMIDEFINITE_TOLERANCE`] 10⁻¹² | the largest eigenvalue | a caller's | mended: become 0 | refused |
//! | [`MAX_NEGATIVE`] 10⁻¹³ | the largest variance | a covariance that is carried on | accepted | mended |
//! | [`MAX_ROUNDING`] 5 · 10⁻¹⁴ | the largest variance left | Joseph's form | accepted | mended: from square roots |
//! | [`MAP_ROUNDING`] 2 · 10⁻¹³ | the largest variance | a large map | accepted unseen | factored, then as that says |
//! | [`MAX_CANCELLED`] 10⁸ | the smallest variance of S | the terms of S | accepted | looked at closely |
//! | [`MIN_PIVOT`] 10⁻⁸ | a variance of S | the factor of S | accepted | mended: from square roots |
//!
//! Each is so far below the one a caller meets, 10⁻¹², that what a filter answers is always accepted as its next
//! argument.

use crate::error::{Error, Quantity};
use crate::sizes::Sizes;
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DefaultAllocator, Dim, Matrix, OMatrix, RawStorage, RawStorageMut, SquareMatrix};
use numerics::{MIN_PIVOT, Spd, power_of_two, singular_values};

/// A caller's covariance may differ from its transpose by this part of its largest entry.
pub const SYMMETRY_TOLERANCE: f64 = 1e-9;
/// A caller's covariance may have an eigenvalue this far below zero, as a part of its largest.
pub const SEMIDEFINITE_TOLERANCE: f64 = 1e-12;
/// A covariance that is carried on may have an eigenvalue this far below zero, as a part of its largest variance.
pub const MAX_NEGATIVE: f64 = 1e-13;
/// The rounding that the terms of Joseph's form may leave, as a part of the largest variance.
pub const MAX_ROUNDING: f64 = 5e-14;
/// The rounding that may gather in a large map, as a part of its largest variance, before the map is looked over.
pub const MAP_ROUNDING: f64 = 2e-13;
/// So many times a variance of S its terms may be without anybody asking what their rounding has left.
pub const MAX_CANCELLED: f64 = 1e8;

/// Why a matrix is not accepted as a covariance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotCovariance {
    /// An entry is a NaN or an infinity.
    NotFinite,
    /// These two entries, (i, j) and (j, i), differ by more than [`SYMMETRY_TOLERANCE`] of the largest.
    NotSymmetric(usize, usize),
    /// An eigenvalue is negative by more than [`SEMIDEFINITE_TOLERANCE`] of the largest.
    NegativeEigenvalue,
    /// The eigenvalues were not found.
    DidNotConverge,
}

/// A caller's square matrix as a covariance: symmetric to the last bit, and without the negative eigenvalues that
/// rounding explains.
///
/// # Errors
/// [`NotCovariance`], when it is no covariance even up to rounding.
///
/// # Example
/// ```
/// use filters::covariance::{NotCovariance, accepted};
/// use nalgebra::dmatrix;
/// assert_eq!(accepted(dmatrix![2.0, 1.0 + 1e-12; 1.0, 2.0]).map(|m| m[(0, 1)] == m[(1, 0)]), Ok(true));
/// assert_eq!(accepted(dmatrix![1.0, 2.0; 2.0, 1.0]), Err(NotCovariance::NegativeEigenvalue));
/// ```
pub fn accepted(m: DMatrix<f64>) -> Result<DMatrix<f64>, NotCovariance> {
    if !is_finite(&m) {
        return Err(NotCovariance::NotFinite);
    }
    let largest = m.amax();
    for j in 0..m.ncols() {
        for i in j + 1..m.nrows() {
            if (m[(i, j)] - m[(j, i)]).abs() > SYMMETRY_TOLERANCE * largest {
                return Err(NotCovariance::NotSymmetric(i, j));
            }
        }
    }
    let m = symmetric(m);
    // Scaled, so that the factorization of a large covariance cannot overflow.
    let scaled = &m / largest;
    if largest == 0.0 || positive_when_raised(&scaled, 0.0) {
        return Ok(m);
    }
    let sizes = singular_values(scaled.clone()).map_err(|_| NotCovariance::DidNotConverge)?.values;
    if !positive_when_raised(&scaled, SEMIDEFINITE_TOLERANCE * sizes[0]) {
        return Err(NotCovariance::NegativeEigenvalue);
    }
    clamped(&m).ok_or(NotCovariance::DidNotConverge)
}

/// True when no entry is a NaN or an infinity.
pub fn is_finite<R: Dim, C: Dim>(m: &Matrix<f64, R, C, impl RawStorage<f64, R, C>>) -> bool {
    numerics::all_finite(m.iter())
}

/// `m` when it is finite.
///
/// # Errors
/// [`Error::NotFinite`] with `quantity`.
pub fn finite<R: Dim, C: Dim>(m: OMatrix<f64, R, C>, quantity: Quantity) -> Result<OMatrix<f64, R, C>, Error>
where
    DefaultAllocator: Allocator<R, C>,
{
    if is_finite(&m) { Ok(m) } else { Err(Error::NotFinite(quantity)) }
}

/// (M + Mᵀ)/2: rounding leaves products like APAᵀ symmetric only to the last digits.
pub fn symmetric<N: Dim>(mut m: OMatrix<f64, N, N>) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Allocator<N, N>,
{
    for j in 0..m.ncols() {
        for i in j + 1..m.nrows() {
            let mean = 0.5 * m[(i, j)] + 0.5 * m[(j, i)];
            m[(i, j)] = mean;
            m[(j, i)] = mean;
        }
    }
    m
}

/// Mends a predicted covariance where its terms cancelled and rounding left an eigenvalue below zero, in this step or
/// in an earlier one in which it was nothing beside the rest.
///
/// Answers whether it is [`regular`].
///
/// # Errors
/// [`Error::NotFinite`].
// In line: as a call it would read back from memory what was just computed.
#[inline(always)]
pub(crate) fn mend<N: Dim>(predicted: &mut OMatrix<f64, N, N>) -> Result<bool, Error>
where
    DefaultAllocator: Sizes<N>,
{
    if !plainly_positive(predicted) {
        let (mended, regular) = doubted(predicted.clone())?;
        copy(predicted, &mended);
        return Ok(regular);
    }
    Ok(true)
}

/// The rare way of [`mend`]. It takes a copy: a matrix whose address is taken would have to be kept in memory on the
/// usual way too.
#[cold]
#[inline(never)]
fn doubted<N: Dim>(predicted: OMatrix<f64, N, N>) -> Result<(DMatrix<f64>, bool), Error>
where
    DefaultAllocator: Sizes<N>,
{
    mended(at_run_time(&predicted))
}

/// [`mend`], compiled once for all sizes.
fn mended(predicted: DMatrix<f64>) -> Result<(DMatrix<f64>, bool), Error> {
    let predicted = finite(predicted, Quantity::PredictedCovariance)?;
    let regular = regular(&predicted);
    if regular || semidefinite(&predicted) {
        return Ok((predicted, regular));
    }
    Ok((clamped(&predicted).unwrap_or(predicted), false))
}

/// A copy whose size is known at run time only, for a rare way that is compiled once.
pub(crate) fn at_run_time<R: Dim, C: Dim>(m: &Matrix<f64, R, C, impl RawStorage<f64, R, C>>) -> DMatrix<f64> {
    DMatrix::from_iterator(m.nrows(), m.ncols(), m.iter().copied())
}

/// Copies the answer of a rare way into `m`, entry by entry: assigned as a whole, the usual matrix would have to be in
/// memory as well.
#[inline(always)]
pub(crate) fn copy<R: Dim, C: Dim>(m: &mut Matrix<f64, R, C, impl RawStorageMut<f64, R, C>>, answer: &DMatrix<f64>) {
    for j in 0..m.ncols() {
        for i in 0..m.nrows() {
            m[(i, j)] = answer[(i, j)];
        }
    }
}

/// Whether a matrix of at most four rows is finite and its leading minors say that it is regular, as [`regular`] means
/// it. The answer may be false for one whose products leave the range of numbers.
///
/// The elimination multiplies where [`Spd`] divides, so that a filter's next step does not wait for three divisions in
/// a row. Its rounding is that of a change in the last digits of the diagonal.
#[inline]
pub(crate) fn plainly_positive<N: Dim>(p: &SquareMatrix<f64, N, impl RawStorage<f64, N, N>>) -> bool {
    let in_range = |minor: f64| (f64::MIN_POSITIVE..=f64::MAX).contains(&minor);
    // What is left of the entry (i, j) once one column is eliminated, and once two are.
    let first = |i: usize, j: usize| p[(0, 0)] * p[(i, j)] - p[(i, 0)] * p[(j, 0)];
    let second = |i: usize, j: usize| first(1, 1) * first(i, j) - first(i, 1) * first(j, 1);
    // A minor over the one before it is a pivot; in second and third stand powers of those before.
    let part = |i: usize| MIN_PIVOT * p[(i, i)];
    let one = || p[(0, 0)] > 0.0;
    let two = || one() && first(1, 1) > part(1) * p[(0, 0)];
    let three = |unit: f64| two() && second(2, 2) > part(2) * unit;
    match p.nrows() {
        1 => in_range(p[(0, 0)]),
        2 => two() && in_range(first(1, 1)),
        3 => three(p[(0, 0)] * first(1, 1)) && in_range(second(2, 2)),
        4 => {
            let unit = p[(0, 0)] * first(1, 1);
            let third = second(2, 2) * second(3, 3) - second(3, 2) * second(3, 2);
            three(unit) && third > part(3) * (unit * second(2, 2)) && in_range(third)
        }
        _ => false,
    }
}

/// Whether `p` has a factor with no pivot below [`MIN_PIVOT`]: the rounding of its entries is then nothing beside it in
/// any direction, and stays so whatever a filter does with it.
pub(crate) fn regular(p: &DMatrix<f64>) -> bool {
    Spd::new(p.clone()).is_some_and(|factor| factor.pivot() >= MIN_PIVOT)
}

/// Whether no eigenvalue of `p` lies below zero by more than [`MAX_NEGATIVE`] of its largest variance. Also false when
/// an entry is not finite.
pub(crate) fn semidefinite(p: &DMatrix<f64>) -> bool {
    positive_when_raised(p, MAX_NEGATIVE * largest_variance(p) + f64::MIN_POSITIVE)
}

/// Whether `p` + `lift` · I is finite and positive definite: whether no eigenvalue of `p` lies below −`lift`.
pub fn positive_when_raised(p: &DMatrix<f64>, lift: f64) -> bool {
    let mut raised = p.clone();
    for i in 0..p.nrows() {
        raised[(i, i)] += lift;
    }
    Spd::new(raised).is_some()
}

/// The covariance nearest to a symmetric `m`: its negative eigenvalues become zero. `None` when an entry is not finite.
pub fn clamped(m: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let scale = power_of_two(m.amax());
    let scaled = m / scale;
    // Raised until no eigenvalue is negative: a pair ±λ would share its singular value and with it its directions.
    let raised = &scaled + DMatrix::identity(m.nrows(), m.ncols()) * (m.nrows() as f64);
    let directions = singular_values(raised).ok()?.directions;
    let mut kept = scaled.clone();
    for v in directions.column_iter() {
        let row = |i: usize| (0..m.ncols()).fold(0.0, |sum, j| sum + scaled[(i, j)] * v[j]);
        let eigenvalue = (0..m.nrows()).fold(0.0, |sum, i| sum + v[i] * row(i));
        if eigenvalue < 0.0 {
            for j in 0..m.ncols() {
                for i in 0..m.nrows() {
                    kept[(i, j)] -= eigenvalue * (v[i] * v[j]);
                }
            }
        }
    }
    Some(kept * scale)
}

/// The largest entry on the diagonal of `p`, or 0 when none is positive.
pub(crate) fn largest_variance<N: Dim>(p: &SquareMatrix<f64, N, impl RawStorage<f64, N, N>>) -> f64 {
    (0..p.nrows()).fold(0.0, |largest, i| if p[(i, i)] > largest { p[(i, i)] } else { largest })
}

#[cfg(test)]
mod tests;
