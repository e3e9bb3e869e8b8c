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
use crate::drive::settings::Settings;
use crate::drive::suspect::Suspect;
use crate::drive::tried::Tried;
use alloc::vec::Vec;

/// The times between readings that are tried, s.
const TIMES: [f64; 8] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
/// Readings that are correlated by less err apart well enough, and so many are left at least.
const APART: f64 = 0.5;
const FEWEST: usize = 12;
/// A σ of the fixes that fits is less than this part of what they claim, where their errors may wander instead.
const LESS: f64 = 0.8;
/// The part of the motion's σ that is enough where fixes err apart; and that with which a filter holds to its motion.
const CALM: f64 = 0.5;
const STILL: f64 = 0.1;

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

/// How far apart fixes are to be taken, beside the σ that a place has; `None` where they err apart as it is, and where
/// those that are left would be few.
pub(crate) fn thinning(drive: &Drive, place: &Trial, base: &Evidence, rows: u32) -> Option<Thinning> {
    if lag1(&base.readings, Sensor::Fix).1 <= APART {
        return None;
    }
    spread(drive, place, base, rows).find(|it| it.by[1] < APART)
}

/// Fixes that are taken farther and farther apart, for as long as more than a few are left.
fn spread(drive: &Drive, place: &Trial, base: &Evidence, rows: u32) -> impl Iterator<Item = Thinning> {
    let (sensor, now) = (Sensor::Fix, *place.settings.every.of(Sensor::Fix));
    let (count, by) = lag1(&base.readings, sensor);
    let counts = [count as f64, count as f64 * share(by)];
    TIMES.into_iter().filter(move |every| *every > now).filter_map(move |every| {
        let mut place = *place;
        *place.settings.every.of_mut(sensor) = every;
        let left = lag1(&Evidence::new(drive, &place, rows).ok()?.readings, sensor);
        let some = (FEWEST..count).contains(&left.0);
        some.then_some(Thinning { sensor, every, by: [by, left.1], counts, either: false })
    })
}

/// Whether a smaller σ of the fixes is what a suspect says.
fn is_smaller(suspect: &Suspect) -> bool {
    let of_fixes = suspect.number.is_some_and(Fitted::is_sigma_of_fixes);
    suspect.fault == Fault::Sigma && of_fixes && suspect.sizes.iter().all(|size| size.value < size.now)
}

/// Leaves out a smaller σ of fixes that are taken apart: how little they change tells nothing of how far off they are.
pub(crate) fn without_smaller(settings: &Settings, found: &mut Vec<(Suspect, Trial)>) {
    if *settings.every.of(Sensor::Fix) > 0.0 {
        found.retain(|(suspect, _)| !is_smaller(suspect));
    }
}

/// Whether fixes with the smaller σ that is likeliest err apart: beside that σ, and the faults that explain most then,
/// the readings are likelier with less noise of the motion. What follows errors that wander needs more.
fn err_apart(drive: &Drive, scope: &Scope, (suspects, places): (&[Suspect], &[Trial])) -> bool {
    let Some(mut place) = places.first().copied() else { return false };
    let of = |place: &Trial| Evidence::new(drive, place, scope.rows).ok();
    let calm = |place: &Trial| {
        let mut calm = *place;
        calm.settings.sigma_distance *= CALM;
        calm.settings.sigma_turn *= CALM;
        of(&calm).zip(of(place)).is_some_and(|(calm, usual)| calm.gain(&usual, 0) > 0.0)
    };
    let faults = suspects.iter().filter(|it| it.fault != Fault::Sigma && it.excess > 0.0);
    let mut tried: Vec<Tried> = faults.map(Suspect::tried).collect();
    // One fault hides another: each time the likeliest is mended, and the others are freed anew.
    while !calm(&place) {
        let mut beside = Round::new(place, tried);
        while matches!(beside.step(drive, scope), Ok(true)) {}
        let Round { found, .. } = beside;
        let most = found.iter().max_by(|a, b| a.0.excess.total_cmp(&b.0.excess)).filter(|it| it.0.excess > 0.0);
        let Some((suspect, mended)) = most else { return false };
        (place, tried) = (*mended, found.iter().map(|it| it.0.tried()).filter(|it| *it != suspect.tried()).collect());
    }
    true
}

/// How far apart fixes are to be taken where a smaller σ of theirs is likeliest, or a larger one of the motion beside
/// which they still go together: that may be how little their errors change from one to the next. `None` where a fault
/// explains why they go together.
pub(crate) fn wandering(
    drive: &Drive,
    round: &Round,
    scope: &Scope,
    (suspects, places): (&[Suspect], &[Trial]),
) -> Option<Thinning> {
    let (first, rows, base) = (suspects.first()?, scope.rows, round.base.as_ref()?);
    let correlated = |evidence: &Evidence| lag1(&evidence.readings, Sensor::Fix).1 > APART;
    let alike = |place: &Trial| Evidence::new(drive, place, rows).is_ok_and(|mended| correlated(&mended));
    let of_motion = matches!(first.number, Some(Fitted::SigmaDistance | Fitted::SigmaTurn))
        && first.sizes.iter().all(|size| size.value > size.now);
    let smaller = is_smaller(first) && first.sizes.iter().all(|size| size.value < LESS * size.now);
    if !correlated(base) || !(smaller || of_motion && alike(places.first()?)) {
        return None;
    }
    let mut faults = suspects.iter().zip(places).filter(|(it, _)| it.fault != Fault::Sigma && it.excess > 0.0);
    if faults.any(|(_, place)| !alike(place)) || smaller && err_apart(drive, scope, (suspects, places)) {
        return None;
    }
    // A filter that holds to its motion follows no error that wanders.
    let mut still = round.place;
    still.settings.sigma_distance *= STILL;
    still.settings.sigma_turn *= STILL;
    let all: Vec<Thinning> = spread(drive, &still, base, rows).collect();
    let far = all.iter().find(|it| it.by[1] < APART).or(all.last());
    far.map(|it| Thinning { either: true, ..*it })
}
