use super::*;
use crate::Lti;
use crate::kf::kalman_step;
use crate::likelihood::log_density;
use crate::rail::{dead_reckoning, position_sensor};
use crate::validate::belief as belief_from;
use nalgebra::{SMatrix, U1, U2, Vector1, dmatrix, dvector};

fn at_run_time<const R: usize, const C: usize>(m: SMatrix<f64, R, C>) -> DMatrix<f64> {
    DMatrix::from_iterator(R, C, m.iter().copied())
}

#[test]
fn a_knob_s_eigenvalues_are_those_of_its_error_matrix() {
    let (sys, _) = position_sensor();
    let (f, g, h) = (at_run_time(sys.f), at_run_time(sys.g), at_run_time(sys.h));
    let system = System::new(f, g, h, at_run_time(sys.v), at_run_time(sys.w)).expect("sound");
    // K = [0.9, 0.8] places 0.5 and 0.2.
    let found = error_eigenvalues(&system, dmatrix![0.9; 0.8]).expect("found");
    let expected = [0.5, 0.2];
    assert_eq!(found.len(), 2);
    for (l, e) in found.iter().zip(expected) {
        assert!((l.re - e).abs() < 1e-14 && l.im == 0.0, "{found:?}");
    }
}

#[test]
fn an_empty_matrix_is_refused_by_name() {
    let error = observability(DMatrix::zeros(0, 0), DMatrix::zeros(1, 0), 1e-9).expect_err("empty");
    assert_eq!((error.code, error.argument.as_ref()), (Code::Shape, "F"));
    let error = observability(dmatrix![1.0], DMatrix::zeros(0, 1), 1e-9).expect_err("empty");
    assert_eq!((error.code, error.argument.as_ref()), (Code::Shape, "H"));
}

fn system_of(sys: &Lti<U2, U1, U1>) -> System {
    System::new(at_run_time(sys.f), at_run_time(sys.g), at_run_time(sys.h), at_run_time(sys.v), at_run_time(sys.w))
        .expect("a sound system")
}

fn belief_of(belief: &Gaussian<U2>) -> Belief {
    belief_from(dvector![belief.x[0], belief.x[1]], at_run_time(belief.p)).expect("a sound belief")
}

fn rail() -> (System, Belief) {
    let (sys, belief) = dead_reckoning();
    (system_of(&sys), belief_of(&belief))
}

#[test]
fn run_time_and_fixed_sizes_agree_bit_for_bit() {
    let (sys, mut typed) = dead_reckoning();
    let (system, mut belief) = rail();
    for k in 0..100 {
        let (u, y) = (0.1 * f64::from(k), libm::sin(f64::from(k)));
        let fixed = kalman_step(&sys, &typed, &Vector1::new(u), &Vector1::new(y)).expect("pd");
        let step = kalman_step(&system, &belief, &dvector![u], &dvector![y]).expect("pd");
        assert_eq!((step.innovation[0], step.s[0]), (fixed.innovation[0], fixed.s[0]));
        assert_eq!(step.r, at_run_time(fixed.r));
        typed = fixed.posterior;
        assert_eq!(step.posterior, belief_of(&typed));
        let x = observer_step(&system, step.r, belief.x.clone(), dvector![u], dvector![y]).expect("finite");
        assert_eq!(x, step.posterior.x);
        belief = step.posterior;
    }
    let typed = sys.steady_state_gain(&typed.p, 40, 1e-12).expect("runs");
    let found = steady_state_gain(&system, belief.p.clone(), 40, 1e-12).expect("runs");
    assert_eq!((found.r, found.iterations), (at_run_time(typed.r), typed.iterations));
    let schedule = gain_schedule(&system, belief.p, 40).expect("runs");
    assert_eq!(schedule[39], at_run_time(typed.r));
}

#[test]
fn the_correction_runs_through_the_most_likely_output() {
    let (system, belief) = rail();
    let step = kalman_step(&system, &belief, &dvector![0.0], &dvector![2.7]).expect("pd");
    let (x, p, h) = (step.predicted.x, step.predicted.p, system.h.clone());
    let y = most_likely_output(h.clone(), p.clone(), system.w.clone(), x.clone(), dvector![2.7]).expect("pd");
    assert!((y[0] - 2.95).abs() < 1e-14);
    let foot = mahalanobis_foot(h.clone(), p, x.clone(), y.clone()).expect("pd");
    assert!((foot - step.posterior.x).norm() < 1e-14);
    assert_eq!(euclidean_foot(h, x, y.clone()).expect("full rank"), dvector![4.0, y[0]]);
}

#[test]
fn a_system_without_inputs_is_a_system() {
    let (f, w) = (dmatrix![1.0], dmatrix![0.5]);
    let system = System::new(f.clone(), DMatrix::zeros(1, 0), f.clone(), w.clone(), w).expect("sound");
    let belief = belief_from(dvector![2.0], f).expect("sound");
    let step = kalman_step(&system, &belief, &DVector::zeros(0), &dvector![2.0]).expect("pd");
    assert_eq!((step.predicted.x[0], step.posterior.x[0], step.predicted.p[0]), (2.0, 2.0, 1.5));
}

