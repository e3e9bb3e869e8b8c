//! Noise and delays that a log tells: of the car, and of a drive that is made up with known ones.

use estimate::Code;
use estimate::drive::{BySensor, Fit, FitResult, Fitted, Settings};
use robot_log::parse;

const CAR: &str = include_str!("../../../content/logs/car.csv");
const MOWER: &str = include_str!("../../../content/logs/plaza1.csv");

fn fitted(text: &str, settings: Settings) -> FitResult {
    let drive = parse(text).expect("a log").drive;
    let mut fit = Fit::new(&drive, settings).expect("readings");
    while fit.step(&drive).expect("a replay") {}
    fit.found()
}

fn of(found: &FitResult, which: Fitted) -> (f64, Option<f64>) {
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
fn the_speed_s_delay_alone_is_found_within_its_own_sigma() {
    let every = BySensor { fix: 1.0, ..BySensor::all(0.0) };
    let settings = Settings { sigma_distance: 0.3, sigma_turn: 0.03, start_sigma: 1.0, every, ..Settings::default() };
    let drive = parse(CAR).expect("a log").drive;
    let mut fit = Fit::only(&drive, settings, &[Fitted::DelaySpeed]).expect("readings");
    while fit.step(&drive).expect("a replay") {}
    let found = fit.found();
    let (delay, sigma) = of(&found, Fitted::DelaySpeed);
    assert!(found.settled && found.numbers.len() == 1);
    assert!((delay - 0.58).abs() < sigma.expect("told"), "{delay} {sigma:?}");
    let gain = found.log_likelihood[1] - found.log_likelihood[0];
    assert!((gain - 148.0).abs() < 2.0, "{gain}");
    let none = Fit::only(&drive, settings, &[Fitted::Scale]).expect_err("a log without ranges");
    assert_eq!(none.code, Code::Limit);
}

#[test]
fn the_mower_tells_the_scale_of_its_ranges() {
    let drive = parse(MOWER).expect("a log").drive;
    let mut fit = Fit::only(&drive, Settings::default(), &[Fitted::Scale]).expect("readings");
    while fit.step(&drive).expect("a replay") {}
    let (scale, sigma) = of(&fit.found(), Fitted::Scale);
    assert!((scale - 0.0701).abs() < 0.002 && sigma.expect("told") < 0.002, "{scale} {sigma:?}");
}

#[test]
fn the_turn_of_a_camera_is_found() {
    use core::fmt::Write;
    let mut text = String::from("L,1,6,8\nL,2,-7,5\nG,0,0,0,0\n");
    // The robot drives straight on, and its camera looks 0.1 rad to the right.
    for i in 0..80 {
        let x = 0.1 * f64::from(i);
        let (dx, dy) = if i % 2 == 0 { (6.0 - x, 8.0) } else { (-7.0 - x, 5.0) };
        let wave = 0.02 * (7.0 * f64::from(i)).sin();
        let (range, bearing) = (dx.hypot(dy) + wave, dy.atan2(dx) + 0.1 + wave);
        writeln!(text, "O,{i},{},0\nB,{i},{},{range},{bearing}", if i == 0 { 0.0 } else { 0.1 }, 1 + i % 2)
            .expect("text");
    }
    let drive = parse(&text).expect("a log").drive;
    let mut fit = Fit::only(&drive, Settings::default(), &[Fitted::BearingOffset]).expect("readings");
    while fit.step(&drive).expect("a replay") {}
    let (offset, sigma) = of(&fit.found(), Fitted::BearingOffset);
    assert!((offset - 0.1).abs() < 0.01 && sigma.expect("told") < 0.05, "{offset} {sigma:?}");
}

#[test]
fn a_log_without_readings_is_refused() {
    let drive = parse("V,0,1,0\nV,9,1,0\n").expect("a log").drive;
    assert_eq!(Fit::new(&drive, Settings::default()).expect_err("nothing to count").code, Code::Limit);
    let drive = parse("V,0,1,0\nP,1,1,0\nV,3,1,0\n").expect("a log").drive;
    assert!(Fit::new(&drive, Settings::default()).is_err(), "its only fix is the start");
}

#[test]
fn without_turn_rates_delays_are_counted_from_the_speed_s() {
    let delays = |letters: &str| {
        let kept: Vec<&str> = CAR.lines().filter(|row| row.starts_with(|first| letters.contains(first))).collect();
        let drive = parse(&kept.join("\n")).expect("a log").drive;
        let found = Fit::new(&drive, Settings::default()).expect("readings").found();
        found.numbers.iter().map(|(number, ..)| *number).filter(|number| number.is_delay()).collect::<Vec<_>>()
    };
    assert_eq!(delays("STP"), [Fitted::DelaySpeed, Fitted::DelayFix]);
    assert_eq!(delays("SP"), [Fitted::DelayFix]);
    assert_eq!(delays("TP"), [Fitted::DelayFix]);
}

#[test]
fn a_sigma_at_the_least_that_is_tried_is_not_told() {
    // The wheels count without any noise, the fixes are a third of a metre off.
    let mut text = String::from("O,0,0,0\n");
    let (mut x, mut y, mut theta) = (0.0_f64, 0.0_f64, 0.0_f64);
    for i in 1..400 {
        let (distance, turn) = (0.1, 0.03 * (f64::from(i) / 40.0).sin());
        x += distance * theta.cos();
        y += distance * theta.sin();
        theta += turn;
        text += &format!("O,{},{distance},{turn}\n", f64::from(i) / 10.0);
        if i % 5 == 0 {
            let off = |much: f64| 0.3 * (f64::from(i) * much).sin() * std::f64::consts::SQRT_2;
            text += &format!("P,{},{},{}\n", f64::from(i) / 10.0, x + off(12.9898), y + off(78.233));
        }
    }
    let found = fitted(&text, Settings::default());
    for which in [Fitted::SigmaDistance, Fitted::SigmaTurn] {
        let (sigma, told) = of(&found, which);
        assert!(sigma < 0.02 && told.is_none(), "{which:?} {sigma} {told:?}");
    }
    let (fix, told) = of(&found, Fitted::SigmaFix);
    assert!((fix - 0.3).abs() < 0.05 && told.is_some_and(|it| it < 0.2), "{fix} {told:?}");
    // The greatest that is about as likely as all smaller ones costs half a unit of the log-likelihood.
    let drive = parse(&text).expect("a log").drive;
    let at = |which| of(&found, which).0;
    assert_eq!(found.at_most.len(), 2, "{:?}", found.at_most);
    for (which, most) in &found.at_most {
        let mut settings = Settings { sigma_fix: at(Fitted::SigmaFix), ..Settings::default() };
        settings.delays.fix = at(Fitted::DelayFix);
        (settings.sigma_distance, settings.sigma_turn) = (at(Fitted::SigmaDistance), at(Fitted::SigmaTurn));
        let of = if *which == Fitted::SigmaTurn { &mut settings.sigma_turn } else { &mut settings.sigma_distance };
        assert!(*most > *of);
        *of = *most;
        let mut there = Fit::only(&drive, settings, &[Fitted::SigmaFix]).expect("readings");
        there.step(&drive).expect("a replay");
        let fall = found.log_likelihood[1] - there.found().log_likelihood[0];
        assert!((0.3..0.51).contains(&fall), "{which:?} at most {most}: {fall}");
    }
}
