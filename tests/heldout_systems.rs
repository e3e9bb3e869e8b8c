//! The core's verdicts on systems that were made to be hard, against verdicts that exact arithmetic gave.
//! `heldout/make.py` wrote the systems without any code of this workspace: every verdict by rational numbers, each
//! checked a second way with 60 digits and more. `heldout/README.md` says what each field means.

#![cfg(not(target_arch = "wasm32"))]

use estimate::dynamic::{self, System};
use estimate::{RiccatiLimit, Verdict};
use nalgebra::{DMatrix, DVector};
use serde_json::Value;

/// How well the numbers are said to be known: the default of the page for a system of the reader's own.
const TOLERANCE: f64 = 1e-9;
/// A verdict may be left open where another one is this near. Between the tolerance and this lie the constants of the
/// measures: a tolerance says how much each number may be off, a margin how far a singular value is from zero.
const NEAR: f64 = 1e-8;

struct Given {
    all: Value,
    name: String,
    system: System,
}

impl Given {
    fn truth(&self, field: &str) -> bool {
        self.all[field].as_bool().unwrap_or_else(|| panic!("{}: {field}", self.name))
    }

    fn count(&self, field: &str) -> usize {
        self.all[field].as_u64().unwrap_or_else(|| panic!("{}: {field}", self.name)) as usize
    }

    /// How far another verdict is: as the numbers stand, or in the units in which it is farthest. 0 where the verdict
    /// hangs on |λ| = 1.
    fn margin(&self, field: &str) -> f64 {
        let of = |kind: &str| self.all[kind][field].as_f64().unwrap_or_else(|| panic!("{}: {kind} {field}", self.name));
        of("margin").max(of("margin_scaled"))
    }

    /// Whether something holds, but would not of a system within the tolerance. Then it does not count as holding: an
    /// eigenvalue of modulus 1 − tolerance does not count as decaying, nor are 0.1, 0.2 and 0.3, 0.6 independent
    /// because decimals are rounded.
    fn hardly(&self, what: &str) -> bool {
        self.truth(what) && self.margin(what) < TOLERANCE
    }

    /// Says so where a verdict is not the true one, and may not be left open either.
    fn judge(&self, what: &str, found: Verdict, faults: &mut Vec<String>, open: &mut Vec<String>) {
        let (truth, margin) = (self.truth(what), self.margin(what));
        let right = match found {
            Verdict::Yes => truth,
            Verdict::No => !truth || self.hardly(what),
            Verdict::Undecided => margin < NEAR,
        };
        if !right {
            faults.push(format!("{}: {what} is {truth}, found {found:?}; margin {margin:e}", self.name));
        }
        if found == Verdict::Undecided {
            open.push(format!("{} {what} {margin:e}", self.name));
        }
    }
}

