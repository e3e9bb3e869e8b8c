//! How much likelier readings become where a number, or a few together, are freed: a search by a few replays.

use crate::drive::evidence::{Evidence, Trial, Weighed};
use crate::drive::row::Drive;
use alloc::vec::Vec;
use nalgebra::{Cholesky, DMatrix, DVector};

/// A number whose freeing promises less than this is not looked at further: it is far from any verdict.
const HOPELESS: f64 = 1.5;
/// A number whose freeing promises more than this may be far off, and is sought elsewhere too.
const FAR: f64 = 100.0;
/// A step that promises less is the last.
const LITTLE: f64 = 0.05;
/// So many steps are taken: of what is wrong by a factor, as a claim whose logarithm moves by about ½ in each, more.
pub(crate) const ROUNDS: u32 = 4;
pub(crate) const ROUNDS_OF_A_FACTOR: u32 = 12;
/// How often a step that does not lead up is halved.
const HALVINGS: u32 = 3;
/// Steps of ln σ, by which the likelihood's curvature is taken, and the longest that is tried.
const SIGMA_STEP: f64 = 0.2;
const LONGEST: f64 = 1.0;
/// A step of three σ makes the readings less likely by so much at least, or is doubled, so many times at most.
const LEAST_FALL: f64 = 1.0;
const DOUBLINGS: u32 = 12;

/// What freeing numbers brings.
#[derive(Clone, Debug)]
pub(crate) struct Freed {
    /// Where the readings are likeliest.
    pub at: Vec<f64>,
    /// How well the readings tell it; infinite where they do not.
    pub sigmas: Vec<f64>,
    /// By how much the log-likelihood rises.
    pub gain: f64,
}

/// Numbers to be freed together: where they are, how far a difference goes, and how far they may go.
pub(crate) struct Numbers<'a, F: Fn(&[f64]) -> Trial> {
    pub first: Vec<f64>,
    pub steps: Vec<f64>,
    pub bounds: Vec<[f64; 2]>,
    /// Whether a difference is taken to both sides: of what the likelihood has corners in.
    pub both: bool,
    /// Where else the first is sought, as far as it may be far off.
    pub others: Vec<f64>,
    /// How many steps are taken at most.
    pub rounds: u32,
    pub place: &'a F,
}

/// A search beside a replay.
pub(crate) struct Search<'a> {
    pub drive: &'a Drive,
    pub rows: u32,
    /// Readings count from this row.
    pub from: u32,
    pub base: &'a Evidence,
}

