//! A log that is read otherwise than its files have it.

use estimate::drive::Event;
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
        landmarks: BTreeMap::from([(1, [1.25, 2.0]), (9, [0.0; 2])]),
        ranges: BTreeMap::from([(2, 0.4), (9, 1.0)]),
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
fn what_no_log_can_be_read_by_is_refused() {
    let mut log = files();
    for driven in [[0.0, 1.0], [1.0, -1.0], [f64::NAN, 1.0], [1.0, f64::INFINITY]] {
        assert!(!log.correct(Corrections { driven, ..Corrections::default() }), "{driven:?}");
    }
    assert!(!log.correct(Corrections { landmarks: BTreeMap::from([(1, [f64::NAN, 0.0])]), ..Corrections::default() }));
    assert_eq!(*log.corrections(), Corrections::default());
}
