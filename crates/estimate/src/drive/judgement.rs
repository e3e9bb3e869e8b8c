//! What a verdict has found, and what is told by the truth of it.

use crate::drive::course::Otherwise;
use crate::drive::evidence::{Against, Evidence, Trial};
use crate::drive::fault::Fault;
use crate::drive::fitted::Fitted;
use crate::drive::flat::flat;
use crate::drive::gaps::{self, Gaps};
use crate::drive::noise::Noise;
use crate::drive::round::{Round, Scope};
use crate::drive::row::{Drive, Event, Motion, Row};
use crate::drive::suspect::{Standing, Suspect};
use crate::drive::thinning::Thinning;
use crate::drive::weight::ranked;
use crate::error::Error;
use alloc::vec::Vec;

/// A mended filter that is farther from the truth than before, by this ratio, is not mended.
const WORSE: f64 = 1.05;
const FOR_THE_CLAIM: f64 = 1.3;
/// Where neither the error nor the NEES changes by this ratio, the truth says nothing.
const SILENT: f64 = 1.01;
/// One with a NEES beyond this still has a fault, unless the error has fallen by this ratio meanwhile.
const WILD: f64 = 20.0;
const BETTER: f64 = 0.9;
/// A delay of so many times what the motion model may have is not its own; one that gains less than this beyond it is.
const MOST_OWN: f64 = 4.0;
const AS_MUCH: f64 = 0.5;
/// So many delays are looked at for stairs: those that a sentence may name.
const NAMED: usize = 2;
/// One whose NEES is what is expected, to within this logarithm, claims what it is: a σ is not refuted by so little.
const CLAIMED: f64 = 0.1;
/// What is expected of the NEES of a position.
const EXPECTED: f64 = 2.0;

/// What a verdict has found so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// All that was looked for, the likeliest fault first.
    pub suspects: Vec<Suspect>,
    /// How many readings were counted, and among how many rows.
    pub readings: u32,
    /// Rows that were judged: those from the first on, [`MOST_JUDGED`](super::MOST_JUDGED) at most.
    pub rows: u32,
    /// Suspects that have been tried, and how many there are.
    pub tried: [u32; 2],
    /// How far the filter is from the truth as it is set; `None` without a truth.
    pub against: Option<Against>,
    /// Whether gates are off meanwhile, because they refuse too much.
    pub ungated: bool,
    /// Whether what the first suspects gain is counted beside a σ that is enlarged.
    pub beside: bool,
    /// How few of the fixes may be taken for their errors not to go together, where no fault is told because they do,
    /// or where a smaller σ of theirs may be that.
    pub thinning: Option<Thinning>,
    /// By how much the log-likelihood rises where the robot turns on its way between two rows of motion, where that is
    /// more than chance: the motion model drives straight and turns then. The suspects are freed beside it.
    pub arcs: Option<f64>,
    /// The median time between rows of motion, s. A delay of at most half of it is the model's own.
    pub period: f64,
    /// How long a delay may be the motion model's own, s: half of that, or all of it.
    pub own_delay: f64,
    /// The mean distance of a second in which the robot drives, m: what σ of the distance is to be held against.
    pub pace: f64,
    /// As that of a [`FitResult`](super::FitResult), rad; 0 where the sizes are those of a robot that turns on its way.
    pub half_turn: f64,
    /// What of the innovations does not look like noise, once all was looked at.
    pub noise: Noise,
    /// Where no motion was read: what is held there looks like a fault of the motion.
    pub gaps: Vec<Gaps>,
    /// Whether no suspect, mended, brings the filter nearer to the truth: something else is wrong.
    pub other: bool,
}

/// Whether the truth says that a remedy is none: one of the error and what is claimed of it gets worse and the other
/// no better, or the error grows, or the filter stays as far from its claims as nothing but another fault explains. A
/// σ is mended for the sake of the claim: where that is twice as near, the error may grow a little.
pub(crate) fn refuted(fault: Fault, before: &Against, after: &Against) -> bool {
    let far = |against: &Against| libm::log(against.nees / EXPECTED).abs();
    let (share, farther) = (after.rmse / before.rmse, far(after) >= far(before));
    let claims = fault == Fault::Sigma && far(after) + core::f64::consts::LN_2 < far(before);
    let worse = if claims { FOR_THE_CLAIM } else { WORSE };
    let right = fault == Fault::Sigma && far(after) < CLAIMED;
    let silent = share < SILENT && far(after) < far(before) + libm::log(SILENT);
    share > worse || (share >= 1.0 && farther && !right && !silent) || (after.nees > WILD && share > BETTER)
}

