use super::*;
use Verdict::{No, Undecided, Yes};
use nalgebra::dmatrix;

/// Observable and detectable at the tolerance 1e-9.
fn verdicts(f: &DMatrix<f64>, c: &DMatrix<f64>) -> (Verdict, Verdict) {
    let found = detectability(f, c, 1e-9).expect("found");
    (found.observable, found.detectable)
}

/// The pair in other coordinates, x = Tz with T = I − 2vvᵀ/vᵀv: full matrices with the same answer.
fn turned(f: &DMatrix<f64>, c: &DMatrix<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
    let n = f.nrows();
    let v = DVector::from_fn(n, |i, _| 1.0 + libm::cos(3.0 * i as f64));
    let t = DMatrix::identity(n, n) - &v * v.transpose() * (2.0 / v.norm_squared());
    (&t * f * &t, c * &t)
}

/// The pair with state i in units of s_i.
fn in_units(f: &DMatrix<f64>, c: &DMatrix<f64>, units: &[f64]) -> (DMatrix<f64>, DMatrix<f64>) {
    let d = DMatrix::from_diagonal(&DVector::from_column_slice(units));
    let inverse = DMatrix::from_diagonal(&DVector::from_iterator(units.len(), units.iter().map(|u| 1.0 / u)));
    (inverse * f * &d, c * d)
}

fn constant_velocity() -> DMatrix<f64> {
    dmatrix![1.0, 0.5; 0.0, 1.0]
}

#[test]
fn the_rail_robot_is_seen_by_its_position_and_not_by_its_velocity() {
    let f = constant_velocity();
    assert_eq!(verdicts(&f, &dmatrix![1.0, 0.0]), (Yes, Yes));
    assert_eq!(verdicts(&f, &dmatrix![0.0, 1.0]), (No, No));
    let found = detectability(&f, &dmatrix![0.0, 1.0], 1e-9).expect("found");
    assert_eq!(found.unseen[0].map(f64::abs), nalgebra::dvector![1.0, 0.0]);
    assert_eq!(found.modes, [Complex::from(1.0)]);
}

#[test]
fn an_unseen_direction_that_dies_out_leaves_a_system_detectable() {
    assert_eq!(verdicts(&dmatrix![0.5, 0.0; 0.0, 1.0], &dmatrix![0.0, 1.0]), (No, Yes));
    assert_eq!(verdicts(&dmatrix![1.2, 0.0; 0.0, 0.5], &dmatrix![0.0, 1.0]), (No, No));
    assert_eq!(verdicts(&dmatrix![1.2, 0.0; 0.0, 0.5], &dmatrix![1.0, 0.0]), (No, Yes));
    assert_eq!(verdicts(&DMatrix::identity(3, 3), &DMatrix::zeros(1, 3)), (No, No));
    assert_eq!(verdicts(&DMatrix::zeros(3, 3), &DMatrix::zeros(1, 3)), (No, Yes));
}

#[test]
fn full_matrices_have_the_answer_of_sparse_ones() {
    let blocks = |unseen: f64, coupling: f64| {
        dmatrix![
            1.0, 0.3, 0.0, 0.0;
            0.0, 0.9, 0.0, 0.0;
            0.2, 0.1, unseen, coupling;
            0.0, 0.4, 0.0, unseen
        ]
    };
    let c = dmatrix![1.0, 0.0, 0.0, 0.0];
    for (unseen, coupling, detectable) in [
        (1.0, 1.0, No),
        (0.8, 1.0, Yes),
        (-1.0, 0.0, No),
        (1.0 - 1e-5, 1.0, Undecided),
        (0.0, 1.0, Yes),
        (1.5, 2.0, No),
    ] {
        let (f, c) = turned(&blocks(unseen, coupling), &c);
        assert_eq!(verdicts(&f, &c), (No, detectable), "unseen {unseen}, coupled by {coupling}");
    }
}

#[test]
fn a_singular_f_is_judged_by_what_is_not_nilpotent_in_it() {
    // A shift register whose end is read, and whose beginning is.
    let shift = dmatrix![0.0, 0.0, 0.0; 1.0, 0.0, 0.0; 0.0, 1.0, 0.0];
    assert_eq!(verdicts(&shift, &dmatrix![0.0, 0.0, 1.0]), (Yes, Yes));
    assert_eq!(verdicts(&shift, &dmatrix![1.0, 0.0, 0.0]), (No, Yes));
}

#[test]
fn a_defective_f_that_is_seen_is_not_taken_for_unseen() {
    // Four times the eigenvalue 1: computed ones lie 1e-4 beside it.
    let f = DMatrix::from_fn(4, 4, |i, j| if i == j || j == i + 1 { 1.0 } else { 0.0 });
    for (c, expected) in [([1.0, 0.0, 0.0, 0.0], (Yes, Yes)), ([0.0, 1.0, 0.0, 0.0], (No, No))] {
        let (f, c) = turned(&f, &DMatrix::from_row_slice(1, 4, &c));
        assert_eq!(verdicts(&f, &c), expected);
    }
}

