//! Jacobians by central differences.

use crate::manifold::State;
use nalgebra::{SMatrix, SVector};

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
    use nalgebra::{Matrix2, Vector2};

    #[test]
    fn central_differences_find_a_linear_map() {
        let (a, x) = (Matrix2::new(1.0, 0.5, 0.0, 1.0), Vector2::new(3.0, -1.0));
        let found = central_differences(|x| a * x, |a, b| a - b, &x, 1e-5);
        assert!((found - a).amax() < 1e-10);
    }
}
