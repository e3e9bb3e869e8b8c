//! A system in continuous time over spans of many lengths.

use super::*;
use nalgebra::DMatrix;

mod exact;

use exact::{APART, Exact, STIFF, SWINGING};

/// Rates of a thousand and of a tenth a second, coupled.
fn stiff() -> Continuous {
    let a = dmatrix![-1000.0, 2.0, 0.5; 1.0, -1.0, 0.25; 0.0, -3.0, -0.01];
    let q = dmatrix![4.0, 1.0, 0.0; 1.0, 2.0, 0.5; 0.0, 0.5, 1.0];
    Continuous::new(a, dmatrix![1.0; 0.0; 0.5], q).expect("sound")
}

fn swinging() -> Continuous {
    let (a, q) = (dmatrix![0.0, 1.0; -4.0, -0.0625], dmatrix![0.0, 0.0; 0.0, 0.5]);
    Continuous::new(a, dmatrix![0.0; 1.0], q).expect("sound")
}

/// Rates of 2²⁰ and of 2⁻¹⁰ a second, apart: each entry of an answer is a formula of its own.
fn apart() -> Continuous {
    let a = DMatrix::from_diagonal(&dvector![-1_048_576.0, -0.000_976_562_5]);
    Continuous::new(a, dmatrix![1.0; 1.0], dmatrix![1.0, 0.5; 0.5, 1.0]).expect("sound")
}

/// The largest error of an entry, as a part of the largest.
fn error(found: &DMatrix<f64>, exact: &[f64]) -> f64 {
    let exact = DMatrix::from_row_slice(found.nrows(), found.ncols(), exact);
    let largest = exact.amax();
    (found - exact).amax() / if largest == 0.0 { 1.0 } else { largest }
}

#[test]
fn a_span_of_any_length_has_the_digits_of_its_fifty() {
    for (system, spans) in [(stiff(), STIFF), (swinging(), SWINGING)] {
        for Exact { dt, f, g, v } in spans {
            let found = system.discretize(dt).expect("finite");
            // A few roundings; what is left of a state after many times its time constant is known no better than A is.
            let tolerance = if found.f.amax() < 0.1 { 2e-13 } else { 4e-15 };
            assert!(error(&found.f, f) < tolerance, "F over {dt}: {}", found.f);
            assert!(error(&found.g, g) < 4e-15 && error(&found.v, v) < 4e-15, "over {dt}: {found:?}");
        }
    }
}

#[test]
fn a_slow_state_keeps_its_digits_beside_a_fast_one() {
    for Exact { dt, f, g, v } in APART {
        let found = apart().discretize(dt).expect("finite");
        for (found, exact) in [(found.f, f), (found.g, g), (found.v, v)] {
            for (found, exact) in found.transpose().iter().zip(exact) {
                assert!((found - exact).abs() <= 4e-15 * exact.abs(), "over {dt}: {found} against {exact}");
            }
        }
    }
}

#[test]
fn a_constant_speed_is_exact_over_any_span() {
    let (a, b) = (dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![0.0; 1.0]);
    let system = Continuous::new(a, b, dmatrix![0.0, 0.0; 0.0, 3.0]).expect("sound");
    for dt in [1e-12, 0.1, 0.5, 1.0, 7.3, 1e9] {
        let Discrete { f, g, v } = system.discretize(dt).expect("finite");
        assert_eq!((f, g), (dmatrix![1.0, dt; 0.0, 1.0], dmatrix![dt * dt / 2.0; dt]));
        let exact = [dt * dt * dt, 1.5 * dt * dt, 1.5 * dt * dt, 3.0 * dt];
        assert!(v.iter().zip(exact).all(|(found, exact)| (found / exact - 1.0).abs() < 1e-15), "{v}");
    }
}

/// 16 integrators in a chain, in any order of the states: entry (i, j) of F is dt^k/k! for the k links between them,
/// that of V is dt^{k+l+1}/(k! l! (k+l+1)), for noise on the last.
#[test]
fn a_chain_of_integrators_ends_its_series_by_itself() {
    let (n, dt) = (16, 3.0);
    let place = |i: usize| 5 * i % n;
    let factorial = |k: usize| (1..=k).map(|i| i as f64).product::<f64>();
    let part = |k: usize| libm::pow(dt, k as f64) / factorial(k);
    let (mut a, mut q) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    (1..n).for_each(|i| a[(place(i - 1), place(i))] = 1.0);
    q[(place(n - 1), place(n - 1))] = 1.0;
    let Discrete { f, v, .. } =
        Continuous::new(a, DMatrix::zeros(n, 0), q).and_then(|chain| chain.discretize(dt)).expect("finite");
    for i in 0..n {
        for j in 0..n {
            let exact = if j < i { 0.0 } else { part(j - i) };
            assert!((f[(place(i), place(j))] - exact).abs() <= 1e-14 * exact);
            let (k, l) = (n - 1 - i, n - 1 - j);
            let exact = part(k) * part(l) * dt / (k + l + 1) as f64;
            assert!((v[(place(i), place(j))] / exact - 1.0).abs() < 1e-14, "({i}, {j})");
        }
    }
}

