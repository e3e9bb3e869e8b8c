//! Which directions of the state the outputs can tell apart: the rank test of Theorem 8.2.2, with what stands behind
//! it.

use crate::error::{Code, Error};
use crate::validate;
use alloc::vec::Vec;
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DVector, DefaultAllocator, Dim, OMatrix};
use numerics::singular_values;

/// The answer of a rank test, with the evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Observability {
    /// The number of singular values above tolerance · the largest.
    pub rank: usize,
    /// The number of states; observable means `rank == n`.
    pub n: usize,
    /// All n singular values, in decreasing order.
    pub singular_values: Vec<f64>,
    /// An orthonormal basis of the directions no output sees: n − rank vectors.
    pub nullspace: Vec<DVector<f64>>,
}

/// Q = [H; HF; …; HF^{n−1}], np × n (Theorem 8.2.2). By Cayley and Hamilton a further power adds no rank.
///
/// Its height n·p is a product that no const parameter can name, hence a `DMatrix` for fixed sizes too.
pub fn observability_matrix<N: Dim, M: Dim>(f: &OMatrix<f64, N, N>, h: &OMatrix<f64, M, N>) -> DMatrix<f64>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N>,
{
    let (m, n) = h.shape();
    let mut q = DMatrix::zeros(m * n, n);
    let mut hf = h.clone();
    for k in 0..n {
        for j in 0..n {
            for i in 0..m {
                q[(k * m + i, j)] = hf[(i, j)];
            }
        }
        hf *= f;
    }
    q
}

/// The rank of a stack `q` of output rows under a tolerance *relative* to its largest singular value.
///
/// # Errors
/// [`Code::Tolerance`] when `tolerance` is negative or not finite, [`Code::NotFinite`] when the stack is not finite,
/// [`Code::DidNotConverge`] when its singular values are not found.
///
/// # Example
/// ```
/// let q = nalgebra::dmatrix![0.0, 1.0; 0.0, 1.0];
/// let seen = estimate::observability::analyze(&q, 1e-9)?;
/// assert_eq!((seen.rank, seen.n), (1, 2));
/// assert_eq!(seen.nullspace[0][0].abs(), 1.0);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn analyze(q: &DMatrix<f64>, tolerance: f64) -> Result<Observability, Error> {
    let tolerance = validate::tolerance(tolerance, "tolerance")?;
    if !filters::covariance::is_finite(q) {
        return Err(Error::new(Code::NotFinite, "F", "its powers overflow; the rank cannot be told"));
    }
    let found = singular_values(q.clone()).map_err(|e| Error::of_matrix(e, "F"))?;
    let threshold = tolerance * found.values.first().copied().unwrap_or(0.0);
    let rank = found.values.iter().filter(|s| **s > threshold).count();
    Ok(Observability {
        rank,
        n: q.ncols(),
        nullspace: found.directions.column_iter().skip(rank).map(|v| v.into_owned()).collect(),
        singular_values: found.values,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, RowVector2, dmatrix};

    #[test]
    fn the_matrix_stacks_powers_in_order() {
        let f = Matrix2::new(1.0, 0.5, 0.0, 1.0);
        assert_eq!(observability_matrix(&f, &RowVector2::new(1.0, 0.0)), dmatrix![1.0, 0.0; 1.0, 0.5]);
        let two_outputs = observability_matrix(&f, &Matrix2::identity());
        assert_eq!(two_outputs, dmatrix![1.0, 0.0; 0.0, 1.0; 1.0, 0.5; 0.0, 1.0]);
    }

    #[test]
    fn the_tolerance_is_relative() {
        let q = dmatrix![1e6, 0.0; 0.0, 1e-1];
        assert_eq!(analyze(&q, 1e-8).expect("found").rank, 2);
        assert_eq!(analyze(&q, 1e-6).expect("found").rank, 1);
        assert_eq!(analyze(&(&q * 1e-200), 1e-8).expect("found").rank, 2);
    }

    #[test]
    fn a_zero_output_observes_no_direction() {
        let none = analyze(&DMatrix::zeros(3, 3), 0.0).expect("found");
        assert_eq!((none.rank, none.nullspace.len()), (0, 3));
    }

    #[test]
    fn the_null_directions_are_orthonormal_and_unseen() {
        let q = dmatrix![1.0, 2.0, 3.0, 4.0; 2.0, 4.0, 6.0, 8.0; 0.0, 1.0, 0.0, -1.0];
        let seen = analyze(&q, 1e-9).expect("found");
        assert_eq!((seen.rank, seen.nullspace.len()), (2, 2));
        for (i, a) in seen.nullspace.iter().enumerate() {
            assert!((&q * a).norm() < 1e-13);
            for (j, b) in seen.nullspace.iter().enumerate() {
                assert!((a.dot(b) - f64::from(u8::from(i == j))).abs() < 1e-14);
            }
        }
    }

    /// The columns of this stack become orthogonal only to rounding.
    #[test]
    fn an_ordinary_pair_whose_columns_turn_at_rounding_level_has_an_answer() {
        let q = observability_matrix(&Matrix2::new(0.0, 0.6, 1.7, 1.0), &RowVector2::new(1.3, 0.3));
        let seen = analyze(&q, 1e-9).expect("found");
        assert_eq!(seen.rank, 2);
        // H is [1.3, 0.3] and HF [0.51, 1.08].
        let determinant = 1.3 * 1.08 - 0.3 * 0.51;
        assert!((seen.singular_values[0] * seen.singular_values[1] - determinant).abs() < 1e-15);
    }

    #[test]
    fn a_bad_tolerance_or_an_overflow_is_refused() {
        let q = DMatrix::identity(2, 2);
        for t in [-1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(analyze(&q, t).expect_err("no tolerance").code, Code::Tolerance);
        }
        assert_eq!(analyze(&(q * f64::INFINITY), 0.1).expect_err("infinite").code, Code::NotFinite);
    }
}
