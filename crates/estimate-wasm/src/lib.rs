//! The JavaScript face of the estimate core.
//!
//! Plain values in, plain values out: a matrix is an array of rows, a vector an array of numbers, a complex number
//! `{ re, im }`. Every export decodes its arguments strictly (nothing is coerced), calls the core, and encodes the
//! answer; there is no arithmetic here. What cannot be answered is thrown as an `Error` named `EstimateError` with a
//! `code`, the `argument` to blame and a `message`; every object is then as it was, and the module goes on working.
//!
//! One mistake does not come this far: a method called after `free()`, or on what is no object of the module, throws
//! wasm-bindgen's own error, which has no `code`.
//!
//! Nor does a call that the engine ends for want of stack: the types say at `EstimateError` what to do then. Nor does a
//! fault of the module itself: in Node and in the npm package `scripts/guard.mjs` refuses by name whatever follows it.
//!
//! A matrix has at most 16 rows and 16 columns, any other array at most 10 000 entries; a call that accepts fewer, and
//! a typed array, say so where they stand.

// A build with some of the classes takes of what all share the part that these need.
#![cfg_attr(not(feature = "functions"), allow(dead_code, unused_imports))]

#[cfg(feature = "analysis")]
mod analysis;
#[cfg(feature = "arguments")]
mod arguments;
#[cfg(feature = "log")]
mod car_log;
#[cfg(feature = "checks")]
mod checks;
mod decode;
#[cfg(feature = "functions")]
mod ekf_localizer;
#[cfg(feature = "functions")]
mod ekf_slam;
mod encode;
mod errors;
#[cfg(feature = "models")]
mod filter_state;
#[cfg(feature = "functions")]
mod functions;
#[cfg(feature = "functions")]
mod kalman_filter;
#[cfg(feature = "labs")]
mod lab;
#[cfg(feature = "log")]
mod log_corrections;
#[cfg(feature = "log")]
mod log_file;
#[cfg(feature = "log")]
mod log_files;
#[cfg(feature = "log")]
mod log_fit;
#[cfg(feature = "log")]
mod log_opening;
#[cfg(feature = "log")]
mod log_readings;
#[cfg(feature = "log")]
mod log_table;
#[cfg(feature = "log")]
mod log_verdict;
mod names;
mod object;
#[cfg(feature = "models")]
mod own_models;
#[cfg(feature = "analysis")]
mod placement;
#[cfg(feature = "programs")]
mod program;
#[cfg(feature = "log")]
mod robot_log;
#[cfg(feature = "functions")]
mod timeline;

#[cfg(feature = "checks")]
pub use self::checks::*;
#[cfg(feature = "labs")]
pub use self::lab::*;
#[cfg(feature = "models")]
pub use self::own_models::{ExtendedKalmanFilter, UnscentedKalmanFilter};
#[cfg(feature = "programs")]
pub use self::program::Program;
#[cfg(feature = "analysis")]
pub use self::{analysis::*, placement::*};
#[cfg(feature = "functions")]
pub use self::{
    ekf_localizer::EkfLocalizer, ekf_slam::EkfSlam, functions::*, kalman_filter::KalmanFilter, timeline::Timeline,
};
#[cfg(feature = "log")]
pub use self::{
    log_files::LogFiles, log_fit::LogFit, log_table::LogTable, log_verdict::LogVerdict, robot_log::DriveLog,
};

use wasm_bindgen::prelude::*;

/// A small allocator for the builds that have to be light. The whole module keeps Rust's own, with which a call is a
/// tenth quicker.
#[cfg(all(target_arch = "wasm32", not(feature = "analysis")))]
#[global_allocator]
static ALLOCATOR: rlsf::GlobalTlsf = rlsf::GlobalTlsf::new();

/// No input can make the core panic; should a defect do so all the same, the console says where before the trap.
#[wasm_bindgen(start)]
pub fn start() {
    // The table that JavaScript values are kept in grows at the first of them. Were that deep in a recursion of the
    // caller's, without stack left, the module would be of no use afterwards.
    drop(JsValue::from_str("module"));
    std::panic::set_hook(Box::new(|info| web_sys::console::error_1(&info.to_string().into())));
}
