//! A drive as it was logged, and its replay: the localizer of §8.3 over motion and readings, each at the time at which
//! it was measured.
//!
//! Beyond [`Localizer`](crate::Localizer), which takes its process noise V in the state, a replay takes the noise of
//! the *input* and carries it through the input's Jacobian (V = B M Bᵀ). Sensors may be late, and what they read may be
//! scaled, offset and biased: a radio that reads 7 % long says y = 1.07 ρ. Such numbers are given, or they are states
//! that the filter learns. [`Smoothed`] is the track in the light of all readings.
//!
//! What is read of the motion is held until the next row, unless it changes evenly ([`Motion`]), and each step is
//! driven straight along the heading at its beginning, with the turn at its end. A robot that turns on its way is
//! therefore seen a little aside, as if its turn rate came half a step late: in a log with sparse rows of motion that
//! looks like a clock. A [`Verdict`] asks for it, and takes no delay of up to half a step for a fault. What is driven
//! evenly turns on its way, and has no such delay.

mod beside;
mod course;
mod diluted;
mod displaced;
mod evidence;
mod exchange;
mod fault;
mod filter;
mod fit;
mod fit_result;
mod fitted;
mod flat;
mod freed;
mod gaps;
mod gates;
mod judgement;
mod learned;
mod likelihood;
mod line;
mod moves;
mod noise;
mod opening;
mod opening_parabola;
mod opening_ranges;
mod opening_seen;
mod opening_spread;
mod opening_trust;
mod outliers;
mod pace;
mod read;
mod replay;
mod round;
mod row;
mod sensor;
mod settings;
mod smoother;
mod statistics;
mod step;
mod summary;
mod suspect;
mod thinning;
mod times;
mod told;
mod tried;
mod truth;
mod verdict;
mod weight;

pub use crate::scaled::{FIRST_SIGMA, HasPose, PoseAndScale, RangeFirst, Scaled};
pub use course::Course;
pub use diluted::squared_turn;
pub use evidence::Against;
pub use fault::Fault;
pub use fit::Fit;
pub use fit_result::FitResult;
pub use fitted::Fitted;
pub use gaps::{Gaps, Missing, SHORTEST_GAP, end_without, gaps, gaps_and_end, gaps_of, lacks};
pub use judgement::Judgement;
pub use learned::FIRST_SIGMA_BIAS;
pub use likelihood::{beyond, log_likelihood};
pub use line::{Line, Points};
pub use noise::{Correlated, Noise, Stretch};
pub use opening::Opening;
pub use replay::{Replay, Taken};
pub use round::MOST_JUDGED;
pub use row::{Drive, Event, Motion, Row};
pub use sensor::{BySensor, Sensor};
pub use settings::{Delays, MAX_DELAY, Settings};
pub use smoother::{Smoothed, SmoothedPose};
pub use statistics::Judged;
pub use summary::{BearingSummary, FixSummary, SensorSummary, Sensors, Summary, Withheld};
pub use suspect::{Size, Standing, Suspect};
pub use thinning::Thinning;
pub use times::Times;
pub use truth::{Pose, Truth};
pub use verdict::Verdict;

#[cfg(test)]
mod tests;
