use super::*;
use crate::slam::LandmarkReading;
use filters::Gaussian;
use filters::association::Thresholds;
use nalgebra::{DMatrix, Matrix2, Matrix3, Vector3};
use numerics::PackedSymmetric;

const W: Matrix2<f64> = Matrix2::new(0.01, 0.001, 0.001, 0.0009);

/// A map of `n` landmarks about the robot.
fn slam(n: u32) -> EkfSlam {
    let p = Matrix3::new(0.04, 0.005, 0.0, 0.005, 0.02, -0.004, 0.0, -0.004, 0.01);
    let belief = Gaussian { x: Vector3::new(0.1, -0.2, 0.3), p };
    let mut slam = EkfSlam::new(&belief, &W, Thresholds { gate: 9.21, found: 50.0 }).expect("sound");
    for j in 0..n {
        let reading =
            LandmarkReading { range: 3.0 + 0.5 * f64::from(j), bearing: 2.4 * f64::from(j), landmark: Some(j) };
        slam.update(&[reading]).expect("founded");
    }
    slam
}

/// A map of `n` landmarks whose covariance is diagonal: `robot`, and `landmark` at every coordinate of one.
fn diagonal(n: u32, robot: [f64; 3], landmark: f64) -> EkfSlam {
    let mut slam = slam(n);
    let variance = |i: usize| if i < 3 { robot[i] } else { landmark };
    slam.p = PackedSymmetric::from_fn(slam.x.len(), |i, j| if i == j { variance(i) } else { 0.0 });
    slam
}

#[test]
fn a_landmark_s_block_is_judged_by_its_own_size() {
    let block = |a: f64, b: f64, c: f64| {
        let mut slam = diagonal(2, [1e16; 3], 1.0);
        for (i, j, value) in [(5, 5, a), (6, 5, b), (6, 6, c)] {
            slam.p.set(i, j, value);
        }
        slam.landmarks_are_covariances()
    };
    for size in [1e-9, 1.0, 1e9] {
        assert!(block(2.0 * size, 0.5 * size, size) && block(size, size, size) && block(size, 0.0, 0.0));
        assert!(!block(size, 2.0 * size, size) && !block(size, 0.0, -0.5 * size) && !block(0.0, size, 4.0 * size));
        // An eigenvalue below zero by rounding, and by more than that.
        assert!(block(size, 0.0, -0.5e-12 * size) && !block(size, 0.0, -2e-12 * size));
    }
}

#[test]
fn a_negative_eigenvalue_is_allowed_up_to_a_part_of_the_largest_variance() {
    assert_eq!(diagonal(0, [0.0; 3], 0.0).semidefinite_to(), Some(0.0));
    for size in [1e-6, 1.0, 1e6] {
        // A few states, and more than are checked at every change.
        for (landmarks, part) in [(1, 1e-12), (17, 2e-14 + 37.0 * f64::EPSILON)] {
            let of = |eigenvalue: f64| diagonal(landmarks, [size, 0.5 * size, eigenvalue * size], 0.1 * size);
            let bound = of(-0.5 * part).semidefinite_to().expect("semidefinite but for rounding");
            assert!((bound / (part * size) - 1.0).abs() < 1e-12, "{bound}");
            assert_eq!(of(-2.0 * part).semidefinite_to(), None);
        }
    }
    assert_eq!(diagonal(1, [-1.0; 3], -1.0).semidefinite_to(), None, "the largest may be negative");
    let mut broken = diagonal(1, [1e12, 1.0, 1.0], 1.0);
    broken.p.set(4, 3, 2.0);
    assert_eq!(broken.semidefinite_to(), None, "the landmark's block is none, small as it is beside the robot's");
    broken.p.set(4, 3, f64::NAN);
    assert_eq!(broken.semidefinite_to(), None);
}

