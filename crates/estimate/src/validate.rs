//! The checks that every argument from outside passes.

use crate::error::{Code, Error};
use alloc::format;
use filters::Gaussian;
use filters::covariance::{NotCovariance, accepted, is_finite};
use nalgebra::{DMatrix, DVector, Dyn};

/// The largest number of states of a run-time system.
pub const MAX_STATES: usize = 16;
/// The largest number of outputs of a run-time system.
pub const MAX_OUTPUTS: usize = 8;
/// The largest number of inputs of a run-time system.
pub const MAX_INPUTS: usize = 8;
/// The most work of one call, counted as (n + p)³ for each Kalman step of n states and p outputs: 10 000 steps of the
/// largest run-time system. So whoever waits for a call knows beforehand how long it can take at most.
pub const MAX_WORK: usize = 10_000 * (MAX_STATES + MAX_OUTPUTS).pow(3);

/// `value`, when it is neither a NaN nor an infinity.
///
/// # Errors
/// [`Code::NotFinite`] blaming `argument`.
pub fn finite(value: f64, argument: &'static str) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(not_finite(argument)) }
}

/// `v`, when it is finite and has `len` entries.
///
/// # Errors
/// [`Code::Shape`] or [`Code::NotFinite`] blaming `argument`.
pub fn vector(v: DVector<f64>, len: usize, argument: &'static str) -> Result<DVector<f64>, Error> {
    entries(v.as_slice(), len, argument)?;
    Ok(v)
}

/// Whether `numbers` are `len` finite ones.
///
/// # Errors
/// [`Code::Shape`] or [`Code::NotFinite`] blaming `argument`.
pub fn entries(numbers: &[f64], len: usize, argument: &'static str) -> Result<(), Error> {
    if numbers.len() != len {
        return Err(Error::new(Code::Shape, argument, format!("has {} entries; it needs {len}", numbers.len())));
    }
    if numbers.iter().all(|number| number.is_finite()) { Ok(()) } else { Err(not_finite(argument)) }
}

/// `m`, when it is finite and `rows` × `columns`.
///
/// # Errors
/// [`Code::Shape`] or [`Code::NotFinite`] blaming `argument`.
pub fn matrix(m: DMatrix<f64>, (rows, columns): (usize, usize), argument: &'static str) -> Result<DMatrix<f64>, Error> {
    let m = shaped(m, (rows, columns), argument)?;
    if is_finite(&m) { Ok(m) } else { Err(not_finite(argument)) }
}

fn shaped(m: DMatrix<f64>, (rows, columns): (usize, usize), argument: &'static str) -> Result<DMatrix<f64>, Error> {
    if m.shape() == (rows, columns) {
        return Ok(m);
    }
    let (r, c) = m.shape();
    Err(Error::new(Code::Shape, argument, format!("is {r} × {c}; it needs to be {rows} × {columns}")))
}

/// `m` as a covariance of `n` components; see [`accepted`], which says what counts as one up to rounding.
///
/// # Errors
/// [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`] or [`Code::NotPositiveSemidefinite`], blaming
/// `argument`.
pub fn covariance(m: DMatrix<f64>, n: usize, argument: &'static str) -> Result<DMatrix<f64>, Error> {
    accepted(shaped(m, (n, n), argument)?).map_err(|refusal| match refusal {
        NotCovariance::NotFinite => not_finite(argument),
        NotCovariance::NotSymmetric(i, j) => {
            let message = format!("entries ({i}, {j}) and ({j}, {i}) differ; a covariance is symmetric");
            Error::new(Code::NotSymmetric, argument, message)
        }
        NotCovariance::NegativeEigenvalue => {
            let message = "has a negative eigenvalue; a covariance has none";
            Error::new(Code::NotPositiveSemidefinite, argument, message)
        }
        NotCovariance::DidNotConverge => Error::new(Code::DidNotConverge, argument, "its eigenvalues were not found"),
    })
}

/// The belief N(x, P), when `x` is finite and `p` a covariance of its size.
///
/// # Errors
/// Naming x or P: [`Code::Limit`], [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`] or
/// [`Code::NotPositiveSemidefinite`].
///
/// # Example
/// ```
/// use nalgebra::{dmatrix, dvector};
/// let belief = estimate::validate::belief(dvector![2.0, 4.0], dmatrix![1.0, 0.0; 0.0, 2.0])?;
/// assert_eq!(belief.x[1], 4.0);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn belief(x: DVector<f64>, p: DMatrix<f64>) -> Result<Gaussian<Dyn>, Error> {
    let n = x.len();
    size(n, MAX_STATES, "x")?;
    Ok(Gaussian { x: vector(x, n, "x")?, p: covariance(p, n, "P")? })
}

/// # Errors
/// [`Code::Shape`] for no row, [`Code::Limit`] for more than `cap`, blaming `argument`.
pub(crate) fn size(n: usize, cap: usize, argument: &'static str) -> Result<(), Error> {
    match n {
        0 => Err(Error::new(Code::Shape, argument, "is empty")),
        n if n > cap => Err(Error::new(Code::Limit, argument, format!("has {n} rows; at most {cap} are accepted"))),
        _ => Ok(()),
    }
}

