//! Faults beside a σ that is larger than is said: it makes any error of the model likelier.
//!
//! The faults are freed once more beside it, and what makes the readings much likelier even so goes before it. A σ that
//! is enlarged until it allows for a fault leaves nothing of it, though: turns of the wrong sign are not seen where the
//! turn is as good as unknown. What explains by itself about as much as that σ is therefore not freed beside it: with
//! the fault mended the σ is found anew, and both are held against the σ alone.

use crate::drive::evidence::{Evidence, Trial};
use crate::drive::fault::Fault;
use crate::drive::fitted::Fitted;
use crate::drive::round::{Round, Scope};
use crate::drive::row::Drive;
use crate::drive::suspect::Suspect;
use crate::drive::thinning::{Thinning, less, thinning};
use crate::drive::tried::Tried;
use crate::drive::weight::{CLEAR, most, ranked, sifted};
use crate::error::Error;
use alloc::vec::Vec;

/// It explains at least this share of what the larger σ does, and no other fault explains as much.
const MOST: f64 = 0.5;

/// Puts before a larger σ the one fault that explains by itself most of what that does; whether there was one.
pub(crate) fn by_itself(round: &mut Round, drive: &Drive, scope: &Scope) -> Result<bool, Error> {
    let Some((sigma, others)) = beside(round) else { return Ok(false) };
    // Outliers are what a larger σ allows for, too.
    let mut others = others.into_iter().filter(|(_, it)| it.fault != Fault::Tails);
    let sigma = sigma.clone();
    let Some((at, alone)) = others.next() else { return Ok(false) };
    let rival = others.find(|(_, it)| !same(it, alone)).map_or(0.0, |(_, it)| it.excess);
    if alone.excess < MOST * sigma.excess || rival >= MOST * sigma.excess {
        return Ok(false);
    }
    let mut anew = Round::new(round.found[at].1, alloc::vec![sigma.tried()]);
    while anew.step(drive, scope)? {}
    let both = alone.gain + anew.found.first().map_or(0.0, |(it, _)| it.gain);
    let much = both - sigma.gain - (alone.gain - alone.excess) >= CLEAR;
    if much {
        let claimed = beside_claims(round, drive, scope, (at, both))?;
        let first = round.found.remove(at);
        let first = claimed.unwrap_or(first);
        round.found.retain(|(suspect, _)| suspect.tried() != first.0.tried());
        round.found.insert(0, first);
    }
    Ok(much)
}

/// Fixes that are worse than they claim bend what is found by them: an arm takes in a delay that is none. The fault
/// as it is beside the σ that they have, where the two explain more than the fault and a σ do otherwise.
fn beside_claims(
    round: &Round,
    drive: &Drive,
    scope: &Scope,
    (at, both): (usize, f64),
) -> Result<Option<(Suspect, Trial)>, Error> {
    let (Some((alone, _)), Some(base)) = (round.found.get(at), &round.base) else { return Ok(None) };
    let larger = |it: &Suspect| it.sizes.iter().all(|size| size.value > size.now) && it.excess > MOST * alone.excess;
    let claim = |it: &Suspect| it.number.filter(|number| it.fault == Fault::Sigma && number.is_sigma_of_fixes());
    let claims = round.found.iter().filter(|(it, _)| larger(it));
    let Some((claim, (sigma, wide))) = claims.filter_map(|it| Some((claim(&it.0)?, it))).next() else {
        return Ok(None);
    };
    let stands_in = |fault: Fault| matches!(fault, Fault::Antenna | Fault::Clock);
    let alike = |it: &&Tried| **it == alone.tried() || stands_in(it.fault()) && stands_in(alone.fault);
    let mut anew = Round::new(*wide, round.tried.iter().filter(alike).copied().collect());
    while anew.step(drive, scope)? {}
    sifted(drive, &mut anew.found, scope);
    let Some((mut fault, mut place)) = ranked(anew.found).into_iter().next() else { return Ok(None) };
    if fault.excess < CLEAR || sigma.gain + fault.gain <= both {
        return Ok(None);
    }
    claim.set(&mut place.settings, claim.get(&round.place.settings));
    let from = if fault.tried().delays() { scope.from } else { 0 };
    let gain = Evidence::new(drive, &place, scope.rows)?.gain(base, from);
    (fault.excess, fault.gain) = (gain - (fault.gain - fault.excess), gain);
    Ok((fault.excess >= CLEAR).then_some((fault, place)))
}

