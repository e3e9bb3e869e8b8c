//! A Kalman filter that holds its system and its belief, for sizes known at run time only. Positions with their
//! speeds, on a line and in the plane, are filtered at the pace of typed code.

use super::{Belief, System};
use crate::error::Error;
use crate::kf::belief_fits;
use crate::likelihood::log_density;
use crate::lti::{Lti, SystemSizes};
use crate::validate;
use alloc::boxed::Box;
use filters::{Gaussian, Update};
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DVector, DefaultAllocator, Dim, Dyn, OMatrix, OVector, U1, U2, U4};

/// The Kalman filter of one system, with its belief inside: [`kalman_step`](crate::kf::kalman_step), in two halves that may be
/// called apart, or together as one step.
///
/// # Example
/// ```
/// use estimate::dynamic::{KalmanFilter, System};
/// use nalgebra::{dmatrix, dvector};
/// let (f, g) = (dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.0; 0.5]);
/// let system = System::new(f, g, dmatrix![1.0, 0.0], dmatrix![0.2, 0.05; 0.05, 0.1], dmatrix![0.5])?;
/// let belief = estimate::validate::belief(dvector![2.0, 4.0], dmatrix![1.0, 0.0; 0.0, 2.0])?;
/// let mut filter = KalmanFilter::new(&system, &belief)?;
/// filter.step(&[0.1], &[4.2])?;
/// assert!((filter.x()[0] - 4.1545454545454543).abs() < 1e-15 && filter.nis().unwrap() < 0.1);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct KalmanFilter(Kind);

#[derive(Clone, Debug)]
enum Kind {
    TwoStatesOneOutput(Filter<U2, Dyn, U1>),
    TwoStatesTwoOutputs(Filter<U2, Dyn, U2>),
    FourStatesTwoOutputs(Box<Filter<U4, Dyn, U2>>),
    Any(Filter<Dyn, Dyn, Dyn>),
}

/// The same for the filter of each kind.
macro_rules! each {
    ($kind:expr, $filter:ident => $answer:expr) => {
        match $kind {
            Kind::TwoStatesOneOutput($filter) => $answer,
            Kind::TwoStatesTwoOutputs($filter) => $answer,
            Kind::FourStatesTwoOutputs($filter) => $answer,
            Kind::Any($filter) => $answer,
        }
    };
}

impl KalmanFilter {
    /// The filter of `system` with the belief x̂(0 | 0), P(0 | 0).
    ///
    /// # Errors
    /// [`Code::Shape`](crate::Code::Shape) when the belief is not of the system's size.
    pub fn new(system: &System, belief: &Belief) -> Result<Self, Error> {
        let (n, m, p) = (system.f.nrows(), Dyn(system.g.ncols()), system.h.nrows());
        belief_fits(belief, n)?;
        Ok(Self(match (n, p) {
            (2, 1) => Kind::TwoStatesOneOutput(Filter::new(system, belief, (U2, m, U1))),
            (2, 2) => Kind::TwoStatesTwoOutputs(Filter::new(system, belief, (U2, m, U2))),
            (4, 2) => Kind::FourStatesTwoOutputs(Box::new(Filter::new(system, belief, (U4, m, U2)))),
            _ => Kind::Any(Filter::new(system, belief, (Dyn(n), m, Dyn(p)))),
        }))
    }

    /// x̂(k+1 | k) = F x̂ + G u and P(k+1 | k) = F P Fᵀ + V, with the input `u` (m; empty for a system without inputs).
    ///
    /// # Errors
    /// [`Code::Shape`](crate::Code::Shape) or [`Code::NotFinite`](crate::Code::NotFinite), naming u, x or P; the filter is then as
    /// it was.
    pub fn predict(&mut self, u: &[f64]) -> Result<(), Error> {
        each!(&mut self.0, filter => filter.predict(u))
    }

    /// The belief corrected by the reading `y` (p), in Joseph's form.
    ///
    /// # Errors
    /// Those of [`predict`](Self::predict) with y for u, and
    /// [`Code::InnovationNotPositiveDefinite`](crate::Code::InnovationNotPositiveDefinite) naming W; the filter is then as it was.
    pub fn update(&mut self, y: &[f64]) -> Result<(), Error> {
        each!(&mut self.0, filter => filter.update(y))
    }

    /// A prediction with `u` and a correction by `y`, both or neither.
    ///
    /// # Errors
    /// Those of [`predict`](Self::predict) and [`update`](Self::update); the filter is then as it was before both.
    pub fn step(&mut self, u: &[f64], y: &[f64]) -> Result<(), Error> {
        each!(&mut self.0, filter => filter.step(u, y))
    }

