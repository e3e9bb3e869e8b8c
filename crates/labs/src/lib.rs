//! The experiments of the page as plain Rust: each lab takes a few parameters and answers with one frame of plain values.
//!
//! A lab is a function of its parameters (the seed is one) and its step, to the last bit; see [`Lab`]. What the prose
//! prints comes from [`numbers`], what the chapter checks from [`checks`], and what was chosen from [`givens`].

pub mod checks;
pub mod ensembles;
pub mod givens;
mod lab;
mod mapping;
pub mod numbers;
mod observability_probe;
mod observer_bench;
mod odometry_frame;
mod odometry_hook;
mod picture;
mod series;
mod shapes;
mod true_path;

pub use lab::{Digest, Lab, MAX_STEP, State};
pub use mapping::MapError;
pub use observability_probe::{
    Fate, MapLandmark, MapShape, Means, ObservabilityProbe, PATH_STEPS, ProbeFrame, ProbeLandmark, ProbeParams,
    ProbeSeries, ProbeSighting, Ranks, RoomShape, Sight, Traces,
};
pub use observer_bench::{BenchFrame, BenchParams, MAX_GAIN, Mode, ObserverBench, Sensor};
pub use odometry_frame::{Belief3, HookFrame, HookSeries, LastSighting, Quality, Ratio, Seen, Spread, Stop, World};
pub use odometry_hook::{HookParams, MAX_BIAS, MAX_SLIP, OdometryHook};
pub use picture::{Foot, Picture, PictureFrame, PictureParams};
pub use series::{Series, Track, Tracks, WINDOW};
pub use shapes::{Belief2, EllipseShape, Root, ellipse_of};
pub use true_path::TruePath;
