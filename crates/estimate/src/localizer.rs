//! The EKF localizer for a caller without types: every argument checked, the culprit named, and the object as it was
//! when a call is refused.

mod reading;

pub use reading::{LandmarkReading, Localized, Logged, SensorKind};

use crate::blame::Blame;
use crate::dynamic::Belief;
use crate::ekf::Localizer;
use crate::error::{Code, Error};
use crate::landmark::Landmark;
use crate::reading::{Corrected, Reading, Setup};
use crate::validate;
use alloc::format;
use alloc::vec::Vec;
use filters::Gaussian;
use filters::covariance::is_finite;
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, SVector, Vector2};

/// The most landmarks of a map.
pub const MAX_LANDMARKS: usize = 1000;
/// The most steps of a log that is replayed in one call.
pub const MAX_LOG: usize = 1_000_000;
/// The most comparisons of a reading with a landmark in one log: each reading without a landmark's id is compared with
/// all.
pub const MAX_COMPARISONS: usize = 10_000_000;

/// What the sensor reads, with its noise covariance W.
#[derive(Clone, Copy, Debug, PartialEq)]
enum SensorNoise {
    RangeBearing(Matrix2<f64>),
    Range(f64),
}

/// The localizer of §8.3 among known landmarks.
///
/// # Example
/// ```
/// use estimate::Landmark;
/// use estimate::localizer::{EkfLocalizer, LandmarkReading, SensorKind};
/// use nalgebra::{dmatrix, dvector};
///
/// let p = dmatrix![0.04, 0.0, 0.0; 0.0, 0.04, 0.0; 0.0, 0.0, 0.01];
/// let belief = estimate::validate::belief(dvector![0.0, 0.0, 0.0], p)?;
/// let map = vec![Landmark { id: 7, x: 2.0, y: 0.0 }];
/// let w = dmatrix![0.01, 0.0; 0.0, 0.01];
/// let mut ekf = EkfLocalizer::new(belief, map, w, Some(9.21), SensorKind::RangeBearing)?;
/// ekf.predict(dvector![1.0, 0.0], dmatrix![0.01, 0.0, 0.0; 0.0, 0.01, 0.0; 0.0, 0.0, 0.01])?;
/// let reading = LandmarkReading { range: 0.9, bearing: Some(std::f64::consts::PI), landmark: None };
/// let answer = ekf.update(reading)?;
/// assert!(answer.accepted && answer.landmark == 7);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct EkfLocalizer {
    localizer: Localizer,
    map: Vec<Landmark>,
    sensor: SensorNoise,
    gate: Option<f64>,
}

impl EkfLocalizer {
    /// A localizer with a belief over [x, y, θ], a map of at least one landmark and at most [`MAX_LANDMARKS`], the
    /// sensor's W, and a gate: an upper bound on χ², or none.
    ///
    /// # Errors
    /// Naming the argument: [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`],
    /// [`Code::NotPositiveSemidefinite`]; [`Code::Limit`] for too few or too many landmarks or a gate that is not
    /// positive; [`Code::Index`] for an id given twice.
    pub fn new(
        belief: Belief,
        landmarks: Vec<Landmark>,
        w: DMatrix<f64>,
        gate: Option<f64>,
        sensor: SensorKind,
    ) -> Result<Self, Error> {
        let x = validate::vector(belief.x, 3, "belief.x")?;
        let p = validate::covariance(belief.p, 3, "belief.P")?;
        validate::count(landmarks.len(), MAX_LANDMARKS, "landmarks")?;
        for (i, landmark) in landmarks.iter().enumerate() {
            let blame = Blame::Entry("landmarks", i);
            if landmarks[..i].iter().any(|earlier| earlier.id == landmark.id) {
                let message = format!("is {}, as another landmark's; ids are unique", landmark.id);
                return Err(blame.field(Error::new(Code::Index, "id", message)));
            }
            for (value, name) in [(landmark.x, "x"), (landmark.y, "y")] {
                validate::finite(value, name).map_err(|e| blame.field(e))?;
            }
        }
        if let Some(gate) = gate
            && validate::finite(gate, "gate")? <= 0.0
        {
            return Err(Error::new(Code::Limit, "gate", "a gate on χ² is positive, or null"));
        }
        let sensor = match sensor {
            SensorKind::RangeBearing => {
                let w = validate::covariance(w, 2, "W")?;
                SensorNoise::RangeBearing(Matrix2::from_fn(|i, j| w[(i, j)]))
            }
            SensorKind::Range => SensorNoise::Range(validate::covariance(w, 1, "W")?[0]),
        };
        let belief = Gaussian { x: SVector::from_fn(|i, _| x[i]), p: Matrix3::from_fn(|i, j| p[(i, j)]) };
        Ok(Self { localizer: Localizer::new(&belief), map: landmarks, sensor, gate })
    }

