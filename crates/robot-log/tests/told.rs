//! What a reader is told of files that can be read and would mislead: gaps, doubled rows, two runs in one file, two
//! speeds, and ranges whose columns are called as the landmarks.

mod opened;

use estimate::Landmark;
use estimate::drive::Event;
use opened::files;
use robot_log::{Files, Role, Understood};
use std::fmt::Write;

const FIXES: &str = "t,gps_x,gps_y\n0,0,0\n5,5,0\n";

/// A table with a row for each of these times.
fn table(head: &str, times: impl IntoIterator<Item = f64>, rest: &str) -> String {
    times.into_iter().fold(format!("{head}\n"), |mut text, time| {
        let _ = writeln!(text, "{time:.2},{rest}");
        text
    })
}

fn every(step: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| step * f64::from(i))
}

fn notes(all: &[(&str, &str)]) -> Vec<String> {
    files(all).read().expect("sound").notes
}

fn said(notes: &[String], what: &str) -> bool {
    notes.iter().any(|note| note.contains(what))
}

#[test]
fn a_gap_between_rows_of_motion_is_said_with_what_is_held_meanwhile() {
    let with = |gap: fn(f64) -> bool| table("t,v,omega", every(0.1, 600).filter(|t| !gap(*t)), "1,0.1");
    let long = with(|t| 20.0 < t && t < 50.0);
    let told = notes(&[("wheels.csv", &long), ("gps.csv", FIXES)]);
    assert!(said(
        &told,
        "No rows of motion from 20 to 50 s after the first row: the last speed and turn rate are held"
    ));
    assert!(said(&told, "cut the log at the gap"), "{told:?}");
    let two = with(|t| (20.0 < t && t < 23.0) || (30.0 < t && t < 39.9));
    assert!(said(&notes(&[("wheels.csv", &two)]), "from 30 to 39.9 s after the first row: "));
    assert!(said(&notes(&[("wheels.csv", &two)]), "the longest of 2 such gaps"));
    let steady = with(|t| 20.0 < t && t < 20.9);
    assert!(!said(&notes(&[("wheels.csv", &steady)]), "No rows"), "nine steps are none");
    let ways = table("t,distance,turn", every(0.1, 100).chain([19.9, 20.0]), "0.1,0");
    assert!(said(&notes(&[("odometry.csv", &ways)]), "the row after it is taken for the whole way and turn since"));
}

#[test]
fn a_log_without_turn_rates_or_without_speeds_says_so_and_what_is_taken_instead() {
    let rows = || every(0.1, 60);
    let speeds = notes(&[("wheels.csv", &table("t,speed", rows(), "1")), ("gps.csv", FIXES)]);
    assert!(said(&speeds, "The log has no turn rate: between readings the robot is taken to drive straight on"));
    let turns = notes(&[("gyro.csv", &table("t,gyro_z", rows(), "0.1")), ("gps.csv", FIXES)]);
    assert!(said(&turns, "The log has no speed: between readings the robot is taken to stand"), "{turns:?}");
    let both = notes(&[("wheels.csv", &table("t,v,omega", rows(), "1,0.1")), ("gps.csv", FIXES)]);
    assert!(!said(&both, "The log has no"), "{both:?}");
}

#[test]
fn few_rows_that_are_doubled_or_go_back_are_counted_with_the_line_of_the_first() {
    let doubled =
        table("t,distance,turn", every(0.1, 100).flat_map(|t| [Some(t), (t == 4.0).then_some(t)]).flatten(), "0.1,0");
    let told = notes(&[("odometry.csv", &doubled)]);
    assert!(said(&told, "odometry.csv: 1 row is the one before to the last digit, in line 43: "), "{told:?}");
    let fixes = "t,gps_x,gps_y\n0,0,0\n1,1,0\n1,1,0\n2,2,0\n2,2,0\n3,3,0\n4,4,0\n5,5,0\n6,6,0\n7,7,0\n8,8,0\n9,9,0\n";
    let told = notes(&[("wheels.csv", &table("t,v,omega", every(0.1, 100), "1,0")), ("gps.csv", fixes)]);
    assert!(said(&told, "gps.csv: 2 rows are the one before to the last digit, the first in line 4: "), "{told:?}");
    let back = table("t,v,omega", every(0.1, 50).chain([4.5]).chain(every(0.1, 80).skip(50)), "1,0");
    let told = notes(&[("wheels.csv", &back)]);
    assert!(said(&told, "wheels.csv: 1 time lies before the one above, in line 52. Rows are"), "{told:?}");
    assert_eq!(notes(&[("wheels.csv", &table("t,v,omega", every(0.1, 50), "1,0"))]), Vec::<String>::new());
}

