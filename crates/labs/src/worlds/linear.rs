//! The rail robot with its position sensor, pushed to and fro.

use super::{STEPS, Shown, nis, squared};
use crate::shapes::root;
use estimate::rail::position_sensor;
use nalgebra::Vector1;
use program::{Matrix, Program, Quantity, Stop};
use sim::Noise;

fn matrix<const R: usize, const C: usize>(m: &nalgebra::SMatrix<f64, R, C>) -> Matrix {
    Matrix::new(R, C, m.transpose().as_slice().to_vec())
}

/// One world.
pub(super) fn run(program: &mut Program, seed: u32) -> Result<Shown, Stop> {
    let (system, belief) = position_sensor();
    let mut noise = Noise::new(u64::from(seed));
    let roots = [root(&belief.p, "P"), root(&system.v, "V")].map(|root| root.map_err(|_| Stop::Given));
    let [root_p, root_v] = roots;
    let root_v = root_v?;
    let mut truth = belief.x + noise.correlated(&root_p?);
    let (mut x, mut p) = (Matrix::column(belief.x.as_slice()), matrix(&belief.p));
    let [v, w, f, g, h] =
        [matrix(&system.v), matrix(&system.w), matrix(&system.f), matrix(&system.g), matrix(&system.h)];
    let mut shown = Shown::default();
    for k in 0..STEPS {
        let u = Vector1::new(if k / 10 % 2 == 0 { 1.0 } else { -1.0 });
        truth = system.f * truth + system.g * u + noise.correlated(&root_v);
        let y = (system.h * truth)[0] + system.w[0].sqrt() * noise.normal();
        let given = vec![
            x,
            p,
            Matrix::column(u.as_slice()),
            Matrix::column(&[y]),
            v.clone(),
            w.clone(),
            f.clone(),
            g.clone(),
            h.clone(),
        ];
        let step = program.step(given)?;
        if let Some(nis) = nis(program, &step) {
            shown.nis = (shown.nis.0 + nis, shown.nis.1 + 1);
        }
        let made = |quantity| program.made(&step, quantity).cloned().ok_or(Stop::Given);
        (x, p) = (made(Quantity::X)?, made(Quantity::P)?);
    }
    let error = Matrix::column(&[truth[0] - x.at(0, 0), truth[1] - x.at(1, 0)]);
    if let Some(nees) = squared(&error, &p) {
        shown.nees = (nees, 1);
    }
    Ok(shown)
}
