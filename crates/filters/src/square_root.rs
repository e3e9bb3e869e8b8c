//! The measurement update in square-root (array) form, for an innovation covariance too near to singular to be
//! factored.
//!
//! With Q = QₗQₗᵀ and Σ̄ = ΣₗΣₗᵀ, one orthogonal factorization
//!
//! ```text
//! ⎡ Qₗᵀ      0  ⎤        ⎡ S^{T/2}  S^{−1/2} C Σ̄ ⎤
//! ⎣ ΣₗᵀCᵀ   Σₗᵀ ⎦  = Θ · ⎣    0        Σ^{T/2}    ⎦
//! ```
//!
//! holds the square roots of S and of the corrected Σ without ever forming S, so condition numbers enter as their
//! square roots (Kaminski, Bryson and Schmidt 1971; Anderson and Moore, Optimal Filtering, §6.5).

use crate::covariance::{
    MAX_CANCELLED, SEMIDEFINITE_TOLERANCE, finite, largest_variance, positive_when_raised, regular, semidefinite,
};
use crate::error::{Error, Quantity};
use crate::terms::{bound_on_sums, bound_on_terms, largest_terms, least_variance, tolerated};
use alloc::vec::Vec;
use nalgebra::DMatrix;
use numerics::{MIN_PIVOT, Singular, Spd, power_of_two, singular_values, sqrt};

/// The smallest |Sᵢᵢ^{½}| relative to its column that still leaves six digits of the answer.
const MIN_ROOT_PIVOT: f64 = 1e-10;

/// What a correction computes on its rare way.
pub(crate) struct Correction {
    /// S, m×m.
    pub s: DMatrix<f64>,
    /// K, n×m.
    pub k: DMatrix<f64>,
    /// Σ, n×n.
    pub p: DMatrix<f64>,
    /// Whether a closer look has left a doubt.
    pub doubted: bool,
}

/// The correction `found` from (Σ̄, C, Q) when a closer look shows that its rounding does not matter, and otherwise the
/// one from square roots. `pivot` is that of the factor of S.
pub(crate) fn examined([p, c, q]: [DMatrix<f64>; 3], pivot: f64, found: Correction) -> Result<Correction, Error> {
    let most = tolerated(&found.p);
    let small = || bound_on_terms(&p, &found.k, &c) <= most || largest_terms(&p, &found.k, &c) <= most;
    let regular = regular(&found.p);
    if pivot >= MIN_PIVOT && small() && (regular || semidefinite(&found.p)) {
        let kept = bound_on_sums(&p, &c) <= MAX_CANCELLED * least_variance(&found.s);
        return Ok(Correction { doubted: !(regular && kept), ..found });
    }
    finite(found.s, Quantity::InnovationCovariance)?;
    let Correction { s, k, p, doubted } = correction(&p, &c, &q)?;
    Ok(Correction { s, k: finite(k, Quantity::Gain)?, p: finite(p, Quantity::Covariance)?, doubted })
}

