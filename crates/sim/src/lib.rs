//! The world the robot lives in: apartment, odometry, sensors, seeded noise.
