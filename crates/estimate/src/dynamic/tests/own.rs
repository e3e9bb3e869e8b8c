//! Filters of one's own models.

use crate::dynamic::{
    Belief, ExtendedKalmanFilter, KalmanFilter, OwnReading, SIGMA_POINTS, System, UnscentedKalmanFilter,
};
use crate::error::{Code, Error};
use crate::validate;
use filters::ukf::SigmaPoints;
use nalgebra::{DMatrix, DVector, dmatrix, dvector};
use std::f64::consts::PI;

/// Two readings a step of a robot on a rail.
fn rail() -> (System, Belief) {
    let (f, h) = (dmatrix![1.0, 0.5; 0.0, 0.9], dmatrix![1.0, 0.0; 0.3, 1.0]);
    let system = System::new(f, DMatrix::zeros(2, 0), h, dmatrix![0.2, 0.05; 0.05, 0.1], dmatrix![0.5, 0.1; 0.1, 0.4]);
    (system.expect("sound"), Belief { x: dvector![2.0, 4.0], p: dmatrix![1.0, 0.2; 0.2, 2.0] })
}

const READ: [[Option<f64>; 2]; 4] =
    [[Some(2.7), Some(4.1)], [None, Some(4.0)], [Some(6.3), None], [Some(8.4), Some(7.0)]];

fn times(m: &DMatrix<f64>) -> impl Fn(&[f64]) -> Result<Vec<f64>, Error> {
    move |x| Ok((m * DVector::from_column_slice(x)).as_slice().to_vec())
}

fn reading<'a>(y: &'a [Option<f64>], w: &DMatrix<f64>) -> OwnReading<'a> {
    OwnReading { y, w: w.clone(), angles: &[], gate: None }
}

#[test]
fn with_linear_models_the_extended_filter_is_the_kalman_filter_to_the_last_bit() {
    let (system, belief) = rail();
    let mut kf = KalmanFilter::new(&system, &belief).expect("sound");
    let mut ekf = ExtendedKalmanFilter::new(&belief, &[]).expect("sound");
    let (mut f, mut h) = (times(&system.f), times(&system.h));
    for y in &READ {
        kf.step_partly(&[], y).expect("sound");
        ekf.predict(&mut f, system.v.clone(), Some(&mut |_| Ok(system.f.clone()))).expect("sound");
        let update = ekf.update(&reading(y, &system.w), &mut h, Some(&mut |_| Ok(system.h.clone()))).expect("sound");
        assert_eq!((ekf.x(), ekf.p()), (kf.x(), &kf.belief().p));
        assert_eq!(update.judged.chi2, kf.nis());
        assert!(update.accepted && ekf.conditioned());
    }
}

#[test]
fn differences_stand_in_for_jacobians_and_points_for_both() {
    let (system, belief) = rail();
    let mut kf = KalmanFilter::new(&system, &belief).expect("sound");
    let mut ekf = ExtendedKalmanFilter::new(&belief, &[]).expect("sound");
    let points = SigmaPoints { alpha: 1.0, beta: 0.0, kappa: 1.0 };
    let mut ukf = UnscentedKalmanFilter::new(&belief, &[], points).expect("sound");
    let (mut f, mut h) = (times(&system.f), times(&system.h));
    for y in &READ {
        kf.step_partly(&[], y).expect("sound");
        ekf.predict(&mut f, system.v.clone(), None).expect("sound");
        ekf.update(&reading(y, &system.w), &mut h, None).expect("sound");
        ukf.predict(&mut f, system.v.clone()).expect("sound");
        ukf.update(&reading(y, &system.w), &mut h).expect("sound");
        let Belief { x, p } = kf.belief();
        let off = |x2: &[f64], p2: &DMatrix<f64>| (DVector::from_column_slice(x2) - &x).amax().max((p2 - &p).amax());
        // A difference rounds in the eleventh digit; the points' weights are near one.
        assert!(off(ekf.x(), ekf.p()) < 1e-9, "{}", off(ekf.x(), ekf.p()));
        assert!(off(ukf.x(), ukf.p()) < 1e-13, "{}", off(ukf.x(), ukf.p()));
    }
}

