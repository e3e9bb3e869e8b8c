use super::frame::DRAWN;
use super::*;
use estimate::Code;

fn at(params: BenchParams, steps: u32) -> ObserverBench {
    let mut bench = ObserverBench::new(params).expect("sound parameters");
    bench.run(steps).expect("within the limit");
    bench
}

fn with(sensor: Sensor, mode: Mode, gain: f64) -> BenchParams {
    BenchParams { sensor, mode, gain, ..BenchParams::default() }
}

#[test]
fn the_velocity_sensor_pins_an_eigenvalue_at_one() {
    for gain in [0.0, 0.5, 1.0, 3.0, 6.0] {
        let frame = at(with(Sensor::Velocity, Mode::Fixed, gain), 3).frame();
        let pinned = frame.pinned.expect("one is pinned");
        assert_eq!((frame.eigenvalues[pinned].re, frame.eigenvalues[pinned].im), (1.0, 0.0));
    }
    assert_eq!(at(with(Sensor::Position, Mode::Fixed, 1.0), 3).frame().pinned, None);
}

#[test]
fn the_knob_s_limit_separates_stable_from_unstable() {
    for sensor in [Sensor::Velocity, Sensor::Position] {
        let limit = ObserverBench::new(with(sensor, Mode::Fixed, 1.0)).expect("sound").frame().stable_up_to;
        for (gain, stable) in [(0.999 * limit, true), (1.001 * limit, false), (0.01, true)] {
            let frame = at(with(sensor, Mode::Fixed, gain), 1).frame();
            assert_eq!(frame.stable, stable, "{sensor:?} at {gain}");
        }
    }
}

#[test]
fn past_the_limit_a_run_diverges_says_so_and_stands_still() {
    let mut bench = at(with(Sensor::Position, Mode::Fixed, 6.0), 200);
    let frame = bench.frame();
    assert!(frame.diverged);
    bench.run(50).expect("within the limit");
    let later = bench.frame();
    assert_eq!((later.truth, later.posterior, later.series), (frame.truth, frame.posterior, frame.series));
    assert_eq!(later.step, 250);
}

#[test]
fn the_filter_s_equivalent_knob_drifts_to_one() {
    for sensor in [Sensor::Velocity, Sensor::Position] {
        let bench = at(with(sensor, Mode::Filter, 1.0), 100);
        assert!((bench.frame().equivalent_knob - 1.0).abs() < 1e-9);
        let first = bench.frame().series.knob.iter().next().expect("recorded");
        assert!((first - 1.0).abs() > 0.2, "{first}");
    }
}

#[test]
fn the_equivalent_knob_does_not_depend_on_the_unit_of_time() {
    for (system, belief) in [dead_reckoning(), position_sensor()] {
        // A velocity in m/s is 60 times as large in m/min: x' = D x with D = diag(1, 60).
        let d = Matrix2::from_diagonal(&Vector2::new(1.0, 60.0));
        let inverse = Matrix2::from_diagonal(&Vector2::new(1.0, 1.0 / 60.0));
        // The velocity sensor's reading is converted as well; the position sensor's stays in metres.
        let c = if system.h[1] == 0.0 { 1.0 } else { 60.0 };
        let minutes = Lti {
            f: d * system.f * inverse,
            g: d * system.g,
            h: system.h * inverse * c,
            v: d * system.v * d,
            w: system.w * (c * c),
        };
        let knob = |system: &Lti<U2, U1, U1>, p: &Matrix2<f64>| {
            let steady = system.steady_state_gain(p, STEADY_ITERATIONS, 1e-12).expect("sound").r;
            let first = system.gain_schedule(p, 1).expect("sound").remove(0);
            equivalent_knob(system, &first, &steady)
        };
        let [in_seconds, in_minutes] = [knob(&system, &belief.p), knob(&minutes, &(d * belief.p * d))];
        // The two limits each stop within 1e-12 of R∞; ⟨R, R∞⟩/⟨R∞, R∞⟩ differed by more than 0.1 here.
        assert!((in_seconds - in_minutes).abs() < 1e-9, "{in_seconds} {in_minutes}");
    }
}

