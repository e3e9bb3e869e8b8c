//! Observability of a nonlinear system: the frozen pair at one point, and the pairs stacked along the path driven.
//!
//! The frozen test says what the readings would tell if the geometry of this instant lasted; the stack says what they
//! did tell. Where the two disagree the stack is right: one range–bearing landmark reads 3 frozen and 2 along every
//! path, since turning the whole drive about it changes no reading.

use crate::error::Error;
use crate::observability::{Observability, analyze, observability_matrix};
use alloc::vec::Vec;
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DVector, DefaultAllocator, Dim, OMatrix};

/// The rank of the linearized pair (F, H) at one point: Theorem 8.2.2 as if F and H were constant.
///
/// # Errors
/// As [`analyze`].
pub fn frozen<N: Dim, M: Dim>(
    f: &OMatrix<f64, N, N>,
    h: &OMatrix<f64, M, N>,
    tolerance: f64,
) -> Result<Observability, Error>
where
    DefaultAllocator: Allocator<N, N> + Allocator<M, N>,
{
    analyze(&observability_matrix(f, h), tolerance)
}

/// The stack [H₀; H₁F₀; H₂F₁F₀; …] of a drive, about the state at its start: the *local observability matrix* of the
/// linearized time-varying system (Chen, Jiang and Hung 1990; Huang, Mourikis and Roumeliotis 2010).
#[derive(Clone, Debug)]
pub struct PathStack {
    rows: Vec<DVector<f64>>,
    /// Φ = F_{k−1} ⋯ F₀.
    transition: DMatrix<f64>,
    steps: usize,
}

/// What a drive has revealed.
#[derive(Clone, Debug, PartialEq)]
pub struct PathObservability {
    /// Rank, singular values, and the null directions **at the start** of the stack.
    pub start: Observability,
    /// The null directions carried along to the present state by Φ, each scaled to length 1.
    pub now: Vec<DVector<f64>>,
    /// Steps taken since the stack was begun.
    pub steps: usize,
}

impl PathStack {
    /// An empty stack for `n` states.
    pub fn new(n: usize) -> Self {
        Self { rows: Vec::new(), transition: DMatrix::identity(n, n), steps: 0 }
    }

    /// The readings at the present state, with their Jacobian H.
    pub fn observe<M: Dim, N: Dim>(&mut self, h: &OMatrix<f64, M, N>)
    where
        DefaultAllocator: Allocator<M, N>,
    {
        for i in 0..h.nrows() {
            let n = self.transition.ncols();
            let row = |j: usize| (0..h.ncols()).map(|k| h[(i, k)] * self.transition[(k, j)]).sum();
            self.rows.push(DVector::from_fn(n, |j, _| row(j)));
        }
    }

    /// A step of the motion, with its Jacobian F.
    pub fn advance<N: Dim>(&mut self, f: &OMatrix<f64, N, N>)
    where
        DefaultAllocator: Allocator<N, N>,
    {
        let n = self.transition.nrows();
        let f = DMatrix::from_fn(n, n, |i, j| f[(i, j)]);
        self.transition = f * &self.transition;
        self.steps += 1;
    }

