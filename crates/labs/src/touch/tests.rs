use super::*;
use crate::picture::{Picture, PictureParams};

fn of(params: TouchParams) -> TouchFrame {
    Touch::new(params).expect("in reach").frame()
}

#[test]
fn it_touches_where_the_picture_has_its_purple_foot() {
    let picture = Picture::new(PictureParams { noise: 0.0, ..PictureParams::default() }).expect("in reach").frame();
    let frame = of(TouchParams { guess: 0.0, ..TouchParams::default() });
    for (ours, theirs) in [(frame.touch, picture.mahalanobis_foot.at), (frame.guess, picture.euclidean_foot.at)] {
        assert!((0..2).all(|i| (ours[i] - theirs[i]).abs() < 1e-14));
    }
    assert!((frame.touch_radius - picture.mahalanobis_foot.distance).abs() < 1e-14);
    assert!((frame.guess_radius - picture.euclidean_foot.distance).abs() < 1e-14);
}

#[test]
fn it_reaches_every_other_point_of_the_line_later() {
    for covariance in [-1.75, -1.0, 0.0, 0.4, 1.05, 1.75] {
        for guess in [-2.5, -1.0, -0.5, 0.0, 0.7, 2.5] {
            let frame = of(TouchParams { covariance, guess, ..TouchParams::default() });
            assert!(frame.guess_radius >= frame.touch_radius && frame.times >= 1.0);
            let there = of(TouchParams { guess: frame.touch[0] - 4.0, covariance, grown: true });
            assert!(there.off.abs() < 1e-14 && (there.guess_radius - there.touch_radius).abs() < 1e-14);
        }
    }
}

#[test]
fn without_correlation_it_touches_straight_below_and_the_lean_says_on_which_side_otherwise() {
    let side = |covariance| {
        let frame = of(TouchParams { covariance, ..TouchParams::default() });
        frame.touch[0] - frame.below[0]
    };
    assert_eq!(side(0.0), 0.0);
    assert!(side(1.05) < -0.6 && side(-1.05) > 0.6);
}

#[test]
fn bad_parameters_of_the_touch_are_refused_by_name() {
    let default = TouchParams::default();
    let refused = |params| Touch::new(params).expect_err("refused");
    assert_eq!(refused(TouchParams { guess: 2.6, ..default }).argument, "guess");
    assert_eq!(refused(TouchParams { covariance: 1.8, ..default }).code, Code::Limit);
    assert_eq!(refused(TouchParams { covariance: f64::NAN, ..default }).code, Code::NotFinite);
}