#[test]
fn with_the_knob_at_one_the_observer_ends_where_the_filter_ends() {
    let fixed = at(with(Sensor::Position, Mode::Fixed, 1.0), 200).frame();
    let filter = at(with(Sensor::Position, Mode::Filter, 1.0), 200).frame();
    assert_eq!(fixed.truth, filter.truth, "the seed fixes truth and readings");
    for i in 0..2 {
        assert!((fixed.posterior.x[i] - filter.posterior.x[i]).abs() < 1e-9);
        assert!((fixed.posterior.p[i][i] - filter.posterior.p[i][i]).abs() < 1e-9);
    }
}

#[test]
fn the_filter_s_update_is_the_mahalanobis_foot_on_the_most_likely_output() {
    let bench = at(with(Sensor::Velocity, Mode::Filter, 1.0), 7);
    let frame = bench.frame();
    let omega = AffineSet { h: bench.system.h, y: Vector1::new(frame.most_likely_output.expect("a reading")) };
    let foot = omega.mahalanobis_foot(&bench.predicted.p, &bench.predicted.x).expect("positive");
    assert!((foot - bench.posterior.x).norm() < 1e-13);
}

#[test]
fn a_change_replays_the_whole_run() {
    let mut turned = at(with(Sensor::Velocity, Mode::Fixed, 1.0), 30);
    turned.set(with(Sensor::Velocity, Mode::Fixed, 2.5)).expect("sound");
    assert_eq!(turned.frame(), at(with(Sensor::Velocity, Mode::Fixed, 2.5), 30).frame());
    let again = ObserverBench::from_state(turned.state()).expect("a state of its own");
    assert_eq!(again.digest(), turned.digest());
    assert_ne!(again.digest(), at(with(Sensor::Velocity, Mode::Fixed, 2.5), 31).digest());
}

#[test]
fn bad_parameters_are_refused_and_the_lab_is_kept() {
    let mut bench = at(BenchParams::default(), 5);
    let before = bench.frame();
    for gain in [-0.1, 6.1] {
        let error = bench.set(BenchParams { gain, ..BenchParams::default() }).expect_err("out of bounds");
        assert_eq!((error.code, error.argument.as_ref()), (Code::Limit, "gain"));
    }
    let error = bench.set(BenchParams { gain: f64::NAN, ..BenchParams::default() }).expect_err("NaN");
    assert_eq!(error.code, Code::NotFinite);
    for n in [0, lab::MAX_STEP] {
        assert_eq!(bench.run(n).expect_err("too few or too many").code, Code::Limit);
    }
    let beyond = lab::State { params: BenchParams::default(), step: lab::MAX_STEP + 1 };
    assert_eq!(ObserverBench::from_state(beyond).expect_err("too far").argument, "step");
    assert_eq!(bench.frame(), before);
}

#[test]
fn a_long_run_keeps_its_memory_and_stays_finite() {
    let frame = at(with(Sensor::Velocity, Mode::Filter, 1.0), 10_000).frame();
    assert_eq!(frame.series.p11.len(), DRAWN);
    assert!(!frame.diverged && frame.posterior.p[0][0] > 2900.0);
}

/// What the text asks for: at a late step P₁₁ is least at a gain near 1, and early at a smaller one.
#[test]
fn the_later_the_step_the_nearer_to_one_is_the_gain_with_the_least_position_variance() {
    let least = |step| {
        let p11 = |gain| at(with(Sensor::Velocity, Mode::Fixed, gain), step).frame().posterior.p[0][0];
        (50..150).map(|hundredths| f64::from(hundredths) * 0.01).min_by(|a, b| p11(*a).total_cmp(&p11(*b)))
    };
    let [early, late] = [12, 200].map(|step| least(step).expect("gains"));
    assert!(early < 0.96 && (0.985..1.005).contains(&late), "{early} {late}");
}
