//! What a reader of the cart and its copy can change.

use lab::params;

params! {
    /// What the reader can change. A copy that is put somewhere else starts the run anew: `phase` is then the cart's.
    pub struct CartCopyParams {
        /// Position of the copy less that of the cart, at step 0.
        pub position: f64 = (-1.0), from (-1.5) to 1.5 by 0.05 in "m";
        /// Speed of the copy less that of the cart, at step 0.
        pub speed: f64 = 0.0, from (-1.5) to 1.5 by 0.05 in "m/s";
        /// The knob g in K = g · R∞. At every value a speed error dies out, or stays.
        pub gain: f64 = 1.0, from 0.0 to 5.0 by 0.05;
        /// Where in its round, of 16 steps, the cart is at step 0.
        pub phase: u32 = 0, from 0.0 to 15.0 by 1.0;
    }
}
