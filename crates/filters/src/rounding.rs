//! What rounding may have left in a covariance: a bound that is carried beside a filter once one of its corrections was
//! doubted.
//!
//! Errors of a covariance behave like covariances. Where Σ is wrong by at most E, in the order of symmetric matrices,
//! AΣAᵀ is wrong by at most AEAᵀ, and a correction leaves (I − KC) E (I − KC)ᵀ of it to first order: the gain is the
//! best one, and its own error enters squared only. Each step adds the rounding of its terms. Where Σ had a variance of
//! 10¹⁴ in a direction and a reading has taken it away, E is what it has left behind.

use crate::covariance::at_run_time;
use crate::gaussian::Gaussian;
use crate::sizes::Sizes;
use crate::update::Update;
use alloc::vec::Vec;
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DefaultAllocator, Dim, OMatrix};
use numerics::{Spd, sqrt};

/// The part of S, of the largest variance, and of the mean or the largest deviation that may be wrong where a filter is
/// well conditioned.
pub const MAX_ERROR: f64 = 1e-6;
/// The bounds are right to first order: a fifth of what is promised leaves room for the rest.
const MAX_BOUND: f64 = MAX_ERROR / 5.0;
/// A bound that is this part of the covariance, along all of its axes together, is carried on no further: no later step
/// makes it a larger part.
const NEGLIGIBLE: f64 = 1e-12;

/// Whether what a filter has answered since its beginning is right to [`MAX_ERROR`]. Steps that are not doubted cost it
/// nothing.
///
/// # Example
/// ```
/// use filters::{Conditioning, Gaussian};
/// use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};
/// // Two readings of the sum and of the difference of two states that nothing is known of.
/// let mut belief = Gaussian { x: Vector2::zeros(), p: Matrix2::identity() * 1e14 };
/// let mut filter = Conditioning::default();
/// for c in [RowVector2::new(1.0, 1.0), RowVector2::new(1.0, -1.0)] {
///     let (corrected, update) = belief.corrected(&Vector1::new(1.0), &c, &Matrix1::new(1e-10))?;
///     filter.corrected(&belief.p, (&c, &Matrix1::new(1e-10)), &update, &corrected);
///     belief = corrected;
/// }
/// // The first has left variances of 10¹⁴ that a double holds to 10⁻² only; the second should leave 10⁻¹⁰.
/// assert!(!filter.is_well_conditioned());
/// # Ok::<(), filters::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Conditioning {
    bound: Bound,
    lost: bool,
}

/// What is known of the rounding in a covariance.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Bound {
    /// It is nothing beside the covariance in any direction.
    #[default]
    Nothing,
    /// It is that of the entries, and may be much of the covariance in some direction.
    OfEntries,
    /// It was worse once, and is carried along: E, n×n, a bound on the error of the covariance.
    Carried(DMatrix<f64>),
}

impl Conditioning {
    /// That of a filter with the covariance `p`, of which the first step is doubted.
    pub fn of<N: Dim>(p: &OMatrix<f64, N, N>) -> Self
    where
        DefaultAllocator: Allocator<N, N>,
    {
        Self { bound: Bound::Carried(Rounding::of(&at_run_time(p)).0), lost: false }
    }

    /// That of a filter that is gone on with: what was known of its rounding, and whether digits were lost.
    pub fn resumed(bound: Bound, lost: bool) -> Self {
        Self { bound, lost }
    }

    /// What is known of the rounding in the covariance of now.
    pub fn bound(&self) -> &Bound {
        &self.bound
    }

    /// Whether S, Σ and μ of every step so far are right to [`MAX_ERROR`] of their largest entries, μ to that part of
    /// the largest deviation where this is more.
    pub fn is_well_conditioned(&self) -> bool {
        !self.lost
    }

    /// Beside the prediction AΣAᵀ + R from the covariance `p`, which is `regular` or not.
    #[inline]
    pub fn predicted<N: Dim>(
        &mut self,
        a: &OMatrix<f64, N, N>,
        p: &OMatrix<f64, N, N>,
        r: &OMatrix<f64, N, N>,
        regular: bool,
    ) where
        DefaultAllocator: Allocator<N, N>,
    {
        match &mut self.bound {
            Bound::Carried(rounding) => {
                let before = Rounding(core::mem::take(rounding));
                *rounding = before.predicted([a, p, r].map(|m| at_run_time(m))).0;
            }
            bound if !regular => *bound = Bound::OfEntries,
            _ => {}
        }
    }

    /// Beside the correction of the covariance `p` by a reading with C and Q, which has left the belief `posterior`.
    #[inline]
    pub fn corrected<N: Dim, M: Dim>(
        &mut self,
        p: &OMatrix<f64, N, N>,
        (c, q): (&OMatrix<f64, M, N>, &OMatrix<f64, M, M>),
        update: &Update<N, M>,
        posterior: &Gaussian<N>,
    ) where
        DefaultAllocator: Sizes<N, M>,
    {
        if update.doubted || !matches!(self.bound, Bound::Nothing) {
            let given = [at_run_time(p), at_run_time(c), at_run_time(q)];
            let found = [at_run_time(&update.k), at_run_time(&update.s), at_run_time(&posterior.p)];
            self.judged(&given, found, &at_run_time(&update.innovation), posterior.x.amax());
        }
    }