#[test]
fn a_small_map_is_checked_at_every_change_and_a_large_one_when_its_rounding_may_matter() {
    let break_it = |slam: &mut EkfSlam| slam.p.set(0, 0, -1.0);
    let mut small = slam(1);
    let before = small.clone();
    assert!(!small.guarded(0.0, 1.0, break_it));
    assert_eq!(small, before);
    assert!(small.guarded(0.0, 1.0, |slam| slam.p.set(0, 0, 1.0)));
    assert!((small.rounding - 1e-12).abs() < 1e-24, "what was verified is kept");

    // 37 states: checked when the rounding is above 2e-13 and twice 37 ε of the largest variance.
    let large = slam(17);
    let most = 2e-13 + 2.0 * 37.0 * f64::EPSILON;
    let looked_over = |after: f64, part: f64, had: f64| {
        let mut slam = EkfSlam { rounding: had, ..large.clone() };
        let kept = slam.guarded(part * after / f64::EPSILON, after, break_it);
        let rounding = numerics::hypot(had, part * after);
        assert!(!kept || (slam.rounding / rounding - 1.0).abs() < 1e-15);
        !kept
    };
    for after in [0.25, 1.0, 4.0] {
        assert!(looked_over(after, 1.05 * most, 0.0) && !looked_over(after, 0.95 * most, 0.0), "{after}");
        assert!(looked_over(after, 0.8 * most, 0.8 * most * after), "it adds up");
    }
}

/// Compared with dense matrices: the new variances, and the terms that were added up to them.
#[test]
fn a_step_reports_its_largest_terms_and_its_largest_new_variance() {
    let mut map = slam(4);
    // All of it correlated: in a fresh map a second sighting says nothing of the other landmarks.
    let p = |i: usize, j: usize| if i == j { 1.0 + 0.1 * i as f64 } else { 0.05 + 0.04 * libm::cos((i * j) as f64) };
    map.p = PackedSymmetric::from_fn(map.x.len(), p);
    let reading = LandmarkReading { range: 4.1, bearing: 4.75, landmark: Some(2) };
    let expected = map.expected(2, &reading).expect("apart");
    let innovation = Vector2::new(0.05, -0.02);
    let step = map.worked_out(&expected, &innovation).expect("positive definite");

    let p = map.p.to_dense();
    let mut h = DMatrix::zeros(2, p.nrows());
    for (b, c) in expected.columns().into_iter().enumerate() {
        h.set_column(c, &expected.h.column(b));
    }
    let s = &h * &p * h.transpose() + W;
    let k = &p * h.transpose() * s.try_inverse().expect("regular");
    let spread = |a: usize| (0..p.nrows()).map(|c| h[(a, c)].abs() * p[(c, c)].sqrt()).sum::<f64>() + W[(a, a)].sqrt();
    let terms = |i: usize| p[(i, i)].sqrt() + k[(i, 0)].abs() * spread(0) + k[(i, 1)].abs() * spread(1);
    let scale = (0..p.nrows()).map(|i| terms(i) * terms(i)).fold(0.0, f64::max);
    assert!((step.scale / scale - 1.0).abs() < 1e-12);

    map.correct(&expected, &innovation).expect("sound");
    let left = map.p.diagonal().fold(0.0, f64::max);
    assert!((step.after / left - 1.0).abs() < 1e-12);
}

#[test]
fn an_update_that_overflows_is_refused() {
    let reading = LandmarkReading { range: 4.0, bearing: 2.4, landmark: Some(0) };
    let refused = |slam: &mut EkfSlam, innovation: f64| {
        let (before, expected) = (slam.clone(), slam.expected(0, &reading).expect("apart"));
        let error = slam.correct(&expected, &Vector2::new(innovation, 0.0)).expect_err("refused");
        assert_eq!((error.code, &*slam), (crate::Code::NotFinite, &before));
    };
    refused(&mut slam(1), 1e308);
    let mut vast = slam(1);
    vast.p = PackedSymmetric::from_fn(5, |i, j| 1e200 * vast.p.get(i, j));
    vast.w *= 1e200;
    refused(&mut vast, 0.1);
}
