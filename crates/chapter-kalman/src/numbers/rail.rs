//! Numbers of the rail robot: the hand-checked steps, the picture, the knob and its limits.

use crate::checks::rail::{brute_force, error_ratios, hand_steps, placed};
use crate::givens::Givens;
use estimate::kf::Gaussian;
use estimate::{Error, Observer};
use filters::consistency::{chi2_interval, chi2_quantile, mahalanobis_squared};
use filters::linear::{self, Gain};
use geom::AffineSet;
use lab::Listing;
use labs::inside;
use labs::observer_bench::{equivalent_knob, knob_limit};
use nalgebra::{Matrix2, RowVector2, SMatrix, Vector1, Vector2};

const LIMIT_TOLERANCE: f64 = 1e-12;
const LIMIT_ITERATIONS: usize = 10_000;

pub(super) fn list(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    steps(givens, to)?;
    wrong_third_steps(givens, to)?;
    picture(givens, to)?;
    limits(givens, to)?;
    gains(givens, to)?;
    noise(givens, to)?;
    Ok(())
}

fn steps(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    for (k, step) in (1..).zip(hand_steps(givens)?) {
        to.by("chapter_kalman::checks::rail::hand_steps", (k <= 2).then_some(k))
            .vector(&format!("step{k}.xpred"), step.predicted.x.iter(), "the predicted mean")
            .symmetric(&format!("step{k}.Ppred"), &step.predicted.p, "the predicted covariance")
            .add(format!("step{k}.nu"), step.innovation[0], "the innovation")
            .add(format!("step{k}.S"), step.s[0], "the innovation's variance")
            .add(format!("step{k}.nuS"), step.innovation[0] / step.s[0], "the innovation over its variance")
            .vector(&format!("step{k}.R"), step.r.iter(), "the Kalman gain")
            .vector(&format!("step{k}.x"), step.posterior.x.iter(), "the corrected mean")
            .symmetric(&format!("step{k}.P"), &step.posterior.p, "the corrected covariance");
    }
    Ok(())
}

/// What a slip in the third step would give: the answers that the quiz recognizes.
fn wrong_third_steps(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let steps = hand_steps(givens)?;
    let (sys, p) = (&givens.velocity, &steps[1].posterior.p);
    let after = |predicted: &Matrix2<f64>, w: f64| -> Result<f64, Error> {
        Ok(linear::gain(predicted, &sys.h, &SMatrix::<f64, 1, 1>::new(w))?.p[(0, 0)])
    };
    let right = linear::predicted_covariance(&sys.f, p, &sys.v)?;
    let no_v = linear::predicted_covariance(&sys.f, p, &Matrix2::zeros())?;
    let transposed = linear::predicted_covariance(&sys.f.transpose(), p, &sys.v)?;
    // The corner of FPFᵀ is P₁₁ + 2T P₁₂ + T²P₂₂.
    let mut cross_once = right;
    cross_once[(0, 0)] -= sys.f[(0, 1)] * p[(0, 1)];
    to.by("chapter_kalman::numbers::rail::wrong_third_steps", None)
        .add("step3.near.cross-once", after(&cross_once, sys.w[0])?, "P₁₁ of the third step with T P₁₂ counted once")
        .add("step3.near.no-update", right[(0, 0)], "P₁₁ of the third step without its update")
        .add("step3.near.no-v", after(&no_v, sys.w[0])?, "P₁₁ of the third step when V is forgotten")
        .add("step3.near.no-w", after(&right, 0.0)?, "P₁₁ of the third step when W is forgotten")
        .add("step3.near.transposed", after(&transposed, sys.w[0])?, "P₁₁ of the third step predicted with FᵀPF");
    Ok(())
}

