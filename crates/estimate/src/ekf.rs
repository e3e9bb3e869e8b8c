//! EKF localization among known landmarks (§8.3), in Choset's letters.

use crate::error::Error;
use crate::odometry::Unicycle;
use filters::covariance::finite;
use filters::linear::{self, Gain};
use filters::{Ekf, Gaussian, MeasurementModel, MotionModel, Quantity, State, Update};
use geom::SE2;
use nalgebra::{Const, DMatrix, DVector, Matrix3, SMatrix, SVector, U3, Vector2};

/// A reading `y` of landmark `j`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sighting<const M: usize> {
    /// Which landmark.
    pub j: usize,
    /// What was read of it.
    pub y: SVector<f64, M>,
}

/// A unicycle's belief about its pose, changed by odometry and readings. The state may hold more than the pose [x, y,
/// θ], as [`PoseAndScale`](crate::drive::PoseAndScale) does.
///
/// # Example
/// ```
/// use estimate::kf::Gaussian;
/// use estimate::landmarks::RangeBearing;
/// use estimate::{Localizer, Landmark, Sighting};
/// use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
/// let mut ekf = Localizer::new(&Gaussian { x: Vector3::zeros(), p: Matrix3::identity() * 0.01 });
/// ekf.predict(&Vector2::new(1.0, 0.0), &(Matrix3::identity() * 0.001))?; // Δs = 1 m
/// let map = [Landmark { id: 1, x: 3.0, y: 0.0 }];
/// let y = Vector2::new(1.9, core::f64::consts::PI); // seen from the landmark, the robot is in direction π
/// let update = ekf.update(&RangeBearing { map: &map }, &Sighting { j: 0, y }, &(Matrix2::identity() * 0.01))?;
/// assert!((update.innovation[0] + 0.1).abs() < 1e-12);
/// assert!(ekf.pose().x() > 1.0, "nearer to the landmark than predicted");
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Localizer<X = SE2, const N: usize = 3> {
    /// The filter, which holds the belief.
    pub filter: Ekf<X, N>,
}

impl Localizer {
    /// A filter with this belief; the heading is wrapped.
    pub fn new(belief: &Gaussian<U3>) -> Self {
        Self { filter: Ekf { x: SE2::from_vector(&belief.x), p: belief.p } }
    }

    /// The estimated pose.
    pub fn pose(&self) -> SE2 {
        self.filter.x
    }

    /// P, 3×3.
    pub fn covariance(&self) -> &Matrix3<f64> {
        &self.filter.p
    }

    /// The present belief, [x, y, θ] with θ in (−π, π].
    pub fn belief(&self) -> Gaussian<U3> {
        Gaussian { x: self.filter.x.to_vector(), p: self.filter.p }
    }
}

impl<X: State<N>, const N: usize> Localizer<X, N> {
    /// Eqs. 8.37–8.39: x̂ moves by u = [Δs, Δθ], P becomes FPFᵀ + V with F at the old heading; V is in the state, n×n.
    ///
    /// # Errors
    /// [`crate::Code::NotFinite`]; the belief is then as it was.
    #[inline]
    pub fn predict(&mut self, u: &Vector2<f64>, v: &SMatrix<f64, N, N>) -> Result<(), Error>
    where
        Unicycle: MotionModel<X, N, 2>,
    {
        Ok(self.filter.predict(&Unicycle, u, v)?)
    }

    // ANCHOR: update
    /// Corrects the belief with one sighting (eqs. 8.40–8.45): H and the innovation at the prediction, P in Joseph's
    /// form, the heading through ⊞.
    ///
    /// # Errors
    /// [`crate::Code::AtLandmark`], [`crate::Code::InnovationNotPositiveDefinite`] or [`crate::Code::NotFinite`]; the
    /// belief is then as it was.
    #[inline]
    pub fn update<const M: usize>(
        &mut self,
        model: &impl MeasurementModel<X, N, M>,
        sighting: &Sighting<M>,
        w: &SMatrix<f64, M, M>,
    ) -> Result<Update<Const<N>, Const<M>>, Error> {
        Ok(self.filter.update(model, &sighting.y, sighting.j, w)?)
    }
    // ANCHOR_END: update