#[test]
fn the_culprit_is_named() {
    let (system, belief) = rail();
    let System { f, g, h, v, w } = system.clone();
    let blame = |e: Error| (e.code, e.argument.to_string());
    let build = |f: &DMatrix<f64>, g: &DMatrix<f64>, h: &DMatrix<f64>, v: &DMatrix<f64>, w: &DMatrix<f64>| {
        blame(System::new(f.clone(), g.clone(), h.clone(), v.clone(), w.clone()).expect_err("refused"))
    };
    let row = dmatrix![1.0, 0.0];
    assert_eq!(build(&row, &g, &h, &v, &w), (Code::Shape, "F".into()));
    assert_eq!(build(&f, &row, &h, &v, &w), (Code::Shape, "G".into()));
    assert_eq!(build(&f, &g, &dmatrix![1.0], &v, &w), (Code::Shape, "H".into()));
    assert_eq!(build(&f, &g, &h, &dmatrix![1.0, 2.0; 0.0, 1.0], &w), (Code::NotSymmetric, "V".into()));
    assert_eq!(build(&f, &g, &h, &v, &dmatrix![-1.0]), (Code::NotPositiveSemidefinite, "W".into()));
    let large = DMatrix::identity(17, 17);
    assert_eq!(build(&large, &g, &h, &v, &w), (Code::Limit, "F".into()));
    assert_eq!(build(&f, &DMatrix::zeros(2, 9), &h, &v, &w), (Code::Limit, "G".into()));
    assert_eq!(build(&f, &g, &DMatrix::zeros(9, 2), &v, &w), (Code::Limit, "H".into()));
    let step = |u, y| blame(kalman_step(&system, &belief, &u, &y).expect_err("refused"));
    assert_eq!(step(dvector![0.0, 0.0], dvector![0.0]), (Code::Shape, "u".into()));
    assert_eq!(step(dvector![0.0], dvector![f64::NAN]), (Code::NotFinite, "y".into()));
    let error = belief_from(dvector![0.0], dmatrix![-1.0]).expect_err("refused").within("belief");
    assert_eq!(blame(error), (Code::NotPositiveSemidefinite, "belief.P".into()));
}

#[test]
fn an_overflow_blames_the_argument_by_the_caller_s_name() {
    let blame = |e: Error| (e.code, e.argument.to_string());
    let not_finite = |argument: &str| (Code::NotFinite, argument.to_string());
    let (system, belief) = rail();
    let (zero, vast) = (dvector![0.0], dvector![1.7e308, 1.7e308]);
    let step = |b: &Belief, u, y| blame(kalman_step(&system, b, &u, &y).expect_err("overflows"));
    let far = Belief { x: vast.clone(), ..belief.clone() };
    assert_eq!(step(&far, zero.clone(), zero.clone()), not_finite("belief.x"));
    let wide = Belief { p: 1.7e308 * DMatrix::identity(2, 2), ..belief.clone() };
    assert_eq!(step(&wide, zero.clone(), zero.clone()), not_finite("belief.P"));
    let fast = Belief { x: dvector![0.0, -1e308], ..belief.clone() };
    assert_eq!(step(&fast, zero.clone(), dvector![1e308]), not_finite("y"));
    assert_eq!(blame(gain_schedule(&system, wide.p.clone(), 3).expect_err("overflows")), not_finite("P0"));
    assert_eq!(blame(steady_state_gain(&system, wide.p, 3, 0.1).expect_err("overflows")), not_finite("P0"));

    let observe = |k, x, u, y| blame(observer_step(&system, k, x, u, y).expect_err("overflows"));
    let k = dmatrix![0.5; 0.5];
    assert_eq!(observe(1e308 * &k, belief.x.clone(), zero.clone(), dvector![99.0]), not_finite("K"));
    assert_eq!(observe(k.clone(), vast, zero.clone(), zero.clone()), not_finite("x"));
    assert_eq!(observe(k, fast.x, zero.clone(), dvector![1e308]), not_finite("y"));
    let strong = System { f: 10.0 * &system.f, g: dmatrix![0.0; 10.0], ..system };
    let pushed = kalman_step(&strong, &belief, &dvector![1e308], &zero).expect_err("overflows");
    assert_eq!(blame(pushed), not_finite("u"));
    let vast: DMatrix<f64> = 1e308 * DMatrix::identity(2, 2);
    assert_eq!(blame(error_eigenvalues(&strong, dmatrix![1e308; 1e308]).expect_err("overflows")), not_finite("K"));
    assert_eq!(blame(observability(vast.clone(), vast, 0.1).expect_err("overflows")), not_finite("F"));
}

