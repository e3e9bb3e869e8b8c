//! Checks 1 to 7: the rail robot of §8.2.6.

use crate::givens::Givens;
use estimate::kf::{KalmanStep, kalman_step};
use estimate::{Complex, Error, Lti, Observer, place_observer_gain};
use filters::linear;
use lab::Check;
use nalgebra::{Matrix1, SMatrix, U1, U2, Vector1, Vector2};

/// The hand-checked steps, one for each reading.
pub(crate) fn hand_steps(givens: &Givens) -> Result<Vec<KalmanStep<U2, U1>>, Error> {
    let sys = &givens.velocity;
    let mut belief = givens.belief;
    let none = Vector1::zeros();
    givens
        .readings
        .iter()
        .map(|y| {
            let step = kalman_step(sys, &belief, &none, &Vector1::new(*y))?;
            belief = step.posterior;
            Ok(step)
        })
        .collect()
}

fn step_check(givens: &Givens, k: usize, title: &'static str, expected: Vec<f64>) -> Result<Check, Error> {
    let steps = hand_steps(givens)?;
    let step = &steps[k - 1];
    let (x, p) = (step.posterior.x, step.posterior.p);
    let actual = vec![step.s[0], step.r[0], step.r[1], x[0], x[1], p[(0, 0)], p[(1, 0)], p[(1, 1)]];
    Ok(Check::new(k as u8, title, expected, actual, 1e-12))
}

/// Check 1, against exact fractions: S, R, x̂⁺, P⁺.
pub(super) fn first_step(givens: &Givens) -> Result<Check, Error> {
    let (r1, r2) = (21.0 / 52.0, 21.0 / 26.0);
    let expected = vec![2.6, r1, r2, 3.475, 2.95, 1327.0 / 1040.0, 21.0 / 104.0, r1];
    step_check(givens, 1, "The first step by hand (y = 2.7)", expected)
}

/// Check 2, against exact fractions: S, R, x̂⁺, P⁺.
pub(super) fn second_step(givens: &Givens) -> Result<Check, Error> {
    let (r1, r2, nu) = (118.0 / 261.0, 131.0 / 261.0, -0.95);
    let expected =
        vec![261.0 / 260.0, r1, r2, 4.95 + r1 * nu, 2.95 + r2 * nu, 16429.0 / 10440.0, 59.0 / 261.0, 131.0 / 522.0];
    step_check(givens, 2, "The second step by hand (y = 2.0)", expected)
}

/// Check 3: the observability ranks.
pub(super) fn ranks(givens: &Givens) -> Result<Check, Error> {
    let rank = |sys: &Lti<U2, U1, U1>| sys.observability(1e-9).map(|o| o.rank as f64);
    let actual = vec![rank(&givens.velocity)?, rank(&givens.position)?];
    Ok(Check::new(3, "Observability ranks: velocity sensor, position sensor", vec![1.0, 2.0], actual, 0.0))
}

/// The position sensor's observer with the chapter's placed poles.
pub(crate) fn placed(givens: &Givens) -> Result<Observer<U2, U1, U1>, Error> {
    let poles = givens.poles.map(Complex::from);
    let k = place_observer_gain(&givens.position.f, &givens.position.h, &poles)?;
    Ok(Observer { sys: givens.position, k, xhat: Vector2::zeros() })
}

/// Check 4: a gain found by Ackermann's formula puts the eigenvalues of (I − KH)F where they were asked for.
pub(super) fn placed_eigenvalues(givens: &Givens) -> Result<Check, Error> {
    let eigenvalues = placed(givens)?.error_eigs()?;
    let actual = eigenvalues.iter().flat_map(|l| [l.re, l.im]).collect();
    Ok(Check::new(4, "The placed eigenvalues of (I − KH)F", vec![0.5, 0.0, 0.2, 0.0], actual, 1e-12))
}

/// ‖e(k)‖ / ‖e(k − 1)‖ of the placed observer on a noiseless run: entry k − 1.
pub(crate) fn error_ratios(givens: &Givens, steps: usize) -> Result<Vec<f64>, Error> {
    let mut observer = placed(givens)?;
    let sys = observer.sys;
    let mut truth = Vector2::from(givens.first_error);
    let mut before = (truth - observer.xhat).norm();
    Ok((0..steps)
        .map(|_| {
            truth = sys.f * truth;
            observer.step(&Vector1::zeros(), &(sys.h * truth));
            let error = (truth - observer.xhat).norm();
            let ratio = error / before;
            before = error;
            ratio
        })
        .collect())
}

/// Check 5: the error of that observer shrinks by the slower eigenvalue a step.
pub(super) fn error_ratio(givens: &Givens) -> Result<Check, Error> {
    let ratios = error_ratios(givens, 24)?;
    let actual = vec![ratios[ratios.len() - 1]];
    Ok(Check::new(5, "The error ratio of that observer converges to 0.5", vec![0.5], actual, 1e-8))
}

/// The K of least posterior covariance for the scalar problem, by search on ever finer grids, and that covariance.
pub(crate) fn brute_force(givens: &Givens) -> (f64, f64) {
    let [p, h, w] = givens.scalar.map(Matrix1::new);
    let cost = |k: f64| linear::joseph(&p, &SMatrix::<f64, 1, 1>::new(k), &h, &w)[0];
    let (mut best, mut width) = (0.0, 10.0);
    // Near its minimum a parabola is flat within the root of the rounding, so only eight digits of K can be found.
    for _ in 0..60 {
        let grid = (-10..=10).map(|i| best + width * f64::from(i) / 10.0);
        best = grid.min_by(|a, b| cost(*a).total_cmp(&cost(*b))).unwrap_or(best);
        width *= 0.7;
    }
    (best, cost(best))
}

/// Check 6: a search over K that knows no calculus finds the Kalman gain.
pub(super) fn brute_force_gain(givens: &Givens) -> Result<Check, Error> {
    let (k, p) = brute_force(givens);
    let expected = vec![17.0 / 22.0, 17.0 / 44.0];
    Ok(Check::new(6, "The gain found by brute force, and its variance", expected, vec![k, p], 1e-7))
}

/// Check 7: R∞ and the eigenvalues of both sensors, and that P converges with one of them only.
pub(super) fn riccati_limits(givens: &Givens) -> Result<Check, Error> {
    let mut actual = Vec::new();
    for sys in [&givens.position, &givens.velocity] {
        let limit = sys.steady_state_gain(&givens.belief.p, 10_000, 1e-12)?;
        let observer = Observer { sys: *sys, k: limit.r, xhat: Vector2::zeros() };
        actual.extend([limit.r[0], limit.r[1]]);
        actual.extend(observer.error_eigs()?.iter().flat_map(|l| [l.re, l.im]));
        actual.extend([f64::from(u8::from(limit.converged)), f64::from(u8::from(limit.gain_converged))]);
    }
    let (re, im, root21) = (0.6339959916641491, 0.0972962813911485, 21.0_f64.sqrt());
    let position = [0.5885825161812468, 0.2868510009809105, re, im, re, -im, 1.0, 1.0];
    let velocity = [0.5, (root21 - 1.0) / 10.0, 1.0, 0.0, (11.0 - root21) / 10.0, 0.0, 0.0, 1.0];
    let expected = [position, velocity].concat();
    let title = "The Riccati limits: R∞, eigenvalues, and whether P and R converge, for both sensors";
    Ok(Check::new(7, title, expected, actual, 1e-10))
}