    // ANCHOR: stacked
    /// Corrects the belief with all sightings of one step, stacked: every H and every innovation at the same
    /// prediction, W block-diagonal. The answer is (ν, S) of the stack.
    ///
    /// # Errors
    /// As [`Localizer::update`].
    pub fn update_stacked<const M: usize>(
        &mut self,
        model: &impl MeasurementModel<X, N, M>,
        sightings: &[Sighting<M>],
        w: &SMatrix<f64, M, M>,
    ) -> Result<(DVector<f64>, DMatrix<f64>), Error> {
        let (rows, Ekf { x, p }) = (M * sightings.len(), &self.filter);
        let (mut h, p) = (DMatrix::zeros(rows, N), DMatrix::from_column_slice(N, N, p.as_slice()));
        let (mut nu, mut w_all) = (DVector::zeros(rows), DMatrix::zeros(rows, rows));
        for (i, sighting) in sightings.iter().enumerate() {
            let (expected, jacobian) = model.linearized(x, sighting.j)?;
            h.view_mut((M * i, 0), (M, N)).copy_from(&jacobian);
            nu.fixed_rows_mut::<M>(M * i).copy_from(&model.residual(&sighting.y, &expected));
            w_all.fixed_view_mut::<M, M>(M * i, M * i).copy_from(w);
        }
        let nu = finite(nu, Quantity::Innovation)?;
        let Gain { k, s, p, .. } = linear::gain(&p, &h, &w_all)?;
        let step = k * &nu;
        let x = x.boxplus(&finite(SVector::from_fn(|i, _| step[i]), Quantity::Mean)?);
        self.filter = Ekf { x, p: SMatrix::from_fn(|i, j| p[(i, j)]) };
        Ok((nu, s))
    }
    // ANCHOR_END: stacked

