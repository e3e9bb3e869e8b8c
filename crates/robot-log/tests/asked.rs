//! What is said first of files that make no log yet: what is missing, what is wrong in a row, and then what is asked.

mod opened;

use opened::files;
use robot_log::{Counting, Error, Files, Role};

fn library(name: &str) -> Files {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/logs");
    files(&[(name, &std::fs::read_to_string(format!("{folder}/{name}")).expect(name))])
}

fn refused(files: &Files) -> Error {
    files.read().expect_err("no log yet")
}

/// Rows of motion, of which one far down has a word where a number was.
fn wheels(broken: bool) -> String {
    let row = |i: u32| format!("{:.1},1,{}\n", f64::from(i) / 10.0, if broken && i == 398 { "abc" } else { "0.1" });
    format!("time,v,omega\n{}", (0..500).map(row).collect::<String>())
}

#[test]
fn a_row_that_is_wrong_far_down_is_said_before_another_file_s_question_and_at_its_file() {
    let compass = ("compass.csv", "time_s,heading_deg\n0,10\n1,12\n");
    let both = files(&[compass, ("wheels.csv", &wheels(true))]);
    let error = refused(&both);
    assert_eq!((error.file, error.line, error.column), (1, 400, 8), "{error}");
    assert_eq!(both.files()[1].fault().expect("row 400").line, 400);
    assert!(both.files()[0].fault().is_none() && !both.files()[0].asks().is_empty(), "its question stays");
    // Of a file that asks, what no answer changes is looked at too.
    let own = "time_s,heading_deg\n0,10\n1,1o\n";
    let error = refused(&files(&[("compass.csv", own), ("wheels.csv", &wheels(false))]));
    assert_eq!((error.file, error.line, error.column), (0, 3, 3), "{error}");
    let short = "t,x,y,z\n0,1,2,3\n1,2,3\n";
    let error = refused(&files(&[("wheels.csv", &wheels(false)), ("track.csv", short)]));
    assert_eq!((error.file, error.line), (1, 3), "{error}");
    // What may stand there is no fault: no heading, a date, a name, a list of ranges.
    for (name, text) in [
        ("compass.csv", "time_s,heading_deg\n0,10\n1,\n2,nan\n"),
        ("compass.csv", "time,heading_deg\n2026-05-01T12:00:00Z,10\n2026-05-01T12:00:01Z,12\n"),
        ("uwb.csv", "t,anchor,range\n0,kitchen,5000\n1,hall,6000\n"),
        ("uwb.csv", "time,destination_id,distance\n0,\"(7, 9)\",\"(5000, 6000)\"\n1,\"(7, 9)\",\"(5000, 6000)\"\n"),
    ] {
        let asks = files(&[(name, text), ("wheels.csv", &wheels(false))]);
        assert!(!asks.files()[0].asks().is_empty(), "{text}");
        assert_eq!(refused(&asks).line, 0, "{text}: {}", refused(&asks));
    }
}

#[test]
fn a_motion_that_is_missing_is_said_before_what_the_files_ask() {
    // A receiver whose course may be in radians or in degrees, and that has no speed.
    let px4 = library("px4-sdlog2-gps.csv");
    assert!(!px4.files()[0].asks().is_empty(), "its question stays");
    let error = refused(&px4);
    assert!(error.message.starts_with("the robot's motion is missing: px4-sdlog2-gps.csv has neither"), "{error}");
    let track = library("east-north-sigma.csv");
    assert!(refused(&track).message.contains("what east-north-sigma.csv is has to be said"), "{}", refused(&track));
    // Poses may be what the robot has reckoned.
    let poses = library("tum-trajectory.txt");
    assert!(refused(&poses).message.contains("tum-trajectory.txt asks: Are x and y"), "{}", refused(&poses));
    // With the motion beside it, what is asked is asked; and what may be the motion is asked at once.
    let mut both = px4;
    both.add("wheels.csv", &wheels(false)).expect("a file");
    assert!(refused(&both).message.contains("px4-sdlog2-gps.csv asks: In which unit"));
    assert!(refused(&files(&[("run.csv", "0,1,2\n1,1,2\n")])).message.contains("run.csv asks: Its columns"));
    let pose = "t,x,y,v,omega\n0,1,2,1,0\n1,1,2,1,0\n";
    assert!(refused(&files(&[("run.csv", pose)])).message.contains("run.csv asks: Are x and y"));
}