#[test]
fn angles_take_the_short_way_round() {
    let belief = Belief { x: dvector![3.1], p: dmatrix![0.04] };
    let mut h = |x: &[f64]| Ok::<_, Error>(x.to_vec());
    let compass = OwnReading { y: &[Some(-3.1)], w: dmatrix![0.04], angles: &[0], gate: Some(4.0) };
    let mut ekf = ExtendedKalmanFilter::new(&belief, &[0]).expect("sound");
    let mut ukf = UnscentedKalmanFilter::new(&belief, &[0], SigmaPoints::default()).expect("sound");
    let innovation = ekf.update(&compass, &mut h, None).expect("sound").judged.innovation[0];
    assert!((innovation - (2.0 * PI - 6.2)).abs() < 1e-12);
    assert!(ukf.update(&compass, &mut h).expect("sound").accepted);
    // Half of the way from 3.1 to 2π − 3.1 is π.
    for x in [ekf.x()[0], ukf.x()[0]] {
        assert!((x.abs() - PI).abs() < 1e-6, "{x}");
    }
    ekf.predict(&mut |x| Ok::<_, Error>(vec![x[0] + 1.0]), dmatrix![0.0], None).expect("sound");
    assert!((ekf.x()[0] - (1.0 - PI)).abs() < 1e-6);
}

#[test]
fn a_reading_beyond_the_gate_leaves_the_belief() {
    let belief = Belief { x: dvector![0.0], p: dmatrix![1.0] };
    let far = OwnReading { y: &[Some(5.0)], w: dmatrix![1.0], angles: &[], gate: Some(9.0) };
    let mut h = |x: &[f64]| Ok::<_, Error>(x.to_vec());
    let mut ekf = ExtendedKalmanFilter::new(&belief, &[]).expect("sound");
    let mut ukf = UnscentedKalmanFilter::new(&belief, &[], SigmaPoints::default()).expect("sound");
    let [a, b] = [ekf.update(&far, &mut h, None), ukf.update(&far, &mut h)].map(|it| it.expect("sound"));
    for refused in [a, b] {
        assert!(!refused.accepted);
        assert!((refused.judged.chi2.expect("regular") - 12.5).abs() < 1e-8);
    }
    assert_eq!((ekf.x()[0], ekf.p()[0], ukf.x()[0], ukf.p()[0]), (0.0, 1.0, 0.0, 1.0));
}

/// What a caller's function may fail with.
#[derive(Debug, PartialEq)]
enum Failure {
    Own,
    Ours(Code, String),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Ours(error.code, error.argument.to_string())
    }
}

