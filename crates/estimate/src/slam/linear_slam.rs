//! Linear SLAM (§8.4.1): an omnidirectional robot measures its displacement to each of ℓ landmarks it can tell apart.
//! The plain [`Kf`](filters::Kf) runs it unchanged.

use filters::Gaussian;
use nalgebra::{Const, SMatrix, SVector};

/// What a [`LinearSlam`] is not certain of: variances in each coordinate, m².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variances {
    /// Of a step of the robot.
    pub v: f64,
    /// Of a measured displacement.
    pub w: f64,
    /// Of the robot's first position.
    pub p0_robot: f64,
    /// Of a landmark's first position.
    pub p0_landmark: f64,
}

/// F = I, H and the covariances, for N = 2 + 2ℓ states and M = 2ℓ outputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearSlam<const N: usize, const M: usize> {
    /// The identity: landmarks stay, and so does a robot that is not driven.
    pub f: SMatrix<f64, N, N>, // Thrun A
    /// −I in the robot's columns and I in landmark i's, for each displacement x_ℓi − x_r.
    pub h: SMatrix<f64, M, N>, // Thrun C
    /// Noise in the robot's two coordinates alone.
    pub v: SMatrix<f64, N, N>, // Thrun R
    /// Noise of the displacements.
    pub w: SMatrix<f64, M, M>, // Thrun Q
    /// P₀, about the origin.
    pub belief: Gaussian<Const<N>>,
}

impl<const N: usize, const M: usize> LinearSlam<N, M> {
    /// The system with the given variances.
    pub fn new(c: &Variances) -> Self {
        const { assert!(N == M + 2 && M.is_multiple_of(2), "two coordinates of the robot and two of each landmark") };
        let h = SMatrix::from_fn(|i, j| if j == i + 2 { 1.0 } else { -f64::from(u8::from(j == i % 2)) });
        let diagonal = |robot: f64, landmark: f64| {
            SMatrix::from_diagonal(&SVector::<f64, N>::from_fn(|i, _| if i < 2 { robot } else { landmark }))
        };
        let belief = Gaussian { x: SVector::zeros(), p: diagonal(c.p0_robot, c.p0_landmark) };
        Self { f: SMatrix::identity(), h, v: diagonal(c.v, 0.0), w: SMatrix::identity() * c.w, belief }
    }
}

/// The trace of Cov(a − b) for the planar points whose coordinates begin at states `a` and `b` of a covariance.
pub fn relative_trace<const N: usize>(p: &SMatrix<f64, N, N>, a: usize, b: usize) -> f64 {
    (0..2).map(|i| p[(a + i, a + i)] + p[(b + i, b + i)] - 2.0 * p[(a + i, b + i)]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observability::analyze;
    use filters::Kf;
    use nalgebra::U1;

    const CONSTANTS: Variances = Variances { v: 0.01, w: 0.04, p0_robot: 0.01, p0_landmark: 4.0 };

    #[test]
    fn linear_slam_has_rank_two_too_few_and_the_missing_directions_shift_the_world() {
        let slam = LinearSlam::<6, 4>::new(&CONSTANTS);
        let q = crate::observability::observability_matrix(&slam.f, &slam.h);
        let seen = analyze(&q, 1e-9).expect("found");
        assert_eq!((seen.rank, seen.n), (4, 6));
        for c in &seen.nullspace {
            for i in 2..6 {
                assert!((c[i] - c[i % 2]).abs() < 1e-12, "robot and landmarks move together");
            }
        }
        let three = LinearSlam::<8, 6>::new(&CONSTANTS);
        let q = crate::observability::observability_matrix(&three.f, &three.h);
        assert_eq!(analyze(&q, 1e-9).expect("found").rank, 6);
    }

    #[test]
    fn a_relative_trace_is_that_of_a_difference() {
        let p = SMatrix::<f64, 6, 6>::from_fn(|i, j| ((i + 1) * (j + 1) + i * j * i * j) as f64);
        let difference =
            SMatrix::<f64, 2, 6>::from_fn(|i, j| f64::from(u8::from(j == 4 + i)) - f64::from(u8::from(j == 1 + i)));
        assert_eq!(relative_trace(&p, 4, 1), (difference * p * difference.transpose()).trace());
    }

    #[test]
    fn a_displacement_is_landmark_minus_robot() {
        let slam = LinearSlam::<6, 4>::new(&CONSTANTS);
        let x = SVector::<f64, 6>::from([1.0, 2.0, 4.0, 8.0, -1.0, 0.0]);
        assert_eq!((slam.h * x).as_slice(), [3.0, 6.0, -2.0, -2.0]);
    }

    #[test]
    fn relative_falls_absolute_stalls_and_the_shape_is_learnt() {
        let slam = LinearSlam::<6, 4>::new(&CONSTANTS);
        let mut kf = Kf::from(slam.belief);
        let mut relative = Vec::new();
        for _ in 0..200 {
            kf.predict::<U1>(&slam.f, &slam.v, None).expect("finite");
            kf.update(&SVector::zeros(), &slam.h, &slam.w).expect("positive definite");
            relative.push(relative_trace(&kf.belief().p, 2, 0));
        }
        assert!(relative.windows(2).all(|w| w[1] < w[0]));
        // No reading says where the world is: P₀ of the robot and one of landmark remain, 2 · 0.01 · 4 / 4.01 and more.
        let absolute = kf.belief().p[(2, 2)] + kf.belief().p[(3, 3)];
        assert!(absolute > 0.059);
        assert!(relative_trace(&kf.belief().p, 2, 4) < 0.001);
    }
}