#[test]
fn parts_of_a_file_in_another_order_are_read_by_their_times_as_if_they_stood_in_it() {
    let table = |parts: [std::ops::Range<i32>; 2]| {
        let row = |i: i32| format!("{:.1},{},{}\n", f64::from(i) / 10.0, 100 * i + 7 * (i % 3), 101 * i);
        format!("time_s,left_ticks,right_ticks\n{}", parts.into_iter().flatten().map(row).collect::<String>())
    };
    let read = |text: &str| {
        let mut encoders = files(&[("encoders.csv", text)]);
        for (name, number) in [("ticks", 1000.0), ("radius", 0.1), ("base", 0.4)] {
            assert!(encoders.set_wheel(0, name, number), "{name}");
        }
        assert!(encoders.set_counting(0, Counting::Total));
        encoders.read()
    };
    let [plain, exchanged] = [table([0..100, 100..200]), table([100..200, 0..100])].map(|text| read(&text));
    let (plain, exchanged) = (plain.expect("in order"), exchanged.expect("exchanged"));
    assert_eq!(plain.log.drive.rows, exchanged.log.drive.rows, "no count jumps where the parts meet");
    assert!(plain.notes.is_empty(), "{:?}", plain.notes);
    let note = "encoders.csv: its rows are in another order than their times: those from line 102 on, 0 to 9.9 s";
    assert!(exchanged.notes[0].starts_with(note), "{:?}", exchanged.notes);
    assert_eq!(exchanged.notes.len(), 1, "{:?}", exchanged.notes);
    let second = read(&table([0..200, 0..100])).expect_err("a second run");
    assert!(second.line == 202 && second.message.contains("a second run is another log"), "{second}");
}

#[test]
fn of_wheels_that_say_their_speed_no_count_is_asked() {
    let needs = |unit: &str| {
        let mut wheels = files(&[("wheels.csv", "time_s,left,right\n0,1,1\n0.1,1,1\n")]);
        assert!(wheels.set_unit(0, "left", unit) && wheels.set_unit(0, "right", unit));
        wheels.files()[0].needs().join(" ")
    };
    for (unit, wanted) in [
        ("m/s", "base"),
        ("rad/s", "radius base"),
        ("rpm", "radius base"),
        ("km/h", "base"),
        ("mm/s", "base"),
        ("m", "base counting"),
        ("rad", "radius base counting"),
        ("ticks", "ticks radius base counting"),
    ] {
        assert_eq!(needs(unit), wanted, "{unit}");
    }
    assert!(files(&[("compass.csv", "time_s,heading_deg\n0,10\n")]).files()[0].needs().is_empty());
}

#[test]
fn where_the_motion_ends_before_the_log_does_it_is_said_what_is_done_then() {
    let fixes: String = (0..60).map(|i| format!("{i},{i},0\n")).collect();
    let fixes = format!("time_s,gps_x,gps_y\n{fixes}");
    let gyro: String = (0..600).map(|i| format!("{:.1},0.1\n", f64::from(i) / 10.0)).collect();
    let gyro = format!("time_s,gyro_z_radps\n{gyro}");
    let step: String = (0..500).map(|i| format!("{:.1},0.1,0.01\n", f64::from(i) / 10.0)).collect();
    let odometry = format!("time_s,distance_m,turn_rad\n{step}");
    let notes = |all: &[(&str, &str)]| files(all).read().expect("sound").notes.join(" ");
    let held = notes(&[("wheels.csv", &wheels(false)), ("gps.csv", &fixes)]);
    let both = "of the motion is 49.9 s after the first row, and the log goes on to 59 s: the last speed and turn rate";
    assert!(held.contains(both), "{held}");
    // A gyro that goes on alone: the way of the wheels, which became a speed, is held.
    let way = notes(&[("odometry.csv", &odometry), ("gyro.csv", &gyro)]);
    assert!(
        way.contains("The last row of the speed is 49.8 s") && way.contains("goes on to 59.9 s: the last one is held"),
        "{way}"
    );
    let stands = notes(&[("odometry.csv", &odometry), ("gps.csv", &fixes)]);
    assert!(stands.contains("the robot is taken to stand from there on"), "{stands}");
    let whole = notes(&[("wheels.csv", &wheels(false)), ("gps.csv", "time_s,gps_x,gps_y\n0,0,0\n50.5,1,1\n")]);
    assert!(!whole.contains("The last row"), "half a second is none: {whole}");
}

