//! The points of Ω = {x : Hx = y} nearest to a prediction, and the most likely output (Choset §8.2.2 to §8.2.4).

use super::overflow;
use crate::error::{Code, Error};
use crate::validate::{self, MAX_OUTPUTS, MAX_STATES, size};
use filters::Gaussian;
use filters::covariance::symmetric;
use geom::AffineSet;
use nalgebra::{DMatrix, DVector, Dyn};
use numerics::{MIN_PIVOT, Spd};

/// The point of Ω = {x : Hx = y} nearest to `x` in the Euclidean metric.
///
/// # Errors
/// [`Code::Limit`], [`Code::Shape`] or [`Code::NotFinite`] naming the argument,
/// [`Code::InnovationNotPositiveDefinite`] when H has not full row rank.
///
/// # Example
/// ```
/// use estimate::dynamic::{euclidean_foot, mahalanobis_foot};
/// use nalgebra::{dmatrix, dvector};
/// let (h, x, y) = (dmatrix![0.0, 1.0], dvector![4.0, 4.0], dvector![2.7]);
/// assert_eq!(euclidean_foot(h.clone(), x.clone(), y.clone())?, dvector![4.0, 2.7]);
/// let foot = mahalanobis_foot(h, dmatrix![1.7, 1.05; 1.05, 2.1], x, y)?;
/// assert!((foot - dvector![3.35, 2.7]).norm() < 1e-14);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn euclidean_foot(h: DMatrix<f64>, x: DVector<f64>, y: DVector<f64>) -> Result<DVector<f64>, Error> {
    let (omega, x) = affine(h, x, y)?;
    omega.euclidean_foot(&x).ok_or_else(rows_repeat)
}

fn rows_repeat() -> Error {
    let message = "HHᵀ is singular, or too large or small for floating point: the rows of H must be independent";
    Error::new(Code::InnovationNotPositiveDefinite, "H", message)
}

/// The point of Ω = {x : Hx = y} nearest to `x` in the Mahalanobis metric of `p`.
///
/// # Errors
/// As [`euclidean_foot`], for H also [`Code::NotFinite`] when HPHᵀ overflows; for `p` as [`validate::covariance`], and
/// [`Code::InnovationNotPositiveDefinite`] when H has full row rank but HPHᵀ is singular.
pub fn mahalanobis_foot(
    h: DMatrix<f64>,
    p: DMatrix<f64>,
    x: DVector<f64>,
    y: DVector<f64>,
) -> Result<DVector<f64>, Error> {
    let (omega, x) = affine(h, x, y)?;
    let p = validate::covariance(p, x.len(), "P")?;
    let Some(foot) = omega.mahalanobis_foot(&p, &x) else {
        let h = &omega.h;
        overflow(&(h * (&p * h.transpose())), "H")?;
        let independent = Spd::new(h * h.transpose()).is_some_and(|s| s.pivot() >= MIN_PIVOT);
        if !independent {
            return Err(rows_repeat());
        }
        let message = "HPHᵀ is singular, or too small for floating point: P leaves no uncertainty in what H measures, \
            so no \
                       step along it reaches Ω";
        return Err(Error::new(Code::InnovationNotPositiveDefinite, "P", message));
    };
    Ok(foot)
}

/// y*, the most likely output: the product of N(Hx̂, HPHᵀ) and N(y, W) peaks there (Theorem 8.2.1).
///
/// # Errors
/// [`Code::Limit`], [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`] or [`Code::NotPositiveSemidefinite`]
/// naming the argument; [`Code::InnovationNotPositiveDefinite`] when HPHᵀ + W is singular.
///
/// # Example
/// ```
/// use nalgebra::{dmatrix, dvector};
/// let p = dmatrix![1.7, 1.05; 1.05, 2.1];
/// let (h, w) = (dmatrix![0.0, 1.0], dmatrix![0.5]);
/// let y = estimate::dynamic::most_likely_output(h, p, w, dvector![4.0, 4.0], dvector![2.7])?;
/// assert!((y[0] - 2.95).abs() < 1e-14);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn most_likely_output(
    h: DMatrix<f64>,
    p: DMatrix<f64>,
    w: DMatrix<f64>,
    x: DVector<f64>,
    y: DVector<f64>,
) -> Result<DVector<f64>, Error> {
    let (omega, x) = affine(h, x, y)?;
    let p = validate::covariance(p, x.len(), "P")?;
    let w = validate::covariance(w, omega.h.nrows(), "W")?;
    let predicted = Gaussian { p: symmetric(&omega.h * p * omega.h.transpose()), x: &omega.h * &x };
    overflow(&predicted.x, "x")?;
    overflow(&predicted.p, "P")?;
    Ok(predicted.product(&Gaussian { x: omega.y, p: w })?.x)
}

fn affine(h: DMatrix<f64>, x: DVector<f64>, y: DVector<f64>) -> Result<(AffineSet<Dyn, Dyn>, DVector<f64>), Error> {
    let (n, p) = (x.len(), h.nrows());
    size(n, MAX_STATES, "x")?;
    size(p, MAX_OUTPUTS, "H")?;
    let h = validate::matrix(h, (p, n), "H")?;
    let y = validate::vector(y, p, "y")?;
    Ok((AffineSet { h, y }, validate::vector(x, n, "x")?))
}
