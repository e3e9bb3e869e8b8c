//! The best track afterwards, along an extended Kalman filter of any state and model (Rauch, Tung and Striebel 1965).

use crate::error::{Code, Error};
use crate::gap::{Gap, Linear};
use alloc::format;
use alloc::vec::Vec;
use filters::{Ekf, MotionModel, State};
use nalgebra::{SMatrix, SVector};

/// An extended Kalman filter that remembers its way, so that its past can be seen in the light of all readings.
///
/// With F and V of each step, C = P Fᵀ P̄⁻¹ and P̄ = F P Fᵀ + V, going back from the last belief,
///
/// x(all) = x ⊞ C (x⁺(all) ⊟ x̄⁺) and P(all) = P + C (P⁺(all) − P̄⁺) Cᵀ.
///
/// The last belief is the filter's, and no P(all) is above the filter's P. For a state of N numbers each step keeps two
/// beliefs and two N×N matrices.
///
/// # Example
/// ```
/// use estimate::{Landmark, Track, Unicycle, landmarks::RangeBearing};
/// use estimate::filters::Ekf;
/// use estimate::geom::SE2;
/// use nalgebra::{Matrix2, Matrix3, Vector2};
/// let map = [Landmark { id: 1, x: 3.0, y: 0.0 }];
/// let mut track = Track::new(Ekf { x: SE2::new(0.0, 0.0, 0.0), p: Matrix3::identity() * 0.01 });
/// track.predict(&Unicycle, &Vector2::new(1.0, 0.0), &(Matrix3::identity() * 0.1))?; // 1 m on; σ is 0.3 m
/// let y = Vector2::new(2.5, core::f64::consts::PI); // m, and seen from the landmark, rad
/// track.correct(|filter| filter.update(&RangeBearing { map: &map }, &y, 0, &(Matrix2::identity() * 0.01)))?;
/// let smoothed = track.smoothed()?;
/// // Of the half metre that the robot lags, the start had a little.
/// assert!(smoothed[0].x.x() < 0.0 && smoothed[0].p[(0, 0)] < 0.01);
/// assert_eq!(&smoothed[1], track.filter());
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Track<X, const N: usize> {
    filter: Ekf<X, N>,
    steps: Vec<Step<X, N>>,
}

/// A step: the belief that was left, the motion, and what was predicted.
#[derive(Clone, Copy, Debug)]
struct Step<X, const N: usize> {
    left: Ekf<X, N>,
    motion: Linear<N>,
    predicted: Ekf<X, N>,
}

impl<X: State<N> + Copy, const N: usize> Track<X, N> {
    /// A track that begins with this belief.
    pub fn new(first: Ekf<X, N>) -> Self {
        Self { filter: first, steps: Vec::new() }
    }

    /// The filter as it is now.
    pub fn filter(&self) -> &Ekf<X, N> {
        &self.filter
    }

    /// How many steps the track has.
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// The next step: [`Ekf::predict`] with the input u and the covariance V of the motion, N×N.
    ///
    /// # Errors
    /// As [`Ekf::predict`]; the track is then as it was.
    pub fn predict<const U: usize>(
        &mut self,
        model: &impl MotionModel<X, N, U>,
        u: &SVector<f64, U>,
        v: &SMatrix<f64, N, N>,
    ) -> Result<(), Error> {
        let left = self.filter;
        let (_, f) = model.linearized(&left.x, u);
        self.filter.predict(model, u, v)?;
        self.steps.push(Step { left, motion: Linear { f, v: *v }, predicted: self.filter });
        Ok(())
    }

    /// Corrects the present belief by a reading, as by [`Ekf::update`]: any number of times in a step.
    pub fn correct<T>(&mut self, reading: impl FnOnce(&mut Ekf<X, N>) -> T) -> T {
        reading(&mut self.filter)
    }

    /// The beliefs in the light of all readings: the first, and one for each step.
    ///
    /// # Errors
    /// [`Code::NotFinite`] or [`Code::InnovationNotPositiveDefinite`], naming the step, where a P̄ has no factor or a
    /// number leaves the range of floating point.
    pub fn smoothed(&self) -> Result<Vec<Ekf<X, N>>, Error> {
        let mut gap = Gap::new(&self.filter);
        let mut back = Vec::with_capacity(self.steps.len() + 1);
        let mut after = self.filter;
        for (i, step) in self.steps.iter().enumerate().rev() {
            gap.close(&after, &step.predicted).map_err(|error| refused(error, i + 2))?;
            back.push(*gap.smoothed());
            gap.widen(&step.motion);
            after = step.left;
        }
        gap.close(&after, &after).map_err(|error| refused(error, 1))?;
        back.push(*gap.smoothed());
        back.reverse();
        Ok(back)
    }
}