fn picture(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let steps = hand_steps(givens)?;
    let prediction = &steps[0].predicted;
    let (sys, p) = (&givens.velocity, &prediction.p);
    let y = Vector1::new(givens.readings[0]);
    let spread = sys.h * p * sys.h.transpose();
    let expected = Gaussian { x: sys.h * prediction.x, p: spread };
    let Gaussian { x: most_likely, p: product } = expected.product(&Gaussian { x: y, p: sys.w })?;
    let omega = AffineSet { h: sys.h, y };
    let no_foot = || Error::new(estimate::Code::InnovationNotPositiveDefinite, "P", "Ω has no foot");
    let euclid = omega.euclidean_foot(&prediction.x).ok_or_else(no_foot)?;
    let foot = omega.mahalanobis_foot(p, &prediction.x).ok_or_else(no_foot)?;
    let correlation = p[(0, 1)] / (p[(0, 0)] * p[(1, 1)]).sqrt();
    to.by("geom::AffineSet", Some(1))
        .vector("picture.euclid", euclid.iter(), "the Euclidean foot on Ω")
        .vector("picture.foot", foot.iter(), "the Mahalanobis foot on Ω")
        .by("filters::gaussian::product", Some(1))
        .add("picture.ystar", most_likely[0], "y*, the most likely output")
        .by("chapter_kalman::numbers::rail::picture", Some(1))
        .add("picture.drag", p[(0, 1)] / p[(1, 1)], "metres the position moves for each m/s the velocity is corrected")
        .add("picture.correlation", correlation, "the correlation of position and velocity in the prediction")
        .vector("picture.sigma", p.diagonal().map(f64::sqrt).iter(), "a standard deviation of the prediction: m, m/s");
    let ellipse = geom::Ellipse::from_covariance(p, 1.0);
    to.by("geom::Ellipse", None)
        .add("picture.axis", 1.0 / libm::tan(ellipse.angle), "metres the ellipse's long axis moves over for each m/s")
        .by("chapter_kalman::numbers::rail::picture", None);
    for level in [1, 2, 3] {
        let inside = inside(f64::from(level));
        to.add(format!("ellipse.inside.{level}"), inside, "the part of a plane Gaussian inside this many sigmas");
    }
    let away = |at: Vector2<f64>| mahalanobis_squared(&(at - prediction.x), p).map(f64::sqrt);
    let (touch, gray) = (away(foot)?, away(euclid)?);
    let density = libm::exp(0.5 * (touch * touch - gray * gray));
    to.add("picture.touch", touch, "radius of the first ellipse that touches Ω, standard deviations")
        .add("picture.touch.inside", 100.0 * inside(touch), "the probability inside it, per cent")
        .add("picture.sigma.inside", 100.0 * inside(1.0), "the probability inside the 1σ ellipse, per cent")
        .add("picture.gray", gray, "how many standard deviations away the Euclidean foot is")
        .add("picture.gray.density", density, "the density at the Euclidean foot over that at the Mahalanobis foot")
        .add("picture.touch.even", 0.5 * touch, "radius of the ellipse that touches Ω* where y* lies in the middle")
        .add("balance.even", 0.5, "the part of the innovation that is then taken over")
        .add("balance.expected", 1.0 / spread[0], "weight of the expected output, 1/variance")
        .add("balance.read", 1.0 / sys.w[0], "weight of the reading, 1/variance")
        .add("balance.variance", product[0], "variance of the most likely output")
        .add("picture.even", spread[0], "the W with which y* lies in the middle, the variance of the expected output");
    Ok(())
}

fn limits(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let p0 = &givens.belief.p;
    for (name, sys) in [("position", &givens.position), ("velocity", &givens.velocity)] {
        let limit = sys.steady_state_gain(p0, LIMIT_ITERATIONS, LIMIT_TOLERANCE)?;
        let posterior = linear::gain(&limit.p, &sys.h, &sys.w)?.p;
        let eigenvalues = Observer { sys: *sys, k: limit.r, xhat: Vector2::zeros() }.error_eigs()?;
        let (first, second) = (eigenvalues[0], eigenvalues[1]);
        let modulus = numerics::hypot(first.re, first.im);
        let gains = sys.gain_schedule(p0, 500)?;
        let knobs: Vec<f64> = gains.iter().take(8).map(|r| equivalent_knob(sys, r, &limit.r)).collect();
        to.by("estimate::Lti::steady_state_gain", Some(7))
            .vector(&format!("{name}.Rinf"), limit.r.iter(), "the limit of the gain")
            .add(format!("{name}.limit.Ppred.22"), limit.p[(1, 1)], "limit of the predicted velocity variance, m²/s²")
            .add(format!("{name}.limit.P.22"), posterior[(1, 1)], "limit of the corrected velocity variance, m²/s²")
            .add(format!("rank.{name}"), sys.observability(1e-9)?.rank as f64, "the observability rank")
            .by("estimate::Observer::error_eigs", Some(7))
            .add(format!("{name}.eig.re"), first.re, "real part of the first eigenvalue of (I − R∞H)F")
            .add(format!("{name}.eig.im"), first.im.abs(), "its imaginary part")
            .add(format!("{name}.modulus"), modulus, "the larger modulus of the eigenvalues of (I − R∞H)F")
            .add(format!("{name}.eig.1"), first.re, "the first eigenvalue of (I − R∞H)F, its real part")
            .add(format!("{name}.eig.2"), second.re, "the second eigenvalue of (I − R∞H)F, its real part")
            .by("labs::observer_bench::equivalent_knob", Some(7))
            .vector(&format!("knob.{name}"), &knobs, "HR(k) / HR∞, the knob of the same share of the innovation")
            .by("labs::observer_bench::knob_limit", Some(7))
            .add(format!("knob.limit.{name}"), knob_limit(sys, &limit.r), "the knob at which it turns unstable")
            .by("estimate::Lti::steady_state_gain", Some(7));
        if name == "position" {
            let (variance, steps) = (posterior[(0, 0)], limit.iterations as f64);
            to.add("position.limit.P.11", variance, "limit of the corrected position variance, m²");
            to.add("steady.position.iterations", steps, "iterations until gain and covariance stand still to 1e-12");
        } else {
            let before = sys.steady_state_gain(p0, LIMIT_ITERATIONS - 1, LIMIT_TOLERANCE)?;
            let growth = limit.p[(0, 0)] - before.p[(0, 0)];
            let still = |pair: &[Vector2<f64>]| (pair[1] - pair[0]).amax() <= LIMIT_TOLERANCE * pair[1].amax();
            let steps = gains.windows(2).position(still).map_or(gains.len(), |i| i + 2) as f64;
            to.add("velocity.growth", growth, "what the position variance gains a step in the limit, m²");
            to.add("steady.velocity.gain.iterations", steps, "iterations until the gain stands still to 1e-12");
        }
    }
    Ok(())
}

