//! Planar poses SE(2), read as `world_from_robot`.

use crate::angle::{angle_diff, wrap};
use nalgebra::{SVector, Vector2};

/// A pose in the plane: position in metres and heading in radians, the heading kept in (−π, π].
///
/// A pose named `world_from_robot` maps robot coordinates to world coordinates.
///
/// # Example
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use geom::SE2;
/// // Facing north, a step of 3 m ahead leads north.
/// let world_from_robot = SE2::new(1.0, 2.0, FRAC_PI_2);
/// let moved = world_from_robot.compose(SE2::new(3.0, 0.0, 0.0));
/// assert!(moved.boxminus(SE2::new(1.0, 5.0, FRAC_PI_2)).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SE2 {
    x: f64,
    y: f64,
    theta: f64,
}

impl SE2 {
    /// The pose at (`x`, `y`) with heading `theta`, wrapped.
    #[inline]
    pub fn new(x: f64, y: f64, theta: f64) -> Self {
        Self { x, y, theta: wrap(theta) }
    }

    /// The pose with coordinates `[x, y, θ]`.
    pub fn from_vector(v: &SVector<f64, 3>) -> Self {
        Self::new(v[0], v[1], v[2])
    }

    /// `[x, y, θ]`.
    #[inline]
    pub fn to_vector(self) -> SVector<f64, 3> {
        SVector::<f64, 3>::new(self.x, self.y, self.theta)
    }

    /// East of the origin, metres.
    pub fn x(self) -> f64 {
        self.x
    }

    /// North of the origin, metres.
    pub fn y(self) -> f64 {
        self.y
    }

    /// Heading in (−π, π], counter-clockwise from the world's x axis.
    pub fn theta(self) -> f64 {
        self.theta
    }

    /// `a_from_b.compose(b_from_c)` is `a_from_c`.
    pub fn compose(self, other: Self) -> Self {
        let p = self.transform(Vector2::new(other.x, other.y));
        Self::new(p.x, p.y, self.theta + other.theta)
    }

    /// The pose that undoes this one: `world_from_robot.inverse()` is `robot_from_world`.
    pub fn inverse(self) -> Self {
        let (s, c) = libm::sincos(self.theta);
        Self::new(-(c * self.x + s * self.y), s * self.x - c * self.y, -self.theta)
    }

    /// The point `p`, given in this pose's frame, in the world's.
    pub fn transform(self, p: Vector2<f64>) -> Vector2<f64> {
        let (s, c) = libm::sincos(self.theta);
        Vector2::new(self.x + c * p.x - s * p.y, self.y + s * p.x + c * p.y)
    }

    /// x ⊞ δ with δ = `[δx, δy, δθ]` in **world** axes: positions add, the heading adds and wraps.
    ///
    /// These are the coordinates in which the chapter's filters carry their covariance.
    #[inline]
    pub fn boxplus(self, delta: &SVector<f64, 3>) -> Self {
        Self::new(self.x + delta[0], self.y + delta[1], self.theta + delta[2])
    }

    /// x ⊟ y, the δ with y ⊞ δ = x whose heading part is the short way round.
    pub fn boxminus(self, other: Self) -> SVector<f64, 3> {
        SVector::<f64, 3>::new(self.x - other.x, self.y - other.y, angle_diff(self.theta, other.theta))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_2, PI};

    fn close(a: SE2, b: SE2) -> bool {
        a.boxminus(b).norm() < 1e-14
    }

    #[test]
    fn compose_moves_in_the_frame_of_the_first_pose() {
        let world_from_a = SE2::new(1.0, 2.0, FRAC_PI_2);
        let a_from_b = SE2::new(3.0, -1.0, 0.25);
        assert!(close(world_from_a.compose(a_from_b), SE2::new(2.0, 5.0, FRAC_PI_2 + 0.25)));
    }

    #[test]
    fn inverse_undoes_from_both_sides() {
        let a = SE2::new(-0.7, 4.2, 2.5);
        let identity = SE2::new(0.0, 0.0, 0.0);
        assert!(close(a.compose(a.inverse()), identity));
        assert!(close(a.inverse().compose(a), identity));
    }

    #[test]
    fn transform_agrees_with_compose() {
        let a = SE2::new(0.3, -2.0, 1.1);
        let p = a.transform(Vector2::new(0.5, 0.75));
        let q = a.compose(SE2::new(0.5, 0.75, 0.0));
        assert_eq!((p.x, p.y), (q.x(), q.y()));
    }

    #[test]
    fn boxplus_wraps_the_heading_and_boxminus_inverts_it() {
        let a = SE2::new(1.0, 1.0, 3.0);
        let d = SVector::<f64, 3>::new(0.5, -0.25, 0.5);
        let b = a.boxplus(&d);
        assert!((b.theta() - (3.5 - 2.0 * PI)).abs() < 1e-15);
        assert!((b.boxminus(a) - d).norm() < 1e-15);
        assert_eq!(b.to_vector(), SVector::<f64, 3>::new(1.5, 0.75, b.theta()));
    }
}
