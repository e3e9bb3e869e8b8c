//! The exercise "Choset's Problem 9 as a test". Fill in `yours` and run
//! `cargo test -p chapter-tests --test problem9 -- --ignored`.

use estimate::Unicycle;
use filters::MeasurementModel;
use filters::ukf::{SigmaPoints, Ukf};
use geom::SE2;
use nalgebra::{Matrix1, Matrix3, RowVector3, Vector1, Vector2, Vector3};

type Belief = (Vector3<f64>, Matrix3<f64>);

/// The sensor y = x₁ + w, for the library's filters.
struct Position;

impl MeasurementModel<SE2, 3, 1> for Position {
    fn h(&self, pose: &SE2, _: usize) -> Result<Vector1<f64>, filters::Error> {
        Ok(Vector1::new(pose.x()))
    }

    fn jacobian(&self, _: &SE2, _: usize) -> Result<RowVector3<f64>, filters::Error> {
        Ok(RowVector3::new(1.0, 0.0, 0.0))
    }
}

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

    /// The same step by the library's `Ukf`, with these sigma
    /// points. Its models are `Unicycle`, which takes distance
    /// and turn, and `Position`, the sensor y = x₁.
    pub fn ukf_step((x, p): Belief, u: Vector2<f64>, t: f64, y: f64, w: f64, points: SigmaPoints) -> Belief {
        let _ = (x, p, u, t, y, w, points);
        todo!("make a Ukf; predict; update")
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

    pub fn ukf_step((x, p): Belief, u: Vector2<f64>, t: f64, y: f64, w: f64, points: SigmaPoints) -> Belief {
        let mut ukf = Ukf { x: SE2::from_vector(&x), p, points };
        ukf.predict(&Unicycle, &(u * t), &Matrix3::zeros()).expect("P is positive definite");
        ukf.update(&Position, &Vector1::new(y), 0, &Matrix1::new(w)).expect("S is positive");
        (ukf.x.to_vector(), ukf.p)
    }
    // ANCHOR_END: answer
}

type EkfStep = fn(Belief, Vector2<f64>, f64, f64, f64) -> Belief;
type UkfStep = fn(Belief, Vector2<f64>, f64, f64, f64, SigmaPoints) -> Belief;

// ANCHOR: tests
fn solves_problem_9(ekf_step: EkfStep) {
    use std::f64::consts::{FRAC_PI_4, PI};
    let belief = (Vector3::new(1.0, 0.5, FRAC_PI_4), Matrix3::identity());
    let (x, p) = ekf_step(belief, Vector2::new(3.0, PI), 0.25, 1.7, 0.5);
    println!("x̂(2 | 2) = {x:.4}P(2 | 2) = {p:.4}");
    assert!((x - Vector3::new(1.652373357442782, 1.0035400994514754, 1.5202806439188616)).amax() < 1e-12);
    let variances = Vector3::new(41.0 / 114.0, 47.0 / 38.0, 16.0 / 19.0);
    assert!((p.diagonal() - variances).amax() < 1e-12);
    assert!((p - p.transpose()).amax() < 1e-15);
}

fn takes_the_heading_before_the_turn(ekf_step: EkfStep) {
    // Facing along x and turning left by a quarter circle, the robot ends straight ahead of where it was.
    let belief = (Vector3::zeros(), Matrix3::identity());
    let (x, p) = ekf_step(belief, Vector2::new(1.0, std::f64::consts::FRAC_PI_2), 1.0, 1.0, 0.5);
    assert!((x - Vector3::new(1.0, 0.0, std::f64::consts::FRAC_PI_2)).amax() < 1e-12);
    // Its heading error has become an error sideways, in y.
    assert!((p[(1, 2)] - 1.0).abs() < 1e-12 && p[(0, 2)].abs() < 1e-12);
}

fn reports_the_gap(ekf_step: EkfStep, ukf_step: UkfStep) {
    use std::f64::consts::{FRAC_PI_4, PI};
    let belief = (Vector3::new(1.0, 0.5, FRAC_PI_4), Matrix3::identity());
    let (straight, _) = ekf_step(belief, Vector2::new(3.0, PI), 0.25, 1.7, 0.5);
    let wide = SigmaPoints { alpha: 1.0, beta: 0.0, kappa: 0.0 };
    for (points, gap) in [
        (SigmaPoints::default(), Vector3::new(-0.0655011, -0.2701921, -0.0694744)),
        (wide, Vector3::new(-0.0642284, -0.1799695, -0.0170926)),
    ] {
        let (curved, p) = ukf_step(belief, Vector2::new(3.0, PI), 0.25, 1.7, 0.5, points);
        println!("UKF minus EKF: {:.4}", curved - straight);
        assert!((curved - straight - gap).amax() < 1e-6);
        assert!((p - p.transpose()).amax() < 1e-12 && p.determinant() > 0.0);
    }
}

fn finds_no_gap_where_nothing_bends(ekf_step: EkfStep, ukf_step: UkfStep) {
    // Turning on the spot, the model is a straight line, and every choice of points is the Kalman filter.
    let belief = (Vector3::new(1.0, 0.5, 0.25), Matrix3::from_diagonal(&Vector3::new(1.0, 2.0, 0.5)));
    let (x, p) = ekf_step(belief, Vector2::new(0.0, 1.0), 0.25, 1.7, 0.5);
    let (curved, q) = ukf_step(belief, Vector2::new(0.0, 1.0), 0.25, 1.7, 0.5, SigmaPoints::default());
    // The weights are near 1e6 and spend six digits.
    assert!((curved - x).amax() < 1e-8 && (q - p).amax() < 1e-8);
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
fn ours_reports_the_gap() {
    reports_the_gap(ours::ekf_step, ours::ukf_step);
}

#[test]
fn ours_finds_no_gap_where_nothing_bends() {
    finds_no_gap_where_nothing_bends(ours::ekf_step, ours::ukf_step);
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

#[test]
#[ignore = "yours to write"]
fn yours_reports_the_gap() {
    reports_the_gap(yours::ekf_step, yours::ukf_step);
}

#[test]
#[ignore = "yours to write"]
fn yours_finds_no_gap_where_nothing_bends() {
    finds_no_gap_where_nothing_bends(yours::ekf_step, yours::ukf_step);
}
