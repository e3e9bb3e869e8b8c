//! Outliers among the readings of a sensor: what a gate brings that refuses them, by itself or with another σ.
//!
//! Outliers that are not very far off look like a larger σ, and a σ that was found among them hides them: beside it
//! they stand out no more. Behind a gate the σ is therefore sought anew, and counts where the two together explain much
//! more than either does.

use crate::drive::evidence::{OUTLIERS, Trial};
use crate::drive::fitted::Fitted;
use crate::drive::freed::{Freed, Search};
use crate::drive::sensor::Sensor;
use crate::drive::suspect::Size;
use crate::drive::tried::Tried;

/// Readings of which this share would be outliers have none: the model is wrong.
const MANY: f64 = 0.5;
/// Steps of ln σ, and so many of them.
const STEP: f64 = 0.35;
const STEPS: usize = 9;
/// How often the step is halved where they lead no further up.
const HALVINGS: usize = 3;

/// What a gate brings.
pub(crate) struct Outliers {
    pub share: f64,
    pub sigma_share: f64,
    pub gain: f64,
    /// How many of the readings are none.
    sound: f64,
}

/// What outliers bring: a share of them, the place with the gate, and σ where it is another one behind it.
pub(crate) struct Tails {
    pub freed: Freed,
    pub place: Trial,
    pub sigma: Option<(Fitted, Size)>,
}

/// The σ of a sensor's readings, of the numbers that are tried.
pub(crate) fn sigma_of(sensor: Sensor, tried: &[Tried]) -> Option<Fitted> {
    let of: &[Fitted] = match sensor {
        Sensor::Fix => &[Fitted::SigmaFix, Fitted::FixSigmaScale],
        Sensor::Heading => &[Fitted::SigmaHeading, Fitted::HeadingSigmaScale],
        Sensor::Range => &[Fitted::SigmaRange],
        Sensor::Bearing => &[],
    };
    of.iter().copied().find(|number| tried.contains(&Tried::Number(*number)))
}

/// Looks at the outliers of a sensor, `place` with its gate, beside what its σ gains `alone`; by chance less than
/// `chance` is gained.
pub(crate) fn tails(
    search: &Search<'_>,
    sensor: Sensor,
    place: Trial,
    number: Option<(Fitted, f64)>,
    chance: f64,
) -> Option<Tails> {
    let plain = outliers(search, sensor, &place).filter(|found| found.share > 0.0);
    let gain = plain.as_ref().map_or(0.0, |found| found.gain);
    let both = number.and_then(|(number, alone)| {
        let (at, found) = beside(search, sensor, &place, number, gain)?;
        (found.share > 0.0 && found.gain > gain.max(alone) + chance)
            .then(|| with_sigma(search, sensor, &place, number, at, &found))?
    });
    both.or_else(|| plain.map(|found| Tails { freed: freed(&found), place, sigma: None }))
}

fn freed(found: &Outliers) -> Freed {
    Freed { at: alloc::vec![found.share], sigmas: alloc::vec![found.sigma_share], gain: found.gain }
}

/// The place with another σ, by its logarithm.
fn at(place: &Trial, number: Fitted, value: f64) -> Trial {
    let mut place = *place;
    number.set(&mut place.settings, value);
    place
}

/// The ln σ behind the gate under which the readings are likeliest, where they gain more than `gain` at some other.
fn beside(search: &Search<'_>, sensor: Sensor, place: &Trial, number: Fitted, gain: f64) -> Option<(f64, Outliers)> {
    let first = number.get(&place.settings);
    let look = |value: f64| Some((value, outliers(search, sensor, &at(place, number, value))?));
    let sides = [-STEP, STEP].into_iter().filter_map(|step| Some((step, look(first + step)?)));
    let (mut step, mut best) = sides.max_by(|(_, one), (_, other)| one.1.gain.total_cmp(&other.1.gain))?;
    if best.1.gain <= gain {
        return None;
    }
    for _ in 0..STEPS {
        // Between a σ that lets outliers in and one that refuses them the likelihood may dip.
        let ahead = [1.0, 2.0].into_iter().filter_map(|steps| look(best.0 + steps * step));
        match ahead.max_by(|one, other| one.1.gain.total_cmp(&other.1.gain)) {
            Some(next) if next.1.gain > best.1.gain => best = next,
            _ => break,
        }
    }
    for _ in 0..HALVINGS {
        step *= 0.5;
        let sides = [-step, step].into_iter().filter_map(|step| look(best.0 + step));
        if let Some(next) = sides.max_by(|one, other| one.1.gain.total_cmp(&other.1.gain))
            && next.1.gain > best.1.gain
        {
            best = next;
        }
    }
    Some(best)
}

/// The two together; how well σ is known, the bend of the likelihood tells, and no better than so many readings can.
fn with_sigma(
    search: &Search<'_>,
    sensor: Sensor,
    place: &Trial,
    number: Fitted,
    value: f64,
    found: &Outliers,
) -> Option<Tails> {
    let step = 0.5 * STEP;
    let gain = |value: f64| outliers(search, sensor, &at(place, number, value)).map(|it| it.gain);
    let bend = (2.0 * found.gain - gain(value - step)? - gain(value + step)?) / (step * step);
    let least = 1.0 / libm::sqrt(2.0 * found.sound.max(1.0));
    let relative = if bend > 0.0 { (1.0 / libm::sqrt(bend)).max(least) } else { f64::INFINITY };
    let (now, is) = (number.value(number.get(&place.settings)), number.value(value));
    let size = Size { now, value: is, sigma: is * relative, end: false };
    Some(Tails { freed: freed(found), place: at(place, number, value), sigma: Some((number, size)) })
}

/// What a gate brings that takes what it refuses for outliers, whose share is the one that is found; it may be 0.
fn outliers(search: &Search<'_>, sensor: Sensor, place: &Trial) -> Option<Outliers> {
    let evidence = search.replay(place)?;
    let [refused, all] = evidence.refused(|of| of == sensor).map(f64::from);
    let share = refused / all;
    let of = |count: f64, share: f64, assumed: f64| if count > 0.0 { count * libm::log(share / assumed) } else { 0.0 };
    let gain = evidence.gain(search.base, search.from)
        + of(refused, share, OUTLIERS)
        + of(all - refused, 1.0 - share, 1.0 - OUTLIERS);
    let sigma_share = libm::sqrt(share * (1.0 - share) / all);
    let sound = all - refused;
    (gain.is_finite() && share < MANY).then_some(Outliers { share, sigma_share, gain, sound })
}
