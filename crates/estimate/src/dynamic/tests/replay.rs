//! A log replayed in one call.

use super::*;

/// A log of 60 steps of a system of `n` states, `m` inputs and `p` outputs, and what the steps one by one make of it.
fn log_of(system: &System, belief: &Belief) -> (Vec<f64>, Vec<f64>, Replayed) {
    let (m, p, steps) = (system.g.ncols(), system.h.nrows(), 60);
    let wave = |a: f64, count: usize| (0..count).map(|i| libm::sin(a * i as f64)).collect::<Vec<_>>();
    let (inputs, readings) = (wave(0.3, steps * m), wave(1.7, steps * p));
    let mut there =
        Replayed { x: vec![], variances: vec![], p: belief.p.clone(), conditioned: true, log_likelihood: Some(0.0) };
    let mut belief = belief.clone();
    for k in 0..steps {
        let (u, y) = (&inputs[k * m..(k + 1) * m], &readings[k * p..(k + 1) * p]);
        let (u, y) = (DVector::from_column_slice(u), DVector::from_column_slice(y));
        let step = kalman_step(system, &belief, &u, &y).expect("pd");
        there.log_likelihood =
            there.log_likelihood.zip(log_density(&step.innovation, &step.s)).map(|(sum, one)| sum + one);
        belief = step.posterior;
        there.x.extend(belief.x.iter());
        there.variances.extend(belief.p.diagonal().iter());
    }
    there.p = belief.p;
    (inputs, readings, there)
}

/// A system of these sizes with nothing special about it, and a belief.
fn ordinary(n: usize, m: usize, p: usize) -> (System, Belief) {
    let entry = |a: f64, i: usize, j: usize| libm::sin(a * (i + 1) as f64 + 1.9 * (j * j + 1) as f64);
    let square = |a: f64, size: usize| DMatrix::from_fn(size, size, |i, j| entry(a, i, j));
    let covariance = |a: f64, size: usize| {
        let root = square(a, size);
        &root * root.transpose() + 0.1 * DMatrix::identity(size, size)
    };
    let (f, g) = (square(2.3, n) * (0.9 / n as f64), DMatrix::from_fn(n, m, |i, j| entry(0.7, i, j)));
    let h = DMatrix::from_fn(p, n, |i, j| entry(3.1, i, j));
    let system = System::new(f, g, h, 0.1 * covariance(1.1, n), covariance(1.7, p)).expect("sound");
    (system, belief_from(DVector::from_fn(n, |i, _| entry(0.3, i, 1)), covariance(0.6, n)).expect("sound"))
}

/// The sizes that are compiled and those that are not: a log, the filter as a class, and the step of sizes known at run
/// time.
#[test]
fn a_log_replayed_is_its_steps_one_by_one_bit_for_bit() {
    let (rail, two) = rail();
    let sizes = (1..=5).flat_map(|n| (0..=2).flat_map(move |m| (1..=3).map(move |p| (n, m, p))));
    for (system, belief) in sizes.map(|(n, m, p)| ordinary(n, m, p)).chain([(rail, two)]) {
        let (inputs, readings, there) = log_of(&system, &belief);
        let mut filter = KalmanFilter::new(&system, &belief).expect("it fits");
        let (m, p) = (system.g.ncols(), system.h.nrows());
        for k in 0..there.x.len() / belief.x.len() {
            filter.step(&inputs[k * m..(k + 1) * m], &readings[k * p..(k + 1) * p]).expect("pd");
        }
        assert_eq!(filter.belief().p, there.p);
        assert_eq!(
            (filter.x(), filter.log_likelihood()),
            (&there.x[there.x.len() - belief.x.len()..], there.log_likelihood)
        );
        assert_eq!(kalman_replay(&system, &belief, &inputs, &readings), Ok(there));
    }
}

/// Two outputs that are copies but for 10⁻⁸: square roots filter the log, and its likelihood has no digits.
#[test]
fn a_log_with_a_nearly_singular_innovation_is_filtered_and_has_no_likelihood() {
    let delta = 1e-8;
    let h = dmatrix![1.0, 0.0; 1.0, delta];
    let eye = DMatrix::identity(2, 2);
    let system = System::new(eye.clone(), DMatrix::zeros(2, 0), h, 0.0 * &eye, delta * delta * &eye).expect("sound");
    let belief = belief_from(dvector![0.0, 0.0], eye).expect("sound");
    let filtered = kalman_replay(&system, &belief, &[], &[0.3, 0.3]).expect("square roots suffice");
    assert_eq!(filtered.log_likelihood, None);
    assert!(filtered.x[0].is_finite());
}

