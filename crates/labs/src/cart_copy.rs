//! A cart on a rail and its copy: an observer as the second robot that it is (§8.2.1, App. J.4). Neither the drive nor
//! the speedometer has noise here, so that an error of the copy is the reader's own.

pub(crate) mod frame;
mod params;

pub use frame::CartCopyFrame;
pub use params::CartCopyParams;

use crate::observer_bench::{Sensor, steady_gain};
use estimate::rail::dead_reckoning;
use estimate::{Error, Observer};
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::{U1, U2, Vector1, Vector2};

/// Steps of a round: to the far end of the rail and back. A power of two, as all that moves the cart, so that a round
/// ends to the bit where it began.
const ROUND: u32 = 16;
/// The force that pushes, N.
const PUSH: f64 = 1.0;

/// The lab.
#[derive(Clone, Debug)]
pub struct CartCopy {
    params: CartCopyParams,
    step: u32,
    truth: Vector2<f64>,
    observer: Observer<U2, U1, U1>,
    predicted: Vector2<f64>,
    digest: Digest,
}

impl Lab for CartCopy {
    named! {
        "cart-copy", CartCopyParams, CartCopyFrame, &[frame::INTERFACES],
        "A cart on a rail and its copy: an observer as the second robot that it is."
    }
    kept! {}

    fn start((): (), params: CartCopyParams) -> Result<Self, Error> {
        params.check()?;
        let (sys, belief) = dead_reckoning();
        let k = steady_gain(Sensor::Velocity, &sys, &belief)? * params.gain;
        let truth =
            (0..params.phase).fold(Vector2::zeros(), |state, step| sys.f * state + sys.g * Vector1::new(push(step)));
        let copy = truth + Vector2::new(params.position, params.speed);
        let observer = Observer { sys, k, xhat: copy };
        let mut lab = Self { params, step: 0, truth, observer, predicted: copy, digest: Digest::default() };
        lab.record();
        Ok(lab)
    }

    fn tried() -> Vec<Self::Params> {
        let open = CartCopyParams::default();
        vec![open, CartCopyParams { speed: 1.25, gain: 3.0, phase: 5, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        let sys = self.observer.sys;
        let u = Vector1::new(push(self.params.phase + self.step));
        self.step += 1;
        self.truth = sys.f * self.truth + sys.g * u;
        self.predicted = sys.f * self.observer.xhat + sys.g * u;
        self.observer.step(&u, &(sys.h * self.truth));
        self.record();
        Ok(())
    }

    fn frame(&self) -> CartCopyFrame {
        let Observer { sys, k, xhat } = self.observer;
        let (reading, expected) = ((sys.h * self.truth)[0], (sys.h * self.predicted)[0]);
        CartCopyFrame {
            step: self.step,
            params: self.params,
            truth: self.truth.into(),
            predicted: self.predicted.into(),
            copy: xhat.into(),
            reading,
            expected,
            innovation: reading - expected,
            nudge: (xhat - self.predicted).into(),
            error: (xhat - self.truth).into(),
            k: k.into(),
        }
    }
}

impl CartCopy {
    fn record(&mut self) {
        for state in [&self.truth, &self.predicted, &self.observer.xhat] {
            self.digest.take(state.as_slice());
        }
    }
}

/// The force on the cart, which its copy is told: forward for a quarter of the round, backward for two, forward again.
pub(crate) fn push(step: u32) -> f64 {
    match step % ROUND / 4 {
        0 | 3 => PUSH,
        _ => -PUSH,
    }
}

#[cfg(test)]
mod tests;
