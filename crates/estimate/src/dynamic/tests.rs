use super::*;
use crate::Lti;
use crate::kf::kalman_step;
use crate::likelihood::log_density;
use crate::rail::{dead_reckoning, position_sensor};
use crate::validate::belief as belief_from;
use nalgebra::{SMatrix, U1, U2, Vector1, dmatrix, dvector};

mod continuous;
mod filter;
mod one_call;
mod own;
mod replay;
mod smooth;
mod timeline;
mod timeline_own;

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
