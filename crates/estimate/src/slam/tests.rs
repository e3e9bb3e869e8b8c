use super::*;
use crate::landmark::Landmark;
use crate::landmarks::RangeBearing;
use filters::{MeasurementModel, central_differences};
use nalgebra::{Vector3, Vector5};

const W: Matrix2<f64> = Matrix2::new(0.01, 0.001, 0.001, 0.0009);
const THRESHOLDS: Thresholds = Thresholds { gate: 9.21, found: 50.0 };
const WORLD: [Landmark; 3] =
    [Landmark { id: 1, x: 4.0, y: 3.0 }, Landmark { id: 2, x: -2.0, y: 2.5 }, Landmark { id: 3, x: 0.5, y: -3.0 }];

/// Numbers of variance one in no visible order, the same in every run.
struct Noise(f64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 += 1.0;
        core::f64::consts::SQRT_2 * libm::sin(self.0 * self.0)
    }
}

fn slam() -> EkfSlam {
    let p = Matrix3::new(0.04, 0.005, 0.0, 0.005, 0.02, -0.004, 0.0, -0.004, 0.01);
    EkfSlam::new(&Gaussian { x: Vector3::new(0.1, -0.2, 0.3), p }, &W, THRESHOLDS).expect("sound")
}

fn reading(truth: &SE2, j: usize, noise: &mut Noise, named: bool) -> LandmarkReading {
    let z = RangeBearing { map: &WORLD }.h(truth, j).expect("apart");
    let landmark = named.then_some(WORLD[j].id);
    LandmarkReading { range: z[0] + 0.05 * noise.next(), bearing: wrap(z[1] + 0.02 * noise.next()), landmark }
}

mod dense;

#[test]
fn founding_carries_the_pose_s_uncertainty_and_its_correlations() {
    let mut slam = slam();
    let before = slam.pose_covariance();
    let given = LandmarkReading { range: 2.5, bearing: -1.1, landmark: Some(7) };
    slam.update(&[given]).expect("founded");
    // By central differences of ℓ(pose, reading).
    let place = |v: &Vector5<f64>| {
        let (sin, cos) = libm::sincos(v[2] + v[4]);
        Vector2::new(v[0] - v[3] * cos, v[1] - v[3] * sin)
    };
    let at = Vector5::new(0.1, -0.2, 0.3, 2.5, -1.1);
    let g = central_differences(place, |a: &Vector2<f64>, b| a - b, &at, 1e-5);
    let (by_pose, by_reading) = (g.fixed_columns::<3>(0), g.fixed_columns::<2>(3));
    let (_, p) = slam.belief();
    let (cross, corner) =
        (by_pose * before, by_pose * before * by_pose.transpose() + by_reading * W * by_reading.transpose());
    for a in 0..2 {
        for i in 0..3 {
            assert!((p[(3 + a, i)] - cross[(a, i)]).abs() < 1e-9);
        }
        for b in 0..2 {
            assert!((p[(3 + a, 3 + b)] - corner[(a, b)]).abs() < 1e-9);
        }
    }
    // A second reading at the same place expects what was read.
    let again = slam.clone().update(&[LandmarkReading { landmark: None, ..given }]).expect("sound");
    assert!(again[0].evidence.expect("matched").0.amax() < 1e-14);
}

#[test]
fn a_second_landmark_is_correlated_with_the_first() {
    let mut slam = slam();
    slam.update(&[LandmarkReading { range: 2.0, bearing: 0.4, landmark: None }]).expect("founded");
    slam.update(&[LandmarkReading { range: 5.0, bearing: 2.4, landmark: None }]).expect("founded");
    let (_, p) = slam.belief();
    assert_eq!(slam.landmarks().map(|l| l.id).collect::<Vec<_>>(), [1, 2]);
    assert!(p[(3, 5)] > 0.03, "both hang on the same pose: {}", p[(3, 5)]);
    assert!(p.symmetric_eigenvalues().min() > 0.0);
}

#[test]
fn sightings_are_matched_rejected_or_found() {
    let mut slam = slam();
    let first = LandmarkReading { range: 3.0, bearing: 0.5, landmark: None };
    let outcome = |slam: &mut EkfSlam, r: LandmarkReading| slam.update(&[r]).expect("sound")[0].outcome;
    assert_eq!(outcome(&mut slam, first), Outcome::Founded);
    assert_eq!(outcome(&mut slam, first), Outcome::Matched);
    let before = slam.belief().1;
    assert_eq!(outcome(&mut slam, LandmarkReading { range: 3.45, ..first }), Outcome::Rejected);
    assert_eq!(slam.belief().1, before, "a rejected sighting changes nothing");
    assert_eq!(outcome(&mut slam, LandmarkReading { bearing: -2.5, ..first }), Outcome::Founded);
    assert_eq!(slam.len(), 2);
    // The gate holds for a named landmark too.
    assert_eq!(outcome(&mut slam, LandmarkReading { range: 3.45, landmark: Some(1), ..first }), Outcome::Rejected);
    assert_eq!(outcome(&mut slam, LandmarkReading { landmark: Some(40), ..first }), Outcome::Founded);
    assert_eq!(slam.landmarks().last().map(|l| l.id), Some(40));
}

