//! The cloud: a covariance as the mean products of two hundred errors, which can be seen and touched (§8.2.1).

pub(crate) mod frame;
mod params;

pub use frame::ErrorCloudFrame;
pub use params::ErrorCloudParams;

use crate::shapes::{ellipse_of, rows};
use estimate::Error;
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::{Matrix2, Vector2};
use numerics::Spd;
use sim::Noise;
use std::sync::LazyLock;

/// How many errors there are.
pub const DOTS: usize = 200;
/// What they are drawn with.
const SEED: u64 = 7;

/// Errors whose mean is zero and whose mean products are those of I, up to rounding: drawn, and then moved and
/// stretched together until it is so. The table of the figure is then the covariance itself and no estimate of it.
static UPRIGHT: LazyLock<[Vector2<f64>; DOTS]> = LazyLock::new(upright);

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Clone, Debug)]
pub struct ErrorCloud {
    params: ErrorCloudParams,
    step: u32,
    digest: Digest,
}

impl Lab for ErrorCloud {
    named! {
        "error-cloud", ErrorCloudParams, ErrorCloudFrame, &[frame::INTERFACES],
        "A covariance as the mean products of two hundred errors."
    }
    kept! {}

    fn start((): (), params: ErrorCloudParams) -> Result<Self, Error> {
        params.check()?;
        let mut digest = Digest::default();
        let frame = cloud(params);
        digest.take(frame.dots.as_flattened());
        digest.take(frame.p.as_flattened());
        Ok(Self { params, step: 0, digest })
    }

    fn tried() -> Vec<Self::Params> {
        let open = ErrorCloudParams::default();
        vec![open, ErrorCloudParams { semi_major: 0.4, angle: -1.1, dot: 12, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        Ok(())
    }

    fn frame(&self) -> ErrorCloudFrame {
        cloud(self.params)
    }
}

fn cloud(params: ErrorCloudParams) -> ErrorCloudFrame {
    let (s, c) = libm::sincos(params.angle);
    let axes = Matrix2::new(c, -s, s, c) * Matrix2::from_diagonal(&Vector2::new(params.semi_major, params.semi_minor));
    let dots: [Vector2<f64>; DOTS] = core::array::from_fn(|i| axes * UPRIGHT[i]);
    let p = mean_products(&dots);
    let ellipse = ellipse_of(&p);
    let (sin, cos) = libm::sincos(ellipse.angle);
    let part = |of: &dyn Fn(f64) -> bool| {
        let products = dots.iter().map(|e| e[0] * e[1]).filter(|product| of(*product));
        products.fold((0.0, 0), |(sum, count), product| (sum + product / DOTS as f64, count + 1))
    };
    let ((positive, positives), (negative, _)) = (part(&|product| product > 0.0), part(&|product| product <= 0.0));
    let error = dots[(params.dot as usize).min(DOTS - 1)];
    let product = error[0] * error[1];
    ErrorCloudFrame {
        step: 0,
        params,
        dots: dots.map(Into::into),
        p: rows(&p),
        ellipse,
        sigma: [p[(0, 0)].sqrt(), p[(1, 1)].sqrt()],
        correlation: p[(0, 1)] / (p[(0, 0)].sqrt() * p[(1, 1)].sqrt()),
        regression: p[(0, 1)] / p[(1, 1)],
        long_axis: cos / sin,
        error: error.into(),
        product,
        share: product / DOTS as f64,
        positive,
        positives,
        negative,
        inside: UPRIGHT.iter().filter(|e| e.norm_squared() <= 1.0).count() as u32,
    }
}

/// The mean of e eᵀ.
fn mean_products(errors: &[Vector2<f64>]) -> Matrix2<f64> {
    let sum = errors.iter().fold(Matrix2::zeros(), |sum, e| sum + e * e.transpose());
    sum / errors.len() as f64
}

fn upright() -> [Vector2<f64>; DOTS] {
    let mut noise = Noise::new(SEED);
    let mut errors = [Vector2::zeros(); DOTS];
    for error in &mut errors {
        *error = Vector2::new(noise.normal(), noise.normal());
    }
    let mean = errors.iter().sum::<Vector2<f64>>() / DOTS as f64;
    errors.iter_mut().for_each(|error| *error -= mean);
    // Two hundred draws span the plane. If they did not, they would stay as they were drawn.
    let root = Spd::new(mean_products(&errors)).map_or_else(Matrix2::identity, |metric| metric.root());
    for error in &mut errors {
        let first = error[0] / root[(0, 0)];
        *error = Vector2::new(first, (error[1] - root[(1, 0)] * first) / root[(1, 1)]);
    }
    errors.sort_by(|a, b| a[0].total_cmp(&b[0]));
    errors
}

#[cfg(test)]
mod tests;
