//! Noise and delays that a log tells: of the car, and of a drive that is made up with known ones.

use estimate::Code;
use estimate::drive::{BySensor, Fit, Fitted, Found, Settings};
use robot_log::parse;

const CAR: &str = include_str!("../../../content/logs/car.csv");

fn fitted(text: &str, settings: Settings) -> Found {
    let drive = parse(text).expect("a log").drive;
    let mut fit = Fit::new(&drive, settings).expect("readings");
    while fit.step(&drive).expect("a replay") {}
    fit.found()
}

fn of(found: &Found, which: Fitted) -> (f64, Option<f64>) {
    let number = found.numbers.iter().find(|(number, ..)| *number == which).expect("among them");
    (number.1, number.2)
}

#[test]
fn the_car_tells_that_its_speed_is_half_a_second_late() {
    let every = BySensor { fix: 1.0, ..BySensor::all(0.0) };
    let settings = Settings { sigma_distance: 0.3, sigma_turn: 0.03, start_sigma: 1.0, every, ..Settings::default() };
    let found = fitted(CAR, settings);
    // The turn rate's delay is held at 0; what the reference's maximum at 0.58 s tells is how much later than the fixes
    // the speed is.
    let [(speed, sigma), (fix, _)] = [Fitted::DelaySpeed, Fitted::DelayFix].map(|which| of(&found, which));
    assert!((speed - fix - 0.58).abs() < 0.1 && sigma.expect("told") < 0.15, "{speed} {fix} {sigma:?}");
    assert!(found.settled && found.log_likelihood[1] - found.log_likelihood[0] > 148.0);
}

#[test]
fn a_log_without_readings_is_refused() {
    let drive = parse("V,0,1,0\nV,9,1,0\n").expect("a log").drive;
    assert_eq!(Fit::new(&drive, Settings::default()).expect_err("nothing to count").code, Code::Limit);
    let drive = parse("V,0,1,0\nP,1,1,0\nV,3,1,0\n").expect("a log").drive;
    assert!(Fit::new(&drive, Settings::default()).is_err(), "its only fix is the start");
}
