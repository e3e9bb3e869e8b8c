//! Systems whose numbers lie many powers of ten apart: what the filter answers is right to 10⁻⁶ of an answer of 200
//! digits, or it says itself that it is not.
#![cfg(not(target_arch = "wasm32"))]

#[path = "scales/exact.rs"]
mod exact;
#[path = "scales/systems.rs"]
mod systems;

use estimate::dynamic::{Belief, KalmanFilter, System};
use estimate::kf::kalman_step;
use exact::{Filter, Matrix};
use filters::Conditioning;
use nalgebra::{DMatrix, DVector, Vector1, dmatrix, dvector};
use systems::{Scales, Trial};

const RIGHT: f64 = 1e-6;

/// So far an answer may be off that is called right: the filter's bounds are to first order, and a cancellation that it
/// had no reason to look at may be behind it. Among 10,000 steps there must not be one.
const AT_WORST: f64 = 1e-4;

/// How many steps were answered, how many of these by a filter that calls itself well conditioned, and how many of
/// those are off by more than [`RIGHT`].
#[derive(Debug, Default, PartialEq, Eq)]
struct Count {
    steps: usize,
    conditioned: usize,
    silent: usize,
}

fn count(scales: Scales, trials: u64) -> Count {
    let mut count = Count::default();
    for number in 0..trials {
        let Trial { system, belief, readings } = Trial::new(scales, number);
        let mut filter = KalmanFilter::new(&system, &belief).expect("a system");
        let exact = exact::System::from(&system);
        let mut truth = Filter::new(&belief);
        for (k, y) in readings.iter().enumerate() {
            // A refusal is no wrong answer.
            if filter.step(&[], y.as_slice()).is_err() {
                break;
            }
            truth.step(&exact, &Matrix::from(y)).expect("W is positive");
            count.steps += 1;
            if !filter.conditioned() {
                assert_eq!(filter.log_likelihood(), None, "{scales:?} {number}, step {k}");
                continue;
            }
            count.conditioned += 1;
            let found = filter.belief();
            let off = truth.errors_of(&found, filter.log_likelihood());
            let worst = off.into_iter().fold(0.0, f64::max);
            assert!(worst <= AT_WORST, "{scales:?} {number}, step {k}: x, P, likelihood {off:?}");
            count.silent += usize::from(worst > RIGHT);
        }
    }
    assert!(count.silent * 10_000 < count.steps, "{scales:?}: {count:?}");
    count
}

fn trials(daily: u64) -> u64 {
    if std::env::var_os("RELEASE").is_some() { 20 * daily } else { daily }
}

#[test]
fn hard_scales_are_right_to_six_digits_or_said() {
    for scales in [Scales::HugePrior, Scales::NoMotionNoise] {
        let Count { steps, conditioned, .. } = count(scales, trials(600));
        // Neither is all of them refused nor all of them called right.
        assert!(conditioned * 10 > steps * 3 && conditioned * 10 < steps * 9, "{scales:?}: {conditioned} of {steps}");
    }
}

#[test]
fn of_ordinary_systems_99_in_100_are_well_conditioned_and_all_these_right() {
    let Count { steps, conditioned, .. } = count(Scales::Ordinary, trials(1000));
    assert!(conditioned * 100 >= steps * 99, "{conditioned} of {steps}");
}

#[test]
fn a_single_step_says_it_too() {
    let (mut doubted, mut steps) = (0, 0);
    for number in 0..trials(400) {
        let Trial { system, belief, readings } = Trial::new(Scales::HugePrior, number);
        let y = &readings[0];
        let Ok(step) = kalman_step(&system, &belief, &DVector::zeros(0), y) else { continue };
        let mut truth = Filter::new(&belief);
        truth.step(&exact::System::from(&system), &Matrix::from(y)).expect("W is positive");
        steps += 1;
        if !step.conditioned(&system, &belief) {
            doubted += 1;
            continue;
        }
        let s = truth.s.as_ref().expect("a step").error_of(&(&step.s).into());
        let [x, p] = [truth.x.error_of(&(&step.posterior.x).into()), truth.p.error_of(&(&step.posterior.p).into())];
        assert!(s <= RIGHT && p <= RIGHT && x <= 1e-3, "{number}: S {s:e}, P {p:e}, x {x:e}");
    }
    assert!(doubted > 0 && doubted < steps, "{doubted} of {steps}");
}

/// A direction that is known almost exactly beside one with a standard deviation of 10⁹, read across: S is W, and what
/// rounding has left of 10¹⁸ is all that a double has.
#[test]
fn a_reading_across_a_huge_direction_is_right_or_said() {
    for [a, b] in [[0.6, 0.8], [1.0, 3.0], [0.1, 0.7], [2.0, 5.0]] {
        let p = dmatrix![b * b, -a * b; -a * b, a * a] * 1e18;
        let system = System {
            f: DMatrix::identity(2, 2),
            g: DMatrix::zeros(2, 0),
            h: dmatrix![a, b],
            v: DMatrix::zeros(2, 2),
            w: dmatrix![0.5],
        };
        let belief = Belief { x: dvector![0.0, 0.0], p };
        let Ok(step) = kalman_step(&system, &belief, &DVector::zeros(0), &dvector![1.0]) else { continue };
        let off = (step.s[(0, 0)] - 0.5).abs() / 0.5;
        assert!(off <= RIGHT || !step.conditioned(&system, &belief), "H = [{a}, {b}]: S is {}", step.s[(0, 0)]);
    }
}

/// The systems of the chapter: those on rails, with the noise that the figure of the log can be given.
#[test]
fn every_step_of_the_chapter_s_systems_is_well_conditioned() {
    for (rail, belief) in [estimate::rail::dead_reckoning(), estimate::rail::position_sensor()] {
        for power in -4..=4 {
            let factor = libm::pow(10.0, f64::from(power));
            let system = estimate::Lti { v: rail.v * factor, w: rail.w / factor, ..rail };
            let (mut belief, mut conditioning) = (belief, Conditioning::default());
            for k in 0..1000 {
                let (u, y) = (Vector1::new(1.0), Vector1::new(f64::from(k % 7)));
                let step = kalman_step(&system, &belief, &u, &y).expect("sound");
                step.follow(&mut conditioning, &system, &belief);
                assert!(conditioning.is_well_conditioned(), "V times and W through 10^{power}, step {k}");
                belief = step.posterior;
            }
        }
    }
}

/// Two states of which nothing is known but their sum, read across: the first S that is computed is no number to divide
/// by, and d² belongs to the one that is answered.
#[test]
fn the_squared_distance_is_of_the_s_that_is_answered() {
    let mut looked_at = 0;
    for number in 0..400 {
        let Trial { system, belief, readings } = Trial::new(Scales::NoMotionNoise, number);
        let mut filter = KalmanFilter::new(&system, &belief).expect("a system");
        for y in &readings {
            let before = filter.belief();
            if filter.step(&[], y.as_slice()).is_err() {
                break;
            }
            let step = kalman_step(&system, &before, &DVector::zeros(0), y).expect("as the filter");
            if y.len() > 1 {
                continue;
            }
            let (d2, s) = (step.innovation[0] * step.innovation[0] / step.s[(0, 0)], step.s[(0, 0)]);
            let found = filter.nis().expect("one output, and S positive");
            assert!((found - d2).abs() <= 1e-8 * d2, "{number}: {found}, with S {s} it is {d2}");
            looked_at += 1;
        }
    }
    assert!(looked_at > 500, "{looked_at}");
}
