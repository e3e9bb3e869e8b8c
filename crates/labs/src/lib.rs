//! The experiments of the page as plain Rust: each lab takes a few parameters and answers with one frame of plain
//! values.
//!
//! A lab is a function of its parameters (the seed is one) and its step, to the last bit; see [`lab::Lab`]. What
//! figures there are is listed once, in [`figures!`].

pub mod bug_museum;
pub mod car_log;
pub mod cart_copy;
pub mod ensemble;
pub mod error_cloud;
#[macro_use]
mod figures;
pub mod late_readings;
pub mod loop_closure;
pub mod mapping;
pub mod observability_probe;
pub mod observer_bench;
pub mod odometry_hook;
pub mod own_system;
pub mod picture;
pub mod robot_log;
mod shapes;
pub mod touch;
pub mod true_path;
pub mod tune;
pub mod two_bells;
pub mod two_carts;
mod typescript;
pub mod worlds;
pub mod write_filter;

pub use estimate::localizer::SensorKind;
pub use figures::FIGURES;
pub use mapping::MapError;
pub use shapes::{BenchBelief, ellipse_of, inside};
pub use true_path::TruePath;
pub use typescript::TYPESCRIPT;

/// What the folders of the figures hand out. The folders are named above, one by one: `cargo fmt` does not look into
/// macros for them.
macro_rules! handed_out {
    ($($module:ident::$lab:ident $(of $world:ident)? in $build:literal $(, was $was:literal)?;)*) => {
        $(pub use $module::*;)*
    };
}

figures!(handed_out);
