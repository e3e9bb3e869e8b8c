//! What a replay is told about the robot and its sensors.

use crate::drive::row::Motion;
use crate::drive::sensor::BySensor;
use crate::error::{Code, Error};
use crate::scaled::FIRST_SIGMA;
use crate::validate::finite;
use alloc::format;

/// The longest delay of a sensor either way, s.
pub const MAX_DELAY: f64 = 10.0;

/// The farthest that an antenna may stand from the point about which the robot turns, either way, m.
pub const MAX_ARM: f64 = 100.0;

/// How late each sensor's rows are: one stamped t was measured at t less the delay. Seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Delays {
    /// Of `S` rows and of the speed of `V` rows. A command leads the motion, so its delay is negative.
    pub speed: f64,
    /// Of `T` rows and of the turn rate of `V` rows.
    pub turn: f64,
    /// Of fixes.
    pub fix: f64,
    /// Of headings.
    pub heading: f64,
    /// Of ranges, with or without a bearing.
    pub sighting: f64,
}

/// The noise of motion and readings, delays, gates, and what is calibrated or learned.
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
    /// σ_P: standard deviation of a fix that has none of its own, m.
    pub sigma_fix: f64,
    /// σ_H: standard deviation of a heading that has none of its own, rad.
    pub sigma_heading: f64,
    /// A fix that brings a standard deviation has one so many times as large.
    pub fix_sigma_scale: f64,
    /// A heading that brings a standard deviation has one so many times as large.
    pub heading_sigma_scale: f64,
    /// Standard deviation of x and of y at the start, m.
    pub start_sigma: f64,
    /// Standard deviation of the heading at the start, rad.
    pub start_sigma_heading: f64,
    /// The pose `[x, y, θ]` at the start of a log without truth; `None` is the origin.
    pub start: Option<[f64; 3]>,
    /// The probability whose χ² quantile a reading's d² may not exceed; `None` takes every reading.
    pub gate: BySensor<Option<f64>>,
    /// A row is passed over where its stamp is less than this after that of the last of its sensor that was not, s.
    pub every: BySensor<f64>,
    /// ε in the expected range (1 + ε) ρ + offset, where it is not learned.
    pub scale: f64,
    /// m.
    pub offset: f64,
    /// What a bearing reads of a landmark straight ahead, rad.
    pub bearing_offset: f64,
    /// What a compass reads of a robot that heads along the axis of x, rad.
    pub heading_offset: f64,
    /// Where the antenna stands whose position a fix is: so far ahead of the robot's pose, and to its left, m.
    pub antenna: [f64; 2],
    /// Whether ε is a state, which starts at 0 with the standard deviation 0.1 and gets no process noise.
    pub learn: bool,
    /// Whether sightings correct the estimate.
    pub sightings: bool,
    /// Whether fixes do.
    pub fixes: bool,
    /// Whether headings do.
    pub headings: bool,
    /// How late each sensor is.
    pub delays: Delays,
    /// κ: the robot drives (1 + κ) times the speed that is read. Of held motion alone, where it is not learned.
    pub speed_scale: f64,
    /// b: the robot turns by the rate that is read less b, rad/s. Of held motion alone, where it is not learned.
    pub turn_bias: f64,
    /// Whether κ is a state, which starts at 0 with the standard deviation 0.1 and gets no process noise.
    pub learn_speed: bool,
    /// Whether b is a state, which starts at 0 with the standard deviation 0.02 rad/s and gets no process noise.
    pub learn_bias: bool,
    /// Fixes stamped between these two times do not correct the estimate: their distances from it are its test.
    pub withheld: Option<[f64; 2]>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            sigma_distance: 0.05,
            sigma_turn: 0.02,
            sigma_range: 0.6,
            sigma_bearing: 0.05,
            sigma_fix: 1.0,
            sigma_heading: 0.05,
            fix_sigma_scale: 1.0,
            heading_sigma_scale: 1.0,
            start_sigma: FIRST_SIGMA[0],
            start_sigma_heading: FIRST_SIGMA[2],
            start: None,
            gate: BySensor::all(None),
            every: BySensor::all(0.0),
            scale: 0.0,
            offset: 0.0,
            bearing_offset: 0.0,
            heading_offset: 0.0,
            antenna: [0.0; 2],
            learn: false,
            sightings: true,
            fixes: true,
            headings: true,
            delays: Delays::default(),
            speed_scale: 0.0,
            turn_bias: 0.0,
            learn_speed: false,
            learn_bias: false,
            withheld: None,
        }
    }
}

impl Settings {
    /// The same without any sensor but those of motion, and with nothing learned: dead reckoning.
    #[must_use]
    pub fn reckoning(self) -> Self {
        let off = Self { learn: false, learn_speed: false, learn_bias: false, withheld: None, ..self };
        Self { sightings: false, fixes: false, headings: false, ..off }
    }

