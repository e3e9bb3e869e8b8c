//! Steps of the Riccati recursion, doubled (Anderson, International Journal of Control 28, 1978, 295–306; Chu, Fan, Lin
//! and Wang, ibid. 77, 2004, 767–788): fifty doublings go as far as 10¹⁵ steps.
//!
//! With P = Y + Δ, where Y is a covariance that the recursion has come to, a step is Δ ↦ E + AᵀΔ(I + GΔ)⁻¹A, and so
//! are two, four and eight steps, with other A, G and E. E is the change of P since Y, so with E of 2ᵏ steps P is known
//! after 2ᵏ. A is what these steps leave of a small change of Y.

use super::blame;
use crate::error::Error;
use crate::lti::Lti;
use filters::covariance::{is_finite, symmetric};
use filters::linear::{Gain, complement, gain, innovation_covariance, predicted_covariance};
use nalgebra::{DMatrix, DVector, Dyn};
use numerics::{Spd, power_of_two, sqrt};

/// A system whose sizes are known at run time only: the doubling is compiled once.
pub(super) type System = Lti<Dyn, Dyn, Dyn>;

/// Doublings: 2⁵⁰ steps.
const DOUBLINGS: i32 = 50;
/// Where neither P nor the gain settles, they are answered as they were after at most so many doublings.
const TRIED: i32 = 10;
/// A change of P by a smaller part of its variances is none.
const NONE: f64 = 4e-16;
/// What rounding leaves of a variance that has died out, as a part of what it was.
const ROUNDING: f64 = 1e-14;
/// To so many digits P has settled, though what it was at the start is not forgotten.
const SETTLED: f64 = 1e-12;
/// A change that each doubling makes smaller dies away; as in the 1/k of a state that is seen and never moved.
const DYING: f64 = 1e-6;
/// A step may change a limit by this part of its variances, which rounding and a slow end leave.
const STILL: f64 = 1e-9;
/// What may be left of a large start, as a part of the variances, where the limit is the same.
const SAME: f64 = 1e-6;

/// A system in units in which each variance of a covariance lies between a quarter and one, and so do those of the
/// innovation. The units are powers of two, so that nothing is rounded.
#[derive(Clone)]
pub(super) struct Scaled {
    system: System,
    p: DMatrix<f64>,
    pub units: DVector<f64>,
    outputs: DVector<f64>,
}

impl Scaled {
    pub fn of(system: &System, p: &DMatrix<f64>) -> Self {
        let unit = |variance: f64| power_of_two(sqrt(variance.max(0.0)));
        let units = p.diagonal().map(unit);
        let outputs = innovation_covariance(&system.h, p, &system.w).diagonal().map(unit);
        let over = |m: &DMatrix<f64>, rows: &DVector<f64>, columns: &dyn Fn(usize) -> f64| {
            DMatrix::from_fn(m.nrows(), m.ncols(), |i, j| m[(i, j)] / rows[i] * columns(j))
        };
        let (times, by) = (|j: usize| units[j], |j: usize| 1.0 / units[j]);
        let scaled = System {
            f: over(&system.f, &units, &times),
            g: DMatrix::zeros(units.len(), 0),
            h: over(&system.h, &outputs, &times),
            v: over(&system.v, &units, &by),
            w: over(&system.w, &outputs, &|j| 1.0 / outputs[j]),
        };
        let p = over(p, &units, &by);
        Self { system: scaled, p, units, outputs }
    }

    /// A gain in the caller's units.
    pub fn given_gain(&self, r: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(r.nrows(), r.ncols(), |i, j| r[(i, j)] * self.units[i] / self.outputs[j])
    }

    /// Whether a step leaves the covariance as it is.
    pub fn holds_still(&self) -> bool {
        self.is_still(&self.p)
    }

    fn is_still(&self, p: &DMatrix<f64>) -> bool {
        step(&self.system, p).is_ok_and(|(_, next)| part_of(&(next - p), p) <= STILL)
    }

    fn gain(&self, p: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        gain(p, &self.system.h, &self.system.w).ok().map(|found| found.k)
    }

    /// A covariance in the caller's units. A variance that is rounding beside the one it came from is zero.
    pub fn given(&self, p: &DMatrix<f64>) -> DMatrix<f64> {
        let known = |i: usize| p[(i, i)] > ROUNDING;
        let entry = |i: usize, j: usize| {
            if known(i) && known(j) { p[(i, j)] * self.units[i] * self.units[j] } else { 0.0 }
        };
        DMatrix::from_fn(p.nrows(), p.ncols(), entry)
    }
}

