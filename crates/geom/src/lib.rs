#![doc = include_str!("../README.md")]
//!
//! # What is where
//!
//! The geometry under the filters: angles, planar poses, covariance ellipses, and the affine set Ω = {x : Hx = y} with
//! the points of it that are nearest to a prediction.
//!
//! Lengths are metres and angles radians throughout; every transcendental function goes through `libm`, so an answer
//! has the same bits on every platform. Square roots need not: IEEE 754 rounds them correctly everywhere.

#![cfg_attr(not(feature = "std"), no_std)]

mod affine_set;
mod angle;
mod ellipse;
mod se2;

pub use affine_set::AffineSet;
pub use angle::{angle_diff, wrap};
pub use ellipse::Ellipse;
pub use nalgebra;
pub use se2::SE2;
