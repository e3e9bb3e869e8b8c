//! The algebra of the linear filter, once, for sizes fixed at compile time and for sizes known at run time only.
//!
//! Sister volume, chapter 6; the Joseph form after Bucy and Joseph (1968). The typed faces are [`crate::kalman`] (fixed
//! sizes) and the chapter's run-time functions; both call these.

use crate::error::Error;
pub use crate::jacobi::{jacobi, power_of_two};
use crate::square_root;
use geom::{MIN_PIVOT, Spd};
use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};

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
    /// The corrected mean, x̄ + K (z − C x̄), added in just this order.
    pub x: OVector<f64, N>,
    /// The corrected covariance.
    pub p: OMatrix<f64, N, N>,
}

/// The rounding that Joseph's form may leave, as a part of the largest variance: well within what a covariance is allowed
/// to be off by, 10⁻¹².
const MAX_ROUNDING: f64 = 5e-14;

/// True when no entry is a NaN or an infinity.
pub fn is_finite<R: Dim, C: Dim>(m: &OMatrix<f64, R, C>) -> bool
where
    DefaultAllocator: Allocator<R, C>,
{
    m.iter().all(|e| e.is_finite())
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

/// Σ̄ = A Σ Aᵀ + R (n×n), made exactly symmetric.
pub fn predicted_covariance<N: Dim>(
    a: &OMatrix<f64, N, N>,
    p: &OMatrix<f64, N, N>,
    r: &OMatrix<f64, N, N>,
) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Allocator<N, N>,
{
    symmetric(a * p * a.transpose() + r)
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
    symmetric(c * p * c.transpose() + q)
}

/// The covariance that **any** gain K leaves behind, in Joseph's form (I − KC) Σ̄ (I − KC)ᵀ + K Q Kᵀ (n×n).
///
/// A sum of two squares, hence positive semidefinite under rounding too; Σ̄ − KCΣ̄ equals it at the optimal gain only.
pub fn joseph<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    k: &OMatrix<f64, N, M>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
{
    let ikc = complement(k, c);
    symmetric(&ikc * p * ikc.transpose() + k * q * k.transpose())
}

/// I − KC (n×n): what is left of a prediction error after a correction with the gain K.
pub fn complement<N: Dim, M: Dim>(k: &OMatrix<f64, N, M>, c: &OMatrix<f64, M, N>) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M>,
{
    let n = k.shape_generic().0;
    OMatrix::identity_generic(n, n) - k * c
}

/// The gain K = Σ̄ Cᵀ S⁻¹ (n×m), S (m×m), and the corrected covariance, for the predicted covariance `p`.
///
/// Where S is so ill-conditioned that a factor of it would lose more than half of its digits (a pivot below
/// [`MIN_PIVOT`]), or the reading leaves so little of the variance that the rounding of the terms of Joseph's form would
/// show, gain and covariance come from an orthogonal factorization of square roots instead, which keeps them.
///
/// # Errors
/// [`Error::InnovationNotPositiveDefinite`] when S is singular even to that, [`Error::NotFinite`] when a product of
/// finite arguments overflows.
pub fn gain_and_covariance<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> Result<(OMatrix<f64, N, M>, OMatrix<f64, M, M>, OMatrix<f64, N, N>), Error>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
{
    let cp = c * p;
    let s = finite(symmetric(&cp * c.transpose() + q), "S")?;
    let factor = Spd::new(s.clone()).filter(|spd| spd.pivot() >= MIN_PIVOT && plainly_semidefinite(q));
    let joseph_form = factor.and_then(|spd| {
        let k = spd.solve(&cp).transpose();
        let posterior = joseph(p, &k, c, q);
        let sound = f64::EPSILON * largest_terms(p, &k, c) <= MAX_ROUNDING * largest_variance(&posterior);
        sound.then_some((k, posterior))
    });
    let (k, posterior) = match joseph_form {
        Some(answer) => answer,
        None => square_root::gain_and_covariance(p, c, q)?,
    };
    Ok((finite(k, "the gain")?, s, finite(posterior, "the covariance")?))
}

/// The largest variance that would be if nothing cancelled in (I − KC) Σ̄ (I − KC)ᵀ: what its rounding is a part of.
fn largest_terms<N: Dim, M: Dim>(p: &OMatrix<f64, N, N>, k: &OMatrix<f64, N, M>, c: &OMatrix<f64, M, N>) -> f64
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M>,
{
    let sigma = |i: usize| p[(i, i)].max(0.0).sqrt();
    let spread = |a: usize| (0..p.nrows()).map(|j| c[(a, j)].abs() * sigma(j)).sum::<f64>();
    let terms = |i: usize| sigma(i) + (0..c.nrows()).map(|a| k[(i, a)].abs() * spread(a)).sum::<f64>();
    (0..p.nrows()).map(|i| terms(i) * terms(i)).fold(0.0, f64::max)
}

/// Whether `q` is surely positive semidefinite: diagonally dominant, or with a Cholesky factor. What is so only up to the
/// rounding of its largest entry may leave a posterior of another scale that is not.
fn plainly_semidefinite<M: Dim>(q: &OMatrix<f64, M, M>) -> bool
where
    DefaultAllocator: Allocator<M, M>,
{
    let m = q.nrows();
    let beside = |i: usize| (0..m).filter(|&j| j != i).map(|j| q[(i, j)].abs()).sum::<f64>();
    (0..m).all(|i| q[(i, i)] >= beside(i)) || Spd::new(q.clone()).is_some()
}

fn largest_variance<N: Dim>(p: &OMatrix<f64, N, N>) -> f64
where
    DefaultAllocator: Allocator<N, N>,
{
    (0..p.nrows()).fold(0.0, |largest, i| p[(i, i)].max(largest))
}

/// The measurement update of the belief N(x̄, Σ̄) with the reading z = Cx + noise of covariance Q.
///
/// # Errors
/// As [`gain_and_covariance`]; also [`Error::NotFinite`] for the innovation or the corrected mean.
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
    let (k, s, p) = gain_and_covariance(p, c, q)?;
    let x = finite(x + &k * &innovation, "the mean")?;
    Ok(Correction { innovation, s, k, x, p })
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
mod tests {
    use super::*;
    use nalgebra::{Matrix1, Matrix2, RowVector2};

    #[test]
    fn noise_adds_to_what_the_dynamics_and_the_sensor_make_of_p() {
        let p = Matrix2::new(3.0, 1.0, 1.0, 2.0);
        let (a, r) = (Matrix2::new(1.0, 2.0, 0.0, 1.0), Matrix2::new(0.5, 0.25, 0.25, 0.125));
        assert_eq!(predicted_covariance(&a, &p, &r), Matrix2::new(15.5, 5.25, 5.25, 2.125));
        let (c, q) = (RowVector2::new(1.0, 2.0), Matrix1::new(0.75));
        assert_eq!(innovation_covariance(&c, &p, &q), Matrix1::new(15.75));
    }
}
