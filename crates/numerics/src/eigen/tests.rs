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

/// The double eigenvalue 0 comes out as a close pair; its sum is the rest of the trace.
#[test]
fn close_roots_have_the_sum_and_the_product_of_their_matrix() {
    let found = eigenvalues(&dmatrix![1.0, -1.0, -3.0; -2.0, 2.0, -1.0; -3.0, 3.0, 2.0]).expect("found");
    assert!((found[0].re - 5.0).abs() < 1e-14, "{found:?}");
    assert!((found[1] + found[2]).l1_norm() < 1e-14 && (found[1] * found[2]).l1_norm() < 1e-14, "{found:?}");
}

#[test]
fn entries_whose_squares_vanish_do_no_harm() {
    for tiny in [1e-155, 1e-158, 1e-161, 1e-164, 1e-200, 5e-324] {
        let m = DMatrix::from_fn(4, 4, |i, j| match (i, j) {
            (0..2, 0..2) | (2..4, 2..4) => [[1.0, 2.0], [3.0, 1.0]][i % 2][j % 2] * (1 + i / 2) as f64,
            (0..2, _) => 1.0,
            _ => tiny * (1 + i + j) as f64,
        });
        let found = eigenvalues(&m).expect("found");
        for (found, exact) in found.iter().zip([2.0, 1.0, -2.0, -1.0].map(|f: f64| f.abs() + f * 6.0_f64.sqrt())) {
            assert!((found.re - exact).abs() < 1e-14 && found.im == 0.0, "{tiny}: {found} against {exact}");
        }
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
fn a_matrix_that_is_not_square_or_not_finite_is_refused() {
    assert_eq!(eigenvalues(&DMatrix::zeros(2, 3)).expect_err("2 × 3"), Error::NotSquare);
    let nan = dmatrix![1.0, f64::NAN, 0.0; 0.0, 1.0, 0.0; 0.0, 0.0, 1.0];
    assert_eq!(eigenvalues(&nan).expect_err("NaN"), Error::NotFinite);
}

/// Each has a repeated eigenvalue, and needs more than a hundred iterations.
#[test]
fn small_whole_matrices_that_need_many_iterations_have_their_eigenvalues() {
    let all = [
        dmatrix![1.0, 1.0, -3.0, 0.0; 1.0, 1.0, -2.0, -1.0; -1.0, 0.0, -1.0, 1.0; 2.0, 1.0, -3.0, -1.0],
        dmatrix![
            -1.0, 0.0, 0.0, -2.0, 1.0;
            0.0, -3.0, 1.0, -1.0, 1.0;
            0.0, -2.0, 0.0, -1.0, 1.0;
            0.0, -1.0, 0.0, -2.0, 1.0;
            0.0, -1.0, 1.0, -1.0, -1.0
        ],
        dmatrix![
            -2.0, 4.0, 4.0, 1.0, 0.0;
            -1.0, 3.0, 1.0, 0.0, 0.0;
            -1.0, 0.0, 3.0, 1.0, 0.0;
            -3.0, 4.0, 3.0, 2.0, 0.0;
            0.0, 0.0, 0.0, 0.0, 0.0
        ],
        dmatrix![
            -2.0, 1.0, 0.0, 0.0, 0.0;
            -1.0, 0.0, 0.0, 0.0, 0.0;
            0.0, 0.0, 1.0, 0.0, 0.0;
            1.0, -1.0, -2.0, 0.0, 1.0;
            3.0, -3.0, -2.0, -1.0, 2.0
        ],
    ];
    for m in all {
        let found = eigenvalues(&m).expect("found");
        let sum: f64 = found.iter().map(|l| l.re).sum();
        assert!((sum - m.trace()).abs() < 1e-12, "{m}{found:?}");
    }
}