    /// x̂⁺ = [x + Δs cos θ, y + Δs sin θ, θ + Δθ] for `u` = [Δs, Δθ]; P⁺ = FPFᵀ + V with F at the old heading, `v` 3×3
    /// in the state.
    ///
    /// # Errors
    /// Naming u or V: [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`], [`Code::NotPositiveSemidefinite`].
    pub fn predict(&mut self, u: DVector<f64>, v: DMatrix<f64>) -> Result<(), Error> {
        let u = validate::vector(u, 2, "u")?;
        let v = validate::covariance(v, 3, "V")?;
        self.moved(&Vector2::new(u[0], u[1]), &Matrix3::from_fn(|i, j| v[(i, j)]), Blame::Alone)
    }

    /// A prediction, of which u or V is to blame for an overflow: V where there would be none without it.
    fn moved(&mut self, u: &Vector2<f64>, v: &Matrix3<f64>, blame: Blame) -> Result<(), Error> {
        self.localizer.predict(u, v).map_err(|e| {
            let mut again = self.localizer;
            let without_noise = again.predict(u, &Matrix3::zeros());
            e.called(|_| if without_noise.is_ok() { "V".into() } else { blame.name("u") })
        })
    }

    /// Corrects the belief with a reading within the gate; one beyond it leaves the belief alone, whether its landmark
    /// was named or found. A range–bearing reading without an id goes to the likeliest landmark, a range to that of
    /// least χ².
    ///
    /// # Errors
    /// [`Code::NotFinite`], naming the range where its innovation overflows; [`Code::Limit`] for a negative range,
    /// [`Code::Type`] for a bearing that is missing or too many, [`Code::Index`] for an id that is not on the map,
    /// [`Code::AtLandmark`], [`Code::InnovationNotPositiveDefinite`].
    pub fn update(&mut self, reading: LandmarkReading) -> Result<Localized, Error> {
        let before = self.localizer;
        let corrected = self.judge(&reading, Blame::Alone).inspect_err(|_| self.localizer = before)?;
        let Corrected { accepted, landmark, outputs, innovation, s, chi2 } = corrected;
        Ok(Localized {
            accepted,
            landmark: landmark.map_or(0, |j| self.map[j].id),
            innovation: DVector::from_fn(outputs, |i, _| innovation[i]),
            s: DMatrix::from_fn(outputs, outputs, |i, k| s[(i, k)]),
            chi2: chi2?,
        })
    }

    /// Judges a reading, and corrects the belief when it is accepted. On an error the belief may already be corrected,
    /// and the caller restores it. Always in line: of a step in a log nobody asks for the answer, which then is not
    /// written down.
    #[inline(always)]
    fn judge(&mut self, reading: &LandmarkReading, blame: Blame) -> Result<Corrected, Error> {
        let reading = self.checked(reading).map_err(|e| blame.field(e))?;
        let setup = Setup { map: &self.map, scale: Some(0.0), offset: 0.0, gate: self.gate };
        let corrected = self.localizer.correct(&reading, &setup).map_err(|e| blame.step(e))?;
        match corrected.chi2 {
            Ok(_) => Ok(corrected),
            Err(e) => Err(blame.step(e.into())),
        }
    }

