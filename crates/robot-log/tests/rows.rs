//! Rows of several sensors, as they are read and in the order in which they are kept.

use estimate::drive::{Event, Motion};
use robot_log::{Files, parse};

const CAR: &str = include_str!("../../../content/logs/car.csv");

#[test]
fn each_letter_is_its_event() {
    let log = parse("S, 0, 10.5\nT,0,-0.04\nV,1,2,0.1\nP,2,3,-4\nP,2,3,-4,0.5\nH,3,-1.5\nH,3,7,0.1\n").expect("sound");
    let events: Vec<Event> = log.drive.rows.iter().map(|row| row.event).collect();
    assert_eq!(
        events,
        [
            Event::Speed { v: 10.5 },
            Event::TurnRate { omega: -0.04 },
            Event::Velocity { v: 2.0, omega: 0.1 },
            Event::Position { x: 3.0, y: -4.0, sigma: None },
            Event::Position { x: 3.0, y: -4.0, sigma: Some(0.5) },
            Event::Heading { theta: -1.5, sigma: None },
            Event::Heading { theta: 7.0, sigma: Some(0.1) },
        ]
    );
    assert_eq!((log.drive.motion, log.count), (Motion::Velocity, 7));
}

#[test]
fn rows_are_kept_by_time_motion_before_readings_and_know_their_lines() {
    let log = parse("P,1,0,0\nG,0,0,0,0\nT,1,0.2\n\nS,1,2\nH,0.5,0\n").expect("sound");
    let order: Vec<(f64, u32)> = log.drive.rows.iter().map(|row| (row.time, row.line)).collect();
    assert_eq!(order, [(0.5, 3), (1.0, 1), (1.0, 2), (1.0, 0)]);
}

#[test]
fn lines_go_on_from_file_to_file() {
    let mut files = Files::default();
    files.add("speeds.csv", "S,0,1\nS,1,1\n").expect("a log");
    files.add("fixes.csv", "P,1,1,0\nP,0,0,0\n").expect("a log");
    let rows = files.read().expect("sound").log.drive.rows;
    assert_eq!(rows.iter().map(|row| row.line).collect::<Vec<_>>(), [0, 3, 1, 2]);
}

#[test]
fn the_car_has_the_rows_that_its_notice_says() {
    let log = parse(CAR).expect("sound");
    let count = |kind: fn(&Event) -> bool| log.drive.rows.iter().filter(|row| kind(&row.event)).count();
    assert_eq!(count(|event| matches!(event, Event::TurnRate { .. })), 10_549);
    assert_eq!(count(|event| matches!(event, Event::Speed { .. })), 2051);
    assert_eq!(count(|event| matches!(event, Event::Position { sigma: None, .. })), 2067);
    assert_eq!((log.count, log.drive.truth.poses().len()), (14_667, 0));
}
