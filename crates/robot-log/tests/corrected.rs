//! A log that is read otherwise than its files have it.

use estimate::drive::{Event, gaps_and_end};
use robot_log::{Corrections, Files};
use std::collections::BTreeMap;

const ODOMETRY: &str = "time_s,distance_m,turn_rad\n0,0,0\n1,0.5,0.1\n2,0.4,-0.1\n";
const BEACONS: &str = "landmark,x,y\nA3,1,2\ndoor,4,5\n";
const RANGES: &str = "time_s,landmark,range\n1,A3,2.1\n2,door,6.0\n";

fn files() -> Files {
    let mut files = Files::default();
    for (name, text) in [("odometry.csv", ODOMETRY), ("beacons.csv", BEACONS), ("ranges.csv", RANGES)] {
        files.add(name, text).expect(name);
    }
    files
}

#[test]
fn distances_turns_and_places_are_taken_otherwise_and_that_is_said() {
    let mut log = files();
    let before = log.read().expect("sound");
    assert!(log.correct(Corrections {
        driven: [1.02, 0.5],
        swerve: 0.0,
        landmarks: BTreeMap::from([(1, [1.25, 2.0]), (9, [0.0; 2])]),
        ranges: BTreeMap::from([(2, 0.4), (9, 1.0)]),
        kept: None,
    }));
    let read = log.read().expect("sound");
    let driven: Vec<_> = read.log.drive.rows.iter().filter(|row| row.event.is_motion()).map(|row| row.event).collect();
    assert_eq!(driven[2], Event::Odometry { distance: 1.02 * 0.4, turn: 0.5 * -0.1 });
    let range =
        |row: &estimate::drive::Row| if let Event::Range { range, .. } = row.event { Some(range) } else { None };
    let ranges: Vec<f64> = read.log.drive.rows.iter().filter_map(range).collect();
    assert_eq!(ranges, [2.1, 6.0 - 0.4]);
    let places: Vec<_> = read.log.drive.landmarks.iter().map(|it| [it.x, it.y]).collect();
    assert_eq!(places, [[1.25, 2.0], [4.0, 5.0]]);
    let said: Vec<_> = read.notes.iter().filter(|note| !before.notes.contains(note)).collect();
    assert_eq!(
        said,
        [
            "Distances of odometry are taken 1.0200 times as they are read, and turns 0.5000 times.",
            "Ranges to landmark door are taken 0.400 m shorter than they are read.",
            "Landmark A3 is taken at (1.25, 2.00) m, and not at (1.00, 2.00) m."
        ]
    );
    assert!(log.correct(Corrections::default()));
    assert_eq!(log.read().expect("sound"), before, "as the files have it");
}

#[test]
fn speeds_and_turn_rates_are_taken_otherwise_each_by_its_factor() {
    let mut log = Files::default();
    log.add("odom.csv", "time_s,v,omega\n0,1,0.5\n1,1,0.25\n2,1,-0.5\n").expect("motion");
    let mut by = |driven| {
        assert!(log.correct(Corrections { driven, ..Corrections::default() }));
        let read = log.read().expect("sound");
        let said = read.notes.into_iter().filter(|note| note.contains("as they are read")).collect::<Vec<_>>();
        (read.log.drive.rows.iter().map(|row| row.event).collect::<Vec<_>>(), said)
    };
    let moves = |v: f64, omegas: [f64; 3]| omegas.map(|omega| Event::Velocity { v, omega });
    let (read, said) = by([1.0, 0.5]);
    assert_eq!(read, moves(1.0, [0.25, 0.125, -0.25]));
    assert_eq!(said, ["Turn rates are taken 0.5000 times as they are read."]);
    let (read, said) = by([2.0, 1.0]);
    assert_eq!(read, moves(2.0, [0.5, 0.25, -0.5]));
    assert_eq!(said, ["Speeds are taken 2.0000 times as they are read."]);
    assert_eq!(by([1.0, 1.0]), (moves(1.0, [0.5, 0.25, -0.5]).to_vec(), Vec::new()));

    // So is a speed that stands alone.
    let mut log = Files::default();
    log.add("speed.csv", "time_s,v\n0,2\n1,2\n").expect("a speed");
    log.add("gyro.csv", "time_s,omega\n0.5,0.5\n1.5,0.5\n").expect("a turn rate");
    assert!(log.correct(Corrections { driven: [0.5, 1.0], ..Corrections::default() }));
    let rows = log.read().expect("sound").log.drive.rows;
    assert_eq!(rows.iter().filter(|row| row.event == Event::Speed { v: 1.0 }).count(), 2);
}