/// `tolerance`, when it is finite and not negative.
///
/// # Errors
/// [`Code::Tolerance`] blaming `argument`.
pub fn tolerance(tolerance: f64, argument: &'static str) -> Result<f64, Error> {
    if tolerance.is_finite() && tolerance >= 0.0 {
        Ok(tolerance)
    } else {
        Err(Error::new(Code::Tolerance, argument, "a tolerance is a finite number, zero or more"))
    }
}

/// `count`, when it lies between 1 and `cap`.
///
/// # Errors
/// [`Code::Limit`] blaming `argument`.
pub fn count(count: usize, cap: usize, argument: &'static str) -> Result<usize, Error> {
    if (1..=cap).contains(&count) {
        Ok(count)
    } else {
        Err(Error::new(Code::Limit, argument, format!("is {count}; it must be at least 1 and at most {cap}")))
    }
}

/// The most Kalman steps of `states` and `outputs` that one call takes: what [`MAX_WORK`] allows, and never more than
/// `cap`.
pub fn affordable_steps(states: usize, outputs: usize, cap: usize) -> usize {
    let step = (states + outputs).saturating_pow(3).max(1);
    (MAX_WORK / step).clamp(1, cap)
}

fn not_finite(argument: &'static str) -> Error {
    Error::new(Code::NotFinite, argument, "holds a NaN or an infinity; every number must be finite")
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    fn code(m: DMatrix<f64>) -> Result<(), Code> {
        let n = m.nrows();
        covariance(m, n, "P").map(|_| ()).map_err(|e| e.code)
    }

    #[test]
    fn rank_one_zero_and_ill_conditioned_covariances_pass() {
        let v = nalgebra::DVector::from_vec(vec![0.1, -0.7, 2.3]);
        assert_eq!(code(&v * v.transpose()), Ok(()));
        assert_eq!(code(DMatrix::zeros(3, 3)), Ok(()));
        assert_eq!(code(DMatrix::from_diagonal(&nalgebra::DVector::from_vec(vec![1e13, 1.0]))), Ok(()));
        assert_eq!(code(dmatrix![1e308, 0.0; 0.0, 1e308]), Ok(()));
    }

    #[test]
    fn a_matrix_that_is_no_covariance_is_refused() {
        assert_eq!(code(dmatrix![1.0, 2.0; 2.0, 1.0]), Err(Code::NotPositiveSemidefinite));
        assert_eq!(code(dmatrix![-1.0]), Err(Code::NotPositiveSemidefinite));
        assert_eq!(code(dmatrix![1.0, 0.0; 0.0, -1e-11]), Err(Code::NotPositiveSemidefinite));
        assert_eq!(code(dmatrix![1.0, 1e-8; 0.0, 1.0]), Err(Code::NotSymmetric));
        assert_eq!(code(dmatrix![1.0, f64::NAN; 0.0, 1.0]), Err(Code::NotFinite));
        assert_eq!(code(dmatrix![f64::INFINITY]), Err(Code::NotFinite));
        assert_eq!(covariance(DMatrix::zeros(2, 3), 2, "P").expect_err("2 × 3").code, Code::Shape);
    }

    #[test]
    fn rounding_is_forgiven_and_mended() {
        let m = covariance(dmatrix![1.0, 0.5 + 5e-10; 0.5, 1.0], 2, "P").expect("symmetric to 1e-9");
        assert_eq!(m[(0, 1)], m[(1, 0)]);
        assert!(covariance(dmatrix![1.0, 0.0; 0.0, -1e-13], 2, "P").is_ok());
    }

    #[test]
    fn the_steps_of_a_call_shrink_with_the_size_of_the_system() {
        assert_eq!(affordable_steps(2, 1, 100_000), 100_000);
        assert_eq!(affordable_steps(MAX_STATES, MAX_OUTPUTS, 100_000), 10_000);
        assert_eq!(affordable_steps(usize::MAX / 2, 1, 100_000), 1);
    }

    #[test]
    fn counts_tolerances_and_vectors_keep_their_bounds() {
        assert_eq!(count(1, 5, "n"), Ok(1));
        assert_eq!(count(5, 5, "n"), Ok(5));
        assert_eq!(count(0, 5, "n").expect_err("none").code, Code::Limit);
        assert_eq!(count(6, 5, "n").expect_err("too many").code, Code::Limit);
        assert_eq!(tolerance(0.0, "t"), Ok(0.0));
        for t in [-1e-300, f64::NAN, f64::INFINITY] {
            assert_eq!(tolerance(t, "t").expect_err("no tolerance").code, Code::Tolerance);
        }
        assert_eq!(vector(DVector::zeros(2), 3, "x").expect_err("short").code, Code::Shape);
        let error = vector(DVector::from_vec(vec![f64::NAN]), 1, "x").expect_err("NaN");
        assert_eq!((error.code, error.argument.as_ref()), (Code::NotFinite, "x"));
        assert!(finite(1.0, "a").is_ok() && finite(f64::NAN, "a").is_err());
    }
}
