//! What a reader of the car's log can change.

use lab::{params, words};

words! {
    /// Which of the fixes correct the estimate.
    pub enum CarFixes {
        /// One a second.
        Second = "second",
        /// All of them, ten a second.
        All = "all",
        /// None: speeds and turn rates alone.
        None = "none",
    }
}

params! {
    /// What the filter is told.
    pub struct CarParams {
        /// Which fixes correct the estimate.
        pub fixes: CarFixes = (CarFixes::Second);
        /// How late the speeds are.
        pub delay: f64 = 0.0, from (-1.0) to 2.0 by 0.02 in "s";
        /// Whether the scale of the speed and the bias of the turn rate are states of the filter.
        pub learn: bool = false;
        /// Whether the fixes from 100 s to 130 s are withheld, as in a tunnel.
        pub tunnel: bool = false;
        /// Whether a fix is refused beyond the gate.
        pub gate: bool = false;
    }
}
