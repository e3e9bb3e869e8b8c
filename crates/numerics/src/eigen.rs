//! Eigenvalues and singular values that always come back: nalgebra's own never return on some finite matrices, the
//! deadbeat ⎡0 0 0; 1 0 0; 0 1 0⎤ among them, so each iteration here has a cap.

use crate::error::Error;
use crate::{all_finite, hypot, power_of_two};
use core::cmp::Ordering;
use nalgebra::{Complex, DMatrix, DVector, Schur};

/// Iterations granted per row; LAPACK grants 30.
const ITERATIONS_PER_ROW: usize = 100;

/// The eigenvalues of a square `m`, by decreasing modulus, then decreasing imaginary part, then decreasing real part.
///
/// Rows and columns that a permutation makes triangular are read off exactly, so a pinned or a deadbeat eigenvalue has
/// no rounding; what is left of size two is solved in closed form, and anything larger by the QR iteration, scaled by a
/// power of two against overflow.
///
/// # Errors
/// [`Error::NotSquare`] when `m` is not square, [`Error::NotFinite`] when an entry is not finite, [`Error::DidNotConverge`] when
/// the iteration meets its cap twice, the second time in another orthonormal basis.
///
/// # Example
/// ```
/// let deadbeat = nalgebra::dmatrix![0.0, 0.0, 0.0; 1.0, 0.0, 0.0; 0.0, 1.0, 0.0];
/// assert!(numerics::eigenvalues(&deadbeat)?.iter().all(|l| l.re == 0.0 && l.im == 0.0));
/// # Ok::<(), numerics::Error>(())
/// ```
pub fn eigenvalues(m: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    found_with(m, iterated)
}

/// [`eigenvalues`] of a matrix of at most two rows, which needs no iteration: who asks for these alone need not carry it.
pub fn eigenvalues_in_closed_form(m: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    found_with(m, |_| Err(Error::TooLarge))
}

fn found_with(
    m: &DMatrix<f64>,
    beyond_two: impl FnOnce(&DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error>,
) -> Result<Vec<Complex<f64>>, Error> {
    if !m.is_square() {
        return Err(Error::NotSquare);
    }
    if !all_finite(m) {
        return Err(Error::NotFinite);
    }
    let (mut found, rest) = isolated(m);
    let core = DMatrix::from_fn(rest.len(), rest.len(), |i, j| m[(rest[i], rest[j])]);
    match core.nrows() {
        0 => {}
        2 => found.extend(of_two_by_two(&core)),
        _ => found.extend(beyond_two(&core)?),
    }
    let modulus = |l: &Complex<f64>| hypot(l.re, l.im);
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
        .ok_or(Error::DidNotConverge)?;
    Ok(schur.complex_eigenvalues().iter().map(|l| l * scale).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

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
        }
    }

    #[test]
    fn what_is_not_square_or_not_finite_is_refused() {
        assert_eq!(eigenvalues(&DMatrix::zeros(2, 3)).expect_err("2 × 3"), Error::NotSquare);
        let nan = dmatrix![1.0, f64::NAN, 0.0; 0.0, 1.0, 0.0; 0.0, 0.0, 1.0];
        assert_eq!(eigenvalues(&nan).expect_err("NaN"), Error::NotFinite);
    }
}