    /// The standard deviation of a fix, m, by the one that it brings.
    pub(crate) fn of_fix(&self, own: Option<f64>) -> f64 {
        own.map_or(self.sigma_fix, |sigma| sigma * self.fix_sigma_scale)
    }

    /// That of a heading, rad.
    pub(crate) fn of_heading(&self, own: Option<f64>) -> f64 {
        own.map_or(self.sigma_heading, |sigma| sigma * self.heading_sigma_scale)
    }

    /// # Errors
    /// [`Code::NotFinite`] or [`Code::Limit`] naming the first setting that is out of bounds, or that asks of `motion`
    /// what it has not.
    pub(crate) fn check(&self, motion: Motion) -> Result<(), Error> {
        for (name, sigma) in [("sigmaDistance", self.sigma_distance), ("sigmaTurn", self.sigma_turn)] {
            limit(finite(sigma, name)? >= 0.0, name, "is negative; a standard deviation is at least 0")?;
        }
        for (name, sigma) in [
            ("sigmaRange", self.sigma_range),
            ("sigmaBearing", self.sigma_bearing),
            ("sigmaFix", self.sigma_fix),
            ("sigmaHeading", self.sigma_heading),
            ("fixSigmaScale", self.fix_sigma_scale),
            ("headingSigmaScale", self.heading_sigma_scale),
            ("startSigma", self.start_sigma),
            ("startSigmaHeading", self.start_sigma_heading),
        ] {
            limit(finite(sigma, name)? > 0.0, name, "is not positive; this standard deviation is above 0")?;
        }
        for (name, number) in
            [("offset", self.offset), ("bearingOffset", self.bearing_offset), ("headingOffset", self.heading_offset)]
        {
            finite(number, name)?;
        }
        for (name, scale) in [("scale", self.scale), ("speedScale", self.speed_scale)] {
            limit(finite(scale, name)? > -1.0, name, "is -1 or less; what is read would not grow with what is true")?;
        }
        finite(self.turn_bias, "turnBias")?;
        for (name, arm) in [("antennaAhead", self.antenna[0]), ("antennaLeft", self.antenna[1])] {
            if finite(arm, name)?.abs() > MAX_ARM {
                return Err(Error::new(Code::Limit, name, format!("is beyond {MAX_ARM} m either way")));
            }
        }
        for number in self.start.into_iter().flatten() {
            finite(number, "start")?;
        }
        for (sensor, gate) in self.gate.each() {
            let probable = gate.is_none_or(|p| p > 0.0 && p < 1.0);
            let message = "is no probability; it must lie between 0 and 1, or be absent";
            limit(probable, "gate", message).map_err(|e| of_sensor(e, sensor, self.gate.is_one()))?;
        }
        for (sensor, every) in self.every.each() {
            let message = "is negative; a time between readings is at least 0";
            finite(*every, "every")
                .and_then(|every| limit(every >= 0.0, "every", message))
                .map_err(|e| of_sensor(e, sensor, self.every.is_one()))?;
        }
        if let Some([from, to]) = self.withheld {
            let (from, to) = (finite(from, "withheld")?, finite(to, "withheld")?);
            limit(from <= to, "withheld", "ends before it begins")?;
        }
        self.check_delays()?;
        if motion.is_odometry() { self.check_odometry() } else { Ok(()) }
    }

    fn check_delays(&self) -> Result<(), Error> {
        let Delays { speed, turn, fix, heading, sighting } = self.delays;
        for (name, delay) in [
            ("delaySpeed", speed),
            ("delayTurn", turn),
            ("delayFix", fix),
            ("delayHeading", heading),
            ("delaySighting", sighting),
        ] {
            let message = format!("is beyond {MAX_DELAY} s either way");
            if finite(delay, name)?.abs() > MAX_DELAY {
                return Err(Error::new(Code::Limit, name, message));
            }
        }
        Ok(())
    }

    /// What says how speeds and turn rates are read says nothing of distances and turns.
    fn check_odometry(&self) -> Result<(), Error> {
        for (name, asked) in [
            ("speedScale", self.speed_scale != 0.0),
            ("turnBias", self.turn_bias != 0.0),
            ("learnSpeed", self.learn_speed),
            ("learnBias", self.learn_bias),
            ("delaySpeed", self.delays.speed != 0.0),
            ("delayTurn", self.delays.turn != 0.0),
        ] {
            limit(!asked, name, "is of speeds and turn rates; this log moves by odometry, which has neither")?;
        }
        Ok(())
    }
}

fn limit(sound: bool, name: &'static str, message: &'static str) -> Result<(), Error> {
    if sound { Ok(()) } else { Err(Error::new(Code::Limit, name, message)) }
}

/// Names the sensor that a setting was refused for, unless it is `one` for all.
fn of_sensor(mut error: Error, sensor: &str, one: bool) -> Error {
    if !one {
        error.argument = format!("{}.{sensor}", error.argument).into();
    }
    error
}
