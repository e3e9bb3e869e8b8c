//! The algebra of the linear filter, once, for sizes fixed at compile time and for sizes known at run time only.
//!
//! Sister volume, chapter 6; the Joseph form after Bucy and Joseph (1968). The typed faces are [`crate::kalman`] (fixed
//! sizes) and the chapter's run-time functions; both call these.

use crate::error::Error;
use crate::square_root;
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DefaultAllocator, Dim, OMatrix, OVector};
use numerics::{MIN_PIVOT, Spd, power_of_two, singular_values};

/// What a measurement update computes: the corrected belief, and what association and diagnostics need.
#[derive(Clone, Debug, PartialEq)]
pub struct Correction<N: Dim, M: Dim>
where
    DefaultAllocator: Allocator<N> + Allocator<N, N> + Allocator<M> + Allocator<M, M> + Allocator<N, M>,
{
    /// z − C x̄, the innovation.
    pub innovation: OVector<f64, M>,
    /// S = C Σ̄ Cᵀ + Q, its covariance.
    pub s: OMatrix<f64, M, M>,
    /// K = Σ̄ Cᵀ S⁻¹, the gain.
    pub k: OMatrix<f64, N, M>,
    /// d² = νᵀS⁻¹ν of the innovation ν; nothing where S is singular to working accuracy.
    pub d2: Option<f64>,
    /// The corrected mean, x̄ + K (z − C x̄), added in just this order.
    pub x: OVector<f64, N>,
    /// The corrected covariance.
    pub p: OMatrix<f64, N, N>,
}

/// The rounding that Joseph's form may leave, as a part of the largest variance: well within what a covariance is allowed
/// to be off by, 10⁻¹².
const MAX_ROUNDING: f64 = 5e-14;
/// What may stand below zero in a covariance that is carried on, as a part of its largest variance.
const MAX_NEGATIVE: f64 = 1e-13;

/// True when no entry is a NaN or an infinity.
pub fn is_finite<R: Dim, C: Dim>(m: &OMatrix<f64, R, C>) -> bool
where
    DefaultAllocator: Allocator<R, C>,
{
    numerics::all_finite(m.iter())
}