/// A larger σ, where that explains most in a round, and the faults that are left beside it, each with its place among
/// all. Where it is what fixes claim, a start is not: it was taken from these, and its σ is their claim.
fn beside(round: &Round) -> Option<(&Suspect, Vec<(usize, &Suspect)>)> {
    let (first, _) = round.found.first()?;
    let larger = first.fault == Fault::Sigma && first.sizes.iter().all(|size| size.value > size.now);
    let claimed = first.number == Some(Fitted::FixSigmaScale);
    let of_fixes = first.number.is_some_and(Fitted::is_sigma_of_fixes);
    // An arm and a delay look alike beside a σ of the motion that allows for both: which it is, they tell by
    // themselves. So do the delays of speed and turn rate where one sensor alone is read.
    let clock = most(&round.found, &|it| it.fault == Fault::Clock);
    let several = round.tried.iter().any(|tried| matches!(tried, Tried::Together(_)));
    let other = |it: &Suspect| match it.number {
        Some(Fitted::DelayTurn) => !several,
        _ => it.fault == Fault::Antenna && it.gain < clock && !of_fixes,
    };
    let kept = |it: &Suspect| it.fault != Fault::Sigma && !(claimed && it.fault == Fault::Start) && !other(it);
    let all = round.found.iter().map(|(suspect, _)| suspect).enumerate();
    let others: Vec<_> = all.filter(|(_, suspect)| suspect.excess > 0.0 && kept(suspect)).collect();
    (larger && first.excess > 0.0 && !others.is_empty()).then_some((first, others))
}

/// The faults that are to be tried anew beside a larger σ.
pub(crate) fn explained(round: &Round) -> Option<Round> {
    let (_, others) = beside(round)?;
    let mut tried: Vec<Tried> = others.iter().map(|(_, suspect)| suspect.tried()).collect();
    // Of an arm with a delay one may be enough there.
    for both in tried.clone() {
        let Tried::Antenna(Some(delay)) = both else { continue };
        let alone = [Tried::Antenna(None), Tried::Number(delay)].into_iter().filter(|it| !tried.contains(it));
        tried.extend(alone.collect::<Vec<_>>());
    }
    Some(Round::new(round.found.first()?.1, tried))
}

/// Puts what gains much beside the larger σ before it; whether there was any. Where there is none because readings go
/// together, it says how few of them do not.
pub(crate) fn hoist(first: &mut Round, mut round: Round, drive: &Drive, scope: &Scope) -> (bool, Option<Thinning>) {
    let mut found = core::mem::take(&mut round.found);
    sifted(drive, &mut found, scope);
    let any = found.iter().any(|(suspect, _)| suspect.excess >= CLEAR);
    for (suspect, place) in &mut found {
        let from = if suspect.tried().delays() { scope.from } else { 0 };
        let mended = Evidence::new(drive, place, scope.rows).ok().zip(round.base.as_ref());
        suspect.excess -= mended.map_or(0.0, |(mended, base)| less(&mended, base, from));
    }
    let mut found = ranked(found);
    let much = found.iter().take_while(|(suspect, _)| suspect.excess >= CLEAR).count();
    if much == 0 {
        let base = round.base.as_ref().filter(|_| any);
        return (false, base.and_then(|base| thinning(drive, &round.place, base, scope.rows)));
    }
    let claim = first.found.first().and_then(|(it, _)| it.number).filter(|number| number.is_sigma_of_fixes());
    // How large it is, the settings as they are tell: the log-likelihood that a reader watches is highest
    // there, and a σ that allows for all errors moves that place. How well it is known, the larger σ tells; and how
    // large it is, too, where that σ is of fixes that claim too much.
    for (suspect, place) in &mut found {
        if let Some(claim) = claim {
            claim.set(&mut place.settings, claim.get(&first.place.settings));
            continue;
        }
        let Some((alone, at)) = first.found.iter().find(|(it, _)| it.tried() == suspect.tried()) else {
            continue;
        };
        let sizes = suspect.sizes.iter_mut().zip(&alone.sizes);
        sizes.for_each(|(size, alone)| (size.value, size.end) = (alone.value, alone.end));
        *place = *at;
        suspect.weigh();
    }
    let [mut found, mut rest] = parted(found, much);
    let before = core::mem::take(&mut first.found).into_iter();
    rest.extend(before.filter(|(suspect, _)| !round.tried.contains(&suspect.tried())));
    let any = !found.is_empty();
    found.extend(ranked(rest));
    first.found = found;
    (any, None)
}

/// Whether they are the same fault, of one sensor or of several together. Turns of the wrong sign are such of a scale
/// below 0, and the least that is tried goes half of the way there.
fn same(one: &Suspect, other: &Suspect) -> bool {
    let turns = |it: &Suspect| matches!(it.fault, Fault::Mirrored | Fault::TurnScale);
    if turns(one) && turns(other) {
        return true;
    }
    let of = |it: &Suspect| it.tried().numbers();
    one.fault == other.fault && one.fault != Fault::Start && of(one).iter().any(|number| of(other).contains(number))
}

/// Those of the first so many whose evidence still counts, and the others.
fn parted(found: Vec<(Suspect, Trial)>, much: usize) -> [Vec<(Suspect, Trial)>; 2] {
    let (mut first, mut others) = (Vec::new(), Vec::new());
    for (i, one) in found.into_iter().enumerate() {
        if i < much && one.0.excess > 0.0 { first.push(one) } else { others.push(one) }
    }
    [first, others]
}
