use super::*;
use crate::shapes::ellipse_of;

fn of(params: PictureParams) -> PictureFrame {
    Picture::new(params).expect("in reach").frame()
}

#[test]
fn the_default_is_the_first_hand_checked_step() {
    let frame = of(PictureParams::default());
    let near = |a: f64, b: f64| (a - b).abs() < 1e-14;
    assert!(near(frame.p[0][0], 1.7) && near(frame.p[0][1], 1.05) && near(frame.p[1][1], 2.1));
    assert!(near(frame.posterior.x[0], 3.475) && near(frame.posterior.x[1], 2.95));
    assert!(near(frame.most_likely_output, 2.95) && near(frame.mahalanobis_foot.at[0], 3.35));
    assert_eq!(frame.euclidean_foot.at, [4.0, 2.7]);
}

#[test]
fn the_update_is_the_filter_s_and_each_foot_is_perpendicular_in_its_metric() {
    for (angle, tilt) in [(0.3, 0.0), (-1.2, 0.7), (2.0, -1.5)] {
        let frame = of(PictureParams { angle, tilt, semi_minor: 0.4, ..PictureParams::default() });
        for i in 0..2 {
            assert!((frame.update.at[i] - frame.posterior.x[i]).abs() < 1e-13);
        }
        assert!(frame.euclidean_foot.euclidean.abs() < 1e-13 && frame.euclidean_foot.mahalanobis.abs() > 1e-3);
        for foot in [&frame.mahalanobis_foot, &frame.update] {
            assert!(foot.mahalanobis.abs() < 1e-12 && foot.residual.abs() < 1e-13);
        }
        assert!(frame.mahalanobis_foot.distance < frame.euclidean_foot.distance);
    }
}

#[test]
fn without_noise_the_two_lines_meet() {
    let frame = of(PictureParams { noise: 0.0, ..PictureParams::default() });
    assert!((frame.most_likely_output - 2.7).abs() < 1e-15);
    assert!((frame.update.at[0] - frame.mahalanobis_foot.at[0]).abs() < 1e-14);
}

#[test]
fn on_a_round_belief_the_two_feet_meet() {
    let frame = of(PictureParams { semi_major: 1.5, semi_minor: 1.5, tilt: 0.4, ..PictureParams::default() });
    for i in 0..2 {
        assert!((frame.euclidean_foot.at[i] - frame.mahalanobis_foot.at[i]).abs() < 1e-14);
    }
}

#[test]
fn axes_may_change_places_and_the_ellipse_stays_what_it_is() {
    let frame = of(PictureParams { semi_major: 0.5, semi_minor: 2.0, angle: 0.0, ..PictureParams::default() });
    let e = drawn(&frame);
    assert!((e.semi_major - 2.0).abs() < 1e-15 && (e.semi_minor - 0.5).abs() < 1e-15);
    assert!((e.angle - core::f64::consts::FRAC_PI_2).abs() < 1e-15);
}

#[test]
fn bad_parameters_of_the_picture_are_refused_by_name() {
    let default = PictureParams::default();
    let refused = |params| Picture::new(params).expect_err("refused");
    assert_eq!(refused(PictureParams { semi_minor: 0.0, ..default }).argument, "semiMinor");
    assert_eq!(refused(PictureParams { semi_major: 11.0, ..default }).argument, "semiMajor");
    assert_eq!(refused(PictureParams { noise: -0.1, ..default }).code, Code::Limit);
    assert_eq!(refused(PictureParams { mean: [0.0, 101.0], ..default }).argument, "mean[1]");
    assert_eq!(refused(PictureParams { reading: f64::NAN, ..default }).code, Code::NotFinite);
    assert_eq!(refused(PictureParams { tilt: f64::INFINITY, ..default }).argument, "tilt");
}

#[test]
fn steps_change_nothing() {
    let mut picture = Picture::new(PictureParams::default()).expect("in reach");
    let before = (picture.frame(), picture.digest());
    picture.run(10).expect("within the limit");
    assert_eq!((picture.frame(), picture.digest()), before);
    assert_eq!(picture.steps(), 10);
}