    /// The mean x̂, n.
    pub fn x(&self) -> &[f64] {
        each!(&self.0, filter => filter.belief.x.as_slice())
    }

    /// The belief N(x̂, P).
    pub fn belief(&self) -> Belief {
        let n = self.x().len();
        let p = each!(&self.0, filter => DMatrix::from_column_slice(n, n, filter.belief.p.as_slice()));
        Gaussian { x: DVector::from_column_slice(self.x()), p }
    }

    /// Σ −½ (ln det 2πS + νᵀS⁻¹ν) over all readings; nothing where [`log_density`] had no answer at one of them, or the sum is
    /// too large for a number.
    pub fn log_likelihood(&self) -> Option<f64> {
        each!(&self.0, filter => filter.log_likelihood)
    }

    /// The normalized innovation squared νᵀS⁻¹ν of the last reading; nothing before the first, and where S is singular to working
    /// accuracy.
    pub fn nis(&self) -> Option<f64> {
        each!(&self.0, filter => filter.nis)
    }
}

/// The filter with matrices of the sizes N, U and M.
#[derive(Clone, Debug)]
pub(super) struct Filter<N: Dim, U: Dim, M: Dim>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    system: Lti<N, U, M>,
    pub belief: Gaussian<N>,
    pub log_likelihood: Option<f64>,
    nis: Option<f64>,
}

impl<N: Dim, U: Dim, M: Dim> Filter<N, U, M>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    /// `system` and `belief`, which are of the sizes (n, m, p).
    pub fn new(system: &System, belief: &Belief, (n, m, p): (N, U, M)) -> Self {
        let system = Lti {
            f: sized(n, n, system.f.as_slice()),
            g: sized(n, m, system.g.as_slice()),
            h: sized(p, n, system.h.as_slice()),
            v: sized(n, n, system.v.as_slice()),
            w: sized(p, p, system.w.as_slice()),
        };
        let belief = Gaussian { x: sized(n, U1, belief.x.as_slice()), p: sized(n, n, belief.p.as_slice()) };
        Self { system, belief, log_likelihood: Some(0.0), nis: None }
    }

    fn predict(&mut self, u: &[f64]) -> Result<(), Error> {
        self.belief = self.predicted(&self.input(u)?)?;
        Ok(())
    }

    fn update(&mut self, y: &[f64]) -> Result<(), Error> {
        let corrected = self.corrected(&self.belief, &self.reading(y)?)?;
        self.keep(corrected);
        Ok(())
    }

    pub fn step(&mut self, u: &[f64], y: &[f64]) -> Result<(), Error> {
        let predicted = self.predicted(&self.input(u)?)?;
        let corrected = self.corrected(&predicted, &self.reading(y)?)?;
        self.keep(corrected);
        Ok(())
    }

    #[inline]
    fn input(&self, u: &[f64]) -> Result<OVector<f64, U>, Error> {
        let m = self.system.g.shape_generic().1;
        validate::entries(u, m.value(), "u").map(|_| sized(m, U1, u))
    }

    #[inline]
    fn reading(&self, y: &[f64]) -> Result<OVector<f64, M>, Error> {
        let p = self.system.h.shape_generic().0;
        validate::entries(y, p.value(), "y").map(|_| sized(p, U1, y))
    }

    // These two answer with the error of `filters`: beside another error the whole answer would be copied in memory.

    #[inline]
    fn predicted(&self, u: &OVector<f64, U>) -> Result<Gaussian<N>, filters::Error> {
        self.belief.predicted(&self.system.f, &self.system.v, Some((&self.system.g, u)))
    }

    #[inline]
    fn corrected(
        &self,
        predicted: &Gaussian<N>,
        y: &OVector<f64, M>,
    ) -> Result<(Gaussian<N>, Update<N, M>), filters::Error> {
        predicted.corrected(y, &self.system.h, &self.system.w)
    }

    #[inline]
    fn keep(&mut self, (belief, update): (Gaussian<N>, Update<N, M>)) {
        let density = log_density(&update.innovation, &update.s);
        let sum = self.log_likelihood.zip(density).map(|(sum, density)| sum + density);
        self.log_likelihood = sum.filter(|sum| sum.is_finite());
        self.nis = update.d2;
        self.belief = belief;
    }
}

fn sized<R: Dim, C: Dim>(rows: R, columns: C, entries: &[f64]) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    OMatrix::from_iterator_generic(rows, columns, entries.iter().copied())
}
