//! What all labs have in common.

use crate::declare::{Parameter, Params, Plain, Shape};
use estimate::{Code, Error};
use std::any::Any;

/// The last step a lab runs to. A replay from there takes several frames of the page, the Probe's many: the cap bounds how
/// long a call lasts, which nothing can interrupt.
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
    /// The lab's name in links and stored states.
    const NAME: &'static str;
    /// What a reader can change, with limits and defaults.
    type Params: Params;
    /// What a view draws.
    type Frame: Plain;

    /// The lab at step 0.
    ///
    /// # Errors
    /// [`Code::Limit`] or [`Code::NotFinite`], naming the parameter.
    fn new(params: Self::Params) -> Result<Self, Error>;

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

    /// A hash of what the run has recorded at every step, bit for bit: truth, readings, estimates, covariances, and their
    /// comparison.
    fn digest(&self) -> u64;

    /// `n` steps.
    ///
    /// # Errors
    /// [`Code::Limit`] when `n` is 0 or leads past [`MAX_STEP`], or whatever the core answers. The lab is then as it was.
    fn run(&mut self, n: u32) -> Result<(), Error> {
        if n == 0 || n > MAX_STEP.saturating_sub(self.steps()) {
            let message = format!("is {n}; it must be at least 1, and the run ends at step {MAX_STEP}");
            return Err(Error::new(Code::Limit, "n", message));
        }
        // The lab is copied, although it could be replayed: a replay can take a hundred thousand times as long as the refused step.
        let before = self.clone();
        (0..n).try_for_each(|_| self.advance()).inspect_err(|_| *self = before)
    }

    /// One step.
    ///
    /// # Errors
    /// As [`Lab::run`].
    fn step(&mut self) -> Result<(), Error> {
        self.run(1)
    }

    /// The same step of the run with other parameters.
    ///
    /// # Errors
    /// As [`Lab::new`] and [`Lab::run`]. The lab is then as it was.
    fn set(&mut self, params: Self::Params) -> Result<(), Error> {
        *self = Self::from_state(State { params, step: self.steps() })?;
        Ok(())
    }

    /// Parameters and step.
    fn state(&self) -> State<Self::Params> {
        State { params: self.params().clone(), step: self.steps() }
    }

    /// The lab in a given state.
    ///
    /// # Errors
    /// As [`Lab::new`]; [`Code::Limit`] naming `step`.
    fn from_state(state: State<Self::Params>) -> Result<Self, Error> {
        let mut lab = Self::new(state.params)?;
        if state.step > 0 {
            lab.run(state.step).map_err(|mut e| {
                if e.argument == "n" {
                    e.argument = "step".into();
                }
                e
            })?;
        }
        Ok(lab)
    }
}

/// What a [`Lab`] says that keeps `params`, `step` and `digest` in fields of these names: its own name, its types, and these three.
macro_rules! kept {
    ($name:literal, $params:ty, $frame:ty) => {
        const NAME: &'static str = $name;
        type Params = $params;
        type Frame = $frame;

        fn params(&self) -> &$params {
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
pub(crate) use kept;

/// What is known of a lab before there is one. With [`Experiment`] it lets one piece of code serve all labs, where a generic
/// one would be compiled for each.
#[derive(Debug)]
pub struct Kind {
    /// The lab's name in links and stored states.
    pub name: &'static str,
    /// Its parameters.
    pub parameters: &'static [Parameter],
    /// What the numbers of its parameters are.
    pub params: Shape,
    /// What the numbers of its frame are.
    pub frame: Shape,
    /// The last step that a run can reach.
    pub last_step: u32,
    /// The parameters it has where none are given.
    pub defaults: fn() -> Vec<f64>,
}

impl Kind {
    /// What is known of the lab `L`.
    pub const fn of<L: Lab + 'static>() -> Self {
        Self {
            name: L::NAME,
            parameters: L::Params::PARAMETERS,
            params: L::Params::SHAPE,
            frame: L::Frame::SHAPE,
            last_step: MAX_STEP,
            defaults: || L::Params::default().numbers(),
        }
    }
}

/// The lab `L` at a step, by the numbers of its parameters.
///
/// # Errors
/// As [`Lab::from_state`].
pub fn open<L: Lab + 'static>(params: &[f64], step: u32) -> Result<Box<dyn Experiment>, Error> {
    Ok(Box::new(L::from_state(State { params: L::Params::read(&mut params.iter()), step })?))
}

/// A [`Lab`] by its numbers alone: parameters and frame are rows of numbers, as [`Kind`] describes them.
pub trait Experiment {
    /// What is known of it.
    fn kind(&self) -> &'static Kind;

    /// [`Lab::set`].
    ///
    /// # Errors
    /// As there.
    fn set_params(&mut self, params: &[f64]) -> Result<(), Error>;

    /// [`Lab::run`].
    ///
    /// # Errors
    /// As there.
    fn run_on(&mut self, n: u32) -> Result<(), Error>;

    /// The present parameters and the step.
    fn state_numbers(&self) -> (Vec<f64>, u32);

    /// [`Lab::frame`].
    fn frame_numbers(&self) -> Vec<f64>;

    /// [`Lab::digest`].
    fn hash(&self) -> u64;

    /// The lab itself.
    fn as_any(&self) -> &dyn Any;
}

impl<L: Lab + 'static> Experiment for L {
    fn kind(&self) -> &'static Kind {
        const { &Kind::of::<L>() }
    }

    fn set_params(&mut self, params: &[f64]) -> Result<(), Error> {
        self.set(L::Params::read(&mut params.iter()))
    }

    fn run_on(&mut self, n: u32) -> Result<(), Error> {
        self.run(n)
    }

    fn state_numbers(&self) -> (Vec<f64>, u32) {
        (self.params().numbers(), self.steps())
    }

    fn frame_numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.frame().write(&mut numbers);
        numbers
    }

    fn hash(&self) -> u64 {
        self.digest()
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// A hash of the bits of the numbers a run computes, in their order: for each, a multiplication by an odd constant and a
/// fold of the high half into the low one. Both can be undone, so that two runs that differ in one number never agree at
/// it. It works on whole words, because a replay hashes thousands of numbers between two pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// 2⁶⁴ over the golden ratio.
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;

    /// Mixes the bits of every number into the hash.
    #[inline(never)]
    pub fn take(&mut self, numbers: &[f64]) {
        for number in numbers {
            let mixed = (self.0 ^ number.to_bits()).wrapping_mul(Self::FACTOR);
            self.0 = mixed ^ (mixed >> 32);
        }
    }

    /// The hash so far.
    pub fn value(self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests;
