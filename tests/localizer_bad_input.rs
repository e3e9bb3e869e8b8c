//! Whatever the localizer is given, it answers or refuses: no panic, no change by a refused call, and after every
//! accepted one a covariance that is one.

#![cfg(not(target_arch = "wasm32"))]

#[path = "src/draws.rs"]
mod draws;

use estimate::dynamic::Belief;
use estimate::localizer::{EkfLocalizer, LandmarkReading, SensorKind};
use estimate::{Landmark, validate};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

/// A number as callers send them: mostly plain, sometimes at the edge of the representable, sometimes none.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => -5.0..5.0_f64,
        1 => prop::sample::select(vec![0.0, -0.0, 1e-9, 1e9, 1e154, 1e308, -1e308, f64::MIN_POSITIVE, 5e-324]),
        1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
    ]
}

/// A square matrix: mostly BBᵀ, so that it is a covariance, scaled by some power of ten; sometimes anything.
fn matrix(n: usize) -> impl Strategy<Value = DMatrix<f64>> {
    let covariance = (prop::collection::vec(-1.0..1.0_f64, n * n), -12..12_i32).prop_map(move |(entries, power)| {
        let b = DMatrix::from_vec(n, n, entries);
        &b * b.transpose() * libm::exp10(f64::from(power))
    });
    let anything = (1..4_usize).prop_flat_map(|n| {
        prop::collection::vec(number(), n * n).prop_map(move |entries| DMatrix::from_vec(n, n, entries))
    });
    prop_oneof![6 => covariance, 1 => anything]
}

fn vector(n: usize) -> impl Strategy<Value = DVector<f64>> {
    prop_oneof![
        9 => prop::collection::vec(number(), n),
        1 => prop::collection::vec(number(), 0..5),
    ]
    .prop_map(DVector::from_vec)
}

#[derive(Clone, Debug)]
enum Call {
    Predict(DVector<f64>, DMatrix<f64>),
    Update(LandmarkReading),
}

fn call() -> impl Strategy<Value = Call> {
    let landmark = prop_oneof![2 => Just(None), 3 => (0..4_u32).prop_map(Some)];
    let bearing = prop_oneof![5 => number().prop_map(Some), 1 => Just(None)];
    let update = (number(), bearing, landmark)
        .prop_map(|(range, bearing, landmark)| Call::Update(LandmarkReading { range, bearing, landmark }));
    prop_oneof![2 => (vector(2), matrix(3)).prop_map(|(u, v)| Call::Predict(u, v)), 3 => update]
}

fn localizer() -> impl Strategy<Value = Option<EkfLocalizer>> {
    let belief = (vector(3), matrix(3)).prop_map(|(x, p)| Belief { x, p });
    let landmark = (0..5_u32, number(), number()).prop_map(|(id, x, y)| Landmark { id, x, y });
    let gate = prop_oneof![Just(None), Just(Some(9.21)), number().prop_map(Some)];
    let sensor = prop_oneof![4 => Just((SensorKind::RangeBearing, 2)), 1 => Just((SensorKind::Range, 1))];
    let sensor = sensor.prop_flat_map(|(kind, n)| (Just(kind), matrix(n)));
    (belief, prop::collection::vec(landmark, 0..4), gate, sensor)
        .prop_map(|(belief, map, gate, (kind, w))| EkfLocalizer::new(belief, map, w, gate, kind).ok())
}

proptest! {
    #![proptest_config(draws::cases(2000))]

    #[test]
    fn a_localizer_answers_or_refuses(ekf in localizer(), calls in prop::collection::vec(call(), 1..8)) {
        let Some(mut ekf) = ekf else { return Ok(()) };
        for call in calls {
            let before = ekf.clone();
            let accepted = match call {
                Call::Predict(u, v) => ekf.predict(u, v).is_ok(),
                Call::Update(reading) => ekf.update(reading).is_ok_and(|answer| answer.accepted),
            };
            if accepted {
                let Belief { x, p } = ekf.belief();
                prop_assert!(x.iter().chain(p.iter()).all(|n| n.is_finite()));
                prop_assert_eq!(&p, &p.transpose());
                prop_assert!(-std::f64::consts::PI < x[2] && x[2] <= std::f64::consts::PI);
                // Eigenvalues no lower than −10⁻¹² of the largest.
                let refusal = validate::covariance(p, 3, "P").err();
                prop_assert!(refusal.is_none(), "{:?}", refusal);
            } else {
                prop_assert_eq!(&ekf, &before);
            }
        }
    }
}

