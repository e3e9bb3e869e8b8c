//! Readings whose innovations go together count as fewer: those of a receiver that filters its own fixes.
//!
//! N readings whose innovations have the autocorrelation ρ at lag 1, falling by it from each to the next, tell as much
//! as N (1 − ρ)/(1 + ρ) that are independent (Bayley and Hammersley 1946). What a fault gains by them counts by that
//! share.

use crate::drive::evidence::{Evidence, Trial, Weighed};
use crate::drive::fault::Fault;
use crate::drive::fitted::Fitted;
use crate::drive::round::{Round, Scope};
use crate::drive::row::Drive;
use crate::drive::sensor::Sensor;
use crate::drive::suspect::Suspect;

/// The times between readings that are tried, s.
const TIMES: [f64; 8] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
/// Readings that are correlated by less err apart well enough, and so many are left at least.
const APART: f64 = 0.5;
const FEWEST: usize = 12;
/// A σ of the fixes that fits is less than this part of what they claim, where their errors may wander instead.
const LESS: f64 = 0.5;

/// How few of a sensor's readings may be taken, so that their errors do not go together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thinning {
    /// Whose readings.
    pub sensor: Sensor,
    /// The least time between two of them, s.
    pub every: f64,
    /// The autocorrelation of their innovations at lag 1, beside a σ that allows for what is wrong: of all, and of
    /// those.
    pub by: [f64; 2],
    /// How many are used, and how many are independent that tell as much.
    pub counts: [f64; 2],
    /// Whether it is one of two: the fixes may be better than they claim instead.
    pub either: bool,
}

/// d² of a reading.
pub(crate) fn squared(reading: &Weighed) -> f64 {
    reading.white.iter().map(|it| it * it).sum()
}

/// How many innovations of a sensor were used, and their autocorrelation at lag 1.
pub(crate) fn lag1(readings: &[Weighed], sensor: Sensor) -> (usize, f64) {
    let its = || readings.iter().filter(|it| it.sensor == sensor && it.used);
    let power: f64 = its().map(squared).sum();
    let product = |(one, next): (&Weighed, &Weighed)| one.white[0] * next.white[0] + one.white[1] * next.white[1];
    (its().count(), its().zip(its().skip(1)).map(product).sum::<f64>() / power)
}

/// The share of readings that count.
fn share(by: f64) -> f64 {
    if by > 0.0 { (1.0 - by) / (1.0 + by) } else { 1.0 }
}

/// How much less a replay's gain over another one counts, because the innovations of the fixes still go together in it.
pub(crate) fn less(evidence: &Evidence, base: &Evidence, from: u32) -> f64 {
    let (_, by) = lag1(&evidence.readings, Sensor::Fix);
    (1.0 - share(by)) * evidence.gain_of(base, from, |sensor| sensor == Sensor::Fix).max(0.0)
}

/// How far apart fixes are to be taken, beside the σ that a place has; `None` where those that are left would be few.
pub(crate) fn thinning(drive: &Drive, place: &Trial, base: &Evidence, rows: u32) -> Option<Thinning> {
    let sensor = Sensor::Fix;
    let (count, by) = lag1(&base.readings, sensor);
    let now = *place.settings.every.of(sensor);
    TIMES.into_iter().filter(|every| *every > now).find_map(|every| {
        let mut place = *place;
        *place.settings.every.of_mut(sensor) = every;
        let left = lag1(&Evidence::new(drive, &place, rows).ok()?.readings, sensor);
        let few = (FEWEST..count).contains(&left.0) && left.1 < APART;
        few.then(|| Thinning {
            sensor,
            every,
            by: [by, left.1],
            counts: [count as f64, count as f64 * share(by)],
            either: false,
        })
    })
}

/// How far apart fixes are to be taken where a smaller σ of theirs is likeliest, and that may be how little their
/// errors change from one to the next; `None` where a fault explains why they go together.
pub(crate) fn wandering(
    drive: &Drive,
    round: &Round,
    scope: &Scope,
    named: (&[Suspect], &[Trial]),
) -> Option<Thinning> {
    let (suspects, places) = named;
    let (first, rows, base) = (suspects.first()?, scope.rows, round.base.as_ref()?);
    let of_fixes = matches!(first.number, Some(Fitted::SigmaFix | Fitted::FixSigmaScale));
    let smaller = first.sizes.first().is_some_and(|size| size.value < LESS * size.now);
    let correlated = |evidence: &Evidence| lag1(&evidence.readings, Sensor::Fix).1 > APART;
    if first.fault != Fault::Sigma || !of_fixes || !smaller || !correlated(base) {
        return None;
    }
    let faults = suspects.iter().zip(places).filter(|(it, _)| it.fault != Fault::Sigma && it.excess > 0.0);
    let explained = |place: &Trial| Evidence::new(drive, place, rows).is_ok_and(|mended| !correlated(&mended));
    if faults.into_iter().any(|(_, place)| explained(place)) {
        return None;
    }
    thinning(drive, &round.place, base, rows).map(|it| Thinning { either: true, ..it })
}
