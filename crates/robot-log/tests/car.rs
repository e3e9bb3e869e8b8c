//! The log of a car with speeds, turn rates and fixes, each at its own time, against an independent replay's numbers.

use estimate::drive::{BySensor, Course, Delays, Drive, Replay, Settings, Smoothed, Summary};
use robot_log::parse;

/// The settings of the reference.
fn settings() -> Settings {
    Settings {
        sigma_distance: 0.3,
        sigma_turn: 0.03,
        sigma_fix: 1.0,
        start_sigma: 1.0,
        start_sigma_heading: 0.1,
        ..Settings::default()
    }
}

fn car() -> Drive {
    parse(include_str!("../../../content/logs/car.csv")).expect("the log is sound").drive
}

fn replayed(settings: Settings) -> Summary {
    let drive = car();
    let course = Course::new(&drive, settings).expect("sound settings");
    let mut replay = Replay::new(&course);
    while replay.take(&drive, &course).expect("a sound row").is_some() {}
    assert_eq!(replay.rows() as usize, drive.rows.len());
    let smoothed = Smoothed::new(&drive, &course, &replay, 1).expect("factored");
    smoothed.told(replay.summary(&course))
}

#[test]
fn print() {
    let second = Settings { every: BySensor { fix: 1.0, ..BySensor::default() }, ..settings() };
    let delayed = Settings { delays: Delays { speed: 0.5, ..Delays::default() }, ..second };
    let learned = Settings { learn_speed: true, learn_bias: true, ..delayed };
    for s in [
        settings().reckoning(),
        settings(),
        second,
        delayed,
        learned,
        Settings { gate: BySensor::all(Some(0.999)), ..learned },
    ] {
        let r = replayed(s);
        println!("{} {} {:?} {:?} {:?} {}", r.used, r.refused, r.nis, r.log_likelihood, r.speed_scale, r.x);
    }
    for s in [second, delayed] {
        println!("{:?}", replayed(Settings { withheld: Some([100.0, 130.0]), ..s }).withheld);
    }
}
