//! The Luenberger observer with a fixed gain (App. J.4, discretized as in J.5).

use crate::error::Error;
use crate::lti::{Lti, SystemSizes};
use alloc::vec::Vec;
use filters::{Sizes, linear};
use nalgebra::{Complex, DMatrix, DefaultAllocator, Dim, OMatrix, OVector};

/// (I − KH)F, n×n: what a step does to the estimation error when no noise acts, e(k+1) = (I − KH)F e(k).
pub fn error_matrix<N: Dim, M: Dim>(
    f: &OMatrix<f64, N, N>,
    h: &OMatrix<f64, M, N>,
    k: &OMatrix<f64, N, M>,
) -> OMatrix<f64, N, N>
where
    DefaultAllocator: Sizes<N, M>,
{
    linear::complement(k, h) * f
}

// ANCHOR: observer
/// An observer: a copy of the system, corrected in proportion to the innovation.
///
/// # Example
/// ```
/// use estimate::{Observer, rail::dead_reckoning};
/// use nalgebra::Vector1;
/// let (sys, belief) = dead_reckoning();
/// let mut observer = Observer { sys, k: [0.4, 0.8].into(), xhat: belief.x };
/// observer.step(&Vector1::new(0.0), &Vector1::new(2.7));
/// assert!((observer.xhat[1] - (4.0 - 0.8 * 1.3)).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Observer<N: Dim, U: Dim, M: Dim>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    /// The model that the observer copies.
    pub sys: Lti<N, U, M>,
    /// K, n×p: the gain.
    pub k: OMatrix<f64, N, M>,
    /// x̂(k | k), the estimate.
    pub xhat: OVector<f64, N>,
}

impl<N: Dim, U: Dim, M: Dim> Observer<N, U, M>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    /// One period: predict with the input `u`, correct with the output `y` of its end: x̂⁺ = x̂⁻ + K(y − H x̂⁻) with
    /// x̂⁻ = F x̂ + G u.
    pub fn step(&mut self, u: &OVector<f64, U>, y: &OVector<f64, M>) {
        let Lti { f, g, h, .. } = &self.sys;
        let predicted = f * &self.xhat + g * u;
        let innovation = y - h * &predicted;
        self.xhat = predicted + &self.k * innovation;
    }

    /// (I − KH)F. The error decays when every eigenvalue lies inside the unit disc (Theorem J.5.1).
    pub fn error_matrix(&self) -> OMatrix<f64, N, N> {
        error_matrix(&self.sys.f, &self.sys.h, &self.k)
    }

    /// The eigenvalues of (I − KH)F, by decreasing modulus.
    ///
    /// # Errors
    /// As [`numerics::eigenvalues`], blaming K.
    pub fn error_eigs(&self) -> Result<Vec<Complex<f64>>, Error> {
        let (m, n) = (self.error_matrix(), self.xhat.len());
        let m = DMatrix::from_iterator(n, n, m.iter().copied());
        let found = if n <= 2 { numerics::eigenvalues_in_closed_form(&m) } else { numerics::eigenvalues(&m) };
        found.map_err(|e| Error::of_matrix(e, "K"))
    }

    /// The error covariance after a correction with this K, from the predicted `p` = P(k+1 | k), in Joseph's form:
    /// right for any gain, least at the Kalman gain.
    pub fn covariance_update(&self, p: &OMatrix<f64, N, N>) -> OMatrix<f64, N, N> {
        linear::joseph(p, &self.k, &self.sys.h, &self.sys.w)
    }
}
// ANCHOR_END: observer

impl<N: Dim, U: Dim, M: Dim> Copy for Observer<N, U, M>
where
    DefaultAllocator: SystemSizes<N, U, M>,
    Lti<N, U, M>: Copy,
    OMatrix<f64, N, M>: Copy,
    OVector<f64, N>: Copy,
{
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rail::dead_reckoning;
    use nalgebra::{Matrix2, RowVector2, U1, U2, Vector1, Vector2};

    fn observer(k: [f64; 2]) -> Observer<U2, U1, U1> {
        let (sys, belief) = dead_reckoning();
        Observer { sys, k: k.into(), xhat: belief.x }
    }

    #[test]
    fn an_observer_without_gain_is_dead_reckoning() {
        let mut o = observer([0.0, 0.0]);
        o.step(&Vector1::new(2.0), &Vector1::new(99.0));
        assert_eq!(o.xhat, Vector2::new(4.0, 5.0));
        assert_eq!(o.error_matrix(), o.sys.f);
    }

    #[test]
    fn the_error_obeys_the_error_matrix() {
        let mut o = observer([0.3, 0.6]);
        let truth = Vector2::new(1.0, -1.0);
        let next = o.sys.f * truth;
        let before = truth - o.xhat;
        o.step(&Vector1::new(0.0), &(o.sys.h * next));
        assert!((next - o.xhat - o.error_matrix() * before).norm() < 1e-15);
    }

    #[test]
    fn a_velocity_sensor_leaves_one_eigenvalue_pinned_at_exactly_one() {
        for gain in [[0.0, 0.0], [0.5, 0.36], [-3.0, 1.7]] {
            let eigs = observer(gain).error_eigs().expect("found");
            assert!(eigs.contains(&Complex::new(1.0, 0.0)), "{eigs:?}");
        }
    }

    #[test]
    fn a_position_sensor_moves_both_eigenvalues() {
        let mut o = observer([0.9, 0.8]);
        o.sys.h = RowVector2::new(1.0, 0.0);
        let eigs = o.error_eigs().expect("found");
        assert!((eigs[0].re - 0.5).abs() < 1e-15 && (eigs[1].re - 0.2).abs() < 1e-15);
    }

    #[test]
    fn three_states_have_three_eigenvalues() {
        let f = nalgebra::Matrix3::new(0.9, 1.0, 0.0, 0.0, 0.5, 2.0, 0.0, 0.0, -0.7);
        let (h, v) = (nalgebra::RowVector3::new(1.0, 0.0, 0.0), nalgebra::Matrix3::identity());
        let sys = Lti { f, g: nalgebra::Vector3::zeros(), h, v, w: nalgebra::Matrix1::new(1.0) };
        let observer = Observer { sys, k: nalgebra::Vector3::zeros(), xhat: nalgebra::Vector3::zeros() };
        let eigs = observer.error_eigs().expect("found");
        assert_eq!(eigs.len(), 3);
        for (found, exact) in eigs.iter().zip([0.9, -0.7, 0.5]) {
            assert!((found.re - exact).abs() < 1e-14 && found.im == 0.0, "{eigs:?}");
        }
    }

    #[test]
    fn the_covariance_of_any_gain_is_the_error_s_second_moment() {
        let o = observer([0.7, -0.2]);
        let p = Matrix2::new(1.7, 1.05, 1.05, 2.1);
        let left = Matrix2::identity() - o.k * o.sys.h;
        let exact = left * p * left.transpose() + o.k * o.sys.w * o.k.transpose();
        assert!((o.covariance_update(&p) - exact).norm() < 1e-15);
    }
}
