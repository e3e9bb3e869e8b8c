//! Kalman SLAM: robot and map in one state (§8.4; Smith, Self and Cheeseman 1990).
//!
//! [`linear_slam`] is the case of §8.4.1, which the plain `Kf` runs as it stands; [`EkfSlam`] is range and bearing on
//! the unicycle (§8.4.2). A sighting touches five entries of the state, so nothing here ever forms HPHᵀ from dense
//! matrices: S comes from a 5×5 block of P, association is O(1) per landmark, and an update costs O(N²). That a
//! landmark is *founded* is what others call its initialization, or the augmentation of the state.

mod correct;
mod found;
mod judge;
pub mod linear_slam;
mod prior;
mod sighting;
mod untyped;

use crate::blame::Blame;
use crate::dynamic::Belief;
use crate::error::{Code, Error};
use crate::odometry::Unicycle;
use crate::validate;
use alloc::vec;
use alloc::vec::Vec;
use filters::association::Thresholds;
use filters::{Gaussian, MotionModel, Quantity};
use geom::{SE2, wrap};
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, U3, Vector2};
use numerics::PackedSymmetric;
use numerics::sqrt;
pub use sighting::{LandmarkReading, Outcome, Report};

/// The largest map.
pub const MAX_LANDMARKS: usize = 500;
/// The most sightings in one step.
pub const MAX_SIGHTINGS: usize = 100;

/// A robot's belief about its pose and the landmarks it has met: `[x, y, θ, x₁, y₁, x₂, y₂, …]`.
///
/// # Example
/// ```
/// use estimate::kf::Gaussian;
/// use estimate::slam::{EkfSlam, Outcome, LandmarkReading};
/// use filters::association::Thresholds;
/// use nalgebra::{Matrix2, Matrix3, Vector3};
/// let belief = Gaussian { x: Vector3::zeros(), p: Matrix3::identity() * 1e-4 };
/// let w = Matrix2::new(0.01, 0.0, 0.0, 0.0009);
/// let mut slam = EkfSlam::new(&belief, &w, Thresholds { gate: 9.21, found: 50.0 })?;
/// let reading = LandmarkReading { range: 3.0, bearing: 0.5, landmark: None };
/// assert_eq!(slam.update(&[reading])?[0].outcome, Outcome::Founded);
/// assert_eq!(slam.update(&[reading])?[0].outcome, Outcome::Matched);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct EkfSlam {
    x: Vec<f64>,
    p: PackedSymmetric,
    ids: Vec<u32>,
    w: Matrix2<f64>,
    thresholds: Thresholds,
    /// Root mean square of the rounding errors that updates have left in P.
    rounding: f64,
    /// νᵀS⁻¹ν of the last update's matched sightings as one stack, and its degrees of freedom.
    nis: (f64, u32),
}

/// A landmark of the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mapped {
    /// Its number.
    pub id: u32,
    /// Where it is believed to be.
    pub position: Vector2<f64>,
    /// The covariance of that, 2×2.
    pub p: Matrix2<f64>,
}

impl EkfSlam {
    /// A robot with this belief about its pose and an empty map; W is 2×2, of a range and a bearing.
    ///
    /// # Errors
    /// [`Code::NotFinite`], [`Code::NotSymmetric`] or [`Code::NotPositiveSemidefinite`] for `belief.x`, `belief.P` or
    /// `W`; [`Code::Limit`] for a threshold that is negative or NaN, and for `found` below a finite gate.
    pub fn new(belief: &Gaussian<U3>, w: &Matrix2<f64>, thresholds: Thresholds) -> Result<Self, Error> {
        let dense = |m: &[f64], n: usize| DMatrix::from_column_slice(n, n, m);
        let belief = Belief { x: DVector::from_column_slice(belief.x.as_slice()), p: dense(belief.p.as_slice(), 3) };
        Self::checked(belief, dense(w.as_slice(), 2), thresholds)
    }

