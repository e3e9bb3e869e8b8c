//! What files hold that would be read wrong in silence: counters that wrap, rows of two robots, variances, and ranges
//! by which a sensor says that it has none.

mod opened;

use estimate::drive::Event;
use opened::files;
use robot_log::{Counting, Files, Frame, Role, Understood};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/logs");
const WHEELS: &str = "time,v,omega\n0,1,0\n1,1,0\n";

fn library(name: &str) -> Files {
    let text = std::fs::read_to_string(format!("{FOLDER}/{name}")).expect(name);
    files(&[(name, &text)])
}

fn with(mut files: Files, others: &[(&str, &str)]) -> Files {
    others.iter().for_each(|(name, text)| files.add(name, text).expect(name));
    files
}

fn distances(read: &Understood) -> Vec<f64> {
    let distance = |event: &Event| if let Event::Odometry { distance, .. } = event { Some(*distance) } else { None };
    read.log.drive.rows.iter().filter_map(|row| distance(&row.event)).collect()
}

fn wheels(files: &mut Files, counting: Counting) {
    for (name, number) in [("ticks", 1000.0), ("radius", 0.1), ("base", 0.4)] {
        assert!(files.set_wheel(0, name, number), "{name}");
    }
    assert!(files.set_counting(0, counting));
}

#[test]
fn counters_of_16_bits_are_counted_on_over_their_end_and_it_is_said() {
    let mut encoders = library("encoders-16-bit.csv");
    wheels(&mut encoders, Counting::Total);
    let read = encoders.read().expect("sound");
    // 145 and 152 ticks in a row.
    let step = (145.0 + 152.0) / 2.0 * core::f64::consts::TAU / 1000.0 * 0.1;
    assert!(distances(&read).iter().all(|distance| (distance - step).abs() < 1e-12), "{:?}", distances(&read));
    assert!(read.notes.iter().any(|note| note.contains("begin anew after 65536 ticks, 2 times")), "{:?}", read.notes);
}

#[test]
fn a_jump_that_no_motion_makes_is_asked_and_may_be_a_new_start() {
    let count = |i: i32| if i < 20 { 40_000 + 150 * i } else { 150 * (i - 20) };
    let rows: String = (0..30).map(|i| format!("{},{},{}\n", 50 * i, count(i), count(i))).collect();
    let mut encoders = files(&[("encoders.csv", &format!("time_ms,left_ticks,right_ticks\n{rows}"))]);
    wheels(&mut encoders, Counting::Total);
    let asked = encoders.read().expect_err("a jump").message;
    assert!(asked.contains("In line 22 \u{201c}left_ticks\u{201d} jumps from 42850 to 0"), "{asked}");
    assert!(encoders.set_counting(0, Counting::Restarted));
    let distances = distances(&encoders.read().expect("sound"));
    let step = 150.0 * core::f64::consts::TAU / 1000.0 * 0.1;
    assert_eq!(distances.len(), 28, "one less for the first row, and one for the jump");
    assert!(distances.iter().all(|distance| (distance - step).abs() < 1e-12), "{distances:?}");
}

#[test]
fn rows_of_two_tags_are_asked_and_only_one_s_are_read() {
    let anchors = ("anchors.csv", "id,x,y\nA1,0,0\nA2,5,0\nA3,0,5\n");
    let mut tags = with(library("uwb-two-tags.csv"), &[("wheels.csv", WHEELS), anchors]);
    let asked = tags.read().expect_err("whose rows?").message;
    assert!(asked.contains("\u{201c}T7\u{201d} in 6 rows, \u{201c}T9\u{201d} in 5 rows"), "{asked}");
    assert!(!tags.set_only(0, Some("T8")) && !tags.set_only(1, None) && tags.set_only(0, Some("T7")));
    let ranges = |read: &Understood| read.log.drive.rows.iter().filter(|row| !row.event.is_motion()).count();
    let read = tags.read().expect("sound");
    assert_eq!(ranges(&read), 6);
    assert!(read.notes.iter().any(|note| note.ends_with("whose tag is T7 are read; 5 are not.")), "{:?}", read.notes);
    assert!(tags.set_only(0, None));
    assert_eq!(ranges(&tags.read().expect("sound")), 11);
    // A column that holds a value of the file tells nothing apart, and one of a single tag does not ask.
    let one = files(&[("uwb.csv", "t,tag,anchor,range\n0,7,1,5\n1,7,2,5\n")]);
    assert!(one.files()[0].several().is_none() && one.files()[0].asks().is_empty());
}

