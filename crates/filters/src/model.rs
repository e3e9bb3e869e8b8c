//! How a state moves and what a sensor reads of it, for the nonlinear filters (sister volume, chapter 7).
//!
//! A function is a model: `|x: &X, u: &U| …` moves a state, `|x: &X| …` reads it. A model of one's own type can say
//! more: its Jacobian, which is else found by differences; which differences are angles; which feature was seen.

use crate::differences::{STEP, central_differences, try_central_differences};
use crate::error::Error;
use crate::linear;
use crate::manifold::State;
use nalgebra::{SMatrix, SVector};

/// How the state moves: x⁺ = f(x, u).
pub trait MotionModel<X: State<N>, const N: usize, const U: usize> {
    /// f(x, u).
    fn f(&self, x: &X, u: &SVector<f64, U>) -> X;

    /// A = ∂f/∂x at (x, u), n×n, in the coordinates of ⊞; by differences ([`STEP`]) where a model says no other. Only
    /// the extended filter asks for it.
    fn jacobian(&self, x: &X, u: &SVector<f64, U>) -> SMatrix<f64, N, N> {
        central_differences(|x| self.f(x, u), X::boxminus, x, STEP)
    }

    /// Both, for a model whose two share their work.
    fn linearized(&self, x: &X, u: &SVector<f64, U>) -> (X, SMatrix<f64, N, N>) {
        (self.f(x, u), self.jacobian(x, u))
    }

    /// A Σ Aᵀ + R for an A that [`MotionModel::jacobian`] answered: a model that knows which of its entries are ones
    /// and zeros may leave their products out.
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

impl<F, X: State<N>, const N: usize, const U: usize> MotionModel<X, N, U> for F
where
    F: Fn(&X, &SVector<f64, U>) -> X,
{
    fn f(&self, x: &X, u: &SVector<f64, U>) -> X {
        self(x, u)
    }
}

/// What a sensor reads of feature `j`: z = h(x, j) + noise. A sensor that sees no features has J = ().
pub trait MeasurementModel<X: State<N>, const N: usize, const M: usize, J: Copy = usize> {
    /// h(x, j).
    ///
    /// # Errors
    /// [`Error::AtFeature`] where h does not exist, [`Error::OutOfRange`] when there is no feature `j`.
    fn h(&self, x: &X, j: J) -> Result<SVector<f64, M>, Error>;

    /// C = ∂h/∂x at x, m×n, in the coordinates of ⊞; by differences ([`STEP`]) where a model says no other. Only the
    /// extended filter asks for it.
    ///
    /// # Errors
    /// As [`MeasurementModel::h`].
    fn jacobian(&self, x: &X, j: J) -> Result<SMatrix<f64, M, N>, Error> {
        try_central_differences(|x| self.h(x, j), |a, b| self.residual(a, b), x, STEP)
    }

    /// Both, for a sensor whose two share their work.
    ///
    /// # Errors
    /// As [`MeasurementModel::h`].
    fn linearized(&self, x: &X, j: J) -> Result<(SVector<f64, M>, SMatrix<f64, M, N>), Error> {
        Ok((self.h(x, j)?, self.jacobian(x, j)?))
    }

    /// z − ẑ, wrapped where a component is an angle.
    fn residual(&self, z: &SVector<f64, M>, expected: &SVector<f64, M>) -> SVector<f64, M> {
        z - expected
    }
}

impl<F, X: State<N>, const N: usize, const M: usize> MeasurementModel<X, N, M, ()> for F
where
    F: Fn(&X) -> SVector<f64, M>,
{
    fn h(&self, x: &X, (): ()) -> Result<SVector<f64, M>, Error> {
        Ok(self(x))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Ekf;
    use crate::error::{Parameter, Quantity};
    use nalgebra::{Matrix1, Matrix1x2, Matrix2, Vector1, Vector2};

    /// The direction in which a point is seen, an angle.
    struct Direction;

    impl MeasurementModel<Vector2<f64>, 2, 1, ()> for Direction {
        fn h(&self, x: &Vector2<f64>, (): ()) -> Result<Vector1<f64>, Error> {
            if *x == Vector2::zeros() { Err(Error::OutOfRange(Parameter::Feature)) } else { Ok(Vector1::new(angle(x))) }
        }

        fn residual(&self, z: &Vector1<f64>, expected: &Vector1<f64>) -> Vector1<f64> {
            Vector1::new(geom::angle_diff(z[0], expected[0]))
        }
    }

    fn angle(x: &Vector2<f64>) -> f64 {
        libm::atan2(x[1], x[0])
    }

    /// ∂φ/∂x = [−y, x] / ρ², to the error of central differences, 10⁻¹⁰, also across ±π.
    #[test]
    fn a_jacobian_left_out_is_that_of_differences_and_angles_go_the_short_way_round() {
        for x in [Vector2::new(3.0, 4.0), Vector2::new(-2.0, 0.0), Vector2::new(-1.0, -1e-9)] {
            let exact = Matrix1x2::new(-x[1], x[0]) / x.norm_squared();
            let found = Direction.jacobian(&x, ()).expect("apart");
            assert!((found - exact).amax() < 1e-9, "{found} {exact}");
        }
    }

    #[test]
    fn what_has_no_value_beside_the_state_is_an_error_and_changes_nothing() {
        let before = Ekf { x: Vector2::new(0.0, 0.0), p: Matrix2::identity() };
        let mut ekf = before;
        assert!(ekf.update(&Direction, &Vector1::new(0.1), (), &Matrix1::new(0.1)).is_err());
        let nowhere = |x: &Vector2<f64>| Vector1::new(if x[0] == 0.0 { 0.0 } else { f64::NAN });
        let refused = ekf.update(&nowhere, &Vector1::new(0.1), (), &Matrix1::new(0.1));
        assert!(matches!(refused, Err(Error::NotFinite(_))), "{refused:?}");
        let lost = |x: &Vector2<f64>, _: &Vector1<f64>| if x[0] == 0.0 { *x } else { x * f64::NAN };
        let refused = ekf.predict(&lost, &Vector1::new(0.0), &Matrix2::identity());
        assert_eq!(refused, Err(Error::NotFinite(Quantity::PredictedCovariance)));
        assert_eq!(ekf, before);
    }
}
