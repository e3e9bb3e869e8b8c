//! A Kalman filter that holds its system and its belief, for sizes known at run time only. Few states and few outputs
//! are filtered at the pace of typed code, to the same bits.

mod typed;

use super::partial::rows_there;
use super::{Belief, Discrete, System};
use crate::error::{Code, Error};
use crate::kf::belief_fits;
use crate::validate::{self, MAX_OUTPUTS, size};
use alloc::boxed::Box;
use alloc::vec::Vec;
use filters::Gaussian;
use nalgebra::{Const, DMatrix, DVector, Dyn};
use typed::{Filter, Last, sized};

/// The Kalman filter of one system, with its belief inside: [`kalman_step`](crate::kf::kalman_step), in two halves that
/// may be called apart, or together as one step.
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

/// The sizes that are compiled, as n and p: `Kind` has a filter for each, and one for all others.
macro_rules! kinds {
    ($($kind:ident: $n:literal, $p:literal;)*) => {
        #[derive(Clone, Debug)]
        enum Kind {
            $($kind(Box<Filter<Const<$n>, Const<$p>>>),)*
            Any(Box<Filter<Dyn, Dyn>>),
        }

        impl Kind {
            fn new(system: &System, belief: &Belief) -> Self {
                match system.h.shape() {
                    $(($p, $n) => Self::$kind(Box::new(Filter::new(system, belief, (Const, Const)))),)*
                    (p, n) => Self::Any(Box::new(Filter::new(system, belief, (Dyn(n), Dyn(p))))),
                }
            }
        }

        /// The same for the filter of each kind.
        macro_rules! each {
            ($of:expr, $filter:ident => $answer:expr) => {
                match $of {
                    $(Kind::$kind($filter) => $answer,)*
                    Kind::Any($filter) => $answer,
                }
            };
        }
    };
}
kinds! {
    OneByOne: 1, 1;
    TwoByOne: 2, 1;
    TwoByTwo: 2, 2;
    ThreeByOne: 3, 1;
    FourByTwo: 4, 2;
}

// Behind the macro that it uses.
mod state;
pub use state::{FilterState, LastReading};

impl KalmanFilter {
    /// The filter of `system` with the belief x̂(0 | 0), P(0 | 0).
    ///
    /// # Errors
    /// [`Code::Shape`](crate::Code::Shape) when the belief is not of the system's size.
    pub fn new(system: &System, belief: &Belief) -> Result<Self, Error> {
        belief_fits(belief, system.f.nrows())?;
        Ok(Self(Kind::new(system, belief)))
    }

    /// x̂(k+1 | k) = F x̂ + G u and P(k+1 | k) = F P Fᵀ + V, with the input `u` (m; empty for a system without inputs).
    ///
    /// # Errors
    /// [`Code::Shape`](crate::Code::Shape) or [`Code::NotFinite`](crate::Code::NotFinite), naming u, x or P; the filter
    /// is then as it was.
    pub fn predict(&mut self, u: &[f64]) -> Result<(), Error> {
        each!(&mut self.0, filter => filter.input(u).and_then(|()| filter.predict(u)))
    }

    /// The belief corrected by the reading `y` (p), in Joseph's form.
    ///
    /// # Errors
    /// Those of [`predict`](Self::predict) with y for u, and
    /// [`Code::InnovationNotPositiveDefinite`](crate::Code::InnovationNotPositiveDefinite) naming W; the filter is then
    /// as it was.
    pub fn update(&mut self, y: &[f64]) -> Result<(), Error> {
        each!(&mut self.0, filter => filter.reading(y).and_then(|()| filter.update(y)))
    }

    /// A prediction with `u` and a correction by `y`, both or neither.
    ///
    /// # Errors
    /// Those of [`predict`](Self::predict) and [`update`](Self::update); the filter is then as it was before both.
    pub fn step(&mut self, u: &[f64], y: &[f64]) -> Result<(), Error> {
        each!(&mut self.0, filter => {
            filter.input(u)?;
            filter.reading(y)?;
            filter.step(u, y)
        })
    }

    /// [`update`](Self::update) by the parts of `y` that are there, with the rows of H and W that are theirs. Where
    /// none is there, nothing was read: the belief and the likelihood stay, and there is no [`nis`](Self::nis).
    ///
    /// # Errors
    /// As there.
    pub fn update_partly(&mut self, y: &[Option<f64>]) -> Result<(), Error> {
        let there: Vec<f64> = y.iter().flatten().copied().collect();
        if there.len() == y.len() {
            return self.update(&there);
        }
        let (p, n) = each!(&self.0, filter => filter.system.h.shape());
        let (h, w) = each!(&self.0, filter => (filter.system.h.as_slice(), filter.system.w.as_slice()));
        let (h, w) = (sized(Dyn(p), Dyn(n), h), sized(Dyn(p), Dyn(p), w));
        self.correct_by(y, &h, &w)
    }