/// A number of steps from Y: see above.
pub(super) struct Doubling {
    a: DMatrix<f64>,
    g: DMatrix<f64>,
    e: DMatrix<f64>,
    /// Y.
    base: DMatrix<f64>,
    /// Δ at the start.
    start: DMatrix<f64>,
}

/// Where the doublings have come to, in the units of [`Scaled`].
#[derive(Clone)]
pub(super) struct Doubled {
    pub p: DMatrix<f64>,
    pub r: DMatrix<f64>,
    pub converged: bool,
    pub gain_converged: bool,
    /// Whether every digit of the limit was found, and nothing of the start is left.
    pub whole: bool,
    pub depends_on_start: bool,
    pub steps: f64,
}

/// P after so many steps.
struct Mark {
    steps: f64,
    p: DMatrix<f64>,
}

impl Doubling {
    /// One step from the covariance that the recursion has come to, with Y the same: small changes are kept to all
    /// digits, whatever F does.
    ///
    /// # Errors
    /// As [`step`].
    pub fn at(scaled: &Scaled) -> Result<Self, Error> {
        let (System { f, h, w, v, .. }, p) = (&scaled.system, &scaled.p);
        let Gain { k: r, s, p: posterior, .. } = gain(p, h, w).map_err(blame)?;
        let next = predicted_covariance(f, &posterior, v).map_err(blame)?;
        let information = Spd::new(s).ok_or(filters::Error::InnovationNotPositiveDefinite).map_err(blame)?.solve(h);
        Ok(Self {
            a: (f * complement(&r, h)).transpose(),
            g: symmetric(h.transpose() * information),
            e: symmetric(next - p),
            base: p.clone(),
            start: p * 0.0,
        })
    }

    /// One step from there with Y = 0: all terms are positive, and a variance that dies away for ever keeps its digits.
    /// `None` where W is singular.
    pub fn from_nothing(scaled: &Scaled) -> Option<Self> {
        let (System { f, h, w, v, .. }, p) = (&scaled.system, &scaled.p);
        let g = symmetric(h.transpose() * Spd::new(w.clone())?.solve(h));
        Some(Self { a: f.transpose(), g, e: v.clone(), base: p * 0.0, start: p.clone() })
    }

    fn covariance(&self) -> Option<DMatrix<f64>> {
        Some(&self.base + &self.e + self.left_of(&self.start)?)
    }

    /// How far from P one comes from a larger start, as a part of the variances.
    fn far_start(&self, far: &DMatrix<f64>, p: &DMatrix<f64>) -> f64 {
        let other = self.left_of(far).map(|left| &self.base + &self.e + left);
        other.map_or(f64::INFINITY, |other| part_of(&(other - p), p))
    }

    /// What is left of a Δ of the start: AᵀΔ(I + GΔ)⁻¹A.
    fn left_of(&self, delta: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let n = self.a.nrows();
        let left = solved(DMatrix::identity(n, n) + &self.g * delta, self.a.clone())?;
        Some(symmetric(self.a.transpose() * delta * left))
    }

    /// Twice as many steps; `None` where a number is no longer finite.
    fn doubled(&self) -> Option<Self> {
        let (Self { a, g, e, .. }, n) = (self, self.a.nrows());
        let mut both = DMatrix::zeros(n, 2 * n);
        both.columns_mut(0, n).copy_from(a);
        both.columns_mut(n, n).copy_from(g);
        let solved = solved(DMatrix::identity(n, n) + g * e, both)?;
        let (left, seen) = (solved.columns(0, n).into_owned(), solved.columns(n, n).into_owned());
        let next = Self {
            e: e + symmetric(a.transpose() * e * &left),
            g: g + symmetric(a * seen * a.transpose()),
            a: a * left,
            base: self.base.clone(),
            start: self.start.clone(),
        };
        (is_finite(&next.a) && is_finite(&next.g) && is_finite(&next.e)).then_some(next)
    }