#[test]
fn a_trajectory_of_tum_is_the_truth_or_positions_and_headings_and_a_camera_s_tilt_is_said() {
    let motion = ("wheels.csv", "time,v,omega\n1305031102.1758,1,0\n1305031106,1,0\n");
    let with = |name: &str| {
        let mut track = library(name);
        track.add(motion.0, motion.1).expect("a file");
        track
    };
    let mut track = with("tum-trajectory.txt");
    assert!(track.set_role(0, Role::Sensors));
    let read = track.read().expect("sound");
    let headings = read.log.drive.rows.iter().filter(|row| matches!(row.event, estimate::drive::Event::Heading { .. }));
    assert_eq!(headings.count(), 40);
    assert!(track.set_role(0, Role::Truth));
    let last = *track.read().expect("sound").log.drive.truth.poses().last().expect("poses");
    // The file turns by 0.02 rad in each of its 40 rows, and has four digits.
    assert!((last.x - 1.95).abs() < 1e-12 && (last.theta - 0.78).abs() < 1e-3, "{last:?}");
    let tilted = with("tum-camera-groundtruth.txt").read().expect("sound").notes.join(" ");
    assert!(tilted.contains("its quaternions are tilted by more than 60\u{b0}"), "{tilted}");
    let level = with("tum-groundtruth.txt").read().expect("sound").notes.join(" ");
    assert!(!level.contains("tilted"), "{level}");
}

#[test]
fn of_several_clocks_it_is_said_whose_each_is_and_what_follows() {
    let phone = library("phone-five-clocks.csv");
    let ask = &phone.files()[0].asks()[0];
    for wanted in [
        "\u{201c}locationTimestamp_since1970(s)\u{201d}: 1 Hz, 2 s long, the clock of the positions and the speed",
        "\u{201c}gyroTimestamp_sinceReboot(s)\u{201d}: 10 Hz, 2.3 s long, the clock of the turn rate",
        "\u{201c}loggingTime(txt)\u{201d}: 10 Hz, 2.3 s long;",
    ] {
        assert!(ask.contains(wanted), "{ask}");
    }
    assert!(phone.files()[0].columns()[7].is_none(), "the time of a heading is no heading");
}

#[test]
fn a_heading_in_radians_beside_latitudes_is_asked_where_it_begins() {
    let truth =
        "time_s,true_latitude_deg,true_longitude_deg,true_heading_rad\n0,48.35,11.78,0.65\n1,48.3501,11.78,0.7\n";
    let mut all = files(&[("wheels.csv", &wheels(false)), ("truth.csv", truth)]);
    assert!(refused(&all).message.contains("true_heading_rad"), "{}", refused(&all));
    assert!(all.set_unit(1, "heading", "rad"));
    assert_eq!(all.read().expect("sound").log.drive.truth.poses()[0].theta, 0.65);
    // A course is always counted from north.
    let course = truth.replace("true_heading_rad", "course_rad");
    assert!(files(&[("wheels.csv", &wheels(false)), ("truth.csv", &course)]).read().is_ok());
}

