//! Logs as others write them: what is guessed, what is read, and where a fault is. The files are made up.

mod opened;

use estimate::Landmark;
use estimate::drive::{Event, Motion};
use opened::files;
use proptest::prelude::*;

#[path = "../../../tests/src/draws.rs"]
mod draws;
use robot_log::{Error, Files, Role, Understood};

/// The five files of a small drive in the form of the UTIAS MRCLAM data sets: robot 1 sees landmarks 6 and 7 and robot
/// 2.
const MRCLAM: [(&str, &str); 5] = [
    (
        "Robot1_Odometry.dat",
        "# UTIAS Multi-Robot Cooperative Localization and Mapping Dataset\n\
         # Time [s]    forward velocity [m/s]    angular velocity[rad/s]\n\
         1248272263.0 \t  0.100 \t  0.000\n\
         1248272263.5   \t 0.100   0.200\n\
         1248272264.0 \t  0.000 \t  0.000\n",
    ),
    (
        "Robot1_Measurement.dat",
        "# Time [s]    Subject #    range [m]    bearing [rad]\n\
         1248272263.2 \t 63 \t 2.000 \t 0.100\n\
         1248272263.4 \t 14 \t 1.000 \t 0.200\n\
         1248272263.6 \t 25 \t 3.000 \t -0.300\n\
         1248272263.8 \t 99 \t 3.000 \t -0.300\n",
    ),
    ("Barcodes.dat", "# Subject #    Barcode #\n 2   \t 14\n 6   \t 63\n 7   \t 25\n"),
    (
        "Landmark_Groundtruth.dat",
        "# Subject #    x [m]    y [m]    x std-dev [m]    y std-dev [m]\n\
         6 \t 2.0 \t 0.5 \t 0.0001 \t 0.0002\n 7 \t 3.0 \t -1.0 \t 0.0001 \t 0.0002\n",
    ),
    (
        "Robot1_Groundtruth.dat",
        "# Time [s]    x [m]    y [m]    orientation [rad]\n\
         1248272262.9 \t 0.10 \t 0.20 \t 0.300\n1248272264.1 \t 0.20 \t 0.20 \t 0.400\n",
    ),
];

fn roles(files: &Files) -> Vec<Role> {
    files.files().iter().map(robot_log::File::role).collect()
}

fn read(of: &[(&str, &str)]) -> Understood {
    files(of).read().expect("sound")
}

/// Asserts that the files are refused in `file` at `[line, column]` with `words` in the message.
fn assert_refused(files: &Files, file: usize, at: [u32; 2], words: &str) {
    let error: Error = files.read().expect_err(words);
    assert_eq!((error.file, [error.line, error.column]), (file, at), "{error}");
    assert!(error.message.contains(words), "{error}");
}

#[test]
fn the_five_files_of_mrclam_are_understood_as_they_are() {
    let mut order = MRCLAM;
    for turn in 0..5 {
        order.rotate_left(1);
        let files = files(&order);
        for (file, (name, _)) in files.files().iter().zip(order) {
            let wanted = match name {
                "Robot1_Odometry.dat" => Role::Velocities,
                "Robot1_Measurement.dat" => Role::Sightings,
                "Barcodes.dat" => Role::Barcodes,
                "Landmark_Groundtruth.dat" => Role::Landmarks,
                _ => Role::Truth,
            };
            assert_eq!((file.role(), file.asks()), (wanted, Vec::new()), "{name}, turn {turn}");
            let usual =
                file.units().iter().flatten().all(|unit| ["s", "m", "rad", "m/s", "rad/s"].contains(&unit.name));
            assert!(usual, "{name}: {:?}", file.units());
        }
        let Understood { log, notes, .. } = files.read().expect("sound");
        assert_eq!(log.drive.landmarks, [Landmark { id: 6, x: 2.0, y: 0.5 }, Landmark { id: 7, x: 3.0, y: -1.0 }]);
        let events: Vec<Event> = log.drive.rows.iter().map(|row| row.event).collect();
        assert_eq!(
            events,
            [
                Event::Velocity { v: 0.1, omega: 0.0 },
                Event::RangeBearing { landmark: 0, range: 2.0, bearing: 0.1 },
                Event::Velocity { v: 0.1, omega: 0.2 },
                Event::RangeBearing { landmark: 1, range: 3.0, bearing: -0.3 },
                Event::Velocity { v: 0.0, omega: 0.0 },
            ]
        );
        assert_eq!((log.drive.motion, log.drive.truth.poses()[0].theta), (Motion::EvenVelocity, 0.3));
        assert_eq!(
            notes,
            ["1 reading left out: no list has the barcode.", "1 reading left out: another robot was seen."]
        );
    }
}