#[test]
fn two_runs_in_one_file_are_refused_at_the_line_where_the_second_begins() {
    let both = table("t,v,omega", every(0.1, 300).chain(every(0.1, 40)), "1,0.1");
    let refused = files(&[("wheels.csv", &both)]).read().expect_err("two runs");
    assert_eq!((refused.line, refused.column), (302, 1));
    assert!(refused.message.contains("goes back here from 29.9 to 0 s"), "{}", refused.message);
    // Rows that came late are one log.
    let late = every(0.1, 200).chain(every(0.1, 110).skip(100)).chain(every(0.1, 300).skip(200));
    files(&[("wheels.csv", &table("t,v,omega", late, "1,0.1"))]).read().expect("one run");
}

fn speeds(read: &Understood) -> usize {
    let is_speed = |event: &Event| matches!(event, Event::Speed { .. } | Event::Velocity { .. });
    read.log.drive.rows.iter().filter(|row| is_speed(&row.event)).count()
}

#[test]
fn of_two_speeds_the_one_beside_the_turn_rate_is_driven_by_and_it_is_said() {
    let wheels = table("t,v,omega", every(0.1, 100), "1,0.1");
    let gps = table("t,gps_x,gps_y,gps_speed_m_s", every(1.0, 10), "1,2,3");
    for all in [[("can.csv", &wheels), ("gps.csv", &gps)], [("gps.csv", &gps), ("can.csv", &wheels)]] {
        let all = all.map(|(name, text)| (name, text.as_str()));
        let at = all.iter().position(|(name, _)| *name == "gps.csv").expect("there");
        let mut files = files(&all);
        let read = files.read().expect("sound");
        assert_eq!(speeds(&read), 100);
        assert!(said(&read.notes, "gps.csv: its speed is not used, as can.csv says how the robot moved"));
        assert!(files.set_column(at, "v", Some(3)));
        let both = files.read().expect("sound");
        assert_eq!(speeds(&both), 110, "a reader may want both");
        assert!(!said(&both.notes, "is not used") && said(&both.notes, "both have a speed"), "{:?}", both.notes);
    }
    let mut asked = files(&[("can.csv", &wheels), ("places.csv", &gps.replace("gps_", ""))]);
    assert!(asked.read().is_err() && asked.set_role(1, Role::Sensors));
    assert_eq!(speeds(&asked.read().expect("sound")), 100, "once it is said what it is");
    let steps = table("t,distance,turn", every(0.1, 100), "0.1,0");
    files(&[("odometry.csv", &steps), ("gps.csv", &gps)]).read().expect("a log moves by one kind");
}

const ANCHORS: &str = "anchor,x_m,y_m\nA2,9,0\nA1,0,0\nK,0,9\n";

fn ranges(read: &Understood) -> Vec<(f64, f64)> {
    let drive = &read.log.drive;
    let range = |event: &Event| match event {
        Event::Range { landmark, range } => {
            let Landmark { x, .. } = drive.landmarks[*landmark];
            Some((x, *range))
        }
        _ => None,
    };
    drive.rows.iter().filter_map(|row| range(&row.event)).collect()
}

#[test]
fn a_wide_table_whose_columns_are_called_as_the_landmarks_is_read() {
    let wheels = table("t,v,omega", every(0.1, 30), "1,0");
    for head in ["t,A1,A2,K", "t,range_A1 [m],range_A2 [m],range_K [m]"] {
        let wide = format!("{head}\n0,1.5,7,0\n1,2.5,6,8\n");
        for order in [[0, 1, 2], [2, 1, 0], [1, 0, 2]] {
            let all = [("wheels.csv", wheels.as_str()), ("uwb.csv", &wide), ("anchors.csv", ANCHORS)];
            let files = files(&order.map(|i| all[i]));
            let read = files.read().expect("sound");
            assert_eq!(ranges(&read), [(0.0, 1.5), (9.0, 7.0), (0.0, 2.5), (9.0, 6.0), (0.0, 8.0)], "{head} {order:?}");
        }
    }
}

