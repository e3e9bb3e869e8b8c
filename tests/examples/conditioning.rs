//! Prints how far three filters are off on the systems of `hard_scales.rs`, beside answers of 200 digits: this core, a
//! Joseph form with the inverse of S as filterpy computes it, and the plain (I − KH) P.
//!
//! ```text
//! cargo run --release -p chapter-tests --example conditioning
//! ```

#[path = "../scales/exact.rs"]
mod exact;
#[path = "../scales/systems.rs"]
mod systems;

use estimate::dynamic::{Belief, KalmanFilter, System};
use exact::{Filter, Matrix};
use nalgebra::{DMatrix, DVector};
use systems::{Scales, Trial};

const TRIALS: u64 = 5000;
const RIGHT: f64 = 1e-6;

/// Errors of P relative to its largest entry, over the steps that a filter answered.
#[derive(Default)]
struct Errors {
    steps: usize,
    wrong: usize,
    /// Of the wrong ones, those that it has called wrong itself.
    said: usize,
    worst_unsaid: f64,
}

impl Errors {
    fn take(&mut self, error: f64, said: bool) {
        self.steps += 1;
        if error <= RIGHT {
            return;
        }
        self.wrong += 1;
        if said {
            self.said += 1;
        } else {
            self.worst_unsaid = self.worst_unsaid.max(error);
        }
    }
}

/// A step by the formulas as a textbook has them; nothing where S has no inverse.
fn textbook(system: &System, belief: &Belief, y: &DVector<f64>, joseph: bool) -> Option<Belief> {
    let System { f, h, v, w, .. } = system;
    let (x, p) = (f * &belief.x, f * &belief.p * f.transpose() + v);
    let s = h * &p * h.transpose() + w;
    let k = &p * h.transpose() * s.try_inverse()?;
    let left = DMatrix::identity(p.nrows(), p.nrows()) - &k * h;
    let x = &x + &k * (y - h * &x);
    let p = if joseph { &left * p * left.transpose() + &k * w * k.transpose() } else { left * p };
    p.iter().all(|e| e.is_finite()).then_some(Belief { x, p })
}

fn main() {
    println!(
        "| scales | filter | steps | P off by more than 10⁻⁶ | of these called so by the filter | worst of the others |"
    );
    println!("|---|---|---|---|---|---|");
    for scales in [Scales::HugePrior, Scales::NoMotionNoise, Scales::Ordinary] {
        let [mut ours, mut joseph, mut plain] = [Errors::default(), Errors::default(), Errors::default()];
        for number in 0..TRIALS {
            let Trial { system, belief, readings } = Trial::new(scales, number);
            let exact = exact::System::from(&system);
            let mut truth = Filter::new(&belief);
            let mut filter = KalmanFilter::new(&system, &belief).ok();
            let mut others = [Some(belief.clone()), Some(belief)];
            for y in &readings {
                if truth.step(&exact, &Matrix::from(y)).is_none() {
                    break;
                }
                let error = |p: &DMatrix<f64>| truth.p.error_of(&p.into());
                filter = filter.and_then(|mut filter| filter.step(&[], y.as_slice()).is_ok().then_some(filter));
                if let Some(filter) = &filter {
                    ours.take(error(&filter.belief().p), !filter.conditioned());
                }
                for (i, errors) in [&mut joseph, &mut plain].into_iter().enumerate() {
                    others[i] = others[i].take().and_then(|belief| textbook(&system, &belief, y, i == 0));
                    if let Some(belief) = &others[i] {
                        errors.take(error(&belief.p), false);
                    }
                }
            }
        }
        for (name, Errors { steps, wrong, said, worst_unsaid }) in
            [("this core", ours), ("Joseph, S inverted (filterpy)", joseph), ("(I − KH) P", plain)]
        {
            println!("| {scales:?} | {name} | {steps} | {wrong} | {said} | {worst_unsaid:.1e} |");
        }
    }
}
