//! The linear functions for shapes known at run time only, as a page, a notebook or another language calls them.
//!
//! The algebra is that of the typed functions, over nalgebra's `Dyn` in place of its `Const`; what is added here is
//! that every argument is checked and the culprit named.

mod analysis;
mod continuous;
mod feet;
mod filter;
mod own;
mod partial;
mod replay;
mod smooth;
mod timeline;

pub use analysis::{
    detectability, falls_as_average, movable, noise_input, noise_reach, riccati_limit, stabilizability,
};
pub use continuous::{Continuous, Discrete};
pub use feet::{euclidean_foot, mahalanobis_foot, most_likely_output};
pub use filter::{FilterState, KalmanFilter, LastReading};
pub use filters::ukf::SigmaPoints;
pub use filters::{Bound, Conditioning};
pub use own::{ExtendedKalmanFilter, Gated, Jacobian, Model, OwnReading, SIGMA_POINTS, UnscentedKalmanFilter};
pub use replay::{MAX_LOG, Replayed, kalman_replay, kalman_replay_partly};
pub use smooth::kalman_smooth;
pub use timeline::{
    AnyOutput, Judged, MAX_AHEAD, MAX_CAPACITY, MAX_DELAY, MAX_SENSORS, Map, Memory, Outcome, Output, OwnOutput,
    Placed, Sensor, SensorStatistics, Timeline,
};

use crate::error::{Code, Error};
use crate::lti::Lti;
use crate::observability::{self, Observability};
use crate::observer::{Observer, error_matrix};
use crate::placement;
use crate::riccati::SteadyState;
pub use crate::riccati::{Limit, STRUCTURE, after_exact_readings, before_exact_readings, grows, steady_state};
use crate::validate::{self, MAX_INPUTS, MAX_OUTPUTS, MAX_STATES, size};
use crate::zero_modes::with_zeros;
use alloc::format;
use alloc::vec::Vec;
use filters::Gaussian;
use filters::covariance::is_finite;
use geom::Ellipse;
use nalgebra::allocator::Allocator;
use nalgebra::{Complex, DMatrix, DVector, DefaultAllocator, Dim, Dyn, Matrix2, OMatrix};

/// A system whose sizes are known at run time only.
pub type System = Lti<Dyn, Dyn, Dyn>;

/// A belief whose size is known at run time only; [`validate::belief`] makes one of a caller's numbers.
pub type Belief = Gaussian<Dyn>;

impl System {
    /// A checked system: F n×n, G n×m, H p×n, V n×n and W p×p, with n ≤ 16, m ≤ 8 and p ≤ 8; all finite, V and W
    /// covariances.
    ///
    /// # Errors
    /// Naming the matrix: [`Code::Limit`], [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`] or
    /// [`Code::NotPositiveSemidefinite`].
    ///
    /// # Example
    /// ```
    /// use estimate::dynamic::System;
    /// use nalgebra::{DMatrix, dmatrix};
    /// let (f, g) = (dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.0; 0.5]);
    /// let sys = System::new(f, g, dmatrix![0.0, 1.0], DMatrix::identity(2, 2), dmatrix![0.5])?;
    /// assert_eq!(sys.is_observable(1e-9), Ok(false));
    /// # Ok::<(), estimate::Error>(())
    /// ```
    pub fn new(
        f: DMatrix<f64>,
        g: DMatrix<f64>,
        h: DMatrix<f64>,
        v: DMatrix<f64>,
        w: DMatrix<f64>,
    ) -> Result<Self, Error> {
        let (f, h) = pair(f, h)?;
        if g.ncols() > MAX_INPUTS {
            return Err(Error::new(Code::Limit, "G", format!("has {} inputs; at most {MAX_INPUTS}", g.ncols())));
        }
        let (n, m, p) = (f.nrows(), g.ncols(), h.nrows());
        Ok(Self {
            g: validate::matrix(g, (n, m), "G")?,
            v: validate::covariance(v, n, "V")?,
            w: validate::covariance(w, p, "W")?,
            f,
            h,
        })
    }

    fn gain(&self, k: DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
        validate::matrix(k, (self.f.nrows(), self.h.nrows()), "K")
    }
}