    /// The reading with the sensor's W and the landmark's place on the map.
    #[inline(always)]
    fn checked(&self, reading: &LandmarkReading) -> Result<Reading, Error> {
        let range = validate::finite(reading.range, "range")?;
        if range < 0.0 {
            return Err(Error::new(Code::Limit, "range", "a range is not negative"));
        }
        let wrong = |message: &'static str| Err(Error::new(Code::Type, "bearing", message));
        let landmark = || reading.landmark.map(|id| self.index(id)).transpose();
        match (self.sensor, reading.bearing) {
            (SensorNoise::RangeBearing(w), Some(bearing)) => {
                let bearing = validate::finite(bearing, "bearing")?;
                Ok(Reading::RangeBearing { landmark: landmark()?, range, bearing, w })
            }
            (SensorNoise::Range(w), None) => Ok(Reading::Range { landmark: landmark()?, range, w }),
            (SensorNoise::RangeBearing(_), None) => wrong("is missing; this sensor reads range and bearing"),
            (SensorNoise::Range(_), Some(_)) => wrong("is given; this sensor reads the range alone"),
        }
    }

    /// Predicts and corrects once for each step of a log, all with the one `v`, and answers the poses x̂ = [x, y, θ]
    /// after the steps. A reading beyond the gate leaves its step at the prediction.
    ///
    /// # Errors
    /// As [`Self::predict`] and [`Self::update`], the argument naming the step; [`Code::Limit`] for no step, more than
    /// [`MAX_LOG`], or more than [`MAX_COMPARISONS`]. The belief is then what it was before the log.
    pub fn replay(
        &mut self,
        log: impl ExactSizeIterator<Item = Logged>,
        v: DMatrix<f64>,
    ) -> Result<Vec<[f64; 3]>, Error> {
        validate::count(log.len(), MAX_LOG, "log")?;
        let v = validate::covariance(v, 3, "V")?;
        let v = Matrix3::from_fn(|i, j| v[(i, j)]);
        let (mut next, mut poses) = (self.clone(), Vec::with_capacity(log.len()));
        let mut comparisons = 0;
        for (k, logged) in log.enumerate() {
            comparisons += logged.reading.landmark.map_or(self.map.len(), |_| 1);
            if comparisons > MAX_COMPARISONS {
                let message =
                    "compares too many readings with every landmark; name the landmarks, or replay the log in parts";
                return Err(Error::new(Code::Limit, "log", message));
            }
            next.step(&logged, &v, k)?;
            let pose = next.localizer.pose();
            poses.push([pose.x(), pose.y(), pose.theta()]);
        }
        *self = next;
        Ok(poses)
    }

    fn step(&mut self, logged: &Logged, v: &Matrix3<f64>, k: usize) -> Result<(), Error> {
        let blame = Blame::Entry("log", k);
        let u = Vector2::from(logged.u);
        if !is_finite(&u) {
            return Err(blame.field(Error::new(Code::NotFinite, "u", "must hold finite numbers")));
        }
        self.moved(&u, v, blame)?;
        self.judge(&logged.reading, blame).map(|_| ())
    }

    /// Which sensor it has.
    pub fn sensor(&self) -> SensorKind {
        match self.sensor {
            SensorNoise::RangeBearing(_) => SensorKind::RangeBearing,
            SensorNoise::Range(_) => SensorKind::Range,
        }
    }

    /// The present belief, θ in (−π, π].
    pub fn belief(&self) -> Belief {
        let Gaussian { x, p } = self.localizer.belief();
        Belief { x: DVector::from_fn(3, |i, _| x[i]), p: DMatrix::from_fn(3, 3, |i, j| p[(i, j)]) }
    }

    fn index(&self, id: u32) -> Result<usize, Error> {
        let message = || format!("is {id}; no landmark of the map has this id");
        let found = self.map.iter().position(|landmark| landmark.id == id);
        found.ok_or_else(|| Error::new(Code::Index, "landmark", message()))
    }
}

#[cfg(test)]
mod tests;
