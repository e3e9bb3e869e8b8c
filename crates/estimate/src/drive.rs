//! A drive as it was logged, and its replay: the localizer of §8.3 over motion and readings, each at the time at which
//! it was measured.
//!
//! Beyond [`Localizer`](crate::Localizer), which takes its process noise V in the state, a replay takes the noise of
//! the *input* and carries it through the input's Jacobian (V = B M Bᵀ). Sensors may be late, and what they read may be
//! scaled, offset and biased: a radio that reads 7 % long says y = 1.07 ρ. Such numbers are given, or they are states
//! that the filter learns. [`Smoothed`] is the track in the light of all readings.

mod course;
mod evidence;
mod filter;
mod fit;
mod fitted;
mod freed;
mod learned;
mod likelihood;
mod line;
mod opening;
mod replay;
mod round;
mod row;
mod sensor;
mod settings;
mod smoother;
mod statistics;
mod summary;
mod suspect;
mod told;
mod truth;
mod verdict;

pub use crate::scaled::{FIRST_SIGMA, HasPose, PoseAndScale, RangeFirst, Scaled};
pub use course::Course;
pub use evidence::Against;
pub use fit::{Fit, Found};
pub use fitted::Fitted;
pub use learned::FIRST_SIGMA_BIAS;
pub use likelihood::log_likelihood;
pub use line::{Line, Points};
pub use opening::Opening;
pub use replay::{Replay, Taken};
pub use row::{Drive, Event, Motion, Row};
pub use sensor::{BySensor, Sensor};
pub use settings::{Delays, MAX_DELAY, Settings};
pub use smoother::{Smoothed, SmoothedPose};
pub use statistics::Judged;
pub use summary::{BearingSummary, FixSummary, SensorSummary, Sensors, Summary, Withheld};
pub use suspect::{Fault, Size, Standing, Suspect};
pub use truth::{Pose, Truth};
pub use verdict::{Judgement, MOST_JUDGED, Verdict};

#[cfg(test)]
mod tests;