#[test]
fn units_do_not_change_the_answer() {
    let f = dmatrix![1.0, 0.1, 0.005; 0.0, 1.0, 0.1; 0.0, 0.0, 1.0];
    for (c, expected) in [([1.0, 0.0, 0.0], (Yes, Yes)), ([0.0, 1.0, 0.0], (No, No))] {
        for units in [[1.0, 1.0, 1.0], [1e-9, 1e3, 1e12], [1e6, 1e-6, 1.0], [1e-5, 1e5, 1e-5]] {
            let (f, c) = in_units(&f, &DMatrix::from_row_slice(1, 3, &c), &units);
            for output in [1e-12, 1.0, 1e15] {
                assert_eq!(verdicts(&f, &(&c * output)), expected, "units {units:?}, output times {output}");
            }
        }
    }
    assert_eq!(verdicts(&dmatrix![1.0, 0.0; 0.0, 0.5], &dmatrix![1e-12, 1.0]), (Yes, Yes));
}

/// Evened out, the two ways by which the second state is seen all but cancel: what is left is 2⁻³⁰. As given it is
/// 2⁻²¹.
#[test]
fn what_is_seen_well_in_the_units_given_is_seen() {
    let f = dmatrix![1.0, 0.0; libm::exp2(-20.0), 1.0];
    assert_eq!(verdicts(&f, &dmatrix![1.0, 1.0]), (Yes, Yes));
}

#[test]
fn a_coupling_below_the_tolerance_leaves_the_question_open() {
    // Two states that go alike but for 1e-11: their difference is seen that little.
    let f = dmatrix![1.0, 0.0; 0.0, 1.0 + 1e-11];
    assert_eq!(verdicts(&f, &dmatrix![1.0, 1.0]), (Undecided, Undecided));
    assert_eq!(verdicts(&dmatrix![0.5, 0.0; 0.0, 0.5 + 1e-11], &dmatrix![1.0, 1.0]), (Undecided, Yes));
    assert_eq!(verdicts(&dmatrix![1.0, 0.0; 0.0, 1.0 + 1e-6], &dmatrix![1.0, 1.0]), (Yes, Yes));
    let coarse = detectability(&dmatrix![1.0, 0.0; 0.0, 1.001], &dmatrix![1.0, 1.0], 0.01).expect("found");
    assert_eq!((coarse.observable, coarse.unseen.len()), (Undecided, 1));
    // An entry of the size of rounding may be one.
    assert_eq!(verdicts(&dmatrix![1.0, 0.0; 5e-17, 0.5], &dmatrix![0.0, 1.0]), (Undecided, Undecided));
}

/// Beside 1e20 the coupling of 0.1 is nothing, and yet H·F has it: no such system hides its second state.
#[test]
fn a_badly_scaled_system_is_not_said_to_hide_a_state() {
    for large in [1e12, 1e20, 1e60] {
        let f = dmatrix![large, 0.1; 0.0, 1.0];
        let found = detectability(&f, &dmatrix![1.0, 0.0], 1e-9).expect("found");
        assert_eq!((found.observable, found.detectable, found.by_entry), (Undecided, Undecided, true), "{large}");
        assert_eq!(verdicts(&f, &dmatrix![0.0, 1.0]), (No, No));
    }
    let alike = detectability(&dmatrix![1.0, 0.0; 0.0, 1.0 + 1e-11], &dmatrix![1.0, 1.0], 1e-9).expect("found");
    assert_eq!((alike.observable, alike.by_entry), (Undecided, false));
}

#[test]
fn sixteen_states_are_judged_too() {
    let chain = DMatrix::from_fn(16, 16, |i, j| {
        if i == j {
            0.95
        } else if j == i + 1 {
            0.1
        } else {
            0.0
        }
    });
    let first = DMatrix::from_fn(1, 16, |_, j| if j == 0 { 1.0 } else { 0.0 });
    let last = DMatrix::from_fn(1, 16, |_, j| if j == 15 { 1.0 } else { 0.0 });
    assert_eq!(verdicts(&chain, &first).0, Yes);
    assert_eq!(verdicts(&chain, &last).0, No);
    let (f, c) = turned(&chain, &first);
    assert_eq!(verdicts(&f, &c).0, Yes);
}

#[test]
fn what_cannot_be_a_tolerance_is_refused() {
    let error = detectability(&constant_velocity(), &dmatrix![1.0, 0.0], -1.0).expect_err("negative");
    assert_eq!(error.code, Code::Tolerance);
    assert_eq!(detectability(&constant_velocity(), &dmatrix![1.0, 0.0], 0.0).expect("exact").observable, Yes);
}
