//! What a system lets an observer know: detectability, what noise and inputs reach, and whether the covariance has a
//! limit.

use super::{System, pair};
use crate::averages;
use crate::detectability::{self, Detectability};
use crate::error::{Code, Error};
use crate::placement::Movable;
use crate::reachability::{self, Reachability};
use crate::riccati_limit::RiccatiLimit;
use crate::validate::{self, MAX_STATES, size};
use crate::verdict::Verdict;
use alloc::format;
use nalgebra::DMatrix;

/// Whether (F, H) is observable, and whether it is detectable: what is unseen dies out by itself. The `tolerance` is
/// how well the numbers are known; an eigenvalue of modulus 1 − `tolerance` or more does not decay.
///
/// # Errors
/// [`Code::Limit`], [`Code::Shape`], [`Code::NotFinite`] or [`Code::Tolerance`] naming the argument,
/// [`Code::DidNotConverge`].
///
/// # Example
/// ```
/// use estimate::{Verdict, dynamic::detectability};
/// use nalgebra::dmatrix;
/// let found = detectability(dmatrix![0.5, 0.0; 0.0, 1.0], dmatrix![0.0, 1.0], 1e-9)?;
/// assert_eq!((found.observable, found.detectable), (Verdict::No, Verdict::Yes));
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn detectability(f: DMatrix<f64>, h: DMatrix<f64>, tolerance: f64) -> Result<Detectability, Error> {
    let (f, h) = pair(f, h)?;
    detectability::detectability(&f, &h, tolerance)
}

/// Whether (F, B) is reachable, and whether it is stabilizable, for an input matrix B, n×m with m ≤ 16.
///
/// # Errors
/// As [`detectability`].
///
/// # Example
/// ```
/// use estimate::{Verdict, dynamic::stabilizability};
/// use nalgebra::dmatrix;
/// let found = stabilizability(dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.0; 0.5], 1e-9)?;
/// assert_eq!(found.reachable, Verdict::Yes);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn stabilizability(f: DMatrix<f64>, b: DMatrix<f64>, tolerance: f64) -> Result<Reachability, Error> {
    let n = f.nrows();
    size(n, MAX_STATES, "F")?;
    if b.ncols() > MAX_STATES {
        return Err(Error::new(Code::Limit, "B", format!("has {} inputs; at most {MAX_STATES}", b.ncols())));
    }
    let f = validate::matrix(f, (n, n), "F")?;
    let m = b.ncols();
    let b = validate::matrix(b, (n, m), "B")?;
    reachability::reachability(&f, &b, tolerance)
}

/// Which eigenvalues of (I − KH)F a gain can move, and the gain that moves them, for one output or several. The
/// `tolerance` is as in [`detectability`].
///
/// # Errors
/// As [`detectability`].
pub fn movable(f: DMatrix<f64>, h: DMatrix<f64>, tolerance: f64) -> Result<Movable, Error> {
    let (f, h) = pair(f, h)?;
    Movable::new(&f, &h, tolerance)
}

/// [`stabilizability`] of (F, V^½): what noise of the covariance V reaches.
///
/// # Errors
/// As there; for V as [`validate::covariance`].
pub fn noise_reach(f: DMatrix<f64>, v: DMatrix<f64>, tolerance: f64) -> Result<Reachability, Error> {
    let n = f.nrows();
    size(n, MAX_STATES, "F")?;
    let v = validate::covariance(v, n, "V")?;
    reachability::noise_reach(&validate::matrix(f, (n, n), "F")?, &v, tolerance)
}

/// A matrix B, n×n, with V = BBᵀ, also of a singular `v`: Bz is noise of the covariance V for n independent standard
/// normal numbers z.
///
/// # Errors
/// For V as [`validate::covariance`]; [`Code::DidNotConverge`].
///
/// # Example
/// ```
/// let b = estimate::dynamic::noise_input(nalgebra::dmatrix![4.0, 2.0; 2.0, 1.0])?;
/// assert!((&b * b.transpose() - nalgebra::dmatrix![4.0, 2.0; 2.0, 1.0]).amax() < 1e-14);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn noise_input(v: DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
    let n = v.nrows();
    size(n, MAX_STATES, "V")?;
    reachability::noise_input(&validate::covariance(v, n, "V")?)
}

/// Whether P(k+1 | k) tends to a limit, and why. Of a reading without noise what noise reaches is asked of what is left
/// to know after it ([`after_exact_readings`](super::after_exact_readings)).
///
/// # Errors
/// As [`detectability`].
///
/// # Example
/// ```
/// use estimate::{RiccatiLimit, dynamic::{System, riccati_limit}};
/// use nalgebra::{DMatrix, dmatrix};
/// let (f, g) = (dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.0; 0.5]);
/// let velocity = System::new(f, g, dmatrix![0.0, 1.0], DMatrix::identity(2, 2), dmatrix![0.5])?;
/// assert_eq!(riccati_limit(&velocity, 1e-9)?, RiccatiLimit::None);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn riccati_limit(system: &System, tolerance: f64) -> Result<RiccatiLimit, Error> {
    let detectable = detectability(system.f.clone(), system.h.clone(), tolerance)?.detectable;
    validate::covariance(system.v.clone(), system.f.nrows(), "V")?;
    let left = super::after_exact_readings(system);
    let System { f, v, .. } = left.last().unwrap_or(system);
    let stabilizable = reachability::noise_reach(f, v, tolerance)?.stabilizable;
    Ok(RiccatiLimit::of(detectable, stabilizable))
}

/// Whether P(k+1 | k) falls for ever as the variance of an average does, by 1/k and not by a factor in each step: from
/// every start that does not know for certain what is averaged. It does where the readings tell, by itself, a
/// combination of the states that F keeps alive on the unit circle and noise does not feed. A combination that they
/// tell only in a sum with another that noise feeds is known from the start alone, and P comes to rest. Of a reading
/// without noise it is asked of what is left to know after it.
///
/// # Errors
/// As [`riccati_limit`].
///
/// # Example
/// ```
/// use estimate::{Verdict, dynamic::{System, falls_as_average}};
/// use nalgebra::{DMatrix, dmatrix};
/// let constants = |h, v| System::new(DMatrix::identity(2, 2), DMatrix::zeros(2, 0), h, v, dmatrix![0.2]);
/// let still = constants(dmatrix![1.0, 0.0], DMatrix::zeros(2, 2))?;
/// assert_eq!(falls_as_average(&still, 1e-12)?, Verdict::Yes);
/// // Beside a walk that the same reading tells, the constant is told by the start alone.
/// let beside = constants(dmatrix![1.0, 1.0], dmatrix![0.001, 0.0; 0.0, 0.0])?;
/// assert_eq!(falls_as_average(&beside, 1e-12)?, Verdict::No);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn falls_as_average(system: &System, tolerance: f64) -> Result<Verdict, Error> {
    validate::covariance(system.v.clone(), system.f.nrows(), "V")?;
    let left = super::after_exact_readings(system);
    averages::falls_as_average(left.last().unwrap_or(system), tolerance)
}
