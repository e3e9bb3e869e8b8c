//! How likely a log is under a linear system, and the noise levels under which it is likeliest (Mehra 1970; Bar-Shalom,
//! Li and Kirubarajan 2001, §5.4). The innovations of a Kalman filter are independent where its system is right, so
//! that the density of a whole log is the product of theirs.

use crate::error::{Code, Error};
use crate::followed::Followed;
use crate::kf::{Gaussian, blame, fit};
use crate::lti::{Lti, SystemSizes};
use nalgebra::{DefaultAllocator, Dim, Matrix2, OMatrix, OVector, Vector2};
use numerics::{MIN_PIVOT, Maximum, Spd, maximum};

/// ln 2π.
pub(crate) const LN_TWO_PI: f64 = 1.837_877_066_409_345_3;
/// Where the search for the likeliest noise starts: the best of so many squared points, spread over the box.
const STARTS: usize = 5;
/// The step of the differences, in natural logarithms. The second derivatives of a log of 1000 readings are then good
/// to five digits, which rounding takes; truncation takes less.
const STEP: f64 = 1e-4;
/// The search stops where a step promises no more log-likelihood than this: within 10⁻⁵ standard deviations of the
/// maximum.
const TOLERANCE: f64 = 1e-10;

/// ln N(ν; 0, S) = −½ (ln det 2πS + νᵀS⁻¹ν) of an innovation ν (p) with its covariance S (p×p); nothing where S is too
/// near to singular for eight digits of the answer (a pivot below [`MIN_PIVOT`]), or the answer too large for a number.
///
/// # Example
/// ```
/// use nalgebra::{Matrix1, Vector1};
/// let density = estimate::likelihood::log_density(&Vector1::new(2.0), &Matrix1::new(4.0));
/// // −½ (ln 2π + ln 4 + 1).
/// assert!((density.unwrap() + 2.112085713764618).abs() < 1e-14);
/// ```
pub fn log_density<M: Dim>(innovation: &OVector<f64, M>, s: &OMatrix<f64, M, M>) -> Option<f64>
where
    DefaultAllocator: nalgebra::allocator::Allocator<M> + nalgebra::allocator::Allocator<M, M>,
{
    let spd = Spd::new(s.clone()).filter(|spd| spd.pivot() >= MIN_PIVOT)?;
    let outputs = innovation.len() as f64;
    let density = -0.5 * (outputs * LN_TWO_PI + spd.ln_determinant() + spd.squared_length(innovation));
    density.is_finite().then_some(density)
}

/// One step of a log: the input u (m) that acted before it, and the reading y (p).
pub type Entry<U, M> = (OVector<f64, U>, OVector<f64, M>);

/// The log-likelihood of a log, Σ −½ (ln det 2πS + νᵀS⁻¹ν) over its steps, from the belief before the first of them.
///
/// # Errors
/// As [`kalman_step`](crate::kf::kalman_step); [`Code::InnovationNotPositiveDefinite`] where an S is too near to
/// singular for [`log_density`], or rounding has left less than six digits of one.
///
/// # Example
/// ```
/// use estimate::likelihood::log_likelihood;
/// use nalgebra::Vector1;
/// let (system, belief) = estimate::rail::position_sensor();
/// let log = [3.1, 5.0, 7.4].map(|y| (Vector1::zeros(), Vector1::new(y)));
/// let likelihood = log_likelihood(&system, &belief, &log)?;
/// assert!(likelihood < 0.0);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn log_likelihood<N: Dim, U: Dim, M: Dim>(
    system: &Lti<N, U, M>,
    belief: &Gaussian<N>,
    log: &[Entry<U, M>],
) -> Result<f64, Error>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    let (mut followed, mut sum) = (Followed::from(belief.clone()), 0.0);
    for (u, y) in log {
        fit(system, &followed, u, y)?;
        followed.predict(&system.f, &system.v, Some((&system.g, u))).map_err(blame)?;
        let update = followed.correct(y, &system.h, &system.w).map_err(blame)?;
        sum += log_density(&update.innovation, &update.s)
            .filter(|_| followed.conditioned())
            .ok_or_else(|| blame(filters::Error::InnovationNotPositiveDefinite))?;
    }
    Ok(sum)
}