    /// Doubles until nothing changes any more; `None` where even the first gain cannot be told. Of a P that is not
    /// `bounded` the gain alone may settle: a growth by less than rounding would look like rest.
    pub fn run(mut self, scaled: &Scaled, bounded: bool) -> Option<Doubled> {
        let (mut size, mut falls, mut forgotten) = (f64::INFINITY, 0, f64::INFINITY);
        // P where it has settled: since when, and where it changed least.
        let mut settled: Option<(f64, f64, DMatrix<f64>)> = None;
        let (mut r, mut calm) = (scaled.gain(&scaled.p), None);
        let far = &self.start + DMatrix::identity(self.a.nrows(), self.a.nrows());
        let mut last = Mark { steps: 0.0, p: scaled.p.clone() };
        let mut tried = Mark { steps: 0.0, p: scaled.p.clone() };
        let (mut whole, mut dying) = (false, false);
        for k in 1..=DOUBLINGS {
            let Some((next, p)) = self.doubled().and_then(|next| next.covariance().map(|p| (next, p))) else { break };
            let (before, change) = (size, &p - &last.p);
            self = next;
            last = Mark { steps: libm::ldexp(1.0, k), p };
            size = part_of(&change, &last.p);
            forgotten = self.far_start(&far, &last.p);
            falls = if size <= 0.75 * before { falls + 1 } else { 0 };
            if calm.is_none() {
                let next = scaled.gain(&last.p);
                if let (Some(next), Some(r)) = (&next, &r)
                    && (next - r).amax() <= SETTLED * next.amax()
                {
                    calm = Some(Mark { steps: last.steps, p: last.p.clone() });
                }
                if k <= TRIED && next.is_some() {
                    tried = Mark { steps: last.steps, p: last.p.clone() };
                }
                r = next;
            }
            if bounded && size <= SETTLED && settled.as_ref().is_none_or(|(_, least, _)| size < *least) {
                let since = settled.map_or(last.steps, |(since, ..)| since);
                settled = Some((since, size, last.p.clone()));
            }
            whole = bounded && size <= NONE && forgotten <= NONE;
            if whole {
                break;
            }
            dying = bounded && k == DOUBLINGS && falls > 3 && size <= DYING;
            if dying {
                // What is yet to come: each doubling brings half of what the one before it brought.
                settled = Some((last.steps, size, &last.p + change));
            }
        }
        let gain_converged = calm.is_some();
        // Where P changes no more though the start is neither forgotten nor kept, rounding holds it.
        let settles = settled.is_some() && (whole || dying || forgotten > SAME);
        let Mark { steps, p } = match settled {
            Some((steps, _, p)) => Mark { steps, p },
            None => calm.unwrap_or(tried),
        };
        // Of a state that turns round and round, every 2ᵏ-th place may be the same one.
        let converged = settles && scaled.is_still(&p);
        // Where the variances have grown so far that no gain can be told, it is that of the start.
        let (r, p, steps) = match scaled.gain(&p) {
            Some(r) => (r, p, steps),
            None => (scaled.gain(&scaled.p)?, scaled.p.clone(), 0.0),
        };
        let depends_on_start = !whole && forgotten > SAME;
        Some(Doubled { gain_converged, whole: whole && converged, depends_on_start, steps, converged, p, r })
    }
}

/// R from P(k+1 | k), and P(k+2 | k+1).
pub(super) fn step(system: &System, p: &DMatrix<f64>) -> Result<(DMatrix<f64>, DMatrix<f64>), Error> {
    let Gain { k: r, p: posterior, .. } = gain(p, &system.h, &system.w).map_err(blame)?;
    Ok((r, predicted_covariance(&system.f, &posterior, &system.v).map_err(blame)?))
}

/// The largest entry of a change of the covariance `p`, as a part of the variances that it belongs to, of which none
/// counts as smaller than 1.
fn part_of(change: &DMatrix<f64>, p: &DMatrix<f64>) -> f64 {
    let size = p.diagonal().map(|variance| sqrt(variance.max(1.0)));
    DMatrix::from_fn(p.nrows(), p.ncols(), |i, j| change[(i, j)] / size[i] / size[j]).amax()
}

/// M⁻¹B by elimination with the largest pivots; `None` where M is singular.
fn solved(mut m: DMatrix<f64>, mut b: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = m.nrows();
    for j in 0..n {
        let (mut pivot, mut most) = (j, 0.0);
        for i in j..n {
            if m[(i, j)].abs() > most {
                (pivot, most) = (i, m[(i, j)].abs());
            }
        }
        if most < f64::MIN_POSITIVE {
            return None;
        }
        m.swap_rows(j, pivot);
        b.swap_rows(j, pivot);
        for i in j + 1..n {
            let factor = m[(i, j)] / m[(j, j)];
            (j + 1..n).for_each(|k| m[(i, k)] -= factor * m[(j, k)]);
            (0..b.ncols()).for_each(|k| b[(i, k)] -= factor * b[(j, k)]);
        }
    }
    for k in 0..b.ncols() {
        for i in (0..n).rev() {
            let rest = (i + 1..n).fold(b[(i, k)], |rest, j| rest - m[(i, j)] * b[(j, k)]);
            b[(i, k)] = rest / m[(i, i)];
        }
    }
    Some(b)
}
