//! A reading without noise, in the Riccati recursion: what is left to know after it is known obeys a system of its own.
//!
//! With W singular the noise of the motion alone keeps the innovation's covariance regular, and what the theorems ask
//! of (F, V^½) has to be asked of that system (Anderson and Moore, Optimal Filtering, chapter 11): from
//! x(k) to x(k+1) the reading at k+1 is one of HF x(k) with the noise Hv + w, of the covariance HVHᵀ + W. What v has in
//! common with it is taken out: with L = VHᵀ(HVHᵀ + W)⁻ the dynamics are F − LHF and their noise V − LHV. Its
//! P(k+1 | k) is the P(k+1 | k+1) of the first.

use super::doubling::System;
use crate::lti::Lti;
use alloc::vec::Vec;
use filters::covariance::symmetric;
use filters::linear::gain;
use nalgebra::{DMatrix, DVector};
use numerics::{singular_values, sqrt};

/// A direction of noise of less than this part of the largest, each reading in units of its own, is none.
const ROUNDING: f64 = 1e-12;
/// What a difference leaves of its terms when they are the same.
const NONE: f64 = 1e-14;

/// What is left to know after one reading, after two, and so on, up to a system each of whose readings has noise; empty
/// where W is regular. If some reading is never reached by noise, the last of n systems has a singular W too.
///
/// # Example
/// ```
/// use estimate::dynamic::{System, after_exact_readings};
/// use nalgebra::dmatrix;
/// // A place that is read without noise: with it the noise of a step is known, and the speed's error turns its sign.
/// let (f, g, h) = (dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.125; 0.5], dmatrix![1.0, 0.0]);
/// let system = System::new(f, g.clone(), h, &g * g.transpose(), dmatrix![0.0])?;
/// let left = after_exact_readings(&system);
/// assert_eq!((left[0].f.clone(), left[0].v.amax()), (dmatrix![0.0, 0.0; -4.0, -1.0], 0.0));
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn after_exact_readings(system: &System) -> Vec<System> {
    let mut all: Vec<System> = Vec::new();
    while all.len() < system.f.nrows()
        && let Some(next) = after(all.last().unwrap_or(system))
    {
        all.push(next);
    }
    all
}

/// Whether the last of these, or the system itself, has readings with noise in each direction.
pub(super) fn is_noisy(system: &System) -> bool {
    Noise::of(&system.w).is_some_and(|noise| noise.rank == system.w.nrows())
}

/// One reading later; `None` where each reading has noise.
fn after(system: &System) -> Option<System> {
    if is_noisy(system) {
        return None;
    }
    let Lti { f, g, h, v, w } = system;
    let cross = v * h.transpose();
    let own = h * &cross;
    let sizes = h.abs() * v.abs() * h.abs().transpose();
    let w = symmetric(own.zip_map(&sizes, |entry, size| if entry.abs() > NONE * size { entry } else { 0.0 }) + w);
    let known = &cross * Noise::of(&w)?.inverse();
    let h = h * f;
    let v = difference(v, &(&known * cross.transpose()));
    Some(Lti { f: f - known * &h, g: g.clone(), h, v: symmetric(v), w })
}

/// A covariance less a part of it; a variance that only rounding leaves is none.
fn difference(v: &DMatrix<f64>, part: &DMatrix<f64>) -> DMatrix<f64> {
    let left = v - part;
    let none = |i: usize| left[(i, i)] <= ROUNDING * v[(i, i)];
    DMatrix::from_fn(v.nrows(), v.ncols(), |i, j| if none(i) || none(j) { 0.0 } else { left[(i, j)] })
}

/// The noise of readings, each in a unit of its own.
struct Noise {
    sigma: DVector<f64>,
    directions: DMatrix<f64>,
    values: Vec<f64>,
    rank: usize,
}

impl Noise {
    fn of(w: &DMatrix<f64>) -> Option<Self> {
        let sigma = w.diagonal().map(|variance| sqrt(variance.max(0.0)));
        let over = |i: usize, j: usize| if sigma[i] * sigma[j] > 0.0 { w[(i, j)] / sigma[i] / sigma[j] } else { 0.0 };
        let found = singular_values(DMatrix::from_fn(w.nrows(), w.ncols(), over)).ok()?;
        let largest = found.values.first().copied().unwrap_or(0.0);
        let rank = found.values.iter().filter(|value| **value > ROUNDING * largest).count();
        Some(Self { sigma, directions: found.directions, values: found.values, rank })
    }

    /// An inverse on the directions that have noise.
    fn inverse(&self) -> DMatrix<f64> {
        let p = self.sigma.len();
        let whiten = |i: usize, k: usize| {
            if self.sigma[i] > 0.0 { self.directions[(i, k)] / sqrt(self.values[k]) / self.sigma[i] } else { 0.0 }
        };
        let root = DMatrix::from_fn(p, self.rank, whiten);
        &root * root.transpose()
    }
}

