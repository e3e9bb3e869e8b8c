//! How evidence is weighed: what counts of a suspect's gain, which suspect goes before which, and how sure each is.

use crate::drive::evidence::{Evidence, Trial};
use crate::drive::fault::Fault;
use crate::drive::fitted::Fitted;
use crate::drive::round::Scope;
use crate::drive::row::Drive;
use crate::drive::suspect::{Size, Standing, Suspect};
use crate::drive::thinning::less;
use alloc::vec::Vec;

/// Faults whose gains differ by less than this tie, and the earlier kind is named first.
const TIE: f64 = 0.5;
/// A fault is sure where neither chance nor another comes as near as this: the readings are 20 times likelier with it.
pub(crate) const CLEAR: f64 = 3.0;
/// A size that is not so many of its own standard deviations away from what is set is none.
const CLEAR_OF_ITSELF: f64 = 2.0;

impl Size {
    /// Whether what the readings tell is another value than is set, and not within its own uncertainty of it. What has
    /// no uncertainty that could be said has only its gain to be judged by. A `ratio` is compared by its logarithm; one
    /// that is less than is set, and not known to a factor e, is told from above alone, and has its gain.
    fn is_clear(&self, ratio: bool) -> bool {
        let (off, sigma) = match ratio {
            true => (libm::log(self.value / self.now), self.sigma / self.value),
            false => (self.value - self.now, self.sigma),
        };
        !sigma.is_finite() || (ratio && off < 0.0 && sigma > 1.0) || off.abs() >= CLEAR_OF_ITSELF * sigma
    }
}

impl Suspect {
    /// Weighs its evidence: what it gains beyond chance counts where its size is clear of its own uncertainty, of
    /// several numbers that of one. A share of outliers is what was counted, and is no size of that kind.
    pub(crate) fn weigh(&mut self) {
        let ratio = self.number.is_some_and(Fitted::is_sigma);
        let clear =
            self.fault == Fault::Tails || self.sizes.is_empty() || self.sizes.iter().any(|it| it.is_clear(ratio));
        if !clear {
            self.excess = self.excess.min(0.0);
        }
    }
}

/// An arm and a delay together gain so many times as much as a clock alone, where that gains more than the arm alone
/// and what is read is held until the next row.
const FAR_MORE: f64 = 1.5;
/// A small arm is at most so many times as long as the way of a step, beside what is uncertain of it.
const SMALL: f64 = 1.3;

impl Suspect {
    /// Whether it is an antenna that seems to stand elsewhere by no more than what is held until the next row does.
    pub(crate) fn is_small_arm(&self, arm: f64) -> bool {
        let [ahead, left, ..] = self.sizes.as_slice() else { return false };
        let off = (ahead.value - ahead.now).abs();
        self.fault == Fault::Antenna && off <= (arm + 2.0 * ahead.sigma).min(SMALL * arm) && !left.is_clear(false)
    }
}

/// The likeliest fault first; of those whose gains tie, the earlier kind.
pub(crate) fn ranked(mut left: Vec<(Suspect, Trial)>) -> Vec<(Suspect, Trial)> {
    let mut all = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let best = left.iter().map(|(suspect, _)| suspect.excess).fold(f64::NEG_INFINITY, f64::max);
        // What falls short of chance is ordered by its gain alone.
        let tie = if best > 0.0 { TIE } else { 0.0 };
        let ties = left.iter().enumerate().filter(|(_, (suspect, _))| suspect.excess >= best - tie);
        let first = ties.min_by_key(|(_, (suspect, _))| suspect.fault).map_or(0, |(i, _)| i);
        all.push(left.remove(first));
    }
    all
}

/// Leaves of the ranges' scale and offset, and of an antenna's place and its delay, both together where neither
/// explains as much by itself, to within what a number gains by chance; else those by themselves. So it leaves wheels
/// of two sizes or a bias of the turn rate.
pub(crate) fn sifted(drive: &Drive, found: &mut Vec<(Suspect, Trial)>, scope: &Scope) {
    let chance = scope.chance[1];
    let pair = |it: &Suspect| it.with.is_some() && it.fault == Fault::Scale;
    let alone = |it: &Suspect| it.with.is_none() && matches!(it.number, Some(Fitted::Scale | Fitted::Offset));
    together(found, chance, pair, alone);
    // What is left of one length the others make up for: all three where they tell more than any does by itself.
    let length = |it: &Suspect| match it.fault {
        Fault::Scale | Fault::Odometry => true,
        fault => fault == Fault::Bias && it.number == Some(Fitted::Offset),
    };
    if found.iter().any(|(it, _)| it.fault == Fault::Lengths) {
        together(found, 2.0 * chance, |it| it.fault == Fault::Lengths, length);
    }
    // At a speed that hardly changes a bias of the turn rate looks the same as wheels of two sizes.
    let bias = |it: &Suspect| it.number == Some(Fitted::TurnBias);
    if found.iter().any(|(it, _)| bias(it)) {
        together(found, chance, |it| it.fault == Fault::UnequalWheels, bias);
    }
    // So the shares of what two wheels read: both wheels' size or their distance, or both.
    let share = |it: &Suspect| matches!(it.fault, Fault::WheelSize | Fault::TurnScale);
    if found.iter().any(|(it, _)| it.fault == Fault::WheelSize) {
        together(found, chance, |it| it.fault == Fault::Odometry, share);
    }
    let late = |it: &Suspect| it.fault == Fault::Antenna && it.with.is_some();
    let placed = |it: &Suspect| it.fault == Fault::Antenna && it.with.is_none();
    // What a delay explains nearly as well by itself is one, and so is an arm no longer than what is held explains.
    let (arm, clock) = (most(found, &placed), most(found, &|it| it.fault == Fault::Clock));
    let likeliest = most(found, &late);
    let beyond = arm >= clock
        || match scope.arm == 0.0 {
            true => likeliest > clock && beyond_clock(drive, found, scope),
            false => likeliest > FAR_MORE * clock,
        };
    let much = |it: &Suspect| {
        let clear = it.sizes.last().is_some_and(|delay| delay.is_clear(false));
        beyond && clear && it.excess > 0.0 && it.gain == likeliest
    };
    found.retain(|(it, _)| !late(it) || much(it));
    let delay = found.iter().find(|(it, _)| late(it)).and_then(|(it, _)| it.with);
    let delayed = |it: &Suspect| it.number == delay.or(Some(Fitted::DelayFix)) && it.with.is_none();
    together(found, chance, late, |it| placed(it) || delayed(it));
}

