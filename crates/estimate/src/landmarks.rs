//! Range and bearing to mapped landmarks (§8.3), the bearing in Choset's convention: measured from the landmark.

use crate::error::{Code, Error};
use crate::landmark::Landmark;
use crate::scaled::RangeFirst;
use alloc::vec::Vec;
use filters::association::{Association, Candidate, Rule, Thresholds, associate};
use filters::{Ekf, MeasurementModel, Parameter, State};
use geom::{SE2, angle_diff, wrap};
use nalgebra::{SMatrix, SVector, Vector1, Vector2};

/// Nearer than this (metres) the robot stands on the landmark: there ρ has no derivative and β no value.
pub const NEAREST: f64 = 1e-9;

/// Δ = (x_r − x_ℓ, y_r − y_ℓ) and its length ρ, for both models.
///
/// # Errors
/// [`filters::Error::AtFeature`] where the robot stands on the landmark.
#[inline]
fn displacement(map: &[Landmark], x: &SE2, j: usize) -> Result<(f64, f64, f64), filters::Error> {
    let landmark = map.get(j).ok_or(filters::Error::OutOfRange(Parameter::Feature))?;
    let (dx, dy) = (x.x() - landmark.x, x.y() - landmark.y);
    let rho = numerics::hypot(dx, dy);
    if rho < NEAREST { Err(filters::Error::AtFeature) } else { Ok((dx, dy, rho)) }
}

// ANCHOR: range_bearing
/// Range and bearing to landmark `j` of the map: `[ρ, β]` with β = atan2(y_r − y_ℓ, x_r − x_ℓ) − θ_r, the direction in
/// which the robot is seen **from the landmark**. Seen from the robot, the other way round, it differs by π.
#[derive(Clone, Copy, Debug)]
pub struct RangeBearing<'m> {
    /// The landmarks.
    pub map: &'m [Landmark],
}

impl MeasurementModel<SE2, 3, 2> for RangeBearing<'_> {
    fn h(&self, x: &SE2, j: usize) -> Result<SVector<f64, 2>, filters::Error> {
        self.linearized(x, j).map(|(h, _)| h)
    }

    fn jacobian(&self, x: &SE2, j: usize) -> Result<SMatrix<f64, 2, 3>, filters::Error> {
        self.linearized(x, j).map(|(_, jacobian)| jacobian)
    }

    #[inline]
    fn linearized(&self, x: &SE2, j: usize) -> Result<(SVector<f64, 2>, SMatrix<f64, 2, 3>), filters::Error> {
        let (dx, dy, rho) = displacement(self.map, x, j)?;
        let h = Vector2::new(rho, wrap(libm::atan2(dy, dx) - x.theta()));
        let per_range = 1.0 / rho;
        let (cos, sin) = (dx * per_range, dy * per_range);
        Ok((h, SMatrix::<f64, 2, 3>::new(cos, sin, 0.0, -sin * per_range, cos * per_range, -1.0)))
    }

    /// Bearings differ by the short way round: z − h(x) would be wrong by a whole turn near ±π.
    #[inline]
    fn residual(&self, z: &SVector<f64, 2>, expected: &SVector<f64, 2>) -> SVector<f64, 2> {
        Vector2::new(z[0] - expected[0], angle_diff(z[1], expected[1]))
    }
}
// ANCHOR_END: range_bearing

// ANCHOR: range_only
/// The same with the bearing row left out (§8.3.3).
#[derive(Clone, Copy, Debug)]
pub struct RangeOnly<'m> {
    /// The landmarks.
    pub map: &'m [Landmark],
}

impl MeasurementModel<SE2, 3, 1> for RangeOnly<'_> {
    fn h(&self, x: &SE2, j: usize) -> Result<SVector<f64, 1>, filters::Error> {
        let (_, _, rho) = displacement(self.map, x, j)?;
        Ok(Vector1::new(rho))
    }

    fn jacobian(&self, x: &SE2, j: usize) -> Result<SMatrix<f64, 1, 3>, filters::Error> {
        let (dx, dy, rho) = displacement(self.map, x, j)?;
        let per_range = 1.0 / rho;
        Ok(SMatrix::<f64, 1, 3>::new(dx * per_range, dy * per_range, 0.0))
    }
}
// ANCHOR_END: range_only

impl RangeFirst<2> for RangeBearing<'_> {}
impl RangeFirst<1> for RangeOnly<'_> {}

/// The bearing row of the Jacobian as Choset prints it, unsimplified: the derivative of the arctangent through
/// 1/(1 + (Δy/Δx)²). It is 0/0 where Δx = 0, and equal to the simple row elsewhere.
pub fn raw_bearing_row(x: &SE2, landmark: &Landmark) -> SMatrix<f64, 1, 3> {
    let (dx, dy) = (x.x() - landmark.x, x.y() - landmark.y);
    let q = dy / dx;
    let outer = 1.0 / (1.0 + q * q);
    SMatrix::<f64, 1, 3>::new(outer * (-dy / (dx * dx)), outer * (1.0 / dx), -1.0)
}

