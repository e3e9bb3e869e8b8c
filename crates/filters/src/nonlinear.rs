//! The extended Kalman filter (sister volume, chapter 7), in Thrun's letters.
//!
//! States live on a manifold: a belief is a point and a covariance in the tangent coordinates of ⊞ there. For a planar
//! pose these are world axes and the heading, so the covariance is that of `[x, y, θ]`.

use crate::error::Error;
use crate::kalman::Update;
use crate::linear::{self, finite};
use geom::SE2;
use nalgebra::{SMatrix, SVector};

/// A state with N degrees of freedom.
pub trait State<const N: usize>: Copy {
    /// x ⊞ δ.
    #[must_use]
    fn boxplus(&self, delta: &SVector<f64, N>) -> Self;

    /// x ⊟ y, the δ with y ⊞ δ = x.
    fn boxminus(&self, other: &Self) -> SVector<f64, N>;

    /// Whether no coordinate is a NaN or an infinity.
    fn is_finite(&self) -> bool;
}

impl<const N: usize> State<N> for SVector<f64, N> {
    #[inline]
    fn boxplus(&self, delta: &SVector<f64, N>) -> Self {
        self + delta
    }

    fn boxminus(&self, other: &Self) -> SVector<f64, N> {
        self - other
    }

    #[inline]
    fn is_finite(&self) -> bool {
        linear::is_finite(self)
    }
}

impl State<3> for SE2 {
    #[inline]
    fn boxplus(&self, delta: &SVector<f64, 3>) -> Self {
        SE2::boxplus(*self, delta)
    }

    fn boxminus(&self, other: &Self) -> SVector<f64, 3> {
        SE2::boxminus(*self, *other)
    }

    #[inline]
    fn is_finite(&self) -> bool {
        linear::is_finite(&self.to_vector())
    }
}

/// How the state moves: x⁺ = f(x, u).
pub trait MotionModel<X: State<N>, const N: usize, const U: usize> {
    /// f(x, u).
    fn f(&self, x: &X, u: &SVector<f64, U>) -> X;

    /// A = ∂f/∂x at (x, u), n×n, in the coordinates of ⊞.
    fn jacobian(&self, x: &X, u: &SVector<f64, U>) -> SMatrix<f64, N, N>;

    /// Both, for a model whose two share their work.
    fn linearized(&self, x: &X, u: &SVector<f64, U>) -> (X, SMatrix<f64, N, N>) {
        (self.f(x, u), self.jacobian(x, u))
    }

    /// A Σ Aᵀ + R for an A that [`MotionModel::jacobian`] answered: a model that knows which of its entries are ones and zeros
    /// may leave their products out.
    #[inline]
    fn transported(
        &self,
        a: &SMatrix<f64, N, N>,
        p: &SMatrix<f64, N, N>,
        r: &SMatrix<f64, N, N>,
    ) -> SMatrix<f64, N, N> {
        linear::congruence(a, p, r)
    }
}

/// What a sensor reads of feature `j`: z = h(x, j) + noise.
pub trait MeasurementModel<X: State<N>, const N: usize, const M: usize> {
    /// h(x, j).
    ///
    /// # Errors
    /// [`Error::AtFeature`] where h does not exist, [`Error::OutOfRange`] when there is no feature `j`.
    fn h(&self, x: &X, j: usize) -> Result<SVector<f64, M>, Error>;

    /// C = ∂h/∂x at x, m×n, in the coordinates of ⊞.
    ///
    /// # Errors
    /// As [`MeasurementModel::h`].
    fn jacobian(&self, x: &X, j: usize) -> Result<SMatrix<f64, M, N>, Error>;

    /// Both, for a sensor whose two share their work.
    ///
    /// # Errors
    /// As [`MeasurementModel::h`].
    fn linearized(&self, x: &X, j: usize) -> Result<(SVector<f64, M>, SMatrix<f64, M, N>), Error> {
        Ok((self.h(x, j)?, self.jacobian(x, j)?))
    }