#[test]
fn ranges_that_were_not_read_are_left_out_counted_and_said() {
    let anchors = ("anchors.csv", "id,x,y\n1,0,0\n2,5,0\n3,0,5\n");
    let read = with(library("uwb-no-reading.csv"), &[("wheels.csv", WHEELS), anchors]).read().expect("sound");
    assert_eq!(read.log.drive.rows.iter().filter(|row| !row.event.is_motion()).count(), 6);
    for wanted in [
        "2 readings without a number left out.",
        "2 ranges of \u{2212}1 are left out",
        "1 range of 0 is left out",
        "1 range of infinity is left out",
    ] {
        assert!(read.notes.iter().any(|note| note.contains(wanted)), "{wanted}: {:?}", read.notes);
    }
    let ranges = |cell: &str| {
        let text = format!("t,landmark,range\n0,1,5\n1,2,{cell}\n");
        files(&[("ranges.csv", &text), ("wheels.csv", WHEELS), anchors]).read()
    };
    assert!(ranges("-1").is_ok());
    let noise = ranges("-0.4").expect("noise beside a landmark").notes;
    assert!(noise.iter().any(|note| note.contains("1 range below 0 left out")), "{noise:?}");
    assert_eq!(ranges("-1.4").expect_err("below 0").line, 3);
    assert_eq!(ranges("abc").expect_err("no number").line, 3);
    let motion = files(&[("wheels.csv", "time,v,omega\n0,1,0\n1,nan,0\n")]).read();
    assert_eq!(motion.expect_err("motion has to be there").line, 3);
}

#[test]
fn a_variance_is_read_as_its_root() {
    let text = "time,latitude,longitude,position_covariance0\n0,48,11,0.25\n1,48,11.00001,0.25\n2,48,11.00002,0\n";
    let mut fixes = files(&[("gps.csv", text), ("wheels.csv", WHEELS)]);
    let sigmas = |files: &Files| -> Vec<Option<f64>> {
        let rows = files.read().expect("sound").log.drive.rows;
        let own = |event: &Event| if let Event::Position { sigma, .. } = event { Some(*sigma) } else { None };
        rows.iter().filter_map(|row| own(&row.event)).collect()
    };
    assert_eq!(sigmas(&fixes), [Some(0.5), Some(0.5), None], "of 0 the setting is taken");
    assert!(fixes.set_unit(0, "sigma", "m"));
    assert_eq!(sigmas(&fixes), [Some(0.25), Some(0.25), None]);
}

/// Fixes in latitude and longitude, 11.1 m apart to the north, and the truth of the same way from an origin of its own.
const GLOBAL: &str = "time [s],latitude,longitude\n10,50,8\n20,50.0001,8\n";
/// Motion for as long.
const DRIVEN: &str = "time [s],v,omega\n0,1,0\n30,1,0\n";
const TRUTH: &str = "time [s],true_x,true_y\n0,400,795\n10,400,800\n20,400,811\n";