#[test]
fn one_step_never_matches_a_landmark_twice() {
    let mut slam = slam();
    let one = LandmarkReading { range: 3.0, bearing: 0.5, landmark: None };
    slam.update(&[one]).expect("founded");
    let reports = slam.update(&[one, LandmarkReading { range: 3.02, ..one }]).expect("sound");
    assert_eq!([reports[0].outcome, reports[1].outcome], [Outcome::Matched, Outcome::Rejected]);
    assert_eq!((reports[1].landmark, slam.len()), (Some(1), 1));
    // A sighting far from every known landmark is of a new one, whatever else was matched.
    let reports = slam.update(&[one, LandmarkReading { bearing: 3.0, ..one }]).expect("sound");
    assert_eq!((reports[1].outcome, reports[1].landmark), (Outcome::Founded, Some(2)));
}

#[test]
fn no_two_landmarks_share_a_name() {
    let at = |bearing, landmark| LandmarkReading { range: 3.0, bearing, landmark };
    for known in [false, true] {
        let mut slam = slam();
        if known {
            slam.update(&[at(0.0, Some(5))]).expect("founded");
        }
        let before = slam.belief().1;
        let refused = slam.update(&[at(0.0, Some(5)), at(2.0, Some(5))]).expect_err("one name, two sightings");
        assert_eq!((refused.code, refused.argument.as_ref()), (Code::Index, "sightings[1].landmark"));
        assert_eq!((slam.len(), slam.belief().1), (usize::from(known), before));
    }
    // A number that the map gives is none of those that later sightings of the step name.
    let mut slam = slam();
    slam.update(&[at(0.0, None), at(2.0, Some(1))]).expect("founded");
    assert_eq!(slam.landmarks().map(|l| l.id).collect::<Vec<_>>(), [2, 1]);
}

#[test]
fn a_refused_sighting_leaves_the_nis_of_the_last() {
    let mut slam = slam();
    let one = LandmarkReading { range: 3.0, bearing: 0.4, landmark: Some(1) };
    assert!(slam.is_empty());
    slam.update(&[one]).expect("founded");
    assert!(!slam.is_empty());
    assert_eq!(slam.nis(), None, "nothing was matched");
    let mut nudged = slam.clone();
    let reports = nudged.update(&[LandmarkReading { range: 3.1, ..one }]).expect("matched");
    let chi2 = reports[0].evidence.map(|(_, _, chi2)| chi2).expect("a known landmark");
    assert!(nudged.nis().is_some_and(|(nis, dof)| (nis - chi2).abs() < 1e-12 && dof == 2 && chi2 > 0.1));
    slam.update(&[one]).expect("matched");
    let before = slam.nis();
    assert!(before.is_some_and(|(nis, dof)| (0.0..1e-12).contains(&nis) && dof == 2), "the same again: {before:?}");
    slam.update(&[LandmarkReading { range: 1e200, bearing: 0.4, landmark: Some(2) }]).expect_err("too far to found");
    assert_eq!(slam.nis(), before);
}

#[test]
fn a_refused_call_leaves_belief_and_map() {
    let mut slam = slam();
    slam.update(&[LandmarkReading { range: 3.0, bearing: 0.5, landmark: Some(1) }]).expect("founded");
    let before = slam.belief().1;
    let good = LandmarkReading { range: 4.0, bearing: -2.0, landmark: Some(2) };
    for (bad, code, argument) in [
        (LandmarkReading { range: f64::NAN, ..good }, Code::NotFinite, "range"),
        (LandmarkReading { range: -1.0, ..good }, Code::Limit, "range"),
        (LandmarkReading { bearing: f64::INFINITY, ..good }, Code::NotFinite, "bearing"),
        (LandmarkReading { range: 0.0, ..good }, Code::AtLandmark, "range"),
        (LandmarkReading { range: 1e200, ..good }, Code::NotFinite, "range"),
    ] {
        let refused = slam.update(&[bad]).expect_err("bad");
        assert_eq!((refused.code, refused.argument.as_ref()), (code, argument), "{bad:?}");
        let two = [good, LandmarkReading { landmark: Some(3), ..bad }];
        assert_eq!(slam.update(&two).expect_err("one of two is bad").code, code, "{bad:?}");
    }
    assert!(slam.update(&[]).is_err());
    assert!(slam.predict(&Vector2::new(1e200, 0.0), &Matrix3::zeros()).is_err());
    assert!(slam.predict(&Vector2::new(0.0, f64::NAN), &Matrix3::zeros()).is_err());
    assert_eq!((slam.len(), slam.belief().1), (1, before));
}

