//! The unscented Kalman filter (Julier and Uhlmann 1997; van der Merwe 2004), in Thrun's letters.

use crate::covariance::{finite, symmetric};
use crate::error::{Error, Parameter, Quantity};
use crate::manifold::State;
use crate::model::{MeasurementModel, MotionModel};
use crate::sizes::Sizes;
use crate::update::Update;
use alloc::vec::Vec;
use nalgebra::allocator::Allocator;
use nalgebra::{Const, DefaultAllocator, Dim, OMatrix, OVector, SMatrix, SVector};
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

/// An unscented Kalman filter that holds its belief.
///
/// # Example
/// ```
/// use filters::ukf::{SigmaPoints, Ukf};
/// use filters::{Error, MeasurementModel};
/// use nalgebra::{Matrix1, Vector1};
/// struct Square;
/// impl MeasurementModel<Vector1<f64>, 1, 1> for Square {
///     fn h(&self, x: &Vector1<f64>, _: usize) -> Result<Vector1<f64>, Error> { Ok(Vector1::new(x[0] * x[0])) }
///     fn jacobian(&self, x: &Vector1<f64>, _: usize) -> Result<Matrix1<f64>, Error> { Ok(Matrix1::new(2.0 * x[0])) }
/// }
/// let mut ukf = Ukf { x: Vector1::new(3.0), p: Matrix1::new(0.25), points: SigmaPoints::default() };
/// let update = ukf.update(&Square, &Vector1::new(10.0), 0, &Matrix1::new(0.5))?;
/// assert!((update.innovation[0] - 0.75).abs() < 1e-6); // 10 − E x², with E x² = μ² + σ²
/// # Ok::<(), filters::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ukf<X, const N: usize> {
    /// The mean μ.
    pub x: X,
    /// The covariance Σ, n×n, in the coordinates of ⊞ at the mean.
    pub p: SMatrix<f64, N, N>,
    /// The sigma points in use.
    pub points: SigmaPoints,
}

/// The sigma points about a mean, in the coordinates of ⊞ there, with their weights: the mean itself, and one along + and
/// − each column of a root of Σ.
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
    #[expect(clippy::type_complexity, reason = "three answers of one step, taken apart where it is called")]
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

impl<X: State<N>, const N: usize> Ukf<X, N> {
    /// The belief after x⁺ = f(x, u) + noise of covariance R.
    ///
    /// # Errors
    /// [`Error::NotFinite`], or [`Error::OutOfRange`] when Σ is not positive definite or the points cannot be placed;
    /// the belief is then unchanged.
    pub fn predict<const U: usize>(
        &mut self,
        model: &impl MotionModel<X, N, U>,
        u: &SVector<f64, U>,
        r: &SMatrix<f64, N, N>,
    ) -> Result<(), Error> {
        let spread = self.points.spread(&self.p)?;
        let centre = model.f(&self.x, u);
        let moved = spread.image(Const::<N>, |d| Ok(model.f(&self.x.boxplus(d), u).boxminus(&centre)))?;
        let x = centre.boxplus(&moved.mean);
        if !x.is_finite() {
            return Err(Error::NotFinite(Quantity::PredictedMean));
        }
        (self.p, self.x) = (spread.predicted_covariance(&moved, r)?, x);
        Ok(())
    }

    /// Corrects the belief with the reading `z` of feature `j`, of noise covariance Q.
    ///
    /// # Errors
    /// As [`Ukf::predict`], [`Error::InnovationNotPositiveDefinite`], or what the model answers; the belief is then
    /// unchanged.
    pub fn update<const M: usize>(
        &mut self,
        model: &impl MeasurementModel<X, N, M>,
        z: &SVector<f64, M>,
        j: usize,
        q: &SMatrix<f64, M, M>,
    ) -> Result<Update<Const<N>, Const<M>>, Error> {
        let spread = self.points.spread(&self.p)?;
        let centre = model.h(&self.x, j)?;
        let expected = |d: &SVector<f64, N>| Ok(model.residual(&model.h(&self.x.boxplus(d), j)?, &centre));
        let seen = spread.image(Const::<M>, expected)?;
        let innovation = model.residual(z, &(centre + seen.mean));
        let (step, p, update) = spread.correction(&self.p, &seen, innovation, q)?;
        let x = self.x.boxplus(&step);
        if !x.is_finite() {
            return Err(Error::NotFinite(Quantity::Mean));
        }
        (self.x, self.p) = (x, p);
        Ok(update)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};

    struct Square;

    impl MotionModel<Vector1<f64>, 1, 1> for Square {
        fn f(&self, x: &Vector1<f64>, _: &SVector<f64, 1>) -> Vector1<f64> {
            Vector1::new(x[0] * x[0])
        }

        fn jacobian(&self, x: &Vector1<f64>, _: &SVector<f64, 1>) -> Matrix1<f64> {
            Matrix1::new(2.0 * x[0])
        }
    }

    struct Sum;

    impl MotionModel<Vector2<f64>, 2, 1> for Sum {
        fn f(&self, x: &Vector2<f64>, u: &SVector<f64, 1>) -> Vector2<f64> {
            Vector2::new(x[0] + 2.0 * x[1], x[1] + u[0])
        }

        fn jacobian(&self, _: &Vector2<f64>, _: &SVector<f64, 1>) -> Matrix2<f64> {
            Matrix2::new(1.0, 2.0, 0.0, 1.0)
        }
    }

    impl MeasurementModel<Vector2<f64>, 2, 1> for Sum {
        fn h(&self, x: &Vector2<f64>, _: usize) -> Result<Vector1<f64>, Error> {
            Ok(Vector1::new(3.0 * x[0] - x[1]))
        }

