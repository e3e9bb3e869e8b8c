//! Eigenvalues and singular values that always come back: nalgebra's own never return on some finite matrices, the
//! deadbeat ⎡0 0 0; 1 0 0; 0 1 0⎤ among them, so each iteration here has a cap.

use crate::error::{Code, Error};
use crate::validate::ITERATIONS_PER_ROW;
use core::cmp::Ordering;
use filters::linear::{jacobi, power_of_two};
use nalgebra::{Complex, DMatrix, DVector, Schur};

/// The eigenvalues of a square `m`, by decreasing modulus, then decreasing imaginary part, then decreasing real part.
///
/// Rows and columns that a permutation makes triangular are read off exactly, so a pinned or a deadbeat eigenvalue has
/// no rounding; what is left of size two is solved in closed form, and anything larger by the QR iteration, scaled by a
/// power of two against overflow.
///
/// # Errors
/// [`Code::Shape`] when `m` is not square, [`Code::NotFinite`] when an entry is not finite, [`Code::DidNotConverge`] when
/// the iteration meets its cap twice, the second time in another orthonormal basis.
///
/// # Example
/// ```
/// let deadbeat = nalgebra::dmatrix![0.0, 0.0, 0.0; 1.0, 0.0, 0.0; 0.0, 1.0, 0.0];
/// assert!(estimate::spectrum::eigenvalues(&deadbeat)?.iter().all(|l| l.re == 0.0 && l.im == 0.0));
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn eigenvalues(m: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    found_with(m, iterated)
}

/// [`eigenvalues`] of a matrix of at most two rows, which needs no iteration: who asks for these alone need not carry it.
pub(crate) fn eigenvalues_in_closed_form(m: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    found_with(m, |_| Err(Error::new(Code::Shape, "matrix", "has more than two rows")))
}

