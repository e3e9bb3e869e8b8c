//! The experiments of the page as plain Rust: each lab takes a few parameters and answers with one frame of plain values.
//!
//! A lab is a function of its parameters (the seed is one) and its step, to the last bit; see [`lab::Lab`]. What figures there are
//! is listed once, in [`figures!`].

pub mod bug_museum;
pub mod ensemble;
mod figures;
mod loop_closure;
pub mod mapping;
pub mod observability_probe;
pub mod observer_bench;
pub mod odometry_hook;
mod own_system;
mod picture;
mod robot_log;
mod shapes;
pub mod true_path;
mod tune;
mod typescript;

pub use bug_museum::{
    Bug, BugMuseum, MuseumAnswer, MuseumFigure, MuseumFrame, MuseumParams, MuseumReadings, MuseumSeries, MuseumSighting,
};
pub use estimate::localizer::SensorKind;
pub use figures::FIGURES;
pub use loop_closure::{
    LoopClosure, LoopFrame, LoopGate, LoopMoment, LoopParams, LoopSeries, LoopSighting, LoopThresholds,
};
pub use mapping::MapError;
pub use observability_probe::{
    Fate, Ghost, GhostReadings, MapLandmark, Means, ObservabilityProbe, PATH_STEPS, ProbeFrame, ProbeLandmark,
    ProbeMap, ProbeParams, ProbeRanks, ProbeSeries, ProbeSighting, RoomShape, Traces,
};
pub use observer_bench::{BenchFrame, BenchParams, BenchSeries, Feet, Mode, ObserverBench, Sensor};
pub use odometry_hook::{
    CornerSighting, HookFrame, HookParams, HookSeries, LastSighting, OdometryHook, PoseBelief, Quality, Ratio, Spread,
    Stop, WheelBelief, World,
};
pub use own_system::{GainBy, OwnEigenvalue, OwnFrame, OwnParams, OwnRank, OwnReach, OwnSeries, OwnSystem};
pub use picture::{Foot, Guess, Picture, PictureFrame, PictureParams};
pub use robot_log::{
    LogBands, LogCorrelation, LogErrors, LogFrame, LogHistogram, LogInnovations, LogLandmark, LogNis, LogParams,
    LogRanges, LogSighting, LogTable, LogTableKind, LogTimeline, LogTracks, LoggedDrive, RobotLog,
};
pub use shapes::{BenchBelief, ellipse_of, inside};
pub use true_path::TruePath;
pub use tune::{MAX_MAP_SIZE, Tune, TuneBand, TuneFit, TuneFrame, TuneParams, TuneVerdict};
pub use typescript::TYPESCRIPT;
