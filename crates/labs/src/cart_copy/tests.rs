use super::*;
use estimate::Code;

fn at(params: CartCopyParams, step: u32) -> CartCopyFrame {
    CartCopy::at((), params, step).expect("in reach").frame()
}

#[test]
fn a_position_error_stays_to_the_bit_whatever_the_gain() {
    for gain in [0.0, 0.5, 1.0, 3.0, 5.0] {
        for step in [1, 2, 7, 16, 100] {
            let frame = at(CartCopyParams { gain, ..CartCopyParams::default() }, step);
            assert_eq!((frame.innovation, frame.nudge, frame.error), (0.0, [0.0, 0.0], [-1.0, 0.0]), "{gain}, {step}");
        }
    }
}

#[test]
fn a_speed_error_dies_out_at_every_gain_but_zero_and_leaves_a_position_error() {
    let wrong = CartCopyParams { position: 0.0, speed: 1.0, ..CartCopyParams::default() };
    for gain in [0.5, 1.0, 2.0, 5.0] {
        let frame = at(CartCopyParams { gain, ..wrong }, 200);
        assert!(frame.error[1].abs() < 1e-9, "{gain}: {:?}", frame.error);
        // What R∞ adds to the position at g = 1 is what a period at the wrong speed has taken: there the error stays.
        assert_eq!(frame.error[0].abs() < 1e-9, gain == 1.0, "{gain}: {:?}", frame.error);
    }
    let reckoned = at(CartCopyParams { gain: 0.0, ..wrong }, 200);
    assert_eq!(reckoned.error, [100.0, 1.0]);
}

#[test]
fn the_copy_drives_then_compares_then_is_nudged_by_the_gain_times_the_innovation() {
    let params = CartCopyParams { speed: 0.5, gain: 2.0, ..CartCopyParams::default() };
    for step in 1..40 {
        let (before, frame) = (at(params, step - 1), at(params, step));
        let u = push(step - 1);
        let drive = |[x, v]: [f64; 2]| [x + 0.5 * v, v + 0.5 * u];
        assert_eq!(frame.truth, drive(before.truth));
        assert_eq!(frame.predicted, drive(before.copy));
        assert_eq!(frame.innovation, frame.truth[1] - frame.predicted[1]);
        for i in 0..2 {
            assert!((frame.nudge[i] - frame.k[i] * frame.innovation).abs() < 1e-14);
        }
    }
    let start = at(params, 0);
    assert_eq!((start.nudge, start.innovation), ([0.0; 2], -0.5));
}

#[test]
fn a_round_ends_to_the_bit_where_it_began_and_a_phase_begins_within_one() {
    let params = CartCopyParams::default();
    let farthest = (0..16).map(|step| at(params, step).truth[0]).fold(0.0, f64::max);
    assert_eq!((farthest, at(params, 16).truth, at(params, 1600).truth), (4.0, [0.0; 2], [0.0; 2]));
    for phase in [1, 5, 15] {
        assert_eq!(at(CartCopyParams { phase, ..params }, 9).truth, at(params, phase + 9).truth);
    }
}

#[test]
fn bad_parameters_of_the_cart_and_its_copy_are_refused_by_name() {
    let refused = |params| CartCopy::new(params).expect_err("refused");
    let default = CartCopyParams::default();
    assert_eq!(refused(CartCopyParams { position: 1.6, ..default }).argument, "position");
    assert_eq!(refused(CartCopyParams { speed: f64::NAN, ..default }).code, Code::NotFinite);
    assert_eq!(refused(CartCopyParams { gain: 5.1, ..default }).argument, "gain");
    assert_eq!(refused(CartCopyParams { phase: 16, ..default }).code, Code::Limit);
}
