//! Answers of the exercises.

use crate::checks::rail::hand_steps;
use crate::givens::Givens;
use estimate::kf::Gaussian;
use estimate::observability::{analyze, observability_matrix};
use estimate::slam::{EkfSlam, LandmarkReading};
use estimate::{Error, Lti, Observer};
use filters::association::Thresholds;
use filters::linear::{self, Gain};
use lab::Listing;
use nalgebra::{Matrix1, Matrix2, Matrix2x3, Matrix3, RowVector3, U1, U2, Vector2, Vector3};

const TOLERANCE: f64 = 1e-9;
/// Rounds in which every recursion here has settled to the last digits.
const LONG: usize = 2_000;

pub(super) fn list(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    unseen(to)?;
    constant(to)?;
    lamp(to);
    candidates(to);
    innovations(givens, to)?;
    bias(givens, to)?;
    founded(to)?;
    both_sensors(givens, to)?;
    other_gains(givens, to)
}

/// Three states read by one sensor: F = [1 0 0; 1 1 1; 2 −1 1], H = [1 0 1].
fn unseen(to: &mut Listing) -> Result<(), Error> {
    let f = Matrix3::new(1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, -1.0, 1.0);
    let found = analyze(&observability_matrix(&f, &RowVector3::new(1.0, 0.0, 1.0)), TOLERANCE)?;
    to.by("estimate::observability::analyze", None).add("ex.unseen.rank", found.rank as f64, "its rank");
    if let [c] = &found.nullspace[..] {
        to.vector("ex.unseen.c", (c / c[0]).iter(), "its unseen direction, scaled to begin with 1");
    }
    Ok(())
}

/// A constant: F = H = 1, V = 0, P₀ = 4, W = 2, ten readings.
fn constant(to: &mut Listing) -> Result<(), Error> {
    let (one, w) = (Matrix1::new(1.0), Matrix1::new(2.0));
    let (mut p, mut k) = (Matrix1::new(4.0), Matrix1::zeros());
    for _ in 0..10 {
        Gain { k, p, .. } = linear::gain(&p, &one, &w)?;
    }
    to.by("filters::linear::gain", None)
        .add("ex.constant.P", p[0], "variance of a constant after ten readings")
        .add("ex.constant.R", k[0], "the tenth gain")
        .add("ex.constant.flat", w[0] / 10.0, "W/10, the variance of the plain mean");
    Ok(())
}

/// The row of a lamp's elevation: h(x) = atan(z/ρ) at Δx = 3 m, Δy = 4 m, z = 2 m.
fn lamp(to: &mut Listing) {
    let [dx, dy, z] = LAMP;
    let rho = numerics::hypot(dx, dy);
    let scale = -z / (rho * (rho * rho + z * z));
    to.by("chapter_kalman::numbers::exercises::lamp", None)
        .add("ex.lamp.1", scale * dx, "∂h/∂x of the lamp's elevation, rad/m")
        .add("ex.lamp.2", scale * dy, "∂h/∂y, rad/m")
        .add("ex.lamp.away", -scale * dx, "∂h/∂x with the wrong sign, rad/m")
        .add("ex.lamp.flat", -dx / (rho * rho * rho) * z, "∂h/∂x with atan(z/ρ) taken for z/ρ, rad/m");
}
const LAMP: [f64; 3] = [3.0, 4.0, 2.0];

/// Two landmarks that might explain one range: innovation (m) and its variance (m²) of each.
const CANDIDATES: [[f64; 2]; 2] = [[0.3, 0.04], [0.9, 0.81]];

fn candidates(to: &mut Listing) {
    let [d, score] = [|[nu, s]: [f64; 2]| nu * nu / s, |[nu, s]: [f64; 2]| nu * nu / s + libm::log(s)]
        .map(|of: fn([f64; 2]) -> f64| CANDIDATES.map(of));
    to.by("chapter_kalman::numbers::exercises::candidates", None)
        .vector("ex.gate.nu", CANDIDATES.map(|c| c[0]).iter(), "innovation of a candidate, m")
        .vector("ex.gate.S", CANDIDATES.map(|c| c[1]).iter(), "its variance, m²")
        .vector("ex.gate.d", d.iter(), "χ² of a candidate")
        .vector("ex.gate.score", score.iter(), "χ² + log S of a candidate")
        .add("ex.gate.ratio", libm::exp(0.5 * (score[1] - score[0])), "likelihood of the first over the second")
        .add("ex.gate.unhalved", libm::exp(score[1] - score[0]), "the same without the half in the exponent");
}

