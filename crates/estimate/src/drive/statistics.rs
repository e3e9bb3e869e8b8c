//! Sums over the errors and the innovations of a replay, of constant memory however long it is.

use crate::drive::sensor::{BySensor, Sensor};
use crate::error::{Code, Error};
use crate::likelihood::LN_TWO_PI;
use crate::reading::Corrected;
use filters::Autocorrelation;
use nalgebra::{Matrix1, Matrix2, Vector2};
use numerics::{Spd, sqrt};

/// What became of a reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// The sensor.
    pub sensor: Sensor,
    /// Whether it corrected the estimate.
    pub used: bool,
    /// ν₁, the innovation of its first number: x of a fix, the heading, the range.
    pub innovation: f64,
    /// S₁₁, its variance before the reading.
    pub variance: f64,
    /// ν of the second number, a bearing, rad.
    pub bearing: Option<f64>,
    /// ν of the second number, the y of a fix, m.
    pub of_y: Option<f64>,
    /// ν/√S of it.
    pub second: Option<f64>,
    /// ν/√S of a fix along the estimated heading, and to the left of it.
    pub along: Option<[f64; 2]>,
    /// L⁻¹ν with S = L Lᵀ, whose squares add up to d²; 0 where the reading has one number, or S cannot be factored.
    pub white: [f64; 2],
    /// d² = νᵀS⁻¹ν.
    pub d2: f64,
    /// ln det 2πS, infinite of a refused reading whose S cannot be factored.
    pub log_det: f64,
    /// p, the outputs of the reading.
    pub outputs: u32,
}

impl Judged {
    /// What a correction made of a reading, at the heading that was estimated before it.
    pub(crate) fn new(sensor: Sensor, corrected: &Corrected, heading: f64, gated: bool) -> Result<Self, Error> {
        let (nu, s) = (corrected.innovation, corrected.s);
        let outputs = sensor.outputs();
        // A distance too large for a number is beyond every gate; without a gate it cannot be taken.
        let d2 = match corrected.chi2 {
            Ok(d2) => d2,
            Err(_) if gated => f64::INFINITY,
            Err(_) => {
                let name = match sensor {
                    Sensor::Fix => "x",
                    Sensor::Heading => "theta",
                    Sensor::Range | Sensor::Bearing => "range",
                };
                return Err(Error::new(Code::NotFinite, name, "is too large: its squared distance overflows"));
            }
        };
        let ln_determinant = match outputs {
            1 => Spd::new(Matrix1::new(s[(0, 0)])).map(|factor| factor.ln_determinant()),
            _ => Spd::new(s).map(|factor| factor.ln_determinant()),
        };
        let log_det = ln_determinant.map(|ln| f64::from(outputs) * LN_TWO_PI + ln);
        if corrected.accepted && log_det.is_none() {
            let message = "has no likelihood: S is not positive definite to working accuracy";
            return Err(Error::new(Code::InnovationNotPositiveDefinite, "y", message));
        }
        let log_det = log_det.unwrap_or(f64::INFINITY);
        let part = |direction: Vector2<f64>| direction.dot(&nu) / sqrt((direction.transpose() * s * direction)[0]);
        let along = (sensor == Sensor::Fix).then(|| {
            let (sin, cos) = libm::sincos(heading);
            [part(Vector2::new(cos, sin)), part(Vector2::new(-sin, cos))]
        });
        let bearing = (sensor == Sensor::Bearing).then_some(nu[1]);
        let of_y = (sensor == Sensor::Fix).then_some(nu[1]);
        let second = bearing.map(|nu| nu / sqrt(s[(1, 1)]));
        let (innovation, variance) = (nu[0], s[(0, 0)]);
        let white = white(&nu, &s, outputs);
        Ok(Self {
            sensor,
            used: corrected.accepted,
            innovation,
            variance,
            bearing,
            of_y,
            second,
            along,
            white,
            d2,
            log_det,
            outputs,
        })
    }

