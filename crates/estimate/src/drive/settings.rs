//! What a replay is told about the robot and its sensors.

use crate::error::{Code, Error};
use crate::validate::finite;

/// The noise of motion and sightings, the gate, and the calibration of the ranges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// σ_d: standard deviation of the distance driven, m for each √s.
    pub sigma_distance: f64,
    /// σ_θ: standard deviation of the turn, rad for each √s.
    pub sigma_turn: f64,
    /// σ_ρ: standard deviation of a range, m.
    pub sigma_range: f64,
    /// σ_β: standard deviation of a bearing, rad.
    pub sigma_bearing: f64,
    /// The probability whose χ² quantile a sighting's d² may not exceed; `None` takes every sighting.
    pub gate: Option<f64>,
    /// ε in the expected range (1 + ε) ρ + offset, where it is not learned.
    pub scale: f64,
    /// m.
    pub offset: f64,
    /// Whether ε is a fourth state, which starts at 0 with the standard deviation 0.1 and gets no process noise.
    pub learn: bool,
    /// Whether sightings correct the estimate; without them the replay is dead reckoning.
    pub sightings: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            sigma_distance: 0.05,
            sigma_turn: 0.02,
            sigma_range: 0.6,
            sigma_bearing: 0.05,
            gate: None,
            scale: 0.0,
            offset: 0.0,
            learn: false,
            sightings: true,
        }
    }
}

impl Settings {
    /// # Errors
    /// [`Code::NotFinite`] or [`Code::Limit`] naming the first setting that is out of bounds.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let limit = |sound, name: &'static str, message: &'static str| {
            if sound { Ok(()) } else { Err(Error::new(Code::Limit, name, message)) }
        };
        for (name, sigma) in [("sigmaDistance", self.sigma_distance), ("sigmaTurn", self.sigma_turn)] {
            limit(finite(sigma, name)? >= 0.0, name, "is negative; a standard deviation is at least 0")?;
        }
        for (name, sigma) in [("sigmaRange", self.sigma_range), ("sigmaBearing", self.sigma_bearing)] {
            limit(finite(sigma, name)? > 0.0, name, "is not positive; a sensor's standard deviation is above 0")?;
        }
        finite(self.offset, "offset")?;
        limit(finite(self.scale, "scale")? > -1.0, "scale", "is -1 or less; ranges would not grow with the distance")?;
        let probable = self.gate.is_none_or(|p| p > 0.0 && p < 1.0);
        limit(probable, "gate", "is no probability; it must lie between 0 and 1, or be absent")
    }
}
