//! The linear Kalman filter (sister volume, chapter 6), in Thrun's letters.

use crate::error::Error;
use crate::gaussian::Gaussian;
use crate::sizes::Sizes;
use crate::update::Update;
use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};

/// A Kalman filter that holds its belief.
///
/// # Example
/// ```
/// use filters::{Gaussian, Kf};
/// use nalgebra::{Matrix1, U1, Vector1};
/// let one = Matrix1::new(1.0);
/// let mut kf = Kf::from(Gaussian { x: Vector1::new(0.0), p: one });
/// kf.predict::<U1>(&one, &one, None)?;                      // Σ̄ = 2
/// let info = kf.update(&Vector1::new(3.0), &one, &one)?;    // S = 3, K = 2/3
/// assert!((info.k[0] - 2.0 / 3.0).abs() < 1e-15);
/// assert!((kf.belief().x[0] - 2.0).abs() < 1e-15);
/// # Ok::<(), filters::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Kf<N: Dim>
where
    DefaultAllocator: Sizes<N>,
{
    belief: Gaussian<N>,
}

impl<N: Dim> From<Gaussian<N>> for Kf<N>
where
    DefaultAllocator: Sizes<N>,
{
    fn from(belief: Gaussian<N>) -> Self {
        Self { belief }
    }
}

