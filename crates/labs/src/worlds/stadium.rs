//! The museum's stadium, with the same noise as there.

use super::{Shown, UNREAD, nis, squared};
use crate::bug_museum::look;
use estimate::Unicycle;
use geom::SE2;
use nalgebra::{Matrix2, Vector2, Vector3};
use program::{Matrix, Program, Quantity, Step, Stop};
use sim::scenarios::BUG_MUSEUM;
use sim::{Noise, Sighting};

/// One world.
pub(super) fn run(program: &mut Program, seed: u32) -> Result<Shown, Stop> {
    let mut noise = Noise::new(u64::from(seed));
    let mut truth = BUG_MUSEUM.course.start();
    let off = Vector3::from_fn(|i, _| BUG_MUSEUM.p0_sigma[i] * noise.normal());
    let start = crate::true_path::squares(BUG_MUSEUM.p0_sigma);
    let mut belief =
        (Matrix::column(truth.boxplus(&off).to_vector().as_slice()), Matrix::new(3, 3, start.as_slice().to_vec()));
    let mut shown = Shown::default();
    for k in 0..BUG_MUSEUM.steps {
        let tick = BUG_MUSEUM.course.tick(k);
        truth = tick.drive(truth);
        let [ahead, turn] = BUG_MUSEUM.u_sigma.map(|sigma| sigma * noise.normal());
        let u = Vector2::new(tick.ds + ahead, tick.dtheta + turn);
        let step = match look(&mut noise, truth, k + 1) {
            None => step(program, &belief, &u, None)?,
            Some(seen) => {
                let with = step(program, &belief, &u, Some(seen))?;
                let nis = nis(program, &with);
                // Without ν and S there is no gate.
                if nis.is_some_and(|nis| nis > BUG_MUSEUM.gate) {
                    step(program, &belief, &u, None)?
                } else {
                    if let Some(nis) = nis {
                        shown.nis = (shown.nis.0 + nis, shown.nis.1 + 1);
                    }
                    with
                }
            }
        };
        let made = |quantity| program.made(&step, quantity).cloned().ok_or(Stop::Given);
        belief = (made(Quantity::X)?, made(Quantity::P)?);
        let error = truth.boxminus(SE2::from_vector(&Vector3::from_column_slice(&belief.0.entries)));
        if let Some(nees) = squared(&Matrix::column(error.as_slice()), &belief.1) {
            shown.nees = (shown.nees.0 + nees, shown.nees.1 + 1);
        }
    }
    Ok(shown)
}

/// One step; without a reading, one of what is expected anyhow, with a variance that leaves nothing of it.
fn step(
    program: &mut Program,
    (x, p): &(Matrix, Matrix),
    u: &Vector2<f64>,
    seen: Option<Sighting>,
) -> Result<Step, Stop> {
    let sensor = BUG_MUSEUM.sensor;
    let pose = SE2::from_vector(&Vector3::from_column_slice(&x.entries));
    let input = Matrix2::from_diagonal(&Vector2::from(BUG_MUSEUM.u_sigma.map(|sigma| sigma * sigma)));
    let v = Unicycle::process_covariance(&pose, &input);
    let scale = if seen.is_some() { 1.0 } else { UNREAD };
    let [range, bearing] = [sensor.range_sigma, sensor.bearing_sigma].map(|sigma| scale * sigma * sigma);
    let landmark = BUG_MUSEUM.landmarks[seen.map_or(0, |seen| seen.landmark as usize)];
    let y = seen.map_or([0.0, 0.0], |seen| [seen.range, seen.bearing]);
    program.step(vec![
        x.clone(),
        p.clone(),
        Matrix::column(u.as_slice()),
        Matrix::column(&y),
        Matrix::new(3, 3, v.transpose().as_slice().to_vec()),
        Matrix::new(2, 2, vec![range, 0.0, 0.0, bearing]),
        Matrix::column(&[landmark.x, landmark.y]),
        Matrix::column(&[BUG_MUSEUM.gate]),
    ])
}
