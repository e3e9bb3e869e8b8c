//! What a robot reads of its surroundings, and how one reading corrects the belief, in Choset's letters.

use crate::ekf::Localizer;
use crate::error::Error;
use crate::landmark::Landmark;
use crate::landmarks::{Among, RangeBearing, RangeOnly, best};
use crate::pose_sensors::{Antenna, Compass, Fix, Speedometer};
use crate::scaled::{HasPose, Scaled};
use filters::association::{Association, Candidate, Rule};
use filters::{MeasurementModel, Update};
use geom::wrap;
use nalgebra::{Matrix1, Matrix2, SMatrix, SVector, Vector1, Vector2};

/// A reading with its noise covariance W, each kind of sensor a variant.
///
/// # Example
/// ```
/// use estimate::nalgebra::{Matrix3, Vector3};
/// use estimate::{Landmark, Localizer, Reading, Setup, kf::Gaussian};
/// let mut robot = Localizer::new(&Gaussian { x: Vector3::zeros(), p: Matrix3::identity() * 0.03 });
/// let map = [Landmark { id: 7, x: 3.0, y: 0.0 }];
/// let setup = Setup { map: &map, scale: None, offset: 0.0, gate: Some(6.63) };
/// robot.correct(&Reading::Heading { theta: 0.1, w: 0.01 }, &setup)?;
/// robot.correct(&Reading::Range { landmark: Some(0), range: 2.9, w: 0.01 }, &setup)?;
/// assert!((robot.pose().theta() - 0.075).abs() < 1e-12 && (robot.pose().x() - 0.075).abs() < 1e-12);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reading {
    /// The distance to a landmark.
    Range {
        /// Its index on the map; without one it is the landmark of least χ².
        landmark: Option<usize>,
        /// m.
        range: f64,
        /// W, m².
        w: f64,
    },
    /// Distance and direction of a landmark.
    RangeBearing {
        /// Its index on the map; without one it is the likeliest landmark.
        landmark: Option<usize>,
        /// m.
        range: f64,
        /// rad, from the landmark ([`RangeBearing`]).
        bearing: f64,
        /// W.
        w: Matrix2<f64>,
    },
    /// The robot's position, as of a satellite receiver.
    Position {
        /// m.
        x: f64,
        /// m.
        y: f64,
        /// W, m².
        w: Matrix2<f64>,
    },
    /// The position of an antenna that does not stand where the robot's pose is.
    Antenna {
        /// m.
        x: f64,
        /// m.
        y: f64,
        /// How far ahead of the pose it stands, and how far to its left, m.
        at: [f64; 2],
        /// W, m².
        w: Matrix2<f64>,
    },
    /// The robot's heading, as of a compass.
    Heading {
        /// rad; any finite angle, taken on the circle.
        theta: f64,
        /// W, rad².
        w: f64,
    },
    /// The robot's speed along its heading, of a state that has one ([`PoseAndSpeed`](crate::PoseAndSpeed)).
    Speed {
        /// m/s.
        v: f64,
        /// W, m²/s².
        w: f64,
    },
}

/// What a reading is judged by.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'m> {
    /// The landmarks.
    pub map: &'m [Landmark],
    /// ε in the expected range (1 + ε) ρ + offset; `None` takes it from the state, and 0 where the state has none.
    pub scale: Option<f64>,
    /// m.
    pub offset: f64,
    /// The largest χ² of a reading that corrects; `None` takes every reading.
    pub gate: Option<f64>,
}

/// What became of a reading.
#[derive(Clone, Debug, PartialEq)]
pub struct Corrected {
    /// Whether it was within the gate and corrected the belief. A reading whose χ² is no number is within no gate.
    pub accepted: bool,
    /// The index of the landmark that it was judged against; `None` of a reading without one.
    pub landmark: Option<usize>,
    /// p, how many numbers were read.
    pub outputs: usize,
    /// ν in its first p entries, 0 below.
    pub innovation: Vector2<f64>,
    /// S in its first p rows and columns, 0 elsewhere.
    pub s: Matrix2<f64>,
    /// χ² = νᵀS⁻¹ν, or why it is no number.
    pub chi2: Result<f64, filters::Error>,
}

