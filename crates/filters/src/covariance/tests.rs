use super::*;
use crate::terms::{bound_on_terms, largest_terms, tolerated};

#[test]
fn an_eigenvalue_may_be_negative_by_a_part_of_the_largest_variance() {
    let of = |a: f64, b: f64| semidefinite(&nalgebra::dmatrix![a, 0.0; 0.0, b]);
    assert!(of(1.0, 0.5) && of(0.0, 0.0) && of(1.0, 0.0));
    for largest in [1e-6, 1.0, 1e6] {
        assert!(of(largest, -0.5 * MAX_NEGATIVE * largest) && of(-0.5 * MAX_NEGATIVE * largest, largest));
        assert!(!of(largest, -2.0 * MAX_NEGATIVE * largest));
    }
    assert!(!of(f64::NAN, 1.0) && !of(1.0, f64::INFINITY));
}

#[test]
fn the_bound_on_the_terms_lies_above_the_terms() {
    let (p, k, c) =
        (nalgebra::dmatrix![4.0, 1.0; 1.0, 9.0], nalgebra::dmatrix![0.5; -2.0], nalgebra::dmatrix![3.0, -1.0]);
    assert_eq!((largest_variance(&p), largest_variance(&nalgebra::dmatrix![7.0, 0.0; 0.0, 3.0])), (9.0, 7.0));
    // σ = 2 and 3, a spread of 3·2 + 1·3: (2 + 9/2)² and (3 + 2·9)².
    assert_eq!(largest_terms(&p, &k, &c), 441.0);
    // 9 (2 + 2·2 (1/4 + 4) (9 + 1)).
    assert_eq!(bound_on_terms(&p, &k, &c), 1548.0);
    assert_eq!(tolerated(&p), 9.0 * MAX_ROUNDING / f64::EPSILON);
}

#[test]
fn clamping_removes_negative_eigenvalues_only() {
    // Eigenvalues 2 ± √2 and −3, and a pair ±1 that shares its singular value.
    let m = nalgebra::dmatrix![3.0, 1.0, 0.0; 1.0, 1.0, 0.0; 0.0, 0.0, -3.0];
    let kept = nalgebra::dmatrix![3.0, 1.0, 0.0; 1.0, 1.0, 0.0; 0.0, 0.0, 0.0];
    assert!((clamped(&m).expect("finite") - kept).amax() < 1e-14);
    let pair = nalgebra::dmatrix![0.0, 1.0; 1.0, 0.0];
    assert!((clamped(&pair).expect("finite") - DMatrix::from_element(2, 2, 0.5)).amax() < 1e-14);
    assert_eq!(clamped(&DMatrix::zeros(2, 2)), Some(DMatrix::zeros(2, 2)));
    assert_eq!(clamped(&nalgebra::dmatrix![f64::NAN]), None);
}

#[test]
fn plainly_positive_accepts_no_singular_or_indefinite_matrix() {
    let of = |entries: &[f64]| {
        let n = (entries.len() as f64).sqrt() as usize;
        plainly_positive(&DMatrix::from_row_slice(n, n, entries))
    };
    assert!(of(&[1e-300]) && of(&[4.0, 1.0, 1.0, 3.0]));
    assert!(of(&[2.0, -1.0, 0.5, -1.0, 2.0, -1.0, 0.5, -1.0, 2.0]));
    assert!(of(&[2.0, -1.0, 0.5, -1.0, 2.0, -1.0, 0.5, -1.0, 2.0].map(|entry| 0.3 * entry)), "in small units too");
    // Singular, and indefinite in each of the minors.
    for edge in [vec![0.0], vec![-1.0], vec![1.0, 2.0, 2.0, 4.0], vec![-4.0, 1.0, 1.0, -3.0]] {
        assert!(!of(&edge), "{edge:?}");
    }
    assert!(!of(&[-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0]), "two negative eigenvalues");
    assert!(!of(&[1.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 1.0]), "the second minor");
    assert!(!of(&[1.0, 0.0, 0.9, 0.0, 1.0, 0.9, 0.9, 0.9, 1.0]), "the third alone");
    assert!(!of(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0]), "the last entry");
    // Of four rows: D − aaᵀ/4 is positive definite as long as Σ aᵢ²/4 < 1, and all its minors but the last stay so a
    // while longer.
    let four = |a: [f64; 4]| DMatrix::from_fn(4, 4, |i, j| f64::from(i == j) - a[i] * a[j] / 4.0);
    assert!(plainly_positive(&four([1.0, -1.0, 0.9, 0.9])) && plainly_positive(&(four([1.0, -0.5, 0.9, 1.2]) * 1e-6)));
    let refused =
        [[1.0, 1.0, 1.0, 1.01], [1.0, -1.0, 1.5, 0.0], [1.0, 1.8, 0.0, 0.0], [2.1, 0.0, 0.0, 0.0], [1.5; 4], [3.0; 4]];
    assert!(refused.iter().all(|a| !plainly_positive(&four(*a))));
    // What is not finite, in each place; what leaves the range of numbers; what is too large for this way.
    for bad in [f64::NAN, f64::INFINITY] {
        for n in [3, 4] {
            for (i, j) in (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))) {
                let mut m = DMatrix::identity(n, n);
                m[(i, j)] = bad;
                m[(j, i)] = bad;
                assert!(!plainly_positive(&m), "{bad} at {i}, {j} of {n}");
            }
        }
        assert!(!of(&[bad]) && !of(&[bad, 0.0, 0.0, 1.0]) && !of(&[1.0, bad, bad, 1.0]) && !of(&[1.0, 0.0, 0.0, bad]));
    }
    for (n, vast) in [(3, 1e100), (4, 1e50)] {
        let eye = DMatrix::identity(n, n);
        assert!(plainly_positive(&eye) && !plainly_positive(&(&eye * vast)) && !plainly_positive(&(&eye / vast)));
    }
    assert!(!plainly_positive(&DMatrix::identity(5, 5)));
}