fn gains(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let (gain, variance) = brute_force(givens);
    let ratios = error_ratios(givens, 12)?;
    // A vast prior, one accurate reading: what the short covariance update loses and Joseph's keeps.
    let (p, h) = (Matrix2::identity() * 1e24, RowVector2::new(1.0, 0.0));
    let w = SMatrix::<f64, 1, 1>::new(0.04);
    let Gain { k: r, p: joseph, .. } = linear::gain(&p, &h, &w)?;
    let short = linear::complement(&r, &h) * p;
    to.by("chapter_kalman::checks::rail::brute_force", Some(6))
        .add("brute.gain", gain, "the gain that a search finds")
        .add("brute.P", variance, "the variance that it leaves")
        .by("estimate::place_observer_gain", Some(4))
        .vector("placed.K", placed(givens)?.k.iter(), "the gain that places the eigenvalues")
        .by("chapter_kalman::checks::rail::error_ratios", Some(5))
        .add("placed.ratio.12", ratios[11], "the ratio of successive errors at step 12")
        .by("filters::linear::complement", None)
        .add("joseph.short", short[(0, 0)], "(I − RH)P of a prior of variance 1e24 after a reading of variance 0.04")
        .by("filters::linear::joseph", None)
        .add("joseph.long", joseph[(0, 0)], "Joseph's form of the same update");
    Ok(())
}

fn noise(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let sys = &givens.velocity;
    let (t, v) = (sys.f[(0, 1)], sys.v);
    let (nees, nis) = (chi2_interval(3, 1, 0.95)?, chi2_interval(2, 1, 0.95)?);
    let of_variance = (2.0_f64 / 99.0).sqrt();
    to.by("chapter_kalman::numbers::rail::noise", None)
        .add("V.kick.11", t * t * v[(1, 1)], "what a velocity kick of variance V₂₂ at the period's start adds to V₁₁")
        .add("V.rest.11", v[(0, 0)] - t * t * v[(1, 1)], "the part of V₁₁ that such a kick does not explain")
        .add("tuning.variance.relative", of_variance, "relative standard error of a variance from 100 samples")
        .by("filters::consistency::chi2_quantile", None)
        .add("gate.99", chi2_quantile(2, 0.99)?, "the 99 % quantile of χ² with 2 degrees of freedom")
        .add("nees.median", chi2_quantile(3, 0.5)?, "the median of χ² with 3 degrees of freedom")
        .by("filters::consistency::chi2_interval", None)
        .add("nees.low", nees.0, "lower end of the 95 % interval of χ² with 3 degrees of freedom")
        .add("nees.high", nees.1, "upper end of the 95 % interval of χ² with 3 degrees of freedom")
        .add("nis.low", nis.0, "lower end of the 95 % interval of χ² with 2 degrees of freedom")
        .add("nis.high", nis.1, "upper end of the 95 % interval of χ² with 2 degrees of freedom");
    Ok(())
}