/// `m` when it is finite.
///
/// # Errors
/// [`Error::NotFinite`] naming `what`.
pub fn finite<R: Dim, C: Dim>(m: OMatrix<f64, R, C>, what: &'static str) -> Result<OMatrix<f64, R, C>, Error>
where
    DefaultAllocator: Allocator<R, C>,
{
    if is_finite(&m) { Ok(m) } else { Err(Error::NotFinite { what }) }
}

/// Σ̄ = A Σ Aᵀ + R (n×n), exactly symmetric and, to rounding, positive semidefinite even where the terms all but cancel.
/// Of Σ and R, which are symmetric, one triangle is read.
///
/// # Errors
/// [`Error::NotFinite`] when an argument is not finite or a product overflows.
pub fn predicted_covariance<N: Dim>(
    a: &OMatrix<f64, N, N>,
    p: &OMatrix<f64, N, N>,
    r: &OMatrix<f64, N, N>,
) -> Result<OMatrix<f64, N, N>, Error>
where
    DefaultAllocator: Allocator<N, N>,
{
    let mut predicted = congruence(a, p, r);
    mend(&mut predicted)?;
    Ok(predicted)
}

/// Makes sure that a prediction, however it was multiplied out, is a covariance; see [`predicted_covariance`].
///
/// # Errors
/// As [`predicted_covariance`].
// Called, it would read back from memory what was just multiplied out: a tenth of an EKF step in wasm.
#[inline(always)]
pub(crate) fn mend<N: Dim>(predicted: &mut OMatrix<f64, N, N>) -> Result<(), Error>
where
    DefaultAllocator: Allocator<N, N>,
{
    if !plainly_positive(predicted) {
        take(predicted, &verified(predicted.clone())?);
    }
    Ok(())
}

/// [`mended`] for any kind of size. What is usual need not be in memory for what is rare: here and below the rare ways take
/// copies, and do their work once for all sizes.
#[cold]
#[inline(never)]
fn verified<N: Dim>(predicted: OMatrix<f64, N, N>) -> Result<DMatrix<f64>, Error>
where
    DefaultAllocator: Allocator<N, N>,
{
    mended(run_time_sized(&predicted))
}

/// A predicted covariance, mended where its terms cancelled and rounding left a negative eigenvalue, be it this step's or
/// one that was nothing beside what Σ was before: a filter may shrink the largest eigenvalue by any factor, and would leave
/// the negative one standing beside it.
fn mended(predicted: DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
    let predicted = finite(predicted, "the predicted covariance")?;
    if semidefinite(&predicted) {
        return Ok(predicted);
    }
    Ok(clamped(&predicted).unwrap_or(predicted))
}

fn run_time_sized<R: Dim, C: Dim>(m: &OMatrix<f64, R, C>) -> DMatrix<f64>
where
    DefaultAllocator: Allocator<R, C>,
{
    DMatrix::from_iterator(m.nrows(), m.ncols(), m.iter().copied())
}

/// Makes `m` what a rare way answers. Entry by entry: taken over whole, the usual matrix would have to be in memory as well.
#[inline(always)]
fn take<R: Dim, C: Dim>(m: &mut OMatrix<f64, R, C>, answer: &DMatrix<f64>)
where
    DefaultAllocator: Allocator<R, C>,
{
    for j in 0..m.ncols() {
        for i in 0..m.nrows() {
            m[(i, j)] = answer[(i, j)];
        }
    }
}

/// S = C Σ̄ Cᵀ + Q (m×m), made exactly symmetric.
pub fn innovation_covariance<N: Dim, M: Dim>(
    c: &OMatrix<f64, M, N>,
    p: &OMatrix<f64, N, N>,
    q: &OMatrix<f64, M, M>,
) -> OMatrix<f64, M, M>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
{
    congruence(c, p, q)
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
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
{
    joseph_with(p, &(c * p), k, c, q)
}

/// [`joseph`] where CΣ̄ is at hand. With X = (I − KC) Σ̄ = Σ̄ − K(CΣ̄) it is X − (XCᵀ) Kᵀ + (KQ) Kᵀ: no product of two n×n
/// matrices is left, and X, small where the reading is precise, is still multiplied by what I − KC leaves of it. The last
/// term is added by itself: as a part of XCᵀ − KQ it would be lost in the rounding of X where Q is smallest.
#[inline]
fn joseph_with<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    cp: &OMatrix<f64, M, N>,
    k: &OMatrix<f64, N, M>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
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

/// M P Mᵀ + R (r×r) for a symmetric P, made exactly symmetric: the one triangle is computed and the other is its image.
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

/// I − KC (n×n): what is left of a prediction error after a correction with the gain K.
pub fn complement<N: Dim, M: Dim>(k: &OMatrix<f64, N, M>, c: &OMatrix<f64, M, N>) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M>,
{
    let n = k.shape_generic().0;
    OMatrix::identity_generic(n, n) - k * c
}

/// The optimal gain of a measurement, and what it leaves.
pub struct Gain<N: Dim, M: Dim>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, M> + Allocator<N, M>,
{
    /// K = Σ̄ Cᵀ S⁻¹ (n×m).
    pub k: OMatrix<f64, N, M>,
    /// S = C Σ̄ Cᵀ + Q (m×m).
    pub s: OMatrix<f64, M, M>,
    /// The corrected covariance (n×n).
    pub p: OMatrix<f64, N, N>,
    spd: Spd<M>,
}

impl<N: Dim, M: Dim> Gain<N, M>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, M> + Allocator<N, M> + Allocator<M>,
{
    /// d² = νᵀS⁻¹ν of an innovation; nothing where S is singular to working accuracy, or d² too large for a number.
    #[inline]
    pub fn d2(&self, innovation: &OVector<f64, M>) -> Option<f64> {
        let d2 = self.spd.squared_length(innovation);
        (self.spd.pivot() > 0.0 && d2.is_finite()).then_some(d2)
    }
}

/// The optimal gain for the predicted covariance `p`, with what it leaves of it.
///
/// Where S is so ill-conditioned that a factor of it would lose more than half of its digits (a pivot below
/// [`MIN_PIVOT`]), or the reading leaves so little of the variance that the rounding of the terms of Joseph's form would
/// show, gain and covariance come from an orthogonal factorization of square roots instead, which keeps them.
///
/// # Errors
/// [`Error::InnovationNotPositiveDefinite`] when S is singular even to that, [`Error::NotFinite`] when a product of
/// finite arguments overflows.
#[inline]
pub fn gain<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> Result<Gain<N, M>, Error>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
{
    let cp = c * p;
    let s = image(&cp, c, q);
    let spd = Spd::assumed(s.clone());
    let mut k = spd.solve(&cp).transpose();
    let mut posterior = joseph_with(p, &cp, &k, c, q);
    // Each entry of K has its square in the diagonal of KQKᵀ: a finite covariance has a finite gain.
    let sound =
        spd.pivot() >= MIN_PIVOT && bound_on_terms(p, &k, c) <= tolerated(&posterior) && plainly_positive(&posterior);
    if !sound {
        let given = (p.clone(), c.clone(), q.clone());
        let better = doubted(given, (s.clone(), spd.pivot()), (k.clone(), posterior.clone()))?;
        take(&mut k, &better[0]);
        take(&mut posterior, &better[1]);
    }
    Ok(Gain { k, s, p: posterior, spd })
}

/// [`examined`] for any kind of size.
#[cold]
#[inline(never)]
fn doubted<N: Dim, M: Dim>(
    (p, c, q): (OMatrix<f64, N, N>, OMatrix<f64, M, N>, OMatrix<f64, M, M>),
    (s, pivot): (OMatrix<f64, M, M>, f64),
    (k, posterior): (OMatrix<f64, N, M>, OMatrix<f64, N, N>),
) -> Result<[DMatrix<f64>; 2], Error>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
{
    let given = [run_time_sized(&p), run_time_sized(&c), run_time_sized(&q), run_time_sized(&s)];
    examined(given, pivot, [run_time_sized(&k), run_time_sized(&posterior)])
}

/// Gain and covariance of a correction whose rounding may show, looked at more closely: as they are where it does not, or by
/// square roots.
fn examined(
    [p, c, q, s]: [DMatrix<f64>; 4],
    pivot: f64,
    [k, posterior]: [DMatrix<f64>; 2],
) -> Result<[DMatrix<f64>; 2], Error> {
    let most = tolerated(&posterior);
    let kept = pivot >= MIN_PIVOT && (bound_on_terms(&p, &k, &c) <= most || largest_terms(&p, &k, &c) <= most);
    if kept && semidefinite(&posterior) {
        return Ok([k, posterior]);
    }
    finite(s, "S")?;
    let (k, posterior) = square_root::gain_and_covariance(&p, &c, &q)?;
    Ok([finite(k, "the gain")?, finite(posterior, "the covariance")?])
}

/// The largest terms of which the rounding does not show in a `posterior`.
fn tolerated<N: Dim>(posterior: &OMatrix<f64, N, N>) -> f64
where
    DefaultAllocator: Allocator<N, N>,
{
    MAX_ROUNDING / f64::EPSILON * largest_variance(posterior)
}

/// An upper bound on [`largest_terms`] by Cauchy and Schwarz, without a square root: good enough wherever a reading leaves
/// a fair part of the variance.
fn bound_on_terms<N: Dim, M: Dim>(p: &OMatrix<f64, N, N>, k: &OMatrix<f64, N, M>, c: &OMatrix<f64, M, N>) -> f64
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M>,
{
    let squares = |sum: f64, e: &f64| sum + e * e;
    let (k, c) = (k.iter().fold(0.0, squares), c.iter().fold(0.0, squares));
    largest_variance(p) * (2.0 + 2.0 * p.nrows() as f64 * k * c)
}

/// The largest variance that would be if nothing cancelled in (I − KC) Σ̄ (I − KC)ᵀ: what its rounding is a part of.
fn largest_terms(p: &DMatrix<f64>, k: &DMatrix<f64>, c: &DMatrix<f64>) -> f64 {
    let sigma = |i: usize| p[(i, i)].max(0.0).sqrt();
    let spread = |a: usize| (0..p.nrows()).map(|j| c[(a, j)].abs() * sigma(j)).sum::<f64>();
    let terms = |i: usize| sigma(i) + (0..c.nrows()).map(|a| k[(i, a)].abs() * spread(a)).sum::<f64>();
    (0..p.nrows()).map(|i| terms(i) * terms(i)).fold(0.0, f64::max)
}

/// Whether `p`, of at most three rows, is positive definite by far less than its rounding or more, and finite: its leading
/// minors, by an elimination that multiplies where [`Spd`] divides. The rounding of each step is that of a change in the
/// last digits of a diagonal entry; and a filter's next step need not wait for three divisions in a row. Where the products
/// leave the range of numbers the answer is false.
#[inline]
fn plainly_positive<N: Dim>(p: &OMatrix<f64, N, N>) -> bool
where
    DefaultAllocator: Allocator<N, N>,
{
    let in_range = |minor: f64| (f64::MIN_POSITIVE..=f64::MAX).contains(&minor);
    let eliminated = |i: usize, j: usize| p[(0, 0)] * p[(i, j)] - p[(i, 0)] * p[(j, 0)];
    match p.nrows() {
        1 => in_range(p[(0, 0)]),
        2 => p[(0, 0)] > 0.0 && in_range(eliminated(1, 1)),
        3 => {
            let (second, across) = (eliminated(1, 1), eliminated(2, 1));
            p[(0, 0)] > 0.0 && second > 0.0 && in_range(second * eliminated(2, 2) - across * across)
        }
        _ => false,
    }
}

/// Whether no eigenvalue of `p` lies below zero by more than [`MAX_NEGATIVE`] of its largest variance: raised by so much,
/// it has a factor. Also false when an entry is not finite.
fn semidefinite(p: &DMatrix<f64>) -> bool {
    let mut raised = p.clone();
    let lift = MAX_NEGATIVE * largest_variance(p) + f64::MIN_POSITIVE;
    for i in 0..p.nrows() {
        raised[(i, i)] += lift;
    }
    Spd::new(raised).is_some()
}

/// The covariance nearest to a symmetric `m`: its negative eigenvalues as zeros; `None` when an entry is not finite.
pub fn clamped(m: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let scale = power_of_two(m.amax());
    let scaled = m / scale;
    // Raised until no eigenvalue is negative, or a pair ±λ would share its singular value and with it its directions.
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

fn largest_variance<N: Dim>(p: &OMatrix<f64, N, N>) -> f64
where
    DefaultAllocator: Allocator<N, N>,
{
    (0..p.nrows()).fold(0.0, |largest, i| if p[(i, i)] > largest { p[(i, i)] } else { largest })
}

/// The measurement update of the belief N(x̄, Σ̄) with the reading z = Cx + noise of covariance Q.
///
/// # Errors
/// As [`gain`]; also [`Error::NotFinite`] for the innovation or the corrected mean.
pub fn correct<N: Dim, M: Dim>(
    x: &OVector<f64, N>,
    p: &OMatrix<f64, N, N>,
    z: &OVector<f64, M>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> Result<Correction<N, M>, Error>
where
    DefaultAllocator:
        Allocator<N> + Allocator<M> + Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
{
    let innovation = finite(z - c * x, "the innovation")?;
    let gain = gain(p, c, q)?;
    let (d2, Gain { k, s, p, .. }) = (gain.d2(&innovation), gain);
    let x = finite(x + &k * &innovation, "the mean")?;
    Ok(Correction { innovation, s, k, d2, x, p })
}

/// The product of the Gaussians (z₁, C₁) and (z₂, C₂), up to its scale (Theorem 8.2.1): mean z₁ + 𝒬(z₂ − z₁) and
/// covariance C₁ − 𝒬C₁ with 𝒬 = C₁(C₁ + C₂)⁻¹.
///
/// It is the correction of the belief (z₁, C₁) by a reading z₂ of the whole state with noise C₂, and is computed so.
///
/// # Errors
/// As [`correct`], C₁ + C₂ taking the place of S.
pub fn product<N: Dim>(
    z1: &OVector<f64, N>,
    c1: &OMatrix<f64, N, N>,
    z2: &OVector<f64, N>,
    c2: &OMatrix<f64, N, N>,
) -> Result<(OVector<f64, N>, OMatrix<f64, N, N>), Error>
where
    DefaultAllocator: Allocator<N> + Allocator<N, N>,
{
    let n = z1.shape_generic().0;
    let whole = OMatrix::identity_generic(n, n);
    let Correction { x, p, .. } = correct(z1, c1, z2, &whole, c2)?;
    Ok((x, p))
}

/// (M + Mᵀ)/2: rounding leaves products like APAᵀ symmetric only to the last digits.
pub fn symmetric<N: Dim>(m: OMatrix<f64, N, N>) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Allocator<N, N>,
{
    let mut m = m;
    for j in 0..m.ncols() {
        for i in j + 1..m.nrows() {
            let mean = 0.5 * m[(i, j)] + 0.5 * m[(j, i)];
            m[(i, j)] = mean;
            m[(j, i)] = mean;
        }
    }
    m
}

#[cfg(test)]
mod tests;
