//! Whatever SLAM is given, it answers or refuses: no panic, no change by a refused call, and after every accepted one a
//! covariance that is one.

#![cfg(not(target_arch = "wasm32"))]

#[path = "src/draws.rs"]
mod draws;

use estimate::slam::{EkfSlam, LandmarkReading};
use estimate::validate;
use nalgebra::{DMatrix, dvector};
use proptest::prelude::*;

/// Numbers as a page may send them: ordinary ones mostly, and the worst there are.
fn number(ordinary: u32) -> impl Strategy<Value = f64> {
    prop_oneof![
        ordinary => -10.0..10.0_f64,
        1 => prop::sample::select(vec![
            f64::NAN, f64::INFINITY, -f64::INFINITY, 1e308, -1e308, 5e-324, 1e-160, 0.0, -0.0, 1e9,
        ]),
    ]
}

/// A covariance of one, two or three unequal scales, sometimes vast, tiny, singular or none at all.
fn square(n: usize) -> impl Strategy<Value = DMatrix<f64>> {
    (prop::collection::vec(number(60), n * n), -9..9_i32, 0..10_u32).prop_map(move |(entries, scale, sound)| {
        let root = DMatrix::from_vec(n, n, entries);
        let scale = libm::exp10(f64::from(scale));
        if sound > 0 { &root * root.transpose() * scale } else { root * scale }
    })
}

proptest! {
    #![proptest_config(draws::cases(1000))]

    /// Whatever is sent: no panic, a refusal changes nothing, and what is accepted leaves a covariance.
    #[test]
    fn random_numbers_are_taken_or_refused_and_a_refusal_changes_nothing(
        (p, w, v) in (square(3), square(2), square(3)),
        steps in prop::collection::vec(
            (number(12), number(12), number(12), number(12), 0..4_u32, any::<bool>()),
            1..25,
        ),
    ) {
        let Ok(belief) = validate::belief(dvector![0.0, 0.0, 0.0], p) else { return Ok(()) };
        let Ok(mut slam) = EkfSlam::from_belief(&belief, w, Some(9.21), 50.0) else { return Ok(()) };
        for (a, b, c, d, id, named) in steps {
            let (x, before) = slam.belief();
            let (x, before) = (x.to_vec(), before);
            let one = LandmarkReading { range: c.abs(), bearing: d, landmark: named.then_some(id) };
            let accepted = match id {
                0 => slam.predict_by(dvector![a, b], v.clone()).is_ok(),
                1 => slam.update(&[one, LandmarkReading { range: a, bearing: b, landmark: None }]).is_ok(),
                _ => slam.update(&[one]).is_ok(),
            };
            let (now, after) = slam.belief();
            if accepted {
                prop_assert!(now.iter().chain(after.iter()).all(|e| e.is_finite()));
                let scale = after.amax();
                if scale > 0.0 {
                    let eigenvalues = (&after / scale).symmetric_eigenvalues();
                    prop_assert!(eigenvalues.min() >= -1e-12 * eigenvalues.max(), "{}", eigenvalues);
                }
            } else {
                prop_assert_eq!(now, x.as_slice());
                prop_assert_eq!(after, before);
            }
        }
    }
}
