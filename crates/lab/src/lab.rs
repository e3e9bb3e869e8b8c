//! What all labs have in common.

use crate::interface::{About, Interface};
use crate::parameter::Params;
use crate::shape::Plain;
use estimate::{Code, Error};

/// The last step a lab runs to. A replay from there takes several frames of the page, the Probe's many: the cap bounds
/// how long a call lasts, which nothing can interrupt.
pub const MAX_STEP: u32 = 100_000;

/// What restores a lab: its parameters and its step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<P> {
    /// The parameters, the seed among them.
    pub params: P,
    /// Steps taken since the start.
    pub step: u32,
}

/// An experiment that is a function of its parameters and its step alone.
///
/// Changing a parameter re-plays the run from its start: what a reader sees is the whole run as it would have been.
pub trait Lab: Clone {
    /// The lab's name in links, stored states and addresses.
    const NAME: &'static str;
    /// What it is, in a sentence.
    const ABOUT: &'static str;
    /// The interfaces of its frame, for TypeScript.
    const INTERFACES: &'static [&'static [About]];
    /// The last step that a run can reach.
    const LAST_STEP: u32 = MAX_STEP;
    /// What it stands on that is none of its parameters: nothing, `()`, or something from outside, as the log of a
    /// robot.
    type World: Clone;
    /// What a reader can change, with limits and defaults.
    type Params: Params + Interface;
    /// What a view draws.
    type Frame: Plain;

    /// The lab at step 0.
    ///
    /// # Errors
    /// [`Code::Limit`] or [`Code::NotFinite`], naming the parameter.
    fn start(world: Self::World, params: Self::Params) -> Result<Self, Error>;

    /// Parameters under which its digest is compared on every machine: as it opens, then as a reader may set it.
    fn tried() -> Vec<Self::Params> {
        vec![Self::Params::default()]
    }

    /// What it stands on.
    fn world(&self) -> Self::World;

    /// The present parameters.
    fn params(&self) -> &Self::Params;

    /// Steps taken so far.
    fn steps(&self) -> u32;

    /// One step, without regard to [`MAX_STEP`]; callers use [`Lab::run`].
    ///
    /// # Errors
    /// Whatever the core answers; the lab may be left between two steps, and [`Lab::run`] puts it back then.
    fn advance(&mut self) -> Result<(), Error>;

    /// The present frame.
    fn frame(&self) -> Self::Frame;

    /// A hash of what the run has recorded at every step, bit for bit: truth, readings, estimates, covariances, and
    /// their comparison.
    fn digest(&self) -> u64;

    /// `n` steps.
    ///
    /// # Errors
    /// [`Code::Limit`] when `n` is 0 or leads past [`Lab::LAST_STEP`], or whatever the core answers. The lab is then as
    /// it was.
    fn run(&mut self, n: u32) -> Result<(), Error> {
        let last = Self::LAST_STEP;
        if n == 0 || n > last.saturating_sub(self.steps()) {
            let message = format!("is {n}; it must be at least 1, and the run ends at step {last}");
            return Err(Error::new(Code::Limit, "n", message));
        }
        // The lab is copied, although it could be replayed: a replay can take a hundred thousand times as long as the
        // refused step.
        let before = self.clone();
        (0..n).try_for_each(|_| self.advance()).inspect_err(|_| *self = before)
    }

    /// The lab at a step.
    ///
    /// # Errors
    /// As [`Lab::start`]; [`Code::Limit`] naming `step`.
    fn at(world: Self::World, params: Self::Params, step: u32) -> Result<Self, Error> {
        let mut lab = Self::start(world, params)?;
        if step > 0 {
            lab.run(step).map_err(|mut e| {
                if e.argument == "n" {
                    e.argument = "step".into();
                }
                e
            })?;
        }
        Ok(lab)
    }

    /// The same step of the run with other parameters.
    ///
    /// # Errors
    /// As [`Lab::at`]. The lab is then as it was.
    fn set(&mut self, params: Self::Params) -> Result<(), Error> {
        *self = Self::at(self.world(), params, self.steps())?;
        Ok(())
    }

    /// One step.
    ///
    /// # Errors
    /// As [`Lab::run`].
    fn step(&mut self) -> Result<(), Error> {
        self.run(1)
    }

    /// Parameters and step.
    fn state(&self) -> State<Self::Params> {
        State { params: self.params().clone(), step: self.steps() }
    }

    /// A lab that stands on its parameters alone, at step 0.
    ///
    /// # Errors
    /// As [`Lab::start`].
    fn new(params: Self::Params) -> Result<Self, Error>
    where
        Self: Lab<World = ()>,
    {
        Self::start((), params)
    }

    /// A lab that stands on its parameters alone, in a given state.
    ///
    /// # Errors
    /// As [`Lab::at`].
    fn from_state(state: State<Self::Params>) -> Result<Self, Error>
    where
        Self: Lab<World = ()>,
    {
        Self::at((), state.params, state.step)
    }
}

/// What a [`Lab`] is called, what it is, and its types:
/// `named! { "name", Params, Frame, the interfaces of the frame, "What it is." }`.
#[macro_export]
macro_rules! named {
    ($name:literal, $params:ty, $frame:ty, $interfaces:expr, $about:literal) => {
        const NAME: &'static str = $name;
        const ABOUT: &'static str = $about;
        const INTERFACES: &'static [&'static [$crate::About]] = $interfaces;
        type Params = $params;
        type Frame = $frame;
    };
}

/// What a [`Lab`] says that keeps `params`, `step` and `digest` in fields of these names, and stands on its parameters
/// alone.
#[macro_export]
macro_rules! kept {
    () => {
        type World = ();

        fn world(&self) {}

        fn params(&self) -> &Self::Params {
            &self.params
        }

        fn steps(&self) -> u32 {
            self.step
        }

        fn digest(&self) -> u64 {
            self.digest.value()
        }
    };
}

#[cfg(test)]
mod tests;
