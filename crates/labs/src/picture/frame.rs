//! What the Picture shows.

use super::PictureParams;
use crate::shapes::BenchBelief;
use geom::Ellipse;
use lab::record;

record! {
    /// A step from the prediction, in both metrics.
    #[derive(Copy)]
    pub struct Foot {
        /// Where it leads.
        pub at: [f64; 2],
        /// HΔx − ν, with the innovation against the line it should land on: zero when it does.
        pub residual: f64,
        /// aᵀΔx for the unit vector a along the line: zero when the step is perpendicular.
        pub euclidean: f64,
        /// aᵀP⁻¹Δx: zero when the step is perpendicular in the metric of the covariance.
        pub mahalanobis: f64,
        /// ‖Δx‖ in that metric: how many ellipses away the step leads.
        pub distance: f64,
        /// The equidistant ellipse through that point.
        pub ellipse: Ellipse,
    }

    /// A point of Ω, judged by the belief.
    #[derive(Copy)]
    pub struct Guess {
        /// Where it is.
        pub at: [f64; 2],
        /// How many ellipses away it is.
        pub distance: f64,
        /// Its density over that of the most probable point of Ω.
        pub density: f64,
    }

    /// The picture.
    pub struct PictureFrame {
        /// Always 0: nothing here goes by steps.
        pub step: u32,
        /// The parameters.
        pub params: PictureParams,
        /// x̂⁻ and P⁻.
        pub predicted: BenchBelief,
        /// x̂⁺ and P⁺.
        pub posterior: BenchBelief,
        /// H, its one row.
        #[name = "H"]
        pub h: [f64; 2],
        /// The unit vector along Ω.
        pub along: [f64; 2],
        /// ν.
        pub innovation: f64,
        /// S = HP⁻Hᵀ + W.
        #[name = "S"]
        pub s: f64,
        /// R, the gain.
        #[name = "R"]
        pub r: [f64; 2],
        /// Hx̂⁻, the output that the prediction expects.
        pub expected_output: f64,
        /// HP⁻Hᵀ, its variance.
        pub expected_variance: f64,
        /// y*.
        pub most_likely_output: f64,
        /// The variance of y*, that of the product of both opinions: HP⁻HᵀW/S.
        pub most_likely_variance: f64,
        /// HR: the part of the innovation that y* takes over, 0 for none of it and 1 for all.
        pub share: f64,
        /// The probability inside the reader's ellipse, 1 − exp(−radius²/2).
        pub inside: f64,
        /// The reader's guess on Ω, where there is one.
        pub guess: Option<Guess>,
        /// The perpendicular foot on Ω.
        pub euclidean_foot: Foot,
        /// The Mahalanobis foot on Ω.
        pub mahalanobis_foot: Foot,
        /// The Kalman update: the Mahalanobis foot on Ω*.
        pub update: Foot,
        /// P⁻ by rows.
        #[name = "P"]
        pub p: [[f64; 2]; 2],
    }
}
