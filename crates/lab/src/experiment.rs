//! A lab by its numbers alone.

use crate::lab::Lab;
use crate::parameter::{Parameter, Params};
use crate::shape::{Plain, Shape};
use estimate::Error;
use std::any::Any;

/// What is known of a lab before there is one. With [`Experiment`] it lets one piece of code serve all labs, where a
/// generic one would be compiled for each.
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
            last_step: L::LAST_STEP,
            defaults: || L::Params::default().numbers(),
        }
    }
}

/// The lab `L` at a step, by the numbers of its parameters.
///
/// # Errors
/// As [`Lab::at`].
pub fn open<L: Lab + 'static>(world: L::World, params: &[f64], step: u32) -> Result<Box<dyn Experiment>, Error> {
    Ok(Box::new(L::at(world, L::Params::read(&mut params.iter()), step)?))
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

    /// The lab itself, to change it.
    fn as_any_mut(&mut self) -> &mut dyn Any;
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

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }
}
