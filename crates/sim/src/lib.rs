//! The world the robot lives in: apartment, odometry, sensors, seeded noise.

mod noise;

pub use noise::Noise;
