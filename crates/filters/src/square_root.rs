//! The measurement update in square-root (array) form, for an innovation covariance too near to singular to be factored.
//!
//! With Q = QₗQₗᵀ and Σ̄ = ΣₗΣₗᵀ, one orthogonal factorization
//!
//! ```text
//! ⎡ Qₗᵀ      0  ⎤        ⎡ S^{T/2}  S^{−1/2} C Σ̄ ⎤
//! ⎣ ΣₗᵀCᵀ   Σₗᵀ ⎦  = Θ · ⎣    0        Σ^{T/2}    ⎦
//! ```
//!
//! holds the square roots of S and of the corrected Σ without ever forming S, so condition numbers enter as their square
//! roots (Kaminski, Bryson and Schmidt 1971; Anderson and Moore, Optimal Filtering, §6.5).

use crate::error::Error;
use crate::linear::finite;
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DefaultAllocator, Dim, OMatrix, SymmetricEigen};

/// The smallest |Sᵢᵢ^{½}| relative to its column that still leaves six digits of the answer.
const MIN_ROOT_PIVOT: f64 = 1e-10;

/// A symmetric matrix of the sizes met here needs a few iterations a row; past this one does not converge.
const MAX_ITERATIONS: usize = 1000;

/// The gain and the corrected covariance for the predicted covariance `p`; see [`crate::linear::gain_and_covariance`].
///
/// The array has m + n rows, a size that no const parameter can name: hence `DMatrix`, on this rare path only.
pub(crate) fn gain_and_covariance<N: Dim, M: Dim>(
    p: &OMatrix<f64, N, N>,
    c: &OMatrix<f64, M, N>,
    q: &OMatrix<f64, M, M>,
) -> Result<(OMatrix<f64, N, M>, OMatrix<f64, N, N>), Error>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>,
{
    let ((n, _), (m, _)) = (p.shape_generic(), c.shape_generic());
    let (k, posterior) = array_update(&run_time_sized(p), &run_time_sized(c), &run_time_sized(q))?;
    Ok((
        OMatrix::from_iterator_generic(n, m, k.iter().copied()),
        OMatrix::from_iterator_generic(n, n, posterior.iter().copied()),
    ))
}

fn run_time_sized<R: Dim, C: Dim>(m: &OMatrix<f64, R, C>) -> DMatrix<f64>
where
    DefaultAllocator: Allocator<R, C>,
{
    DMatrix::from_iterator(m.nrows(), m.ncols(), m.iter().copied())
}

fn array_update(p: &DMatrix<f64>, c: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<(DMatrix<f64>, DMatrix<f64>), Error> {
    let (m, n) = c.shape();
    let (root_p, root_q) = (root(p)?, root(q)?);
    let mut array = DMatrix::zeros(m + n, m + n);
    array.view_mut((0, 0), (m, m)).copy_from(&root_q.transpose());
    array.view_mut((m, 0), (n, m)).copy_from(&(c * &root_p).transpose());
    array.view_mut((m, m), (n, n)).copy_from(&root_p.transpose());
    let r = array.qr().r();

    let root_s = r.view((0, 0), (m, m));
    for i in 0..m {
        // Written so that a zero column and a NaN are refused too.
        let trusted = root_s[(i, i)].abs() > MIN_ROOT_PIVOT * root_s.column(i).norm();
        if !trusted {
            return Err(Error::InnovationNotPositiveDefinite);
        }
    }
    let kt = root_s.solve_upper_triangular(&r.view((0, m), (m, n))).ok_or(Error::InnovationNotPositiveDefinite)?;
    let root_posterior = r.view((m, m), (n, n));
    Ok((kt.transpose(), root_posterior.transpose() * root_posterior))
}

/// A matrix L with LLᵀ = `s`, for a positive semidefinite `s`: Cholesky's, or where that meets a zero pivot the one from
/// the eigenvectors.
fn root(s: &DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
    let s = finite(s.clone(), "a covariance")?;
    if let Some(factor) = s.clone().cholesky() {
        return Ok(factor.unpack());
    }
    let eigen = SymmetricEigen::try_new(s, f64::EPSILON, MAX_ITERATIONS).ok_or(Error::InnovationNotPositiveDefinite)?;
    // Rounding may push a zero eigenvalue this far below zero; what lies lower is not a covariance.
    if eigen.eigenvalues.min() < -1e-12 * eigen.eigenvalues.amax() {
        return Err(Error::InnovationNotPositiveDefinite);
    }
    let scales = eigen.eigenvalues.map(|l| libm::sqrt(l.max(0.0)));
    Ok(eigen.eigenvectors * DMatrix::from_diagonal(&scales))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linear;

    /// A covariance of size n with no symmetry beyond its own.
    fn covariance(n: usize, scale: f64) -> DMatrix<f64> {
        let l = DMatrix::from_fn(n, n, |i, j| if i < j { 0.0 } else { 1.0 / (1.0 + (2 * i + j) as f64) });
        &l * l.transpose() * scale
    }

    #[test]
    fn it_agrees_with_the_joseph_form_at_any_size_and_scale() {
        for (m, n) in [(1, 1), (1, 3), (2, 3), (3, 2), (2, 2)] {
            // The square roots of the extremes are far from 1, and so is any threshold that is not relative.
            for scale in [1e-24, 1.0, 1e24] {
                let (p, q) = (covariance(n, scale), covariance(m, 0.5 * scale));
                let c = DMatrix::from_fn(m, n, |i, j| 1.0 - 0.4 * (i * n + j) as f64);
                let (k, posterior) = array_update(&p, &c, &q).expect("well conditioned");
                let (expected_k, _, expected) = linear::gain_and_covariance(&p, &c, &q).expect("well conditioned");
                assert!((&k - &expected_k).amax() < 1e-11 * expected_k.amax(), "{m}×{n} at {scale}");
                assert!((&posterior - &expected).amax() < 1e-11 * scale, "{m}×{n} at {scale}");
            }
        }
    }

    #[test]
    fn a_singular_covariance_has_a_root_and_a_negative_one_has_none() {
        for scale in [1e-20, 1.0, 1e20] {
            let line = DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 1.0, 1.0]) * scale;
            let l = root(&line).expect("semidefinite");
            assert!((&l * l.transpose() - &line).amax() < 1e-15 * scale);
            // Rounding's −1e-14 is taken for zero, a −1e-10 is not.
            assert!(root(&(DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, -1e-14]) * scale)).is_ok(), "{scale}");
            assert!(root(&(DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, -1e-10]) * scale)).is_err(), "{scale}");
        }
    }

    #[test]
    fn two_readings_of_one_number_without_noise_are_refused() {
        let c = DMatrix::from_row_slice(2, 1, &[1.0, 1.0]);
        let refused = array_update(&covariance(1, 1.0), &c, &DMatrix::zeros(2, 2));
        assert_eq!(refused.map(|_| ()), Err(Error::InnovationNotPositiveDefinite));
    }
}
