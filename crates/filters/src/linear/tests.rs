use super::*;
use nalgebra::{Matrix1, Matrix2, Matrix2x1, RowVector2, Vector2};

#[test]
fn noise_adds_to_what_the_dynamics_and_the_sensor_make_of_p() {
    let p = Matrix2::new(3.0, 1.0, 1.0, 2.0);
    let (a, r) = (Matrix2::new(1.0, 2.0, 0.0, 1.0), Matrix2::new(0.5, 0.25, 0.25, 0.125));
    assert_eq!(predicted_covariance(&a, &p, &r), Ok(Matrix2::new(15.5, 5.25, 5.25, 2.125)));
    let (c, q) = (RowVector2::new(1.0, 2.0), Matrix1::new(0.75));
    assert_eq!(innovation_covariance(&c, &p, &q), Matrix1::new(15.75));
}

#[test]
fn what_is_left_of_an_error_is_the_rest_of_one() {
    let left = complement(&Matrix2x1::new(0.5, 0.25), &RowVector2::new(1.0, 2.0));
    assert_eq!(left, Matrix2::new(0.5, -1.0, -0.25, 0.5));
}

#[test]
fn what_may_lie_below_zero_is_a_part_of_the_largest_variance() {
    let of = |a: f64, b: f64| semidefinite(&nalgebra::dmatrix![a, 0.0; 0.0, b]);
    assert!(of(1.0, 0.5) && of(0.0, 0.0) && of(1.0, 0.0));
    for largest in [1e-6, 1.0, 1e6] {
        assert!(of(largest, -0.5 * MAX_NEGATIVE * largest) && of(-0.5 * MAX_NEGATIVE * largest, largest));
        assert!(!of(largest, -2.0 * MAX_NEGATIVE * largest));
    }
    assert!(!of(f64::NAN, 1.0) && !of(1.0, f64::INFINITY));
}

#[test]
fn terms_are_counted_before_they_cancel_and_their_bound_is_one() {
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
fn a_doubtful_correction_stays_where_its_terms_are_small_and_is_made_anew_where_not() {
    let (one, mark) = (DMatrix::<f64>::identity(2, 2), nalgebra::dmatrix![0.75, 0.0; 0.0, 1.0]);
    let read = nalgebra::dmatrix![1.0, 0.0];
    let w = nalgebra::dmatrix![1.0];
    let stays = |product: f64, pivot: f64, mark: &DMatrix<f64>| {
        let given = [one.clone(), read.clone(), w.clone(), nalgebra::dmatrix![2.0]];
        let [_, p] = examined(given, pivot, [nalgebra::dmatrix![product; 0.0], mark.clone()]).expect("regular");
        let anew = (&p - nalgebra::dmatrix![0.5, 0.0; 0.0, 1.0]).amax() < 1e-15;
        assert!(anew || p == *mark, "{p}");
        !anew
    };
    assert!(stays(0.5, 1.0, &mark), "both measures are small");
    assert!(stays(8.0, 1.0, &mark), "the bound is above, the terms are not");
    assert!(!stays(20.0, 1.0, &mark), "both are above");
    assert!(!stays(0.5, 0.1 * MIN_PIVOT, &mark), "S had hardly a factor");
    assert!(!stays(0.5, 1.0, &nalgebra::dmatrix![-0.75, 0.0; 0.0, 1.0]), "no covariance");
}

/// However precise the reading: its own variance is what it leaves, of its size at least, and never nothing.
#[test]
fn what_the_most_precise_reading_leaves_is_not_lost() {
    let p = Matrix2::new(3.0, 0.2, 0.2, 1.1);
    for h in [1.0, 0.2, 0.3, 7.0] {
        for w in [1e-20, 1e-26, 1e-31, 1e-33, 1e-36] {
            let left = gain(&p, &RowVector2::new(h, 0.0), &Matrix1::new(w)).expect("positive definite").p;
            let own = w / (h * h);
            assert!(left[(0, 0)] > 0.5 * own, "{h} {w}: {left}");
            assert!((left[(1, 1)] - (1.1 - 0.04 / 3.0)).abs() < 1e-14);
        }
    }
}

/// Outputs δ = 1e-9 apart: no pivot is left of S, and square roots still have six digits.
#[test]
fn where_s_has_no_factor_an_innovation_has_no_distance() {
    let delta = 1e-9;
    let (c, q) = (Matrix2::new(1.0, 0.0, 1.0, delta), Matrix2::identity() * (delta * delta));
    let gain = gain(&Matrix2::identity(), &c, &q).expect("square roots suffice");
    assert_eq!((gain.spd.pivot(), gain.d2(&Vector2::new(1e-3, 2e-3))), (0.0, None));
}

#[test]
fn clamping_takes_what_is_negative_and_leaves_the_rest() {
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
fn what_is_plainly_positive_is_so_and_nothing_near_the_edge_is() {
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
    // What is not finite, in each place; what leaves the range of numbers; what is too large for this way.
    for bad in [f64::NAN, f64::INFINITY] {
        for (i, j) in [(0, 0), (1, 0), (2, 0), (1, 1), (2, 1), (2, 2)] {
            let mut m = DMatrix::identity(3, 3);
            m[(i, j)] = bad;
            m[(j, i)] = bad;
            assert!(!plainly_positive(&m), "{bad} at {i}, {j}");
        }
        assert!(!of(&[bad]) && !of(&[bad, 0.0, 0.0, 1.0]) && !of(&[1.0, bad, bad, 1.0]) && !of(&[1.0, 0.0, 0.0, bad]));
    }
    assert!(!plainly_positive(&(DMatrix::identity(3, 3) * 1e100)) && !plainly_positive(&DMatrix::identity(4, 4)));
    assert!(!plainly_positive(&(DMatrix::identity(3, 3) * 1e-100)));
}

#[test]
fn a_prediction_says_what_is_not_finite_and_mends_what_cancels() {
    let (one, zero) = (Matrix2::identity(), Matrix2::zeros());
    assert_eq!(predicted_covariance(&one, &zero, &zero), Ok(zero));
    let refused = Err(Error::NotFinite { what: "the predicted covariance" });
    assert_eq!(predicted_covariance(&one, &(one * f64::NAN), &zero), refused);
    assert_eq!(predicted_covariance(&(one * 1e200), &one, &zero), refused);
    // Out by a huge lever and back: what is left is rounding, of either sign, and is taken as none.
    let lever = Matrix2::new(1.0, 1e9, 0.0, 1.0);
    let p = predicted_covariance(&lever, &Matrix2::new(1.0, 0.3, 0.3, 0.7), &zero).expect("finite");
    let back = lever.try_inverse().expect("a shear");
    let p = predicted_covariance(&back, &p, &zero).expect("finite");
    assert!(p.symmetric_eigenvalues().min() >= -1e-12 * p.symmetric_eigenvalues().max());
}