#[test]
fn a_wide_table_whose_columns_have_no_known_name_is_asked_and_no_role_is_taken_in_silence() {
    let wheels = table("t,v,omega", every(0.1, 30), "1,0");
    let numbered = "anchor,x_m,y_m\n2,9,0\n1,0,0\n";
    let wide = "t,M1,M2,temp\n0,1.5,7,20\n1,2.5,6,20\n";
    let mut files = files(&[("wheels.csv", &wheels), ("uwb.csv", wide), ("anchors.csv", numbered)]);
    assert!(files.read().expect_err("asked").message.contains("Are its columns the ranges to landmarks"));
    assert!(files.set_role(1, Role::Ranges) && files.set_column(1, "first range", Some(3)));
    let asked = files.read().expect_err("no range").message;
    assert!(asked.contains("\u{201c}temp\u{201d} has no number in its name, and no landmark is called so"), "{asked}");
    assert!(files.set_column(1, "first range", Some(1)));
    assert_eq!(ranges(&files.read().expect("sound")), [(0.0, 1.5), (9.0, 7.0), (0.0, 2.5), (9.0, 6.0)]);
    assert!(files.set_role(1, Role::Unused));
    assert!(said(&files.read().expect("sound").notes, "uwb.csv is not used."));
    // Numbers and names of one landmark cannot be told together.
    let called = "t,range_1,range_2\n0,1.5,7\n1,2.5,6\n";
    let mut others = Files::default();
    for (name, text) in [("wheels.csv", wheels.as_str()), ("anchors.csv", ANCHORS), ("uwb.csv", called)] {
        others.add(name, text).expect(name);
    }
    assert!(others.read().expect_err("numbers").message.contains("has the number 1, where others have names"));
    let none = "t,gps_x,gps_y\n0,,\n1,,\n";
    let told = notes(&[("wheels.csv", &wheels), ("gps.csv", none)]);
    assert!(said(&told, "gps.csv: read as sensors, it has no row that says anything."), "{told:?}");
}

#[test]
fn ticks_of_l_and_r_are_of_the_wheels_and_courses_are_headings_within_half_a_turn() {
    for head in ["t,ticks_l,ticks_r", "t,enc_l,enc_r", "t,l_ticks,r_ticks"] {
        let files = files(&[("wheels.csv", &table(head, every(0.1, 9), "100,200"))]);
        assert_eq!(files.files()[0].role(), Role::Encoders, "{head}");
        assert_eq!(files.files()[0].columns()[1..3], [Some(1), Some(2)], "{head}");
    }
    let courses = "t,gps_x,gps_y,course_deg\n0,0,0,350\n1,1,0,10\n2,2,0,100\n3,3,0,170\n4,4,0,200\n";
    let files = files(&[("gps.csv", courses)]);
    assert!(
        files.files()[0].follows().ends_with("headings \u{2212}110 \u{2026} 100\u{b0}"),
        "{:?}",
        files.files()[0].follows()
    );
}

#[test]
fn what_the_files_call_their_landmarks_is_known_behind_the_numbers() {
    let places = "name,x,y\nA12,0,0\nnorth door,5,5\n";
    let seen = "time,beacon,range\n0,north door,7\n0.1,A12,0.5\n";
    let wheels = "time,v,omega\n0,1,0\n1,1,0\n";
    let read = files(&[("landmarks.csv", places), ("ranges.csv", seen), ("wheels.csv", wheels)]).read().expect("sound");
    let ids: Vec<u32> = read.log.drive.landmarks.iter().map(|it| it.id).collect();
    assert_eq!((ids, read.landmarks), (vec![1, 2], vec!["A12".to_string(), "north door".to_string()]));
    let numbered = files(&[("landmarks.csv", "id,x,y\n7,0,0\n"), ("wheels.csv", wheels)]).read().expect("sound");
    assert_eq!(numbered.landmarks, Vec::<String>::new());
}

#[test]
fn a_file_with_one_of_speed_and_turn_rate_says_which() {
    let asks = |head: &str| files(&[("drive.csv", &table(head, every(0.1, 30), "1,0.1"))]).files()[0].asks();
    assert!(asks("time,speed,widdershins")[0].starts_with("It has a speed, \u{201c}speed\u{201d}, and no column"));
    assert!(asks("time,knolls,yaw_rate")[0].starts_with("It has a turn rate, \u{201c}yaw_rate\u{201d}, and no column"));
}

