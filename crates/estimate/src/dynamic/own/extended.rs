//! The extended Kalman filter of a caller's own f and h.

use super::{Function, Gated, Jacobian, Linearized, Model, OwnReading, checked, named, wrap_at};
use crate::dynamic::{Belief, Judged};
use crate::error::Error;
use crate::followed;
use crate::validate;
use alloc::vec::Vec;
use filters::Conditioning;
use nalgebra::{DMatrix, DVector};

/// The extended Kalman filter over models of one's own: x(k+1) = f(x(k)) + v, y(k) = h(x(k)) + w. At most 16 states and
/// 8 outputs. Angles are taken the short way round.
///
/// # Example
/// ```
/// use estimate::dynamic::{ExtendedKalmanFilter, OwnReading};
/// use estimate::Error;
/// use nalgebra::{DMatrix, dmatrix, dvector};
/// // A cart on a rail, seen from a mast that stands 3 m beside it.
/// let belief = estimate::validate::belief(dvector![0.0, 1.0], DMatrix::identity(2, 2))?;
/// let mut filter = ExtendedKalmanFilter::new(&belief, &[])?;
/// let mut f = |x: &[f64]| Ok::<_, Error>(vec![x[0] + 0.5 * x[1], x[1]]);
/// let mut h = |x: &[f64]| Ok::<_, Error>(vec![(x[0] * x[0] + 9.0).sqrt()]);
/// filter.predict(&mut f, dmatrix![0.0, 0.0; 0.0, 0.1], None)?;
/// let reading = OwnReading { y: &[Some(3.2)], w: dmatrix![0.01], angles: &[], gate: Some(9.0) };
/// assert!(filter.update(&reading, &mut h, None)?.accepted);
/// assert!(filter.x()[0] > 0.5); // further along: the mast is 3.2 m away
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct ExtendedKalmanFilter {
    x: DVector<f64>,
    angles: Vec<usize>,
    p: DMatrix<f64>,
    conditioning: Conditioning,
}

impl ExtendedKalmanFilter {
    /// The filter with the belief before the first step; `angles` lists the components of x that are angles.
    ///
    /// # Errors
    /// [`Code::Index`](crate::Code::Index) naming the angle.
    pub fn new(belief: &Belief, angles: &[usize]) -> Result<Self, Error> {
        let (x, angles) = checked(belief, angles)?;
        Ok(Self { x, angles, p: belief.p.clone(), conditioning: Conditioning::default() })
    }

    /// x = f(x), P = F P Fᵀ + V with V n×n and F = ∂f/∂x at the old x: given, or by central differences.
    ///
    /// # Errors
    /// What `f` answers; [`Error`] naming `f(x)`, `F(x)`, V or P. The filter is then as it was.
    pub fn predict<E: From<Error>>(
        &mut self,
        f: Model<'_, E>,
        v: DMatrix<f64>,
        jacobian: Option<Jacobian<'_, E>>,
    ) -> Result<(), E> {
        let n = self.x.len();
        let v = validate::covariance(v, n, "V")?;
        let mut f = Function { model: f, name: "f(x)", len: n, angles: &self.angles };
        let mut moved = f.at(&self.x)?;
        let slope = match jacobian {
            Some(jacobian) => validate::matrix(jacobian(self.x.as_slice())?, (n, n), "F(x)")?,
            None => f.differences(&self.x)?,
        };
        // What is predicted is the estimate's error, whose mean is zero.
        let mut error = DVector::zeros(n);
        let (error, p) = (error.as_mut_slice(), self.p.as_mut_slice());
        followed::predict((error, p), &mut self.conditioning, (&slope, &v), None).map_err(named)?;
        wrap_at(&self.angles, &mut moved);
        self.x = moved;
        Ok(())
    }

    /// Corrects the belief by a reading, with H = ∂h/∂x at x: given, or by central differences.
    ///
    /// # Errors
    /// What `h` answers; [`Error`] naming `h(x)`, `H(x)`, y, W, gate, angles or P. The filter is then as it was.
    pub fn update<E: From<Error>>(
        &mut self,
        reading: &OwnReading<'_>,
        h: Model<'_, E>,
        jacobian: Option<Jacobian<'_, E>>,
    ) -> Result<Gated, E> {
        let n = self.x.len();
        let Linearized { innovation, h, w } = reading.linearized(&self.x, h, jacobian)?;
        let (mut error, mut p, mut conditioning) = (DVector::zeros(n), self.p.clone(), self.conditioning.clone());
        let numbers = (error.as_mut_slice(), p.as_mut_slice());
        let update = followed::correct(numbers, &mut conditioning, &innovation, (&h, &w)).map_err(named)?;
        let judged = Judged { innovation, s: update.s, chi2: update.d2 };
        let accepted = reading.accepts(&judged);
        if accepted {
            let mut x = &self.x + error;
            wrap_at(&self.angles, &mut x);
            validate::entries(x.as_slice(), n, "x")?;
            (self.x, self.p, self.conditioning) = (x, p, conditioning);
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

    /// Whether S and P of every step so far are right to 10⁻⁶ of their largest entries, for the Jacobians that were
    /// used.
    pub fn conditioned(&self) -> bool {
        self.conditioning.is_well_conditioned()
    }
}
