//! A run that is refused, and the hash of a run.

use super::*;
use crate::{Digest, params};
use std::cell::Cell;

params! {
    /// The parameters of a lab that gets stuck.
    pub struct StuckParams {
        /// The step that it cannot take.
        pub at: u32 = 7;
    }
}

/// Counts the step that it cannot take before it refuses it.
#[derive(Clone, Debug, PartialEq)]
struct Stuck {
    params: StuckParams,
    steps: u32,
    taken: Vec<u32>,
}

thread_local! {
    /// How many steps all labs of a test have computed.
    static COMPUTED: Cell<u32> = const { Cell::new(0) };
}

impl Lab for Stuck {
    named! { "stuck", StuckParams, u32, &[], "Gets stuck." }
    type World = ();

    fn world(&self) {}

    fn start((): (), params: StuckParams) -> Result<Self, Error> {
        Ok(Self { params, steps: 0, taken: vec![] })
    }

    fn params(&self) -> &StuckParams {
        &self.params
    }

    fn steps(&self) -> u32 {
        self.steps
    }

    fn advance(&mut self) -> Result<(), Error> {
        COMPUTED.set(COMPUTED.get() + 1);
        self.steps += 1;
        if self.steps == self.params.at {
            return Err(Error::new(Code::DidNotConverge, "lab", "is stuck"));
        }
        self.taken.push(self.steps);
        Ok(())
    }

    fn frame(&self) -> u32 {
        self.steps
    }

    fn digest(&self) -> u64 {
        0
    }
}

#[test]
fn a_run_that_is_refused_leaves_the_lab_as_it_was() {
    let mut lab = Stuck::new(StuckParams { at: 7 }).expect("any");
    assert_eq!(lab.run(9).expect_err("stuck at once").code, Code::DidNotConverge);
    assert_eq!(lab, Stuck::new(StuckParams { at: 7 }).expect("any"));
    lab.run(4).expect("not yet");
    assert_eq!(lab.run(3).expect_err("stuck on the way").code, Code::DidNotConverge);
    assert_eq!(lab, Stuck { params: StuckParams { at: 7 }, steps: 4, taken: vec![1, 2, 3, 4] });
    lab.run(2).expect("not yet");
    assert_eq!(lab.taken.len(), 6);
    assert_eq!(lab.set(StuckParams { at: 3 }).expect_err("stuck before").code, Code::DidNotConverge);
    assert_eq!((lab.params.at, lab.steps), (7, 6));
}

#[test]
fn a_run_that_is_refused_is_not_played_again() {
    let mut lab = Stuck::new(StuckParams { at: 60_001 }).expect("any");
    lab.run(60_000).expect("not yet");
    let before = COMPUTED.get();
    lab.run(1).expect_err("stuck");
    assert_eq!(COMPUTED.get() - before, 1);
}

#[test]
fn the_digest_depends_on_every_bit_and_on_the_order() {
    let of = |numbers: &[f64]| {
        let mut digest = Digest::default();
        digest.take(numbers);
        digest.value()
    };
    assert_eq!(of(&[]), Digest::default().value());
    assert_ne!(of(&[0.0]), of(&[-0.0]), "bits, not values");
    assert_ne!(of(&[1.0, 2.0]), of(&[2.0, 1.0]));
    let last_digits: std::collections::HashSet<u64> =
        (0..1000).map(|ulps| of(&[1.0, f64::from_bits(1.5_f64.to_bits() + ulps), 3.0])).collect();
    assert_eq!(last_digits.len(), 1000);
}
