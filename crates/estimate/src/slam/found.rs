//! A landmark that is new to the map: the state grows by its two coordinates.

use super::sighting::founding;
use super::{EkfSlam, LandmarkReading, MAX_LANDMARKS, digits_lost};
use crate::blame::Blame;
use crate::error::{Code, Error};
use alloc::vec::Vec;
use filters::covariance::symmetric;
use nalgebra::Matrix2x3;
use numerics::sqrt;

impl EkfSlam {
    /// Appends a landmark where the reading puts it, with its covariance and its correlations with everything else.
    pub(super) fn found(&mut self, reading: &LandmarkReading, id: Option<u32>, blame: Blame) -> Result<(), Error> {
        let unnamed = || blame.field(Error::new(Code::Limit, "landmark", "no number is left to call it by"));
        let id = id.ok_or_else(unnamed)?;
        if self.len() == MAX_LANDMARKS {
            return Err(Error::new(Code::Limit, "landmarks", "the map is full: it holds 500"));
        }
        let (position, by_pose, by_reading) = founding(&self.pose(), reading).map_err(|e| blame.field(e))?;
        let n = self.x.len();
        // P_ℓ· = G_x P_r·, of which the new 2×2 corner is G_x P_rr G_xᵀ + G_z W G_zᵀ.
        let cross =
            |by: &Matrix2x3<f64>, a: usize, i: usize| (0..3).map(|k| by[(a, k)] * self.p.get(k, i)).sum::<f64>();
        let rows = [0, 1].map(|a| (0..n).map(|i| cross(&by_pose, a, i)).collect::<Vec<f64>>());
        let corner = symmetric(
            by_pose * self.pose_covariance() * by_pose.transpose() + by_reading * self.w * by_reading.transpose(),
        );
        let all = rows.iter().flatten().chain(corner.iter()).chain(position.iter());
        if all.clone().any(|e| !e.is_finite()) {
            let message = "is too large: the landmark that it would found has an infinite place or covariance";
            return Err(blame.field(Error::new(Code::NotFinite, "range", message)));
        }
        let largest = self.p.diagonal().fold(0.0, f64::max);
        let reach = [0, 1].map(|a: usize| {
            let pose: f64 = (0..3).map(|k| by_pose[(a, k)].abs() * sqrt(self.p.get(k, k))).sum();
            pose + (0..2).map(|k| by_reading[(a, k)].abs() * sqrt(self.w[(k, k)])).sum::<f64>()
        });
        let after = largest.max(corner[(0, 0)]).max(corner[(1, 1)]);
        let [first, second] = rows;
        let scale = largest.max(reach[0] * reach[0]).max(reach[1] * reach[1]);
        let sound = self.guarded(scale, after, |slam| {
            slam.x.extend(position.iter());
            slam.p.push_row(first.into_iter().chain([corner[(0, 0)]]));
            slam.p.push_row(second.into_iter().chain([corner[(1, 0)], corner[(1, 1)]]));
            slam.ids.push(id);
        });
        if sound { Ok(()) } else { Err(digits_lost()) }
    }
}
