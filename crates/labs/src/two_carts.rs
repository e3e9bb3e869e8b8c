//! Two carts on one rail, pushed alike, and the readings of each: a direction that a sensor does not see, by hand
//! (Theorem 8.2.2). Nothing here is noisy.

pub(crate) mod frame;
mod params;

pub use frame::TwoCartsFrame;
pub use params::TwoCartsParams;

use crate::cart_copy::push;
use crate::observer_bench::Sensor;
use estimate::Error;
use estimate::observability::{analyze, observability_matrix};
use estimate::rail::{dead_reckoning, position_sensor};
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::{Vector1, Vector2};

/// Readings on a strip: those of a round, with its first and its last.
pub const READINGS: usize = 17;
/// The tolerance of the rank test, relative to the largest singular value.
const TOLERANCE: f64 = 1e-9;

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Clone, Debug)]
pub struct TwoCarts {
    params: TwoCartsParams,
    step: u32,
    frame: TwoCartsFrame,
    digest: Digest,
}

impl Lab for TwoCarts {
    named! {
        "two-carts", TwoCartsParams, TwoCartsFrame, &[frame::INTERFACES],
        "Two carts on one rail, pushed alike, and the readings of each."
    }
    kept! {}

    fn start((): (), params: TwoCartsParams) -> Result<Self, Error> {
        params.check()?;
        let frame = drive(params)?;
        let mut digest = Digest::default();
        for strip in frame.positions.iter().chain(&frame.readings) {
            digest.take(strip);
        }
        Ok(Self { params, step: 0, frame, digest })
    }

    fn tried() -> Vec<Self::Params> {
        let open = TwoCartsParams::default();
        vec![open, TwoCartsParams { sensor: Sensor::Position, speed: -0.35, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        Ok(())
    }

    fn frame(&self) -> TwoCartsFrame {
        self.frame.clone()
    }
}

fn drive(params: TwoCartsParams) -> Result<TwoCartsFrame, Error> {
    let (system, _) = match params.sensor {
        Sensor::Velocity => dead_reckoning(),
        Sensor::Position => position_sensor(),
    };
    let start = [Vector2::zeros(), Vector2::new(params.position, params.speed)];
    let mut states = start;
    let (mut positions, mut readings) = ([[0.0; READINGS]; 2], [[0.0; READINGS]; 2]);
    for k in 0..READINGS {
        let u = Vector1::new(push(k as u32));
        for (cart, state) in states.iter_mut().enumerate() {
            positions[cart][k] = state[0];
            readings[cart][k] = (system.h * *state)[0];
            *state = system.f * *state + system.g * u;
        }
    }
    let seen = analyze(&observability_matrix(&system.f, &system.h), TOLERANCE)?;
    let [first, second] = &readings;
    Ok(TwoCartsFrame {
        step: 0,
        params,
        start: start.map(Into::into),
        positions,
        readings,
        difference: first.iter().zip(second).map(|(a, b)| (b - a).abs()).fold(0.0, f64::max),
        rank: seen.rank as u32,
        // Of either sign; shown as a step forward.
        unseen: seen.nullspace.first().map(|c| [c[0].abs(), if c[0] < 0.0 { -c[1] } else { c[1] }].map(|e| e + 0.0)),
    })
}

#[cfg(test)]
mod tests;