fn refused(error: filters::Error, step: usize) -> Error {
    let code = match error {
        filters::Error::InnovationNotPositiveDefinite => Code::InnovationNotPositiveDefinite,
        _ => Code::NotFinite,
    };
    Error::new(code, "P", format!("cannot be smoothed over step {step}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coasting::PoseAndSpeed;
    use crate::odometry::Unicycle;
    use crate::{Landmark, landmarks::RangeBearing};
    use core::f64::consts::PI;
    use geom::SE2;
    use nalgebra::{Matrix1, Matrix2, Matrix3, Matrix4, Vector1, Vector2};

    /// The least eigenvalue of the filter's P less the smoothed one, as a part of P's trace.
    fn least<const N: usize>(filtered: &SMatrix<f64, N, N>, smoothed: &SMatrix<f64, N, N>) -> f64 {
        let apart = nalgebra::DMatrix::from_fn(N, N, |i, j| filtered[(i, j)] - smoothed[(i, j)]);
        apart.symmetric_eigenvalues().min() / filtered.trace()
    }

    /// A winding drive with sightings now and then: the filter's beliefs, and the track.
    fn winding(phase: f64, every: usize) -> (Vec<Ekf<SE2, 3>>, Track<SE2, 3>) {
        let map = [Landmark { id: 1, x: 3.0, y: 4.0 }, Landmark { id: 2, x: -5.0, y: 1.0 }];
        let mut track = Track::new(Ekf { x: SE2::new(0.0, 0.0, 0.1), p: Matrix3::identity() * 0.05 });
        let mut filtered = vec![*track.filter()];
        let w = Matrix2::new(0.04, 0.0, 0.0, 0.01);
        for i in 0..60 {
            let t = phase + i as f64;
            let u = Vector2::new(0.3 + 0.1 * libm::sin(t), 0.2 * libm::cos(0.7 * t));
            let v = Matrix3::from_diagonal(&nalgebra::vector![0.01, 0.01, 0.002]);
            track.predict(&Unicycle, &u, &v).expect("finite");
            if i % every == every - 1 {
                let (at, mark) = (track.filter().x, &map[i % 2]);
                let (dx, dy) = (mark.x - at.x(), mark.y - at.y());
                let range = numerics::hypot(dx, dy) + 0.2 * libm::sin(5.0 * t);
                let bearing = geom::wrap(libm::atan2(dy, dx) - at.theta() + PI + 0.1 * libm::cos(3.0 * t));
                let y = Vector2::new(range, bearing);
                track.correct(|ekf| ekf.update(&RangeBearing { map: &map }, &y, i % 2, &w)).expect("seen");
            }
            filtered.push(*track.filter());
        }
        (filtered, track)
    }

    #[test]
    fn no_smoothed_covariance_is_above_the_filter_s_and_the_last_belief_is_the_filter_s() {
        for every in [1, 3, 7, 100] {
            for phase in 0..20 {
                let (filtered, track) = winding(f64::from(phase), every);
                let smoothed = track.smoothed().expect("factored");
                assert_eq!((smoothed.len(), smoothed.last()), (filtered.len(), filtered.last()));
                for (filtered, smoothed) in filtered.iter().zip(&smoothed) {
                    assert!(least(&filtered.p, &smoothed.p) > -1e-12, "{every} {phase}");
                    assert!(smoothed.p.symmetric_eigenvalues().min() > 0.0 && smoothed.p == smoothed.p.transpose());
                }
                let tells = (0..60).any(|i| smoothed[i].p.trace() < 0.9 * filtered[i].p.trace());
                assert_eq!(tells, every != 100, "readings tell of the past, and without any nothing does");
            }
        }
    }

    #[test]
    fn a_speed_is_known_afterwards_by_the_way_it_led() {
        // A state of one's own: a pose and a speed that is read nowhere.
        let coast = |x: &PoseAndSpeed, _: &Vector1<f64>| PoseAndSpeed {
            pose: x.pose.compose(SE2::new(x.speed, 0.0, 0.0)),
            ..*x
        };
        let seen = |x: &PoseAndSpeed| Vector1::new(x.pose.x());
        let x = PoseAndSpeed { pose: SE2::new(0.0, 0.0, 0.0), speed: 0.0 };
        let mut track = Track::new(Ekf { x, p: Matrix4::identity() });
        let v = Matrix4::identity() * 1e-4;
        let mut filtered = vec![*track.filter()];
        for i in 1..=20 {
            track.predict(&coast, &Vector1::zeros(), &v).expect("finite");
            track
                .correct(|ekf| ekf.update(&seen, &Vector1::new(0.5 * f64::from(i)), (), &Matrix1::new(0.01)))
                .expect("seen");
            filtered.push(*track.filter());
        }
        let smoothed = track.smoothed().expect("factored");
        assert!((smoothed[0].x.speed - 0.5).abs() < 0.02, "{:?}", smoothed[0].x);
        assert!(filtered.iter().zip(&smoothed).all(|(f, s)| least(&f.p, &s.p) > -1e-12));
    }

    #[test]
    fn a_step_that_is_refused_leaves_the_track_as_it_was() {
        let (_, mut track) = winding(0.0, 3);
        let before = (*track.filter(), track.steps());
        let endless = Vector2::new(f64::INFINITY, 0.0);
        assert!(track.predict(&Unicycle, &endless, &Matrix3::identity()).is_err());
        assert_eq!((*track.filter(), track.steps()), before);
    }
}