        fn jacobian(&self, _: &Vector2<f64>, _: usize) -> Result<RowVector2<f64>, Error> {
            Ok(RowVector2::new(3.0, -1.0))
        }
    }

    impl MeasurementModel<Vector1<f64>, 1, 1> for Square {
        fn h(&self, x: &Vector1<f64>, _: usize) -> Result<Vector1<f64>, Error> {
            Ok(Vector1::new(x[0] * x[0]))
        }

        fn jacobian(&self, x: &Vector1<f64>, _: usize) -> Result<Matrix1<f64>, Error> {
            Ok(Matrix1::new(2.0 * x[0]))
        }
    }

    /// E x² = μ² + σ², and Var x² = 4μ²σ² + 2σ⁴ for a normal x: both exact with κ = 2, α = 1, β = 0.
    #[test]
    fn the_moments_of_a_square_are_exact() {
        let points = SigmaPoints { alpha: 1.0, beta: 0.0, kappa: 2.0 };
        let mut ukf = Ukf { x: Vector1::new(3.0), p: Matrix1::new(0.25), points };
        ukf.predict(&Square, &Vector1::zeros(), &Matrix1::zeros()).expect("positive definite");
        assert!((ukf.x[0] - 9.25).abs() < 1e-14);
        assert!((ukf.p[0] - (4.0 * 9.0 * 0.25 + 2.0 * 0.0625)).abs() < 1e-13);
    }

    /// By hand: of x² the mean is met whatever the points, the variance found is 4μ²σ² + (α²κ + β)σ⁴, the covariance
    /// with x 2μσ².
    #[test]
    fn alpha_beta_and_kappa_enter_the_moments_of_a_square_as_derived() {
        let (mu, var, q) = (3.0, 0.25, 0.5);
        let (points, fourth) = (SigmaPoints { alpha: 0.5, beta: 1.5, kappa: 3.0 }, 0.25 * 3.0 + 1.5);
        let spread = 4.0 * mu * mu * var + fourth * var * var;
        let start = Ukf { x: Vector1::new(mu), p: Matrix1::new(var), points };
        let mut moved = start;
        moved.predict(&Square, &Vector1::zeros(), &Matrix1::new(q)).expect("positive definite");
        assert!((moved.x[0] - (mu * mu + var)).abs() < 1e-14 && (moved.p[0] - (spread + q)).abs() < 1e-13);

        let mut read = start;
        let update = read.update(&Square, &Vector1::new(10.0), 0, &Matrix1::new(q)).expect("positive definite");
        let (s, cross) = (spread + q, 2.0 * mu * var);
        assert!((update.innovation[0] - (10.0 - mu * mu - var)).abs() < 1e-14 && (update.s[0] - s).abs() < 1e-13);
        assert!((update.k[0] - cross / s).abs() < 1e-15);
        assert!((read.x[0] - (mu + update.k[0] * update.innovation[0])).abs() < 1e-15);
        assert!((read.p[0] - (var - cross * cross / s)).abs() < 1e-15);
        assert!(update.d2.is_some_and(|d2| (d2 - update.innovation[0] * update.innovation[0] / s).abs() < 1e-15));
    }

    #[test]
    fn on_a_linear_system_every_choice_of_points_is_the_kalman_filter() {
        let (r, q) = (Matrix2::identity() * 0.1, Matrix1::new(0.5));
        let mut exact = crate::ekf::Ekf { x: Vector2::new(1.0, -1.0), p: Matrix2::new(2.0, 0.5, 0.5, 1.0) };
        let start = exact;
        exact.predict(&Sum, &Vector1::new(0.5), &r).expect("finite");
        exact.update(&Sum, &Vector1::new(2.0), 0, &q).expect("positive definite");
        for (points, digits) in
            [(SigmaPoints::default(), 1e-8), (SigmaPoints { alpha: 1.0, beta: 0.0, kappa: 0.0 }, 1e-14)]
        {
            let mut ukf = Ukf { x: start.x, p: start.p, points };
            ukf.predict(&Sum, &Vector1::new(0.5), &r).expect("positive definite");
            ukf.update(&Sum, &Vector1::new(2.0), 0, &q).expect("positive definite");
            // With α = 1e-3 the weights are 1e6: six digits are spent on them.
            assert!((ukf.x - exact.x).amax() < digits && (ukf.p - exact.p).amax() < digits);
        }
    }

    #[test]
    fn sigma_points_that_cannot_be_placed_are_refused_and_the_belief_kept() {
        for points in [
            SigmaPoints { alpha: 0.0, ..Default::default() },
            SigmaPoints { kappa: -2.0, ..Default::default() },
            SigmaPoints { beta: f64::NAN, ..Default::default() },
            SigmaPoints { alpha: -0.5, ..Default::default() },
            SigmaPoints { alpha: 1e200, ..Default::default() },
        ] {
            let mut ukf = Ukf { x: Vector2::zeros(), p: Matrix2::identity(), points };
            let refused = ukf.predict(&Sum, &Vector1::zeros(), &Matrix2::zeros());
            assert_eq!(refused, Err(Error::OutOfRange(Parameter::SigmaPoints)));
        }
        let singular = Ukf { x: Vector2::zeros(), p: Matrix2::zeros(), points: SigmaPoints::default() };
        let mut ukf = singular;
        assert!(ukf.update(&Sum, &Vector1::zeros(), 0, &Matrix1::new(1.0)).is_err());
        assert_eq!(ukf, singular);
    }
}
