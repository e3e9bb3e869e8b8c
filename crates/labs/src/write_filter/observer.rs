//! What a program is as an observer, where its gain depends on nothing: its gain is read off its answers.

use super::frame::WriteObserver;
use crate::worlds::linear::given;
use estimate::Observer;
use estimate::rail::position_sensor;
use filters::linear;
use nalgebra::{DMatrix, Matrix2, Vector1, Vector2};
use program::{Matrix, Program, Quantity};

/// Two numbers are one that differ by no more than this part of their size.
const NEAR: f64 = 1e-9;

/// The observer that a program is on the rail; none where its gain depends on P, or its estimate is no observer's.
pub(super) fn of(program: &Program) -> Option<WriteObserver> {
    let mut program = program.clone();
    let (sys, belief) = position_sensor();
    let mut step = |x: Vector2<f64>, p: &Matrix2<f64>, u: f64, y: f64| {
        let before = vec![Matrix::column(x.as_slice()), Matrix::new(2, 2, p.as_slice().to_vec())];
        let step = program.step([before, given(&sys, u, y)].concat()).ok()?;
        let made = |quantity| program.made(&step, quantity).map(|m| m.entries.clone());
        Some((Vector2::from_row_slice(&made(Quantity::X)?), Matrix2::from_row_slice(&made(Quantity::P)?)))
    };
    let priors = [belief.p, 7.0 * belief.p + Matrix2::new(0.0, 0.5, 0.5, 3.0)];
    let gain = |p: &Matrix2<f64>, step: &mut dyn FnMut(_, &_, f64, f64) -> Option<(Vector2<f64>, Matrix2<f64>)>| {
        Some(step(Vector2::zeros(), p, 0.0, 1.0)?.0 - step(Vector2::zeros(), p, 0.0, 0.0)?.0)
    };
    let k = gain(&priors[0], &mut step)?;
    if !near(&gain(&priors[1], &mut step)?, &k) {
        return None;
    }
    let mut honest = true;
    for p in &priors {
        for (x, u, y) in [(belief.x, 1.0, 3.0), (Vector2::new(-3.0, 1.0), -2.0, 0.5)] {
            let mut observer = Observer { sys, k, xhat: x };
            observer.step(&Vector1::new(u), &Vector1::new(y));
            let (estimate, claimed) = step(x, p, u, y)?;
            if !near(&estimate, &observer.xhat) {
                return None;
            }
            let predicted = linear::predicted_covariance(&sys.f, p, &sys.v).ok()?;
            honest &= near(&claimed, &observer.covariance_update(&predicted));
        }
    }
    let error = Observer { sys, k, xhat: belief.x }.error_matrix();
    let error = DMatrix::from_column_slice(2, 2, error.as_slice());
    let eigenvalues = numerics::eigenvalues_in_closed_form(&error).ok()?;
    let radius = eigenvalues.iter().map(|l| numerics::hypot(l.re, l.im)).fold(0.0, f64::max);
    Some(WriteObserver { gain: k.into(), radius, honest })
}

fn near<const R: usize, const C: usize>(a: &nalgebra::SMatrix<f64, R, C>, b: &nalgebra::SMatrix<f64, R, C>) -> bool {
    (a - b).amax() <= NEAR * b.amax().max(1.0)
}
