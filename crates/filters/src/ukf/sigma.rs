//! Sigma points: where a function is asked for the mean and the covariance of what it makes of a belief.

use crate::covariance::{finite, symmetric};
use crate::error::{Error, Parameter, Quantity};
use crate::sizes::Sizes;
use crate::update::Update;
use alloc::vec::Vec;
use nalgebra::allocator::Allocator;
use nalgebra::{Const, DefaultAllocator, Dim, OMatrix, OVector};
use numerics::sqrt;
use numerics::{MIN_PIVOT, Spd};

/// Where the sigma points lie and what they weigh. The answer depends on this choice, so a result should name it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SigmaPoints {
    /// Spread of the points about the mean, positive.
    pub alpha: f64,
    /// What is known of the distribution's kurtosis; 2 is right for a normal one.
    pub beta: f64,
    /// A second scale, with n + κ positive.
    pub kappa: f64,
}

impl Default for SigmaPoints {
    /// α = 1e-3, β = 2, κ = 0: van der Merwe's usual choice.
    fn default() -> Self {
        Self { alpha: 1e-3, beta: 2.0, kappa: 0.0 }
    }
}

/// The sigma points about a mean, in the coordinates of ⊞ there, with their weights: the mean itself, and one along
/// + and − each column of a root of Σ.
pub struct Spread<N: Dim>
where
    DefaultAllocator: Sizes<N>,
{
    /// √(n + λ) times the columns of Σ's Cholesky root.
    columns: Vec<OVector<f64, N>>,
    /// The weight of each of the 2n outer points.
    outer: f64,
    /// The weight of the centre in a covariance.
    centre: f64,
}

/// What a function makes of the sigma points.
pub struct Image<M: Dim>
where
    DefaultAllocator: Allocator<M>,
{
    /// The deviations of the outer points' images from that of the centre.
    deviations: Vec<[OVector<f64, M>; 2]>,
    /// Their weighted mean: E f(x) is this from the centre's image.
    pub mean: OVector<f64, M>,
}

impl SigmaPoints {
    /// The points for a belief of covariance `p`.
    ///
    /// # Errors
    /// [`Error::NotFinite`], or [`Error::OutOfRange`] when Σ is not positive definite or the points cannot be placed.
    pub fn spread<N: Dim>(&self, p: &OMatrix<f64, N, N>) -> Result<Spread<N>, Error>
    where
        DefaultAllocator: Sizes<N>,
    {
        let Self { alpha, beta, kappa } = *self;
        let n = p.nrows() as f64;
        let scale = alpha * alpha * (n + kappa); // n + λ
        let usable = alpha > 0.0 && scale > 0.0 && scale.is_finite() && beta.is_finite();
        if !usable {
            return Err(Error::OutOfRange(Parameter::SigmaPoints));
        }
        let p = finite(p.clone(), Quantity::Covariance)?;
        let root = Spd::new(p).ok_or(Error::OutOfRange(Parameter::Covariance))?.root() * sqrt(scale);
        let columns = root.column_iter().map(|column| column.into_owned()).collect();
        let centre_mean = (scale - n) / scale;
        Ok(Spread { columns, outer: 0.5 / scale, centre: centre_mean + 1.0 - alpha * alpha + beta })
    }
}

impl<M: Dim> Image<M>
where
    DefaultAllocator: Allocator<M>,
{
    /// The image of a part of the function's components, which `of` takes of each deviation.
    #[must_use]
    pub fn part<L: Dim>(&self, of: impl Fn(&OVector<f64, M>) -> OVector<f64, L>) -> Image<L>
    where
        DefaultAllocator: Allocator<L>,
    {
        let deviations = self.deviations.iter().map(|[ahead, behind]| [of(ahead), of(behind)]).collect();
        Image { deviations, mean: of(&self.mean) }
    }
}

impl<N: Dim> Spread<N>
where
    DefaultAllocator: Sizes<N>,
{
    /// The image under a function of M components, given as the deviation of its value from that at the centre.
    ///
    /// # Errors
    /// What the function answers.
    pub fn image<M: Dim, E>(
        &self,
        size: M,
        mut deviation: impl FnMut(&OVector<f64, N>) -> Result<OVector<f64, M>, E>,
    ) -> Result<Image<M>, E>
    where
        DefaultAllocator: Allocator<M>,
    {
        let mut deviations = Vec::with_capacity(self.columns.len());
        for column in &self.columns {
            deviations.push([deviation(column)?, deviation(&-column)?]);
        }
        let mut sum = OVector::zeros_generic(size, Const::<1>);
        deviations.iter().flatten().for_each(|d| sum += d);
        Ok(Image { mean: sum * self.outer, deviations })
    }

    /// The covariance of the image of f with noise of covariance `r`.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn predicted_covariance(&self, moved: &Image<N>, r: &OMatrix<f64, N, N>) -> Result<OMatrix<f64, N, N>, Error> {
        finite(symmetric(self.covariance(moved, moved) + r), Quantity::PredictedCovariance)
    }

    /// How a belief of covariance `p` is corrected by an innovation, of noise covariance Q, whose expected reading is
    /// the image `seen`: the step of the mean in the coordinates of ⊞, and the covariance.
    ///
    /// # Errors
    /// [`Error::NotFinite`] or [`Error::InnovationNotPositiveDefinite`].
    pub fn correction<M: Dim>(
        &self,
        p: &OMatrix<f64, N, N>,
        seen: &Image<M>,
        innovation: OVector<f64, M>,
        q: &OMatrix<f64, M, M>,
    ) -> Result<(OVector<f64, N>, OMatrix<f64, N, N>, Update<N, M>), Error>
    where
        DefaultAllocator: Sizes<N, M>,
    {
        let states = self.image(p.shape_generic().0, |d| Ok(d.clone()))?;
        let innovation = finite(innovation, Quantity::Innovation)?;
        let s = finite(symmetric(self.covariance(seen, seen) + q), Quantity::InnovationCovariance)?;
        let spd = Spd::new(s.clone()).ok_or(Error::InnovationNotPositiveDefinite)?;
        let k = spd.solve(&self.covariance(&states, seen).transpose()).transpose();
        let d2 = spd.squared_length(&innovation);
        let step = &k * &innovation;
        let p = finite(symmetric(p - &k * &s * k.transpose()), Quantity::Covariance)?;
        let doubted = spd.pivot() < MIN_PIVOT;
        Ok((step, p, Update { innovation, s, k, d2: Some(d2).filter(|d2| d2.is_finite()), doubted }))
    }

    /// Σ wᵢ (aᵢ − ā)(bᵢ − b̄)ᵀ over all 2n + 1 points, the centre's deviation being zero.
    fn covariance<M: Dim, L: Dim>(&self, a: &Image<M>, b: &Image<L>) -> OMatrix<f64, M, L>
    where
        DefaultAllocator: Allocator<M> + Allocator<L> + Allocator<M, L>,
    {
        let (rows, columns) = (a.mean.shape_generic().0, b.mean.shape_generic().0);
        let mut sum = OMatrix::from_fn_generic(rows, columns, |i, j| a.mean[i] * b.mean[j] * self.centre);
        for (of_a, of_b) in a.deviations.iter().flatten().zip(b.deviations.iter().flatten()) {
            let (of_a, of_b) = (of_a - &a.mean, of_b - &b.mean);
            sum += OMatrix::from_fn_generic(rows, columns, |i, j| of_a[i] * of_b[j] * self.outer);
        }
        sum
    }
}