fn localizer_of(p: [f64; 3], w: [f64; 2]) -> EkfLocalizer {
    let belief = Belief { x: DVector::zeros(3), p: DMatrix::from_diagonal(&DVector::from_row_slice(&p)) };
    let map = vec![Landmark { id: 0, x: 0.0, y: -2.5 }];
    let w = DMatrix::from_diagonal(&DVector::from_row_slice(&w));
    EkfLocalizer::new(belief, map, w, None, SensorKind::RangeBearing).expect("covariances, to rounding")
}

/// What the property above once found: a variance of 10¹⁷ m² read away without noise, a W that is semidefinite only
/// beside its largest entry, a P of the same kind driven far.
#[test]
fn a_covariance_remains_where_scales_collapse() {
    let reading = LandmarkReading { range: 0.0, bearing: Some(0.0), landmark: None };
    let sound = |ekf: &EkfLocalizer| validate::covariance(ekf.belief().p, 3, "P").map(|_| ());

    let mut far = localizer_of([0.0, 0.0, 0.162], [0.0, 0.0]);
    far.predict(DVector::from_vec(vec![1e9, 0.0]), DMatrix::zeros(3, 3)).expect("finite");
    if far.update(reading).is_ok() {
        assert_eq!(sound(&far), Ok(()));
    }

    let mut lopsided = localizer_of([0.0, 46.1, 24.6], [1e154, -3.02]);
    lopsided.update(reading).expect("W is a covariance to rounding");
    assert_eq!(sound(&lopsided), Ok(()));

    let mut driven = localizer_of([1e154, 0.0, -0.438], [0.1, 0.1]);
    driven.predict(DVector::from_vec(vec![1e154, 0.0]), DMatrix::zeros(3, 3)).expect("finite");
    assert_eq!(sound(&driven), Ok(()));

    // Out and back: the terms of FPFᵀ are 10¹² times what is left of them.
    for i in 0..50 {
        let mut returned = localizer_of([1e-9, 1e-9, 0.1], [0.1, 0.1]);
        for u in [[0.0, 0.1 * f64::from(i)], [1e6, 0.0], [-1e6, 0.0]] {
            returned.predict(DVector::from_row_slice(&u), DMatrix::zeros(3, 3)).expect("finite");
        }
        assert_eq!(sound(&returned), Ok(()), "{i}");
    }
    // Back by parts: no step's terms cancel by much, and what was rounding beside the first is not beside the last.
    for lever in [1e2, 1e3, 1e4, 1e6] {
        for part in [0.2, 0.35, 0.5] {
            let mut returned = localizer_of([0.0, 0.0, 0.1], [0.1, 0.1]);
            let mut away = lever;
            returned.predict(DVector::from_row_slice(&[lever, 0.0]), DMatrix::zeros(3, 3)).expect("finite");
            while away > 1e-3 {
                returned.predict(DVector::from_row_slice(&[-part * away, 0.0]), DMatrix::zeros(3, 3)).expect("finite");
                away -= part * away;
                assert_eq!(sound(&returned), Ok(()), "{lever} by {part}, {away} m to go");
            }
            let again = EkfLocalizer::new(
                returned.belief(),
                vec![Landmark { id: 1, x: 6.0, y: 6.0 }],
                DMatrix::identity(1, 1),
                None,
                SensorKind::Range,
            );
            assert!(again.is_ok(), "its own belief is refused: {again:?}");
        }
    }
}
