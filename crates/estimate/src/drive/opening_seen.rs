//! A reading of a landmark beside where the motion alone has led, and how far it is from what a start lets expect.

use super::{Replay, Settings};
use geom::wrap;
use nalgebra::{Matrix3, Vector3};

/// A residual of so many σ counts half: outliers do not draw the start to them.
const HALF: f64 = 3.0;

/// A reading beside where the motion alone leads from the origin along x: the landmark is at so far, by so many m.
pub(super) struct Seen {
    pub reckoned: [f64; 3],
    /// How that has drifted since the start.
    pub drift: Matrix3<f64>,
    pub landmark: [f64; 2],
    pub range: f64,
    sigma: f64,
    pub bearing: Option<[f64; 2]>,
    /// The parts of those σ, of range and bearing, that are of the reading itself.
    own: [f64; 2],
}

impl Seen {
    /// A range of a landmark at a place, and a bearing, where a replay from the origin has come to it.
    pub fn new(landmark: [f64; 2], read: (f64, Option<f64>), replay: &Replay, settings: &Settings) -> Self {
        let (pose, covariance) = (replay.pose(), replay.covariance());
        let drift = Matrix3::from_fn(|i, j| covariance.get((i, j)).copied().unwrap_or(0.0));
        // What was reckoned is the less sure the farther the robot has driven.
        let along = 0.5 * replay.place_covariance().trace();
        let [range, bearing] = [settings.sigma_range, settings.sigma_bearing];
        let sigma = libm::sqrt(range * range + along);
        let turned = libm::sqrt(bearing * bearing + drift[(2, 2)]);
        Self {
            reckoned: [pose.x(), pose.y(), pose.theta()],
            drift,
            landmark,
            range: (read.0 - settings.offset) / (1.0 + settings.scale),
            sigma,
            bearing: read.1.map(|read| [read - settings.bearing_offset, turned]),
            own: [range / sigma, bearing / turned],
        }
    }

    /// What is measured less what is expected from a start, in standard deviations, each with its slope.
    pub fn residuals(&self, pose: &Vector3<f64>) -> ([f64; 2], [Vector3<f64>; 2]) {
        let (sin, cos) = libm::sincos(pose[2]);
        let [rx, ry, turned] = self.reckoned;
        // Where the robot was, and how that moves as the start turns.
        let (across, along) = (cos * rx - sin * ry, sin * rx + cos * ry);
        let (dx, dy) = (self.landmark[0] - pose[0] - across, self.landmark[1] - pose[1] - along);
        let distance = libm::hypot(dx, dy).max(1e-6);
        let (ux, uy) = (dx / distance, dy / distance);
        let slope = Vector3::new(ux, uy, uy * across - ux * along) / self.sigma;
        let of_range = (self.range - distance) / self.sigma;
        let Some([bearing, sigma]) = self.bearing else { return ([of_range, 0.0], [slope, Vector3::zeros()]) };
        let expected = libm::atan2(dy, dx) - pose[2] - turned;
        let (px, py) = (-uy / distance, ux / distance);
        let turning = Vector3::new(px, py, py * across - px * along + 1.0) / sigma;
        ([of_range, wrap(bearing - expected) / sigma], [slope, turning])
    }

    /// What it adds to the slope of the cost where the pose at its time has drifted, by the slopes of start and drift,
    /// and what its own noise adds to the covariance of that slope.
    pub fn weighed(&self, pose: &Vector3<f64>) -> [Matrix3<f64>; 2] {
        let (sin, cos) = libm::sincos(pose[2]);
        let turning = [0.0, self.bearing.map_or(0.0, |[_, sigma]| 1.0 / sigma)];
        let (residuals, slopes) = self.residuals(pose);
        let mut sums = [Matrix3::zeros(); 2];
        for i in 0..2 {
            let (slope, weight) = (slopes[i], weight(residuals[i]));
            let along = Vector3::new(cos * slope[0] + sin * slope[1], cos * slope[1] - sin * slope[0], turning[i]);
            sums[0] += slope * along.transpose() * weight;
            sums[1] += slope * slope.transpose() * (weight * self.own[i] * weight * self.own[i]);
        }
        sums
    }
}

/// The weight of a residual: an outlier's is small.
pub(super) fn weight(residual: f64) -> f64 {
    1.0 / (1.0 + residual * residual / (HALF * HALF))
}

/// How badly the readings fit a start: what their likelihood falls by.
pub(super) fn cost(seen: &[Seen], pose: &Vector3<f64>) -> f64 {
    let far = |residual: f64| HALF * HALF * libm::log1p(residual * residual / (HALF * HALF));
    seen.iter().map(|it| it.residuals(pose).0.map(far).iter().sum::<f64>()).sum::<f64>() * 0.5
}
