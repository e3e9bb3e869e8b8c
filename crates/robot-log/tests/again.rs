//! A table that holds the motion, ranges and positions of a robot is read once for each.

mod opened;

use estimate::drive::Event;
use opened::files;
use robot_log::{Counting, Files, Role};

/// What each file is called, is read as, and is another reading of.
fn read_as(files: &Files) -> Vec<(&str, Role, Option<usize>)> {
    files.files().iter().map(|file| (file.name(), file.role(), file.again())).collect()
}

/// How many rows of motion, ranges and fixes a log has.
fn counts(files: &Files) -> [usize; 3] {
    let read = files.read().expect("sound");
    assert_eq!(read.notes.iter().filter(|note| note.contains("without a number")).count(), 0, "each cell is read");
    let count = |is: fn(&Event) -> bool| read.log.drive.rows.iter().filter(|row| is(&row.event)).count();
    [
        count(Event::is_motion),
        count(|event| matches!(event, Event::Range { .. })),
        count(|event| matches!(event, Event::Position { .. })),
    ]
}

const ANCHORS: (&str, &str) = ("anchors.csv", "id,x,y\n1,0,0\n2,9,0\n");

#[test]
fn ranges_beside_velocities_are_read_and_so_are_the_velocities() {
    let table = ("run.csv", "t,v,omega,range1,range2\n0,1,0,,\n0.1,1,0,5,6\n0.2,1,0.1,,\n0.3,1,0,,6.1\n");
    let files = files(&[table, ANCHORS]);
    let as_read = [("run.csv", Role::Ranges, None), ANCHORS_READ, ("run.csv, its motion", Role::Velocities, Some(0))];
    assert_eq!(read_as(&files), as_read);
    assert_eq!(counts(&files), [4, 3, 0]);
}

const ANCHORS_READ: (&str, Role, Option<usize>) = ("anchors.csv", Role::Landmarks, None);

#[test]
fn columns_that_are_called_as_the_landmarks_are_ranges_beside_velocities_too() {
    let table = ("run.csv", "t,v,omega,north,south\n0,1,0,,\n0.1,1,0,5,6\n");
    let files = files(&[table, ("anchors.csv", "landmark,x,y\nnorth,0,0\nsouth,9,0\n")]);
    assert_eq!(counts(&files), [2, 2, 0]);
    assert_eq!(files.files()[2].name(), "run.csv, its ranges");
}

#[test]
fn rows_of_encoders_without_counts_are_fixes() {
    let table = "t,left_ticks,right_ticks,lat,lon\n0,0,0,,\n0.1,10,12,,\n0.15,,,48.1,11.5\n0.2,20,24,,\n";
    let mut files = files(&[("agv.csv", table)]);
    let as_read = [("agv.csv", Role::Encoders, None), ("agv.csv, its positions", Role::Sensors, Some(0))];
    assert_eq!(read_as(&files), as_read);
    for (name, number) in [("ticks", 100.0), ("radius", 0.1), ("base", 0.4)] {
        assert!(files.set_wheel(0, name, number));
    }
    assert!(files.set_counting(0, Counting::Total));
    assert_eq!(counts(&files), [2, 0, 1]);
    // One of two counts is a fault, and no row of others.
    let faulty = files_of("t,left_ticks,right_ticks,lat,lon\n0,0,0,,\n0.1,10,,,\n");
    assert_eq!(faulty.read().expect_err("a count is missing").line, 3);
}

fn files_of(table: &str) -> Files {
    let mut files = files(&[("agv.csv", table)]);
    for (name, number) in [("ticks", 100.0), ("radius", 0.1), ("base", 0.4)] {
        files.set_wheel(0, name, number);
    }
    files.set_counting(0, Counting::Step);
    files
}

#[test]
fn a_true_track_with_velocities_is_driven_by_them_where_no_other_file_says_how_the_robot_moved() {
    let table = ("sim.csv", "t,v,omega,x_true,y_true,d1,d2\n0,1,0,0,0,5,6\n0.1,1,0,0.1,0,5,6\n");
    let alone = files(&[table, ANCHORS]);
    let names: Vec<&str> = alone.files().iter().map(|file| file.name()).collect();
    assert_eq!(names, ["sim.csv", "anchors.csv", "sim.csv, its truth", "sim.csv, its motion"]);
    assert_eq!(counts(&alone), [2, 4, 0]);
    assert!(alone.read().expect("sound").log.drive.truth.position(0.05).is_some());
    let wheels = ("wheels.csv", "t,v,omega\n0,1,0\n0.1,1,0\n0.2,1,0\n");
    for both in [[table, wheels], [wheels, table]] {
        assert_eq!(counts(&files(&both))[0], 3, "the wheels alone");
    }
}