/// 16 states and 8 outputs: a call takes a tenth of the steps that a small system may ask for.
#[test]
fn a_large_system_is_given_fewer_steps() {
    let (n, p) = (16, 8);
    let (eye, wide) = (DMatrix::identity(n, n), DMatrix::identity(p, n));
    let system = System::new(eye.clone(), DMatrix::zeros(n, 0), wide, eye.clone(), DMatrix::identity(p, p));
    let system = system.expect("sound");
    let refused = steady_state_gain(&system, eye.clone(), 10_001, 0.0).expect_err("too much work");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::Limit, "maxIterations"));
    let few = steady_state_gain(&system, eye.clone(), 10_000, 1e-9).expect("as many as are given by default");
    assert!(few.gain_converged);
    let belief = belief_from(DVector::zeros(n), eye).expect("sound");
    let refused = kalman_replay(&system, &belief, &[], &vec![0.0; 10_001 * p]).expect_err("too much work");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::Limit, "readings"));
    assert!(refused.message.contains("of 16 states and 8 outputs at least 1 and at most 10000"), "{}", refused.message);
}

#[test]
fn a_log_that_does_not_fit_is_refused_by_name() {
    let (system, belief) = rail();
    let blame = |system: &System, belief: &Belief, inputs: &[f64], readings: &[f64]| {
        let error = kalman_replay(system, belief, inputs, readings).expect_err("refused");
        (error.code, error.argument.to_string(), error.message.to_string())
    };
    let short = |(code, argument, _): (Code, String, String)| (code, argument);
    assert_eq!(short(blame(&system, &belief, &[], &[])), (Code::Limit, "readings".into()));
    let long = vec![0.0; MAX_LOG + 1];
    assert_eq!(short(blame(&system, &belief, &long, &long)), (Code::Limit, "readings".into()));
    assert!(kalman_replay(&system, &belief, &long[1..], &long[1..]).is_ok());
    assert_eq!(short(blame(&system, &belief, &[0.0], &[0.0, 1.0])), (Code::Shape, "inputs".into()));
    let pair = System { h: DMatrix::identity(2, 2), w: DMatrix::identity(2, 2), ..system.clone() };
    assert_eq!(short(blame(&pair, &belief, &[0.0], &[0.0, 1.0, 2.0])), (Code::Shape, "readings".into()));
    assert_eq!(short(blame(&system, &belief, &[0.0, f64::NAN], &[0.0, 1.0])), (Code::NotFinite, "inputs[1]".into()));
    assert_eq!(
        short(blame(&system, &belief, &[0.0, 0.0], &[f64::INFINITY, 1.0])),
        (Code::NotFinite, "readings[0]".into())
    );
    let other = belief_from(dvector![0.0], dmatrix![1.0]).expect("sound");
    assert_eq!(short(blame(&system, &other, &[0.0], &[0.0])), (Code::Shape, "belief".into()));

    let undriven = System { g: DMatrix::zeros(2, 0), ..system.clone() };
    assert_eq!(short(blame(&undriven, &belief, &[0.0], &[0.0])), (Code::Shape, "inputs".into()));

    // A refused step of a log has the code of the step by itself; the message counts the steps from one.
    let pushed = System { g: dmatrix![1e308; 1e308], ..system.clone() };
    assert_eq!(short(blame(&pushed, &belief, &[0.0, 10.0], &[0.0; 2])), (Code::NotFinite, "inputs".into()));
    let seen = System { h: dmatrix![1e308, 0.0], ..system.clone() };
    assert_eq!(short(blame(&seen, &belief, &[0.0], &[0.0])), (Code::NotFinite, "belief.x".into()));
    let (code, argument, message) = blame(&system, &belief, &[0.0; 3], &[0.0, 1.7e308, -1.7e308]);
    assert_eq!((code, argument.as_str()), (Code::NotFinite, "readings"));
    assert!(message.ends_with("at step 3"), "{message}");
    let unstable = System { f: dmatrix![1e200, 0.0; 0.0, 1.0], h: dmatrix![0.0, 1.0], ..system.clone() };
    let (code, argument, _) = blame(&unstable, &belief, &[0.0; 3], &[0.0; 3]);
    assert_eq!((code, argument.as_str()), (Code::NotFinite, "belief.P"));
    let far = Belief { x: dvector![1e308, 0.0], p: belief.p.clone() };
    let fast = System { f: dmatrix![10.0, 0.0; 0.0, 1.0], ..system.clone() };
    assert_eq!(short(blame(&fast, &far, &[0.0], &[0.0])), (Code::NotFinite, "belief.x".into()));
    let noiseless = System { w: dmatrix![0.0], v: DMatrix::zeros(2, 2), ..system };
    let certain = Belief { x: belief.x, p: DMatrix::zeros(2, 2) };
    assert_eq!(short(blame(&noiseless, &certain, &[0.0], &[0.0])), (Code::InnovationNotPositiveDefinite, "W".into()));
}