#[test]
fn names_of_columns_say_what_is_in_them_and_in_which_unit() {
    let wheels = "stamp_ms,linear speed [mm/s],yaw_rate (deg/s)\n1000,500,90\n1100,500,-90\n";
    let radios = "\"Time (s)\";\"beacon\";\"dist_cm\"\n1.05;4;250\n";
    let map = "id\teast\tnorth\n4.0\t1.5\t2.5\n";
    let truth = "t,x,y\n1.0,0,0\n1.2,0.3,0.3\n";
    let files = files(&[("a.csv", wheels), ("b.csv", radios), ("c.tsv", map), ("truth.csv", truth)]);
    assert_eq!(roles(&files), [Role::Velocities, Role::Sightings, Role::Landmarks, Role::Truth]);
    let Understood { log, notes, .. } = files.read().expect("sound");
    let rows: Vec<(f64, Event)> = log.drive.rows.iter().map(|row| (row.time, row.event)).collect();
    assert_eq!(
        rows,
        [
            (1.0, Event::Velocity { v: 0.5, omega: 90_f64.to_radians() }),
            (1.05, Event::Range { landmark: 0, range: 2.5 }),
            (1.1, Event::Velocity { v: 0.5, omega: -90_f64.to_radians() }),
        ]
    );
    assert_eq!(log.drive.landmarks, [Landmark { id: 4, x: 1.5, y: 2.5 }]);
    assert!((log.drive.truth.poses()[0].theta - 45_f64.to_radians()).abs() < 1e-15, "from the way of the truth");
    assert_eq!(notes.len(), 1, "{notes:?}");
}

#[test]
fn numbers_without_names_are_asked_and_can_be_corrected() {
    let mut files = files(&[("run.csv", "0,0.1,30\n20,0.2,-45\n40,0.2,10\n")]);
    assert_eq!(roles(&files), [Role::Undecided]);
    assert_refused(&files, 0, [0, 0], "run.csv asks: Its columns have no names");
    assert!(files.set_role(0, Role::Odometry));
    assert_eq!(files.files()[0].header(), ["column 1", "column 2", "column 3"]);
    assert_eq!(files.files()[0].columns(), [Some(0), Some(1), Some(2), None, None]);
    for (value, unit) in [("time", "ms"), ("turn", "deg"), ("distance", "cm")] {
        assert!(files.set_unit(0, value, unit));
    }
    let drive = files.read().expect("sound").log.drive;
    assert_eq!(
        (drive.rows[1].time, drive.rows[1].event),
        (0.02, Event::Odometry { distance: 0.002, turn: (-45_f64).to_radians() })
    );
    assert!(files.set_column(0, "distance", Some(0)) && files.set_unit(0, "distance", "m"));
    assert_eq!(
        files.read().expect("sound").log.drive.rows[1].event,
        Event::Odometry { distance: 20.0, turn: (-45_f64).to_radians() }
    );
    assert!(
        !files.set_column(0, "distance", Some(3))
            && !files.set_column(0, "v", None)
            && !files.set_column(1, "time", None)
    );
    assert!(!files.set_unit(0, "time", "m") && !files.set_unit(1, "distance", "m") && !files.set_role(1, Role::Log));
    // What was refused has changed nothing.
    assert_eq!(files.files()[0].columns(), [Some(0), Some(0), Some(2), None, None]);
}

#[test]
fn times_in_small_units_are_known_by_how_far_apart_they_are() {
    for (gap, unit) in [(0.05, "s"), (50.0, "ms"), (50_000.0, "us"), (5e7, "ns"), (2.0, "s")] {
        let rows: String = (0..20).map(|i| format!("{},0.1,0.1\n", 1e9 + gap * f64::from(i))).collect();
        let files = files(&[("run.csv", &format!("time,v,omega\n{rows}"))]);
        assert_eq!(files.files()[0].units()[0].map(|unit| unit.name), Some(unit), "a gap of {gap}");
    }
}

#[test]
fn a_log_in_the_books_own_format_is_read_as_before() {
    let text = "# mine\nL,7,3.0,4.0\nO,0.5,0.1,0.02\nR,0.5,7,4.9\n";
    let Understood { log, notes, .. } = read(&[("mine.csv", text)]);
    assert_eq!((Ok(log), notes.len()), (robot_log::parse(text), 0));
    for (text, at, words) in [
        ("O;0;1;0\n", [1, 1], "';' was found"),
        ("\"O\",0,1,0\n", [1, 1], "quoted"),
        ("O,0,1,0\nQ,1\n", [2, 1], "no row's letter"),
        ("\0\0\u{1}PNG", [1, 1], "control character"),
        ("", [1, 1], "the file is empty"),
        ("L,1,0,0\n", [1, 1], "no motion"),
    ] {
        assert_refused(&files(&[("mine.csv", text)]), 0, at, words);
    }
}

#[test]
fn a_log_without_landmarks_is_dead_reckoning() {
    let Understood { log, notes, .. } =
        read(&[MRCLAM[0], ("seen.csv", "time,landmark,range\n1248272263.2,6,2\n1248272263.3,7,2\n")]);
    assert_eq!((log.drive.rows.len(), log.drive.landmarks.len()), (3, 0));
    assert!(notes[0].starts_with("2 readings left out") && notes[0].contains("dead reckoning"), "{notes:?}");
}