fn matrix(rows: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = serde_json::from_value(rows.clone()).expect("rows of numbers");
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

fn systems() -> Vec<Given> {
    let all: Vec<Value> = serde_json::from_str(include_str!("heldout/systems.json")).expect("JSON");
    let given = |one: Value| {
        let [f, g, h, v, w] = ["F", "G", "H", "V", "W"].map(|name| matrix(&one[name]));
        let name = one["name"].as_str().expect("a name").to_owned();
        let system = System::new(f, g, h, v, w).unwrap_or_else(|error| panic!("{name}: {error}"));
        Given { all: one, name, system }
    };
    all.into_iter().map(given).collect()
}

/// No verdict is wrong, and none is left open: the tolerance would allow some, but the core decides them all.
fn report(faults: &[String], open: &[String]) {
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
    assert!(open.is_empty(), "left open: {open:#?}");
}

#[test]
fn observability_and_detectability_are_as_exact_arithmetic_says() {
    let (mut faults, mut open) = (Vec::new(), Vec::new());
    for given in systems() {
        let System { f, h, .. } = &given.system;
        let found = dynamic::detectability(f.clone(), h.clone(), TOLERANCE).expect("an answer");
        for (what, verdict) in [("observable", found.observable), ("detectable", found.detectable)] {
            given.judge(what, verdict, &mut faults, &mut open);
        }
        let rank = dynamic::observability(f.clone(), h.clone(), TOLERANCE).expect("an answer").rank;
        let raw = given.all["margin"]["observable"].as_f64().expect("a number");
        if raw > NEAR && rank != given.count("observability_rank") {
            faults.push(format!("{}: rank {rank}", given.name));
        }
        if found.observable == Verdict::No && !given.hardly("observable") {
            let basis: Vec<Vec<f64>> =
                serde_json::from_value(given.all["unobservable_basis"].clone()).expect("vectors");
            if basis.len() != found.unseen.len() {
                faults.push(format!("{}: {} unseen directions", given.name, found.unseen.len()));
                continue;
            }
            for direction in basis.into_iter().map(DVector::from_vec) {
                let rest = found.unseen.iter().fold(direction.clone(), |rest, one| &rest - one * one.dot(&rest));
                if rest.norm() > 1e-7 * direction.norm() {
                    faults.push(format!("{}: {direction} is unseen, {:?} found", given.name, found.unseen));
                }
            }
        }
    }
    report(&faults, &open);
}

#[test]
fn what_noise_and_inputs_reach_is_as_exact_arithmetic_says() {
    let (mut faults, mut open) = (Vec::new(), Vec::new());
    for given in systems() {
        let System { f, g, v, .. } = &given.system;
        let input = dynamic::stabilizability(f.clone(), g.clone(), TOLERANCE).expect("an answer");
        let noise = dynamic::noise_reach(f.clone(), v.clone(), TOLERANCE).expect("an answer");
        for (what, found) in [("controllable", input.reachable), ("stabilizable", noise.stabilizable)] {
            given.judge(what, found, &mut faults, &mut open);
        }
        // There is no margin of its own for what noise reaches in all.
        let whole = given.count("noise_rank") == given.count("n");
        if noise.reachable != Verdict::Undecided && noise.reachable != Verdict::from(whole) {
            faults.push(format!("{}: noise rank {}, {:?}", given.name, given.count("noise_rank"), noise.reachable));
        }
    }
    report(&faults, &open);
}

#[test]
fn the_riccati_recursion_does_what_exact_arithmetic_says() {
    let (mut faults, mut open, mut compared, mut hardly) = (Vec::new(), Vec::new(), 0, 0);
    for given in systems() {
        if given.hardly("detectable") || given.hardly("stabilizable") {
            hardly += 1;
            continue;
        }
        let limit = dynamic::riccati_limit(&given.system, TOLERANCE).expect("an answer");
        let truth = given.all["riccati"].as_str().expect("a word");
        let (detectable, stabilizable) = (given.truth("detectable"), given.truth("stabilizable"));
        let agrees = match limit {
            RiccatiLimit::FromEveryStart => {
                detectable && stabilizable && truth == "limit" && given.truth("stabilizing")
            }
            // A growing mode that noise does not reach leaves the limit stabilizing.
            RiccatiLimit::FromLargeStart => detectable && truth == "limit",
            RiccatiLimit::None => !detectable && stabilizable && truth == "diverges",
            RiccatiLimit::DependsOnStart => !detectable && !stabilizable,
            RiccatiLimit::Undecided => given.margin("detectable").min(given.margin("stabilizable")) < NEAR,
        };
        if !agrees {
            faults.push(format!(
                "{}: {limit:?}, but {truth}, detectable {detectable}, stabilizable {stabilizable}",
                given.name
            ));
        }
        if limit == RiccatiLimit::Undecided {
            open.push(given.name.clone());
        }
        // Where the error dies out fast enough, the recursion of the core has the limit too.
        if given.all["closed_loop_radius"].as_f64().is_some_and(|radius| radius < 0.98) {
            let n = given.count("n");
            let found =
                dynamic::steady_state_gain(&given.system, DMatrix::identity(n, n), 5000, 1e-10).expect("a limit");
            let expected = matrix(&given.all["limit_P"]);
            let units = DVector::from_fn(n, |i, _| expected[(i, i)].sqrt());
            let off = (0..n * n).map(|at| (at / n, at % n)).map(|(i, j)| {
                let (unit, off) = (units[i] * units[j], (found.p[(i, j)] - expected[(i, j)]).abs());
                if unit > 0.0 { off / unit } else { off }
            });
            let most = off.fold(0.0, f64::max);
            compared += 1;
            if !(found.converged && most < 1e-6) {
                faults.push(format!(
                    "{}: {} is off by {most:e} from {expected}, {}",
                    given.name, found.p, found.converged
                ));
            }
        }
    }
    assert!(compared > 50 && hardly < 10, "{compared} {hardly}");
    report(&faults, &open);
}

/// P(k+1 | k) after 5000 steps from P = I lies where 60 digits say it does, and is symmetric: also where the limit is
/// approached like 1/k, and where F grows, so that a difference of P and its transpose would grow too.
#[test]
fn five_thousand_steps_of_the_riccati_recursion_keep_their_digits() {
    let (mut faults, mut compared) = (Vec::new(), 0);
    for given in systems().iter().filter(|given| given.all["riccati"] == "limit") {
        if given.hardly("detectable") || given.hardly("stabilizable") || !given.truth("detectable") {
            continue;
        }
        let n = given.count("n");
        let found = dynamic::steady_state_gain(&given.system, DMatrix::identity(n, n), 5000, 0.0).expect("finite").p;
        let limit = matrix(&given.all["limit_P"]);
        let size = limit.amax().max(1.0);
        let off = (&found - &limit).amax() / size;
        compared += 1;
        let expected = given.all["off_limit_after_5000"].as_f64().expect("a number");
        let skew = (&found - found.transpose()).amax() / size;
        if (off - expected).abs() > 0.01 * expected + 1e-6 || skew > 1e-12 {
            faults.push(format!("{}: off by {off:e}, {expected:e} expected; P - P' {skew:e}", given.name));
        }
    }
    assert!(compared > 90, "{compared}");
    report(&faults, &[]);
}