impl Search<'_> {
    pub fn replay(&self, place: &Trial) -> Option<Evidence> {
        // What leaves the numbers is no place that could be the best.
        Evidence::new(self.drive, place, self.rows).ok()
    }

    /// Numbers that move what is expected of the readings (Gauss and Newton): with e = L⁻¹ν the gradient of the
    /// log-likelihood is −Σ eᵀ∂e, and its information Σ ∂eᵀ∂e. `None` where the readings do not tell them.
    pub fn means<F: Fn(&[f64]) -> Trial>(&self, numbers: &Numbers<'_, F>) -> Option<Freed> {
        let first = Freed { at: numbers.first.clone(), sigmas: Vec::new(), gain: 0.0 };
        let (near, promised) = self.ascend(numbers, first, None)?;
        let lost = near.gain == 0.0 && promised >= HOPELESS;
        if promised < FAR && !lost {
            return Some(near);
        }
        // So far off the way up from where they are may lead nowhere.
        let mut best: Option<(Freed, Evidence)> = None;
        for value in &numbers.others {
            let mut at = numbers.first.clone();
            at[0] = *value;
            let Some(evidence) = self.replay(&(numbers.place)(&at)) else { continue };
            let gain = evidence.gain(self.base, self.from);
            if gain > best.as_ref().map_or(near.gain, |(best, _)| best.gain) {
                best = Some((Freed { at, sigmas: near.sigmas.clone(), gain }, evidence));
            }
        }
        let far = best.and_then(|(from, here)| self.ascend(numbers, from, Some(here)));
        Some(far.map_or(near, |(found, _)| found))
    }

    /// How well numbers are told behind a gate, where a small step may change what it refuses: as far as the readings
    /// are less likely by what that uncertainty promises.
    pub fn widened<F: Fn(&[f64]) -> Trial>(&self, numbers: &Numbers<'_, F>, mut found: Freed) -> Freed {
        for i in 0..found.sigmas.len() {
            let falls = |step: f64| {
                let mut at = found.at.clone();
                at[i] += step;
                self.replay(&(numbers.place)(&at))
                    .map_or(f64::INFINITY, |it| found.gain - it.gain(self.base, self.from))
            };
            // At three σ the logarithm has fallen by 4.5: where it has by less than a fifth of that, σ is another.
            let mut step = 3.0 * found.sigmas[i];
            let mut fall = falls(step).min(falls(-step));
            let mut doublings = 0;
            while fall < LEAST_FALL && doublings < DOUBLINGS {
                step *= 2.0;
                fall = falls(step).min(falls(-step));
                doublings += 1;
            }
            if doublings > 0 {
                found.sigmas[i] =
                    if fall < LEAST_FALL { f64::INFINITY } else { step / libm::sqrt(2.0 * fall.min(4.5)) };
            }
        }
        found
    }

    /// Steps up from what was found, and what the first of them promised.
    fn ascend<F: Fn(&[f64]) -> Trial>(
        &self,
        numbers: &Numbers<'_, F>,
        mut found: Freed,
        mut here: Option<Evidence>,
    ) -> Option<(Freed, f64)> {
        let (mut first, begins) = (0.0, here.is_none());
        for round in 0..numbers.rounds {
            let (step, sigmas, promised) = self.step(numbers, &found.at, here.as_ref().unwrap_or(self.base))?;
            found.sigmas = sigmas;
            if round == 0 {
                first = promised;
                if begins && promised < HOPELESS {
                    found.at.iter_mut().zip(&step).for_each(|(at, step)| *at += step);
                    found.gain = promised;
                    break;
                }
            }
            let Some((at, evidence, gain)) = self.climb(&found, &step, numbers).filter(|_| promised > LITTLE) else {
                break;
            };
            (found.at, found.gain, here) = (at, gain, Some(evidence));
        }
        Some((found, first))
    }

    /// The step to where the gradient vanishes, the standard deviations there, and what it promises.
    fn step<F: Fn(&[f64]) -> Trial>(
        &self,
        numbers: &Numbers<'_, F>,
        at: &[f64],
        here: &Evidence,
    ) -> Option<(Vec<f64>, Vec<f64>, f64)> {
        let slopes: Vec<Vec<[f64; 2]>> =
            (0..at.len()).map(|i| self.slope(numbers, at, i, here)).collect::<Option<_>>()?;
        let counts = |k: &usize| here.readings[*k].row >= self.from;
        let dot = |a: &dyn Fn(usize) -> [f64; 2], b: &dyn Fn(usize) -> [f64; 2]| -> f64 {
            (0..here.readings.len()).filter(counts).map(|k| a(k)[0] * b(k)[0] + a(k)[1] * b(k)[1]).sum()
        };
        let of = |i: usize| {
            let slope = &slopes[i];
            move |k: usize| slope[k]
        };
        let white = |k: usize| here.readings[k].white;
        let information = DMatrix::from_fn(at.len(), at.len(), |i, j| dot(&of(i), &of(j)));
        let gradient = DVector::from_fn(at.len(), |i, _| -dot(&of(i), &white));
        let factor = Cholesky::new(information)?;
        let step = factor.solve(&gradient);
        let covariance = factor.inverse();
        let sigmas: Vec<f64> = (0..at.len()).map(|i| libm::sqrt(covariance[(i, i)])).collect();
        let promised = 0.5 * gradient.dot(&step);
        let sound = promised.is_finite() && sigmas.iter().all(|sigma| sigma.is_finite());
        sound.then(|| (step.as_slice().to_vec(), sigmas, promised))
    }

    /// ∂e of each reading; 0 of those that one of the replays has not used.
    fn slope<F: Fn(&[f64]) -> Trial>(
        &self,
        numbers: &Numbers<'_, F>,
        at: &[f64],
        i: usize,
        here: &Evidence,
    ) -> Option<Vec<[f64; 2]>> {
        let moved = |by: f64| {
            let mut to = at.to_vec();
            to[i] += by;
            self.replay(&(numbers.place)(&to))
        };
        let h = numbers.steps[i];
        let above = moved(h)?;
        let below = if numbers.both { Some(moved(-h)?) } else { None };
        let lower: Vec<_> = match &below {
            Some(below) => below.aligned(here).collect(),
            None => here.readings.iter().map(Some).collect(),
        };
        let width = if numbers.both { 2.0 * h } else { h };
        let slope = |((above, below), its): ((Option<_>, Option<_>), &Weighed)| {
            let used = |one: &&Weighed| one.used && its.used;
            match (above.filter(used), below.filter(used)) {
                (Some(a), Some(b)) => [(a.white[0] - b.white[0]) / width, (a.white[1] - b.white[1]) / width],
                _ => [0.0; 2],
            }
        };
        Some(above.aligned(here).zip(lower).zip(&here.readings).map(slope).collect())
    }

    /// The step, or a shorter one, that leads up.
    fn climb<F: Fn(&[f64]) -> Trial>(
        &self,
        found: &Freed,
        step: &[f64],
        numbers: &Numbers<'_, F>,
    ) -> Option<(Vec<f64>, Evidence, f64)> {
        let share = |n: u32| 1.0 / f64::from(1_u32 << n);
        (0..=HALVINGS).map(share).find_map(|share| {
            let to = found.at.iter().zip(step).zip(&numbers.bounds);
            let at: Vec<f64> = to.map(|((at, step), [least, most])| (at + share * step).clamp(*least, *most)).collect();
            let evidence = self.replay(&(numbers.place)(&at))?;
            let gain = evidence.gain(self.base, self.from);
            (gain > found.gain).then_some((at, evidence, gain))
        })
    }

    /// A standard deviation by its logarithm, by the likelihood's own differences. `None` where the readings do not
    /// tell it.
    pub fn sigma<F: Fn(&[f64]) -> Trial>(&self, numbers: &Numbers<'_, F>) -> Option<Freed> {
        let value = |at: f64| {
            self.replay(&(numbers.place)(&[at])).map_or(f64::NEG_INFINITY, |it| it.gain(self.base, self.from))
        };
        let mut found = Freed { at: numbers.first.clone(), sigmas: Vec::new(), gain: 0.0 };
        for round in 0..numbers.rounds {
            let at = found.at[0];
            let [above, below] = [SIGMA_STEP, -SIGMA_STEP].map(|by| value(at + by));
            let slope = (above - below) / (2.0 * SIGMA_STEP);
            let bend = (above + below - 2.0 * found.gain) / (SIGMA_STEP * SIGMA_STEP);
            if !(slope.is_finite() && bend.is_finite()) {
                return None;
            }
            found.sigmas = alloc::vec![if bend < 0.0 { 1.0 / libm::sqrt(-bend) } else { f64::INFINITY }];
            let step = if bend < 0.0 { -slope / bend } else { LONGEST * slope.signum() };
            let step = step.clamp(-LONGEST, LONGEST);
            let promised = slope * step + 0.5 * bend * step * step;
            if round == 0 && promised < HOPELESS {
                (found.at[0], found.gain) = (at + step, promised.max(0.0));
                return Some(found);
            }
            if promised < LITTLE {
                break;
            }
            let [least, most] = numbers.bounds[0];
            let share = |n: u32| (at + step / f64::from(1_u32 << n)).clamp(least, most);
            let up = (0..=HALVINGS).map(share).map(|to| (to, value(to))).find(|(_, gain)| *gain > found.gain);
            let Some((to, gain)) = up else { break };
            (found.at[0], found.gain) = (to, gain);
        }
        Some(found)
    }
}
