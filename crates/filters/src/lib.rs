//! The sister volume's filters, in Thrun's letters: A, B, C the system, R the process covariance, Q the measurement
//! covariance, K the gain, μ and Σ (here `x` and `p`) the belief.
//!
//! - [`kalman`]: the linear filter, [`kalman::Gaussian`] and [`kalman::Kf`];
//! - [`linear`]: its algebra, written once for fixed and for run-time sizes;
//! - [`consistency`]: NEES, NIS and their χ² bounds.

pub mod consistency;
mod error;
mod jacobi;
pub mod kalman;
pub mod linear;
mod square_root;

pub use error::Error;
