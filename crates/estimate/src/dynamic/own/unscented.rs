//! The unscented Kalman filter of a caller's own f and h.

use super::{Function, Gated, Model, OwnReading, checked, named, wrap_at};
use crate::dynamic::partial::rows_there;
use crate::dynamic::{Belief, Judged};
use crate::error::Error;
use crate::validate;
use alloc::vec::Vec;
use filters::ukf::SigmaPoints;
use nalgebra::{DMatrix, DVector, Dyn};

/// The points that are taken where none are given: α = 1, β = 2, κ = 0. Their weights are near one; those of the usual
/// α of 10⁻³ are near 10⁶, and spend as many digits.
pub const SIGMA_POINTS: SigmaPoints = SigmaPoints { alpha: 1.0, beta: 2.0, kappa: 0.0 };

/// The unscented Kalman filter over models of one's own: x(k+1) = f(x(k)) + v, y(k) = h(x(k)) + w. No Jacobian is
/// needed: f and h are asked at 2n + 1 points. At most 16 states and 8 outputs. Angles are taken the short way round.
///
/// # Example
/// ```
/// use estimate::dynamic::{OwnReading, SIGMA_POINTS, UnscentedKalmanFilter};
/// use estimate::Error;
/// use nalgebra::{DMatrix, dmatrix, dvector};
/// let belief = estimate::validate::belief(dvector![0.0, 1.0], DMatrix::identity(2, 2))?;
/// let mut filter = UnscentedKalmanFilter::new(&belief, &[], SIGMA_POINTS)?;
/// filter.predict(&mut |x| Ok::<_, Error>(vec![x[0] + 0.5 * x[1], x[1]]), dmatrix![0.0, 0.0; 0.0, 0.1])?;
/// let reading = OwnReading { y: &[Some(3.2)], w: dmatrix![0.01], angles: &[], gate: None };
/// filter.update(&reading, &mut |x| Ok::<_, Error>(vec![(x[0] * x[0] + 9.0).sqrt()]))?;
/// assert!(filter.p()[(0, 0)] < 1.25);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct UnscentedKalmanFilter {
    x: DVector<f64>,
    p: DMatrix<f64>,
    angles: Vec<usize>,
    points: SigmaPoints,
}

impl UnscentedKalmanFilter {
    /// The filter with the belief before the first step; `angles` lists the components of x that are angles.
    ///
    /// # Errors
    /// [`Code::Index`](crate::Code::Index) naming the angle.
    pub fn new(belief: &Belief, angles: &[usize], points: SigmaPoints) -> Result<Self, Error> {
        let (x, angles) = checked(belief, angles)?;
        points.spread(&DMatrix::<f64>::identity(x.len(), x.len())).map_err(named)?;
        Ok(Self { x, p: belief.p.clone(), angles, points })
    }

    /// The belief after x⁺ = f(x) + v, Cov v = V, n×n.
    ///
    /// # Errors
    /// What `f` answers; [`Error`] naming `f(x)`, V or P, which must be positive definite and be left a covariance:
    /// rounding spoils it where points lie close to the mean, or a reading leaves next to nothing of P. The filter is
    /// then as it was.
    pub fn predict<E: From<Error>>(&mut self, f: Model<'_, E>, v: DMatrix<f64>) -> Result<(), E> {
        let n = self.x.len();
        let v = validate::covariance(v, n, "V")?;
        let spread = self.points.spread(&self.p).map_err(named)?;
        let mut f = Function { model: f, name: "f(x)", len: n, angles: &self.angles };
        let centre = f.at(&self.x)?;
        let moved = spread.image(Dyn(n), |d| f.at(&(&self.x + d)).map(|there| f.difference(there, &centre)))?;
        let p = still_covariance(spread.predicted_covariance(&moved, &v).map_err(named)?)?;
        let mut x = centre + &moved.mean;
        wrap_at(&self.angles, &mut x);
        validate::entries(x.as_slice(), n, "x")?;
        (self.x, self.p) = (x, p);
        Ok(())
    }

    /// Corrects the belief by a reading.
    ///
    /// # Errors
    /// What `h` answers; [`Error`] naming `h(x)`, y, W, gate, angles, or P as in [`predict`](Self::predict). The filter
    /// is then as it was.
    pub fn update<E: From<Error>>(&mut self, reading: &OwnReading<'_>, h: Model<'_, E>) -> Result<Gated, E> {
        let whole = reading.checked()?;
        let (n, p) = (self.x.len(), reading.y.len());
        let spread = self.points.spread(&self.p).map_err(named)?;
        let mut h = Function { model: h, name: "h(x)", len: p, angles: reading.angles };
        let centre = h.at(&self.x)?;
        let (_, w) = rows_there(&DMatrix::zeros(p, 0), &whole.w, reading.y);
        let mean = |d: &DVector<f64>| h.at(&(&self.x + d)).map(|there| h.difference(there, &centre));
        let seen = spread.image(Dyn(p), mean)?;
        let innovation = reading.innovation(&whole.y, &(centre + &seen.mean));
        let seen = seen.part(|deviation| reading.there(deviation));
        let (step, covariance, update) = spread.correction(&self.p, &seen, innovation, &w).map_err(named)?;
        let judged = Judged { innovation: update.innovation, s: update.s, chi2: update.d2 };
        let accepted = reading.accepts(&judged);
        if accepted {
            let mut x = &self.x + step;
            wrap_at(&self.angles, &mut x);
            validate::entries(x.as_slice(), n, "x")?;
            (self.x, self.p) = (x, still_covariance(covariance)?);
        }
        Ok(Gated { accepted, judged })
    }

    /// The mean x̂, n; angles in (−π, π].
    pub fn x(&self) -> &[f64] {
        self.x.as_slice()
    }

    /// The covariance P, n×n.
    pub fn p(&self) -> &DMatrix<f64> {
        &self.p
    }
}

/// What is left of P, if it is a covariance.
fn still_covariance(p: DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
    let n = p.nrows();
    validate::covariance(p, n, "P").map_err(|error| {
        let message =
            "is left with a negative eigenvalue by rounding: sigma points further apart (a greater α) lose less";
        Error::new(error.code, "P", message)
    })
}