    #[cold]
    #[inline(never)]
    fn judged(
        &mut self,
        [p, c, q]: &[DMatrix<f64>; 3],
        [k, s, posterior]: [DMatrix<f64>; 3],
        innovation: &DMatrix<f64>,
        largest: f64,
    ) {
        let before = match core::mem::take(&mut self.bound) {
            Bound::Carried(rounding) => Rounding(rounding),
            _ => Rounding::of(p),
        };
        let of_s = before.of_s([p, c, q]);
        self.lost |= relative(&of_s, s.clone()) > MAX_BOUND;
        let rounding = before.corrected([p, c, q], &k, &posterior);
        let (error, variance) = (rounding.0.diagonal().max(), posterior.diagonal().max());
        // A reading without noise leaves nothing, and the rounding of K leaves this of it.
        let nothing = 4.0 * p.nrows() as f64 * f64::EPSILON;
        self.lost |= error > MAX_BOUND * variance && error > nothing * nothing * p.diagonal().max();
        let scale = MAX_BOUND * largest.max(sqrt(variance));
        self.lost |= before.of_mean([p, c], s, innovation) > scale || of_sum(&k, c, innovation, largest) > scale;
        if relative(&rounding.0, posterior) > NEGLIGIBLE {
            self.bound = Bound::Carried(rounding.0);
        }
    }
}

/// E, n×n: a bound on the error of a covariance.
#[derive(Clone, Debug)]
struct Rounding(DMatrix<f64>);

impl Rounding {
    /// That of a covariance whose entries are rounded.
    fn of(p: &DMatrix<f64>) -> Self {
        Self(of_terms(&deviations(p)))
    }

    /// That of AΣAᵀ + R.
    fn predicted(&self, [a, p, r]: [DMatrix<f64>; 3]) -> Self {
        Self(&a * &self.0 * a.transpose() + of_terms(&sums([(&a, &p)], &r)))
    }

    /// That of (I − KC) Σ (I − KC)ᵀ + KQKᵀ, the `posterior`.
    fn corrected(&self, [p, c, q]: [&DMatrix<f64>; 3], k: &DMatrix<f64>, posterior: &DMatrix<f64>) -> Self {
        let left = DMatrix::identity(p.nrows(), p.nrows()) - k * c;
        Self(&left * &self.0 * left.transpose() + of_terms(&sums([(&left, p), (k, q)], posterior)))
    }

    /// That of S.
    fn of_s(&self, [p, c, q]: [&DMatrix<f64>; 3]) -> DMatrix<f64> {
        c * &self.0 * c.transpose() + of_terms(&sums([(c, p)], q))
    }

    /// How far Σ̄CᵀS⁻¹(z − Cμ̄) is off. A covariance of two directions is known no better than the rounding of the
    /// largest entry, however little is left of the variance in one of them.
    fn of_mean(&self, [p, c]: [&DMatrix<f64>; 2], s: DMatrix<f64>, innovation: &DMatrix<f64>) -> f64 {
        let Some(s) = Spd::new(s) else { return f64::INFINITY };
        let weighed = (c.transpose() * s.solve(innovation)).abs();
        let least = p.nrows() as f64 * f64::EPSILON * p.amax();
        let errors = self.0.diagonal().map(|error| sqrt(error.max(least)));
        errors.max() * errors.dot(&weighed.column(0))
    }
}

/// The sum of the parts that `error` may be of a covariance along its axes; infinite where that is singular.
fn relative(error: &DMatrix<f64>, covariance: DMatrix<f64>) -> f64 {
    Spd::new(covariance).map_or(f64::INFINITY, |spd| spd.solve(error).trace())
}

/// The rounding of μ̄ + K(z − Cμ̄), of which the `largest` entry is left: where it is small beside its terms they
/// cancel.
fn of_sum(k: &DMatrix<f64>, c: &DMatrix<f64>, innovation: &DMatrix<f64>, largest: f64) -> f64 {
    let [k, c, innovation] = [k, c, innovation].map(|m| m.abs());
    let terms = largest + (&k * innovation).max();
    let grown = (k * c).row_iter().map(|row| row.sum()).fold(1.0, f64::max);
    f64::EPSILON * grown * terms
}

fn deviations(p: &DMatrix<f64>) -> Vec<f64> {
    p.diagonal().iter().map(|variance| sqrt(variance.max(0.0))).collect()
}

/// The deviations that Σ MΣMᵀ over the pairs (M, Σ), and `alone` beside them, would have if no terms cancelled.
fn sums<const PAIRS: usize>(pairs: [(&DMatrix<f64>, &DMatrix<f64>); PAIRS], alone: &DMatrix<f64>) -> Vec<f64> {
    let mut sums = deviations(alone);
    for (m, of) in pairs {
        for (j, sigma) in deviations(of).into_iter().enumerate() {
            sums.iter_mut().enumerate().for_each(|(i, sum)| *sum += m[(i, j)].abs() * sigma);
        }
    }
    sums
}

/// A bound on the rounding of a matrix whose entry (i, j) is a sum of terms of the size of eᵢ eⱼ.
fn of_terms(e: &[f64]) -> DMatrix<f64> {
    let each = e.len() as f64 * f64::EPSILON;
    DMatrix::from_fn(e.len(), e.len(), |i, j| if i == j { each * e[i] * e[i] } else { 0.0 })
}