/// A robot that stands at first turns later on: what its gyro reads is looked at to the end.
#[test]
fn a_turn_rate_that_is_too_fast_for_radians_is_asked_wherever_it_stands() {
    let rows = |most: f64| -> String {
        (0..2000).map(|k| format!("{},1,{}\n", f64::from(k) * 0.02, if k < 1500 { 0.01 } else { most })).collect()
    };
    for (most, asked) in [(2.0, false), (9.0, true)] {
        let mut files = Files::default();
        files.add("motion.csv", &format!("t,v,gyro_z\n{}", rows(most))).expect("a table");
        let asks = files.files()[0].asks();
        assert_eq!(asks == ["In which unit is \u{201c}gyro_z\u{201d}?"], asked, "{most}: {asks:?}");
    }
}

/// ArduPilot's file of wheel encoders has the ways of a first and a second wheel, and no ranges to landmarks.
#[test]
fn which_of_two_numbered_wheels_is_on_which_side_is_asked() {
    let ways =
        "TimeUS,Dist0,Qual0,Dist1,Qual1\n1000000,0,100,0,100\n1100000,0.1,100,0.11,100\n1200000,0.2,100,0.22,100\n";
    let mut log = files(&[("WENC.csv", ways)]);
    assert_eq!(log.files()[0].role(), Role::Encoders);
    let asks = log.files()[0].asks();
    assert!(asks.iter().any(|ask| ask.contains("left")) && asks.iter().any(|ask| ask.contains("right")), "{asks:?}");
    assert!(log.set_column(0, "left", Some(1)) && log.set_column(0, "right", Some(3)));
    assert!(log.set_unit(0, "left", "m") && log.set_unit(0, "right", "m") && log.set_wheel(0, "base", 0.5));
    assert!(log.set_counting(0, Counting::Total));
    let read = log.read().expect("motion");
    assert_eq!(read.log.drive.rows.len(), 2, "{:?}", read.log.drive.rows);
    // In another file they are ranges, and what has no place is no dead reckoning where fixes are read.
    let ranges = ways.replace("Qual", "Quality");
    let gps = "TimeUS,Lat,Lng,Spd,GCrs\n1000000,48.1,11.5,1,90\n1200000,48.1,11.5000027,1,90\n";
    let log = files(&[("GPS.csv", gps), ("uwb.csv", &ranges), ("IMU.csv", "TimeUS,GyrZ\n1000000,0\n1200000,0\n")]);
    assert_eq!(log.files()[1].role(), Role::Ranges);
    let notes = log.read().expect("a log").notes;
    assert!(notes.iter().any(|note| note.ends_with("no file says where the landmarks are.")), "{notes:?}");
}

/// A phone writes how accurate its bearing is as it writes the bearing.
#[test]
fn how_accurate_a_heading_is_stands_in_the_heading_s_unit() {
    let unit = |head: &str| {
        let text = format!("time_s,latitude,longitude,{head}\n0,48.1,11.5,350,2\n1,48.1,11.6,10,2\n");
        let log = files(&[("Location.csv", &text)]);
        let at = Role::Sensors.values().iter().position(|it| it.name == "sigma of heading").expect("a value");
        log.files()[0].units()[at].map(|unit| unit.name)
    };
    assert_eq!(unit("bearing,bearingAccuracy"), Some("deg"));
    assert_eq!(unit("bearing,bearingAccuracy_rad"), Some("rad"));
    assert_eq!(unit("bearing,course"), None, "no accuracy is there");
}

#[test]
fn positions_are_known_in_the_languages_of_decimal_commas() {
    for (x, y) in [("Posizione x (cm)", "Posizione y (cm)"), ("posición x (cm)", "posición y (cm)")] {
        let text = format!("tempo (s);{x};{y}\n0,0;100,0;200,0\n0,2;101,5;200,5\n");
        let log = files(&[("carrello.csv", &text)]);
        assert_eq!(log.files()[0].role(), Role::Undecided, "{x}: the truth, or a sensor's");
        assert!(!log.files()[0].asks().is_empty());
    }
}
