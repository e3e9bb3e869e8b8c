//! The thirteen checks of the chapter, natively (`cargo test`) and in wasm (`wasm-pack test --node tests`), from this
//! one source. Each computes through the public interface, and says which claim of the text it holds up. The numbers
//! that the text prints stand in `printed_by_checks.json`, by which Node holds the shipped module to them too.

use std::collections::BTreeMap;

use chapter_kalman::checks::CHECKS;
use chapter_kalman::givens::Givens;
use lab::Check;
use wasm_bindgen_test::wasm_bindgen_test as in_wasm;

/// Check `id`, computed and passed.
fn passed(id: u8) -> Check {
    let givens = Givens::default();
    let mut checks = CHECKS.iter().map(|check| check(&givens).expect("the core answers"));
    let check = checks.find(|check| check.id == id).expect("there is such a check");
    assert!(check.passed, "{check:#?}");
    assert!(!check.expected.is_empty());
    check
}

/// What the text prints of a check's numbers: of so many, those from the place `from` on.
#[derive(serde::Deserialize)]
struct Printed {
    of: usize,
    from: usize,
    numbers: Vec<f64>,
}

/// Every number is the rounded one that the text prints, to 10⁻³ however many decimals are printed: that it is this
/// claim which was checked. How sharply it was is the check's own tolerance.
fn prints(check: &Check) {
    let rows = serde_json::from_str::<BTreeMap<u8, Printed>>(include_str!("printed_by_checks.json")).expect("a table");
    let Printed { of, from, numbers } = &rows[&check.id];
    assert_eq!(check.actual.len(), *of, "{check:#?}");
    let actual = &check.actual[*from..from + numbers.len()];
    for (a, p) in actual.iter().zip(numbers) {
        assert!((a - p).abs() <= 1e-3, "{a} is printed {p}");
    }
}

/// Every number within `tolerance` of its own.
fn near(actual: &[f64], exact: &[f64], tolerance: f64) {
    assert_eq!(actual.len(), exact.len(), "{actual:?} against {exact:?}");
    for (a, e) in actual.iter().zip(exact) {
        assert!((a - e).abs() <= tolerance, "{a} is not {e}");
    }
}

#[test]
#[in_wasm]
fn check_1_the_first_hand_step() {
    let check = passed(1);
    assert_eq!(check.tolerance, 1e-12);
    prints(&check);
}

#[test]
#[in_wasm]
fn check_2_the_second_hand_step() {
    let check = passed(2);
    assert_eq!(check.tolerance, 1e-12);
    // Exact: S = 2.6 after the first step, hence P⁻₁₂ = 59/130 and P⁻₂₂ = 131/260 in the second; then ν = −0.95.
    let (r1, r2, nu) = (118.0 / 261.0, 131.0 / 261.0, -0.95);
    let exact = [261.0 / 260.0, r1, r2, 4.95 + r1 * nu, 2.95 + r2 * nu, 16429.0 / 10440.0, 59.0 / 261.0, 131.0 / 522.0];
    near(&check.actual, &exact, 1e-12);
    prints(&check);
}

#[test]
#[in_wasm]
fn check_3_the_observability_ranks() {
    assert_eq!(passed(3).actual, [1.0, 2.0]);
}

#[test]
#[in_wasm]
fn check_4_the_placed_eigenvalues() {
    let check = passed(4);
    assert_eq!(check.tolerance, 1e-12);
    near(&check.actual, &[0.5, 0.0, 0.2, 0.0], 1e-12);
}

#[test]
#[in_wasm]
fn check_5_the_error_ratio() {
    let check = passed(5);
    // The smaller eigenvalue is 0.4 of the larger: after 24 steps what it adds is down to 0.4²⁴ ≈ 3·10⁻¹⁰.
    assert_eq!(check.tolerance, 1e-8);
    near(&check.actual, &[0.5], 1e-8);
    assert_ne!(check.actual, check.expected, "it converges; it does not start there");
}

#[test]
#[in_wasm]
fn check_6_the_gain_by_brute_force() {
    prints(&passed(6));
}

#[test]
#[in_wasm]
fn check_7_the_riccati_limits() {
    let check = passed(7);
    assert_eq!(check.tolerance, 1e-10);
    prints(&check);
    // The velocity sensor's limit in closed form: R∞ = [1/2, (√21 − 1)/10], eigenvalues 1 and (11 − √21)/10.
    let root = 21.0_f64.sqrt();
    near(&check.actual[8..14], &[0.5, (root - 1.0) / 10.0, 1.0, 0.0, (11.0 - root) / 10.0, 0.0], 1e-10);
    assert_eq!([&check.actual[6..8], &check.actual[14..]].concat(), [1.0, 1.0, 0.0, 1.0], "P and R, then R alone");
}

#[test]
#[in_wasm]
fn check_8_the_jacobians() {
    let check = passed(8);
    assert!(check.actual.iter().all(|gap| *gap > 0.0), "two ways of computing that agree to the last bit are one way");
}

#[test]
#[in_wasm]
fn check_9_five_ranks_frozen_and_along_the_path() {
    assert_eq!(passed(9).actual, [2.0, 3.0, 3.0, 2.0, 2.0, 2.0, 3.0, 2.0, 3.0, 2.0]);
}

#[test]
#[in_wasm]
fn check_10_the_traces_with_one_landmark_and_with_two() {
    prints(&passed(10));
}

#[test]
#[in_wasm]
fn check_11_linear_slam() {
    let check = passed(11);
    assert_eq!(check.actual[..2], [4.0, 1.0]);
    prints(&check);
}

#[test]
#[in_wasm]
fn check_12_range_bearing_slam() {
    let check = passed(12);
    assert_eq!(check.actual[..4], [600.0, 3.0, 0.0, 0.0]);
}

#[test]
#[in_wasm]
fn check_13_problem_9() {
    let check = passed(13);
    for (actual, expected) in check.actual.iter().zip(&check.expected).take(6) {
        assert!((actual - expected).abs() < 1e-12, "the EKF's step is known to the last digits");
    }
    prints(&check);
}