/// By how much the readings of a round are likelier for a robot that turns on its way, where that is more than any
/// suspect brings by itself, or more than chance once the likeliest, a clock or a turned sensor, is mended: what is
/// held puts the one off, and a robot that drives on before it turns looks like the other.
pub(crate) fn turning(drive: &Drive, round: &Round, scope: &Scope) -> Option<f64> {
    let with = |place: &Trial, arcs| {
        let place = Trial { otherwise: Otherwise { arcs, ..place.otherwise }, ..*place };
        Evidence::new(drive, &place, scope.rows).ok()
    };
    // A turn rate that comes half a step early is what a turn on the way looks like.
    let others = |(suspect, _): &&(Suspect, Trial)| {
        suspect.number != Some(Fitted::DelayTurn) && !suspect.is_small_arm(scope.arm)
    };
    let (chance, found) = (scope.chance[0], || round.found.iter().filter(others));
    let alone = with(&round.place, true)?.gain(round.base.as_ref()?, 0);
    if alone > found().map(|(suspect, _)| suspect.gain).fold(chance, f64::max) {
        return Some(alone);
    }
    let (first, mended) = found().find(|(suspect, _)| suspect.fault != Fault::Sigma)?;
    let more = with(mended, true)?.gain(&with(mended, false)?, 0);
    (matches!(first.fault, Fault::Clock | Fault::Turned) && more > chance).then_some(more)
}

/// What a reader has who mends no more than this: the robot turns where it does, and what is the model's own stays.
pub(crate) fn as_mended(place: &Trial, own: &[Suspect]) -> Trial {
    let mut mended = Trial { otherwise: Otherwise { arcs: false, ..place.otherwise }, ..*place };
    for suspect in own {
        let set = suspect.tried().numbers().into_iter().zip(&suspect.sizes);
        set.for_each(|(number, size)| number.set(&mut mended.settings, size.now));
    }
    mended
}

/// Takes off a suspect's gain what it does not gain for the filter as it is used, which neither turns on the way nor
/// knows what of a delay is the model's own: its σ make up for that.
pub(crate) fn for_the_filter(drive: &Drive, round: &mut Round, own: &[Suspect], scope: &Scope) -> Result<(), Error> {
    if own.is_empty() && !round.place.otherwise.arcs {
        return Ok(());
    }
    let base = Evidence::new(drive, &as_mended(&round.place, own), scope.rows)?;
    for (suspect, place) in round.found.iter_mut().filter(|(suspect, _)| suspect.excess > 0.0) {
        let from = if suspect.tried().delays() { scope.from } else { 0 };
        let used = Evidence::new(drive, &as_mended(place, own), scope.rows);
        let less = used.map_or(suspect.gain, |used| (suspect.gain - used.gain(&base, from)).max(0.0));
        (suspect.gain, suspect.excess) = (suspect.gain - less, suspect.excess - less);
    }
    round.found = ranked(core::mem::take(&mut round.found));
    Ok(())
}

/// The settings that a suspect delays, and by how much; `None` of what is no delay.
fn delayed(suspect: &Suspect) -> Option<(Vec<Fitted>, f64)> {
    let size = suspect.sizes.first().filter(|_| suspect.fault == Fault::Clock)?;
    Some((suspect.tried().numbers(), size.value - size.now))
}

/// How long a delay the motion model may have as its own, with motion about every `period` seconds. The robot drives
/// straight and turns then, which is half a step; a speed or turn rate is held for a step besides, which is another.
/// What is driven evenly has none.
pub(crate) fn own_delay(motion: Motion, arcs: bool, period: f64) -> f64 {
    match motion {
        Motion::EvenOdometry | Motion::EvenVelocity => 0.0,
        Motion::Velocity if !arcs => period,
        _ => 0.5 * period,
    }
}

/// Whether a suspect is the motion model's own: a delay of at most `half` a step, or a longer one that makes the
/// readings no likelier than that does. Of a delay that was set it may be known already how much is the model's, or
/// not.
pub(crate) fn is_own(drive: &Drive, suspect: &Suspect, round: &Round, scope: &Scope, half: f64) -> bool {
    if suspect.sizes.iter().any(|size| size.now != 0.0) {
        return false;
    }
    // One that is not known to be longer is not.
    let more = suspect.sizes.first().map_or(0.0, |size| (2.0 * size.sigma).min(0.3 * half));
    delayed(suspect).is_some_and(|(_, off)| off.abs() <= half + more)
        || beyond_own(drive, suspect, round, scope, half).is_some_and(|gain| gain <= AS_MUCH)
}

/// By how much a short delay makes the readings likelier than what is the model's own the same way; `None` of others.
fn beyond_own(drive: &Drive, suspect: &Suspect, round: &Round, scope: &Scope, own: f64) -> Option<f64> {
    let (numbers, off) = delayed(suspect).filter(|(_, off)| off.abs() <= MOST_OWN * own)?;
    let mut place = round.place;
    for number in &numbers {
        let to = number.get(&place.settings) + own.copysign(off);
        number.set(&mut place.settings, to);
    }
    let by_own = Evidence::new(drive, &place, scope.rows).ok()?.gain(round.base.as_ref()?, scope.from);
    Some(suspect.gain - by_own)
}