    /// [`Self::new`] for shapes known at run time only.
    fn checked(belief: Belief, w: DMatrix<f64>, thresholds: Thresholds) -> Result<Self, Error> {
        let x = validate::vector(belief.x, 3, "belief.x")?;
        let p = validate::covariance(belief.p, 3, "belief.P")?;
        let w = validate::covariance(w, 2, "W")?;
        for (threshold, name) in [(thresholds.gate, "gate"), (thresholds.found, "found")] {
            let sound = threshold >= 0.0;
            if !sound {
                return Err(Error::new(Code::Limit, name, "is a squared distance: zero or more"));
            }
        }
        if thresholds.gate.is_finite() && thresholds.found < thresholds.gate {
            let message = "is below the gate: a sighting between the two would be of a known landmark and of a new one";
            return Err(Error::new(Code::Limit, "found", message));
        }
        Ok(Self {
            x: vec![x[0], x[1], wrap(x[2])],
            p: PackedSymmetric::from_fn(3, |i, j| p[(i, j)]),
            ids: Vec::new(),
            w: Matrix2::from_fn(|i, j| w[(i, j)]),
            thresholds,
            rounding: f64::EPSILON * p.diagonal().max(),
            nis: (0.0, 0),
        })
    }

    /// The estimated pose.
    pub fn pose(&self) -> SE2 {
        SE2::new(self.x[0], self.x[1], self.x[2])
    }

    /// The pose's block of P.
    pub fn pose_covariance(&self) -> Matrix3<f64> {
        Matrix3::from_fn(|i, j| self.p.get(i, j))
    }

    /// The whole belief: x, and P as a full symmetric matrix.
    pub fn belief(&self) -> (&[f64], DMatrix<f64>) {
        (&self.x, self.p.to_dense())
    }

    /// νᵀS⁻¹ν of the last update's matched sightings as one stack, and its degrees of freedom; none where none was
    /// matched. Each sighting's share is that of its innovation given the ones before it: the shares of a chain add up
    /// to the whole.
    pub fn nis(&self) -> Option<(f64, u32)> {
        (self.nis.1 > 0).then_some(self.nis)
    }

