//! Gates that refuse much: they hide a fault, or there are as many outliers.

use crate::drive::evidence::Trial;
use crate::drive::fault::Fault;
use crate::drive::round::Round;
use crate::drive::sensor::{BySensor, Sensor};
use crate::drive::settings::Settings;
use crate::drive::tried::Tried;
use alloc::vec::Vec;

/// A gate that refuses more than this share may hide a fault.
pub(crate) const MUCH: f64 = 0.1;

/// What a verdict does with the gates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Gates {
    /// They are as they are set.
    Set,
    /// They are off, since they refuse much; and how they are set.
    Off(BySensor<Option<f64>>),
    /// They are as they are set, though they refuse much: without them outliers explain most.
    Trusted,
}

impl Gates {
    /// Opens the gates of a round where they refuse much, and has outliers looked for instead; whether it did.
    pub fn open(&mut self, round: &mut Round) -> bool {
        let (Self::Set, Some(base)) = (*self, &round.base) else { return false };
        let set = round.place.settings.gate;
        let refused = |of: &dyn Fn(Sensor) -> bool| base.refused(|sensor| set.of(sensor).is_some() && of(sensor));
        let [share, all] = refused(&|_| true).map(f64::from);
        if share <= MUCH * all {
            return false;
        }
        let sensors = [Sensor::Fix, Sensor::Heading, Sensor::Range, Sensor::Bearing].into_iter();
        let gated: Vec<Sensor> = sensors.filter(|sensor| refused(&|it| it == *sensor)[1] > 0).collect();
        round.tried.extend(gated.into_iter().map(Tried::Outliers));
        round.place.settings.gate = BySensor::all(None);
        round.base = None;
        *self = Self::Off(set);
        true
    }

    /// Puts them back where outliers behind one of them explain most; whether it did.
    pub fn trust(&mut self, round: &mut Round) -> bool {
        let Self::Off(set) = *self else { return false };
        let gated = |sensor: Option<Sensor>| sensor.is_some_and(|sensor| set.of(sensor).is_some());
        let first = round.found.first().map(|(suspect, _)| suspect);
        if !first.is_some_and(|it| it.fault == Fault::Tails && it.excess > 0.0 && gated(it.sensor)) {
            return false;
        }
        let outliers = |tried: &Tried| matches!(tried, Tried::Outliers(sensor) if gated(Some(*sensor)));
        let tried = round.tried.iter().copied().filter(|tried| !outliers(tried)).collect();
        let settings = Settings { gate: set, ..round.place.settings };
        *round = Round::new(Trial { settings, ..round.place }, tried);
        *self = Self::Trusted;
        true
    }
}