/// One step of the observer with the gain `k` (n×p) from the estimate `x`.
///
/// # Errors
/// [`Code::Shape`] or [`Code::NotFinite`] naming the argument.
pub fn observer_step(
    system: &System,
    k: DMatrix<f64>,
    x: DVector<f64>,
    u: DVector<f64>,
    y: DVector<f64>,
) -> Result<DVector<f64>, Error> {
    let k = system.gain(k)?;
    let x = validate::vector(x, system.f.nrows(), "x")?;
    let u = validate::vector(u, system.g.ncols(), "u")?;
    let y = validate::vector(y, system.h.nrows(), "y")?;
    let mut observer = Observer { sys: system.clone(), k, xhat: x };
    let input = &system.g * &u;
    let predicted = &system.f * &observer.xhat + &input;
    let output = &system.h * &predicted;
    observer.step(&u, &y);
    // In the order in which they are computed: the first that is not finite is to blame for the others.
    overflow(&input, "u")?;
    overflow(&predicted, "x")?;
    overflow(&output, "x")?;
    overflow(&(y - output), "y")?;
    overflow(&observer.xhat, "K")?;
    Ok(observer.xhat)
}

/// The eigenvalues of (I − KH)F, by decreasing modulus, then decreasing imaginary part.
///
/// What is 0 within the rounding of the numbers, each state in a unit that fits it, is 0: the readings of a sensor that
/// are on their way for m steps leave an m-fold 0, of which rounding alone would make digits.
///
/// # Errors
/// [`Code::Shape`] or [`Code::NotFinite`] naming K, [`Code::DidNotConverge`].
///
/// # Example
/// ```
/// let (typed, _) = estimate::rail::position_sensor();
/// let rows = |m: &[f64], n: usize| nalgebra::DMatrix::from_column_slice(n, m.len() / n, m);
/// let [f, v] = [typed.f, typed.v].map(|m| rows(m.as_slice(), 2));
/// let (g, h) = (rows(typed.g.as_slice(), 2), rows(typed.h.as_slice(), 1));
/// let sys = estimate::dynamic::System::new(f, g, h, v, rows(typed.w.as_slice(), 1))?;
/// let found = estimate::dynamic::error_eigenvalues(&sys, nalgebra::dmatrix![0.9; 0.8])?;
/// assert!((found[0].re - 0.5).abs() < 1e-14 && (found[1].re - 0.2).abs() < 1e-14);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn error_eigenvalues(system: &System, k: DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    let k = system.gain(k)?;
    let System { f, h, .. } = system;
    let m = error_matrix(f, h, &k);
    overflow(&m, "K")?;
    // What is subtracted may be larger than what is left, and its rounding with it.
    let sizes = (DMatrix::identity(f.nrows(), f.nrows()) + k.abs() * h.abs()) * f.abs();
    let found = numerics::eigenvalues(&m).map_err(|e| Error::of_matrix(e, "K"))?;
    Ok(with_zeros(found, &m, &sizes))
}

/// The rank of [H; HF; …; HF^{n−1}] under the relative `tolerance`, with its singular values and null directions.
///
/// # Errors
/// [`Code::Limit`], [`Code::Shape`], [`Code::NotFinite`] or [`Code::Tolerance`] naming the argument,
/// [`Code::DidNotConverge`].
///
/// # Example
/// ```
/// use nalgebra::dmatrix;
/// let seen = estimate::dynamic::observability(dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.0, 1.0], 1e-9)?;
/// assert_eq!((seen.rank, seen.n), (1, 2));
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn observability(f: DMatrix<f64>, h: DMatrix<f64>, tolerance: f64) -> Result<Observability, Error> {
    let (f, h) = pair(f, h)?;
    observability::analyze(&observability::observability_matrix(&f, &h), tolerance)
}

