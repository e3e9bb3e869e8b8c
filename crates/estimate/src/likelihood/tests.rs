use super::*;
use crate::rail::position_sensor;
use nalgebra::{DMatrix, DVector, Matrix1, U1, U2, Vector1};

/// Readings without a pattern, the same in each run.
fn readings<const P: usize>(steps: u32, size: f64) -> Vec<Entry<U1, nalgebra::Const<P>>> {
    let number = |k: u32| size * libm::sin(12.9898 * f64::from(k * k + 3 * k + 1));
    (0..steps)
        .map(|k| {
            (
                Vector1::new(number(7 * k + 5)),
                OVector::from_fn_generic(nalgebra::Const, nalgebra::U1, |i, _| number(11 * k + i as u32)),
            )
        })
        .collect()
}

/// F = 0 forgets everything: the readings are independent, each of variance V + W.
#[test]
fn of_independent_readings_the_likelihood_is_in_closed_form() {
    let one = Matrix1::new(1.0);
    let (v, w) = (0.7, 1.9);
    let system = Lti { f: 0.0 * one, g: 0.0 * one, h: one, v: v * one, w: w * one };
    let log = readings::<1>(50, 2.0);
    let squares: f64 = log.iter().map(|(_, y)| y[0] * y[0]).sum();
    let exact = -0.5 * (50.0 * libm::log(core::f64::consts::TAU * (v + w)) + squares / (v + w));
    let found = log_likelihood(&system, &Gaussian { x: Vector1::zeros(), p: one }, &log).expect("positive definite");
    assert!((found / exact - 1.0).abs() < 1e-14, "{found} against {exact}");
}

/// A constant read with noise: the readings are jointly normal with covariance P₀ 11ᵀ + W I, whose determinant is
/// Wⁿ⁻¹ (W + nP₀) and whose inverse is (I − P₀ 11ᵀ / (W + nP₀)) / W.
#[test]
fn of_a_constant_the_likelihood_is_in_closed_form() {
    let one = Matrix1::new(1.0);
    let (p0, w, n) = (3.0, 0.5, 40.0);
    let system = Lti { f: one, g: one, h: one, v: 0.0 * one, w: w * one };
    let log: Vec<Entry<U1, U1>> = readings::<1>(40, 1.0).into_iter().map(|(_, y)| (Vector1::zeros(), y)).collect();
    let (sum, squares) = log.iter().fold((0.0, 0.0), |(s, q), (_, y)| (s + y[0], q + y[0] * y[0]));
    let ln_det = (n - 1.0) * libm::log(w) + libm::log(w + n * p0);
    let distance = (squares - p0 * sum * sum / (w + n * p0)) / w;
    let exact = -0.5 * (n * LN_TWO_PI + ln_det + distance);
    let found =
        log_likelihood(&system, &Gaussian { x: Vector1::zeros(), p: p0 * one }, &log).expect("positive definite");
    assert!((found / exact - 1.0).abs() < 1e-13, "{found} against {exact}");
}

/// All readings of a short log are one normal vector. Its mean and covariance follow from the system without a filter:
/// x(k) = Fᵏ x₀ + Σ Fᵏ⁻ʲ (G u(j) + v(j)).
fn joint_density<const P: usize>(
    system: &Lti<U2, U1, nalgebra::Const<P>>,
    belief: &Gaussian<U2>,
    log: &[Entry<U1, nalgebra::Const<P>>],
) -> f64 {
    let n = log.len();
    let (mut mean, mut spread) = (belief.x, belief.p);
    let (mut means, mut spreads) = (Vec::new(), Vec::new());
    for (u, _) in log {
        mean = system.f * mean + system.g * u;
        spread = system.f * spread * system.f.transpose() + system.v;
        means.push(system.h * mean);
        spreads.push(spread);
    }
    // Cov(x(i), x(j)) = Fⁱ⁻ʲ Cov(x(j)) for i ≥ j.
    let covariance = DMatrix::from_fn(n * P, n * P, |a, b| {
        let ((i, a), (j, b)) = if a >= b { ((a / P, a % P), (b / P, b % P)) } else { ((b / P, b % P), (a / P, a % P)) };
        let power = (j..i).fold(Matrix2::identity(), |power, _| system.f * power);
        let noise = if i == j { system.w[(a, b)] } else { 0.0 };
        (system.h * power * spreads[j] * system.h.transpose())[(a, b)] + noise
    });
    let off = DVector::from_fn(n * P, |a, _| log[a / P].1[a % P] - means[a / P][a % P]);
    let factor = covariance.cholesky().expect("positive definite");
    let ln_det = 2.0 * factor.l().diagonal().iter().map(|d| libm::log(*d)).sum::<f64>();
    -0.5 * ((n * P) as f64 * LN_TWO_PI + ln_det + off.dot(&factor.solve(&off)))
}