/// Statistics of the innovations of a filter whose model is not the robot's: their mean over √S, the correlation of one
/// with the next, and the mean of ν²/S, as they are in the long run. The filter's V and W are the true ones times `v`
/// and `w`; `force` is an acceleration (m/s²) that it does not know of.
fn symptoms(sys: &Lti<U2, U1, U1>, p0: &Matrix2<f64>, v: f64, w: f64, force: f64) -> Result<[f64; 3], Error> {
    let believed = Lti { v: sys.v * v, w: sys.w * w, ..*sys };
    let limit = believed.steady_state_gain(p0, LONG, 1e-14)?;
    let (k, claimed) = (limit.r, (sys.h * limit.p * sys.h.transpose() + believed.w)[0]);
    let (mut p, mut m, mut predicted, mut drift) = (*p0, Vector2::zeros(), *p0, Vector2::zeros());
    let rest = linear::complement(&k, &sys.h);
    for _ in 0..LONG {
        predicted = linear::predicted_covariance(&sys.f, &p, &sys.v)?;
        p = linear::joseph(&predicted, &k, &sys.h, &sys.w);
        drift = sys.f * m + sys.g * force;
        m = rest * drift;
    }
    let variance = (sys.h * predicted * sys.h.transpose() + sys.w)[0];
    let next = (sys.h * sys.f * (predicted * sys.h.transpose() - k * variance))[0];
    let mean = (sys.h * drift)[0];
    Ok([mean / claimed.sqrt(), next / variance, (variance + mean * mean) / claimed])
}

/// Letters of the filters to be diagnosed, with their faults: V, W, force.
const PATIENTS: [(&str, f64, f64, f64); 5] =
    [("A", 1.0, 1.0, 0.5), ("B", 0.04, 1.0, 0.0), ("C", 0.25, 0.25, 0.0), ("D", 1.0, 0.1, 0.0), ("E", 1.0, 1.0, 0.0)];

fn innovations(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    to.by("chapter_kalman::numbers::exercises::symptoms", None);
    for (name, v, w, force) in PATIENTS {
        let [mean, next, nis] = symptoms(&givens.position, &givens.belief.p, v, w, force)?;
        to.add(format!("ex.patient.{name}.mean"), mean, "mean of the innovation over √S")
            .add(format!("ex.patient.{name}.next"), next, "correlation of an innovation with the next")
            .add(format!("ex.patient.{name}.nis"), nis, "mean of ν²/S");
    }
    Ok(())
}

