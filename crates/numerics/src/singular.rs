//! Singular values by one-sided Jacobi rotations (Hestenes 1958; Golub and Van Loan, Matrix Computations, §8.6.3).
//!
//! Not nalgebra's SVD: that iterates for ever on some finite matrices, brings three more factorizations with it, and
//! knows a small singular value only to the rounding of the largest. Rotations until all columns are orthogonal keep
//! the digits of the small ones.
//!
//! # Why it ends
//!
//! Two columns count as orthogonal when the cosine between them is at most τ = (m + 8)ε, with m rows. A rotation is
//! made only where the cosine is greater, and leaves a smaller one: of rounding, the inner product contributes at most
//! mε/2, the two norms through the angle as much again where they are close, the angle and the new entries less than
//! 8ε. In exact arithmetic the sweeps converge, and quadratically once all cosines are small (Forsythe and Henrici
//! 1960). Rounding disturbs that only below τ, where no rotation is made. With ε alone in place of τ a pair can be
//! rotated for ever at the level of its rounding.

use crate::error::Error;
use crate::sqrt;
use crate::{all_finite, hypot, power_of_two};
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Sweeps over all pairs of columns; seven or eight suffice for sixteen of them.
const MAX_SWEEPS: usize = 60;

/// Singular values and right singular vectors.
#[derive(Clone, Debug, PartialEq)]
pub struct Singular {
    /// In decreasing order, one for each column of the matrix.
    pub values: Vec<f64>,
    /// The right singular vector of each value as a column: orthonormal, the entry of largest size positive.
    pub directions: DMatrix<f64>,
}

/// The singular values of `m` and its right singular vectors, as many as it has columns: with fewer rows than columns
/// the missing values are zero.
///
/// # Errors
/// [`Error::NotFinite`] when an entry is not finite, [`Error::DidNotConverge`] when the sweeps reach their limit.
///
/// # Example
/// ```
/// let found = numerics::singular_values(nalgebra::dmatrix![0.0, -3.0; 2.0, 0.0])?;
/// assert_eq!(found.values, [3.0, 2.0]);
/// assert_eq!(found.directions, nalgebra::dmatrix![0.0, 1.0; 1.0, 0.0]);
/// # Ok::<(), numerics::Error>(())
/// ```
pub fn singular_values(m: DMatrix<f64>) -> Result<Singular, Error> {
    if !all_finite(&m) {
        return Err(Error::NotFinite);
    }
    let n = m.ncols();
    // By a power of two, hence without rounding, so that no square overflows or vanishes.
    let scale = power_of_two(m.amax());
    let (mut a, mut v) = (m / scale, DMatrix::identity(n, n));
    let tolerance = (a.nrows() as f64 + 8.0) * f64::EPSILON;
    // Columns that depend on others shrink to rounding, and then without end: such a product counts as zero.
    let negligible = f64::EPSILON * f64::EPSILON * a.norm_squared();
    let mut still = false;
    for _ in 0..MAX_SWEEPS {
        still = true;
        for q in 1..n {
            for p in 0..q {
                still &= !orthogonalize(&mut a, &mut v, (p, q), tolerance, negligible);
            }
        }
        if still {
            break;
        }
    }
    let mut order: Vec<(f64, usize)> = Vec::with_capacity(n);
    for j in 0..n {
        let size = a.column(j).norm();
        let at = order.iter().position(|(s, _)| size > *s).unwrap_or(order.len());
        order.insert(at, (size, j));
    }
    if !still {
        return Err(Error::DidNotConverge);
    }
    let mut directions = DMatrix::zeros(n, n);
    for (mut to, (_, j)) in directions.column_iter_mut().zip(&order) {
        let direction = v.column(*j);
        to.copy_from(&(direction * facing(direction.as_slice())));
    }
    Ok(Singular { values: order.into_iter().map(|(size, _)| size * scale).collect(), directions })
}

/// The sign under which the entry of largest size is positive. A direction has no sign, but to have the same digits
/// everywhere it needs one.
fn facing(direction: &[f64]) -> f64 {
    let largest = direction.iter().fold(0.0_f64, |a, &b| if b.abs() > a.abs() * (1.0 + 1e-9) { b } else { a });
    if largest < 0.0 { -1.0 } else { 1.0 }
}

