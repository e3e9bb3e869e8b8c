//! The Picture: a prediction, the states that explain a reading, and the two ways of stepping onto them (§8.2.2–8.2.4).

pub(crate) mod frame;
mod params;

pub use frame::{Foot, Guess, PictureFrame};
pub use params::PictureParams;
pub(crate) use params::{FIRST_READING, FIRST_STEP, first_step};

use crate::shapes::{inside, rows};
use estimate::kf::Gaussian;
use estimate::{Code, Error};
use filters::Update;
use filters::covariance::symmetric;
use geom::{AffineSet, Ellipse};
use lab::{Digest, Lab, Params, named};
use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};
use numerics::Spd;

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Clone, Debug)]
pub struct Picture {
    frame: PictureFrame,
    digest: Digest,
    steps: u32,
}

impl Lab for Picture {
    named! {
        "picture", PictureParams, PictureFrame, &[frame::INTERFACES],
        "A prediction, the states that explain a reading, and the two ways of stepping onto them."
    }
    type World = ();

    fn start((): (), params: PictureParams) -> Result<Self, Error> {
        params.check()?;
        let frame = picture(params)?;
        let mut digest = Digest::default();
        for foot in [&frame.euclidean_foot, &frame.mahalanobis_foot, &frame.update] {
            digest.take(&foot.at);
            digest.take(&[foot.distance]);
        }
        digest.take(frame.posterior.p.as_flattened());
        digest.take(&[frame.innovation, frame.s, frame.most_likely_output]);
        Ok(Self { frame, digest, steps: 0 })
    }

    fn world(&self) {}

    fn params(&self) -> &PictureParams {
        &self.frame.params
    }

    fn steps(&self) -> u32 {
        self.steps
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.steps += 1;
        Ok(())
    }

    fn frame(&self) -> PictureFrame {
        self.frame.clone()
    }

    fn digest(&self) -> u64 {
        self.digest.value()
    }
}

fn picture(params: PictureParams) -> Result<PictureFrame, Error> {
    let x = Vector2::from(params.mean);
    let turn = rotation(params.angle);
    let axes = Vector2::new(params.semi_major * params.semi_major, params.semi_minor * params.semi_minor);
    let p = symmetric(turn * Matrix2::from_diagonal(&axes) * turn.transpose());
    let sensor = rotation(params.tilt);
    let (along, h) = (sensor.column(0).into_owned(), RowVector2::new(sensor[(0, 1)], sensor[(1, 1)]));
    // A variance whose square is lost below the smallest number has no digits to compute with, and no ellipse shows it.
    let noise = if params.noise < 1e-150 { 0.0 } else { params.noise };
    let (y, w) = (Vector1::new(params.reading), Matrix1::new(noise));

    let predicted = Gaussian { x, p };
    let (posterior, Update { innovation, s, k, .. }) = predicted.corrected(&y, &h, &w)?;
    let expected = Gaussian { x: h * x, p: h * p * h.transpose() };
    let Gaussian { x: most_likely, p: most_likely_variance } = expected.product(&Gaussian { x: y, p: w })?;
    let no_foot = || Error::new(Code::InnovationNotPositiveDefinite, "semiMinor", "leaves no foot on the line");
    let (omega, omega_star) = (AffineSet { h, y }, AffineSet { h, y: most_likely });
    let metric = Spd::new(p).ok_or_else(no_foot)?;
    let foot = |set: &AffineSet<_, _>, at: Vector2<f64>| {
        let step = at - x;
        let scaled = metric.solve(&step);
        let distance = step.dot(&scaled).max(0.0).sqrt();
        Foot {
            at: at.into(),
            residual: -set.residual(&at)[0],
            euclidean: along.dot(&step),
            mahalanobis: along.dot(&scaled),
            distance,
            ellipse: Ellipse::from_covariance(&p, distance),
        }
    };
    let gray = omega.euclidean_foot(&x).ok_or_else(no_foot)?;
    let purple = foot(&omega, omega.mahalanobis_foot(&p, &x).ok_or_else(no_foot)?);
    let guess = params.guess.map(|place| {
        let Foot { at, distance, .. } = foot(&omega, gray + along * place);
        Guess { at, distance, density: libm::exp(0.5 * (purple.distance * purple.distance - distance * distance)) }
    });
    Ok(PictureFrame {
        step: 0,
        params,
        predicted: (&predicted).into(),
        posterior: (&posterior).into(),
        h: h.transpose().into(),
        along: along.into(),
        innovation: innovation[0],
        s: s[0],
        r: k.into(),
        expected_output: expected.x[0],
        expected_variance: expected.p[0],
        most_likely_output: most_likely[0],
        most_likely_variance: most_likely_variance[0],
        share: (h * k)[0],
        inside: inside(params.radius),
        guess,
        euclidean_foot: foot(&omega, gray),
        mahalanobis_foot: purple,
        update: foot(&omega_star, omega_star.mahalanobis_foot(&p, &x).ok_or_else(no_foot)?),
        p: rows(&p),
    })
}

fn rotation(angle: f64) -> Matrix2<f64> {
    let (s, c) = libm::sincos(angle);
    Matrix2::new(c, -s, s, c)
}

#[cfg(test)]
mod tests;
