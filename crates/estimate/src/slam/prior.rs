//! SLAM that goes on with a map it is given, as from an earlier visit.

use super::{EkfSlam, MAX_LANDMARKS, Mapped};
use crate::blame::Blame;
use crate::error::{Code, Error};
use crate::validate;
use alloc::format;
use alloc::vec;
use filters::Gaussian;
use filters::association::Thresholds;
use nalgebra::{DMatrix, DVector, Matrix2, U3};

impl EkfSlam {
    /// A robot with this belief about its pose and a map already, the errors of all of them independent: P is
    /// block-diagonal. W is 2×2, of a range and a bearing.
    ///
    /// # Errors
    /// As [`EkfSlam::new`]; naming the landmark, `map[1].p`: [`Code::NotFinite`], [`Code::NotSymmetric`] or
    /// [`Code::NotPositiveSemidefinite`], [`Code::Index`] where two have one number; [`Code::Limit`] for more than
    /// [`MAX_LANDMARKS`].
    ///
    /// # Example
    /// ```
    /// use estimate::kf::Gaussian;
    /// use estimate::slam::{EkfSlam, Mapped, Outcome, LandmarkReading};
    /// use filters::association::Thresholds;
    /// use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
    /// let belief = Gaussian { x: Vector3::zeros(), p: Matrix3::identity() * 1e-4 };
    /// let corner = Mapped { id: 7, position: Vector2::new(3.0, 0.0), p: Matrix2::identity() * 0.01 };
    /// let w = Matrix2::new(0.01, 0.0, 0.0, 0.0009);
    /// let mut slam = EkfSlam::with_map(&belief, &[corner], &w, Thresholds { gate: 9.21, found: 50.0 })?;
    /// // Seen from the landmark, the robot is in the direction π.
    /// let reading = LandmarkReading { range: 3.1, bearing: 3.14, landmark: None };
    /// assert_eq!(slam.update(&[reading])?[0].outcome, Outcome::Matched);
    /// # Ok::<(), estimate::Error>(())
    /// ```
    pub fn with_map(
        belief: &Gaussian<U3>,
        map: &[Mapped],
        w: &Matrix2<f64>,
        thresholds: Thresholds,
    ) -> Result<Self, Error> {
        let mut slam = Self::new(belief, w, thresholds)?;
        if map.len() > MAX_LANDMARKS {
            return Err(Error::new(Code::Limit, "map", format!("holds more than {MAX_LANDMARKS} landmarks")));
        }
        for (i, Mapped { id, position, p }) in map.iter().enumerate() {
            let blame = Blame::Entry("map", i);
            if slam.index(*id).is_some() {
                return Err(blame.field(Error::new(Code::Index, "id", "is that of an earlier landmark")));
            }
            validate::vector(DVector::from_column_slice(position.as_slice()), 2, "position")
                .map_err(|e| blame.field(e))?;
            let p = validate::covariance(DMatrix::from_column_slice(2, 2, p.as_slice()), 2, "p")
                .map_err(|e| blame.field(e))?;
            let apart = vec![0.0; slam.x.len()];
            slam.x.extend(position.iter());
            slam.p.push_row(apart.iter().copied().chain([p[(0, 0)]]));
            slam.p.push_row(apart.into_iter().chain([p[(1, 0)], p[(1, 1)]]));
            slam.ids.push(*id);
            slam.rounding = slam.rounding.max(f64::EPSILON * p.diagonal().max());
        }
        Ok(slam)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::slam::{LandmarkReading, Outcome};
    use nalgebra::{Matrix3, Vector2, Vector3};

    fn map() -> [Mapped; 2] {
        let one = Mapped { id: 4, position: Vector2::new(2.0, 1.0), p: Matrix2::new(0.02, 0.01, 0.01, 0.03) };
        [one, Mapped { id: 9, position: Vector2::new(-1.0, 3.0), p: Matrix2::identity() * 0.5 }]
    }

    fn with(map: &[Mapped]) -> Result<EkfSlam, Error> {
        let belief = Gaussian { x: Vector3::new(0.1, 0.2, 0.3), p: Matrix3::identity() * 0.01 };
        EkfSlam::with_map(&belief, map, &Matrix2::new(0.01, 0.0, 0.0, 0.001), Thresholds { gate: 9.21, found: 50.0 })
    }

    #[test]
    fn a_given_map_is_kept_and_independent() {
        let slam = with(&map()).expect("sound");
        assert_eq!(slam.landmarks().collect::<Vec<_>>(), map());
        let (x, p) = slam.belief();
        assert_eq!(x, [0.1, 0.2, 0.3, 2.0, 1.0, -1.0, 3.0]);
        let block = |i: usize| if i < 3 { 0 } else { (i - 1) / 2 };
        assert!((0..7).all(|i| (0..7).all(|j| block(i) == block(j) || p[(i, j)] == 0.0)));
    }

    #[test]
    fn it_goes_on_like_any_other() {
        let mut slam = with(&map()).expect("sound");
        let named = |id| LandmarkReading { range: 2.0, bearing: 3.5, landmark: Some(id) };
        assert_eq!(slam.update(&[named(4)]).expect("sound")[0].outcome, Outcome::Matched);
        assert!(slam.belief().1[(0, 3)] != 0.0, "a sighting ties robot and landmark");
        assert_eq!(slam.update(&[named(10)]).expect("sound")[0].outcome, Outcome::Founded);
        assert_eq!(slam.len(), 3);
    }

    /// The gate round an expected sighting is the one that a sighting is judged by.
    #[test]
    fn an_expected_sighting_is_what_the_update_compares_with() {
        let mut slam = with(&map()).expect("sound");
        let (expected, s) = slam.expected_sighting(9).expect("in the map");
        let (range, bearing) = (expected[0] + 0.3, expected[1] - 0.1);
        let report = slam.update(&[LandmarkReading { range, bearing, landmark: Some(9) }]).expect("sound")[0];
        let (innovation, covariance, _) = report.evidence.expect("compared");
        assert!((innovation - Vector2::new(0.3, -0.1)).amax() < 1e-15 && covariance == s);
        assert_eq!(slam.expected_sighting(5).expect_err("unknown").code, Code::Index);
    }

    #[test]
    fn what_is_no_map_is_refused_by_name() {
        let refused = |map: &[Mapped]| {
            let error = with(map).expect_err("refused");
            (error.code, error.argument.to_string())
        };
        let [one, two] = map();
        assert_eq!(refused(&[one, Mapped { id: 4, ..two }]), (Code::Index, "map[1].id".into()));
        let nan = Mapped { position: Vector2::new(f64::NAN, 0.0), ..two };
        assert_eq!(refused(&[one, nan]), (Code::NotFinite, "map[1].position".into()));
        let negative = Mapped { p: -Matrix2::identity(), ..one };
        assert_eq!(refused(&[negative]), (Code::NotPositiveSemidefinite, "map[0].p".into()));
        let many: Vec<Mapped> = (0..=MAX_LANDMARKS as u32).map(|id| Mapped { id, ..one }).collect();
        assert_eq!(refused(&many), (Code::Limit, "map".into()));
    }
}
