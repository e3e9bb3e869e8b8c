//! The rail robot of §8.2.6.

use crate::lti::Lti;
use filters::Gaussian;
use nalgebra::{Matrix1, Matrix2, RowVector2, U1, U2, Vector2};

// ANCHOR: dead_reckoning
/// The rail robot of §8.2.6 with its velocity sensor, and its first belief N(x̂(k|k), P(k|k)): state [m, m/s], a force
/// of 1 N accelerates its 1 kg by 1 m/s², sampled every 0.5 s.
pub fn dead_reckoning() -> (Lti<U2, U1, U1>, Gaussian<U2>) {
    let (t, mass) = (0.5, 1.0);
    let sys = Lti {
        f: Matrix2::new(1.0, t, 0.0, 1.0),
        g: Vector2::new(0.0, t / mass),
        h: RowVector2::new(0.0, 1.0),
        v: Matrix2::new(0.2, 0.05, 0.05, 0.1),
        w: Matrix1::new(0.5),
    };
    (sys, Gaussian { x: Vector2::new(2.0, 4.0), p: Matrix2::new(1.0, 0.0, 0.0, 2.0) })
}

/// The same robot with a sensor of its position instead.
pub fn position_sensor() -> (Lti<U2, U1, U1>, Gaussian<U2>) {
    let (sys, belief) = dead_reckoning();
    (Lti { h: RowVector2::new(1.0, 0.0), ..sys }, belief)
}
// ANCHOR_END: dead_reckoning
