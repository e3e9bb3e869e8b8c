//! One world, step by step: its truth, and what a program believes.

use super::linear::Rail;
use super::stadium::Stadium;
use super::{nis, squared};
use estimate::Error;
use geom::SE2;
use nalgebra::Vector3;
use program::{Matrix, Program, Quantity, Step, Stop, World};
use sim::Sighting;

#[derive(Clone, Debug)]
enum Robot {
    Rail(Rail),
    Stadium(Stadium),
}

/// A world, and a program's belief in it.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    robot: Robot,
    /// x and P.
    pub belief: (Matrix, Matrix),
    /// νᵀS⁻¹ν of the last reading, where it was used and the program names both.
    pub nis: Option<f64>,
    /// Whether the gate let the last reading in.
    pub used: bool,
}

impl Run {
    /// A world before its first step.
    ///
    /// # Errors
    /// None, on the chapter's constants.
    pub fn start(world: World, seed: u32) -> Result<Self, Error> {
        let (robot, belief) = match world {
            World::Linear => {
                let (rail, belief) = Rail::start(seed)?;
                (Robot::Rail(rail), belief)
            }
            World::Robot => {
                let (stadium, belief) = Stadium::start(seed);
                (Robot::Stadium(stadium), belief)
            }
        };
        Ok(Self { robot, belief, nis: None, used: false })
    }

    /// A step of the world, then the program's.
    ///
    /// # Errors
    /// [`Stop`]; the belief then is as it was.
    pub fn next(&mut self, program: &mut Program) -> Result<(), Stop> {
        self.moves();
        let (step, used) = self.read(program)?;
        let made = |quantity| program.made(&step, quantity).cloned().ok_or(Stop::Given);
        let belief = (made(Quantity::X)?, made(Quantity::P)?);
        self.nis = if used { nis(program, &step) } else { None };
        (self.used, self.belief) = (used, belief);
        Ok(())
    }

    fn moves(&mut self) {
        match &mut self.robot {
            Robot::Rail(rail) => rail.moves(),
            Robot::Stadium(stadium) => stadium.moves(),
        }
    }

    /// A step of the world, and what it gives a program: input, reading, V, W, then F, G and H or landmark and gate.
    /// The motion's noise is as at the first estimate.
    pub fn given(&mut self) -> Vec<Matrix> {
        self.moves();
        match &self.robot {
            Robot::Rail(rail) => rail.given.clone(),
            Robot::Stadium(stadium) => stadium.given(&self.belief.0),
        }
    }

    fn read(&self, program: &mut Program) -> Result<(Step, bool), Stop> {
        match &self.robot {
            Robot::Rail(rail) => Ok((rail.read(program, &self.belief)?, true)),
            Robot::Stadium(stadium) => stadium.read(program, &self.belief),
        }
    }

    /// The true state.
    pub fn truth(&self) -> Vec<f64> {
        match &self.robot {
            Robot::Rail(rail) => rail.truth.as_slice().to_vec(),
            Robot::Stadium(stadium) => stadium.truth.to_vector().as_slice().to_vec(),
        }
    }

    /// Truth less estimate, a heading the short way round.
    pub fn error(&self) -> Vec<f64> {
        let x = &self.belief.0.entries;
        match &self.robot {
            Robot::Rail(rail) => rail.truth.iter().zip(x).map(|(truth, x)| truth - x).collect(),
            Robot::Stadium(stadium) => {
                let estimate = SE2::from_vector(&Vector3::from_column_slice(x));
                stadium.truth.boxminus(estimate).as_slice().to_vec()
            }
        }
    }

    /// eᵀP⁻¹e; none where P is no covariance.
    pub fn nees(&self) -> Option<f64> {
        squared(&Matrix::column(&self.error()), &self.belief.1)
    }

    /// The landmark that was sighted in the last step.
    pub fn seen(&self) -> Option<Sighting> {
        match &self.robot {
            Robot::Rail(_) => None,
            Robot::Stadium(stadium) => stadium.seen,
        }
    }
}
