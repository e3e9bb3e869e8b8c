//! What a reader of the Picture can change.

use core::f64::consts::{FRAC_PI_2, PI};
use geom::Ellipse;
use lab::params;
use nalgebra::Matrix2;

params! {
    /// What the reader can change. The covariance is given by its axes, so that no drag can make it invalid.
    pub struct PictureParams {
        /// x̂⁻, the prediction: m, m/s.
        pub mean: [f64; 2] = [4.0, 4.0], from (-100.0) to 100.0 by 0.05;
        /// Half the ellipse's first axis.
        pub semi_major: f64 = (first_step().semi_major), from 0.15 to 3.0 by 0.05;
        /// Half the ellipse's second axis; may be the longer one.
        pub semi_minor: f64 = (first_step().semi_minor), from 0.15 to 3.0 by 0.05;
        /// Angle of the first axis, radians.
        pub angle: f64 = (first_step().angle);
        /// The reading y.
        pub reading: f64 = FIRST_READING, from (-8.0) to 8.0 by 0.05 in "m/s";
        /// W, the reading's variance; 0 for a perfect sensor.
        pub noise: f64 = 0.5, from 0.0 to 4.0 by 0.05;
        /// Turn of the sensor: H = [−sin, cos], so 0 measures the velocity and −π/2 the position.
        pub tilt: f64 = 0.0, from (-FRAC_PI_2) to FRAC_PI_2 by (PI / 180.0) in "rad";
        /// Radius of an ellipse about x̂⁻ that the reader lets grow, in standard deviations; 0 for none.
        pub radius: f64 = 0.0, from 0.0 to 6.0 by 0.05;
        /// The reader's guess at the estimate: its place on Ω, from the perpendicular foot along the line.
        pub guess: Option<f64> = None, from (-200.0) to 200.0 by 0.05;
        /// Whether a view keeps the answer to itself while the reader guesses.
        pub sealed: bool = false;
    }
}

/// P⁻ of the first hand-checked step.
pub(crate) const FIRST_STEP: Matrix2<f64> = Matrix2::new(1.7, 1.05, 1.05, 2.1);
/// y of that step.
pub(crate) const FIRST_READING: f64 = 2.7;

/// The predicted ellipse of that step.
pub(crate) fn first_step() -> Ellipse {
    Ellipse::from_covariance(&FIRST_STEP, 1.0)
}
