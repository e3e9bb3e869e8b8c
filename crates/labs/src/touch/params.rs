//! What a reader of the touch can change.

use lab::params;

params! {
    /// What the reader can change.
    pub struct TouchParams {
        /// The reader's dot: its place on the line, from the point straight below the prediction, to the right.
        pub guess: f64 = 1.5, from (-2.5) to 2.5 by 0.05 in "m";
        /// Whether the ellipse has grown until it touches the line; before, a view keeps to itself where it does.
        pub grown: bool = false;
        /// P₁₂ of the prediction, m²/s; its variances are those of the first hand-checked step.
        pub covariance: f64 = 1.05, from (-1.75) to 1.75 by 0.05;
    }
}