#[test]
fn samples_of_a_sparse_column_are_values_that_are_there() {
    let mut text = String::from("time,v,omega,gps_x,gps_y,never\n");
    for i in 0..400 {
        let fix = if i % 10 == 3 { format!("{i},#N/A") } else { "#N/A,".into() };
        let _ = writeln!(text, "{},1,0.1,{fix},", f64::from(i) / 10.0);
    }
    let files = files(&[("drive.csv", &text)]);
    let samples = |column: usize| files.files()[0].samples(column);
    assert_eq!((samples(3), samples(0)), (vec!["3", "13", "23"], vec!["0", "10", "19.9"]));
    assert_eq!((samples(4), samples(5)), (vec![""], vec![""]));
}

#[test]
fn what_is_counted_are_lines_and_not_what_they_hold() {
    let head = "time,v,omega,gps_x,gps_y,heading_rad";
    let mut files = files(&[("drive.csv", &table(head, every(0.1, 30), "1,0.1,5,6,0.3"))]);
    assert!(files.set_role(0, Role::Sensors));
    let read = files.read().expect("sound");
    assert_eq!((read.log.count, read.log.drive.rows.len()), (30, 32));
}

#[test]
fn a_gap_between_fixes_that_is_long_beside_their_usual_step_is_said() {
    let wheels = table("t,v,omega", every(0.1, 1200), "1,0.1");
    let fixes = |gap: fn(f64) -> bool| {
        let times = every(0.5, 240).filter(|t| !gap(*t));
        times.fold(String::from("t,gps_x,gps_y\n"), |text, t| format!("{text}{t},{t},0\n"))
    };
    let told = |gap| notes(&[("wheels.csv", &wheels), ("gps.csv", &fixes(gap))]);
    let long = told(|t| 40.0 < t && t < 90.0);
    assert!(said(&long, "No positions from 40 to 90 s after the first row: "), "{long:?}");
    let two = told(|t| (20.0 < t && t < 30.0) || (40.0 < t && t < 60.0));
    assert!(said(&two, "from 40 to 60 s") && said(&two, "the longest of 2 such gaps"), "{two:?}");
    assert_eq!(told(|t| 40.0 < t && t < 45.0), Vec::<String>::new(), "ten steps are none");
}

#[test]
fn columns_that_are_not_read_are_known() {
    let unread = |name: &str, text: &str| {
        let files = files(&[(name, text)]);
        let file = &files.files()[0];
        file.unread().into_iter().map(|at| file.header()[at].clone()).collect::<Vec<_>>()
    };
    assert_eq!(unread("a.csv", "t,v,temp,omega,pressure\n0,1,20,0,5\n1,1,20,0,5\n"), ["temp", "pressure"]);
    assert_eq!(unread("a.csv", "t,v,omega\n0,1,0\n1,1,0\n"), [""; 0]);
    assert_eq!(unread("b.csv", "temp,pressure\n0,1\n1,1\n"), [""; 0], "of a file that is not used all are not");
    let ranges = "t,A1,A2,quality\n0,1,2,9\n1,1,2,9\n";
    let files = files(&[("ranges.csv", ranges), ("anchors.csv", "anchor,x,y\nA1,0,0\nA2,5,0\n")]);
    assert_eq!(files.files()[0].unread(), [3]);
}

#[test]
fn the_question_of_what_a_file_is_names_its_answers() {
    let answers = |text: &str| files(&[("places.csv", text)]).files()[0].answers();
    assert_eq!(answers("t,x,y\n0,1,0\n1,1,0\n"), [Role::Truth, Role::Sensors]);
    assert_eq!(answers("t,v,omega,x,y\n0,1,0,1,0\n1,1,0,1,0\n"), [Role::Truth, Role::Sensors]);
    assert_eq!(answers("t,v,omega\n0,1,0\n1,1,0\n"), []);
    let mut said = files(&[("places.csv", "t,x,y\n0,1,0\n1,1,0\n")]);
    assert!(said.set_role(0, Role::Undecided));
    assert_eq!(said.files()[0].answers(), [], "who has said nothing may mean anything");
}
