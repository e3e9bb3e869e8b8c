//! The rail robot with its position sensor, pushed to and fro.

use crate::shapes::root;
use estimate::rail::position_sensor;
use estimate::{Error, Lti};
use nalgebra::{Matrix2, U1, U2, Vector1, Vector2};
use program::{Matrix, Program, Step, Stop};
use sim::Noise;

fn matrix<const R: usize, const C: usize>(m: &nalgebra::SMatrix<f64, R, C>) -> Matrix {
    Matrix::new(R, C, m.transpose().as_slice().to_vec())
}

/// The robot, and what the next step's noise is drawn from.
#[derive(Clone, Debug)]
pub(super) struct Rail {
    system: Lti<U2, U1, U1>,
    root_v: Matrix2<f64>,
    noise: Noise,
    pub truth: Vector2<f64>,
    k: u32,
    /// What the last step gives a program.
    pub given: Vec<Matrix>,
}

impl Rail {
    /// The robot of a seed, and the belief before the first step.
    pub fn start(seed: u32) -> Result<(Self, (Matrix, Matrix)), Error> {
        let (system, belief) = position_sensor();
        let mut noise = Noise::new(u64::from(seed));
        let (root_p, root_v) = (root(&belief.p, "P")?, root(&system.v, "V")?);
        let truth = belief.x + noise.correlated(&root_p);
        let belief = (Matrix::column(belief.x.as_slice()), matrix(&belief.p));
        Ok((Self { system, root_v, noise, truth, k: 0, given: Vec::new() }, belief))
    }

    /// The robot moves, and its sensor reads.
    pub fn moves(&mut self) {
        let system = &self.system;
        let u = Vector1::new(if (self.k / 10).is_multiple_of(2) { 1.0 } else { -1.0 });
        self.k += 1;
        self.truth = system.f * self.truth + system.g * u + self.noise.correlated(&self.root_v);
        let y = (system.h * self.truth)[0] + system.w[0].sqrt() * self.noise.normal();
        self.given = given(system, u[0], y);
    }

    /// What a program makes of the step.
    pub fn read(&self, program: &mut Program, (x, p): &(Matrix, Matrix)) -> Result<Step, Stop> {
        program.step([&[x.clone(), p.clone()], &self.given[..]].concat())
    }
}

/// Input, reading and system as a program takes them.
pub(crate) fn given(system: &Lti<U2, U1, U1>, u: f64, y: f64) -> Vec<Matrix> {
    vec![
        Matrix::column(&[u]),
        Matrix::column(&[y]),
        matrix(&system.v),
        matrix(&system.w),
        matrix(&system.f),
        matrix(&system.g),
        matrix(&system.h),
    ]
}