// ANCHOR: associate
/// νᵢⱼ, Sᵢⱼ and χ²ᵢⱼ of the reading `y` against landmark `j` (§8.3.2).
///
/// # Errors
/// [`Code::AtLandmark`], [`Code::InnovationNotPositiveDefinite`] or [`Code::NotFinite`]; [`Code::Limit`] when there is
/// no landmark `j`.
pub fn candidate<X: State<N>, const N: usize, const M: usize>(
    model: &impl MeasurementModel<X, N, M>,
    belief: &Ekf<X, N>,
    y: &SVector<f64, M>,
    j: usize,
    w: &SMatrix<f64, M, M>,
    rule: Rule,
) -> Result<Candidate<M>, Error> {
    let (expected, h) = model.linearized(&belief.x, j)?;
    let innovation = model.residual(y, &expected);
    let s = filters::linear::innovation_covariance(&h, &belief.p, w);
    Ok(Candidate::new(j, innovation, s, rule)?)
}

/// The landmark a range–bearing reading is likeliest of, by χ² + ln det S; `None` when its χ² is above `gate`.
///
/// # Errors
/// As [`candidate`], [`Code::Index`] for an empty map.
pub fn associate_ml(
    y: &SVector<f64, 2>,
    belief: &Ekf<SE2, 3>,
    map: &[Landmark],
    w: &SMatrix<f64, 2, 2>,
    gate: f64,
) -> Result<Option<usize>, Error> {
    let among = Among { landmarks: map.len(), rule: Rule::MaximumLikelihood, gate: Some(gate) };
    let best = best(&RangeBearing { map }, belief, y, w, among)?;
    Ok(best.matched().map(|candidate| candidate.j))
}
// ANCHOR_END: associate

/// The landmark a range is nearest to, by Choset's χ² alone: a(i) = argminⱼ χ²ᵢⱼ; `None` when its χ² is above `gate`.
///
/// # Errors
/// As [`associate_ml`].
pub fn associate_chi2(
    y: &SVector<f64, 1>,
    belief: &Ekf<SE2, 3>,
    map: &[Landmark],
    w: &SMatrix<f64, 1, 1>,
    gate: f64,
) -> Result<Option<usize>, Error> {
    let among = Among { landmarks: map.len(), rule: Rule::ChiSquared, gate: Some(gate) };
    let best = best(&RangeOnly { map }, belief, y, w, among)?;
    Ok(best.matched().map(|candidate| candidate.j))
}

/// Which landmarks a reading is compared with, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Among {
    /// The first so many of the map.
    pub landmarks: usize,
    /// What the best one minimizes.
    pub rule: Rule,
    /// The largest χ² of a match.
    pub gate: Option<f64>,
}

