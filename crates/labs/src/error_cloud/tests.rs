use super::*;
use estimate::Code;

fn of(params: ErrorCloudParams) -> ErrorCloudFrame {
    ErrorCloud::new(params).expect("in reach").frame()
}

#[test]
fn the_mean_products_are_the_covariance_of_the_first_hand_checked_step() {
    let frame = of(ErrorCloudParams::default());
    // Two hundred products of rounded errors: a few units in the last place each.
    let near = |a: f64, b: f64| (a - b).abs() < 1e-13;
    assert!(near(frame.p[0][0], 1.7) && near(frame.p[0][1], 1.05) && near(frame.p[1][1], 2.1), "{:?}", frame.p);
    assert!(near(frame.regression, 0.5) && near(frame.sigma[0], 1.7_f64.sqrt()));
    assert_eq!(frame.p[0][1], frame.p[1][0]);
}

#[test]
fn the_mean_error_is_zero_and_the_ellipse_is_that_of_the_axes() {
    for (semi_major, semi_minor, angle) in [(1.7, 0.9, 0.3), (0.5, 1.5, -1.2), (1.0, 0.4, 2.0)] {
        let frame = of(ErrorCloudParams { semi_major, semi_minor, angle, ..ErrorCloudParams::default() });
        for i in 0..2 {
            assert!(frame.dots.iter().map(|dot| dot[i]).sum::<f64>().abs() < 1e-12);
        }
        assert!((frame.ellipse.semi_major - semi_major.max(semi_minor)).abs() < 1e-12);
        assert!((frame.ellipse.semi_minor - semi_major.min(semi_minor)).abs() < 1e-12);
    }
}

#[test]
fn the_shares_of_all_dots_add_up_to_the_covariance() {
    let params = ErrorCloudParams::default();
    let each: Vec<ErrorCloudFrame> = (0..DOTS as u32).map(|dot| of(ErrorCloudParams { dot, ..params })).collect();
    let sum: f64 = each.iter().map(|frame| frame.share).sum();
    let frame = &each[0];
    assert!((sum - frame.p[0][1]).abs() < 1e-13 && (frame.positive + frame.negative - frame.p[0][1]).abs() < 1e-13);
    assert_eq!(each.iter().filter(|frame| frame.share > 0.0).count(), frame.positives as usize);
    assert!(frame.negative < 0.0 && frame.positive > 0.0);
    for (i, frame) in each.iter().enumerate() {
        assert_eq!(frame.error, frame.dots[i]);
    }
}

#[test]
fn the_regression_makes_the_least_squares_of_the_position_errors() {
    let frame = of(ErrorCloudParams::default());
    let squares = |slope: f64| frame.dots.iter().map(|[x, v]| (x - slope * v).powi(2)).sum::<f64>();
    for other in [frame.regression - 1e-3, frame.regression + 1e-3, frame.long_axis] {
        assert!(squares(frame.regression) < squares(other));
    }
}

#[test]
fn the_ellipse_holds_about_what_a_gaussian_s_does() {
    let frame = of(ErrorCloudParams::default());
    // 1 − exp(−½) of 200 is 78.7, with a standard deviation of 6.9.
    assert!((58..=99).contains(&frame.inside), "{}", frame.inside);
}

#[test]
fn bad_parameters_of_the_cloud_are_refused_by_name() {
    let default = ErrorCloudParams::default();
    let refused = |params| ErrorCloud::new(params).expect_err("refused");
    assert_eq!(refused(ErrorCloudParams { semi_minor: 0.0, ..default }).argument, "semiMinor");
    assert_eq!(refused(ErrorCloudParams { dot: 200, ..default }).argument, "dot");
    assert_eq!(refused(ErrorCloudParams { angle: f64::NAN, ..default }).code, Code::NotFinite);
}
