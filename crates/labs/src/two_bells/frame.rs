//! What the two bells show.

use super::TwoBellsParams;
use lab::record;

record! {
    /// Two opinions about one number, and what comes of both.
    pub struct TwoBellsFrame {
        /// Always 0: nothing here goes by steps.
        pub step: u32,
        /// The parameters.
        pub params: TwoBellsParams,
        /// y*, the most likely output: the mean of the product.
        pub likely: f64,
        /// The variance of the product.
        pub variance: f64,
        /// One over the variance of the prediction's opinion, of the reading, and of their product.
        pub weights: [f64; 3],
        /// The way from the expected output to y*, and from there to the reading.
        pub arms: [f64; 2],
    }
}