    /// [`predict`](Self::predict) over a step of its own in place of the system's: F n×n, G n×m and V n×n, as
    /// [`Continuous::discretize`](super::Continuous::discretize) gives them for any span of time.
    ///
    /// # Errors
    /// Those of [`predict`](Self::predict); [`Code::Shape`], [`Code::NotFinite`] and those of [`validate::covariance`]
    /// naming F, G or V.
    pub fn predict_over(&mut self, u: &[f64], step: Discrete) -> Result<(), Error> {
        let (n, m) = each!(&self.0, filter => filter.system.g.shape());
        let f = validate::matrix(step.f, (n, n), "F")?;
        let g = validate::matrix(step.g, (n, m), "G")?;
        let v = validate::covariance(step.v, n, "V")?;
        each!(&mut self.0, filter => {
            filter.input(u).and_then(|()| filter.predict_by(u, f.as_slice(), g.as_slice(), v.as_slice()))
        })
    }

    /// [`update_partly`](Self::update_partly) by a sensor of its own in place of the system's: H p×n and W p×p, with
    /// p ≤ 8 outputs, as many as `y` has.
    ///
    /// # Errors
    /// As there, and naming H or W: [`Code::Limit`], [`Code::Shape`], [`Code::NotFinite`] and those of
    /// [`validate::covariance`].
    pub fn update_by(&mut self, y: &[Option<f64>], h: DMatrix<f64>, w: DMatrix<f64>) -> Result<(), Error> {
        let (n, p) = (self.x().len(), h.nrows());
        size(p, MAX_OUTPUTS, "H")?;
        let (h, w) = (validate::matrix(h, (p, n), "H")?, validate::covariance(w, p, "W")?);
        self.correct_by(y, &h, &w)
    }

    fn correct_by(&mut self, y: &[Option<f64>], h: &DMatrix<f64>, w: &DMatrix<f64>) -> Result<(), Error> {
        validate::entries(&y.iter().map(|part| part.unwrap_or(0.0)).collect::<Vec<f64>>(), h.nrows(), "y")?;
        let there: Vec<f64> = y.iter().flatten().copied().collect();
        if there.is_empty() {
            each!(&mut self.0, filter => filter.last = Last::Nothing);
            return Ok(());
        }
        let (h, w) = rows_there(h, w, y);
        let y = DVector::from_vec(there);
        each!(&mut self.0, filter => filter.update_by(&y, &h, &w))
    }

    /// [`step`](Self::step) with [`update_partly`](Self::update_partly) in place of the correction.
    ///
    /// # Errors
    /// As there.
    pub fn step_partly(&mut self, u: &[f64], y: &[Option<f64>]) -> Result<(), Error> {
        let before = self.clone();
        let done = self.predict(u).and_then(|()| self.update_partly(y));
        done.inspect_err(|_| *self = before)
    }

    /// The mean x̂, n.
    pub fn x(&self) -> &[f64] {
        each!(&self.0, filter => filter.belief.x.as_slice())
    }

    /// A step for each row of a log, whose numbers are known to be finite and so many: all means, and all variances,
    /// row by row.
    ///
    /// # Errors
    /// That of the first step that is refused, with its number, counted from one. The filter is then between the halves
    /// of a step.
    pub(super) fn replay(&mut self, inputs: &[f64], readings: &[f64]) -> Result<(Vec<f64>, Vec<f64>), (Error, usize)> {
        each!(&mut self.0, filter => filter.replay(inputs, readings))
    }

    /// The belief N(x̂, P).
    pub fn belief(&self) -> Belief {
        let n = self.x().len();
        let p = each!(&self.0, filter => DMatrix::from_column_slice(n, n, filter.belief.p.as_slice()));
        Gaussian { x: DVector::from_column_slice(self.x()), p }
    }

    /// Whether S, P and x̂ of every step so far are right to 10⁻⁶ of their largest entries, x̂ to that part of the
    /// largest standard deviation where this is more. They are not where a reading takes away variances so large that
    /// their
    /// rounding is more than what is left, as after a prior of 10¹⁴ with W of 10⁻¹⁰.
    pub fn conditioned(&self) -> bool {
        each!(&self.0, filter => filter.belief.conditioned())
    }

    /// Σ −½ (ln det 2πS + νᵀS⁻¹ν) over all readings; nothing where the filter is not
    /// [`conditioned`](Self::conditioned), [`log_density`] had no answer at one of them, or the sum is too large for a
    /// number.
    pub fn log_likelihood(&self) -> Option<f64> {
        each!(&self.0, filter => filter.log_likelihood)
    }

    /// The normalized innovation squared νᵀS⁻¹ν of the last reading; nothing before the first, and where S is singular
    /// to working accuracy.
    pub fn nis(&self) -> Option<f64> {
        each!(&self.0, filter => match &filter.last {
            Last::Nothing => None,
            Last::Whole(update) => update.d2,
            Last::Partly(update) => update.d2,
        })
    }

    /// What the last reading has told; nothing before the first, and where none of its parts was there.
    pub fn last(&self) -> Option<LastReading> {
        each!(&self.0, filter => match &filter.last {
            Last::Nothing => None,
            Last::Whole(update) => Some(LastReading::of(update)),
            Last::Partly(update) => Some(LastReading::of(update)),
        })
    }
}
