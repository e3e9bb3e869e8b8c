//! The robot's drive on its rail, and what its sensors read at each tick, whether or not they are asked.

use super::Course;
use crate::shapes::root;
use core::f64::consts::TAU;
use estimate::Error;
use estimate::dynamic::Continuous;
use nalgebra::{Matrix2, Vector2, dmatrix};
use sim::Noise;
use sim::scenarios::THREE_SENSORS;
use std::sync::LazyLock;

/// x(k+1) = F x(k) + G u + v over one tick, with the acceleration as input.
pub(super) struct Model {
    pub f: Matrix2<f64>,
    pub g: Vector2<f64>,
    pub v: Matrix2<f64>,
}

/// Position and speed, with a disturbed acceleration.
///
/// # Errors
/// None on the chapter's constants.
pub(super) fn continuous() -> Result<Continuous, Error> {
    let q = THREE_SENSORS.q;
    Continuous::new(dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![0.0; 1.0], dmatrix![0.0, 0.0; 0.0, q])
}

/// The model of a tick, which never changes.
static MODEL: LazyLock<Result<Model, Error>> = LazyLock::new(|| {
    let tick = continuous()?.discretize(THREE_SENSORS.tick)?;
    let (f, g, v) = (tick.f.as_slice(), tick.g.as_slice(), tick.v.as_slice());
    Ok(Model { f: Matrix2::from_column_slice(f), g: Vector2::from_column_slice(g), v: Matrix2::from_column_slice(v) })
});

/// # Errors
/// None on the chapter's constants.
pub(super) fn model() -> Result<&'static Model, Error> {
    MODEL.as_ref().map_err(Clone::clone)
}

/// A drive.
#[derive(Debug)]
pub(super) struct Drive {
    pub seed: u32,
    pub course: Course,
    /// The true state at each tick, from 0 on.
    pub states: Vec<Vector2<f64>>,
    /// The input held from each tick to the next.
    pub inputs: Vec<f64>,
    /// What each sensor would read at each tick.
    pub readings: Vec<[f64; 3]>,
}

impl Drive {
    /// # Errors
    /// None on the chapter's constants.
    pub fn new(seed: u32, course: Course) -> Result<Self, Error> {
        let Model { f, g, v } = model()?;
        let constants = THREE_SENSORS;
        let (mut noise, kick) = (Noise::new(u64::from(seed)), root(v, "V")?);
        let inputs: Vec<f64> = (0..constants.ticks).map(|k| command(course, k)).collect();
        let mut state = start() + Vector2::from(constants.p0_sigma.map(|sigma| sigma * noise.normal()));
        let read = |state: &Vector2<f64>, noise: &mut Noise| constants.sigma.map(|s| state[0] + s * noise.normal());
        let mut readings = vec![read(&state, &mut noise)];
        let mut states = vec![state];
        for u in &inputs {
            state = f * state + g * *u + noise.correlated(&kick);
            states.push(state);
            readings.push(read(&state, &mut noise));
        }
        Ok(Self { seed, course, states, inputs, readings })
    }
}

/// Where the robot is believed to be at first.
pub(super) fn start() -> Vector2<f64> {
    Vector2::new(0.0, THREE_SENSORS.speed)
}

/// The acceleration that is held from a tick to the next.
fn command(course: Course, tick: usize) -> f64 {
    let constants = THREE_SENSORS;
    match course {
        Course::Steady => 0.0,
        Course::ToAndFro => {
            let speed = |k: usize| constants.speed * libm::cos(TAU * k as f64 * constants.tick / constants.round);
            (speed(tick + 1) - speed(tick)) / constants.tick
        }
    }
}