    /// z − ẑ, wrapped where a component is an angle.
    fn residual(&self, z: &SVector<f64, M>, expected: &SVector<f64, M>) -> SVector<f64, M> {
        z - expected
    }
}

/// An extended Kalman filter holding its belief.
///
/// # Example
/// ```
/// use filters::nonlinear::{Ekf, MotionModel};
/// use nalgebra::{SMatrix, SVector, Vector1, Matrix1};
/// struct Doubling;
/// impl MotionModel<Vector1<f64>, 1, 1> for Doubling {
///     fn f(&self, x: &Vector1<f64>, u: &SVector<f64, 1>) -> Vector1<f64> { 2.0 * x + u }
///     fn jacobian(&self, _: &Vector1<f64>, _: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> { Matrix1::new(2.0) }
/// }
/// let mut ekf = Ekf { x: Vector1::new(1.0), p: Matrix1::new(1.0) };
/// ekf.predict(&Doubling, &Vector1::new(0.5), &Matrix1::new(0.25))?;
/// assert_eq!((ekf.x[0], ekf.p[0]), (2.5, 4.25));
/// # Ok::<(), filters::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ekf<X, const N: usize> {
    /// The mean μ.
    pub x: X,
    /// The covariance Σ, n×n, of the error in the coordinates of ⊞ at the mean.
    pub p: SMatrix<f64, N, N>,
}

impl<X: State<N>, const N: usize> Ekf<X, N> {
    /// μ̄ = f(μ, u), Σ̄ = A Σ Aᵀ + R, with A at the old mean.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; the belief is then unchanged.
    pub fn predict<const U: usize>(
        &mut self,
        model: &impl MotionModel<X, N, U>,
        u: &SVector<f64, U>,
        r: &SMatrix<f64, N, N>,
    ) -> Result<(), Error> {
        let (x, a) = model.linearized(&self.x, u);
        if !x.is_finite() {
            return Err(Error::NotFinite { what: "the predicted mean" });
        }
        let mut p = model.transported(&a, &self.p, r);
        linear::mend(&mut p)?;
        *self = Self { x, p };
        Ok(())
    }

    /// Corrects the belief with the reading `z` of feature `j`, of noise covariance Q; the covariance in Joseph's form.
    ///
    /// # Errors
    /// [`Error::InnovationNotPositiveDefinite`], [`Error::NotFinite`], or what the model answers; the belief is then
    /// unchanged.
    pub fn update<const M: usize>(
        &mut self,
        model: &impl MeasurementModel<X, N, M>,
        z: &SVector<f64, M>,
        j: usize,
        q: &SMatrix<f64, M, M>,
    ) -> Result<Update<N, M>, Error> {
        let (expected, c) = model.linearized(&self.x, j)?;
        let innovation = finite(model.residual(z, &expected), "the innovation")?;
        self.correct(&innovation, &c, q)
    }

    /// Corrects the belief by an innovation and its Jacobian, both already at hand.
    ///
    /// # Errors
    /// As [`Ekf::update`].
    pub fn correct<const M: usize>(
        &mut self,
        innovation: &SVector<f64, M>,
        c: &SMatrix<f64, M, N>,
        q: &SMatrix<f64, M, M>,
    ) -> Result<Update<N, M>, Error> {
        let gain = linear::gain(&self.p, c, q)?;
        let x = self.x.boxplus(&(gain.k * innovation));
        if !x.is_finite() {
            return Err(Error::NotFinite { what: "the mean" });
        }
        *self = Self { x, p: gain.p };
        Ok(Update { innovation: *innovation, s: gain.s, k: gain.k, d2: gain.d2(innovation) })
    }
}