/// The noise levels under which a log is likeliest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoiseFit {
    /// The factor of V.
    pub q: f64,
    /// The factor of W.
    pub w: f64,
    /// The log-likelihood with qV and wW.
    pub log_likelihood: f64,
    /// The observed Fisher information in (ln q, ln w): minus the second derivatives of the log-likelihood, 2×2, by
    /// central differences of 10⁻⁴. Its inverse estimates the covariance of (ln q, ln w) where neither is held and the
    /// log is long.
    pub information: Matrix2<f64>,
    /// Whether q and w were held by a bound: the log is likelier still beyond it.
    pub held: [bool; 2],
    /// Whether the search ended at a maximum, and not because its steps ran out.
    pub converged: bool,
}

/// The maximum of the log-likelihood over the factors q of the system's V and w of its W, each within `bounds` (least
/// and greatest of q, then of w). It is sought in (ln q, ln w), by Newton's method from the best of 25 starts, and ends
/// where a step promises at most 10⁻¹⁰ more.
///
/// # Errors
/// [`Code::Limit`] naming `log` where it is empty, or `bounds` where they are not positive, finite and rising; as
/// [`log_likelihood`] where that has no answer at the middle of the bounds.
///
/// # Example
/// ```
/// use estimate::likelihood::fit_noise;
/// use nalgebra::Vector1;
/// let (system, belief) = estimate::rail::position_sensor();
/// let read = |k: u32| Vector1::new(2.0 + 2.0 * f64::from(k) + f64::from(k * k % 7));
/// let log: Vec<_> = (0..60).map(|k| (Vector1::zeros(), read(k))).collect();
/// let fit = fit_noise(&system, &belief, &log, &[[0.01, 100.0]; 2])?;
/// assert!(fit.converged && fit.w > 1.0);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn fit_noise<N: Dim, U: Dim, M: Dim>(
    system: &Lti<N, U, M>,
    belief: &Gaussian<N>,
    log: &[Entry<U, M>],
    bounds: &[[f64; 2]; 2],
) -> Result<NoiseFit, Error>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    if log.is_empty() {
        return Err(Error::new(Code::Limit, "log", "is empty: no noise can be told from it"));
    }
    let rising = |[least, greatest]: &[f64; 2]| 0.0 < *least && least < greatest && greatest.is_finite();
    if !bounds.iter().all(rising) {
        return Err(Error::new(Code::Limit, "bounds", "must be positive and finite, the least below the greatest"));
    }
    let at = |x: &Vector2<f64>| {
        let (q, w) = (libm::exp(x[0]), libm::exp(x[1]));
        log_likelihood(&Lti { v: &system.v * q, w: &system.w * w, ..system.clone() }, belief, log)
    };
    let bounds = bounds.map(|ends| ends.map(libm::log));
    let between = |[least, greatest]: [f64; 2], share: f64| least + share * (greatest - least);
    at(&Vector2::from(bounds.map(|ends| between(ends, 0.5))))?;
    let likelihood = |x: &Vector2<f64>| at(x).unwrap_or(f64::NAN);
    let share = |i: usize| (i as f64 + 0.5) / STARTS as f64;
    let starts = (0..STARTS * STARTS)
        .map(|i| Vector2::new(between(bounds[0], share(i / STARTS)), between(bounds[1], share(i % STARTS))));
    let best = starts.map(|x| (likelihood(&x), x)).reduce(|best, next| if next.0 > best.0 { next } else { best });
    let start = best.map_or_else(Vector2::zeros, |(_, x)| x);
    let Maximum { at, value, hessian, held, converged, .. } = maximum(likelihood, start, &bounds, STEP, TOLERANCE);
    Ok(NoiseFit {
        q: libm::exp(at[0]),
        w: libm::exp(at[1]),
        log_likelihood: value,
        information: -hessian,
        held,
        converged,
    })
}

#[cfg(test)]
mod tests;