impl<X: HasPose<N>, const N: usize> Localizer<X, N> {
    /// Corrects the belief with a reading within the gate; one beyond it leaves the belief alone, whether its landmark
    /// was named or found.
    ///
    /// # Errors
    /// As [`Localizer::update`], [`crate::Code::Index`] where a landmark is to be found on an empty map, and
    /// [`crate::Code::Shape`] of a speed where the state has none; the belief is then as it was.
    #[inline(always)]
    pub fn correct(&mut self, reading: &Reading, setup: &Setup<'_>) -> Result<Corrected, Error> {
        let Setup { map, scale, offset, gate } = *setup;
        let among = |rule| Among { landmarks: map.len(), rule, gate };
        match *reading {
            Reading::Range { landmark, range, w } => {
                let model = Scaled { sensor: RangeOnly { map }, scale, offset };
                let (y, w) = (Vector1::new(range), Matrix1::new(w));
                self.sighted(landmark, &model, &y, &w, among(Rule::ChiSquared))
            }
            Reading::RangeBearing { landmark, range, bearing, w } => {
                let model = Scaled { sensor: RangeBearing { map }, scale, offset };
                let y = Vector2::new(range, wrap(bearing));
                self.sighted(landmark, &model, &y, &w, among(Rule::MaximumLikelihood))
            }
            Reading::Position { x, y, w } => self.within(gate, &Fix, None, &Vector2::new(x, y), &w),
            Reading::Antenna { x, y, at, w } => self.within(gate, &Antenna { at }, None, &Vector2::new(x, y), &w),
            Reading::Speed { v, w } if self.filter.x.speed().is_some() => {
                self.within(gate, &Speedometer, None, &Vector1::new(v), &Matrix1::new(w))
            }
            Reading::Speed { .. } => Err(Error::new(crate::Code::Shape, "speed", "is read of a state that has none")),
            Reading::Heading { theta, w } => self.within(gate, &Compass, None, &Vector1::new(theta), &Matrix1::new(w)),
        }
    }

    /// Corrects the belief by the landmark that is named, or else by the best of all.
    #[inline(always)]
    fn sighted<const M: usize>(
        &mut self,
        named: Option<usize>,
        model: &impl MeasurementModel<X, N, M>,
        y: &SVector<f64, M>,
        w: &SMatrix<f64, M, M>,
        among: Among,
    ) -> Result<Corrected, Error> {
        let j = match named {
            Some(j) => j,
            None => match best(model, &self.filter, y, w, among)? {
                Association::Matched(best) | Association::Rejected(best) => best.j,
                Association::New => return Err(Error::new(crate::Code::Index, "landmarks", "is empty")),
            },
        };
        self.within(among.gate, model, Some(j), y, w)
    }

