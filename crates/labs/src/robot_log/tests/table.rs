//! The tables of a replay.

use super::*;

/// A table that is taken `n` rows at a time.
fn table(logged: &Arc<LoggedDrive>, params: LogParams, kind: LogTableKind, n: u32) -> String {
    let mut table = LogTable::new(Arc::clone(logged), params, kind).expect("sound parameters");
    let mut text = String::new();
    while let Some(part) = table.next(n).expect("a sound log") {
        text.push_str(&part);
    }
    text
}

#[test]
fn a_table_has_a_row_for_each_motion_or_sighting_and_ends_where_the_replay_ends() {
    let plaza = plaza();
    let params = LogParams { gate: BySensor::all(Some(0.999)), learn: true, ..LogParams::default() };
    let lab = whole(&plaza, params);
    let track = table(&plaza, params, LogTableKind::Track, 1_000_000);
    assert_eq!(track, table(&plaza, params, LogTableKind::Track, 777), "however it is cut");
    let numbers = |line: &str| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect::<Vec<f64>>();
    let last = numbers(track.lines().last().expect("rows"));
    let (pose, p) = (lab.replay.pose(), lab.replay.covariance());
    assert_eq!(track.lines().count(), 1 + 13_186 - 3529);
    assert_eq!(last[1..4], [pose.x(), pose.y(), pose.theta()], "to the last bit");
    assert_eq!(last[8], p[(3, 3)].sqrt());
    let sightings = table(&plaza, params, LogTableKind::Innovations, 5000);
    let rows: Vec<Vec<f64>> = sightings.lines().skip(1).map(numbers).collect();
    let refused = rows.iter().filter(|row| row[12] == 0.0).count();
    assert_eq!((rows.len(), refused), (3529, lab.summary().refused as usize));
    assert!(rows.iter().all(|row| (row[3] - row[4] - row[5]).abs() < 1e-9), "innovation is range less expected");
    assert!(
        table(&plaza, LogParams::default(), LogTableKind::Track, 10).lines().all(|line| line.split(',').count() == 11)
    );
}

#[test]
fn the_innovations_of_all_sensors_are_in_their_table() {
    let log = "L,4,9,1\nV,0,1,0\nP,0,0.5,0.25\nH,1,0.125\nR,1,4,8\nB,2,4,7,0.25\nP,2,2,0.5\n";
    let text = table(&logged(log), LogParams::default(), LogTableKind::Innovations, 3);
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert!(rows.iter().all(|row| row.len() == text.lines().next().map_or(0, |head| head.split(',').count())));
    let sensors: Vec<&str> = rows.iter().map(|row| row[1]).collect();
    assert_eq!(sensors, ["fix", "heading", "range", "bearing", "fix"]);
    // After the last of the log's readings the estimate is where the replay ends.
    let lab = whole(&logged(log), LogParams::default());
    let (pose, p) = (lab.replay.pose(), lab.replay.covariance());
    let after: Vec<f64> = rows[4][13..].iter().map(|it| it.parse().expect("a number")).collect();
    assert_eq!(after[..3], [pose.x(), pose.y(), pose.theta()]);
    assert_eq!(after[3..], [0, 1, 2].map(|i| p[(i, i)].sqrt()));
    // From the origin: the first fix is expected there, and the robot drives along x.
    assert_eq!(rows[0][3..6], ["0.5", "0", "0.5"]);
    assert_eq!(rows[0][7..10], ["0.25", "0", "0.25"]);
    assert_eq!((rows[2][2], rows[2][7], rows[1][2]), ("4", "", ""), "only sightings have a landmark");
    let second = |row: &Vec<&str>| -> Vec<f64> { row[7..10].iter().map(|it| it.parse().expect("a number")).collect() };
    for row in [&rows[3], &rows[4]] {
        let [measured, expected, nu] = second(row)[..] else { panic!("three numbers") };
        assert!((measured - expected - nu).abs() < 1e-12);
    }
}

#[test]
fn a_table_that_meets_a_bad_row_stays_where_it_was() {
    let logged = logged("L,1,0,5\nO,1,1,0\nR,1,1,5\nO,2,1e300,0\nR,2,1,5\n");
    let mut table = LogTable::new(logged, LogParams::default(), LogTableKind::Track).expect("sound parameters");
    assert!(table.next(2).is_ok_and(|part| part.is_some_and(|part| part.lines().count() == 2)));
    let first = table.next(2).expect_err("too large");
    assert_eq!(table.next(2).expect_err("still too large").code, first.code);
}

#[test]
fn a_log_that_is_written_reads_as_the_same_log_and_replays_to_the_same_bits() {
    let mixed = "G,0,1e-300,0.1,-0.25\nP,2,2,0.5\nL,4,9,1\nV,0,1,0\nP,0,0.5,0.25,3\nH,1.5,0.125,0.1\nR,1,4,8\n\
                 B,2,4,7,0.25\nS,1,0.30000000000000004\nT,1,-1e22\nH,1,0.2\n";
    let params = LogParams { learn: true, delay_sighting: 0.5, delay_heading: 0.5, ..LogParams::default() };
    for logged in [plaza(), logged(mixed)] {
        let text = table(&logged, params, LogTableKind::Log, 7);
        let read = robot_log::parse(&text).expect("a log");
        assert_eq!(read.count, text.lines().count());
        let (was, is) = (logged.drive(), &read.drive);
        assert_eq!((&is.landmarks, &is.truth, is.motion), (&was.landmarks, &was.truth, was.motion));
        let told = |drive: &estimate::drive::Drive| drive.rows.iter().map(|it| (it.time, it.event)).collect::<Vec<_>>();
        assert_eq!(told(is), told(was));
        let again = Arc::new(LoggedDrive::new(read.drive));
        let ends = |of: &Arc<LoggedDrive>| table(of, params, LogTableKind::Track, 1000);
        assert_eq!(ends(&again), ends(&logged), "what is late is taken in the same order");
    }
}