#[test]
fn a_fault_in_a_table_is_told_with_its_file_line_and_column() {
    let motion = ("wheels.csv", "time,v,omega\n0,1,0\n1,1,0\n");
    let map = ("map.csv", "id,x,y\n1,0,0\n");
    let refused = |file: usize, text: &str, at, words| {
        assert_refused(&files(&[motion, map, ("seen.csv", text)]), file, at, words);
    };
    let seen = "time_s,landmark,range\n0.5,1,2\n";
    refused(2, &format!("{seen}0.6,1,x\n"), [3, 7], "range is 'x'");
    refused(2, &format!("{seen}0.6,1,-2\n"), [3, 7], "at least 0");
    refused(2, &format!("{seen}0.6, 1.5 ,1\n"), [3, 6], "whole number");
    refused(2, &format!("{seen}0.6,9,1\n"), [3, 5], "no landmark 9");
    refused(2, &format!("{seen}\n# a comment\n0.6,1\n"), [5, 6], "has 2 fields; 3 were expected");
    refused(2, &format!("{seen}0.6,1,1,4\n"), [3, 9], "has 4 fields");
    refused(2, &format!("{seen}1e12,1,1\n"), [3, 1], "times within");
    refused(2, &format!("{seen}0.6,\u{1},1\n"), [3, 5], "control character");
    let mut files = files(&[motion, map]);
    assert!(files.set_column(0, "v", None));
    assert_refused(&files, 0, [1, 1], "no column has been chosen for v");
    assert!(files.set_role(0, Role::Unused));
    assert_refused(&files, 0, [0, 0], "wheels.csv is not used, map.csv is read as landmarks");
}

#[test]
fn where_no_file_has_the_motion_each_is_told_with_what_it_was_read_as() {
    let [_, seen, codes, map, truth] = MRCLAM;
    let message = "the robot's motion is missing: Robot1_Measurement.dat is read as sightings, Barcodes.dat is read \
        as barcodes, \
                   Landmark_Groundtruth.dat is read as landmarks, Robot1_Groundtruth.dat is read as truth; \
                   a file of velocities, of odometry or of encoders was expected";
    let error = files(&[seen, codes, map, truth]).read().expect_err("no motion");
    assert_eq!((error.line, error.column, error.to_string().as_str()), (0, 0, message));
    // A log in the book's own format beside a table: neither has a row that stands for both.
    assert_refused(
        &files(&[("mine.csv", "L,6,3,4\n"), truth]),
        0,
        [0, 0],
        "mine.csv has no rows of motion, Robot1_Ground",
    );
    assert_refused(
        &files(&[("diary.txt", "Dear diary,\ntoday it drove.\n")]),
        0,
        [0, 0],
        "missing: diary.txt is not used;",
    );
}

#[test]
fn a_file_that_is_not_used_is_told() {
    let Understood { notes, .. } = read(&[("diary.txt", "Dear diary,\ntoday it drove.\n"), MRCLAM[0]]);
    assert_eq!(notes, ["diary.txt is not used."]);
}

#[test]
fn a_sighting_of_no_landmark_is_refused_in_the_books_own_format_also_without_any_landmark() {
    let text = "O,1,0,0\nR,0.7,8,4.9\n";
    let error = robot_log::parse(text).expect_err("no landmark");
    assert_refused(
        &files(&[("mine.csv", text)]),
        0,
        [2, 7],
        "there is no landmark 8; a landmark that is seen needs a row",
    );
    assert_eq!(files(&[("mine.csv", text)]).read(), Err(error));
}

proptest! {
    #![proptest_config(draws::cases(256))]

    #[test]
    fn no_text_makes_the_reading_of_files_panic(
        name in draws::text("abz.csv_", 20), role in 0_usize..Role::ALL.len(),
        texts in prop::collection::vec(draws::text("tx,;\t\n #0123456789.", 120), 1..4),
    ) {
        let mut files = files(&texts.iter().map(|text| (name.as_str(), text.as_str())).collect::<Vec<_>>());
        let _ = files.read();
        files.set_role(0, Role::ALL[role].0);
        let _ = files.read();
    }

    #[test]
    fn a_spoilt_table_is_read_or_refused_at_a_line_that_there_is(
        (which, text) in (0_usize..5).prop_flat_map(|which| (Just(which), draws::spoilt(MRCLAM[which].1))),
    ) {
        let mut some = MRCLAM;
        some[which].1 = &text;
        if let Err(error) = files(&some).read() {
            prop_assert!(error.line as usize <= some[error.file].1.split('\n').count(), "{error}");
        }
    }

    /// The files of a drive cut anywhere: what is read is a part of the whole.
    #[test]
    fn truncated_tables_are_a_part_of_the_whole_or_refused(which in 0_usize..5, cut in 0_usize..300) {
        let whole = read(&MRCLAM).log;
        let mut some = MRCLAM;
        some[which].1 = &some[which].1[..cut.min(some[which].1.len())];
        if let Ok(part) = files(&some).read() {
            prop_assert!(part.log.count <= whole.count && part.log.drive.rows.len() <= whole.drive.rows.len());
        }
    }
}
