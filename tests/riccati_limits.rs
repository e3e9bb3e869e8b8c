//! The limit of the Riccati recursion on systems whose limit is known to fifty digits and more.
//! `heldout/make_limits.py` wrote them without any code of this workspace; each limit was proved there by the equation
//! that it satisfies.

#![cfg(not(target_arch = "wasm32"))]

use estimate::RiccatiLimit;
use estimate::dynamic::{self, Limit, System, steady_state};
use nalgebra::DMatrix;
use serde_json::Value;

/// What an answer may be off, in units of its own, where the question is well posed.
const OFF: f64 = 1e-9;
/// A question is well posed where a change of every number by its rounding, 10⁻¹⁶, changes the answer by so much less.
const WELL_POSED: f64 = 1e5;

fn matrix(rows: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = serde_json::from_value(rows.clone()).expect("rows of numbers");
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

fn all(text: &str) -> Vec<(String, System, Value)> {
    let all: Vec<Value> = serde_json::from_str(text).expect("JSON");
    let given = |one: Value| {
        let [f, h, v, w] = ["F", "H", "V", "W"].map(|name| matrix(&one[name]));
        let name = one["name"].as_str().expect("a name").to_owned();
        let n = f.nrows();
        let system = System::new(f, DMatrix::zeros(n, 0), h, v, w).unwrap_or_else(|error| panic!("{name}: {error}"));
        (name, system, one)
    };
    all.into_iter().map(given).collect()
}

fn from_one(name: &str, system: &System) -> Limit {
    let n = system.f.nrows();
    steady_state(system, DMatrix::identity(n, n)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Each entry as a part of the variances, or of the gain's unit, that it belongs to.
fn off(found: &Limit, system: &System, one: &Value) -> f64 {
    let p: Vec<Vec<f64>> = serde_json::from_value(one["P"].clone()).expect("the lower triangle");
    let (k, n) = (matrix(&one["K"]), p.len());
    let p = DMatrix::from_fn(n, n, |i, j| p[i.max(j)][i.min(j)]);
    let s = &system.h * &p * system.h.transpose() + &system.w;
    let sigma = p.diagonal().map(f64::sqrt);
    let of_p = DMatrix::from_fn(n, n, |i, j| (found.p[(i, j)] - p[(i, j)]) / sigma[i] / sigma[j]);
    let of_r = DMatrix::from_fn(n, k.ncols(), |i, j| (found.r[(i, j)] - k[(i, j)]) * s[(j, j)].sqrt() / sigma[i]);
    of_p.amax().max(of_r.amax())
}

#[test]
fn the_limit_is_right_to_nine_digits_wherever_the_question_has_so_many() {
    let (mut faults, mut counts) = (Vec::new(), [0; 3]);
    for (name, system, one) in all(include_str!("heldout/limits.json")) {
        let found = from_one(&name, &system);
        let condition = one["condition"].as_f64().expect("a condition");
        let off = off(&found, &system, &one);
        counts[usize::from(name.starts_with("by lot"))] += 1;
        counts[2] += usize::from(condition <= WELL_POSED);
        let allowed = OFF * (condition / WELL_POSED).max(1.0);
        if off.is_nan() || off > allowed || !found.converged || !found.gain_converged || found.depends_on_start {
            faults.push(format!("{name}: off {off:.1e}, condition {condition:.0e}, {found:?}"));
        }
    }
    assert!(faults.is_empty(), "{} of {counts:?}:\n{}", faults.len(), faults.join("\n"));
    assert!(counts[0] >= 100 && counts[1] >= 500 && counts[2] >= 580, "{counts:?}");
}

/// The systems of `heldout_systems.rs`, many of which have no limit or one that depends on the start. Where the error
/// dies out as 1/k or not at all, and more slowly than doubles can tell, a limit may be left open; none may be wrong.
#[test]
fn a_limit_is_found_where_there_is_one_and_only_there() {
    // Where the tolerance takes what is hardly seen for unseen, doubles hardly tell either.
    let (mut faults, mut open, mut right) = (Vec::new(), 0, 0);
    for (name, system, one) in all(include_str!("heldout/systems.json")) {
        let found = from_one(&name, &system);
        let limit = one["riccati"] == "limit";
        let said = dynamic::riccati_limit(&system, 1e-9).expect("an answer");
        // Its F turns by a modulus that is 10⁻¹⁷ off the circle: no double tells it from a rotation.
        if name == "float-rotation-0.6-0.8-unread" {
            continue;
        }
        if limit && !found.converged {
            let radius = one["closed_loop_radius"].as_f64().expect("a radius");
            open += 1;
            if radius < 1.0 - 1e-8 && said != RiccatiLimit::None {
                faults.push(format!("{name}: radius {radius}, {said:?}, {found:?}"));
            }
        } else if !limit && found.converged {
            faults.push(format!("{name}: has none, {said:?}, {found:?}"));
        } else if limit {
            let p = matrix(&one["limit_P"]);
            let off = (&found.p - &p).amax() / p.amax().max(1.0);
            let dies = 1.0 - one["closed_loop_radius"].as_f64().expect("a radius");
            right += 1;
            if off > (1e-15 / dies.abs()).clamp(1e-9, 1e-6) && said != RiccatiLimit::None {
                faults.push(format!("{name}: off {off:.1e}, {said:?}, {found:?}"));
            }
            if said == RiccatiLimit::FromEveryStart && found.depends_on_start {
                faults.push(format!("{name}: {said:?}, and yet {found:?}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}:\n{}", faults.len(), faults.join("\n"));
    assert!(right > 100 && open < 20, "{right} found, {open} left open");
}

/// A value beside a bias of which only their sum is read, in three shapes: each step adds less to a variance than
/// rounding leaves of it once it is large, and yet it has no end.
#[test]
fn a_growth_that_rounding_hides_is_no_limit() {
    let diagonal = |entries: &[f64]| DMatrix::from_diagonal(&nalgebra::DVector::from_row_slice(entries));
    let three = DMatrix::from_row_slice(3, 3, &[1.0, 0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    let [sum, sums, of_place] =
        [(1, 2, vec![1.0, 1.0]), (2, 3, vec![1.0, 1.0, 0.0, 0.0, 1.0, 1.0]), (1, 3, vec![1.0, 0.0, 1.0])]
            .map(|(rows, columns, entries)| DMatrix::from_row_slice(rows, columns, &entries));
    for (f, h, v) in [
        (diagonal(&[1.0; 2]), sum, diagonal(&[5e-4, 5e-6])),
        (diagonal(&[1.0; 3]), sums, diagonal(&[0.01, 0.02, 0.03])),
        (three, of_place, diagonal(&[0.0, 0.01, 1e-4])),
    ] {
        let (n, p) = (f.nrows(), h.nrows());
        let system = System::new(f, DMatrix::zeros(n, 0), h, v, DMatrix::identity(p, p) * 0.04).expect("sound");
        let found = from_one("a bias", &system);
        assert!(!found.converged && !found.depends_on_start && found.gain_converged, "{found:?}");
        // As single steps have it.
        let stepped = dynamic::steady_state_gain(&system, DMatrix::identity(n, n), 20_000, 0.0).expect("runs");
        assert!((&found.r - &stepped.r).amax() < 1e-9, "{found:?} {stepped:?}");
        let grows =
            |steps| dynamic::steady_state_gain(&system, DMatrix::identity(n, n), steps, 0.0).expect("runs").p.trace();
        assert!(grows(40_000) > grows(20_000) + 0.01, "{system:?}");
    }
}
