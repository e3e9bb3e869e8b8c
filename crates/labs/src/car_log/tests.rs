use super::*;

fn of(params: CarParams) -> CarFrame {
    let log = robot_log::parse(include_str!("../../../../content/logs/car.csv")).expect("the car's");
    CarLog::new_on(log.drive, params)
}

impl CarLog {
    fn new_on(drive: Drive, params: CarParams) -> CarFrame {
        CarLog::start(Arc::new(LoggedDrive::new(drive)), params).expect("in reach").frame()
    }
}

fn near(value: Option<f64>, expected: f64) {
    let value = value.expect("said");
    assert!((value - expected).abs() < 1e-6, "{value} {expected}");
}

#[test]
fn the_replays_are_those_of_the_reference() {
    let open = CarParams::default();
    let all = of(CarParams { fixes: CarFixes::All, ..open });
    assert_eq!((all.used, all.refusals), (2067, 0));
    near(all.nis, 0.633428672);
    near(all.log_likelihood, -5331.045830071);
    let second = of(open);
    assert_eq!(second.used, 205);
    near(second.nis, 2.923664776);
    near(second.log_likelihood, -1076.425374044);
    let delayed = of(CarParams { delay: 0.5, ..open });
    near(delayed.nis, 2.214565029);
    near(delayed.log_likelihood, -931.043172562);
    let learned = of(CarParams { delay: 0.5, learn: true, ..open });
    near(learned.log_likelihood, -887.382748554);
    near(learned.learned.map(|it| it.speed_scale), 0.025213565);
    let gated = of(CarParams { delay: 0.5, learn: true, gate: true, ..open });
    assert_eq!((gated.used, gated.refusals), (162, 43));
    near(gated.log_likelihood, -564.862994548);
}

#[test]
fn the_smoother_closes_the_tunnel() {
    let tunnel = of(CarParams { tunnel: true, ..CarParams::default() }).tunnel.expect("withheld");
    assert_eq!(tunnel.rows, 311);
    near(Some(tunnel.rms), 27.580167947);
    near(Some(tunnel.worst), 48.340891009);
    near(tunnel.rms_smoothed, 9.355070341);
    near(tunnel.worst_smoothed, 13.977784991);
}

#[test]
fn the_curve_has_its_maximum_at_half_a_second() {
    let log = robot_log::parse(include_str!("../../../../content/logs/car.csv")).expect("the car's");
    let lab = CarLog::start(Arc::new(LoggedDrive::new(log.drive)), CarParams::default()).expect("in reach");
    let at = |delay: f64| lab.likelihood(delay).expect("in reach");
    assert_eq!(Some(at(0.0)), lab.frame().log_likelihood);
    assert!(at(0.58) > at(0.5) && at(0.58) > at(0.66) && at(0.58) - at(0.0) > 147.0);
    assert_eq!(lab.likelihood(2.5).expect_err("too long").argument, "delay");
}

#[test]
fn a_log_by_distances_is_replayed_as_it_is() {
    let log = robot_log::parse(include_str!("../../../../content/logs/plaza1.csv")).expect("the mower's");
    let frame = CarLog::new_on(log.drive, CarParams { delay: 1.0, learn: true, ..CarParams::default() });
    assert!(frame.learned.is_none() && frame.estimate.len() > 10);
}
