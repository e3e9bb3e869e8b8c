//! Jacobians by central differences.

use crate::manifold::State;
use core::convert::Infallible;
use nalgebra::{SMatrix, SVector};

/// The step of a Jacobian that a model does not say, in the coordinates of ⊞: the cube root of the machine's ε, where
/// the error of the formula and that of rounding are about equal for states and values of the order of 1. For much
/// larger ones, say the Jacobian.
pub const STEP: f64 = 6.055_454_452_393_343e-6;

/// ∂f/∂x by central differences of step `h` in the coordinates of ⊞, for a map between states or into a vector whose
/// difference is `minus`: what an analytic Jacobian is checked against.
pub fn central_differences<X: State<N>, Y, const N: usize, const M: usize>(
    f: impl Fn(&X) -> Y,
    minus: impl Fn(&Y, &Y) -> SVector<f64, M>,
    x: &X,
    h: f64,
) -> SMatrix<f64, M, N> {
    let certain = |x: &X| Ok::<Y, Infallible>(f(x));
    match try_central_differences(certain, minus, x, h) {
        Ok(jacobian) => jacobian,
        Err(never) => match never {},
    }
}

/// [`central_differences`] of a map that may have no value; its error comes through.
pub(crate) fn try_central_differences<X: State<N>, Y, E, const N: usize, const M: usize>(
    f: impl Fn(&X) -> Result<Y, E>,
    minus: impl Fn(&Y, &Y) -> SVector<f64, M>,
    x: &X,
    h: f64,
) -> Result<SMatrix<f64, M, N>, E> {
    let mut jacobian = SMatrix::<f64, M, N>::zeros();
    for i in 0..N {
        let mut delta = SVector::<f64, N>::zeros();
        delta[i] = h;
        let (ahead, behind) = (f(&x.boxplus(&delta))?, f(&x.boxplus(&-delta))?);
        jacobian.set_column(i, &(minus(&ahead, &behind) / (2.0 * h)));
    }
    Ok(jacobian)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Vector2};

    #[test]
    fn central_differences_find_a_linear_map() {
        let (a, x) = (Matrix2::new(1.0, 0.5, 0.0, 1.0), Vector2::new(3.0, -1.0));
        let found = central_differences(|x| a * x, |a, b| a - b, &x, 1e-5);
        assert!((found - a).amax() < 1e-10);
    }
}
