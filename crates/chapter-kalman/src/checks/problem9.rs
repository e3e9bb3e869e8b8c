//! Check 13: Choset's Problem 9 (chapter 8), by the EKF and by the UKF.

use crate::givens::Givens;
use estimate::Error;
use estimate::Unicycle;
use filters::ukf::{SigmaPoints, Ukf};
use filters::{Ekf, MeasurementModel, MotionModel};
use geom::SE2;
use lab::Check;
use nalgebra::{Matrix1, Matrix3, RowVector3, Vector1, Vector2, Vector3};
use sim::scenarios::Problem9;

/// y = x₁ + w.
struct FirstCoordinate;

impl MeasurementModel<SE2, 3, 1> for FirstCoordinate {
    fn h(&self, x: &SE2, _: usize) -> Result<Vector1<f64>, filters::Error> {
        Ok(Vector1::new(x.x()))
    }

    fn jacobian(&self, _: &SE2, _: usize) -> Result<RowVector3<f64>, filters::Error> {
        Ok(RowVector3::new(1.0, 0.0, 0.0))
    }
}

/// The step of the EKF, in all its parts.
pub(crate) struct EkfStep {
    pub f: Matrix3<f64>,
    pub predicted: Ekf<SE2, 3>,
    pub innovation: f64,
    pub s: f64,
    pub r: Vector3<f64>,
    pub posterior: Ekf<SE2, 3>,
}

fn start(problem: &Problem9) -> (SE2, Matrix3<f64>) {
    (SE2::from_vector(&Vector3::from(problem.x)), Matrix3::identity() * problem.p)
}

/// [Δs, Δθ] = T u: the problem's input is a velocity and a turn rate.
pub(crate) fn displacement(problem: &Problem9) -> Vector2<f64> {
    Vector2::from(problem.u) * problem.period
}

/// The EKF's step when it is told the displacement `u`.
pub(crate) fn ekf(problem: &Problem9, u: Vector2<f64>) -> Result<EkfStep, Error> {
    let (x, p) = start(problem);
    let mut ekf = Ekf { x, p };
    ekf.predict(&Unicycle, &u, &Matrix3::zeros())?;
    let predicted = ekf;
    let update = ekf.update(&FirstCoordinate, &Vector1::new(problem.y), 0, &Matrix1::new(problem.w))?;
    let f = Unicycle.jacobian(&x, &u);
    Ok(EkfStep { f, predicted, innovation: update.innovation[0], s: update.s[0], r: update.k, posterior: ekf })
}

/// UKF minus EKF, after the step.
pub(crate) fn gap(problem: &Problem9, points: SigmaPoints) -> Result<Vector3<f64>, Error> {
    let (x, p) = start(problem);
    let u = displacement(problem);
    let mut ukf = Ukf { x, p, points };
    ukf.predict(&Unicycle, &u, &Matrix3::zeros())?;
    ukf.update(&FirstCoordinate, &Vector1::new(problem.y), 0, &Matrix1::new(problem.w))?;
    Ok(ukf.x.boxminus(ekf(problem, u)?.posterior.x))
}

/// α = 1, β = 0, κ = 0: points a standard deviation times √3 away, all of one kind.
pub(crate) const WIDE: SigmaPoints = SigmaPoints { alpha: 1.0, beta: 0.0, kappa: 0.0 };

/// Check 13: x̂(2 | 2), the variances of P(2 | 2), and UKF − EKF for both spreads of sigma points.
pub(super) fn problem9(givens: &Givens) -> Result<Check, Error> {
    let problem = &givens.problem9;
    let step = ekf(problem, displacement(problem))?.posterior;
    let mut actual: Vec<f64> = step.x.to_vector().iter().copied().collect();
    actual.extend(step.p.diagonal().iter());
    actual.extend(gap(problem, SigmaPoints::default())?.iter());
    actual.extend(gap(problem, WIDE)?.iter());
    // The variances as fractions; the rest computed independently, the gaps to seven decimals.
    let expected = [
        [1.652373357442782, 1.0035400994514754, 1.5202806439188616],
        [41.0 / 114.0, 47.0 / 38.0, 16.0 / 19.0],
        [-0.0655011, -0.2701921, -0.0694744],
        [-0.0642284, -0.1799695, -0.0170926],
    ];
    let title = "Problem 9: the EKF's mean and variances, and the gap to the UKF at two spreads";
    Ok(Check::new(13, title, expected.concat(), actual, 1e-7))
}
