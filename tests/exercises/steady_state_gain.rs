//! The exercise "The steady-state gain". Fill in `yours` and run
//! `cargo test -p chapter-tests --test steady_state_gain -- --ignored`.

use estimate::kf::kalman_step;
use estimate::rail::{dead_reckoning, position_sensor};
use estimate::{Lti, Observer};
use nalgebra::{Matrix2, U1, U2, Vector1, Vector2};

mod yours {
    use super::*;

    // ANCHOR: starter
    /// The gain at which the Riccati recursion comes to rest
    /// from `p0` = P(0 | 0), and whether P(k+1 | k) came to rest:
    /// whether, within `max_iters` steps, its largest change in a
    /// step fell to `tol` of its largest entry.
    pub fn steady_state_gain(
        sys: &Lti<U2, U1, U1>,
        p0: &Matrix2<f64>,
        max_iters: usize,
        tol: f64,
    ) -> (Vector2<f64>, bool) {
        let _ = (sys, p0, max_iters, tol);
        todo!("predict, gain, Joseph update, until P rests")
    }
    // ANCHOR_END: starter
}

mod ours {
    use super::*;

    // ANCHOR: answer
    pub fn steady_state_gain(
        sys: &Lti<U2, U1, U1>,
        p0: &Matrix2<f64>,
        max_iters: usize,
        tol: f64,
    ) -> (Vector2<f64>, bool) {
        let mut posterior = *p0;
        let mut last = Matrix2::zeros();
        let mut gain = Vector2::zeros();
        for _ in 0..max_iters {
            let predicted = sys.f * posterior * sys.f.transpose() + sys.v;
            let s = (sys.h * predicted * sys.h.transpose() + sys.w)[0];
            gain = predicted * sys.h.transpose() / s;
            let left = Matrix2::identity() - gain * sys.h;
            posterior = left * predicted * left.transpose() + gain * sys.w * gain.transpose();
            if (predicted - last).amax() <= tol * predicted.amax() {
                return (gain, true);
            }
            last = predicted;
        }
        (gain, false)
    }
    // ANCHOR_END: answer
}

type Solution = fn(&Lti<U2, U1, U1>, &Matrix2<f64>, usize, f64) -> (Vector2<f64>, bool);

// ANCHOR: tests
fn agrees_with_the_filter(steady_state_gain: Solution) {
    let (sys, mut belief) = position_sensor();
    let (k, converged) = steady_state_gain(&sys, &belief.p, 10_000, 1e-12);
    assert!(converged);
    let mut observer = Observer { sys, k, xhat: belief.x };
    for step in 0..50 {
        let y = Vector1::new(f64::from(step % 7));
        belief = kalman_step(&sys, &belief, &Vector1::zeros(), &y).expect("S is positive").posterior;
        observer.step(&Vector1::zeros(), &y);
    }
    assert!((observer.xhat - belief.x).amax() < 1e-6);
}

fn tells_a_gain_that_settles_from_a_covariance_that_does_not(steady_state_gain: Solution) {
    let (sys, belief) = dead_reckoning();
    let (gain, converged) = steady_state_gain(&sys, &belief.p, 500, 1e-12);
    assert!(!converged);
    let (later, _) = steady_state_gain(&sys, &belief.p, 1000, 1e-12);
    assert!((later - gain).amax() < 1e-12);
    assert!((gain - Vector2::new(0.5, (21.0_f64.sqrt() - 1.0) / 10.0)).amax() < 1e-9);
}
// ANCHOR_END: tests

#[test]
fn ours_agrees_with_the_filter() {
    agrees_with_the_filter(ours::steady_state_gain);
}

#[test]
fn ours_tells_a_gain_that_settles() {
    tells_a_gain_that_settles_from_a_covariance_that_does_not(ours::steady_state_gain);
}

#[test]
#[ignore = "yours to write"]
fn yours_agrees_with_the_filter() {
    agrees_with_the_filter(yours::steady_state_gain);
}

#[test]
#[ignore = "yours to write"]
fn yours_tells_a_gain_that_settles() {
    tells_a_gain_that_settles_from_a_covariance_that_does_not(yours::steady_state_gain);
}
