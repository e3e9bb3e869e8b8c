use super::*;
use crate::picture::{Picture, PictureParams};
use estimate::Code;

fn of(params: TwoBellsParams) -> TwoBellsFrame {
    TwoBells::new(params).expect("in reach").frame()
}

#[test]
fn it_opens_as_the_picture_does() {
    let picture = Picture::new(PictureParams::default()).expect("in reach").frame();
    let frame = of(TwoBellsParams::default());
    // The Picture's covariance is made of its axes, and has their rounding.
    assert!((frame.likely - picture.most_likely_output).abs() < 1e-14);
    assert!((frame.variance - picture.most_likely_variance).abs() < 1e-14);
}

#[test]
fn the_beam_balances_and_the_weight_of_the_product_is_both_weights() {
    for (expected, expected_variance, reading, noise) in
        [(4.0, 2.1, 2.7, 0.5), (0.0, 0.05, 7.0, 4.0), (3.0, 1.0, 3.0, 2.0)]
    {
        let frame = of(TwoBellsParams { expected, expected_variance, reading, noise });
        let [left, right, both] = frame.weights;
        assert!((left * frame.arms[0] - right * frame.arms[1]).abs() < 1e-12);
        assert!((left + right - both).abs() < 1e-12 * both);
        assert!(frame.variance < expected_variance.min(noise));
    }
}

#[test]
fn two_equal_opinions_balance_half_way() {
    let frame = of(TwoBellsParams { expected_variance: 0.5, ..TwoBellsParams::default() });
    assert!((frame.likely - 3.35).abs() < 1e-15 && (frame.variance - 0.25).abs() < 1e-16);
}

#[test]
fn bad_parameters_of_the_two_bells_are_refused_by_name() {
    let default = TwoBellsParams::default();
    let refused = |params| TwoBells::new(params).expect_err("refused");
    assert_eq!(refused(TwoBellsParams { noise: 0.0, ..default }).argument, "noise");
    assert_eq!(refused(TwoBellsParams { expected_variance: 4.5, ..default }).argument, "expectedVariance");
    assert_eq!(refused(TwoBellsParams { reading: f64::NAN, ..default }).code, Code::NotFinite);
}
