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
use nalgebra::{DMatrix, DVector};
use numerics::{Singular, Spd, singular_values};

/// The smallest |Sᵢᵢ^{½}| relative to its column that still leaves six digits of the answer.
const MIN_ROOT_PIVOT: f64 = 1e-10;

/// The gain and the corrected covariance for the predicted covariance `p`; see [`crate::linear::gain`].
///
/// The array has m + n rows, a size that no const parameter can name: hence `DMatrix`, on this rare path only.
pub(crate) fn gain_and_covariance(
    p: &DMatrix<f64>,
    c: &DMatrix<f64>,
    q: &DMatrix<f64>,
) -> Result<(DMatrix<f64>, DMatrix<f64>), Error> {
    let (m, n) = c.shape();
    let (root_p, root_q) = (root(p)?, root(q)?);
    let mut array = DMatrix::zeros(m + n, m + n);
    array.view_mut((0, 0), (m, m)).copy_from(&root_q.transpose());
    array.view_mut((m, 0), (n, m)).copy_from(&(c * &root_p).transpose());
    array.view_mut((m, m), (n, n)).copy_from(&root_p.transpose());
    let r = largest_rows_first(&array).qr().r();

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

/// The rows of `m` by decreasing largest entry. Reflections keep the digits of small rows only below the large ones (Powell
/// and Reid 1969), and the triangle they leave does not depend on the order.
fn largest_rows_first(m: &DMatrix<f64>) -> DMatrix<f64> {
    let size = |i: usize| m.row(i).amax();
    let mut order: Vec<usize> = Vec::with_capacity(m.nrows());
    for i in 0..m.nrows() {
        let at = order.iter().position(|&j| size(i) > size(j)).unwrap_or(order.len());
        order.insert(at, i);
    }
    DMatrix::from_fn(m.nrows(), m.ncols(), |i, j| m[(order[i], j)])
}

/// A matrix L with LLᵀ = `s`, for a positive semidefinite `s`: Cholesky's, or where that meets a zero pivot the one from
/// the eigenvectors.
fn root(s: &DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
    let s = finite(s.clone(), "a covariance")?;
    if let Some(factor) = Spd::new(s.clone()) {
        return Ok(factor.root());
    }
    // Of a semidefinite matrix the singular values are the eigenvalues.
    let Singular { values, directions } =
        singular_values(s.clone()).map_err(|_| Error::InnovationNotPositiveDefinite)?;
    // Rounding may push a zero eigenvalue this far below zero; what lies lower is not a covariance.
    let allowance = DMatrix::identity(s.nrows(), s.nrows()) * (1e-12 * values[0]);
    if values[0] > 0.0 && Spd::new(s + allowance).is_none() {
        return Err(Error::InnovationNotPositiveDefinite);
    }
    Ok(directions * DMatrix::from_diagonal(&DVector::from_vec(values).map(f64::sqrt)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    #[test]
    fn a_semidefinite_matrix_has_a_root_in_any_units_and_an_indefinite_one_none() {
        let of = |a: f64, b: f64| root(&dmatrix![a, 0.0; 0.0, b]);
        let squared = |l: DMatrix<f64>| &l * l.transpose();
        assert_eq!(of(0.0, 0.0).map(squared), Ok(DMatrix::zeros(2, 2)));
        for unit in [1e-9, 1.0, 1e9] {
            for s in [dmatrix![unit, 0.0; 0.0, 0.0], dmatrix![unit, unit; unit, unit]] {
                assert!((squared(root(&s).expect("semidefinite")) - s).amax() < 1e-15 * unit);
            }
            // Below zero by rounding, and by more than that.
            assert!(of(unit, -1e-13 * unit).is_ok());
            assert_eq!(of(unit, -1e-11 * unit), Err(Error::InnovationNotPositiveDefinite));
        }
    }

    /// Two outputs δ apart, their noise as small: what is trusted is a part of what is there.
    #[test]
    fn what_is_told_apart_does_not_depend_on_the_units() {
        let of = |unit: f64, delta: f64| {
            let (p, c) = (DMatrix::identity(2, 2) * (unit * unit), dmatrix![1.0, 0.0; 1.0, delta]);
            gain_and_covariance(&p, &c, &(DMatrix::identity(2, 2) * (unit * unit * delta * delta)))
        };
        let (k, p) = of(1.0, 1e-8).expect("eight digits apart");
        for unit in [1e-6, 1e6] {
            let (there, posterior) = of(unit, 1e-8).expect("eight digits apart");
            assert!((there - &k).amax() < 1e-6 * k.amax() && (posterior / (unit * unit) - &p).amax() < 1e-6);
            assert_eq!(of(unit, 1e-12), Err(Error::InnovationNotPositiveDefinite));
        }
    }
}
