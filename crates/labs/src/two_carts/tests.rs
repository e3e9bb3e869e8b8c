use super::*;
use estimate::Code;

fn of(params: TwoCartsParams) -> TwoCartsFrame {
    TwoCarts::new(params).expect("in reach").frame()
}

#[test]
fn a_velocity_sensor_reads_the_same_to_the_bit_wherever_the_second_cart_starts() {
    for position in [-2.0, -0.35, 0.0, 1.0, 2.0] {
        let frame = of(TwoCartsParams { position, ..TwoCartsParams::default() });
        assert_eq!(frame.readings[0], frame.readings[1]);
        assert_eq!((frame.difference, frame.rank, frame.unseen), (0.0, 1, Some([1.0, 0.0])));
    }
}

#[test]
fn a_position_sensor_tells_any_two_starts_apart() {
    for (position, speed) in [(1.0, 0.0), (0.0, 0.5), (-2.0, 0.25), (0.05, -0.05)] {
        let frame = of(TwoCartsParams { position, speed, sensor: Sensor::Position });
        assert!(frame.difference >= position.abs() - 1e-14 && frame.difference > 0.0);
        assert_eq!((frame.rank, frame.unseen), (2, None));
        assert_eq!(frame.readings, frame.positions);
    }
}

#[test]
fn another_speed_parts_the_strips_of_both_sensors() {
    for sensor in [Sensor::Velocity, Sensor::Position] {
        let frame = of(TwoCartsParams { position: 0.0, speed: 0.5, sensor });
        // At the end of 16 half seconds: the difference of the speeds, or 4 m.
        assert_eq!(frame.difference, if sensor == Sensor::Velocity { 0.5 } else { 4.0 });
    }
}

#[test]
fn both_carts_are_pushed_alike_and_the_first_ends_where_it_began() {
    let frame = of(TwoCartsParams::default());
    assert_eq!((frame.positions[0][0], frame.positions[0][8], frame.positions[0][16]), (0.0, 4.0, 0.0));
    for (first, second) in frame.positions[0].iter().zip(&frame.positions[1]) {
        assert_eq!(second - first, 1.0);
    }
}

#[test]
fn bad_parameters_of_the_two_carts_are_refused_by_name() {
    let default = TwoCartsParams::default();
    let refused = |params| TwoCarts::new(params).expect_err("refused");
    assert_eq!(refused(TwoCartsParams { position: 2.1, ..default }).argument, "position");
    assert_eq!(refused(TwoCartsParams { speed: f64::INFINITY, ..default }).code, Code::NotFinite);
}
