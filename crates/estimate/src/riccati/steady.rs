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
/// A direction is unseen, or not moved by noise, if what tells is below this part of what else there is: what a limit
/// rests on, whatever tolerance its verdicts are asked with.
pub const STRUCTURE: f64 = 1e-12;
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

/// Whether P grows without bound from every start, however slowly: of what does not die out a direction is neither seen
/// nor told by a combination that noise does not feed. Without such a combination noise moves it, and no gain can let
/// its error die out. Where noise reaches all that does not die out, it is enough that one direction is not seen.
/// `false` where it may grow from some starts alone, or where that is undecided.
pub fn grows(system: &System) -> bool {
    let System { f, h, v, .. } = system;
    let Ok(noise) = noise_reach(f, v, STRUCTURE) else { return false };
    let still = noise.unreached;
    let (n, p) = (f.nrows(), h.nrows());
    let told = DMatrix::from_fn(p + still.len(), n, |i, j| if i < p { h[(i, j)] } else { still[i - p][j] });
    noise.stabilizable != Verdict::Undecided
        && detectability(f, &told, STRUCTURE).is_ok_and(|seen| seen.detectable == Verdict::No)
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

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    fn system(f: DMatrix<f64>, h: DMatrix<f64>, v: &[f64]) -> System {
        let (n, p) = (f.nrows(), h.nrows());
        let v = DMatrix::from_diagonal(&nalgebra::DVector::from_column_slice(v));
        System::new(f, DMatrix::zeros(n, 0), h, v, DMatrix::identity(p, p) * 0.2).expect("sound")
    }

    /// Whether P grows, and that iterating agrees: what grows for ever has grown by as much again in as many steps.
    fn grown(system: &System) -> bool {
        let n = system.f.nrows();
        let after = |steps: usize| system.steady_state_gain(&DMatrix::identity(n, n), steps, 0.0).expect("runs").p;
        let [one, two, four] = [2000, 4000, 8000].map(|steps| after(steps).trace());
        let iterated = four - two > 1.5 * (two - one) && four - two > 1e-6 * four;
        let limit = steady_state(system, DMatrix::identity(n, n)).expect("found");
        assert_eq!(limit.converged, !iterated, "{system:?}: {one} {two} {four}");
        iterated
    }

    #[test]
    fn a_walk_that_no_reading_tells_apart_from_another_grows_whatever_else_is_told() {
        let both = dmatrix![1.0, 1.0, 0.0; 1.0, 1.0, 1.0];
        assert!(grown(&system(DMatrix::identity(3, 3), both.clone(), &[0.001, 0.001, 0.0])));
        assert!(grown(&system(DMatrix::identity(2, 2), dmatrix![1.0, 1.0], &[0.001, 0.001])));
        // A walk beside a constant: what the start says of the constant tells them apart for ever.
        assert!(!grown(&system(DMatrix::identity(2, 2), dmatrix![1.0, 1.0], &[0.001, 0.0])));
        assert!(!grown(&system(DMatrix::identity(3, 3), both, &[0.001, 0.0, 0.001])));
        assert!(grown(&system(dmatrix![1.0, 1.0; 0.0, 1.0], dmatrix![0.0, 1.0], &[0.0, 0.001])));
    }
}