#[test]
fn what_a_function_answers_is_checked_and_what_it_fails_with_comes_through() {
    let belief = Belief { x: dvector![1.0, 2.0], p: DMatrix::identity(2, 2) };
    let mut ekf = ExtendedKalmanFilter::new(&belief, &[1]).expect("sound");
    let mut ukf = UnscentedKalmanFilter::new(&belief, &[1], SigmaPoints::default()).expect("sound");
    let v = DMatrix::identity(2, 2);
    let ours = |code, argument: &str| Err(Failure::Ours(code, argument.into()));
    let answers: [(fn(&[f64]) -> Result<Vec<f64>, Failure>, _); 3] = [
        (|_| Err(Failure::Own), Err(Failure::Own)),
        (|_| Ok(vec![1.0]), ours(Code::Shape, "f(x)")),
        (|_| Ok(vec![1.0, f64::NAN]), ours(Code::NotFinite, "f(x)[1]")),
    ];
    for (mut f, expected) in answers {
        assert_eq!(ekf.predict(&mut f, v.clone(), None), expected);
        assert_eq!(ukf.predict(&mut f, v.clone()), expected);
    }
    let mut same = |x: &[f64]| Ok(x.to_vec());
    let narrow = |_: &[f64]| Ok(dmatrix![1.0]);
    assert_eq!(ekf.predict(&mut same, v.clone(), Some(&mut { narrow })), ours(Code::Shape, "F(x)"));
    assert_eq!(ekf.predict(&mut same, dmatrix![1.0], None), ours(Code::Shape, "V"));
    let of = |y, w, angles, gate| OwnReading { y, w, angles, gate };
    for (reading, code, argument) in [
        (of(&[], dmatrix![1.0], &[], None), Code::Shape, "y"),
        (of(&[None, None], DMatrix::identity(2, 2), &[], None), Code::Shape, "y"),
        (of(&[Some(1.0), Some(f64::NAN)], DMatrix::identity(2, 2), &[], None), Code::NotFinite, "y"),
        (of(&[Some(1.0), Some(1.0)], dmatrix![1.0], &[], None), Code::Shape, "W"),
        (of(&[Some(1.0), Some(1.0)], DMatrix::identity(2, 2), &[0, 2], None), Code::Index, "angles[1]"),
        (of(&[Some(1.0), Some(1.0)], DMatrix::identity(2, 2), &[], Some(0.0)), Code::Limit, "gate"),
        (of(&[Some(1.0)], dmatrix![1.0], &[], None), Code::Shape, "h(x)"),
    ] {
        let expected = Failure::Ours(code, argument.into());
        assert_eq!(ekf.update(&reading, &mut same, None).expect_err("refused"), expected);
        assert_eq!(ukf.update(&reading, &mut same).expect_err("refused"), expected);
    }
    assert_eq!((ekf.x(), ukf.x()), (belief.x.as_slice(), belief.x.as_slice()));
    assert_eq!((ekf.p(), ukf.p()), (&belief.p, &belief.p));
    assert_eq!(ExtendedKalmanFilter::new(&belief, &[2]).expect_err("no such").code, Code::Index);
}

/// A range to a mast three metres beside the rail: the mean of the root is not the root of the mean.
#[test]
fn the_unscented_filter_sees_the_bend_of_h() {
    let belief = Belief { x: dvector![0.0], p: dmatrix![1.0] };
    let mut h = |x: &[f64]| Ok::<_, Error>(vec![x[0] * x[0]]);
    let seen = OwnReading { y: &[Some(1.0)], w: dmatrix![0.5], angles: &[], gate: None };
    let points = SigmaPoints { alpha: 1.0, beta: 0.0, kappa: 2.0 };
    let mut ukf = UnscentedKalmanFilter::new(&belief, &[], points).expect("sound");
    let found = ukf.update(&seen, &mut h).expect("sound").judged;
    // E x² = 1 and Var x² = 2 for a normal x of variance one.
    assert!(found.innovation[0].abs() < 1e-14 && (found.s[0] - 2.5).abs() < 1e-14);
    let mut ekf = ExtendedKalmanFilter::new(&belief, &[]).expect("sound");
    assert_eq!(ekf.update(&seen, &mut h, None).expect("sound").judged.innovation[0], 1.0);
}

/// A prior whose variances are 10²⁷ times those that a reading leaves: P − R S Rᵀ has no digit of them.
#[test]
fn a_covariance_that_rounding_has_spoilt_is_refused() {
    let belief = Belief { x: dvector![1.0, 2.0], p: dmatrix![1.0, 0.5; 0.5, 1.0] * 1e18 };
    let w = DMatrix::identity(2, 2) * 1e-9;
    let seen = OwnReading { y: &[Some(0.0), Some(0.0)], w, angles: &[], gate: None };
    let mut refused = 0;
    for k in 0..50 {
        let (sin, cos) = (libm::sin(f64::from(k)), libm::cos(f64::from(k)));
        let mut turn = |x: &[f64]| Ok::<_, Error>(vec![cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]]);
        let mut filter = UnscentedKalmanFilter::new(&belief, &[], SIGMA_POINTS).expect("sound");
        match filter.update(&seen, &mut turn) {
            Ok(_) => assert!(validate::covariance(filter.p().clone(), 2, "P").is_ok()),
            Err(error) => {
                refused += 1;
                assert_eq!((error.code, error.argument.as_ref()), (Code::NotPositiveSemidefinite, "P"));
                assert_eq!((filter.x(), filter.p()), (belief.x.as_slice(), &belief.p));
            }
        }
    }
    assert!(refused > 5, "{refused}");
}
