//! The museum's stadium, with the same noise as there.

use super::{UNREAD, nis};
use crate::bug_museum::look;
use estimate::Unicycle;
use geom::SE2;
use nalgebra::{Matrix2, Vector2, Vector3};
use program::{Matrix, Program, Step, Stop};
use sim::scenarios::BUG_MUSEUM;
use sim::{Noise, Sighting};

/// The robot, and what the next step's noise is drawn from.
#[derive(Clone, Debug)]
pub(super) struct Stadium {
    noise: Noise,
    pub truth: SE2,
    k: u32,
    u: Vector2<f64>,
    pub seen: Option<Sighting>,
}

impl Stadium {
    /// The robot of a seed, and the belief before the first step.
    pub fn start(seed: u32) -> (Self, (Matrix, Matrix)) {
        let mut noise = Noise::new(u64::from(seed));
        let truth = BUG_MUSEUM.course.start();
        let off = Vector3::from_fn(|i, _| BUG_MUSEUM.p0_sigma[i] * noise.normal());
        let start = crate::true_path::squares(BUG_MUSEUM.p0_sigma);
        let x = Matrix::column(truth.boxplus(&off).to_vector().as_slice());
        let belief = (x, Matrix::new(3, 3, start.as_slice().to_vec()));
        (Self { noise, truth, k: 0, u: Vector2::zeros(), seen: None }, belief)
    }

    /// The robot drives on, and looks.
    pub fn moves(&mut self) {
        let tick = BUG_MUSEUM.course.tick(self.k);
        self.truth = tick.drive(self.truth);
        let [ahead, turn] = BUG_MUSEUM.u_sigma.map(|sigma| sigma * self.noise.normal());
        self.u = Vector2::new(tick.ds + ahead, tick.dtheta + turn);
        self.k += 1;
        self.seen = look(&mut self.noise, self.truth, self.k);
    }

    /// What the step gives a program, the noise as at an estimate.
    pub fn given(&self, x: &Matrix) -> Vec<Matrix> {
        given(x, &self.u, self.seen)
    }

    /// What a program makes of the step, and whether the gate lets the reading in; without ν and S there is no gate.
    pub fn read(&self, program: &mut Program, belief: &(Matrix, Matrix)) -> Result<(Step, bool), Stop> {
        let Some(seen) = self.seen else { return Ok((step(program, belief, &self.u, None)?, false)) };
        let with = step(program, belief, &self.u, Some(seen))?;
        if nis(program, &with).is_some_and(|nis| nis > BUG_MUSEUM.gate) {
            return Ok((step(program, belief, &self.u, None)?, false));
        }
        Ok((with, true))
    }
}

/// One step; without a reading, one of what is expected anyhow, with a variance that leaves nothing of it.
fn step(
    program: &mut Program,
    (x, p): &(Matrix, Matrix),
    u: &Vector2<f64>,
    seen: Option<Sighting>,
) -> Result<Step, Stop> {
    program.step([&[x.clone(), p.clone()], &given(x, u, seen)[..]].concat())
}

/// Input, reading, noise, landmark and gate as a program takes them, at an estimate.
fn given(x: &Matrix, u: &Vector2<f64>, seen: Option<Sighting>) -> Vec<Matrix> {
    let sensor = BUG_MUSEUM.sensor;
    let pose = SE2::from_vector(&Vector3::from_column_slice(&x.entries));
    let input = Matrix2::from_diagonal(&Vector2::from(BUG_MUSEUM.u_sigma.map(|sigma| sigma * sigma)));
    let v = Unicycle::process_covariance(&pose, &input);
    let scale = if seen.is_some() { 1.0 } else { UNREAD };
    let [range, bearing] = [sensor.range_sigma, sensor.bearing_sigma].map(|sigma| scale * sigma * sigma);
    let landmark = BUG_MUSEUM.landmarks[seen.map_or(0, |seen| seen.landmark as usize)];
    let y = seen.map_or([0.0, 0.0], |seen| [seen.range, seen.bearing]);
    vec![
        Matrix::column(u.as_slice()),
        Matrix::column(&y),
        Matrix::new(3, 3, v.transpose().as_slice().to_vec()),
        Matrix::new(2, 2, vec![range, 0.0, 0.0, bearing]),
        Matrix::column(&[landmark.x, landmark.y]),
        Matrix::column(&[BUG_MUSEUM.gate]),
    ]
}
