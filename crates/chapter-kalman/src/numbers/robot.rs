//! Numbers of the Jacobians (check 8) and of Problem 9 (check 13).

use crate::checks::jacobians::{central_gap, raw_gap};
use crate::checks::problem9::{WIDE, displacement, ekf, gap};
use crate::givens::Givens;
use estimate::Error;
use filters::ukf::SigmaPoints;
use lab::Listing;
use nalgebra::Vector2;

pub(super) fn list(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    to.by("chapter_kalman::checks::jacobians::raw_gap", Some(8))
        .add("jacobian.raw.gap", raw_gap()?, "the largest difference of the simplified bearing row from the raw one")
        .by("chapter_kalman::checks::jacobians::central_gap", Some(8))
        .add("jacobian.central.gap", central_gap()?, "the largest difference of a Jacobian from central differences");
    problem9(givens, to)?;
    wrong_problem9(givens, to)
}

fn problem9(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let problem = &givens.problem9;
    let u = displacement(problem);
    let step = ekf(problem, u)?;
    to.by("chapter_kalman::checks::problem9::ekf", Some(13))
        .add("problem9.displacement", u[0], "T u₁, the distance driven")
        .vector("problem9.xpred", step.predicted.x.to_vector().iter(), "the predicted pose")
        .add("problem9.F.13", step.f[(0, 2)], "F₁₃, at the old heading")
        .add("problem9.F.23", step.f[(1, 2)], "F₂₃, at the old heading")
        .add("problem9.nu", step.innovation, "the innovation")
        .add("problem9.S", step.s, "the innovation's variance")
        .vector("problem9.R", step.r.iter(), "the Kalman gain")
        .vector("problem9.x", step.posterior.x.to_vector().iter(), "the corrected pose")
        .symmetric("problem9.Ppred", &step.predicted.p, "the predicted covariance")
        .symmetric("problem9.P", &step.posterior.p, "the corrected covariance")
        .by("chapter_kalman::checks::problem9::gap", Some(13))
        .vector("problem9.ukf.gap", gap(problem, SigmaPoints::default())?.iter(), "UKF − EKF, α = 10⁻³, β = 2, κ = 0")
        .vector("problem9.ukf.gap.wide", gap(problem, WIDE)?.iter(), "UKF − EKF, α = 1, β = 0, κ = 0")
        .vector(
            "problem9.ukf.between",
            (gap(problem, SigmaPoints::default())? - gap(problem, WIDE)?).abs().iter(),
            "how far the two sets of sigma points are apart",
        );
    Ok(())
}

/// What a slip in Problem 9 would give: the answers that the quiz recognizes.
fn wrong_problem9(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let mut turned = givens.problem9;
    let u = displacement(&turned);
    let no_t = ekf(&turned, Vector2::new(turned.u[0], u[1]))?.posterior.x.x();
    turned.x[2] += u[1];
    let new_heading = ekf(&turned, Vector2::new(u[0], 0.0))?.posterior.x.x();
    to.by("chapter_kalman::numbers::robot::wrong_problem9", None)
        .add("problem9.near.no-t", no_t, "x₁ when u₁ is taken for the displacement")
        .add("problem9.near.new-heading", new_heading, "x₁ when the heading after the turn moves the robot");
    Ok(())
}