/// P(k | k) of a start after the first readings of these systems, as the last of them begins with it; `None` where a
/// reading has no noise at all.
pub(super) fn start_after(left: &[System], p0: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    left.iter().try_fold(p0.clone(), |p, System { h, w, .. }| gain(&p, h, w).ok().map(|found| found.p))
}

/// P(k+1 | k) of `system` and its gain, from `p`, that of the last of what is [left](after_exact_readings); `None`
/// where the innovation's covariance is singular.
pub fn before_exact_readings(
    system: &System,
    left: &[System],
    p: DMatrix<f64>,
) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
    let p = (0..left.len()).rev().fold(p, |p, i| {
        let System { f, v, .. } = if i == 0 { system } else { &left[i - 1] };
        symmetric(f * p * f.transpose() + v)
    });
    let r = gain(&p, &system.h, &system.w).ok()?.k;
    Some((p, r))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RiccatiLimit::{FromEveryStart, FromLargeStart};
    use crate::dynamic::{riccati_limit, steady_state};
    use nalgebra::dmatrix;

    /// A place and its speed every half second, kicked along `kick`, whose place is read without noise.
    fn kicked(kick: [f64; 2]) -> System {
        let g = DMatrix::from_column_slice(2, 1, &kick);
        let f = dmatrix![1.0, 0.5; 0.0, 1.0];
        System::new(f, g.clone(), dmatrix![1.0, 0.0], &g * g.transpose(), dmatrix![0.0]).expect("sound")
    }

    /// P(k+1 | k) after so many single steps from P(0 | 0) = 0 and from I.
    fn stepped(system: &System) -> [DMatrix<f64>; 2] {
        let n = system.f.nrows();
        [0.0, 1.0].map(|from| system.steady_state_gain(&(DMatrix::identity(n, n) * from), 300, 0.0).expect("runs").p)
    }

    /// Kicks from which the place moves first one way and then the other hide from the filter that trusts its readings.
    #[test]
    fn a_reading_without_noise_is_asked_about_the_system_that_it_leaves() {
        for (kick, expected) in
            [([0.125, 0.5], FromLargeStart), ([0.1, 0.5], FromLargeStart), ([0.15, 0.5], FromEveryStart)]
        {
            let system = kicked(kick);
            assert_eq!(riccati_limit(&system, 1e-9).expect("found"), expected, "{kick:?}");
            let [nothing, one] = stepped(&system);
            assert_eq!((nothing - one).amax() < 1e-6, expected == FromEveryStart, "{kick:?}");
        }
    }

    #[test]
    fn its_limit_is_found_where_the_recursion_itself_loses_it() {
        let system = kicked([0.1, 0.5]);
        let found = steady_state(&system, DMatrix::zeros(2, 2)).expect("found");
        assert!(found.converged && found.depends_on_start, "{found:?}");
        assert!((found.p - &system.v).amax() < 1e-15 && (found.r - dmatrix![1.0; 5.0]).amax() < 1e-14);
    }

    /// Two readings, of which only the second has noise, and a place that noise reaches two steps later.
    #[test]
    fn noise_may_come_to_a_reading_late() {
        let f = dmatrix![1.0, 0.5, 0.2; 0.0, 1.0, 0.5; 0.0, 0.0, 1.0];
        let h = dmatrix![1.0, 0.0, 0.0; 0.0, 1.0, 0.0];
        let v = dmatrix![0.0, 0.0, 0.0; 0.0, 0.0, 0.0; 0.0, 0.0, 0.05];
        let system = System::new(f, DMatrix::zeros(3, 0), h, v, dmatrix![0.0, 0.0; 0.0, 0.1]).expect("sound");
        let left = after_exact_readings(&system);
        assert_eq!((left.len(), left.last().map(is_noisy)), (2, Some(true)), "{left:?}");
        let direct = system.steady_state_gain(&DMatrix::identity(3, 3), 400, 0.0).expect("runs");
        let last = left.last().expect("two").clone();
        let start = start_after(&left, &DMatrix::identity(3, 3)).expect("regular");
        let (p, r) =
            before_exact_readings(&system, &left, steady_state(&last, start).expect("found").p).expect("regular");
        assert!((p - &direct.p).amax() < 1e-9 * direct.p.amax() && (r - direct.r).amax() < 1e-8);
        // What is read without noise and never moved stays without.
        let still = System::new(dmatrix![1.0], DMatrix::zeros(1, 0), dmatrix![1.0], dmatrix![0.0], dmatrix![0.0]);
        assert!(after_exact_readings(&still.expect("sound")).last().is_some_and(|last| !is_noisy(last)));
        let noisy = System::new(dmatrix![1.0], DMatrix::zeros(1, 0), dmatrix![1.0], dmatrix![0.0], dmatrix![1e-30]);
        assert!(after_exact_readings(&noisy.expect("sound")).is_empty());
    }
}