/// S, gain and corrected covariance for the predicted covariance `p`; see [`crate::linear::gain`].
///
/// The array has m + n rows, a size that no const parameter can name: hence `DMatrix`, on this rare way only.
fn correction(p: &DMatrix<f64>, c: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<Correction, Error> {
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
    let (s, p) = (root_s.transpose() * root_s, root_posterior.transpose() * root_posterior);
    Ok(Correction { s, k: kt.transpose(), p, doubted: true })
}

/// The rows of `m` by decreasing largest entry. Reflections keep the digits of small rows only below the large ones
/// (Powell and Reid 1969), and the triangle they leave does not depend on the order.
fn largest_rows_first(m: &DMatrix<f64>) -> DMatrix<f64> {
    let size = |i: usize| m.row(i).amax();
    let mut order: Vec<usize> = Vec::with_capacity(m.nrows());
    for i in 0..m.nrows() {
        let at = order.iter().position(|&j| size(i) > size(j)).unwrap_or(order.len());
        order.insert(at, i);
    }
    DMatrix::from_fn(m.nrows(), m.ncols(), |i, j| m[(order[i], j)])
}

/// A matrix L with LLᵀ = `s`, for a positive semidefinite `s`: Cholesky's, or where that meets a zero pivot the one
/// from the eigenvectors.
fn root(s: &DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
    let s = finite(s.clone(), Quantity::Covariance)?;
    if let Some(factor) = Spd::new(s.clone()) {
        return Ok(factor.root());
    }
    // In units in which each variance is about 1 a small one is known as well as a large one. Where these units show a
    // negative eigenvalue it is rounding beside the largest variance, or no covariance.
    let (n, largest) = (s.nrows(), largest_variance(&s));
    for own in [true, false] {
        let unit = |i: usize| power_of_two(sqrt(if own && s[(i, i)] > 0.0 { s[(i, i)] } else { largest }));
        let scaled = DMatrix::from_fn(n, n, |i, j| s[(i, j)] / unit(i) / unit(j));
        // Of a semidefinite matrix the singular values are the eigenvalues.
        let found = singular_values(scaled.clone()).map_err(|_| Error::InnovationNotPositiveDefinite)?;
        let Singular { values: sizes, directions } = found;
        if sizes[0] == 0.0 || positive_when_raised(&scaled, SEMIDEFINITE_TOLERANCE * sizes[0]) {
            return Ok(DMatrix::from_fn(n, n, |i, j| unit(i) * (directions[(i, j)] * sqrt(sizes[j]))));
        }
    }
    Err(Error::InnovationNotPositiveDefinite)
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

    /// Two outputs δ apart with noise as small: the bound on a pivot is relative to its column.
    #[test]
    fn the_smallest_trusted_pivot_does_not_depend_on_units() {
        let of = |unit: f64, delta: f64| {
            let (p, c) = (DMatrix::identity(2, 2) * (unit * unit), dmatrix![1.0, 0.0; 1.0, delta]);
            correction(&p, &c, &(DMatrix::identity(2, 2) * (unit * unit * delta * delta)))
        };
        let Correction { k, p, .. } = of(1.0, 1e-8).expect("eight digits apart");
        for unit in [1e-6, 1e6] {
            let there = of(unit, 1e-8).expect("eight digits apart");
            let (there, posterior) = (there.k, there.p);
            assert!((there - &k).amax() < 1e-6 * k.amax() && (posterior / (unit * unit) - &p).amax() < 1e-6);
            assert_eq!(of(unit, 1e-12).err(), Some(Error::InnovationNotPositiveDefinite));
        }
    }

    #[test]
    fn a_doubtful_correction_is_kept_when_its_terms_are_small_and_recomputed_otherwise() {
        let (one, mark) = (DMatrix::<f64>::identity(2, 2), dmatrix![0.75, 0.0; 0.0, 1.0]);
        let read = dmatrix![1.0, 0.0];
        let w = dmatrix![1.0];
        let stays = |product: f64, pivot: f64, mark: &DMatrix<f64>| {
            let given = [one.clone(), read.clone(), w.clone()];
            let found = Correction { s: dmatrix![2.0], k: dmatrix![product; 0.0], p: mark.clone(), doubted: true };
            let p = examined(given, pivot, found).expect("regular").p;
            let recomputed = (&p - dmatrix![0.5, 0.0; 0.0, 1.0]).amax() < 1e-15;
            assert!(recomputed || p == *mark, "{p}");
            !recomputed
        };
        assert!(stays(0.5, 1.0, &mark), "both measures are small");
        assert!(stays(8.0, 1.0, &mark), "the bound is above, the terms are not");
        assert!(!stays(20.0, 1.0, &mark), "both are above");
        assert!(!stays(0.5, 0.1 * MIN_PIVOT, &mark), "S had hardly a factor");
        assert!(!stays(0.5, 1.0, &dmatrix![-0.75, 0.0; 0.0, 1.0]), "no covariance");
    }
}