#[test]
fn a_truth_in_metres_beside_latitudes_is_asked_for_its_origin_and_can_be_moved() {
    let mut log = files(&[("wheels.csv", DRIVEN), ("gps.csv", GLOBAL), ("truth.csv", TRUTH)]);
    let asked = log.read().expect_err("another origin").message;
    assert!(asked.contains("truth.csv asks: Its places are in metres, the positions are in latitude"), "{asked}");
    assert!(log.files()[2].is_foreign() && !log.set_frame(1, Frame::Same), "only the truth is asked");
    assert!(log.set_frame(2, Frame::Moved));
    let read = log.read().expect("sound");
    let poses: Vec<[f64; 2]> = read.log.drive.truth.poses().iter().map(|pose| [pose.x, pose.y]).collect();
    assert_eq!(poses, [[0.0, -5.0], [0.0, 0.0], [0.0, 11.0]], "its place at the time of the first fix lies there");
    let said = |what: &str| read.notes.iter().any(|note| note.contains(what));
    assert!(said("The truth is moved by \u{2212}400.00 m along x and \u{2212}800.00 m along y"), "{:?}", read.notes);
    assert!(said("so that it lies on the first position: what that is off by is in every error"), "{:?}", read.notes);
    assert!(log.set_frame(2, Frame::Same));
    assert_eq!(log.read().expect("sound").log.drive.truth.poses()[1].x, 400.0);
    assert!(log.set_role(2, Role::Unused));
    assert!(log.read().expect("sound").log.drive.truth.poses().is_empty());
    let global = "time [s],true_latitude,true_longitude\n0,50,8\n10,50.0001,8\n";
    let turned = files(&[("wheels.csv", DRIVEN), ("gps.csv", "t,gps_x,gps_y\n0,0,0\n"), ("truth.csv", global)]);
    let asked = turned.read().expect_err("another origin").message;
    assert!(
        asked.contains("truth.csv asks: Its places are in latitude and longitude, the positions are in metres"),
        "{asked}"
    );
    // Nothing is asked of those that are counted alike.
    let metric = files(&[("wheels.csv", DRIVEN), ("gps.csv", "t,gps_x,gps_y\n0,0,0\n"), ("truth.csv", TRUTH)]);
    assert!(metric.read().is_ok() && !metric.files()[2].is_foreign());
}

#[test]
fn landmarks_and_fixes_in_metres_beside_latitudes_are_asked_for_their_origin() {
    let log = [("wheels.csv", DRIVEN), ("gps.csv", GLOBAL), ("landmarks.csv", "id,x,y\n1,3,4\n")];
    let asked = files(&log).read().expect_err("another origin").message;
    assert!(asked.contains("landmarks.csv asks: Its places are in metres, others are in latitude"), "{asked}");
    let notes = files(&[log[0], log[2]]).read().expect("sound").notes;
    assert!(!notes.iter().any(|note| note.contains("east and north")), "{notes:?}");
    // Where it was said, the fixes are counted from it.
    let mut log = files(&log);
    assert!(log.files()[2].is_beside() && log.files()[2].asks().len() == 1 && !log.files()[1].is_beside());
    assert!(!log.set_frame(2, Frame::Moved) && log.set_origin(2, 49.9999, 8.0));
    let read = log.read().expect("sound");
    let north = read.log.drive.rows.iter().find_map(|row| match row.event {
        Event::Position { y, .. } => Some(y),
        _ => None,
    });
    assert!(north.is_some_and(|north| (north - 11.12).abs() < 0.01), "{north:?}");
    assert!(read.notes.iter().any(|note| note.contains("north of 49.99990\u{b0} N, 8.00000\u{b0} E; if its")));
    assert!(log.set_frame(2, Frame::Same) && log.files()[2].asks().is_empty());
    assert!(log.read().expect("sound").notes.iter().any(|note| note.contains("of the first fix, 50.0")));
}

#[test]
fn a_first_fix_that_is_farther_from_the_truth_than_that_reaches_is_said() {
    let notes = |fix: &str| {
        let gps = format!("time [s],gps_x,gps_y\n10,{fix}\n");
        files(&[("wheels.csv", WHEELS), ("gps.csv", &gps), ("truth.csv", TRUTH)]).read().expect("sound").notes
    };
    let said = |notes: &[String]| notes.iter().any(|note| note.contains("The first fix is 894 m from the truth: are"));
    assert!(said(&notes("0,0")), "{:?}", notes("0,0"));
    assert!(!notes("402,790").iter().any(|note| note.contains("from the truth")));
}