impl<N: Dim> Kf<N>
where
    DefaultAllocator: Sizes<N>,
{
    /// The present belief.
    pub fn belief(&self) -> &Gaussian<N> {
        &self.belief
    }

    /// μ̄ = A μ + B u, Σ̄ = A Σ Aᵀ + R; see [`Gaussian::predicted`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] when an argument is not finite or a product overflows; the belief is then unchanged.
    pub fn predict<U: Dim>(
        &mut self,
        a: &OMatrix<f64, N, N>,
        r: &OMatrix<f64, N, N>,
        input: Option<(&OMatrix<f64, N, U>, &OVector<f64, U>)>,
    ) -> Result<(), Error>
    where
        DefaultAllocator: Allocator<N, U> + Allocator<U>,
    {
        self.belief = self.belief.predicted(a, r, input)?;
        Ok(())
    }

    /// Corrects the belief with the reading z = C x + noise of covariance Q; see [`Gaussian::corrected`].
    ///
    /// # Errors
    /// [`Error::InnovationNotPositiveDefinite`], or [`Error::NotFinite`]; the belief is then unchanged.
    pub fn update<M: Dim>(
        &mut self,
        z: &OVector<f64, M>,
        c: &OMatrix<f64, M, N>,
        q: &OMatrix<f64, M, M>,
    ) -> Result<Update<N, M>, Error>
    where
        DefaultAllocator: Sizes<N, M>,
    {
        let update;
        (self.belief, update) = self.belief.corrected(z, c, q)?;
        Ok(update)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linear;
    use nalgebra::{Matrix1, Matrix2, RowVector2, U1, U2, Vector1, Vector2};

    fn prior() -> Gaussian<U2> {
        Gaussian { x: Vector2::new(4.0, 4.0), p: Matrix2::new(1.7, 1.05, 1.05, 2.1) }
    }

    #[test]
    fn joseph_equals_the_short_form_at_the_optimal_gain() {
        let (c, q) = (RowVector2::new(0.3, 1.0), Matrix1::new(0.5));
        let mut kf = Kf::from(prior());
        let info = kf.update(&Vector1::new(2.7), &c, &q).expect("positive definite");
        let short = prior().p - info.k * c * prior().p;
        assert!((kf.belief().p - short).norm() < 1e-15);
    }

    #[test]
    fn joseph_stays_positive_semidefinite_at_any_gain_and_the_short_form_does_not() {
        let (c, q) = (RowVector2::new(0.0, 1.0), Matrix1::new(0.5));
        for gain in [[0.0, 0.0], [5.0, -3.0], [-40.0, 40.0], [1e6, 1e-6]] {
            let k = Vector2::from(gain);
            let p = linear::joseph(&prior().p, &k, &c, &q);
            assert!(p.trace() >= 0.0 && p.determinant() >= -1e-12 * p.trace() * p.trace(), "{gain:?}");
        }
        let k = Vector2::new(5.0, 3.0);
        assert!((prior().p - k * c * prior().p).trace() < 0.0);
    }

    #[test]
    fn the_optimal_gain_has_the_least_trace() {
        let (c, q) = (RowVector2::new(0.4, 1.0), Matrix1::new(0.5));
        let mut kf = Kf::from(prior());
        let k = kf.update(&Vector1::new(0.0), &c, &q).expect("positive definite").k;
        for d in [[1e-3, 0.0], [0.0, 1e-3], [-1e-3, 1e-3]] {
            let worse = linear::joseph(&prior().p, &(k + Vector2::from(d)), &c, &q).trace();
            assert!(worse > kf.belief().p.trace());
        }
    }

    #[test]
    fn a_vast_prior_leaves_the_noise_of_the_reading() {
        let mut kf = Kf::from(Gaussian { x: Vector1::new(0.0), p: Matrix1::new(1e24) });
        kf.update(&Vector1::new(1.0), &Matrix1::new(1.0), &Matrix1::new(0.04)).expect("positive definite");
        assert!((kf.belief().p[0] - 0.04).abs() < 1e-15);
    }

    #[test]
    fn joseph_is_its_formula_written_out() {
        let c = Matrix2::new(1.0, 0.3, -0.2, 2.0);
        let q = Matrix2::new(0.4, 0.1, 0.1, 0.3);
        for k in [Matrix2::zeros(), Matrix2::identity(), Matrix2::new(0.5, -1.0, 3.0, 0.25)] {
            let left = Matrix2::identity() - k * c;
            let formula = left * prior().p * left.transpose() + k * q * k.transpose();
            let found = linear::joseph(&prior().p, &k, &c, &q);
            assert!((found - formula).amax() < 1e-13 * formula.amax(), "{found} against {formula}");
            assert_eq!(found, found.transpose());
        }
    }

    /// A component read twenty digits more precisely than it was known keeps the variance of the reading, beside one
    /// that is not read: Σ̄ − KCΣ̄ would leave nothing or a rounding of either sign.
    #[test]
    fn a_precise_reading_leaves_its_own_variance() {
        let p = Matrix2::from_diagonal(&Vector2::new(0.7, 3.0));
        let (c, q) = (RowVector2::new(1.0, 0.0), Matrix1::new(1e-20));
        let gain = linear::gain(&p, &c, &q).expect("positive definite");
        assert!((gain.p[(0, 0)] / 1e-20 - 1.0).abs() < 1e-15, "{}", gain.p[(0, 0)]);
        assert_eq!((gain.p[(1, 1)], gain.p[(0, 1)]), (3.0, 0.0));
    }

    #[test]
    fn the_distance_of_an_innovation_comes_with_the_update() {
        let (z, c) = (Vector2::new(1.0, -0.5), Matrix2::new(1.0, 0.3, -0.2, 2.0));
        let q = Matrix2::new(0.4, 0.1, 0.1, 0.3);
        let update = Kf::from(prior()).update(&z, &c, &q).expect("positive definite");
        let d2 = crate::consistency::nis(&update.innovation, &update.s).expect("positive definite");
        assert!((update.d2.expect("regular") / d2 - 1.0).abs() < 1e-14);
        // An innovation whose square leaves the range of numbers moves the mean all the same.
        let far = Kf::from(prior()).update(&(z * 1e200), &c, &q).expect("a mean");
        assert_eq!(far.d2, None);
    }

    /// Two outputs δ = 1e-8 apart with Q = δ²I: in Joseph's form with a factored S the answer is wrong in its first
    /// digit, and still positive definite.
    #[test]
    fn nearly_parallel_outputs_keep_their_digits() {
        let delta: f64 = 1e-8;
        let c = Matrix2::new(1.0, 0.0, 1.0, delta);
        let delta = c[(1, 1)];
        let q = Matrix2::identity() * (delta * delta);
        let prior = Gaussian { x: Vector2::zeros(), p: Matrix2::identity() };
        let mut kf = Kf::from(prior);
        kf.update(&Vector2::zeros(), &c, &q).expect("square roots suffice");
        // Exactly: P⁻¹ = I + CᵀC/δ² = [1 + 2/δ², 1/δ; 1/δ, 2], whose determinant is 2 + 3/δ².
        let det = 2.0 + 3.0 / (delta * delta);
        let exact = [2.0 / det, -1.0 / (delta * det), (1.0 + 2.0 / (delta * delta)) / det];
        let p = kf.belief().p;
        for (found, exact) in [p[(0, 0)], p[(1, 0)], p[(1, 1)]].into_iter().zip(exact) {
            assert!((found / exact - 1.0).abs() < 1e-6, "{found} against {exact}");
        }
    }

    #[test]
    fn a_singular_innovation_is_refused_and_the_belief_kept() {
        let mut kf = Kf::from(prior());
        let c = Matrix2::new(1.0, 0.0, 1.0, 0.0);
        let error = kf.update(&Vector2::zeros(), &c, &Matrix2::zeros()).expect_err("singular");
        assert_eq!(error, Error::InnovationNotPositiveDefinite);
        let negative = kf.update(&Vector1::new(0.0), &RowVector2::new(1.0, 0.0), &Matrix1::new(-3.0));
        assert_eq!(negative.expect_err("S < 0"), Error::InnovationNotPositiveDefinite);
        assert_eq!(*kf.belief(), prior());
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused_and_the_belief_kept() {
        let mut kf = Kf::from(prior());
        let nan = Matrix2::new(1.0, f64::NAN, 0.0, 1.0);
        assert!(matches!(kf.predict::<U1>(&nan, &Matrix2::zeros(), None), Err(Error::NotFinite(_))));
        assert!(kf.predict::<U1>(&(1e200 * Matrix2::identity()), &Matrix2::zeros(), None).is_err());
        let c = RowVector2::new(0.0, 1.0);
        assert!(kf.update(&Vector1::new(f64::INFINITY), &c, &Matrix1::new(0.5)).is_err());
        assert_eq!(*kf.belief(), prior());
    }

    #[test]
    fn an_input_moves_the_mean_alone() {
        let mut kf = Kf::from(prior());
        let (b, u) = (Vector2::new(0.0, 0.5), Vector1::new(3.0));
        kf.predict(&Matrix2::identity(), &Matrix2::zeros(), Some((&b, &u))).expect("finite");
        assert_eq!(*kf.belief(), Gaussian { x: Vector2::new(4.0, 5.5), ..prior() });
    }

    #[test]
    fn the_product_does_not_depend_on_the_order() {
        let b = Gaussian { x: Vector2::new(-1.0, 2.0), p: Matrix2::new(0.6, -0.2, -0.2, 0.9) };
        let (ab, ba) = (prior().product(&b).expect("pd"), b.product(&prior()).expect("pd"));
        assert!((ab.x - ba.x).norm() < 1e-14 && (ab.p - ba.p).norm() < 1e-14);
        // Information adds: C₃⁻¹ = C₁⁻¹ + C₂⁻¹.
        let inverse = |m: Matrix2<f64>| m.try_inverse().expect("invertible");
        assert!((inverse(ab.p) - inverse(prior().p) - inverse(b.p)).norm() < 1e-13);
    }
}
