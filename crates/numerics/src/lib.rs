#![doc = include_str!("../README.md")]
//!
//! # What is where
//!
//! The matrix computations under the geometry and the filters. Nothing here knows what a matrix means.
//!
//! - [`Spd`]: the factor LDLᵀ of a positive definite matrix, and solves with it;
//! - [`eigenvalues`] and [`singular_values`]: iterations that end on every finite matrix;
//! - [`PackedSymmetric`]: one triangle of a symmetric matrix that grows by rows;
//! - [`maximum`]: where a smooth function of a few variables is greatest;
//! - [`hypot`], [`sqrt`], [`all_finite`], [`power_of_two`]: single numbers.
//!
//! Transcendental functions go through `libm`, so an answer has the same bits on every platform. Square roots are the
//! machine's: IEEE 754 rounds them correctly everywhere.

#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

mod eigen;
mod error;
mod finite;
mod hypot;
mod maximum;
mod packed;
mod power_of_two;
mod singular;
mod spd;
mod sqrt;

pub use eigen::{eigenvalues, eigenvalues_in_closed_form};
pub use error::Error;
pub use finite::all_finite;
pub use hypot::hypot;
pub use maximum::{Maximum, maximum};
pub use nalgebra;
pub use packed::PackedSymmetric;
pub use power_of_two::power_of_two;
pub use singular::{Singular, singular_values};
pub use spd::{MIN_PIVOT, Spd};
pub use sqrt::sqrt;
