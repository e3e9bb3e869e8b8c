//! The touch: an ellipse of a prediction grows until it touches the line of a reading, and a reader says before where
//! that will be (§8.2.3). It is the Picture's first half: one line, and a sensor without noise.

pub(crate) mod frame;
mod params;

pub use frame::TouchFrame;
pub use params::TouchParams;

use crate::picture::{FIRST_READING, FIRST_STEP};
use crate::shapes::{ellipse_of, rows};
use estimate::{Code, Error};
use geom::AffineSet;
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::{RowVector2, Vector1, Vector2};
use numerics::Spd;

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Clone, Debug)]
pub struct Touch {
    params: TouchParams,
    step: u32,
    frame: TouchFrame,
    digest: Digest,
}

impl Lab for Touch {
    named! {
        "touch", TouchParams, TouchFrame, &[frame::INTERFACES],
        "An ellipse that grows until it touches the line of a reading."
    }
    kept! {}

    fn start((): (), params: TouchParams) -> Result<Self, Error> {
        params.check()?;
        let frame = touch(params)?;
        let mut digest = Digest::default();
        for point in [&frame.guess, &frame.touch, &frame.below] {
            digest.take(point);
        }
        digest.take(&[frame.guess_radius, frame.touch_radius, frame.times]);
        Ok(Self { params, step: 0, frame, digest })
    }

    fn tried() -> Vec<Self::Params> {
        let open = TouchParams::default();
        vec![open, TouchParams { covariance: -1.7, guess: -0.35, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        Ok(())
    }

    fn frame(&self) -> TouchFrame {
        self.frame.clone()
    }
}

fn touch(params: TouchParams) -> Result<TouchFrame, Error> {
    let mut p = FIRST_STEP;
    (p[(0, 1)], p[(1, 0)]) = (params.covariance, params.covariance);
    let mean = Vector2::new(4.0, 4.0);
    let line = AffineSet { h: RowVector2::new(0.0, 1.0), y: Vector1::new(FIRST_READING) };
    let none = || Error::new(Code::InnovationNotPositiveDefinite, "covariance", "leaves no point of touch");
    let below = line.euclidean_foot(&mean).ok_or_else(none)?;
    let touch = line.mahalanobis_foot(&p, &mean).ok_or_else(none)?;
    let metric = Spd::new(p).ok_or_else(none)?;
    let square = |at: &Vector2<f64>| (at - mean).dot(&metric.solve(&(at - mean))).max(0.0);
    let guess = below + Vector2::new(params.guess, 0.0);
    let (far, near) = (square(&guess), square(&touch));
    Ok(TouchFrame {
        step: 0,
        params,
        mean: mean.into(),
        p: rows(&p),
        ellipse: ellipse_of(&p),
        h: line.h.transpose().into(),
        reading: FIRST_READING,
        below: below.into(),
        guess: guess.into(),
        guess_radius: far.sqrt(),
        touch: touch.into(),
        touch_radius: near.sqrt(),
        off: guess[0] - touch[0],
        times: libm::exp(0.5 * (far - near)),
    })
}

#[cfg(test)]
mod tests;