/// The rail robot with a sensor's constant offset as its third state.
fn bias(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let t = givens.velocity.f[(0, 1)];
    let f = Matrix3::new(1.0, t, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    let velocity = analyze(&observability_matrix(&f, &RowVector3::new(0.0, 1.0, 1.0)), TOLERANCE)?;
    let position = analyze(&observability_matrix(&f, &RowVector3::new(1.0, 0.0, 1.0)), TOLERANCE)?;
    let both = Matrix2x3::new(1.0, 0.0, 0.0, 0.0, 1.0, 1.0);
    let both = analyze(&observability_matrix(&f, &both), TOLERANCE)?;
    to.by("estimate::observability::analyze", None)
        .add("ex.bias.velocity", velocity.rank as f64, "rank with a velocity sensor that has an offset")
        .add("ex.bias.position", position.rank as f64, "rank with a position sensor that has an offset")
        .add("ex.bias.both", both.rank as f64, "rank with a sound position sensor beside the offset velocity sensor");
    Ok(())
}

/// A landmark founded 5 m ahead: pose variances 0.01, 0.01 m², 0.0004 rad²; W = diag(0.01 m², 0.0009 rad²).
fn founded(to: &mut Listing) -> Result<(), Error> {
    let pose = Gaussian { x: Vector3::zeros(), p: Matrix3::from_diagonal(&Vector3::new(0.01, 0.01, 0.0004)) };
    let w = Matrix2::new(0.01, 0.0, 0.0, 0.0009);
    let mut slam = EkfSlam::new(&pose, &w, Thresholds { gate: 9.21, found: 50.0 })?;
    // The chapter's bearing is taken from the landmark: straight ahead of the robot it is π.
    slam.update(&[LandmarkReading { range: 5.0, bearing: core::f64::consts::PI, landmark: None }])?;
    let p = slam.belief().1;
    to.by("estimate::slam::EkfSlam", None)
        .add("ex.found.x", p[(3, 3)], "variance of the founded landmark along the line of sight, m²")
        .add("ex.found.y", p[(4, 4)], "variance across it, m²")
        .add("ex.found.bearing", 25.0 * w[(1, 1)], "the bearing's part of it at 5 m, m²")
        .add("ex.found.fixed", p[(4, 4)] - 25.0 * pose.p[(2, 2)], "the same as if the heading were known, m²")
        .add("ex.found.heading", p[(4, 2)], "its covariance with the heading, m rad");
    Ok(())
}

/// Position and velocity both read in step 1, W = ½ each: together, and one after the other.
fn both_sensors(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let predicted = &hand_steps(givens)?[0].predicted.p;
    let (sys, w) = (&givens.velocity, givens.velocity.w[0]);
    let batch = linear::gain(predicted, &Matrix2::identity(), &Matrix2::from_diagonal_element(w))?.p;
    let first = linear::gain(predicted, &givens.position.h, &sys.w)?.p;
    let in_turn = linear::gain(&first, &sys.h, &sys.w)?.p;
    to.by("filters::linear::gain", None)
        .symmetric("ex.batch.P", &batch, "P⁺ when both readings are taken at once")
        .symmetric("ex.turn.P", &in_turn, "P⁺ when they are taken in turn")
        .symmetric("ex.turn.first", &first, "P⁺ after the position alone");
    Ok(())
}

/// The position sensor's fastest observer on the line K = g R∞, and the velocity sensor with W = 1.
fn other_gains(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let (sys, p0) = (&givens.position, &givens.belief.p);
    let steady = sys.steady_state_gain(p0, LONG, 1e-14)?.r;
    // The pair of eigenvalues meets on the real axis where (2 − g s)² = 4 (1 − g R₁), s = R₁ + T R₂.
    let s = steady[0] + sys.f[(0, 1)] * steady[1];
    let knob = 4.0 * (s - steady[0]) / (s * s);
    let radius = (1.0 - knob * steady[0]).sqrt();
    // The largest radius that prints like the least. Below the pair has it, above a real λ: (1 − λ)² = g (R₁ − s λ).
    let most = (radius * 100.0).round() / 100.0 + 0.005;
    let [from, upto] = [(1.0 - most * most) / steady[0], (1.0 - most) * (1.0 - most) / (steady[0] - s * most)];
    let settled = |k: &Vector2<f64>| -> Result<f64, Error> {
        (0..LONG)
            .try_fold(*p0, |p, _| {
                Ok::<_, Error>(linear::joseph(&linear::predicted_covariance(&sys.f, &p, &sys.v)?, k, &sys.h, &sys.w))
            })
            .map(|p| p[(0, 0)])
    };
    to.by("chapter_kalman::numbers::exercises::other_gains", None)
        .add("ex.fastest.knob", knob, "the knob at which the spectral radius is least")
        .add("ex.fastest.radius", radius, "the spectral radius there")
        .add("ex.fastest.most", most, "the largest radius that two decimals print like it")
        .add("ex.fastest.from", from, "the least knob with no larger radius")
        .add("ex.fastest.to", upto, "the greatest knob with no larger radius")
        .add("ex.fastest.P", settled(&(steady * knob))?, "P₁₁ that this observer settles at, m²")
        .add("ex.fastest.best", settled(&steady)?, "P₁₁ that the filter settles at, m²");
    let noisy = Lti { w: givens.velocity.w * 2.0, ..givens.velocity };
    let limit = noisy.steady_state_gain(p0, 500, 1e-12)?;
    let observer = Observer { sys: noisy, k: limit.r, xhat: Vector2::zeros() };
    to.by("estimate::Lti::steady_state_gain", None)
        .vector("ex.noisy.Rinf", limit.r.iter(), "the velocity sensor's R∞ with W = 1")
        .add("ex.noisy.p", limit.p[(1, 1)], "limit of its predicted velocity variance, m²/s²")
        .add("ex.noisy.eig", observer.error_eigs()?[1].re, "its second eigenvalue");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use filters::central_differences;
    use std::collections::BTreeMap;

    fn answers() -> BTreeMap<String, f64> {
        let mut listing = Listing::new();
        list(&Givens::default(), &mut listing).expect("computed");
        listing.numbers.into_iter().map(|n| (n.id, n.value)).collect()
    }

    /// Fractions and closed forms found with a pencil.
    #[test]
    fn the_answers_are_those_of_the_worked_solutions() {
        let n = answers();
        let root = (0.01_f64 + 0.4).sqrt();
        let noisy = (0.1 + root) / 2.0;
        for (id, value) in [
            ("ex.unseen.rank", 2.0),
            ("ex.unseen.c.1", 1.0),
            ("ex.unseen.c.2", 2.0),
            ("ex.unseen.c.3", -1.0),
            ("ex.constant.P", 4.0 / 21.0),
            ("ex.constant.R", 2.0 / 21.0),
            ("ex.lamp.1", -6.0 / 145.0),
            ("ex.lamp.2", -8.0 / 145.0),
            ("ex.lamp.away", 6.0 / 145.0),
            ("ex.gate.d.1", 2.25),
            ("ex.gate.d.2", 1.0),
            ("ex.gate.ratio", 4.5 * (-0.625_f64).exp()),
            ("ex.gate.unhalved", 20.25 * (-1.25_f64).exp()),
            ("ex.bias.velocity", 1.0),
            ("ex.bias.position", 2.0),
            ("ex.bias.both", 3.0),
            ("ex.found.x", 0.02),
            ("ex.found.y", 0.0425),
            ("ex.found.bearing", 0.0225),
            ("ex.found.fixed", 0.0325),
            ("ex.found.heading", 0.002),
            // (P⁻⁻¹ + 2 I)⁻¹ with P⁻ = [1.7 1.05; 1.05 2.1]: det P⁻ = 2.4675, det (P⁻ + I/2) = 4.6175.
            ("ex.batch.P.11", 0.5 * (1.7 * 2.6 - 1.05 * 1.05) / 4.6175),
            ("ex.batch.P.12", 0.25 * 1.05 / 4.6175),
            ("ex.noisy.p", noisy),
            ("ex.noisy.Rinf.1", 0.5),
            ("ex.noisy.Rinf.2", noisy / (noisy + 1.0)),
            ("ex.noisy.eig", 1.0 / (noisy + 1.0)),
        ] {
            assert!((n[id] - value).abs() < 1e-11, "{id} is {}, not {value}", n[id]);
        }
    }

    #[test]
    fn readings_taken_in_turn_leave_what_both_at_once_leave() {
        let n = answers();
        for entry in ["11", "12", "22"] {
            assert!((n[&format!("ex.batch.P.{entry}")] - n[&format!("ex.turn.P.{entry}")]).abs() < 1e-15, "{entry}");
        }
    }

    #[test]
    fn the_lamp_s_row_is_its_elevation_s_derivative() {
        let [dx, dy, z] = LAMP;
        let elevation = |x: &Vector2<f64>| Matrix1::new(libm::atan2(z, numerics::hypot(x[0], x[1])));
        let row = central_differences(elevation, |a, b| a - b, &Vector2::new(dx, dy), 1e-5);
        let n = answers();
        assert!((row[0] - n["ex.lamp.1"]).abs() < 1e-9 && (row[1] - n["ex.lamp.2"]).abs() < 1e-9);
    }

    #[test]
    fn each_fault_has_its_own_symptom() {
        let n = answers();
        let of = |name: &str| ["mean", "next", "nis"].map(|what| n[&format!("ex.patient.{name}.{what}")]);
        let sound = of("E");
        // The search for the limit stops at 1e-14 of P.
        assert!(sound[0] == 0.0 && sound[1].abs() < 1e-9 && (sound[2] - 1.0).abs() < 1e-9, "{sound:?}");
        assert!(of("A")[0] > 0.3 && of("A")[1].abs() < 1e-9);
        assert!(of("B")[0] == 0.0 && of("B")[1] > 0.2 && of("B")[2] > 1.2);
        assert!(of("C")[1].abs() < 1e-9 && (of("C")[2] - 4.0).abs() < 1e-9);
        assert!(of("D")[1] < -0.2);
    }

    #[test]
    fn the_fastest_observer_on_the_line_is_not_the_best() {
        let n = answers();
        let (sys, p0) = (Givens::default().position, Givens::default().belief.p);
        let steady = sys.steady_state_gain(&p0, LONG, 1e-14).expect("converges").r;
        let radius = |g: f64| {
            let roots = Observer { sys, k: steady * g, xhat: Vector2::zeros() }.error_eigs().expect("2×2");
            numerics::hypot(roots[0].re, roots[0].im)
        };
        let [best, from, to] = ["knob", "from", "to"].map(|it| n[&format!("ex.fastest.{it}")]);
        // The two eigenvalues meet here, and two that meet move like a root: 1e-3 of the knob is 3e-2 of the radius.
        assert!((radius(best) - n["ex.fastest.radius"]).abs() < 1e-6, "{}", radius(best));
        assert!([0.9, 0.98, 0.995, 1.005, 1.02, 1.1].iter().all(|f| radius(best * f) > radius(best)));
        assert!(n["ex.fastest.P"] > n["ex.fastest.best"]);
        let prints = |g: f64| format!("{:.2}", radius(g)) == format!("{:.2}", radius(best));
        assert!(prints(from + 1e-4) && !prints(from - 1e-4) && prints(to - 1e-4) && !prints(to + 1e-4));
    }
}
