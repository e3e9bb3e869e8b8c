#![doc = include_str!("../README.md")]
//!
//! # What is where
//!
//! The sister volume's filters, in Thrun's letters: A, B, C the system, R the process covariance, Q the measurement
//! covariance, K the gain, μ and Σ (here `x` and `p`) the belief.
//!
//! - [`Gaussian`], a belief, and [`Kf`], the linear filter that holds one; [`linear`], their algebra. All of it is
//!   written once, over [`Sizes`] fixed at compile time or known at run time only;
//! - [`covariance`]: what counts as a covariance up to rounding, and what is done about the rest;
//! - [`Ekf`], the extended filter, with its [`MotionModel`], [`MeasurementModel`] and [`State`]s on a manifold;
//!   [`ukf`], the unscented one;
//! - [`association`]: which feature a sighting is of;
//! - [`consistency`]: NEES, NIS and their χ² bounds.

#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

pub mod association;
mod autocorrelation;
pub mod consistency;
pub mod covariance;
mod differences;
mod ekf;
mod error;
mod gaussian;
mod kalman;
pub mod linear;
mod manifold;
mod model;
mod rounding;
mod sizes;
mod square_root;
mod terms;
pub mod ukf;
mod update;

pub use autocorrelation::Autocorrelation;
pub use differences::{STEP, central_differences};
pub use ekf::Ekf;
pub use error::{Error, Parameter, Quantity};
pub use gaussian::Gaussian;
pub use kalman::Kf;
pub use manifold::State;
pub use model::{MeasurementModel, MotionModel};
pub use nalgebra;
pub use rounding::{Bound, Conditioning, MAX_ERROR};
pub use sizes::Sizes;
pub use update::Update;
