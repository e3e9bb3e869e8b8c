//! A Kalman filter that holds its system and its belief, for sizes known at run time only. Few states and few outputs
//! are filtered at the pace of typed code, to the same bits.

use super::partial::rows_there;
use super::{Belief, System};
use crate::error::Error;
use crate::followed::Followed;
use crate::kf::belief_fits;
use crate::likelihood::log_density;
use crate::lti::{Lti, SystemSizes};
use crate::validate;
use alloc::boxed::Box;
use alloc::vec::Vec;
use filters::Gaussian;
use nalgebra::allocator::Allocator;
use nalgebra::{Const, DMatrix, DVector, DefaultAllocator, Dim, Dyn, OMatrix, U1, VectorView};

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
        validate::entries(&y.iter().map(|part| part.unwrap_or(0.0)).collect::<Vec<f64>>(), p, "y")?;
        if there.is_empty() {
            each!(&mut self.0, filter => filter.nis = None);
            return Ok(());
        }
        let (h, w) = each!(&self.0, filter => (filter.system.h.as_slice(), filter.system.w.as_slice()));
        let (h, w) = rows_there(&sized(Dyn(p), Dyn(n), h), &sized(Dyn(p), Dyn(p), w), y);
        let y = DVector::from_vec(there);
        let update = each!(&mut self.0, filter => filter.belief.correct_partly(&y, &h, &w)?);
        let density = log_density(&update.innovation, &update.s);
        each!(&mut self.0, filter => filter.note(density, update.d2));
        Ok(())
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
        each!(&self.0, filter => filter.nis)
    }
}

/// The filter with matrices of the sizes N and M; how many inputs there are is known at run time only.
#[derive(Clone, Debug)]
struct Filter<N: Dim, M: Dim>
where
    DefaultAllocator: SystemSizes<N, Dyn, M>,
{
    system: Lti<N, Dyn, M>,
    belief: Followed<N>,
    log_likelihood: Option<f64>,
    nis: Option<f64>,
}

impl<N: Dim, M: Dim> Filter<N, M>
where
    DefaultAllocator: SystemSizes<N, Dyn, M>,
{
    /// `system` and `belief`, which are of the sizes (n, p).
    fn new(system: &System, belief: &Belief, (n, p): (N, M)) -> Self {
        let system = Lti {
            f: kept(n, n, system.f.as_slice()),
            g: kept(n, Dyn(system.g.ncols()), system.g.as_slice()),
            h: kept(p, n, system.h.as_slice()),
            v: kept(n, n, system.v.as_slice()),
            w: kept(p, p, system.w.as_slice()),
        };
        let belief = Gaussian { x: kept(n, U1, belief.x.as_slice()), p: kept(n, n, belief.p.as_slice()) };
        Self { system, belief: belief.into(), log_likelihood: Some(0.0), nis: None }
    }

    // In wasm a half is one function, in a step too: in line it would weigh twice, and be hardly quicker.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    fn predict(&mut self, u: &[f64]) -> Result<(), Error> {
        let system = &self.system;
        let u = VectorView::from_slice_generic(u, system.g.shape_generic().1, U1);
        Ok(self.belief.predict(&system.f, &system.v, Some((&system.g, &u)))?)
    }

    #[cfg_attr(target_arch = "wasm32", inline(never))]
    fn update(&mut self, y: &[f64]) -> Result<(), Error> {
        let system = &self.system;
        let y = sized(system.h.shape_generic().0, U1, y);
        let update = self.belief.correct(&y, &system.h, &system.w)?;
        self.note(log_density(&update.innovation, &update.s), update.d2);
        Ok(())
    }

    #[inline]
    fn step(&mut self, u: &[f64], y: &[f64]) -> Result<(), Error> {
        let before = self.belief.clone();
        self.predict(u)?;
        self.update(y).inspect_err(|_| self.belief = before)
    }

    fn replay(&mut self, inputs: &[f64], readings: &[f64]) -> Result<(Vec<f64>, Vec<f64>), (Error, usize)> {
        let (p, n) = self.system.h.shape_generic();
        let (n, m, p) = (n.value(), self.system.g.ncols(), p.value());
        let steps = readings.len() / p;
        let (mut x, mut variances) = (Vec::with_capacity(steps * n), Vec::with_capacity(steps * n));
        for k in 0..steps {
            let (u, y) = (&inputs[k * m..(k + 1) * m], &readings[k * p..(k + 1) * p]);
            self.predict(u).and_then(|()| self.update(y)).map_err(|e| (e, k + 1))?;
            x.extend(self.belief.x.iter());
            variances.extend((0..n).map(|i| self.belief.p[(i, i)]));
        }
        Ok((x, variances))
    }

    fn input(&self, u: &[f64]) -> Result<(), Error> {
        validate::entries(u, self.system.g.ncols(), "u")
    }

    fn reading(&self, y: &[f64]) -> Result<(), Error> {
        validate::entries(y, self.system.h.nrows(), "y")
    }

    /// The density and the squared distance of a reading.
    fn note(&mut self, density: Option<f64>, d2: Option<f64>) {
        let sum = self.log_likelihood.zip(density).map(|(sum, density)| sum + density);
        self.log_likelihood = sum.filter(|sum| sum.is_finite() && self.belief.conditioned());
        self.nis = d2;
    }
}

/// [`sized`] where it is called once for a filter, of which there are many sizes.
#[cfg_attr(target_arch = "wasm32", inline(never))]
fn kept<R: Dim, C: Dim>(rows: R, columns: C, entries: &[f64]) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    sized(rows, columns, entries)
}

fn sized<R: Dim, C: Dim>(rows: R, columns: C, entries: &[f64]) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    OMatrix::from_column_slice_generic(rows, columns, entries)
}
