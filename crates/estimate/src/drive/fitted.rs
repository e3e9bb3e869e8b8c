//! The numbers that a fit may find, and how it moves them: a σ by its logarithm, others as they are.

use crate::drive::course::Course;
use crate::drive::row::{Drive, Event};
use crate::drive::sensor::Sensor;
use crate::drive::settings::Settings;
use alloc::vec::Vec;
use core::f64::consts::{LN_2, PI};

/// A number that a fit may find.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fitted {
    /// σ_d, of the distance.
    SigmaDistance,
    /// σ_θ, of the turn.
    SigmaTurn,
    /// σ_P, of a fix.
    SigmaFix,
    /// σ_H, of a heading.
    SigmaHeading,
    /// The factor on the σ that fixes bring.
    FixSigmaScale,
    /// The factor on the σ that headings bring.
    HeadingSigmaScale,
    /// σ_ρ, of a range.
    SigmaRange,
    /// σ_β, of a bearing.
    SigmaBearing,
    /// The delay of the speed.
    DelaySpeed,
    /// The delay of the turn rate. A fit holds it: a delay of all together cannot be seen.
    DelayTurn,
    /// The delay of the fixes.
    DelayFix,
    /// The delay of the headings.
    DelayHeading,
    /// The delay of the sightings.
    DelaySighting,
    /// ε, the scale of the ranges.
    Scale,
    /// The offset of the ranges.
    Offset,
    /// What a bearing reads of a landmark straight ahead.
    BearingOffset,
    /// What a compass reads of a robot that heads along the axis of x.
    HeadingOffset,
    /// κ, the scale of the speed.
    SpeedScale,
    /// b, the bias of the turn rate.
    TurnBias,
}

/// The least and the greatest σ that is tried.
const SIGMAS: [f64; 2] = [1e-4, 1e3];

impl Fitted {
    /// All of them.
    pub const ALL: [Self; 19] = [
        Self::SigmaDistance,
        Self::SigmaTurn,
        Self::SigmaFix,
        Self::SigmaHeading,
        Self::FixSigmaScale,
        Self::HeadingSigmaScale,
        Self::SigmaRange,
        Self::SigmaBearing,
        Self::DelaySpeed,
        Self::DelayTurn,
        Self::DelayFix,
        Self::DelayHeading,
        Self::DelaySighting,
        Self::Scale,
        Self::Offset,
        Self::BearingOffset,
        Self::HeadingOffset,
        Self::SpeedScale,
        Self::TurnBias,
    ];

    /// The least σ that is tried.
    pub(crate) const LEAST: f64 = SIGMAS[0];

    /// Those that a fit looks for unless it is told which: of the motion, and of the readings that a course uses.
    pub(crate) fn of(drive: &Drive, course: &Course) -> Vec<Self> {
        let usual = |number: &Self| !matches!(number, Self::SpeedScale | Self::TurnBias | Self::DelayTurn);
        Self::all(drive, course).into_iter().filter(usual).collect()
    }

    /// Those that a drive may tell.
    pub(crate) fn all(drive: &Drive, course: &Course) -> Vec<Self> {
        let (sensors, s) = (course.sensors(), course.settings());
        let own = |event: &Event| match event {
            Event::Position { sigma, .. } => Some((Self::SigmaFix, sigma.is_some())),
            Event::Heading { sigma, .. } => Some((Self::SigmaHeading, sigma.is_some())),
            _ => None,
        };
        // A σ of all readings is to be found where one has none of its own, and a factor on it where one has.
        let there = |which: Self, is: bool| drive.rows.iter().any(|row| own(&row.event) == Some((which, is)));
        let (fix, heading) = (sensors.fix && s.fixes, sensors.heading && s.headings);
        let (range, bearing) = (sensors.range && s.sightings, sensors.bearing && s.sightings);
        let (sighting, held) = (range || bearing, !drive.motion.is_odometry());
        let has = |is: fn(&Event) -> bool| drive.rows.iter().any(|row| is(&row.event));
        let turns = has(|event| matches!(event, Event::Velocity { .. } | Event::TurnRate { .. }));
        let speeds = has(|event| matches!(event, Event::Velocity { .. } | Event::Speed { .. }));
        [
            (Self::SigmaFix, fix && there(Self::SigmaFix, false)),
            (Self::FixSigmaScale, fix && there(Self::SigmaFix, true)),
            (Self::SigmaHeading, heading && there(Self::SigmaHeading, false)),
            (Self::HeadingSigmaScale, heading && there(Self::SigmaHeading, true)),
            (Self::SigmaRange, sighting),
            (Self::SigmaBearing, bearing),
            // Delays are counted from that of the turn rate; where there is none, from the speed's own.
            (Self::DelaySpeed, turns && speeds),
            // A turn rate that is late is no late speed, and no late reading: both would be early by as much.
            (Self::DelayTurn, turns && speeds && (fix || heading || sighting)),
            (Self::DelayFix, fix),
            (Self::DelayHeading, heading),
            (Self::DelaySighting, sighting),
            (Self::Scale, sighting && !s.learn),
            (Self::Offset, sighting),
            (Self::BearingOffset, bearing),
            // Headings alone do not tell a turned compass from a start that was turned.
            (Self::HeadingOffset, heading && (fix || sighting)),
            (Self::SpeedScale, held && !s.learn_speed),
            (Self::TurnBias, held && !s.learn_bias),
            (Self::SigmaDistance, true),
            (Self::SigmaTurn, true),
        ]
        .into_iter()
        .filter_map(|(number, told)| told.then_some(number))
        .filter(|_| fix || heading || sighting)
        .collect()
    }