/// Says of short delays that they may be the motion model's own: those that are no longer than such a one may be
/// (`own`), and those that make the readings no likelier than that one and chance do.
pub(crate) fn may_be_own(drive: &Drive, suspects: &mut [Suspect], round: &Round, scope: &Scope, own: f64) {
    for suspect in suspects.iter_mut().filter(|it| it.standing != Standing::Cleared) {
        let all = delayed(suspect).is_some_and(|(_, off)| off.abs() <= own);
        if all || beyond_own(drive, suspect, round, scope, own).is_some_and(|gain| gain <= scope.chance[1]) {
            (suspect.own, suspect.standing) = (true, Standing::Maybe);
        }
    }
}

/// So much of the gain is left, where an antenna's place is told without the delay that was found with it.
const HALF: f64 = 0.5;

/// Leaves the delay as it is that was found with an antenna's place, where that may be the motion model's own.
pub(crate) fn own_delay_left(
    drive: &Drive,
    suspects: &mut [Suspect],
    places: &mut [Trial],
    round: &Round,
    scope: &Scope,
    own: f64,
) {
    let Some(base) = &round.base else { return };
    let both = suspects.iter_mut().zip(places).filter(|(it, _)| it.fault == Fault::Antenna);
    for (suspect, place) in both {
        let (Some(delay), [_, _, late]) = (suspect.with, suspect.sizes.as_mut_slice()) else { continue };
        // Of a delay that was set it may be known already how much is the model's, or not.
        if late.now != 0.0 || late.value.abs() > own + (2.0 * late.sigma).min(0.3 * own) {
            continue;
        }
        let mut left = *place;
        delay.set(&mut left.settings, 0.0);
        let gain = Evidence::new(drive, &left, scope.rows).map_or(0.0, |it| it.gain(base, scope.from));
        if gain < HALF * suspect.gain {
            continue;
        }
        (late.value, *place) = (0.0, left);
        suspect.excess -= suspect.gain - gain;
        suspect.gain = gain;
    }
}

/// Says of the likeliest delays how far the readings tell them at all.
pub(crate) fn stairs(drive: &Drive, suspects: &mut [Suspect], places: &[Trial], scope: &Scope) {
    let clocks = suspects.iter_mut().zip(places);
    let clocks = clocks.filter(|(it, _)| it.fault == Fault::Clock && it.standing != Standing::Cleared);
    for (suspect, place) in clocks.take(NAMED) {
        let Some(begin) = suspect.sizes.first().map(|size| size.value) else { continue };
        let numbers = suspect.tried().numbers();
        let value = |to: f64| {
            let mut place = *place;
            for number in &numbers {
                let now = number.get(&place.settings);
                number.set(&mut place.settings, now + to - begin);
            }
            let evidence = Evidence::new(drive, &place, scope.rows).ok()?;
            Some(evidence.readings.iter().filter(|it| it.row >= scope.from).map(|it| it.log_likelihood).sum())
        };
        suspect.flat = flat(drive, begin, value);
    }
}

/// The median time between rows of motion, s: of speeds or of turn rates, whichever come less often.
pub(crate) fn period(rows: &[Row]) -> f64 {
    let speeds = median(rows, |event| !matches!(event, Event::TurnRate { .. }));
    speeds.max(median(rows, |event| !matches!(event, Event::Speed { .. })))
}

fn median(rows: &[Row], of: impl Fn(&Event) -> bool) -> f64 {
    let times: Vec<f64> = rows.iter().filter(|row| row.event.is_motion() && of(&row.event)).map(|it| it.time).collect();
    gaps::median(times.windows(2).map(|pair| pair[1] - pair[0]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_truth_refuses_what_makes_it_worse_and_says_nothing_where_next_to_nothing_changes() {
        let of = |rmse, nees| Against { rmse, nees, outside: 0.1 };
        let refuses = |after| refuted(Fault::Bias, &of(1.0, 2.3), &after);
        assert!(refuses(of(1.06, 2.0)), "the error");
        assert!(refuses(of(1.02, 2.4)) && refuses(of(1.0, 2.4)), "neither is better, and one is worse");
        assert!(!refuses(of(1.005, 2.31)), "nothing changes");
        assert!(!refuses(of(1.02, 2.2)) && !refuses(of(0.98, 2.6)), "one of the two is better");
        assert!(refuses(of(0.95, 21.0)) && !refuses(of(0.5, 21.0)), "wild claims");
    }
}
