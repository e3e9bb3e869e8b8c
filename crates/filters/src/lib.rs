//! The sister volume's filters, in Thrun's letters: A, B, C the system, R the process covariance, Q the measurement
//! covariance, K the gain, μ and Σ (here `x` and `p`) the belief.
//!
//! - [`kalman`]: the linear filter, [`kalman::Gaussian`] and [`kalman::Kf`];
//! - [`linear`]: its algebra, written once for fixed and for run-time sizes;
//! - [`nonlinear`]: the extended filter, its models and states on a manifold; [`ukf`]: the unscented one;
//! - [`association`]: which feature a sighting is of;
//! - [`consistency`]: NEES, NIS and their χ² bounds.

pub mod association;
pub mod consistency;
mod error;
pub mod kalman;
pub mod linear;
pub mod nonlinear;
mod square_root;
pub mod ukf;

pub use error::Error;
