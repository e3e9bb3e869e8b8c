//! The limit of the Riccati recursion, found in doublings instead of steps.

use super::blame;
use super::doubling::{Doubled, Doubling, Scaled, System, step};
use super::exact::{after_exact_readings, before_exact_readings, is_noisy, start_after};
use crate::Verdict;
use crate::detectability::detectability;
use crate::error::Error;
use crate::reachability::noise_reach;
use crate::validate;
use filters::linear;
use nalgebra::DMatrix;

/// Steps that are taken one by one before the first doubling: what a reading tells at once is then known, and a large
/// start no longer hides a small limit.
const FIRST: usize = 32;
/// A direction is unseen, or not moved by noise, if what tells is below this part of what else there is.
const STRUCTURE: f64 = 1e-12;
/// How often the doubling begins anew where it has come to: the change is then small, and so is its rounding.
const STAGES: usize = 4;

/// Where P(k+1 | k) and the gain go from a start.
///
/// # Example
/// ```
/// use estimate::dynamic::{System, steady_state};
/// use nalgebra::{DMatrix, dmatrix};
/// // A bias that wanders by 10⁻⁷ a step takes ten million steps to settle, and twenty-four doublings.
/// let walk = System::new(dmatrix![1.0], DMatrix::zeros(1, 0), dmatrix![1.0], dmatrix![1e-14], dmatrix![1.0])?;
/// let limit = steady_state(&walk, dmatrix![1.0])?;
/// assert!(limit.converged && !limit.depends_on_start && limit.steps > 1e7);
/// assert!((limit.p[0] - 1.00000005e-7).abs() < 1e-16);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// R, n×p: the limit of the gain. Thrun K. Where it has none, the gain after the steps that were taken.
    pub r: DMatrix<f64>,
    /// P(k+1 | k), n×n: the limit, or the covariance that this gain is computed from.
    pub p: DMatrix<f64>,
    /// Whether P has a limit from this start.
    pub converged: bool,
    /// Whether R has. Without observability R may settle while P grows for ever.
    pub gain_converged: bool,
    /// Whether P has a limit that a larger start would change.
    pub depends_on_start: bool,
    /// How many steps were taken until P, or where it has no limit R, changed by less than 10⁻¹² of its size in twice
    /// as many; where neither does, all that were taken. A power of two and a few more.
    pub steps: f64,
}

/// The limit of P(k+1 | k) and of the gain from `p0` = P(0 | 0), however slow the recursion is.
///
/// Its accuracy is that of the question: about 10⁻¹⁶ times the factor by which an error of the system's numbers, each
/// as a part of its size, shows in the answer, in units of each state's own.
///
/// # Errors
/// For `p0` as [`validate::covariance`]; [`crate::Code::InnovationNotPositiveDefinite`]; [`crate::Code::NotFinite`]
/// when P overflows within the first steps.
pub fn steady_state(system: &System, p0: DMatrix<f64>) -> Result<Limit, Error> {
    let p0 = validate::covariance(p0, system.f.nrows(), "P0")?;
    let mut p = linear::predicted_covariance(&system.f, &p0, &system.v).map_err(blame)?;
    let mut next = step(system, &p)?.1;
    let mut first = 0;
    // A variance that grows without bound may hide all others: then the last step before is where to begin.
    while let Ok((_, after)) = step(system, &next)
        && first < FIRST
    {
        (p, next, first) = (next, after, first + 1);
    }
    let scaled = Scaled::of(system, &p);
    let none = || blame(filters::Error::InnovationNotPositiveDefinite);
    let bounded = !grows(system);
    let found = Doubling::at(&scaled)?.run(&scaled, bounded).ok_or_else(none)?;
    let steps = |found: &Doubled| first as f64 + found.steps;
    if found.whole
        && let Some((own, better)) = refined(system, scaled.clone(), found.clone())
    {
        return Ok(answer(&own, &better, steps(&found)));
    }
    let found = Doubling::from_nothing(&scaled).and_then(|from| from.run(&scaled, bounded)).unwrap_or(found);
    let found = answer(&scaled, &found, steps(&found));
    if found.converged { Ok(found) } else { Ok(of_what_is_left(system, &p0).unwrap_or(found)) }
}

/// The limit where a reading has no noise, by way of what is left to know after it: near such a limit the difference of
/// two covariances loses its digits. `None` where each reading has noise, or one is never reached by any.
fn of_what_is_left(system: &System, p0: &DMatrix<f64>) -> Option<Limit> {
    let left = after_exact_readings(system);
    let last = left.last().filter(|last| is_noisy(last))?;
    let found = steady_state(last, start_after(&left, p0)?).ok().filter(|found| found.converged)?;
    let (p, r) = before_exact_readings(system, &left, found.p.clone())?;
    Some(Limit { r, p, steps: found.steps + left.len() as f64, ..found })
}

/// Whether P grows without bound from every start, however slowly: noise reaches every direction that does not die out,
/// and of these one is not seen. A bounded P would have a limit with a gain under which every error dies out.
fn grows(system: &System) -> bool {
    let System { f, h, v, .. } = system;
    detectability(f, h, STRUCTURE).is_ok_and(|seen| seen.detectable == Verdict::No)
        && noise_reach(f, v, STRUCTURE).is_ok_and(|noise| noise.stabilizable == Verdict::Yes)
}

fn answer(scaled: &Scaled, found: &Doubled, steps: f64) -> Limit {
    Limit {
        r: scaled.given_gain(&found.r),
        p: scaled.given(&found.p),
        converged: found.converged,
        gain_converged: found.converged || found.gain_converged,
        depends_on_start: found.converged && found.depends_on_start,
        steps,
    }
}

/// The limit, sought once more from where it was found, in units that fit it; `None` where it does not hold there.
fn refined(system: &System, mut scaled: Scaled, mut found: Doubled) -> Option<(Scaled, Doubled)> {
    for _ in 0..STAGES {
        let again = Scaled::of(system, &scaled.given(&found.p));
        let Some(better) = Doubling::at(&again).ok()?.run(&again, true).filter(|better| better.whole) else { break };
        let same = again.units == scaled.units;
        (scaled, found) = (again, better);
        if same {
            return Some((scaled, found));
        }
    }
    let own = Scaled::of(system, &scaled.given(&found.p));
    own.holds_still().then_some((scaled, found))
}
