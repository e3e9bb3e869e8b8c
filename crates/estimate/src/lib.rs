#![doc = include_str!("../README.md")]
//!
//! # What is where
//!
//! The chapter's observers and filters, in Choset's letters (Principles of Robot Motion, chapter 8 and appendix J).
//!
//! The letters collide with the sister volume's in the worst place: Choset's R is the Kalman *gain* and his V and W are
//! covariances; Thrun's R and Q are covariances and his gain is K. The `filters` crate speaks Thrun; this crate
//! translates at its boundary, and every field of [`Lti`] names its twin.
//!
//! - [`Lti`], [`Observer`], [`place_observer_gain`]: linear systems, the fixed-gain observer, and where its poles may
//!   go;
//! - [`kf`]: one Kalman step; [`rail`]: the rail robot of §8.2.6;
//! - [`riccati`]: the gain as a schedule, and its limit;
//! - [`likelihood`]: how likely a log is, and the noise under which it is likeliest;
//! - [`observability`]: ranks, with the singular values and null directions behind them;
//! - [`Detectability`], [`Reachability`], [`RiccatiLimit`]: whether what is unseen dies out, what noise reaches, and
//!   whether P settles, each with a [`Verdict`] within a tolerance;
//! - [`odometry_delta`], [`landmarks`], [`Localizer`]: from encoder counts to localization among known landmarks;
//! - [`RightWheel`]: the same with the fraction by which a wheel is believed too large as a fourth state;
//! - [`slam`]: robot and map in one state, linear and range–bearing;
//! - [`path_observability`]: the rank test frozen at one pose, and along the path driven;
//! - [`dynamic`]: the same linear functions for shapes known at run time only, with every argument checked; systems in
//!   continuous time, a smoother, and a time line for sensors with delays;
//! - [`drive`]: a logged drive of several sensors, its replay by the time of their measurement, with input noise,
//!   delays and what the filter learns of its sensors, and its smoother;
//! - [`localizer`]: the EKF localizer for a caller without types, with every argument checked.

#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

mod averages;
mod balance;
mod blame;
mod by_entry;
mod coasting;
mod decay;
mod detectability;
pub mod drive;
pub mod dynamic;
mod ekf;
mod error;
mod followed;
mod gap;
pub mod kf;
mod landmark;
pub mod landmarks;
pub mod likelihood;
pub mod localizer;
mod lti;
mod nearest_unobservable;
pub mod observability;
mod observer;
mod odometry;
pub mod path_observability;
mod placement;
mod pose_sensors;
pub mod rail;
mod reachability;
mod reading;
pub mod riccati;
mod riccati_limit;
mod scaled;
pub mod slam;
mod staircase;
mod track;
pub mod validate;
mod verdict;
mod wheel;
mod zero_modes;

pub use coasting::{Coasting, PoseAndSpeed};
pub use detectability::Detectability;
pub use ekf::{Localizer, Sighting};
pub use error::{Code, Error};
pub use filters;
pub use geom;
pub use landmark::Landmark;
pub use lti::{Lti, SystemSizes};
pub use nalgebra;
pub use nalgebra::Complex;
pub use observer::{Observer, error_matrix};
pub use odometry::{Ticks, Unicycle, Wheels, odometry_delta, slip_covariance};
pub use placement::{Movable, place_observer_gain};
pub use reachability::Reachability;
pub use reading::{Corrected, Reading, Setup};
pub use riccati_limit::RiccatiLimit;
pub use track::Track;
pub use verdict::Verdict;
pub use wheel::RightWheel;