/// As of two wheels of which one is larger: in what the factors make of distances, and of speeds.
#[test]
fn turns_are_taken_with_an_angle_for_each_metre() {
    let mut log = files();
    assert!(log.correct(Corrections { driven: [2.0, 0.5], swerve: -0.04, ..Corrections::default() }));
    let read = log.read().expect("sound");
    let driven: Vec<_> = read.log.drive.rows.iter().filter(|row| row.event.is_motion()).map(|row| row.event).collect();
    assert_eq!(driven[2], Event::Odometry { distance: 0.8, turn: 0.5 * -0.1 - 0.04 * 0.8 });
    let said = "On each metre 2.292\u{b0} more to the right is turned than is read.";
    assert!(read.notes.iter().any(|note| note == said), "{:?}", read.notes);

    let mut log = Files::default();
    log.add("odom.csv", "time_s,v,omega\n0,2,0.5\n1,-1,0.25\n2,0,-0.5\n").expect("motion");
    assert!(log.correct(Corrections { swerve: 0.25, ..Corrections::default() }));
    let moves: Vec<_> = log.read().expect("sound").log.drive.rows.iter().map(|row| row.event).collect();
    let v = |(v, omega)| Event::Velocity { v, omega };
    assert_eq!(moves, [(2.0, 1.0), (-1.0, 0.0), (0.0, -0.5)].map(v));

    // A gyro reads no wheels.
    let mut log = Files::default();
    log.add("speed.csv", "time_s,v\n0,2\n1,2\n").expect("a speed");
    log.add("gyro.csv", "time_s,omega\n0.5,0.5\n1.5,0.5\n").expect("a turn rate");
    let before = log.read().expect("sound").log.drive.rows;
    assert!(log.correct(Corrections { swerve: 0.25, ..Corrections::default() }));
    assert_eq!(log.read().expect("sound").log.drive.rows, before);
}

#[test]
fn what_no_log_can_be_read_by_is_refused() {
    let mut log = files();
    for driven in [[0.0, 1.0], [1.0, -1.0], [f64::NAN, 1.0], [1.0, f64::INFINITY]] {
        assert!(!log.correct(Corrections { driven, ..Corrections::default() }), "{driven:?}");
    }
    assert!(!log.correct(Corrections { landmarks: BTreeMap::from([(1, [f64::NAN, 0.0])]), ..Corrections::default() }));
    assert!(!log.correct(Corrections { swerve: f64::NAN, ..Corrections::default() }));
    for kept in [[2.0, 2.0], [2.0, 1.0], [f64::NAN, 1.0], [0.0, f64::INFINITY]] {
        assert!(!log.correct(Corrections { kept: Some(kept), ..Corrections::default() }), "{kept:?}");
    }
    assert_eq!(*log.corrections(), Corrections::default());
}

#[test]
fn a_part_of_a_log_is_read_alone_with_its_truth_and_without_the_gap_beside_it() {
    let mut log = Files::default();
    let moves = |k: i32| format!("{:.1},1,0.1\n", 100.0 + 0.1 * f64::from(k));
    let motion: String = (0..200).filter(|k| *k < 50 || *k >= 120).map(moves).collect();
    let truth: String = (-10..200).map(|k| format!("{:.1},{k},0,0\n", 100.0 + 0.1 * f64::from(k))).collect();
    log.add("odom.csv", &format!("time_s,v,omega\n{motion}")).expect("motion");
    log.add("groundtruth.csv", &format!("time_s,x,y,heading_rad\n{truth}")).expect("truth");
    let whole = log.read().expect("sound");
    let [gap] = gaps_and_end(&whole.log.drive.rows, whole.log.drive.motion)[..] else { panic!("one gap") };
    let near = |found: [f64; 2], wanted: [f64; 2]| found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(near(gap.longest, [4.9, 12.0]) && near(gap.between, [12.0, 19.9]), "{gap:?}");
    assert!(log.correct(Corrections { kept: Some(gap.between), ..Corrections::default() }));
    let part = log.read().expect("sound");
    let drive = &part.log.drive;
    assert!(near(drive.span().expect("rows"), [112.0, 119.9]) && drive.rows.len() == 80);
    assert_eq!((drive.truth.poses().len(), drive.truth.poses()[0].x), (80, 120.0));
    assert_eq!(whole.log.count - part.log.count, 50 + 130);
    assert!(gaps_and_end(&drive.rows, drive.motion).is_empty());
    let said = |notes: &[String], of: &str| notes.iter().any(|note| note.contains(of));
    assert!(said(&whole.notes, "No rows of motion from 4.9 to 12 s") && !said(&part.notes, "No rows of motion"));
    assert!(said(&part.notes, "The log is read from 12.0 to 19.9 s after its first row."));
    // Where nothing moves, nothing is cut.
    assert!(log.correct(Corrections { kept: Some([6.0, 11.0]), ..Corrections::default() }));
    let all = log.read().expect("sound");
    assert_eq!(all.log, whole.log);
    assert!(said(&all.notes, "No motion lies from 6.0 to 11.0 s after the first row: all of the log is read."));
}