fn found_with(
    m: &DMatrix<f64>,
    beyond_two: impl FnOnce(&DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error>,
) -> Result<Vec<Complex<f64>>, Error> {
    if !m.is_square() {
        return Err(Error::new(Code::Shape, "matrix", "has no eigenvalues: it is not square"));
    }
    if !filters::linear::is_finite(m) {
        return Err(Error::new(Code::NotFinite, "matrix", "holds a NaN or an infinity"));
    }
    let (mut found, rest) = isolated(m);
    let core = DMatrix::from_fn(rest.len(), rest.len(), |i, j| m[(rest[i], rest[j])]);
    match core.nrows() {
        0 => {}
        2 => found.extend(of_two_by_two(&core)),
        _ => found.extend(beyond_two(&core)?),
    }
    let modulus = |l: &Complex<f64>| geom::hypot(l.re, l.im);
    // By insertion: a handful of values do not pay for the standard library's sort, 20 kB of the module.
    let mut ordered: Vec<Complex<f64>> = Vec::with_capacity(found.len());
    for l in found {
        let before = |o: &Complex<f64>| {
            let order = modulus(&l).total_cmp(&modulus(o)).then(l.im.total_cmp(&o.im)).then(l.re.total_cmp(&o.re));
            order == Ordering::Greater
        };
        let at = ordered.iter().position(before).unwrap_or(ordered.len());
        ordered.insert(at, l);
    }
    Ok(ordered)
}

/// The diagonal entries that stand alone in their row or column among the indices not yet taken (eigenvalues, exactly),
/// and the indices that are left.
fn isolated(m: &DMatrix<f64>) -> (Vec<Complex<f64>>, Vec<usize>) {
    let mut rest: Vec<usize> = (0..m.nrows()).collect();
    let mut found = Vec::with_capacity(m.nrows());
    let alone = |i: usize, rest: &[usize]| {
        rest.iter().all(|&j| j == i || m[(i, j)] == 0.0) || rest.iter().all(|&j| j == i || m[(j, i)] == 0.0)
    };
    while let Some(at) = rest.iter().position(|&i| alone(i, &rest)) {
        let i = rest.remove(at);
        found.push(Complex::new(m[(i, i)], 0.0));
    }
    (found, rest)
}

/// Both roots of λ² − (a + d)λ + ad − bc, the smaller real one as the determinant over the larger, so that neither is a
/// difference of near-equals.
fn of_two_by_two(m: &DMatrix<f64>) -> [Complex<f64>; 2] {
    let scale = power_of_two(m.amax());
    let (a, b, c, d) = (m[(0, 0)] / scale, m[(0, 1)] / scale, m[(1, 0)] / scale, m[(1, 1)] / scale);
    let half_trace = 0.5 * (a + d);
    let half_difference = 0.5 * (a - d);
    let discriminant = libm::fma(half_difference, half_difference, b * c);
    let root = discriminant.abs().sqrt();
    if discriminant < 0.0 {
        let (re, im) = (scale * half_trace, scale * root);
        return [Complex::new(re, im), Complex::new(re, -im)];
    }
    let larger = half_trace + libm::copysign(root, half_trace);
    let bc = b * c;
    let determinant = libm::fma(a, d, -bc) - libm::fma(b, c, -bc);
    let smaller = if larger == 0.0 { 0.0 } else { determinant / larger };
    [Complex::new(scale * larger, 0.0), Complex::new(scale * smaller, 0.0)]
}

fn iterated(m: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    let n = m.nrows();
    let scale = power_of_two(m.amax());
    let scaled = m / scale;
    let cap = ITERATIONS_PER_ROW * n;
    // The iteration can stand still on a matrix of zeros and ones; it does not in a basis that mixes every coordinate.
    let v = DVector::from_fn(n, |i, _| (i + 1) as f64);
    let mirror = DMatrix::identity(n, n) - &v * v.transpose() * (2.0 / v.norm_squared());
    let schur = Schur::try_new(scaled.clone(), f64::EPSILON, cap)
        .or_else(|| Schur::try_new(&mirror * scaled * &mirror, f64::EPSILON, cap))
        .ok_or_else(|| Error::new(Code::DidNotConverge, "matrix", "its eigenvalues were not found"))?;
    Ok(schur.complex_eigenvalues().iter().map(|l| l * scale).collect())
}

/// Singular values and right singular vectors.
#[derive(Clone, Debug, PartialEq)]
pub struct Singular {
    /// In decreasing order, one for each column of the matrix.
    pub values: Vec<f64>,
    /// The right singular vector of each value: orthonormal, the entry of largest size positive.
    pub directions: Vec<DVector<f64>>,
}

/// The singular values of `m` and its right singular vectors, as many as it has columns: with fewer rows than columns
/// the missing values are zero.
///
/// # Errors
/// [`Code::NotFinite`] when an entry is not finite, [`Code::DidNotConverge`] when the iteration meets its cap.
pub fn singular(m: &DMatrix<f64>) -> Result<Singular, Error> {
    if !filters::linear::is_finite(m) {
        return Err(Error::new(Code::NotFinite, "matrix", "holds a NaN or an infinity"));
    }
    let (values, directions) = jacobi(m.clone())
        .ok_or_else(|| Error::new(Code::DidNotConverge, "matrix", "its singular values were not found"))?;
    let directions = directions.column_iter().map(|v| facing(v.clone_owned())).collect();
    Ok(Singular { values, directions })
}

/// ±v, whichever has its largest entry positive: a direction has no sign, but the same digits everywhere need one.
fn facing(v: DVector<f64>) -> DVector<f64> {
    let largest = v.iter().copied().fold(0.0_f64, |a, b| if b.abs() > a.abs() * (1.0 + 1e-9) { b } else { a });
    if largest < 0.0 { -v } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{dmatrix, dvector};

    #[test]
    fn a_triangular_matrix_shows_its_eigenvalues_exactly() {
        let m = dmatrix![1.0, 0.3, -7.0; 0.0, 0.1, 2.0; 0.0, 0.0, -0.9];
        let found: Vec<f64> = eigenvalues(&m).expect("found").iter().map(|l| l.re).collect();
        assert_eq!(found, [1.0, -0.9, 0.1]);
    }

    #[test]
    fn a_rotation_has_a_conjugate_pair_the_upper_one_first() {
        let found = eigenvalues(&dmatrix![0.0, -2.0; 2.0, 0.0]).expect("found");
        assert_eq!(found, [Complex::new(0.0, 2.0), Complex::new(0.0, -2.0)]);
    }

    #[test]
    fn the_small_root_of_a_pair_keeps_its_digits() {
        // Roots 1e8 and 1e-8 of λ² − (1e8 + 1e-8)λ + 1.
        let found = eigenvalues(&dmatrix![1e8, 1.0; 0.0625, 7.25e-9]).expect("found");
        let product = found[0].re * found[1].re;
        let determinant = 1e8 * 7.25e-9 - 0.0625;
        assert!((product / determinant - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_direction_faces_where_its_largest_entry_is_positive_and_its_first_of_two() {
        let of = |a: f64, b: f64| facing(dvector![a, b]);
        assert_eq!((of(0.6, -0.8), of(-0.6, 0.8)), (dvector![-0.6, 0.8], dvector![-0.6, 0.8]));
        assert_eq!((of(0.8, -0.6), of(-0.8, 0.6)), (dvector![0.8, -0.6], dvector![0.8, -0.6]));
        // As large but for rounding; larger by more than that.
        let (tie, more) = (0.5 * (1.0 + 1e-12), 0.5 * (1.0 + 1e-8));
        assert_eq!((of(0.5, -tie), of(-0.5, tie)), (dvector![0.5, -tie], dvector![0.5, -tie]));
        assert_eq!((of(0.5, -more), of(-0.5, more)), (dvector![-0.5, more], dvector![-0.5, more]));
    }

    /// ad = 1 + 2ε exactly, bc = (1 + ε)² is rounded to it: the determinant −ε² is the rounding alone.
    #[test]
    fn a_determinant_below_the_rounding_of_its_products_has_its_sign_and_its_digits() {
        let e = 2.0_f64.powi(-30);
        let found = eigenvalues(&dmatrix![1.0 + 2.0 * e, 1.0 + e; 1.0 + e, 1.0]).expect("found");
        assert!((found[0].re * found[1].re / (-e * e) - 1.0).abs() < 1e-15, "{found:?}");
    }

    /// All 512 matrices of zeros and ones: trace and determinant are the eigenvalues' sum and product.
    #[test]
    fn every_small_matrix_of_zeros_and_ones_has_an_answer() {
        for bits in 0..512_u32 {
            let m = DMatrix::from_fn(3, 3, |i, j| f64::from((bits >> (3 * i + j)) & 1));
            let found = eigenvalues(&m).unwrap_or_else(|e| panic!("{m}: {e}"));
            let sum: Complex<f64> = found.iter().sum();
            let product: Complex<f64> = found.iter().product();
            // A triple eigenvalue is known to the cube root of the rounding only; its sum and product to much more.
            assert!((sum.re - m.trace()).abs() < 1e-12 && sum.im.abs() < 1e-12, "{m}");
            assert!((product.re - m.determinant()).abs() < 1e-10, "{m}{found:?}");
        }
    }

    #[test]
    fn deadbeat_chains_of_every_size_have_zero_eigenvalues() {
        for n in 1..=16 {
            let chain = DMatrix::from_fn(n, n, |i, j| if i == j + 1 { 1.0 } else { 0.0 });
            assert!(eigenvalues(&chain).expect("found").iter().all(|l| l.re == 0.0 && l.im == 0.0));
        }
    }

    #[test]
    fn a_cycle_has_the_roots_of_unity() {
        let cycle = DMatrix::from_fn(4, 4, |i, j| if i == (j + 1) % 4 { 1.0 } else { 0.0 });
        let found = eigenvalues(&cycle).expect("found");
        for l in &found {
            let fourth = l * l * l * l;
            assert!((fourth - Complex::new(1.0, 0.0)).l1_norm() < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn huge_and_tiny_matrices_scale() {
        for size in [1e300, 1e-300] {
            let m = dmatrix![2.0, 1.0, 0.5; 1.0, 3.0, 1.0; 0.5, 1.0, 4.0] * size;
            let sum: Complex<f64> = eigenvalues(&m).expect("found").iter().sum();
            assert!((sum.re / size - 9.0).abs() < 1e-12);
            assert!((singular(&m).expect("found").values.iter().sum::<f64>() / size - 9.0).abs() < 1e-12);
        }
    }

    #[test]
    fn what_is_not_square_or_not_finite_is_refused() {
        assert_eq!(eigenvalues(&DMatrix::zeros(2, 3)).expect_err("2 × 3").code, Code::Shape);
        let nan = dmatrix![1.0, f64::NAN, 0.0; 0.0, 1.0, 0.0; 0.0, 0.0, 1.0];
        assert_eq!(eigenvalues(&nan).expect_err("NaN").code, Code::NotFinite);
        assert_eq!(singular(&nan).expect_err("NaN").code, Code::NotFinite);
    }

    #[test]
    fn singular_values_come_ordered_with_their_directions() {
        let s = singular(&dmatrix![0.0, 0.0, -3.0; 2.0, 0.0, 0.0]).expect("found");
        assert_eq!(s.values.len(), 3);
        for (found, exact) in s.values.iter().zip([3.0, 2.0, 0.0]) {
            assert!((found - exact).abs() < 1e-15);
        }
        assert!((s.directions[0][2] - 1.0).abs() < 1e-15, "turned to face the positive side");
        assert!((s.directions[2][1] - 1.0).abs() < 1e-15);
    }

    #[test]
    fn the_zero_matrix_has_every_direction_null() {
        let s = singular(&DMatrix::zeros(2, 4)).expect("found");
        assert_eq!(s.values, [0.0; 4]);
        assert_eq!(s.directions.len(), 4);
    }
}
