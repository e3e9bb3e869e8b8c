//! Whether a filter's covariance matches its errors: NEES, NIS and their χ² bounds (Bar-Shalom, Li and Kirubarajan
//! 2001, §5.4).

use crate::covariance::finite;
use crate::error::{Error, Parameter, Quantity};
use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};
use numerics::Spd;
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// The squared Mahalanobis length vᵀS⁻¹v.
///
/// # Errors
/// [`Error::InnovationNotPositiveDefinite`] when `s` is not positive definite, [`Error::NotFinite`] on overflow.
pub fn mahalanobis_squared<D: Dim>(v: &OVector<f64, D>, s: &OMatrix<f64, D, D>) -> Result<f64, Error>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    let spd =
        Spd::new(finite(s.clone(), Quantity::InnovationCovariance)?).ok_or(Error::InnovationNotPositiveDefinite)?;
    let d = spd.squared_length(v);
    if d.is_finite() { Ok(d) } else { Err(Error::NotFinite(Quantity::SquaredDistance)) }
}

/// The normalized estimation error squared eᵀP⁻¹e of the error e = x − x̂: needs the truth. Its expectation is the
/// number of states when the filter is consistent.
///
/// # Errors
/// As [`mahalanobis_squared`].
pub fn nees<D: Dim>(error: &OVector<f64, D>, p: &OMatrix<f64, D, D>) -> Result<f64, Error>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    mahalanobis_squared(error, p)
}

/// The normalized innovation squared νᵀS⁻¹ν: needs no truth, so a robot can compute it. Its expectation is the number
/// of outputs when the filter is consistent.
///
/// # Errors
/// As [`mahalanobis_squared`].
pub fn nis<D: Dim>(innovation: &OVector<f64, D>, s: &OMatrix<f64, D, D>) -> Result<f64, Error>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    mahalanobis_squared(innovation, s)
}

/// The x with P(χ² ≤ x) = `probability` for a χ² variable of `dof` degrees of freedom.
///
/// # Errors
/// [`Error::OutOfRange`] when `dof` is zero or the probability outside (0, 1).
///
/// # Example
/// ```
/// let q = filters::consistency::chi2_quantile(2, 0.99)?;
/// assert!((q - 9.2103403719761827).abs() < 1e-9); // −2 ln 0.01
/// # Ok::<(), filters::Error>(())
/// ```
pub fn chi2_quantile(dof: u32, probability: f64) -> Result<f64, Error> {
    if !(probability > 0.0 && probability < 1.0) {
        return Err(Error::OutOfRange(Parameter::Probability));
    }
    let chi2 = ChiSquared::new(f64::from(dof)).map_err(|_| Error::OutOfRange(Parameter::DegreesOfFreedom))?;
    Ok(chi2.inverse_cdf(probability))
}

/// The two-sided interval that holds the **mean** of `samples` independent χ² variables of `dof` degrees of freedom
/// with the given probability: the quantiles of χ² with dof · samples degrees of freedom, divided by the samples.
///
/// # Errors
/// [`Error::OutOfRange`] as [`chi2_quantile`], or when dof · samples is not a whole number below 2³².
pub fn chi2_interval(dof: u32, samples: u32, probability: f64) -> Result<(f64, f64), Error> {
    if !(probability > 0.0 && probability < 1.0) {
        return Err(Error::OutOfRange(Parameter::Probability));
    }
    if dof == 0 {
        return Err(Error::OutOfRange(Parameter::DegreesOfFreedom));
    }
    let all = dof.checked_mul(samples).filter(|n| *n > 0).ok_or(Error::OutOfRange(Parameter::Samples))?;
    let tail = 0.5 * (1.0 - probability);
    let n = f64::from(samples);
    Ok((chi2_quantile(all, tail)? / n, chi2_quantile(all, 1.0 - tail)? / n))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Vector2};

    #[test]
    fn quantiles_of_two_degrees_of_freedom_are_logarithms() {
        for p in [0.01, 0.5, 0.95, 0.999] {
            let exact = -2.0 * libm::log(1.0 - p);
            assert!((chi2_quantile(2, p).expect("in range") / exact - 1.0).abs() < 1e-9, "{p}");
        }
    }

    #[test]
    fn tabulated_quantiles_are_met() {
        // Abramowitz and Stegun, table 26.8.
        for (dof, p, table) in [(1, 0.95, 3.84146), (3, 0.95, 7.81473), (3, 0.025, 0.215795), (10, 0.99, 23.2093)] {
            let q = chi2_quantile(dof, p).expect("in range");
            assert!((q - table).abs() < 1e-4, "{dof} {p}: {q}");
        }
    }

    #[test]
    fn the_interval_narrows_with_the_samples() {
        let (low, high) = chi2_interval(3, 1, 0.95).expect("in range");
        let (low_of_mean, high_of_mean) = chi2_interval(3, 500, 0.95).expect("in range");
        assert!(low < low_of_mean && low_of_mean < 3.0 && 3.0 < high_of_mean && high_of_mean < high);
    }

    #[test]
    fn arguments_out_of_range_are_refused() {
        for p in [0.0, 1.0, -0.1, f64::NAN] {
            assert_eq!(chi2_quantile(3, p), Err(Error::OutOfRange(Parameter::Probability)));
            assert_eq!(chi2_interval(3, 2, p), Err(Error::OutOfRange(Parameter::Probability)));
        }
        assert_eq!(chi2_quantile(0, 0.5), Err(Error::OutOfRange(Parameter::DegreesOfFreedom)));
        assert_eq!(chi2_interval(0, 2, 0.5), Err(Error::OutOfRange(Parameter::DegreesOfFreedom)));
        assert_eq!(chi2_interval(3, 0, 0.9), Err(Error::OutOfRange(Parameter::Samples)));
        assert!(chi2_interval(u32::MAX, 2, 0.9).is_err());
    }

    #[test]
    fn nees_and_nis_are_squared_lengths_in_units_of_sigma() {
        let p = Matrix2::new(4.0, 0.0, 0.0, 0.25);
        let e = Vector2::new(2.0, 1.0);
        assert_eq!(nees(&e, &p), Ok(5.0));
        assert_eq!(nis(&e, &p), Ok(5.0));
        assert_eq!(nees(&e, &Matrix2::zeros()), Err(Error::InnovationNotPositiveDefinite));
        assert!(nees(&Vector2::new(1e200, 0.0), &p).is_err());
    }
}
