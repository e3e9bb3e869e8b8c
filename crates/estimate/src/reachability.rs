//! What noise or inputs reach, and whether what they do not reach dies out by itself: reachability and stabilizability,
//! which are observability and detectability of the transposed pair (Anderson and Moore, Optimal Filtering, appendix
//! C).

use crate::detectability::blurred;
use crate::error::Error;
use crate::verdict::Verdict;
use alloc::vec::Vec;
use nalgebra::{Complex, DMatrix, DVector};
use numerics::singular_values;
use numerics::sqrt;

/// Eigenvalues of a matrix of correlations below this part of the largest are rounding: see
/// [`validate::covariance`](crate::validate::covariance).
const ROUNDING: f64 = 1e-12;

/// What a pair (F, B) of dynamics and inputs moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Reachability {
    /// Whether every combination of the states is moved.
    pub reachable: Verdict,
    /// Whether every combination that is not moved dies out by itself.
    pub stabilizable: Verdict,
    /// Orthonormal c for which cᵀx counts as not moved: less than the tolerance.
    pub unreached: Vec<DVector<f64>>,
    /// The eigenvalues of F that belong to them, by decreasing modulus.
    pub modes: Vec<Complex<f64>>,
}

/// Whether (`f`, `b`), n×n and n×m and finite, is reachable, and whether it is stabilizable.
///
/// # Errors
/// As [`detectability`](crate::detectability::detectability).
pub(crate) fn reachability(f: &DMatrix<f64>, b: &DMatrix<f64>, tolerance: f64) -> Result<Reachability, Error> {
    reached_by(f, b, 0.0, tolerance)
}

/// The same of noise of the covariance `v`, n×n.
///
/// # Errors
/// As [`reachability`], and as [`noise_input`].
pub(crate) fn noise_reach(f: &DMatrix<f64>, v: &DMatrix<f64>, tolerance: f64) -> Result<Reachability, Error> {
    noise_reach_beside(f, v, &[], tolerance)
}

/// The same where there is noise along these directions too.
///
/// # Errors
/// As [`noise_reach`].
pub(crate) fn noise_reach_beside(
    f: &DMatrix<f64>,
    v: &DMatrix<f64>,
    others: &[DVector<f64>],
    tolerance: f64,
) -> Result<Reachability, Error> {
    let (noise, n) = (noise_input(v)?, f.nrows());
    let all = DMatrix::from_fn(n, n + others.len(), |i, j| if j < n { noise[(i, j)] } else { others[j - n][i] });
    // A direction of less than this part of a state's noise is rounding; the root of it is what `noise_input` leaves.
    reached_by(f, &all, sqrt(ROUNDING), tolerance)
}

fn reached_by(f: &DMatrix<f64>, b: &DMatrix<f64>, blur: f64, tolerance: f64) -> Result<Reachability, Error> {
    let dual = blurred(&f.transpose(), &b.transpose(), blur, tolerance)?;
    Ok(Reachability {
        reachable: dual.observable,
        stabilizable: dual.detectable,
        unreached: dual.unseen,
        modes: dual.modes,
    })
}

/// A matrix B with V = BBᵀ, n×n: the directions and sizes of the noise.
///
/// The correlations are taken apart and not V itself, so that no unit makes a variance negligible.
///
/// # Errors
/// As [`singular_values`], blaming V.
pub(crate) fn noise_input(v: &DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
    let n = v.nrows();
    let sigma = v.diagonal().map(|variance| sqrt(variance.max(0.0)));
    let over = |i: usize, j: usize| if sigma[i] * sigma[j] > 0.0 { v[(i, j)] / sigma[i] / sigma[j] } else { 0.0 };
    let found = singular_values(DMatrix::from_fn(n, n, over)).map_err(|e| Error::of_matrix(e, "V"))?;
    let largest = found.values.first().copied().unwrap_or(0.0);
    let root = |size: f64| if size > ROUNDING * largest { sqrt(size) } else { 0.0 };
    Ok(DMatrix::from_fn(n, n, |i, j| sigma[i] * found.directions[(i, j)] * root(found.values[j])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use Verdict::{No, Yes};
    use nalgebra::dmatrix;

    #[test]
    fn the_noise_of_a_covariance_is_found_in_any_units() {
        let v = dmatrix![1e-14, 0.0; 0.0, 1e6];
        let b = noise_input(&v).expect("found");
        assert!((&b * b.transpose() - &v).amax() < 1e-9);
        assert!(b.row(0).amax() > 0.0);
        // Rank one but for rounding: one direction and no second one.
        let g = dmatrix![0.125; 0.5];
        let b = noise_input(&(&g * g.transpose() * 0.1)).expect("found");
        assert_eq!(b.column(1).amax(), 0.0);
        assert_eq!(noise_input(&DMatrix::zeros(2, 2)).expect("found"), DMatrix::zeros(2, 2));
    }

    #[test]
    fn noise_that_a_small_number_lets_through_is_not_said_to_stop() {
        let kicks = dmatrix![0.0, 0.0; 0.0, 1.0];
        let reached = |f: DMatrix<f64>| noise_reach(&f, &kicks, 1e-9).expect("found").reachable;
        assert_eq!(reached(dmatrix![1e20, 0.1; 0.0, 1.0]), Verdict::Undecided);
        assert_eq!(reached(dmatrix![1e20, 0.0; 0.1, 1.0]), No);
        // Noise of rank one in full coordinates: its second direction is rounding.
        let g = dmatrix![0.3; 0.7];
        assert_eq!(noise_reach(&DMatrix::identity(2, 2), &(&g * g.transpose()), 1e-9).expect("found").reachable, No);
    }

    #[test]
    fn kicks_of_the_velocity_reach_the_position_and_not_the_other_way_round() {
        let f = dmatrix![1.0, 0.5; 0.0, 1.0];
        let reached = |b: &DMatrix<f64>| reachability(&f, b, 1e-9).expect("found");
        assert_eq!(reached(&dmatrix![0.0; 1.0]).reachable, Yes);
        let of_position = reached(&dmatrix![1.0; 0.0]);
        assert_eq!((of_position.reachable, of_position.stabilizable), (No, No));
        assert_eq!(of_position.unreached[0].map(f64::abs), nalgebra::dvector![0.0, 1.0]);
        let decaying = reachability(&dmatrix![1.0, 0.5; 0.0, 0.9], &dmatrix![1.0; 0.0], 1e-9).expect("found");
        assert_eq!((decaying.reachable, decaying.stabilizable), (No, Yes));
    }
}
