//! A file whose times do not meet those of the motion is asked what is to be added to them.

use robot_log::{Files, Role};

fn files(named: &[(&str, &str)]) -> Files {
    let mut files = Files::default();
    named.iter().for_each(|(name, text)| files.add(name, text).expect("few and short"));
    files.compare();
    files
}

/// Motion of 100 s from a time on, and fixes of 90 s from another.
fn log(motion: f64, fixes: f64) -> [(&'static str, String); 2] {
    let motion: String = (0..=100).map(|k| format!("{},1,0\n", motion + f64::from(k))).collect();
    let gps: String = (0..=90).map(|k| format!("{},{k},0\n", fixes + f64::from(k))).collect();
    [("wheels.csv", format!("time_s,v,omega\n{motion}")), ("gps.csv", format!("time_s,gps_x,gps_y\n{gps}"))]
}

fn opened(log: &[(&'static str, String)]) -> Files {
    files(&log.iter().map(|(name, text)| (*name, text.as_str())).collect::<Vec<_>>())
}

fn fix_times(files: &Files) -> [f64; 2] {
    let rows = files.read().expect("sound").log.drive.rows;
    let mut times = rows.iter().filter(|row| !row.event.is_motion()).map(|row| row.time);
    [times.next().expect("fixes"), times.next_back().expect("fixes")]
}

#[test]
fn fixes_an_hour_off_are_asked_and_shifted() {
    let mut log = opened(&log(1000.0, 4605.0));
    let asked = log.read().expect_err("another clock").message;
    assert!(asked.starts_with("gps.csv asks: Its times begin 3505.0 s after the motion ends:"), "{asked}");
    let clock = *log.files()[1].other_clock().expect("asked");
    assert_eq!((clock.zone, clock.together), (Some(-3600.0), -3605.0));
    assert!(
        !log.set_clock_shift(0, 1.0)
            && !log.set_clock_shift(1, f64::NAN)
            && !log.set_clock_shift(1, 1e12)
            && !log.set_clock_shift(2, 1.0)
    );
    assert!(log.set_clock_shift(1, -3600.0));
    log.compare();
    assert_eq!((log.files()[1].clock_shift(), log.files()[1].asks().len()), (Some(-3600.0), 0));
    assert_eq!(fix_times(&log), [1005.0, 1095.0]);
    assert!(log.files()[1].follows().contains("1005 to 1095 s"), "{}", log.files()[1].follows());
    // Nothing added is an answer too, and then it is said.
    assert!(log.set_clock_shift(1, 0.0));
    log.compare();
    assert_eq!(fix_times(&log), [4605.0, 4695.0]);
    let notes = log.read().expect("sound").notes;
    assert!(notes.iter().any(|note| note.contains("all before the motion or after it")), "{notes:?}");
    // What was added to times in another unit is not what these need.
    assert!(log.set_clock_shift(1, -3600.0) && log.set_unit(1, "time", "ms") && log.set_unit(1, "time", "s"));
    log.compare();
    assert_eq!((log.files()[1].clock_shift(), log.files()[1].asks().len()), (None, 1));
    assert!(log.set_role(1, Role::Unused));
    log.compare();
    assert_eq!(log.files()[1].clock_shift(), None);
}

#[test]
fn times_that_meet_are_asked_nothing_nor_are_parts_of_one_log() {
    for fixes in [1000.0, 910.0, 1100.0] {
        assert!(opened(&log(1000.0, fixes)).read().is_ok(), "{fixes}");
    }
    assert!(opened(&log(1000.0, 909.0)).read().is_err());
    let [(_, one), _] = log(0.0, 0.0);
    let [(_, two), _] = log(200.0, 0.0);
    assert!(files(&[("one.csv", &one), ("two.csv", &two)]).read().is_ok(), "the second goes on from the first");
    // A gyro of another clock is none of its parts.
    let gyro: String = (0..=100).map(|k| format!("{},0.1\n", 7200 + k)).collect();
    let gyro = files(&[
        ("speed.csv", &one.replace(",0\n", "\n").replace(",omega", "")),
        ("gyro.csv", &format!("time_s,omega\n{gyro}")),
    ]);
    assert!(gyro.files()[0].asks().is_empty(), "{:?}", gyro.files()[0].asks());
    assert_eq!(gyro.files()[1].other_clock().expect("asked").zone, Some(-7200.0));
}

#[test]
fn a_truth_and_ranges_of_another_clock_are_asked_by_themselves() {
    let [wheels, _] = log(0.0, 0.0);
    let truth: String = (0..=100).map(|k| format!("{},{k},0\n", 1.7e9 + f64::from(k))).collect();
    let ranges: String = (0..=100).map(|k| format!("{},1,5\n", 1.8e9 + f64::from(k))).collect();
    let mut log = opened(&[
        wheels,
        ("truth.csv", format!("time_s,true_x,true_y\n{truth}")),
        ("ranges.csv", format!("time_s,landmark,range\n{ranges}")),
        ("landmarks.csv", "landmark,x,y\n1,3,4\n".into()),
    ]);
    assert!(log.files()[3].asks().is_empty(), "landmarks have no times");
    for (at, own) in [(1, 1.7e9), (2, 1.8e9)] {
        let clock = *log.files()[at].other_clock().expect("asked");
        assert_eq!((clock.zone, clock.together), (None, -own));
        assert!(log.set_clock_shift(at, clock.together));
        log.compare();
    }
    let read = log.read().expect("sound").log.drive;
    assert_eq!(read.truth.poses()[0].time, 0.0);
    assert_eq!(read.span(), Some([0.0, 100.0]));
}

#[test]
fn a_time_of_day_goes_on_over_midnight_and_a_file_that_begins_after_it_is_of_another_day() {
    let stamp = |k: i32| format!("{:02}:{:02}:{:02}", k / 3600 % 24, k / 60 % 60, k % 60);
    let from = 24 * 3600 - 50;
    let motion: String = (0..=100).map(|k| format!("{},1,0\n", stamp(from + k))).collect();
    let wheels = ("wheels.csv", format!("time,v,omega\n{motion}"));
    let seen: String = (0..=100).map(|k| format!("{0},1,5\n{0},2,6\n", stamp(from + k))).collect();
    let landmarks = ("landmarks.csv", "landmark,x,y\n1,3,4\n2,0,5\n".to_string());
    let read = opened(&[wheels.clone(), ("seen.csv", format!("time,landmark,range\n{seen}")), landmarks]).read();
    let read = read.expect("sound");
    assert_eq!(read.log.drive.span(), Some([f64::from(from), f64::from(from + 100)]));
    assert!(read.notes.iter().any(|note| note.starts_with("wheels.csv: its times of day pass midnight")));
    let fixes: String = (60..=100).map(|k| format!("{},{k},0\n", stamp(from + k))).collect();
    let mut late = opened(&[wheels, ("gps.csv", format!("time,gps_x,gps_y\n{fixes}"))]);
    assert_eq!(late.files()[1].other_clock().expect("asked").zone, Some(86_400.0));
    assert!(late.set_clock_shift(1, 86_400.0));
    late.compare();
    assert_eq!(fix_times(&late), [f64::from(from + 60), f64::from(from + 100)]);
}