#[test]
fn the_reading_to_blame_is_named() {
    let one = LandmarkReading { range: 3.0, bearing: 0.5, landmark: Some(1) };
    let mut slam = slam();
    slam.update(&[one]).expect("founded");
    let mut blamed = |readings: &[LandmarkReading]| {
        let refused = slam.update(readings).expect_err("refused");
        (refused.code, refused.argument.to_string())
    };
    let other = LandmarkReading { bearing: -2.0, landmark: Some(2), ..one };
    for (range, code) in [(0.0, Code::AtLandmark), (1e200, Code::NotFinite), (1e308, Code::NotFinite)] {
        let bad = LandmarkReading { range, landmark: Some(3), ..one };
        assert_eq!(blamed(&[bad]), (code, "range".into()), "a new landmark at {range}");
        assert_eq!(blamed(&[one, other, bad]), (code, "sightings[2].range".into()), "a new landmark at {range}");
    }
    let far = LandmarkReading { range: 1e308, ..one };
    assert_eq!(blamed(&[far]), (Code::NotFinite, "range".into()));
    assert_eq!(blamed(&[other, far]), (Code::NotFinite, "sightings[1].range".into()));

    let [x, y] = slam.landmarks().map(|l| l.position.into()).next().expect("one");
    slam.x[..2].copy_from_slice(&[x, y]);
    let refused = slam.update(&[one]).expect_err("the estimate stands on it");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::AtLandmark, "landmark"));
}

#[test]
fn a_map_has_its_cap() {
    let mut slam = slam();
    for id in 0..MAX_LANDMARKS as u32 {
        slam.update(&[LandmarkReading { range: 3.0, bearing: 0.001 * f64::from(id), landmark: Some(id) }])
            .expect("founded");
    }
    let one_more = slam.update(&[LandmarkReading { range: 3.0, bearing: 0.0, landmark: Some(u32::MAX) }]);
    assert_eq!(one_more.expect_err("full").code, Code::Limit);
    assert_eq!(slam.len(), MAX_LANDMARKS);
}

/// A vast prior and sharp readings: P falls by sixteen orders of magnitude, more than its digits hold. The filter then
/// refuses; it never answers with a negative variance.
#[test]
fn where_rounding_would_show_the_update_is_refused() {
    for (prior, noise_variance) in [(1e8, 1e-8), (1e4, 1e-10), (1e12, 1e-4)] {
        let belief = Gaussian { x: Vector3::zeros(), p: Matrix3::identity() * prior };
        let w = Matrix2::identity() * noise_variance;
        let mut slam =
            EkfSlam::new(&belief, &w, Thresholds { gate: f64::INFINITY, found: f64::INFINITY }).expect("sound");
        for k in 0..40_u32 {
            let id = k % 3;
            let z = RangeBearing { map: &WORLD }.h(&SE2::new(0.0, 0.0, 0.0), id as usize).expect("apart");
            let _ = slam.update(&[LandmarkReading { range: z[0], bearing: z[1], landmark: Some(id) }]);
            let (_, p) = slam.belief();
            let eigenvalues = p.symmetric_eigenvalues();
            assert!(eigenvalues.min() >= -1e-12 * eigenvalues.max(), "{prior} {noise_variance} {k}: {eigenvalues}");
        }
    }
}

/// A map too large to be looked over at every change: what is far away moves with the least turn of the heading, and
/// where a way back takes that out again only rounding is left of it. Such a step is refused, or leaves a covariance.
#[test]
fn in_a_large_map_a_cancellation_over_a_long_lever_leaves_a_covariance_or_is_refused() {
    let semidefinite = |slam: &EkfSlam| {
        let eigenvalues = slam.belief().1.symmetric_eigenvalues();
        eigenvalues.min() >= -1e-12 * eigenvalues.max()
    };
    for lever in [1e3, 1e5, 1e7] {
        let p = Matrix3::from_diagonal(&Vector3::new(1e-4, 1e-4, 0.1));
        let mut slam = EkfSlam::new(&Gaussian { x: Vector3::zeros(), p }, &W, THRESHOLDS).expect("sound");
        for j in 0..20 {
            let bearing = 0.3 * f64::from(j);
            slam.update(&[LandmarkReading { range: 1.0 + 0.1 * f64::from(j), bearing, landmark: Some(j) }])
                .expect("founded");
        }
        assert!(slam.belief().0.len() > 35);
        let still = Matrix3::zeros();
        let mut back = slam.clone();
        if back.predict(&Vector2::new(lever, 0.0), &still).is_ok() {
            let refused = back.predict(&Vector2::new(-lever, 0.0), &still).is_err();
            assert!(refused || semidefinite(&back), "out and back over {lever}");
        }
        let mut seen = slam.clone();
        if seen.predict(&Vector2::new(lever, 0.0), &still).is_ok() {
            let far = LandmarkReading { range: lever, bearing: 0.0, landmark: Some(99) };
            let refused = seen.update(&[far]).is_err();
            assert!(refused || semidefinite(&seen), "seen from {lever}");
        }
    }
}
