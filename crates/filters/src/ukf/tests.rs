//! The unscented filter.

use super::*;
use crate::error::Parameter;
use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};

struct Square;

impl MotionModel<Vector1<f64>, 1, 1> for Square {
    fn f(&self, x: &Vector1<f64>, _: &SVector<f64, 1>) -> Vector1<f64> {
        Vector1::new(x[0] * x[0])
    }
}

struct Sum;

impl MotionModel<Vector2<f64>, 2, 1> for Sum {
    fn f(&self, x: &Vector2<f64>, u: &SVector<f64, 1>) -> Vector2<f64> {
        Vector2::new(x[0] + 2.0 * x[1], x[1] + u[0])
    }

    fn jacobian(&self, _: &Vector2<f64>, _: &SVector<f64, 1>) -> Matrix2<f64> {
        Matrix2::new(1.0, 2.0, 0.0, 1.0)
    }
}

impl MeasurementModel<Vector2<f64>, 2, 1> for Sum {
    fn h(&self, x: &Vector2<f64>, _: usize) -> Result<Vector1<f64>, Error> {
        Ok(Vector1::new(3.0 * x[0] - x[1]))
    }

    fn jacobian(&self, _: &Vector2<f64>, _: usize) -> Result<RowVector2<f64>, Error> {
        Ok(RowVector2::new(3.0, -1.0))
    }
}

impl MeasurementModel<Vector1<f64>, 1, 1> for Square {
    fn h(&self, x: &Vector1<f64>, _: usize) -> Result<Vector1<f64>, Error> {
        Ok(Vector1::new(x[0] * x[0]))
    }
}

/// E x² = μ² + σ², and Var x² = 4μ²σ² + 2σ⁴ for a normal x: both exact with κ = 2, α = 1, β = 0.
#[test]
fn the_moments_of_a_square_are_exact() {
    let points = SigmaPoints { alpha: 1.0, beta: 0.0, kappa: 2.0 };
    let mut ukf = Ukf { x: Vector1::new(3.0), p: Matrix1::new(0.25), points };
    ukf.predict(&Square, &Vector1::zeros(), &Matrix1::zeros()).expect("positive definite");
    assert!((ukf.x[0] - 9.25).abs() < 1e-14);
    assert!((ukf.p[0] - (4.0 * 9.0 * 0.25 + 2.0 * 0.0625)).abs() < 1e-13);
}

/// By hand: of x² the mean is met whatever the points, the variance found is 4μ²σ² + (α²κ + β)σ⁴, the covariance
/// with x 2μσ².
#[test]
fn alpha_beta_and_kappa_enter_the_moments_of_a_square_as_derived() {
    let (mu, var, q) = (3.0, 0.25, 0.5);
    let (points, fourth) = (SigmaPoints { alpha: 0.5, beta: 1.5, kappa: 3.0 }, 0.25 * 3.0 + 1.5);
    let spread = 4.0 * mu * mu * var + fourth * var * var;
    let start = Ukf { x: Vector1::new(mu), p: Matrix1::new(var), points };
    let mut moved = start;
    moved.predict(&Square, &Vector1::zeros(), &Matrix1::new(q)).expect("positive definite");
    assert!((moved.x[0] - (mu * mu + var)).abs() < 1e-14 && (moved.p[0] - (spread + q)).abs() < 1e-13);

    let mut read = start;
    let update = read.update(&Square, &Vector1::new(10.0), 0, &Matrix1::new(q)).expect("positive definite");
    let (s, cross) = (spread + q, 2.0 * mu * var);
    assert!((update.innovation[0] - (10.0 - mu * mu - var)).abs() < 1e-14 && (update.s[0] - s).abs() < 1e-13);
    assert!((update.k[0] - cross / s).abs() < 1e-15);
    assert!((read.x[0] - (mu + update.k[0] * update.innovation[0])).abs() < 1e-15);
    assert!((read.p[0] - (var - cross * cross / s)).abs() < 1e-15);
    assert!(update.d2.is_some_and(|d2| (d2 - update.innovation[0] * update.innovation[0] / s).abs() < 1e-15));
}

#[test]
fn on_a_linear_system_every_choice_of_points_is_the_kalman_filter() {
    let (r, q) = (Matrix2::identity() * 0.1, Matrix1::new(0.5));
    let mut exact = crate::ekf::Ekf { x: Vector2::new(1.0, -1.0), p: Matrix2::new(2.0, 0.5, 0.5, 1.0) };
    let start = exact;
    exact.predict(&Sum, &Vector1::new(0.5), &r).expect("finite");
    exact.update(&Sum, &Vector1::new(2.0), 0, &q).expect("positive definite");
    for (points, digits) in [(SigmaPoints::default(), 1e-8), (SigmaPoints { alpha: 1.0, beta: 0.0, kappa: 0.0 }, 1e-14)]
    {
        let mut ukf = Ukf { x: start.x, p: start.p, points };
        ukf.predict(&Sum, &Vector1::new(0.5), &r).expect("positive definite");
        ukf.update(&Sum, &Vector1::new(2.0), 0, &q).expect("positive definite");
        // With α = 1e-3 the weights are 1e6: six digits are spent on them.
        assert!((ukf.x - exact.x).amax() < digits && (ukf.p - exact.p).amax() < digits);
    }
}

#[test]
fn sigma_points_that_cannot_be_placed_are_refused_and_the_belief_kept() {
    for points in [
        SigmaPoints { alpha: 0.0, ..Default::default() },
        SigmaPoints { kappa: -2.0, ..Default::default() },
        SigmaPoints { beta: f64::NAN, ..Default::default() },
        SigmaPoints { alpha: -0.5, ..Default::default() },
        SigmaPoints { alpha: 1e200, ..Default::default() },
    ] {
        let mut ukf = Ukf { x: Vector2::zeros(), p: Matrix2::identity(), points };
        let refused = ukf.predict(&Sum, &Vector1::zeros(), &Matrix2::zeros());
        assert_eq!(refused, Err(Error::OutOfRange(Parameter::SigmaPoints)));
    }
    let singular = Ukf { x: Vector2::zeros(), p: Matrix2::zeros(), points: SigmaPoints::default() };
    let mut ukf = singular;
    assert!(ukf.update(&Sum, &Vector1::zeros(), 0, &Matrix1::new(1.0)).is_err());
    assert_eq!(ukf, singular);
}
