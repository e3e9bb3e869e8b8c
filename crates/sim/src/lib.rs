//! The world the robot lives in: apartment, odometry, sensors, seeded noise.
//!
//! - [`Apartment`]: rooms, walls, and the corners on the map;
//! - [`Rusty`]: a differential drive and its encoders;
//! - [`LandmarkSensor`]: noisy range and bearing to a landmark within its reach;
//! - [`paths`]: the courses that the chapter drives;
//! - [`scenarios`]: every constant of every experiment, with where it comes from;
//! - [`Noise`]: seeded normal numbers with the same bits everywhere.

mod apartment;
mod noise;
pub mod paths;
mod rusty;
pub mod scenarios;
mod sensor;

pub use apartment::{Apartment, Room, Wall};
pub use noise::Noise;
pub use rusty::Rusty;
pub use sensor::{LandmarkSensor, Sighting};
