//! One sighting of one landmark of the map: what is expected of it, and where it would put a new one.

use crate::error::{Code, Error};
use crate::landmark::Landmark;
use crate::landmarks::{NEAREST, RangeBearing};
use filters::MeasurementModel;
use geom::{SE2, angle_diff};
use nalgebra::{Matrix2, Matrix2x3, SMatrix, SVector, Vector2};
use numerics::PackedSymmetric;

/// A range and a bearing (Choset's, from the landmark), of a landmark that is named or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LandmarkReading {
    /// Metres, zero or more.
    pub range: f64,
    /// Radians.
    pub bearing: f64,
    /// Which landmark it is of, if that is known.
    pub landmark: Option<u32>,
}

impl LandmarkReading {
    /// # Errors
    /// [`Code::NotFinite`], or [`Code::Limit`] for a negative range.
    pub(super) fn check(&self) -> Result<(), Error> {
        for (value, name) in [(self.range, "range"), (self.bearing, "bearing")] {
            crate::validate::finite(value, name)?;
        }
        if self.range < 0.0 {
            return Err(Error::new(Code::Limit, "range", "is negative; a range is zero or more"));
        }
        Ok(())
    }
}

/// What became of a sighting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It corrected the state.
    Matched,
    /// It founded a landmark.
    Founded,
    /// It was not used: too far from what is known to be of it, too near to be of something new.
    Rejected,
}

/// What an update says of each sighting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// What became of it.
    pub outcome: Outcome,
    /// The landmark matched, founded, or (when rejected) nearest.
    pub landmark: Option<u32>,
    /// ν, S and χ² against that landmark at the prediction; nothing for a new one.
    pub evidence: Option<(Vector2<f64>, Matrix2<f64>, f64)>,
}

/// What is expected of a sighting of a landmark; it depends on five entries of the state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expected {
    pub j: usize,
    /// The nonzero columns of H_j (eq. 8.47): the pose's three and the landmark's two.
    pub h: SMatrix<f64, 2, 5>,
    pub innovation: Vector2<f64>,
    pub s: Matrix2<f64>,
}

impl Expected {
    pub fn new(
        x: &[f64],
        p: &PackedSymmetric,
        j: usize,
        reading: &LandmarkReading,
        w: &Matrix2<f64>,
    ) -> Result<Self, filters::Error> {
        let c = 3 + 2 * j;
        let map = [Landmark { id: 0, x: x[c], y: x[c + 1] }];
        let (model, pose) = (RangeBearing { map: &map }, SE2::new(x[0], x[1], x[2]));
        let (read, by_pose) = model.linearized(&pose, 0)?;
        let mut h = SMatrix::<f64, 2, 5>::zeros();
        h.fixed_columns_mut::<3>(0).copy_from(&by_pose);
        // Only the difference of the two positions enters.
        h.fixed_columns_mut::<2>(3).copy_from(&-by_pose.fixed_columns::<2>(0));
        let innovation = model.residual(&Vector2::new(reading.range, reading.bearing), &read);
        let mut expected = Self { j, h, innovation, s: *w };
        expected.s = expected.innovation_covariance(p, w);
        Ok(expected)
    }

    /// Where in the state H's columns stand.
    pub fn columns(&self) -> [usize; 5] {
        let c = 3 + 2 * self.j;
        [0, 1, 2, c, c + 1]
    }

    /// S = H P Hᵀ + W from the 5×5 block of P.
    pub fn innovation_covariance(&self, p: &PackedSymmetric, w: &Matrix2<f64>) -> Matrix2<f64> {
        let columns = self.columns();
        let block = SMatrix::<f64, 5, 5>::from_fn(|a, b| p.get(columns[a], columns[b]));
        filters::linear::innovation_covariance(&self.h, &block, w)
    }

    /// How far the five entries have moved from `before` to `now`.
    pub fn moved(&self, before: &[f64], now: &[f64]) -> SVector<f64, 5> {
        let mut moved = SVector::<f64, 5>::from_iterator(self.columns().map(|c| now[c] - before[c]));
        moved[2] = angle_diff(now[2], before[2]);
        moved
    }
}

/// Where a reading puts a new landmark, ℓ = r − ρ [cos(θ + β), sin(θ + β)], with the Jacobians by the pose and by the
/// reading.
pub(super) fn founding(
    pose: &SE2,
    reading: &LandmarkReading,
) -> Result<(Vector2<f64>, Matrix2x3<f64>, Matrix2<f64>), Error> {
    let LandmarkReading { range, bearing, .. } = *reading;
    if range < NEAREST {
        let message = "is 0, or next to it: a reading taken on a landmark has no bearing, and cannot found one";
        return Err(Error::new(Code::AtLandmark, "range", message));
    }
    let (sin, cos) = libm::sincos(pose.theta() + bearing);
    let position = Vector2::new(pose.x() - range * cos, pose.y() - range * sin);
    let by_pose = Matrix2x3::new(1.0, 0.0, range * sin, 0.0, 1.0, -range * cos);
    let by_reading = Matrix2::new(-cos, range * sin, -sin, -range * cos);
    Ok((position, by_pose, by_reading))
}
