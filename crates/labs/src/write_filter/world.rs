//! The first steps of a world, for programs of other languages to be tested on.

use super::WriteFilter;
use crate::worlds::Run;
use estimate::Error;
use lab::record;
use program::{Matrix, World};

/// So many steps are a test.
const STEPS: usize = 10;

record! {
    /// The first steps of the world that a program filters.
    pub struct WriteWorld {
        /// What does not change.
        pub system: WriteSystem,
        /// The belief before the first step.
        pub belief: WriteBelief,
        /// What each step gives.
        pub steps: Vec<WriteStep>,
    }

    /// What does not change in a world; F, G and H are a linear one's, the gate a robot's.
    pub struct WriteSystem {
        /// The covariance of the motion's noise.
        #[name = "V"]
        pub v: Vec<Vec<f64>>,
        /// The covariance of the reading's noise, in the first step.
        #[name = "W"]
        pub w: Vec<Vec<f64>>,
        /// The motion.
        #[name = "F"]
        pub f: Option<Vec<Vec<f64>>>,
        /// What the input does.
        #[name = "G"]
        pub g: Option<Vec<Vec<f64>>>,
        /// What the reading tells.
        #[name = "H"]
        pub h: Option<Vec<Vec<f64>>>,
        /// χ² beyond which a sighting is refused.
        pub gate: Option<f64>,
    }

    /// An estimate with its covariance.
    pub struct WriteBelief {
        /// The estimate.
        pub x: Vec<f64>,
        /// Its covariance.
        #[name = "P"]
        pub p: Vec<Vec<f64>>,
    }

    /// What a step gives; the landmark and its W are a robot's.
    pub struct WriteStep {
        /// The input.
        pub u: Vec<f64>,
        /// The reading.
        pub y: Vec<f64>,
        /// Where the landmark stands.
        pub landmark: Option<Vec<f64>>,
        /// The covariance of this reading's noise.
        #[name = "W"]
        pub w: Option<Vec<Vec<f64>>>,
    }
}

fn rows(m: &Matrix) -> Vec<Vec<f64>> {
    m.entries.chunks(m.columns).map(<[f64]>::to_vec).collect()
}

/// The world of a lab's seed.
///
/// # Errors
/// None, on the chapter's constants.
pub(super) fn of(lab: &WriteFilter) -> Result<WriteWorld, Error> {
    let world = lab.program.world();
    let mut run = Run::start(world, lab.params.seed)?;
    let belief = WriteBelief { x: run.belief.0.entries.clone(), p: rows(&run.belief.1) };
    let steps: Vec<_> = (0..STEPS).map(|_| run.given()).collect();
    let first = &steps[0];
    let linear = world == World::Linear;
    let part = |i: usize| linear.then(|| rows(&first[i]));
    let gate = (!linear).then(|| first[5].at(0, 0));
    let system = WriteSystem { v: rows(&first[2]), w: rows(&first[3]), f: part(4), g: part(5), h: part(6), gate };
    let step = |given: &Vec<Matrix>| WriteStep {
        u: given[0].entries.clone(),
        y: given[1].entries.clone(),
        landmark: (!linear).then(|| given[4].entries.clone()),
        w: (!linear).then(|| rows(&given[3])),
    };
    Ok(WriteWorld { system, belief, steps: steps.iter().map(step).collect() })
}