    /// −½ (ln det 2πS + d²).
    pub fn log_likelihood(&self) -> f64 {
        -0.5 * (self.log_det + self.d2)
    }

    /// ν₁/√S₁₁.
    pub fn normalized(&self) -> f64 {
        self.innovation / sqrt(self.variance)
    }
}

/// L⁻¹ν.
fn white(nu: &Vector2<f64>, s: &Matrix2<f64>, outputs: u32) -> [f64; 2] {
    let root = sqrt(s[(0, 0)]);
    let (first, below) = (nu[0] / root, s[(1, 0)] / root);
    let left = if outputs == 2 { s[(1, 1)] - below * below } else { 0.0 };
    if left > 0.0 { [first, (nu[1] - below * first) / sqrt(left)] } else { [first, 0.0] }
}

/// Sums over the errors of the position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Errors {
    count: u32,
    squares: f64,
    worst: f64,
}

impl Errors {
    pub fn take(&mut self, distance: f64) {
        self.count += 1;
        self.squares += distance * distance;
        self.worst = self.worst.max(distance);
    }

    pub fn count(&self) -> u32 {
        self.count
    }

    pub fn rmse(&self) -> Option<f64> {
        (self.count > 0).then(|| sqrt(self.squares / f64::from(self.count)))
    }

    pub fn worst(&self) -> Option<f64> {
        (self.count > 0).then_some(self.worst)
    }
}

/// Sums over normalized innovations n = ν₁/√S₁₁.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Innovations {
    normalized: Autocorrelation<1>,
    nis: f64,
    refused: u32,
}

impl Innovations {
    /// Takes n and d²/p of a used reading.
    pub fn take(&mut self, n: f64, nis: f64) {
        self.normalized.take(n);
        self.nis += nis;
    }

    pub fn count(&self) -> u32 {
        self.normalized.count()
    }

    pub fn refused(&self) -> u32 {
        self.refused
    }

    pub fn nis(&self) -> Option<f64> {
        (self.count() > 0).then(|| self.nis / f64::from(self.count()))
    }

    pub fn mean(&self) -> Option<f64> {
        self.normalized.mean()
    }

    pub fn lag1(&self) -> Option<f64> {
        self.normalized.at(1)
    }
}

/// The innovations of all readings, and of each sensor's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Statistics {
    pub all: Innovations,
    pub each: BySensor<Innovations>,
    /// Second numbers of sightings.
    pub bearings: Autocorrelation<1>,
    /// Sums over the used fixes.
    pub along: [f64; 2],
    pub log_likelihood: f64,
}

impl Statistics {
    pub fn take(&mut self, judged: &Judged) {
        if !judged.used {
            self.refuse(judged.sensor);
            return;
        }
        let (n, nis) = (judged.normalized(), judged.d2 / f64::from(judged.outputs));
        for sums in [&mut self.all, self.each.of_mut(judged.sensor)] {
            sums.take(n, nis);
        }
        if let Some(second) = judged.second {
            self.bearings.take(second);
        }
        if let Some([along, across]) = judged.along {
            self.along[0] += along;
            self.along[1] += across;
        }
        self.log_likelihood += judged.log_likelihood();
    }

    pub fn refuse(&mut self, sensor: Sensor) {
        self.all.refused += 1;
        self.each.of_mut(sensor).refused += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken(values: &[f64]) -> Innovations {
        let mut sums = Innovations::default();
        values.iter().for_each(|n| sums.take(*n, n * n));
        sums
    }

    #[test]
    fn what_cannot_be_said_is_none() {
        assert_eq!((taken(&[]).nis(), taken(&[]).mean(), taken(&[]).lag1()), (None, None, None));
        assert_eq!((taken(&[3.0]).nis(), taken(&[3.0]).mean(), taken(&[3.0]).lag1()), (Some(9.0), Some(3.0), None));
        assert_eq!((Errors::default().rmse(), Errors::default().worst()), (None, None));
    }
}