    /// The rank of the stack under a relative tolerance.
    ///
    /// # Errors
    /// As [`analyze`].
    pub fn analyze(&self, tolerance: f64) -> Result<PathObservability, Error> {
        let n = self.transition.ncols();
        let q = DMatrix::from_fn(self.rows.len(), n, |i, j| self.rows[i][j]);
        let start = analyze(&q, tolerance)?;
        let now = start
            .nullspace
            .iter()
            .map(|c| {
                let carried = &self.transition * c;
                let norm = carried.norm();
                if norm > 0.0 { carried / norm } else { carried }
            })
            .collect();
        Ok(PathObservability { start, now, steps: self.steps })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Code;
    use crate::landmark::Landmark;
    use crate::landmarks::{RangeBearing, RangeOnly};
    use crate::odometry::Unicycle;
    use filters::{MeasurementModel, MotionModel};
    use geom::SE2;
    use nalgebra::{Matrix2, RowVector2, Vector2, Vector3};

    const ONE: [Landmark; 1] = [Landmark { id: 1, x: 6.0, y: 5.0 }];

    /// A random drive, and the rank along it.
    fn driven<const M: usize>(
        model: &impl MeasurementModel<SE2, 3, M>,
        landmarks: usize,
        seed: f64,
    ) -> PathObservability {
        let mut count = 100.0 * seed;
        let mut random = || {
            count += 1.0;
            libm::sin(count * count)
        };
        let mut pose = SE2::new(1.0, 1.0, random());
        let mut stack = PathStack::new(3);
        for _ in 0..20 {
            for j in 0..landmarks {
                stack.observe(&model.jacobian(&pose, j).expect("apart"));
            }
            let u = Vector2::new(0.1 + 0.05 * random(), 0.3 * random());
            stack.advance(&Unicycle.jacobian(&pose, &u));
            pose = Unicycle.f(&pose, &u);
        }
        stack.analyze(1e-9).expect("found")
    }

    #[test]
    fn a_motion_that_forgets_a_direction_leaves_none_to_carry() {
        let mut stack = PathStack::new(2);
        stack.observe(&RowVector2::new(1.0, 0.0));
        stack.advance(&Matrix2::new(1.0, 0.0, 0.0, 0.0));
        let seen = stack.analyze(1e-9).expect("finite");
        assert_eq!((seen.start.rank, seen.start.nullspace.len()), (1, 1));
        assert_eq!(seen.now, [DVector::zeros(2)]);
    }

    #[test]
    fn on_a_linear_system_frozen_and_driven_agree() {
        for h in [RowVector2::new(0.0, 1.0), RowVector2::new(1.0, 0.0)] {
            let f = Matrix2::new(1.0, 0.5, 0.0, 1.0);
            let mut stack = PathStack::new(2);
            for _ in 0..5 {
                stack.observe(&h);
                stack.advance(&f);
            }
            let driven = stack.analyze(1e-9).expect("found");
            assert_eq!(driven.start.rank, frozen(&f, &h, 1e-9).expect("found").rank);
            assert_eq!(driven.steps, 5);
        }
    }

    #[test]
    fn one_range_bearing_landmark_is_unobservable_on_every_path() {
        for seed in 0..20 {
            let found = driven(&RangeBearing { map: &ONE }, 1, f64::from(seed));
            assert_eq!(found.start.rank, 2, "seed {seed}: {:?}", found.start.singular_values);
            // The turn about the landmark: [−Δy, Δx, 1], at the start (1, 1).
            let turn = Vector3::new(4.0, -5.0, 1.0).normalize();
            let c = &found.start.nullspace[0];
            assert!((c[0] * turn[0] + c[1] * turn[1] + c[2] * turn[2]).abs() > 1.0 - 1e-9);
        }
    }

    #[test]
    fn one_range_only_landmark_hides_the_same_turn() {
        for seed in 0..20 {
            let found = driven(&RangeOnly { map: &ONE }, 1, f64::from(seed));
            assert_eq!(found.start.rank, 2, "seed {seed}");
        }
    }

    #[test]
    fn two_landmarks_reveal_everything() {
        let two = [ONE[0], Landmark { id: 2, x: 0.0, y: 6.0 }];
        assert_eq!(driven(&RangeOnly { map: &two }, 2, 3.0).start.rank, 3);
        assert_eq!(driven(&RangeBearing { map: &two }, 2, 3.0).start.rank, 3);
    }

    #[test]
    fn the_turn_is_carried_to_the_present_pose() {
        let (model, mut pose, mut stack) = (RangeBearing { map: &ONE }, SE2::new(1.0, 1.0, 0.3), PathStack::new(3));
        for k in 0..15 {
            stack.observe(&model.jacobian(&pose, 0).expect("apart"));
            let u = Vector2::new(0.2, 0.1 * f64::from(k % 3));
            stack.advance(&Unicycle.jacobian(&pose, &u));
            pose = Unicycle.f(&pose, &u);
        }
        let turn = Vector3::new(-(pose.y() - ONE[0].y), pose.x() - ONE[0].x, 1.0).normalize();
        let now = &stack.analyze(1e-9).expect("found").now[0];
        assert!((now[0] * turn[0] + now[1] * turn[1] + now[2] * turn[2]).abs() > 1.0 - 1e-9);
    }

    #[test]
    fn an_empty_stack_and_a_stack_that_is_not_finite_have_answers() {
        let nothing = PathStack::new(3).analyze(1e-9).expect("found");
        assert_eq!((nothing.start.rank, nothing.now.len()), (0, 3));
        let mut stack = PathStack::new(2);
        for _ in 0..4 {
            stack.observe(&RowVector2::new(f64::NAN, 1.0));
        }
        assert_eq!(stack.analyze(1e-9).expect_err("NaN").code, Code::NotFinite);
    }
}