#[test]
fn the_likelihood_is_the_joint_density_of_all_readings() {
    let (system, belief) = position_sensor();
    let log = readings::<1>(9, 4.0);
    let found = log_likelihood(&system, &belief, &log).expect("positive definite");
    let exact = joint_density(&system, &belief, &log);
    assert!((found / exact - 1.0).abs() < 1e-13, "{found} against {exact}");

    let w = Matrix2::new(0.4, 0.1, 0.1, 0.3);
    let two = Lti { f: system.f, g: system.g, h: Matrix2::new(1.0, 0.2, -0.3, 1.0), v: system.v, w };
    let log = readings::<2>(6, 4.0);
    let found = log_likelihood(&two, &belief, &log).expect("positive definite");
    let exact = joint_density(&two, &belief, &log);
    assert!((found / exact - 1.0).abs() < 1e-13, "{found} against {exact}");
}

/// Two outputs, one of V's noise alone and one of W's alone: ln q and ln w are ln of the mean squares, and the
/// information of each is half the number of readings.
#[test]
fn of_readings_of_either_noise_alone_the_fit_is_in_closed_form() {
    let first = Matrix2::new(1.0, 0.0, 0.0, 0.0);
    let system = Lti {
        f: Matrix2::zeros(),
        g: nalgebra::Vector2::zeros(),
        h: first,
        v: first,
        w: Matrix2::new(0.0, 0.0, 0.0, 1.0),
    };
    let log = readings::<2>(60, 3.0);
    let square = |i: usize| log.iter().map(|(_, y)| y[i] * y[i]).sum::<f64>() / 60.0;
    let belief = Gaussian { x: Vector2::zeros(), p: Matrix2::zeros() };
    let fit = fit_noise(&system, &belief, &log, &[[1e-3, 1e3]; 2]).expect("positive definite");
    assert!(fit.converged && fit.held == [false; 2]);
    // Within 10⁻⁵ of a standard deviation, √(2/60), of the maximum.
    assert!((fit.q / square(0) - 1.0).abs() < 1e-5 && (fit.w / square(1) - 1.0).abs() < 1e-5, "{fit:?}");
    assert!((fit.information - Matrix2::new(30.0, 0.0, 0.0, 30.0)).amax() < 1e-3, "{}", fit.information);
    // Beyond its bounds the likelihood still rises, and the fit says so.
    let bounded = fit_noise(&system, &belief, &log, &[[1e-3, 0.1], [1e-3, 1e3]]).expect("positive definite");
    assert!(bounded.converged && bounded.held == [true, false] && (bounded.q / 0.1 - 1.0).abs() < 1e-12, "{bounded:?}");
}

#[test]
fn no_log_or_no_box_is_refused_by_name() {
    let (system, belief) = position_sensor();
    let log = readings::<1>(5, 1.0);
    let refused = |log: &[Entry<U1, U1>], bounds: [[f64; 2]; 2]| {
        let error = fit_noise(&system, &belief, log, &bounds).expect_err("refused");
        (error.code, error.argument.to_string())
    };
    assert_eq!(refused(&[], [[0.1, 1.0]; 2]), (Code::Limit, "log".into()));
    for bad in [[0.0, 1.0], [1.0, 1.0], [2.0, 1.0], [f64::NAN, 1.0], [0.1, f64::INFINITY]] {
        assert_eq!(refused(&log, [[0.1, 1.0], bad]), (Code::Limit, "bounds".into()), "{bad:?}");
    }
    let nan = [(Vector1::zeros(), Vector1::new(f64::NAN))];
    assert_eq!(refused(&nan, [[0.1, 1.0]; 2]), (Code::NotFinite, "y".into()));
}

#[test]
fn a_singular_innovation_has_no_density() {
    assert_eq!(log_density(&Vector1::new(0.0), &Matrix1::new(0.0)), None);
    assert_eq!(log_density(&Vector1::new(1e200), &Matrix1::new(1.0)), None);
    assert_eq!(log_density(&Vector2::zeros(), &Matrix2::new(1.0, 1.0, 1.0, 1.0 + 1e-12)), None);
}