    /// As [`Localizer::update_stacked`], one sighting at a time, and equal to it: each later innovation is reduced by
    /// what the earlier sightings already moved, H staying at the prediction.
    ///
    /// # Errors
    /// As [`Localizer::update`].
    pub fn update_in_turn<const M: usize>(
        &mut self,
        model: &impl MeasurementModel<X, N, M>,
        sightings: &[Sighting<M>],
        w: &SMatrix<f64, M, M>,
    ) -> Result<(), Error> {
        let prediction = &self.filter.x;
        let mut next = self.filter;
        for sighting in sightings {
            let (expected, h) = model.linearized(prediction, sighting.j)?;
            let surprise = model.residual(&sighting.y, &expected);
            let innovation = surprise - h * next.x.boxminus(prediction);
            next.correct(&finite(innovation, Quantity::Innovation)?, &h, w)?;
        }
        self.filter = next;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Landmark;
    use crate::error::Code;
    use crate::landmarks::{RangeBearing, RangeOnly};
    use nalgebra::{Matrix1, Matrix2, Vector1, Vector3};

    const MAP: [Landmark; 3] =
        [Landmark { id: 1, x: 6.0, y: 6.0 }, Landmark { id: 2, x: 0.0, y: 6.0 }, Landmark { id: 3, x: 3.0, y: 0.0 }];

    fn ekf() -> Localizer {
        let p = Matrix3::new(0.09, 0.01, 0.0, 0.01, 0.04, -0.02, 0.0, -0.02, 0.05);
        Localizer::new(&Gaussian { x: Vector3::new(1.5, 2.0, 0.4), p })
    }

    fn sightings() -> [Sighting<2>; 3] {
        let model = RangeBearing { map: &MAP };
        let off = [Vector2::new(0.2, -0.05), Vector2::new(-0.1, 0.02), Vector2::new(0.15, 0.07)];
        core::array::from_fn(|j| Sighting { j, y: model.h(&ekf().pose(), j).expect("apart") + off[j] })
    }

    #[test]
    fn stacked_and_in_turn_agree_with_one_linearization() {
        let (model, w) = (RangeBearing { map: &MAP }, Matrix2::new(0.09, 0.01, 0.01, 0.0025));
        let (mut stacked, mut in_turn) = (ekf(), ekf());
        stacked.update_stacked(&model, &sightings(), &w).expect("positive definite");
        in_turn.update_in_turn(&model, &sightings(), &w).expect("positive definite");
        assert!(stacked.pose().boxminus(in_turn.pose()).amax() < 1e-14);
        assert!((stacked.covariance() - in_turn.covariance()).amax() < 1e-15);
    }

    #[test]
    fn relinearized_after_each_sighting_they_differ() {
        let (model, w) = (RangeBearing { map: &MAP }, Matrix2::new(0.09, 0.0, 0.0, 0.0025));
        let (mut stacked, mut relinearized) = (ekf(), ekf());
        stacked.update_stacked(&model, &sightings(), &w).expect("positive definite");
        for sighting in &sightings() {
            relinearized.update(&model, sighting, &w).expect("positive definite");
        }
        assert!(stacked.pose().boxminus(relinearized.pose()).amax() > 1e-4);
    }

    #[test]
    fn one_sighting_is_a_stack_of_one() {
        let (model, w) = (RangeBearing { map: &MAP }, Matrix2::new(0.09, 0.0, 0.0, 0.0025));
        let (mut single, mut stack) = (ekf(), ekf());
        let info = single.update(&model, &sightings()[1], &w).expect("positive definite");
        let (nu, s) = stack.update_stacked(&model, &sightings()[1..2], &w).expect("positive definite");
        assert!(single.pose().boxminus(stack.pose()).amax() < 1e-15);
        assert!((info.innovation[0] - nu[0]).abs() < 1e-15 && (info.s[(1, 1)] - s[(1, 1)]).abs() < 1e-15);
    }

    #[test]
    fn the_motion_turns_after_it_drives() {
        let mut ekf = Localizer::new(&Gaussian { x: Vector3::zeros(), p: Matrix3::identity() });
        ekf.predict(&Vector2::new(1.0, core::f64::consts::FRAC_PI_2), &Matrix3::zeros()).expect("finite");
        assert_eq!((ekf.pose().x(), ekf.pose().y()), (1.0, 0.0));
        // F at the old heading: the heading error becomes an error in y.
        assert_eq!((ekf.covariance()[(1, 2)], ekf.covariance()[(0, 2)]), (1.0, 0.0));
    }

    #[test]
    fn an_estimate_across_the_cut_stays_wrapped() {
        let mut ekf = Localizer::new(&Gaussian { x: Vector3::new(0.0, 0.0, 3.1), p: Matrix3::identity() });
        ekf.predict(&Vector2::new(0.0, 0.2), &Matrix3::zeros()).expect("finite");
        assert!((ekf.pose().theta() - (3.3 - core::f64::consts::TAU)).abs() < 1e-15);
        let model = RangeBearing { map: &MAP };
        let truth = SE2::new(0.0, 0.0, 3.0);
        let y = model.h(&truth, 0).expect("apart");
        for _ in 0..20 {
            ekf.update(&model, &Sighting { j: 0, y }, &(Matrix2::identity() * 1e-4)).expect("positive definite");
        }
        // One landmark leaves the turn about it open; its own readings are met.
        let met = model.residual(&y, &model.h(&ekf.pose(), 0).expect("apart"));
        assert!(met.amax() < 1e-3, "{met}");
    }

    #[test]
    fn a_refused_call_leaves_the_belief() {
        let before = ekf();
        let mut ekf = before;
        let model = RangeOnly { map: &MAP };
        let nan = Sighting { j: 0, y: Vector1::new(f64::NAN) };
        assert!(ekf.update(&model, &nan, &Matrix1::new(1.0)).is_err());
        let good = Sighting { j: 1, y: Vector1::new(4.0) };
        assert!(ekf.update_stacked(&model, &[good, nan], &Matrix1::new(1.0)).is_err());
        assert!(ekf.update_in_turn(&model, &[good, nan], &Matrix1::new(1.0)).is_err());
        assert!(ekf.predict(&Vector2::new(f64::INFINITY, 0.0), &Matrix3::zeros()).is_err());
        assert_eq!(ekf, before);

        let mut on_it = Localizer::new(&Gaussian { x: Vector3::new(6.0, 6.0, 0.0), p: Matrix3::identity() });
        let refused = on_it.update(&model, &Sighting { j: 0, y: Vector1::new(1.0) }, &Matrix1::new(1.0));
        assert_eq!(refused.expect_err("on the landmark").code, Code::AtLandmark);
    }
}
