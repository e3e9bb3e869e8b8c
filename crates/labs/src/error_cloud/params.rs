//! What a reader of the cloud can change.

use crate::picture::first_step;
use lab::params;

params! {
    /// What the reader can change. The covariance is given by its axes, so that no drag can make it invalid.
    pub struct ErrorCloudParams {
        /// Half the ellipse's first axis.
        pub semi_major: f64 = (first_step().semi_major), from 0.3 to 2.0 by 0.05;
        /// Half the ellipse's second axis; may be the longer one.
        pub semi_minor: f64 = (first_step().semi_minor), from 0.3 to 2.0 by 0.05;
        /// Angle of the first axis, radians.
        pub angle: f64 = (first_step().angle);
        /// Which error is looked at, counted from the left of the upright cloud.
        pub dot: u32 = 185, from 0.0 to 199.0 by 1.0;
    }
}