    /// Corrects the belief, and takes that back where χ² is beyond the gate.
    #[inline(always)]
    fn within<const M: usize>(
        &mut self,
        gate: Option<f64>,
        model: &impl MeasurementModel<X, N, M>,
        landmark: Option<usize>,
        y: &SVector<f64, M>,
        w: &SMatrix<f64, M, M>,
    ) -> Result<Corrected, Error> {
        let (before, j) = (self.filter, landmark.unwrap_or(0));
        let Update { innovation, s, d2, .. } = self.filter.update(model, y, j, w)?;
        let chi2 = match d2 {
            Some(d2) => Ok(d2),
            None => Candidate::new(j, innovation, s, Rule::ChiSquared).map(|candidate| candidate.d2),
        };
        let accepted = gate.is_none_or(|gate| chi2.is_ok_and(|chi2| chi2 <= gate));
        if !accepted {
            self.filter = before;
        }
        let entry = |i: usize, k: usize| if i < M && k < M { s[(i, k)] } else { 0.0 };
        Ok(Corrected {
            accepted,
            landmark,
            outputs: M,
            innovation: Vector2::from_fn(|i, _| if i < M { innovation[i] } else { 0.0 }),
            s: Matrix2::from_fn(entry),
            chi2,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scaled::PoseAndScale;
    use core::f64::consts::{PI, TAU};
    use filters::Ekf;
    use geom::SE2;
    use nalgebra::{Matrix3, Matrix4};

    const MAP: [Landmark; 2] = [Landmark { id: 7, x: 3.0, y: 0.0 }, Landmark { id: 9, x: 0.0, y: 5.0 }];

    fn setup(gate: Option<f64>) -> Setup<'static> {
        Setup { map: &MAP, scale: None, offset: 0.0, gate }
    }

    fn heading(theta: f64) -> Localizer {
        let p = Matrix3::from_diagonal(&nalgebra::Vector3::new(0.04, 0.04, 0.03));
        Localizer { filter: Ekf { x: SE2::new(0.0, 0.0, theta), p } }
    }

    #[test]
    fn a_compass_turns_the_heading_the_short_way_round() {
        // S = P + W = 0.04: three quarters of the innovation are taken.
        let mut localizer = heading(PI - 0.02);
        let reading = Reading::Heading { theta: 0.02 - PI, w: 0.01 };
        let answer = localizer.correct(&reading, &setup(Some(6.63))).expect("positive definite");
        assert!(answer.accepted && answer.landmark.is_none() && answer.outputs == 1);
        assert!((answer.innovation[0] - 0.04).abs() < 1e-15 && (answer.s[(0, 0)] - 0.04).abs() < 1e-15);
        assert!((answer.chi2.expect("a number") - 0.04).abs() < 1e-14);
        assert!((localizer.pose().theta() - (PI + 0.01 - TAU)).abs() < 1e-15);
        assert!((localizer.filter.p[(2, 2)] - 0.0075).abs() < 1e-16, "1/(1/0.03 + 1/0.01)");
    }

    #[test]
    fn a_compass_stands_beside_ranges_and_says_nothing_of_the_scale() {
        let x = PoseAndScale { pose: SE2::new(0.0, 0.0, 0.1), epsilon: 0.05 };
        let mut localizer = Localizer { filter: Ekf { x, p: Matrix4::identity() * 0.01 } };
        let compass = Reading::Heading { theta: 0.2, w: 0.01 };
        localizer.correct(&compass, &setup(None)).expect("positive definite");
        let Ekf { x, p } = localizer.filter;
        assert!((x.pose.theta() - 0.15).abs() < 1e-15 && x.epsilon == 0.05 && p[(3, 3)] == 0.01);
        let range = Reading::Range { landmark: Some(0), range: 3.3, w: 0.01 };
        localizer.correct(&range, &setup(None)).expect("positive definite");
        assert!(localizer.filter.x.epsilon > 0.05 && localizer.filter.p[(3, 3)] < 0.01);
    }

    #[test]
    fn a_fix_moves_the_position_and_turns_what_is_correlated_with_it() {
        let p = Matrix3::new(0.04, 0.0, 0.0, 0.0, 0.12, 0.03, 0.0, 0.03, 0.03);
        let mut localizer = Localizer { filter: Ekf { x: SE2::new(1.0, 2.0, 0.5), p } };
        let fix = Reading::Position { x: 1.5, y: 1.6, w: Matrix2::new(0.01, 0.0, 0.0, 0.04) };
        let answer = localizer.correct(&fix, &setup(None)).expect("positive definite");
        assert!(answer.accepted && answer.landmark.is_none() && answer.outputs == 2);
        assert!((answer.innovation - Vector2::new(0.5, -0.4)).amax() < 1e-15);
        assert!((answer.s - Matrix2::new(0.05, 0.0, 0.0, 0.16)).amax() < 1e-15);
        assert!((answer.chi2.expect("a number") - (5.0 + 1.0)).abs() < 1e-12);
        // K = [4/5, 0; 0, 3/4; 0, 3/16].
        let pose = localizer.pose();
        assert!((pose.x() - 1.4).abs() < 1e-15 && (pose.y() - 1.7).abs() < 1e-15);
        assert!((pose.theta() - (0.5 - 0.4 * 3.0 / 16.0)).abs() < 1e-15);
    }

    #[test]
    fn a_speed_is_refused_of_a_state_without_one() {
        let mut localizer = heading(0.1);
        let refused = localizer.correct(&Reading::Speed { v: 1.0, w: 0.1 }, &setup(None)).expect_err("no speed");
        assert_eq!((refused.code, refused.argument.as_ref()), (crate::Code::Shape, "speed"));
        assert_eq!(localizer, heading(0.1));
    }

    #[test]
    fn beyond_the_gate_the_belief_stays_and_what_overflows_is_within_none() {
        let before = heading(0.1);
        for reading in [
            Reading::Heading { theta: 2.1, w: 0.01 },
            Reading::Position { x: 3.0, y: -3.0, w: Matrix2::identity() },
            Reading::Position { x: 1e300, y: 0.0, w: Matrix2::identity() },
            Reading::Range { landmark: None, range: 8.0, w: 0.01 },
            Reading::Range { landmark: Some(0), range: 1e300, w: 0.01 },
            Reading::RangeBearing { landmark: None, range: 8.0, bearing: 0.0, w: Matrix2::identity() * 0.01 },
        ] {
            let mut localizer = before;
            assert!(!localizer.correct(&reading, &setup(Some(6.63))).expect("positive definite").accepted);
            assert_eq!(localizer, before);
            let nan = Reading::Heading { theta: f64::NAN, w: 0.01 };
            assert!(localizer.correct(&nan, &setup(None)).is_err());
            assert_eq!(localizer, before);
        }
    }
}
