//! What the cloud shows.

use super::{DOTS, ErrorCloudParams};
use geom::Ellipse;
use lab::record;

record! {
    /// Two hundred errors, and what their mean products are. An error is one of the position and one of the velocity.
    pub struct ErrorCloudFrame {
        /// Always 0: nothing here goes by steps.
        pub step: u32,
        /// The parameters.
        pub params: ErrorCloudParams,
        /// The errors, m and m/s.
        pub dots: [[f64; 2]; DOTS],
        /// The mean products of these errors.
        #[name = "P"]
        pub p: [[f64; 2]; 2],
        /// Its ellipse at one standard deviation.
        pub ellipse: Ellipse,
        /// The square roots of P₁₁ and P₂₂.
        pub sigma: [f64; 2],
        /// P₁₂ over both of them.
        pub correlation: f64,
        /// P₁₂/P₂₂: the slope of the regression of the position error on the velocity error, s.
        pub regression: f64,
        /// Position error for each m/s along the ellipse's long axis, s.
        pub long_axis: f64,
        /// The error looked at.
        pub error: [f64; 2],
        /// The product of its two entries, m²/s.
        pub product: f64,
        /// What that adds to P₁₂: its two-hundredth.
        pub share: f64,
        /// What the errors with a positive product add to P₁₂, and how many they are.
        pub positive: f64,
        /// How many errors have a positive product.
        pub positives: u32,
        /// What those with a negative product add.
        pub negative: f64,
        /// How many errors the ellipse holds.
        pub inside: u32,
    }
}