#[test]
fn places_beside_ranges_are_asked_about_and_their_answer_says_what_drives() {
    let mut files = files(&[("all.csv", "t,v,omega,x,y,d1,d2\n0,1,0,0,0,5,6\n0.1,1,0,0.1,0,5,6\n"), ANCHORS]);
    assert_eq!(files.files().len(), 3);
    assert_eq!(files.files()[2].answers(), [Role::Truth, Role::Sensors, Role::Unused]);
    assert!(files.read().is_err(), "it asks");
    for (answer, wanted) in [(Role::Truth, [2, 4, 0]), (Role::Sensors, [2, 4, 2]), (Role::Unused, [2, 4, 0])] {
        files.set_role(2, answer);
        assert_eq!(counts(&files), wanted, "{answer:?}");
    }
    // Whether the landmarks come first does not matter, nor whether the columns have their names.
    for order in [[0, 1], [1, 0]] {
        let all = [
            ("all.csv", "t,v,omega,x,y,a,b\n0,1,0,0,0,5,6\n0.1,1,0,0.1,0,5,6\n"),
            ("map.csv", "id,x,y\na,0,0\nb,9,0\n"),
        ];
        let named = self::files(&order.map(|i| all[i]));
        let asks = named.files().iter().filter(|file| file.role() == Role::Undecided).count();
        let ranges = named.files().iter().filter(|file| file.role() == Role::Ranges).count();
        assert_eq!((asks, ranges), (1, 1), "{:?}", read_as(&named));
    }
    // A file that is left out is left out whole.
    files.set_role(0, Role::Unused);
    assert_eq!(read_as(&files), [("all.csv", Role::Unused, None), ANCHORS_READ]);
}

#[test]
fn what_asked_whether_it_is_true_is_driven_by_as_well_as_true() {
    let mut files = files(&[("sim.csv", "t,x,y,v,omega\n0,0,0,1,0\n0.1,0.1,0,1,0\n")]);
    assert_eq!(read_as(&files), [("sim.csv", Role::Undecided, None)]);
    files.set_role(0, Role::Truth);
    let as_read = [("sim.csv", Role::Truth, None), ("sim.csv, its motion", Role::Velocities, Some(0))];
    assert_eq!((read_as(&files).as_slice(), counts(&files)), (&as_read[..], [2, 0, 0]));
    files.set_role(0, Role::Sensors);
    assert_eq!((files.files().len(), counts(&files)), (1, [2, 0, 2]));
}

#[test]
fn a_column_is_unread_where_no_reading_of_its_file_has_it() {
    let table = ("run.csv", "t,v,omega,range1,range2,voltage\n0,1,0,5,6,12\n");
    let files = files(&[table, ANCHORS]);
    assert_eq!((files.unread(0), files.unread(2)), (vec![5], Vec::new()));
}

/// The x and y of the truth are those that are called so; the others are a sensor's.
#[test]
fn a_true_pose_beside_a_receivers_is_never_taken_for_it() {
    let rows = "0,1,0,9,9,9,0,0,0\n0.1,1,0,9,9,9,0.1,0,0\n";
    for head in ["t,v,omega,gps_x,gps_y,cog,gt_x,gt_y,gt_yaw", "t,v,omega,fix_x,fix_y,q,x_true,y_true,theta_true"] {
        let text = format!("{head}\n{rows}");
        let files = files(&[("one.csv", &text)]);
        let roles: Vec<Role> = files.files().iter().map(|file| file.role()).collect();
        assert_eq!(roles, [Role::Truth, Role::Sensors], "{head}");
        let truth = files.files()[0].columns();
        assert_eq!(truth[1..4], [Some(6), Some(7), Some(8)], "{head}");
        assert_eq!(counts(&files)[2], 2, "{head}");
        let read = files.read().expect("sound");
        assert!(read.log.drive.truth.position(0.0).is_some_and(|at| at == [0.0, 0.0]), "{head}");
        assert!(
            read.log.drive.rows.iter().all(|row| !matches!(row.event, Event::Heading { theta, .. } if theta == 0.0))
        );
    }
    // A place without a name may be the robot's own reckoning: it is asked about.
    let mut asks = files(&[("one.csv", &format!("t,v,omega,x,y,q,gt_x,gt_y,gt_yaw\n{rows}"))]);
    let answers = [Role::Sensors, Role::Unused];
    assert_eq!((asks.files()[0].role(), asks.files()[1].answers()), (Role::Truth, &answers[..]));
    for (answer, fixes) in [(Role::Sensors, 2), (Role::Unused, 0)] {
        asks.set_role(1, answer);
        assert_eq!(counts(&asks), [2, 0, fixes], "{answer:?}");
    }
}

/// What a filter or a planner has made of a pose is no reading, and a compass beside it is.
#[test]
fn the_heading_of_an_estimate_is_no_compass() {
    for made in ["ekf_yaw_rad", "odom_yaw_rad", "ref_yaw_rad", "est_yaw_deg", "yaw_est"] {
        let text = format!(
            "time,v,omega,lat,lon,compass_rad,ekf_x,ekf_y,{made}\n0,1,0,50,8,0.5,9,9,2\n1,1,0,50,8,0.5,9,9,2\n"
        );
        let files = files(&[("one.csv", &text)]);
        let file = &files.files()[0];
        let heading = file.role().values().iter().position(|value| value.name == "heading").expect("it has one");
        assert_eq!((files.files().len(), file.role(), file.columns()[heading]), (1, Role::Sensors, Some(5)), "{made}");
        assert_eq!(files.unread(0), [6, 7, 8], "{made}");
    }
}

#[test]
fn a_true_latitude_is_the_truth_beside_a_receivers() {
    let text =
        "time,v,omega,lat,lon,compass_rad,true_lat,true_lon\n0,1,0,50,8,0.5,50,8\n1,1,0,50,8.0001,0.5,50,8.0001\n";
    let files = files(&[("one.csv", text)]);
    let as_read = [("one.csv", Role::Sensors, None), ("one.csv, its truth", Role::Truth, Some(0))];
    assert_eq!((read_as(&files).as_slice(), files.unread(0)), (&as_read[..], vec![]));
}