/// The ellipse that `P` of a picture draws.
fn drawn(frame: &PictureFrame) -> Ellipse {
    ellipse_of(&Matrix2::new(frame.p[0][0], frame.p[0][1], frame.p[1][0], frame.p[1][1]))
}

#[test]
fn every_noise_of_the_range_has_a_picture() {
    for noise in [5e-324, 1e-310, 2.2e-308, 1e-300, 1e-160, 1e-154, 1e-20, 4.0] {
        let frame = of(PictureParams { noise, ..PictureParams::default() });
        let numbers = Params::numbers(&frame.params);
        assert!(numbers.iter().all(|n| n.is_finite()) && frame.most_likely_output.is_finite(), "{noise}");
        if noise < 1e-20 {
            assert!((frame.most_likely_output - 2.7).abs() < 1e-15, "{noise}: {}", frame.most_likely_output);
        }
    }
}

#[test]
fn the_most_likely_output_is_where_two_weights_of_one_over_the_variance_balance() {
    for (noise, tilt, reading) in [(0.5, 0.0, 2.7), (2.1, 0.0, 2.7), (4.0, -0.7, -3.0), (0.05, 1.2, 6.0)] {
        let frame = of(PictureParams { noise, tilt, reading, ..PictureParams::default() });
        let (left, right) = (frame.most_likely_output - frame.expected_output, reading - frame.most_likely_output);
        assert!((left / frame.expected_variance - right / noise).abs() < 1e-12);
        assert!((1.0 / frame.most_likely_variance - 1.0 / frame.expected_variance - 1.0 / noise).abs() < 1e-9);
        assert!((left - frame.share * frame.innovation).abs() < 1e-12);
    }
    assert!((of(PictureParams { noise: 2.1, ..PictureParams::default() }).share - 0.5).abs() < 1e-14);
    assert_eq!(of(PictureParams { noise: 0.0, ..PictureParams::default() }).most_likely_variance, 0.0);
}

#[test]
fn the_reader_s_ellipse_holds_what_random_points_of_the_belief_say() {
    let mut noise = sim::Noise::new(3);
    let draws: Vec<f64> = (0..20_000).map(|_| noise.normal().powi(2) + noise.normal().powi(2)).collect();
    for radius in [0.0, 0.5, 1.0, 2.0, 3.0] {
        let inside = of(PictureParams { radius, ..PictureParams::default() }).inside;
        let counted = draws.iter().filter(|d2| **d2 <= radius * radius).count() as f64 / draws.len() as f64;
        // Three standard errors of a frequency of 20 000 draws.
        assert!((inside - counted).abs() < 0.011, "{radius}: {inside} and {counted}");
    }
    assert!(
        (of(PictureParams { radius: 1.0, ..PictureParams::default() }).inside - 0.393_469_340_287_366_6).abs() < 1e-15
    );
}

#[test]
fn no_guess_on_the_line_is_as_probable_as_the_purple_foot() {
    let purple = of(PictureParams::default());
    assert_eq!(purple.guess, None);
    // The purple foot is at 3.35 m and the gray one at 4 m.
    for (place, at) in [(0.0, 4.0), (-0.65, 3.35), (2.0, 6.0), (-3.0, 1.0)] {
        let frame = of(PictureParams { guess: Some(place), sealed: true, ..PictureParams::default() });
        let guess = frame.guess.expect("given");
        assert!((guess.at[0] - at).abs() < 1e-14 && (guess.at[1] - 2.7).abs() < 1e-14);
        assert!(guess.density <= 1.0 + 1e-12 && guess.distance >= purple.mahalanobis_foot.distance - 1e-12);
        assert_eq!((guess.density > 1.0 - 1e-9), place == -0.65, "{guess:?}");
        assert_eq!(frame.update, purple.update, "a guess changes no answer");
    }
}
