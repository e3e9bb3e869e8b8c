//! What the touch shows.

use super::TouchParams;
use geom::Ellipse;
use lab::record;

record! {
    /// A prediction, the line of a reading, and a dot of the reader's on it. A state is a position and a velocity.
    pub struct TouchFrame {
        /// Always 0: nothing here goes by steps.
        pub step: u32,
        /// The parameters.
        pub params: TouchParams,
        /// x̂⁻.
        pub mean: [f64; 2],
        /// P⁻.
        #[name = "P"]
        pub p: [[f64; 2]; 2],
        /// The ellipse of P⁻ at one standard deviation.
        pub ellipse: Ellipse,
        /// H, its one row.
        #[name = "H"]
        pub h: [f64; 2],
        /// y, the output on the line.
        pub reading: f64,
        /// The point of the line straight below the prediction.
        pub below: [f64; 2],
        /// The reader's dot.
        pub guess: [f64; 2],
        /// The radius at which the ellipse reaches the dot, in standard deviations.
        pub guess_radius: f64,
        /// Where the growing ellipse first touches the line.
        pub touch: [f64; 2],
        /// The radius at which it does.
        pub touch_radius: f64,
        /// The position of the dot less that of the touch, m.
        pub off: f64,
        /// The density at the touch over that at the dot.
        pub times: f64,
    }
}
