//! The numbers that a fit may find, and how it moves them: a σ by its logarithm, a delay as it is.

use crate::drive::course::Course;
use crate::drive::row::{Drive, Event, Motion};
use crate::drive::settings::Settings;
use alloc::vec::Vec;

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
    /// σ_ρ, of a range.
    SigmaRange,
    /// σ_β, of a bearing.
    SigmaBearing,
    /// The delay of the speed.
    DelaySpeed,
    /// The delay of the fixes.
    DelayFix,
    /// The delay of the headings.
    DelayHeading,
    /// The delay of the sightings.
    DelaySighting,
}

/// The least and the greatest σ that is tried.
const SIGMAS: [f64; 2] = [1e-4, 1e3];

impl Fitted {
    /// Those that a drive may tell: of its motion, and of the readings that its course uses.
    pub(crate) fn of(drive: &Drive, course: &Course) -> Vec<Self> {
        let (sensors, s) = (course.sensors(), course.settings());
        let own = |event: &Event| match event {
            Event::Position { sigma, .. } => Some((Self::SigmaFix, sigma.is_some())),
            Event::Heading { sigma, .. } => Some((Self::SigmaHeading, sigma.is_some())),
            _ => None,
        };
        // A σ of all readings is to be found where one has none of its own.
        let open = |which: Self| drive.rows.iter().any(|row| own(&row.event) == Some((which, false)));
        let (fix, heading) = (sensors.fix && s.fixes, sensors.heading && s.headings);
        let (range, bearing) = (sensors.range && s.sightings, sensors.bearing && s.sightings);
        [
            (Self::SigmaFix, fix && open(Self::SigmaFix)),
            (Self::SigmaHeading, heading && open(Self::SigmaHeading)),
            (Self::SigmaRange, range || bearing),
            (Self::SigmaBearing, bearing),
            (Self::DelaySpeed, drive.motion == Motion::Velocity),
            (Self::DelayFix, fix),
            (Self::DelayHeading, heading),
            (Self::DelaySighting, range || bearing),
            (Self::SigmaDistance, true),
            (Self::SigmaTurn, true),
        ]
        .into_iter()
        .filter_map(|(number, told)| told.then_some(number))
        .filter(|_| fix || heading || range || bearing)
        .collect()
    }

    /// Its name among the settings, as a lab has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::SigmaDistance => "sigmaDistance",
            Self::SigmaTurn => "sigmaTurn",
            Self::SigmaFix => "sigmaFix",
            Self::SigmaHeading => "sigmaHeading",
            Self::SigmaRange => "sigmaRange",
            Self::SigmaBearing => "sigmaBearing",
            Self::DelaySpeed => "delaySpeed",
            Self::DelayFix => "delayFix",
            Self::DelayHeading => "delayHeading",
            Self::DelaySighting => "delaySighting",
        }
    }

    /// Whether it is a delay, and not a σ.
    pub fn is_delay(self) -> bool {
        matches!(self, Self::DelaySpeed | Self::DelayFix | Self::DelayHeading | Self::DelaySighting)
    }

    fn place(self, settings: &mut Settings) -> &mut f64 {
        match self {
            Self::SigmaDistance => &mut settings.sigma_distance,
            Self::SigmaTurn => &mut settings.sigma_turn,
            Self::SigmaFix => &mut settings.sigma_fix,
            Self::SigmaHeading => &mut settings.sigma_heading,
            Self::SigmaRange => &mut settings.sigma_range,
            Self::SigmaBearing => &mut settings.sigma_bearing,
            Self::DelaySpeed => &mut settings.delays.speed,
            Self::DelayFix => &mut settings.delays.fix,
            Self::DelayHeading => &mut settings.delays.heading,
            Self::DelaySighting => &mut settings.delays.sighting,
        }
    }

    /// As the search moves it.
    pub(crate) fn get(self, settings: &Settings) -> f64 {
        let mut settings = *settings;
        let value = *self.place(&mut settings);
        if self.is_delay() { value } else { libm::log(value.max(SIGMAS[0])) }
    }

    /// Its value where the search has it at `at`.
    pub(crate) fn value(self, at: f64) -> f64 {
        if self.is_delay() { at } else { libm::exp(at) }
    }

    pub(crate) fn set(self, settings: &mut Settings, at: f64) {
        *self.place(settings) = self.value(at);
    }

    /// How far it is tried, with delays of at most so much.
    pub(crate) fn bounds(self, most: f64) -> [f64; 2] {
        if self.is_delay() { [-most, most] } else { SIGMAS.map(libm::log) }
    }

    /// The first step: half a second at most, or a factor of two.
    pub(crate) fn first_step(self, most: f64) -> f64 {
        if self.is_delay() { (most / 4.0).min(0.5) } else { core::f64::consts::LN_2 }
    }

    /// A step that is fine enough: five milliseconds, or one part in a hundred.
    pub(crate) fn fine(self) -> f64 {
        if self.is_delay() { 0.005 } else { 0.01 }
    }
}