    /// Its name among the settings, as a lab has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::SigmaDistance => "sigmaDistance",
            Self::SigmaTurn => "sigmaTurn",
            Self::SigmaFix => "sigmaFix",
            Self::SigmaHeading => "sigmaHeading",
            Self::FixSigmaScale => "fixSigmaScale",
            Self::HeadingSigmaScale => "headingSigmaScale",
            Self::SigmaRange => "sigmaRange",
            Self::SigmaBearing => "sigmaBearing",
            Self::DelaySpeed => "delaySpeed",
            Self::DelayTurn => "delayTurn",
            Self::DelayFix => "delayFix",
            Self::DelayHeading => "delayHeading",
            Self::DelaySighting => "delaySighting",
            Self::Scale => "scale",
            Self::Offset => "offset",
            Self::BearingOffset => "bearingOffset",
            Self::HeadingOffset => "headingOffset",
            Self::SpeedScale => "speedScale",
            Self::TurnBias => "turnBias",
        }
    }

    /// Whether it is a delay.
    pub fn is_delay(self) -> bool {
        matches!(self, Self::DelaySpeed | Self::DelayTurn) || self.is_reading_delay()
    }

    /// Whether it is the delay of a sensor's readings, and not of the motion.
    pub(crate) fn is_reading_delay(self) -> bool {
        matches!(self, Self::DelayFix | Self::DelayHeading | Self::DelaySighting)
    }

    /// Whether it is a standard deviation or a factor on some: a fit then says how well the log tells it relative to
    /// itself.
    pub fn is_sigma(self) -> bool {
        !self.is_delay()
            && !matches!(self, Self::Scale | Self::Offset | Self::BearingOffset | Self::HeadingOffset)
            && !matches!(self, Self::SpeedScale | Self::TurnBias)
    }

    /// Whether it is how far fixes may be off.
    pub(crate) fn is_sigma_of_fixes(self) -> bool {
        matches!(self, Self::SigmaFix | Self::FixSigmaScale)
    }

    /// Whose readings bring the standard deviations that it is a factor on.
    pub(crate) fn claimed_by(self) -> Option<Sensor> {
        match self {
            Self::FixSigmaScale => Some(Sensor::Fix),
            Self::HeadingSigmaScale => Some(Sensor::Heading),
            _ => None,
        }
    }

    fn place(self, settings: &mut Settings) -> &mut f64 {
        match self {
            Self::SigmaDistance => &mut settings.sigma_distance,
            Self::SigmaTurn => &mut settings.sigma_turn,
            Self::SigmaFix => &mut settings.sigma_fix,
            Self::SigmaHeading => &mut settings.sigma_heading,
            Self::FixSigmaScale => &mut settings.fix_sigma_scale,
            Self::HeadingSigmaScale => &mut settings.heading_sigma_scale,
            Self::SigmaRange => &mut settings.sigma_range,
            Self::SigmaBearing => &mut settings.sigma_bearing,
            Self::DelaySpeed => &mut settings.delays.speed,
            Self::DelayTurn => &mut settings.delays.turn,
            Self::DelayFix => &mut settings.delays.fix,
            Self::DelayHeading => &mut settings.delays.heading,
            Self::DelaySighting => &mut settings.delays.sighting,
            Self::Scale => &mut settings.scale,
            Self::Offset => &mut settings.offset,
            Self::BearingOffset => &mut settings.bearing_offset,
            Self::HeadingOffset => &mut settings.heading_offset,
            Self::SpeedScale => &mut settings.speed_scale,
            Self::TurnBias => &mut settings.turn_bias,
        }
    }

    /// As the search moves it.
    pub(crate) fn get(self, settings: &Settings) -> f64 {
        let mut settings = *settings;
        let value = *self.place(&mut settings);
        if self.is_sigma() { libm::log(value.max(SIGMAS[0])) } else { value }
    }

    /// Its value where the search has it at `at`.
    pub(crate) fn value(self, at: f64) -> f64 {
        if self.is_sigma() { libm::exp(at) } else { at }
    }

    pub(crate) fn set(self, settings: &mut Settings, at: f64) {
        *self.place(settings) = self.value(at);
    }

    /// How far it is tried, with delays of at most so much.
    pub(crate) fn bounds(self, most: f64) -> [f64; 2] {
        match self {
            // A factor of ten either way: feet and kilometres an hour lie well within.
            Self::Scale | Self::SpeedScale => [-0.9, 9.0],
            Self::Offset => [-1e3, 1e3],
            Self::BearingOffset | Self::HeadingOffset => [-PI, PI],
            Self::TurnBias => [-1.0, 1.0],
            _ if self.is_delay() => [-most, most],
            _ => SIGMAS.map(libm::log),
        }
    }

    /// The first step of a fit: half a second at most, a factor of two of a σ, a few per cent, metres or degrees.
    pub(crate) fn first_step(self, most: f64) -> f64 {
        match self {
            Self::Scale | Self::SpeedScale => 0.02,
            Self::Offset => 0.2,
            Self::BearingOffset | Self::HeadingOffset => 0.05,
            Self::TurnBias => 0.01,
            _ if self.is_delay() => (most / 4.0).min(0.5),
            _ => LN_2,
        }
    }

    /// A step that is fine enough: five milliseconds, one part in a hundred of a σ, a millimetre, 10⁻⁴ of a scale.
    pub(crate) fn fine(self) -> f64 {
        match self {
            Self::Scale | Self::SpeedScale | Self::BearingOffset | Self::HeadingOffset => 1e-4,
            Self::Offset => 1e-3,
            Self::TurnBias => 1e-5,
            _ if self.is_delay() => 0.005,
            _ => 0.01,
        }
    }
}