#[test]
fn sixteen_states_and_eight_outputs_are_in_reach() {
    let (n, p) = (MAX_STATES, MAX_OUTPUTS);
    let f = DMatrix::from_fn(n, n, |i, j| if i == j { 1.0 } else { 0.02 * libm::sin((3 * i + 7 * j) as f64) });
    let h = DMatrix::from_fn(p, n, |i, j| if j % p == i { 1.0 + 0.1 * j as f64 } else { 0.0 });
    let system = System::new(
        f.clone(),
        DMatrix::zeros(n, MAX_INPUTS),
        h.clone(),
        0.1 * DMatrix::identity(n, n),
        DMatrix::identity(p, p),
    )
    .expect("at the caps");
    let found = steady_state_gain(&system, DMatrix::identity(n, n), 10_000, 1e-12).expect("converges");
    assert!(found.converged && found.gain_converged);
    assert_eq!(observability(f, h, 1e-9).expect("found").rank, n);
    let moduli: Vec<f64> =
        error_eigenvalues(&system, found.r).expect("found").iter().map(|l| numerics::hypot(l.re, l.im)).collect();
    assert!(moduli[0] < 1.0 && moduli.is_sorted_by(|a, b| a >= b));
}

#[test]
fn feet_and_ellipses_name_what_they_cannot_use() {
    let code = |e: Error| (e.code, e.argument.to_string());
    let h = dmatrix![1.0, 0.0; 1.0, 0.0];
    let (x, y) = (dvector![0.0, 0.0], dvector![1.0, 1.0]);
    let refused = euclidean_foot(h.clone(), x.clone(), y.clone()).expect_err("rank one");
    assert_eq!(code(refused), (Code::InnovationNotPositiveDefinite, "H".into()));
    let foot = |h: &DMatrix<f64>, p| mahalanobis_foot(h.clone(), p, x.clone(), y.clone()).map_err(code);
    let singular = |argument: &str| Err((Code::InnovationNotPositiveDefinite, argument.into()));
    assert_eq!(foot(&h, DMatrix::identity(2, 2)), singular("H"), "its rows are copies");
    assert_eq!(foot(&DMatrix::identity(2, 2), dmatrix![1.0, 0.0; 0.0, 0.0]), singular("P"));
    let vast = 1e200 * DMatrix::identity(2, 2);
    assert_eq!(foot(&vast, DMatrix::identity(2, 2)), Err((Code::NotFinite, "H".into())));
    let p = DMatrix::identity(2, 2);
    assert_eq!(code(covariance_ellipse(p.clone(), 0.0).expect_err("no radius")), (Code::Limit, "radius".into()));
    assert_eq!(code(covariance_ellipse(p, f64::INFINITY).expect_err("infinite")).0, Code::NotFinite);
    assert_eq!(code(covariance_ellipse(dmatrix![1.0], 1.0).expect_err("1 × 1")).0, Code::Shape);
    let many = place_observer_gain(DMatrix::identity(2, 2), DMatrix::identity(2, 2), &[]).expect_err("two outputs");
    assert_eq!(code(many), (Code::Shape, "H".into()));
}

/// A log of 60 steps of a system of `n` states, `m` inputs and `p` outputs, and what the steps one by one make of it.
fn log_of(system: &System, belief: &Belief) -> (Vec<f64>, Vec<f64>, Replayed) {
    let (m, p, steps) = (system.g.ncols(), system.h.nrows(), 60);
    let wave = |a: f64, count: usize| (0..count).map(|i| libm::sin(a * i as f64)).collect::<Vec<_>>();
    let (inputs, readings) = (wave(0.3, steps * m), wave(1.7, steps * p));
    let mut there = Replayed { x: vec![], variances: vec![], p: belief.p.clone(), log_likelihood: Some(0.0) };
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

#[test]
fn a_log_replayed_is_its_steps_one_by_one_bit_for_bit() {
    let two_outputs = {
        let f = dmatrix![1.0, 0.5, 0.1; 0.0, 1.0, 0.5; 0.0, 0.0, 0.9];
        let (g, h) = (dmatrix![0.0, 0.1; 0.0, 0.2; 0.5, 0.0], dmatrix![1.0, 0.0, 0.0; 0.0, 1.0, 0.5]);
        System::new(f, g, h, DMatrix::identity(3, 3) * 0.02, dmatrix![0.5, 0.1; 0.1, 0.3]).expect("sound")
    };
    let three = belief_from(dvector![1.0, -1.0, 0.5], DMatrix::identity(3, 3)).expect("sound");
    let (rail, two) = rail();
    let undriven = System { g: DMatrix::zeros(2, 0), ..rail.clone() };
    for (system, belief) in [(rail, &two), (undriven, &two), (two_outputs, &three)] {
        let (inputs, readings, there) = log_of(&system, belief);
        assert_eq!(kalman_replay(&system, belief, &inputs, &readings), Ok(there));
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