/// Over two spans in a row a system is what it is over both at once, and V is a covariance to the last bit.
#[test]
fn spans_join() {
    for n in 1..=6 {
        let entry = |a: f64, i: usize, j: usize| libm::sin(a * (i + 1) as f64 + 1.9 * (j * j + 1) as f64);
        let root = DMatrix::from_fn(n, 2, |i, j| entry(1.1, i, j));
        let (a, b) = (DMatrix::from_fn(n, n, |i, j| entry(2.3, i, j)), DMatrix::from_fn(n, 1, |i, j| entry(0.7, i, j)));
        let system = Continuous::new(a, b, &root * root.transpose()).expect("sound");
        for (first, second) in [(1e-9, 1e-9), (0.01, 0.7), (1.0, 0.3), (4.0, 0.001)] {
            let [one, two, both] = [first, second, first + second].map(|dt| system.discretize(dt).expect("finite"));
            let joined = [&two.f * &one.f, &two.f * &one.g + &two.g, &two.f * &one.v * two.f.transpose() + &two.v];
            for (joined, at_once) in joined.iter().zip([&both.f, &both.g, &both.v]) {
                assert!((joined - at_once).amax() < 1e-13 * at_once.amax(), "{n} states over {first} and {second}");
            }
            assert_eq!(both.v, both.v.transpose());
            assert!(validate::covariance(both.v.clone(), n, "V").is_ok());
        }
    }
}

#[test]
fn over_no_time_nothing_happens() {
    for dt in [0.0, -0.0] {
        let Discrete { f, g, v } = stiff().discretize(dt).expect("finite");
        assert_eq!((f, g, v), (DMatrix::identity(3, 3), DMatrix::zeros(3, 1), DMatrix::zeros(3, 3)));
    }
}

#[test]
fn rates_and_spans_at_the_ends_of_the_range_have_answers_or_are_refused() {
    let one = |a: f64, dt: f64| {
        let found = Continuous::new(dmatrix![a], dmatrix![1.0], dmatrix![2.0]).and_then(|one| one.discretize(dt));
        found.map(|it| (it.f[0], it.g[0], it.v[0])).map_err(|e| (e.code, e.argument.to_string()))
    };
    let (f, g, v) = one(-1.0, 1e308).expect("it decays");
    assert!(f == 0.0 && (g - 1.0).abs() < 1e-15 && (v - 1.0).abs() < 1e-15, "{g} {v}");
    assert_eq!(one(-1.0, 5e-324), Ok((1.0, 5e-324, 0.0)));
    assert_eq!(one(0.0, 1e307), Ok((1.0, 1e307, 2e307)));
    let (f, g, v) = one(-1e307, 1e9).expect("it decays");
    assert!(f == 0.0 && (g * 1e307 - 1.0).abs() < 1e-12 && (v * 1e307 - 1.0).abs() < 1e-12, "{g} {v}");
    for (a, dt) in [(1.0, 1e9), (1e308, 1e308), (0.0, 1.5e308)] {
        assert_eq!(one(a, dt), Err((Code::NotFinite, "dt".into())), "{a} over {dt}");
    }
}

#[test]
fn what_is_no_system_or_no_span_is_refused_by_name() {
    let blamed = |a: DMatrix<f64>, b: DMatrix<f64>, q: DMatrix<f64>, dt: f64| {
        let error = Continuous::new(a, b, q).and_then(|it| it.discretize(dt)).expect_err("refused");
        (error.code, error.argument.to_string())
    };
    let (one, two) = (dmatrix![1.0], DMatrix::<f64>::identity(2, 2));
    let cases = [
        (blamed(DMatrix::zeros(0, 0), one.clone(), one.clone(), 1.0), (Code::Shape, "A")),
        (blamed(DMatrix::zeros(17, 17), one.clone(), one.clone(), 1.0), (Code::Limit, "A")),
        (blamed(DMatrix::zeros(1, 2), one.clone(), one.clone(), 1.0), (Code::Shape, "A")),
        (blamed(one.clone(), DMatrix::zeros(1, 9), one.clone(), 1.0), (Code::Limit, "B")),
        (blamed(one.clone(), two.clone(), one.clone(), 1.0), (Code::Shape, "B")),
        (blamed(one.clone(), one.clone(), two.clone(), 1.0), (Code::Shape, "Q")),
        (blamed(dmatrix![f64::NAN], one.clone(), one.clone(), 1.0), (Code::NotFinite, "A")),
        (blamed(one.clone(), one.clone(), -&one, 1.0), (Code::NotPositiveSemidefinite, "Q")),
        (blamed(two.clone(), DMatrix::zeros(2, 0), dmatrix![1.0, 0.5; 0.0, 1.0], 1.0), (Code::NotSymmetric, "Q")),
        (blamed(one.clone(), one.clone(), one.clone(), -1e-300), (Code::Limit, "dt")),
        (blamed(one.clone(), one.clone(), one.clone(), f64::NAN), (Code::NotFinite, "dt")),
        (blamed(one.clone(), one.clone(), one.clone(), f64::INFINITY), (Code::NotFinite, "dt")),
    ];
    for (found, (code, argument)) in cases {
        assert_eq!(found, (code, argument.to_string()));
    }
}
