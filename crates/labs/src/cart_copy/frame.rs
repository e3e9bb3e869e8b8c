//! What the cart and its copy show.

use super::CartCopyParams;
use lab::record;

record! {
    /// The cart and its copy after a step. A state is a position and a speed, m and m/s.
    pub struct CartCopyFrame {
        /// Steps taken.
        pub step: u32,
        /// The parameters of the run.
        pub params: CartCopyParams,
        /// The state of the cart.
        pub truth: [f64; 2],
        /// The copy after its own drive: x̂(k+1 | k). At step 0, where it was put.
        pub predicted: [f64; 2],
        /// The copy after the nudge: x̂(k+1 | k+1).
        pub copy: [f64; 2],
        /// y, what the cart's speedometer reads.
        pub reading: f64,
        /// H x̂(k+1 | k), what the copy's would.
        pub expected: f64,
        /// ν, the one less the other.
        pub innovation: f64,
        /// Kν, what is added to the copy; nothing at step 0.
        pub nudge: [f64; 2],
        /// The copy's state less the cart's.
        pub error: [f64; 2],
        /// K.
        #[name = "K"]
        pub k: [f64; 2],
    }
}
