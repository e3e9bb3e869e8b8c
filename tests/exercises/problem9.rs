//! The exercise "Choset's Problem 9 as a test". Fill in `yours` and run
//! `cargo test -p chapter-tests --test problem9 -- --ignored`.

use nalgebra::{Matrix3, RowVector3, Vector2, Vector3};

type Belief = (Vector3<f64>, Matrix3<f64>);

mod yours {
    use super::*;

    // ANCHOR: starter
    /// One EKF step of the unicycle: the belief (x̂, P) after
    /// driving with the velocities `u` = [m/s, rad/s] for `t`
    /// seconds without process noise, and then reading
    /// `y` = x₁ + w with Var w = `w`.
    pub fn ekf_step((x, p): Belief, u: Vector2<f64>, t: f64, y: f64, w: f64) -> Belief {
        let _ = (x, p, u, t, y, w);
        todo!("predict with f and F, update with H = [1 0 0]")
    }
    // ANCHOR_END: starter
}

mod ours {
    use super::*;

    // ANCHOR: answer
    pub fn ekf_step((x, p): Belief, u: Vector2<f64>, t: f64, y: f64, w: f64) -> Belief {
        let (distance, turn, heading) = (t * u[0], t * u[1], x[2]);
        let predicted = x + Vector3::new(distance * heading.cos(), distance * heading.sin(), turn);
        let f = Matrix3::new(1.0, 0.0, -distance * heading.sin(), 0.0, 1.0, distance * heading.cos(), 0.0, 0.0, 1.0);
        let p = f * p * f.transpose();

        let h = RowVector3::new(1.0, 0.0, 0.0);
        let s = (h * p * h.transpose())[0] + w;
        let gain = p * h.transpose() / s;
        let left = Matrix3::identity() - gain * h;
        (predicted + gain * (y - predicted[0]), left * p * left.transpose() + gain * w * gain.transpose())
    }
    // ANCHOR_END: answer
}

// ANCHOR: tests
fn solves_problem_9(ekf_step: fn(Belief, Vector2<f64>, f64, f64, f64) -> Belief) {
    use std::f64::consts::{FRAC_PI_4, PI};
    let belief = (Vector3::new(1.0, 0.5, FRAC_PI_4), Matrix3::identity());
    let (x, p) = ekf_step(belief, Vector2::new(3.0, PI), 0.25, 1.7, 0.5);
    println!("x̂(2 | 2) = {x:.4}P(2 | 2) = {p:.4}");
    assert!((x - Vector3::new(1.652373357442782, 1.0035400994514754, 1.5202806439188616)).amax() < 1e-12);
    let variances = Vector3::new(41.0 / 114.0, 47.0 / 38.0, 16.0 / 19.0);
    assert!((p.diagonal() - variances).amax() < 1e-12);
    assert!((p - p.transpose()).amax() < 1e-15);
}

fn takes_the_heading_before_the_turn(ekf_step: fn(Belief, Vector2<f64>, f64, f64, f64) -> Belief) {
    // Facing along x and turning left by a quarter circle, the robot ends straight ahead of where it was.
    let belief = (Vector3::zeros(), Matrix3::identity());
    let (x, p) = ekf_step(belief, Vector2::new(1.0, std::f64::consts::FRAC_PI_2), 1.0, 1.0, 0.5);
    assert!((x - Vector3::new(1.0, 0.0, std::f64::consts::FRAC_PI_2)).amax() < 1e-12);
    // Its heading error has become an error sideways, in y.
    assert!((p[(1, 2)] - 1.0).abs() < 1e-12 && p[(0, 2)].abs() < 1e-12);
}
// ANCHOR_END: tests

#[test]
fn ours_solves_problem_9() {
    solves_problem_9(ours::ekf_step);
}

#[test]
fn ours_takes_the_heading_before_the_turn() {
    takes_the_heading_before_the_turn(ours::ekf_step);
}

#[test]
#[ignore = "yours to write"]
fn yours_solves_problem_9() {
    solves_problem_9(yours::ekf_step);
}

#[test]
#[ignore = "yours to write"]
fn yours_takes_the_heading_before_the_turn() {
    takes_the_heading_before_the_turn(yours::ekf_step);
}
