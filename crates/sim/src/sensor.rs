//! Range and bearing to a landmark.

use crate::noise::Noise;
use estimate::Landmark;
use geom::{SE2, wrap};

/// One landmark seen: Choset's reading, the bearing **from the landmark** to the robot against the robot's heading,
/// atan2(y_r − y_ℓ, x_r − x_ℓ) − θ_r, half a turn from the bearing of the landmark in the robot's own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sighting {
    /// Which landmark it truly is.
    pub landmark: u32,
    /// Metres.
    pub range: f64,
    /// Radians in (−π, π].
    pub bearing: f64,
}

/// What one sensor can see, and how well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LandmarkSensor {
    /// One sigma of the range, metres.
    pub range_sigma: f64,
    /// One sigma of the bearing, radians.
    pub bearing_sigma: f64,
    /// The greatest range at which a landmark is seen, metres.
    pub reach: f64,
}

impl LandmarkSensor {
    /// Whether the landmark is near enough. [`Apartment::in_sight`](crate::Apartment::in_sight) says whether a wall
    /// stands between.
    pub fn reaches(&self, world_from_robot: SE2, landmark: &Landmark) -> bool {
        numerics::hypot(world_from_robot.x() - landmark.x, world_from_robot.y() - landmark.y) <= self.reach
    }

    /// A noisy reading of the landmark: two normal numbers are drawn, the range's first. A range is never negative.
    pub fn sight(&self, world_from_robot: SE2, landmark: &Landmark, noise: &mut Noise) -> Sighting {
        let (dx, dy) = (world_from_robot.x() - landmark.x, world_from_robot.y() - landmark.y);
        let range = numerics::hypot(dx, dy) + self.range_sigma * noise.normal();
        let bearing = libm::atan2(dy, dx) - world_from_robot.theta() + self.bearing_sigma * noise.normal();
        Sighting { landmark: landmark.id, range: range.max(0.0), bearing: wrap(bearing) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_2, PI};

    const EXACT: LandmarkSensor = LandmarkSensor { range_sigma: 0.0, bearing_sigma: 0.0, reach: 2.0 };

    #[test]
    fn the_bearing_is_the_landmark_s() {
        let landmark = Landmark { id: 5, x: 1.0, y: 1.0 };
        // One metre north of the landmark, facing north: the landmark looks north to the robot.
        let seen = EXACT.sight(SE2::new(1.0, 2.0, FRAC_PI_2), &landmark, &mut Noise::new(1));
        assert_eq!((seen.landmark, seen.range), (5, 1.0));
        assert!(seen.bearing.abs() < 1e-15);
        // Half a turn from the bearing in the robot's frame: the landmark is behind.
        let seen = EXACT.sight(SE2::new(1.0, 2.0, -FRAC_PI_2), &landmark, &mut Noise::new(1));
        assert!((seen.bearing - PI).abs() < 1e-15);
    }

    #[test]
    fn the_reach_ends_and_noise_has_its_spread() {
        let landmark = Landmark { id: 0, x: 0.0, y: 0.0 };
        assert!(EXACT.reaches(SE2::new(2.0, 0.0, 0.0), &landmark));
        assert!(!EXACT.reaches(SE2::new(2.0, 0.01, 0.0), &landmark));
        let sensor = LandmarkSensor { range_sigma: 0.1, bearing_sigma: 0.05, reach: 2.0 };
        let mut noise = Noise::new(3);
        let (mut range, mut bearing) = (0.0, 0.0);
        let n = 4000;
        for _ in 0..n {
            let seen = sensor.sight(SE2::new(1.0, 0.0, 0.0), &landmark, &mut noise);
            range += (seen.range - 1.0) * (seen.range - 1.0) / f64::from(n);
            bearing += seen.bearing * seen.bearing / f64::from(n);
        }
        assert!((range / 0.01 - 1.0).abs() < 0.1 && (bearing / 0.0025 - 1.0).abs() < 0.1, "{range} {bearing}");
    }
}