/// The best candidate among all landmarks, and whether it is within the gate. A landmark that the estimate stands on
/// has no bearing to compare with and is no candidate, while there is another.
///
/// # Errors
/// As [`associate_ml`].
pub fn best<X: State<N>, const N: usize, const M: usize>(
    model: &impl MeasurementModel<X, N, M>,
    belief: &Ekf<X, N>,
    y: &SVector<f64, M>,
    w: &SMatrix<f64, M, M>,
    among: Among,
) -> Result<Association<M>, Error> {
    let Among { landmarks, rule, gate } = among;
    if landmarks == 0 {
        return Err(Error::new(Code::Index, "landmarks", "is empty: there is nothing to associate the sighting with"));
    }
    let (mut candidates, mut underfoot) = (Vec::with_capacity(landmarks), None);
    for j in 0..landmarks {
        match candidate(model, belief, y, j, w, rule) {
            Ok(candidate) => candidates.push(candidate),
            Err(error) if error.code == Code::AtLandmark => underfoot = Some(error),
            Err(error) => return Err(error),
        }
    }
    match underfoot {
        Some(error) if candidates.is_empty() => Err(error),
        _ => Ok(associate(&candidates, &[], Thresholds::gate(gate))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;
    use filters::central_differences;
    use nalgebra::{Matrix1, Matrix2, Matrix3, Vector3};

    const MAP: [Landmark; 3] =
        [Landmark { id: 7, x: 2.0, y: 1.0 }, Landmark { id: 8, x: -3.0, y: 4.0 }, Landmark { id: 9, x: 0.5, y: -2.0 }];

    #[test]
    fn seen_from_the_robot_the_bearing_differs_by_pi() {
        let x = SE2::new(0.3, 0.2, 0.7);
        let from_landmark = RangeBearing { map: &MAP }.h(&x, 0).expect("apart")[1];
        let from_robot = libm::atan2(MAP[0].y - x.y(), MAP[0].x - x.x()) - x.theta();
        assert!((angle_diff(from_landmark, from_robot).abs() - PI).abs() < 1e-15);
    }

    #[test]
    fn the_jacobians_are_derivatives_and_the_raw_row_agrees() {
        let (rb, ro) = (RangeBearing { map: &MAP }, RangeOnly { map: &MAP });
        for x in [SE2::new(0.3, 0.2, 0.7), SE2::new(-4.0, 1.0, -3.0), SE2::new(2.5, -0.5, 3.1)] {
            for (j, landmark) in MAP.iter().enumerate() {
                let jacobian = rb.jacobian(&x, j).expect("apart");
                let numeric = central_differences(|x| rb.h(x, j).expect("apart"), |a, b| rb.residual(a, b), &x, 1e-5);
                assert!((jacobian - numeric).amax() < 1e-9);
                assert!((jacobian.row(1) - raw_bearing_row(&x, landmark)).amax() < 1e-15);
                assert_eq!(jacobian.row(0), ro.jacobian(&x, j).expect("apart"));
                assert_eq!(rb.h(&x, j).expect("apart")[0], ro.h(&x, j).expect("apart")[0]);
            }
        }
    }

    #[test]
    fn straight_above_a_landmark_the_simple_row_is_finite_and_the_raw_one_is_not() {
        let x = SE2::new(2.0, 3.0, 0.1);
        assert!(raw_bearing_row(&x, &MAP[0]).iter().any(|e| e.is_nan()));
        assert!((RangeBearing { map: &MAP }.jacobian(&x, 0).expect("apart")[(1, 0)] + 0.5).abs() < 1e-15);
    }

    #[test]
    fn a_bearing_across_the_cut_is_a_small_surprise() {
        let model = RangeBearing { map: &MAP };
        let nu = model.residual(&Vector2::new(1.0, PI - 0.01), &Vector2::new(1.0, -PI + 0.01));
        assert!((nu[1] + 0.02).abs() < 1e-15);
    }

    #[test]
    fn on_the_landmark_there_is_no_model() {
        let x = SE2::new(2.0, 1.0, 0.0);
        assert_eq!(RangeBearing { map: &MAP }.h(&x, 0), Err(filters::Error::AtFeature));
        assert_eq!(RangeOnly { map: &MAP }.jacobian(&x, 0), Err(filters::Error::AtFeature));
        assert!(RangeOnly { map: &MAP }.h(&x, 3).is_err(), "there is no fourth");
    }

    #[test]
    fn sightings_find_their_landmarks() {
        let belief = Ekf { x: SE2::new(0.0, 0.0, 0.2), p: Matrix3::identity() * 0.01 };
        let pose = belief.x;
        for j in 0..3 {
            let y = RangeBearing { map: &MAP }.h(&pose, j).expect("apart") + Vector2::new(0.05, -0.02);
            let w = Matrix2::new(0.01, 0.0, 0.0, 0.001);
            assert_eq!(associate_ml(&y, &belief, &MAP, &w, 9.21), Ok(Some(j)));
            let range = Vector1::new(y[0]);
            assert_eq!(associate_chi2(&range, &belief, &MAP, &Matrix1::new(0.01), 6.63), Ok(Some(j)));
            assert_eq!(associate_ml(&(y * 3.0), &belief, &MAP, &w, 9.21), Ok(None));
        }
        assert!(associate_ml(&Vector2::zeros(), &belief, &[], &Matrix2::identity(), 9.21).is_err());
    }

    #[test]
    fn only_a_landmark_under_the_robot_is_skipped() {
        // Sure of y and of every range: what is read of the landmark ahead has no spread to compare with.
        let belief = Ekf { x: SE2::new(0.0, 0.0, 0.0), p: Matrix3::from_diagonal(&Vector3::new(1.0, 0.0, 0.0)) };
        let map = [Landmark { id: 1, x: 3.0, y: 0.0 }, Landmark { id: 2, x: 0.0, y: 5.0 }];
        let (y, w) = (Vector1::new(3.0), Matrix1::zeros());
        assert_eq!(associate_chi2(&y, &belief, &map[..1], &w, 6.63), Ok(Some(0)));
        let refused = associate_chi2(&y, &belief, &map, &w, 6.63).expect_err("S is zero");
        assert_eq!(refused.code, Code::InnovationNotPositiveDefinite);
    }

    /// Choset's rule and maximum likelihood part where one candidate's S is far wider than the other's.
    #[test]
    fn the_two_rules_may_choose_differently() {
        // Uncertain in heading: the far landmark's position is smeared, in its bearing row not at all.
        let belief = Ekf { x: SE2::new(0.0, 0.0, 0.0), p: Matrix3::from_diagonal(&Vector3::new(4.0, 1e-4, 1e-4)) };
        let map = [Landmark { id: 1, x: 0.0, y: 5.0 }, Landmark { id: 2, x: 5.8, y: 0.0 }];
        let w = Matrix1::new(0.01);
        let y = Vector1::new(5.2);
        let model = RangeOnly { map: &map };
        let likeliest =
            best(&model, &belief, &y, &w, Among { landmarks: 2, rule: Rule::MaximumLikelihood, gate: None })
                .expect("apart");
        assert_eq!(associate_chi2(&y, &belief, &map, &w, f64::INFINITY), Ok(Some(1)));
        assert!(matches!(likeliest, Association::Matched(c) if c.j == 0));
    }
}