/// The gain that gives (I − KH)F the eigenvalues `poles`, for a single output; see
/// [`place_observer_gain`](crate::place_observer_gain). For several outputs, or where not all eigenvalues can be moved,
/// see [`movable`].
///
/// # Errors
/// [`Code::Limit`], [`Code::Shape`] or [`Code::NotFinite`] naming the argument, [`Code::Poles`],
/// [`Code::Unobservable`], [`Code::NotPlaceable`], [`Code::DidNotConverge`].
///
/// # Example
/// ```
/// use nalgebra::dmatrix;
/// let poles = [0.5, 0.2].map(estimate::Complex::from);
/// let k = estimate::dynamic::place_observer_gain(dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![1.0, 0.0], &poles)?;
/// assert!((k[0] - 0.9).abs() < 1e-14 && (k[1] - 0.8).abs() < 1e-14);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn place_observer_gain(f: DMatrix<f64>, h: DMatrix<f64>, poles: &[Complex<f64>]) -> Result<DVector<f64>, Error> {
    let (f, h) = pair(f, h)?;
    if h.nrows() != 1 {
        let message = format!("has {} outputs; Ackermann's formula is for a single one", h.nrows());
        return Err(Error::new(Code::Shape, "H", message));
    }
    Ok(placement::place(&f, &h, poles)?.column(0).into_owned())
}

/// The limit of the gain from `p0` = P(0 | 0); see [`Lti::steady_state_gain`](crate::Lti::steady_state_gain).
///
/// # Errors
/// As there, and for `p0` as [`validate::covariance`].
pub fn steady_state_gain(
    system: &System,
    p0: DMatrix<f64>,
    max_iterations: usize,
    tolerance: f64,
) -> Result<SteadyState<Dyn, Dyn>, Error> {
    let p0 = validate::covariance(p0, system.f.nrows(), "P0")?;
    system.steady_state_gain(&p0, max_iterations, tolerance)
}

/// R(1), …, R(`steps`) from `p0` = P(0 | 0).
///
/// # Errors
/// As [`steady_state_gain`].
pub fn gain_schedule(system: &System, p0: DMatrix<f64>, steps: usize) -> Result<Vec<DMatrix<f64>>, Error> {
    let p0 = validate::covariance(p0, system.f.nrows(), "P0")?;
    system.gain_schedule(&p0, steps)
}

/// The ellipse {x : xᵀP⁻¹x = radius²} of a 2×2 covariance.
///
/// # Errors
/// For `p` as [`validate::covariance`]; [`Code::Limit`] when `radius` is not positive, [`Code::NotFinite`] when it is
/// not finite.
///
/// # Example
/// ```
/// let ellipse = estimate::dynamic::covariance_ellipse(nalgebra::dmatrix![4.0, 0.0; 0.0, 1.0], 2.0)?;
/// assert_eq!((ellipse.semi_major, ellipse.semi_minor), (4.0, 2.0));
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn covariance_ellipse(p: DMatrix<f64>, radius: f64) -> Result<Ellipse, Error> {
    let p = validate::covariance(p, 2, "P")?;
    let radius = validate::finite(radius, "radius")?;
    if radius <= 0.0 {
        return Err(Error::new(Code::Limit, "radius", "must be positive"));
    }
    let ellipse = Ellipse::from_covariance(&Matrix2::new(p[(0, 0)], p[(0, 1)], p[(1, 0)], p[(1, 1)]), radius);
    validate::finite(ellipse.semi_major, "radius")?;
    Ok(ellipse)
}

/// # Errors
/// [`Code::NotFinite`] blaming `argument`, when finite numbers have become an `m` that is not.
fn overflow<C: Dim>(m: &OMatrix<f64, Dyn, C>, argument: &'static str) -> Result<(), Error>
where
    DefaultAllocator: Allocator<Dyn, C>,
{
    if is_finite(m) {
        return Ok(());
    }
    Err(Error::new(Code::NotFinite, argument, "is too large, with the numbers beside it: a product overflows"))
}

/// The checked matrices F and H of a system.
fn pair(f: DMatrix<f64>, h: DMatrix<f64>) -> Result<(DMatrix<f64>, DMatrix<f64>), Error> {
    let n = f.nrows();
    size(n, MAX_STATES, "F")?;
    size(h.nrows(), MAX_OUTPUTS, "H")?;
    let p = h.nrows();
    Ok((validate::matrix(f, (n, n), "F")?, validate::matrix(h, (p, n), "H")?))
}

#[cfg(test)]
mod tests;