/// Rotates columns `p` and `q` of `a`, and of `v` with them, so that they become orthogonal; false when they already
/// were.
fn orthogonalize(
    a: &mut DMatrix<f64>,
    v: &mut DMatrix<f64>,
    (p, q): (usize, usize),
    tolerance: f64,
    negligible: f64,
) -> bool {
    let (pp, qq, pq) = (a.column(p).norm_squared(), a.column(q).norm_squared(), a.column(p).dot(&a.column(q)));
    if pq.abs() <= negligible || pq.abs() <= tolerance * sqrt(pp) * sqrt(qq) {
        return false;
    }
    let zeta = (qq - pp) / (2.0 * pq);
    let t = libm::copysign(1.0, zeta) / (zeta.abs() + hypot(1.0, zeta));
    let c = 1.0 / hypot(1.0, t);
    let s = c * t;
    for m in [a, v] {
        for i in 0..m.nrows() {
            let (x, y) = (m[(i, p)], m[(i, q)]);
            m[(i, p)] = c * x - s * y;
            m[(i, q)] = s * x + c * y;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DVector, dmatrix};

    #[test]
    fn values_and_directions_reproduce_the_matrix() {
        for (rows, columns) in [(5, 3), (3, 5), (16, 16), (1, 4), (4, 1)] {
            let m = DMatrix::from_fn(rows, columns, |i, j| libm::sin((3 * i * i + 7 * j + 1) as f64));
            let Singular { values, directions: v } = singular_values(m.clone()).expect("converges");
            assert!(values.is_sorted_by(|a, b| a >= b));
            assert!((v.transpose() * &v - DMatrix::identity(columns, columns)).amax() < 1e-14);
            let squares = DVector::from_vec(values.iter().map(|s| s * s).collect());
            let gram = &v * DMatrix::from_diagonal(&squares) * v.transpose();
            assert!((gram - m.transpose() * m).amax() < 1e-12);
        }
    }

    #[test]
    fn a_small_value_keeps_its_digits_beside_a_large_one() {
        let Singular { values, .. } = singular_values(dmatrix![1e10, 1.0; 0.0, 1e-10]).expect("converges");
        // Their product is |det| = 1.
        assert!((values[0] * values[1] - 1.0).abs() < 1e-14);
    }

    /// With one ε in place of the tolerance this pair was rotated at the level of its rounding until the sweeps ran
    /// out.
    #[test]
    fn columns_that_are_orthogonal_but_for_rounding_count_as_such() {
        let found = singular_values(dmatrix![1.3, 0.3; 0.51, 1.08]).expect("converges");
        assert!((found.values[0] * found.values[1] - (1.3 * 1.08 - 0.3 * 0.51)).abs() < 1e-15);
    }

    #[test]
    fn degenerate_and_deficient_matrices_converge() {
        let Singular { values, .. } = singular_values(dmatrix![0.0, 1.0; 1.0, 0.0]).expect("converges");
        assert_eq!(values, [1.0, 1.0]);
        let Singular { values, .. } = singular_values(DMatrix::from_element(6, 6, 1.0)).expect("converges");
        assert!((values[0] - 6.0).abs() < 1e-14 && values[1] < 1e-14);
        assert_eq!(singular_values(DMatrix::zeros(3, 2)).expect("converges").values, [0.0, 0.0]);
    }

    #[test]
    fn a_matrix_whose_squares_have_no_number_has_the_same_values_to_scale() {
        let m = dmatrix![3.0, 1.0; -2.0, 0.5];
        let Singular { values, directions } = singular_values(m.clone()).expect("converges");
        for exponent in [-700, 700] {
            let unit = libm::ldexp(1.0, exponent);
            let Singular { values: scaled, directions: same } = singular_values(&m * unit).expect("converges");
            assert_eq!((scaled, same), (values.iter().map(|s| s * unit).collect(), directions.clone()), "2^{exponent}");
        }
    }

    #[test]
    fn huge_and_tiny_matrices_scale() {
        for size in [1e300, 1e-300] {
            let m = dmatrix![2.0, 1.0, 0.5; 1.0, 3.0, 1.0; 0.5, 1.0, 4.0] * size;
            assert!((singular_values(m).expect("converges").values.iter().sum::<f64>() / size - 9.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_matrix_that_is_not_finite_has_no_singular_values() {
        assert_eq!(singular_values(dmatrix![f64::NAN]), Err(Error::NotFinite));
        assert_eq!(singular_values(dmatrix![1.0, f64::INFINITY]), Err(Error::NotFinite));
    }

    #[test]
    fn a_direction_has_its_largest_entry_positive_and_of_two_as_large_the_first() {
        let signs = |a: f64, b: f64| (facing(&[a, b]), facing(&[-a, -b]));
        assert_eq!((signs(0.6, -0.8), signs(0.8, -0.6)), ((-1.0, 1.0), (1.0, -1.0)));
        // As large but for rounding; larger by more than that.
        let (tie, more) = (0.5 * (1.0 + 1e-12), 0.5 * (1.0 + 1e-8));
        assert_eq!((signs(0.5, -tie), signs(0.5, -more)), ((1.0, -1.0), (-1.0, 1.0)));
    }

    #[test]
    fn singular_values_come_ordered_with_their_directions() {
        let s = singular_values(dmatrix![0.0, 0.0, -3.0; 2.0, 0.0, 0.0]).expect("found");
        assert_eq!(s.values.len(), 3);
        for (found, exact) in s.values.iter().zip([3.0, 2.0, 0.0]) {
            assert!((found - exact).abs() < 1e-15);
        }
        assert!((s.directions[(2, 0)] - 1.0).abs() < 1e-15, "turned to face the positive side");
        assert!((s.directions[(1, 2)] - 1.0).abs() < 1e-15);
    }

    #[test]
    fn the_zero_matrix_has_every_direction_null() {
        let s = singular_values(DMatrix::zeros(2, 4)).expect("found");
        assert_eq!(s.values, [0.0; 4]);
        assert_eq!(s.directions.ncols(), 4);
    }
}