/// Whether the likeliest arm with a delay makes the readings likelier than the likeliest clock alone, by more than
/// chance. Fixes whose errors go together count as fewer.
fn beyond_clock(drive: &Drive, found: &[(Suspect, Trial)], scope: &Scope) -> bool {
    let likeliest = |fault: Fault| {
        let its = found.iter().filter(|(it, _)| it.fault == fault);
        let place = its.max_by(|a, b| a.0.gain.total_cmp(&b.0.gain)).map(|(_, place)| place)?;
        Evidence::new(drive, place, scope.rows).ok()
    };
    let Some((both, clock)) = likeliest(Fault::Antenna).zip(likeliest(Fault::Clock)) else { return false };
    both.gain(&clock, scope.from) - less(&both, &clock, scope.from) > scope.chance[1]
}

/// The most that any of such suspects gains.
pub(crate) fn most(found: &[(Suspect, Trial)], of: &dyn Fn(&Suspect) -> bool) -> f64 {
    let gains = found.iter().filter(|(it, _)| of(it)).map(|(it, _)| it.gain);
    gains.fold(f64::NEG_INFINITY, f64::max)
}

/// Leaves what is `both` where it gains more than any `alone` does, by more than chance; else those.
fn together(
    found: &mut Vec<(Suspect, Trial)>,
    chance: f64,
    both: impl Fn(&Suspect) -> bool,
    alone: impl Fn(&Suspect) -> bool,
) {
    let more = most(found, &both) > most(found, &alone).max(0.0) + chance;
    found.retain(|(it, _)| if more { !alone(it) } else { !both(it) });
}

/// Says how sure each suspect is; `hoisted` where the first are counted beside a larger σ.
pub(crate) fn stand(suspects: &mut [Suspect], hoisted: bool) {
    // What a larger σ explains as well is no rival of what is named before it.
    let kept = |suspect: &&Suspect| !hoisted || suspect.fault != Fault::Sigma;
    let rival = suspects.iter().skip(1).filter(kept).map(|s| s.excess).next().unwrap_or(0.0).max(0.0);
    for (i, suspect) in suspects.iter_mut().enumerate().filter(|(_, suspect)| suspect.excess > 0.0) {
        let clear = i == 0 && suspect.excess >= rival + CLEAR;
        suspect.standing = if clear { Standing::Sure } else { Standing::Maybe };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weighed(fault: Fault, number: Option<Fitted>, [now, value, sigma]: [f64; 3]) -> f64 {
        let mut suspect = Suspect {
            fault,
            number,
            with: None,
            sensor: None,
            landmarks: Vec::new(),
            sizes: alloc::vec![Size { now, value, sigma, end: false }],
            claims: None,
            dilution: None,
            gain: 9.0,
            excess: 5.0,
            standing: Standing::Cleared,
            own: false,
            flat: None,
            mended: None,
        };
        suspect.weigh();
        suspect.excess
    }

    #[test]
    fn a_size_that_is_not_clear_of_its_own_uncertainty_is_no_evidence() {
        let scale = |size| weighed(Fault::Scale, Some(Fitted::SpeedScale), size);
        assert_eq!([scale([0.0, 0.01, 0.1]), scale([0.0, -0.21, 0.1]), scale([0.05, 0.3, 0.1])], [0.0, 5.0, 5.0]);
        assert_eq!(weighed(Fault::Clock, Some(Fitted::DelaySpeed), [0.0, 0.15, 0.11]), 0.0);
        // A σ is compared by its logarithm: to a tenth, whatever is left of it.
        let sigma = |size| weighed(Fault::Sigma, Some(Fitted::SigmaTurn), size);
        assert_eq!([sigma([1.0, 0.1, 0.1]), sigma([1.0, 1.3, 0.2])], [5.0, 0.0]);
        assert_eq!([sigma([0.02, 1e-4, 3e-4]), sigma([0.02, 0.015, 0.008])], [5.0, 0.0], "one is told from above");
        assert_eq!(sigma([1.0, 1e-4, f64::INFINITY]), 5.0, "what is not told at all has its gain");
        assert_eq!(weighed(Fault::Tails, None, [0.0, 0.003, 0.002]), 5.0, "outliers are counted");
    }
}
