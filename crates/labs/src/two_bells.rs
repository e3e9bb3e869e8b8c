//! Two bells on a beam: y*, the most likely output, is where two opinions balance (§8.2.4).

pub(crate) mod frame;
mod params;

pub use frame::TwoBellsFrame;
pub use params::TwoBellsParams;

use estimate::Error;
use estimate::kf::Gaussian;
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::{Matrix1, Vector1};

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Clone, Debug)]
pub struct TwoBells {
    params: TwoBellsParams,
    step: u32,
    frame: TwoBellsFrame,
    digest: Digest,
}

impl Lab for TwoBells {
    named! {
        "two-bells", TwoBellsParams, TwoBellsFrame, &[frame::INTERFACES],
        "Two opinions about one number, and where they balance."
    }
    kept! {}

    fn start((): (), params: TwoBellsParams) -> Result<Self, Error> {
        params.check()?;
        let frame = balance(params)?;
        let mut digest = Digest::default();
        digest.take(&[frame.likely, frame.variance]);
        Ok(Self { params, step: 0, frame, digest })
    }

    fn tried() -> Vec<Self::Params> {
        let open = TwoBellsParams::default();
        vec![open, TwoBellsParams { noise: 2.35, expected: 1.15, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        Ok(())
    }

    fn frame(&self) -> TwoBellsFrame {
        self.frame.clone()
    }
}

fn balance(params: TwoBellsParams) -> Result<TwoBellsFrame, Error> {
    let opinion = |mean, variance| Gaussian { x: Vector1::new(mean), p: Matrix1::new(variance) };
    let both = opinion(params.expected, params.expected_variance).product(&opinion(params.reading, params.noise))?;
    let (likely, variance) = (both.x[0], both.p[0]);
    Ok(TwoBellsFrame {
        step: 0,
        params,
        likely,
        variance,
        weights: [params.expected_variance, params.noise, variance].map(|variance| 1.0 / variance),
        arms: [likely - params.expected, params.reading - likely],
    })
}

#[cfg(test)]
mod tests;