/// ∂f/∂x by central differences of step `h` in the coordinates of ⊞, for a map between states or into a vector whose
/// difference is `minus`: what an analytic Jacobian is checked against.
pub fn central_differences<X: State<N>, Y, const N: usize, const M: usize>(
    f: impl Fn(&X) -> Y,
    minus: impl Fn(&Y, &Y) -> SVector<f64, M>,
    x: &X,
    h: f64,
) -> SMatrix<f64, M, N> {
    let mut jacobian = SMatrix::<f64, M, N>::zeros();
    for i in 0..N {
        let mut delta = SVector::<f64, N>::zeros();
        delta[i] = h;
        let (ahead, behind) = (f(&x.boxplus(&delta)), f(&x.boxplus(&-delta)));
        jacobian.set_column(i, &(minus(&ahead, &behind) / (2.0 * h)));
    }
    jacobian
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kalman::{Gaussian, Kf};
    use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};

    struct Rail;

    impl MotionModel<Vector2<f64>, 2, 1> for Rail {
        fn f(&self, x: &Vector2<f64>, u: &SVector<f64, 1>) -> Vector2<f64> {
            Vector2::new(x[0] + 0.5 * x[1], x[1] + 0.5 * u[0])
        }

        fn jacobian(&self, _: &Vector2<f64>, _: &SVector<f64, 1>) -> Matrix2<f64> {
            Matrix2::new(1.0, 0.5, 0.0, 1.0)
        }
    }

    impl MeasurementModel<Vector2<f64>, 2, 1> for Rail {
        fn h(&self, x: &Vector2<f64>, _: usize) -> Result<SVector<f64, 1>, Error> {
            Ok(Vector1::new(x[1]))
        }

        fn jacobian(&self, _: &Vector2<f64>, _: usize) -> Result<SMatrix<f64, 1, 2>, Error> {
            Ok(RowVector2::new(0.0, 1.0))
        }
    }

    #[test]
    fn on_a_linear_system_it_is_the_linear_filter() {
        let belief = Gaussian { x: Vector2::new(2.0, 4.0), p: Matrix2::new(1.0, 0.0, 0.0, 2.0) };
        let (r, q) = (Matrix2::new(0.2, 0.05, 0.05, 0.1), Matrix1::new(0.5));
        let mut ekf = Ekf { x: belief.x, p: belief.p };
        let mut kf = Kf::from(belief);
        for z in [2.7, 2.0, 2.3] {
            let (u, z) = (Vector1::new(0.3), Vector1::new(z));
            ekf.predict(&Rail, &u, &r).expect("finite");
            kf.predict(&Matrix2::new(1.0, 0.5, 0.0, 1.0), &r, Some((&Vector2::new(0.0, 0.5), &u))).expect("finite");
            ekf.update(&Rail, &z, 0, &q).expect("positive definite");
            kf.update(&z, &RowVector2::new(0.0, 1.0), &q).expect("positive definite");
            assert_eq!((ekf.x, ekf.p), (kf.belief().x, kf.belief().p));
        }
    }

    #[test]
    fn a_refused_step_leaves_the_belief() {
        let before = Ekf { x: Vector2::new(2.0, 4.0), p: Matrix2::identity() };
        let mut ekf = before;
        assert!(ekf.predict(&Rail, &Vector1::new(f64::NAN), &Matrix2::zeros()).is_err());
        assert!(ekf.predict(&Rail, &Vector1::new(0.0), &Matrix2::from_element(f64::INFINITY)).is_err());
        assert!(ekf.update(&Rail, &Vector1::new(f64::NAN), 0, &Matrix1::new(1.0)).is_err());
        assert!(ekf.update(&Rail, &Vector1::new(0.0), 0, &Matrix1::new(-1.0)).is_err());
        assert_eq!(ekf, before);
    }

    #[test]
    fn a_pose_is_finite_when_its_numbers_are() {
        assert!(State::is_finite(&SE2::new(1.0, -2.0, 0.5)));
        for at in 0..3 {
            let of = |i: usize| if i == at { f64::INFINITY } else { 1.0 };
            assert!(!State::is_finite(&SE2::from_vector(&nalgebra::Vector3::new(of(0), of(1), of(2)))), "{at}");
        }
    }

    #[test]
    fn central_differences_find_a_linear_map() {
        let x = Vector2::new(3.0, -1.0);
        let found = central_differences(|x| Rail.f(x, &Vector1::new(1.0)), |a, b| a - b, &x, 1e-5);
        assert!((found - Matrix2::new(1.0, 0.5, 0.0, 1.0)).amax() < 1e-10);
    }
}