    /// How many landmarks the map holds.
    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// Whether the map is empty.
    pub fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }

    /// The map, in the order in which it was founded.
    pub fn landmarks(&self) -> impl Iterator<Item = Mapped> + '_ {
        self.ids.iter().enumerate().map(|(j, &id)| {
            let c = 3 + 2 * j;
            let position = Vector2::new(self.x[c], self.x[c + 1]);
            Mapped { id, position, p: Matrix2::from_fn(|a, b| self.p.get(c + a, c + b)) }
        })
    }

    /// The pose moves by u = [Δs, Δθ]; V is 3×3, in the pose. F differs from the identity in the pose's rows only, so
    /// this costs O(N).
    ///
    /// # Errors
    /// [`Code::NotFinite`], or [`Code::NotPositiveSemidefinite`] where P would lose its digits; the belief is then as
    /// it was.
    pub fn predict(&mut self, u: &Vector2<f64>, v: &Matrix3<f64>) -> Result<(), Error> {
        let (pose, f) = Unicycle.linearized(&self.pose(), u);
        let pose = pose.to_vector();
        let moved = |row: &[f64]| [row[0] + f[(0, 2)] * row[2], row[1] + f[(1, 2)] * row[2]];
        let cross_is_finite = (3..self.x.len()).all(|i| moved(self.p.row(i)).iter().all(|e| e.is_finite()));
        if !filters::covariance::is_finite(&pose) {
            return Err(filters::Error::NotFinite(Quantity::PredictedMean).into());
        }
        let block = filters::linear::predicted_covariance(&f, &self.pose_covariance(), v)?;
        if !cross_is_finite {
            return Err(filters::Error::NotFinite(Quantity::PredictedCovariance).into());
        }
        let sigma = [0, 1, 2].map(|i| sqrt(self.p.get(i, i)));
        let largest = self.p.diagonal().fold(0.0, f64::max);
        let reach = [0, 1].map(|a: usize| sigma[a] + f[(a, 2)].abs() * sigma[2]).map(|r| r * r);
        let after = self.p.diagonal().skip(3).chain(block.diagonal().iter().copied()).fold(0.0, f64::max);
        let sound = self.guarded(largest.max(reach[0]).max(reach[1]), after, |slam| {
            for i in 3..slam.x.len() {
                let row = slam.p.row_mut(i);
                [row[0], row[1]] = moved(row);
            }
            for i in 0..3 {
                slam.x[i] = pose[i];
                for j in 0..=i {
                    slam.p.set(i, j, block[(i, j)]);
                }
            }
        });
        if sound { Ok(()) } else { Err(digits_lost()) }
    }

    /// The sightings of one step: each is matched, rejected or founds a landmark, all Jacobians at the same prediction.
    /// No landmark is matched twice in a step, and near one that is matched none is founded. What is new is founded
    /// first; then the matched sightings correct the whole state, one after the other with the first linearization,
    /// which equals their stack since W is block-diagonal.
    ///
    /// # Errors
    /// [`Code::Limit`], [`Code::NotFinite`] or [`Code::InnovationNotPositiveDefinite`]; [`Code::AtLandmark`] naming the
    /// landmark that the estimate stands on, or a range of 0 that would found one; [`Code::NotPositiveSemidefinite`]
    /// where P would lose its digits; [`Code::Index`] when two sightings name one landmark. Of several sightings the
    /// name says which: `sightings[1].range`. Belief and map are then as they were.
    pub fn update(&mut self, readings: &[LandmarkReading]) -> Result<Vec<Report>, Error> {
        validate::count(readings.len(), MAX_SIGHTINGS, "sightings")?;
        match readings {
            [one] => {
                let (report, expected) = self.judged(one, &[], Blame::Alone)?;
                let before = core::mem::replace(&mut self.nis, (0.0, 0));
                let done = match expected {
                    Some(expected) => self.correct(&expected, &expected.innovation),
                    None if report.outcome == Outcome::Founded => self.found(one, report.landmark, Blame::Alone),
                    None => Ok(()),
                };
                if done.is_err() {
                    self.nis = before;
                }
                done.map(|()| vec![report]).map_err(|e| Blame::Alone.step(e))
            }
            // Several: a later one may fail, so the work is done on a copy, which costs no more than one of the
            // updates.
            _ => {
                let mut next = self.clone();
                next.nis = (0.0, 0);
                let reports = next.update_all(readings)?;
                *self = next;
                Ok(reports)
            }
        }
    }

    fn update_all(&mut self, readings: &[LandmarkReading]) -> Result<Vec<Report>, Error> {
        let (mut reports, mut matched, mut unfounded) = (Vec::new(), Vec::new(), Vec::new());
        let named: Vec<u32> = readings.iter().filter_map(|r| r.landmark).collect();
        let mut taken: Vec<usize> = named.iter().filter_map(|id| self.index(*id)).collect();
        for (i, reading) in readings.iter().enumerate() {
            let blame = Blame::Entry("sightings", i);
            if reading.landmark.is_some() && readings[..i].iter().any(|earlier| earlier.landmark == reading.landmark) {
                let message = "is named by an earlier sighting of this step";
                return Err(blame.field(Error::new(Code::Index, "landmark", message)));
            }
            let (mut report, expected) = self.judged(reading, &taken, blame)?;
            if let Some(expected) = expected {
                taken.push(expected.j);
                matched.push((blame, expected));
            } else if report.outcome == Outcome::Founded {
                if reading.landmark.is_none() {
                    report.landmark = self.free_id(&named, &reports);
                }
                unfounded.push((blame, reading, report.landmark));
            }
            reports.push(report);
        }
        for (blame, reading, id) in unfounded {
            self.found(reading, id, blame)?;
        }
        let prediction = self.x.clone();
        for (blame, expected) in &matched {
            let moved = expected.moved(&prediction, &self.x);
            let innovation = expected.innovation - expected.h * moved;
            self.correct(expected, &innovation).map_err(|e| blame.step(e))?;
        }
        Ok(reports)
    }

    fn index(&self, id: u32) -> Option<usize> {
        self.ids.iter().position(|i| *i == id)
    }

    /// One more than the greatest number in the map, named in this step, or among its reports.
    fn free_id(&self, named: &[u32], reports: &[Report]) -> Option<u32> {
        let used = self.ids.iter().chain(named).copied().chain(reports.iter().filter_map(|r| r.landmark));
        used.max().map_or(Some(1), |id| id.checked_add(1))
    }

    /// From now on no sighting founds a landmark, unless it names a new one: what would have founded one is rejected.
    pub fn close_map(&mut self) {
        self.thresholds.found = f64::INFINITY;
    }
}

/// The refusal of a change after which P would consist of rounding, since its terms differ too much in size.
fn digits_lost() -> Error {
    let message = "would lose its digits: variances and distances of such different sizes do not fit in one matrix";
    Error::new(Code::NotPositiveSemidefinite, "P", message)
}

#[cfg(test)]
mod tests;
