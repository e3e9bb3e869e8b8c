//! What a reader of the odometry hook can change.

use lab::params;
use sim::scenarios::HOOK;

params! {
    /// What the reader can change.
    pub struct HookParams {
        /// The right wheel's nominal radius exceeds its true one by this fraction; the greatest turns the robot a
        /// quarter in two laps.
        pub bias: f64 = (HOOK.bias), from 0.0 to 0.01 by 0.0005;
        /// One sigma of what each wheel slips in a tick, at most a tenth of the way; the filter knows it.
        pub slip: f64 = (HOOK.slip), from 0.0 to 0.005 by 0.0001 in "m";
        /// Whether sightings of the corners correct the estimate.
        pub fixes: bool = false;
        /// Whether the right wheel's bias is a fourth state, which the filter learns.
        pub learn: bool = false;
        /// Fixes slip and sensor noise.
        pub seed: u32 = 1;
    }
}
