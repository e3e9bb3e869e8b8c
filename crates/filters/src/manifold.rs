//! States on a manifold: a belief is a point, and a covariance in the tangent coordinates of ⊞ there.
//!
//! For a planar pose these are world axes and the heading, so the covariance is that of `[x, y, θ]`.

use crate::covariance;
use geom::SE2;
use nalgebra::SVector;

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
        covariance::is_finite(self)
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
        covariance::is_finite(&self.to_vector())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pose_is_finite_when_its_numbers_are() {
        assert!(State::is_finite(&SE2::new(1.0, -2.0, 0.5)));
        for at in 0..3 {
            let of = |i: usize| if i == at { f64::INFINITY } else { 1.0 };
            assert!(!State::is_finite(&SE2::from_vector(&nalgebra::Vector3::new(of(0), of(1), of(2)))), "{at}");
        }
    }
}
