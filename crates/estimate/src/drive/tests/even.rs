//! Odometry that is driven evenly: a reading between two rows meets the estimate on its way.

use super::*;

/// A winding way by odometry at 2 Hz, of 20 s, with readings at the offset after each row.
fn winding(motion: Motion, after: f64) -> Drive {
    let mut rows = Vec::new();
    for k in 0..40 {
        let time = 0.5 * f64::from(k);
        rows.push((time, odometry(0.4 + 0.1 * libm::sin(time), 0.1 * libm::cos(0.4 * time))));
        rows.push((time + after, Event::Range { landmark: 0, range: 9.0 + libm::cos(time) }));
        rows.push((time + after, Event::Heading { theta: 0.1 * time, sigma: Some(0.3) }));
    }
    drive(motion, &[[0.0, 0.0, 0.0, 0.1]], &rows)
}

/// The pose after each row.
fn poses(drive: &Drive, settings: Settings) -> Vec<SE2> {
    let course = Course::new(drive, settings).expect("sound settings");
    let (mut replay, mut poses) = (Replay::new(&course), Vec::new());
    while replay.take(drive, &course).expect("sound rows").is_some() {
        poses.push(replay.pose());
    }
    poses
}

#[test]
fn readings_at_the_rows_of_odometry_meet_a_robot_that_turns_on_its_way_to_the_last_bit() {
    let of = |motion, arcs| {
        let log = winding(motion, 0.0);
        let otherwise = course::Otherwise { arcs, ..course::Otherwise::default() };
        let course = Course::new(&log, Settings::default()).expect("sound settings").with(&log, otherwise);
        let mut replay = Replay::new(&course);
        while replay.take(&log, &course).expect("sound rows").is_some() {}
        (replay.pose(), replay.covariance(), replay.summary(&course))
    };
    assert_eq!(of(Motion::EvenOdometry, false), of(Motion::Odometry, true));
}

#[test]
fn a_circle_of_few_rows_is_met_between_them_to_within_its_chords() {
    // A radius of 2 m in steps of 0.1 rad, and a heading read at a third of each.
    let rows = (0..60).flat_map(|k| {
        let time = f64::from(k);
        let step = if k == 0 { odometry(0.0, 0.0) } else { odometry(0.2, 0.1) };
        [(time, step), (time + 1.0 / 3.0, Event::Heading { theta: 0.0, sigma: None })]
    });
    let log = drive(Motion::EvenOdometry, &[], &rows.collect::<Vec<_>>());
    let dark = Settings { headings: false, ..Settings::default() };
    for pose in poses(&log, dark) {
        let radius = numerics::hypot(pose.x(), pose.y() - 2.0);
        assert!((radius - 2.0).abs() < 2.0 * 0.1 * 0.1 / 8.0, "{radius}");
    }
}

#[test]
fn a_reading_between_two_rows_meets_its_share_of_the_way_and_the_rest_is_driven_at_the_next() {
    let dark = Settings { sightings: false, headings: false, ..Settings::default() };
    for (after, share) in [(0.125, 0.25), (0.25, 0.5), (0.375, 0.75)] {
        let log = winding(Motion::EvenOdometry, after);
        let [even, stood] = [log.clone(), Drive { motion: Motion::Odometry, ..log }].map(|log| poses(&log, dark));
        for rows in even.windows(4).zip(stood.windows(4)).step_by(3) {
            let (way, whole) = rows;
            let ([from, there, _, to], [start, held, _, end]) = (way, whole) else { unreachable!("windows of four") };
            assert_eq!(start, held, "the estimate of the other stands");
            // The turn is on the way, so the ways are bent otherwise.
            let turn = end.theta() - start.theta();
            assert!((there.theta() - from.theta() - share * turn).abs() < 1e-12, "{after}");
            let gone = |a: &SE2, b: &SE2| numerics::hypot(b.x() - a.x(), b.y() - a.y());
            assert!((gone(from, there) - share * gone(start, end)).abs() < 1e-12, "{after}");
            assert!((to.theta() - end.theta()).abs() < 1e-12 && gone(from, to) < gone(start, end) + 1e-12, "{after}");
        }
    }
}

#[test]
fn behind_the_last_row_it_stands_and_before_the_first_nothing_is_known() {
    let at = |time| (time, Event::Heading { theta: 0.0, sigma: None });
    let rows = [at(0.0), at(0.5), (1.0, odometry(1.0, 0.0)), at(1.5), (2.0, odometry(3.0, 0.0)), at(2.5)];
    let x: Vec<f64> =
        poses(&drive(Motion::EvenOdometry, &[], &rows), Settings::default()).iter().map(|pose| pose.x()).collect();
    assert_eq!(x, [0.0, 0.0, 1.0, 2.5, 4.0, 4.0]);
}

#[test]
fn a_filter_that_starts_on_the_way_drives_what_is_left_of_it() {
    let rows = [(0.0, odometry(9.0, 0.0)), (1.0, odometry(2.0, 0.0)), (2.0, odometry(1.0, 0.0))];
    let log = drive(Motion::EvenOdometry, &[[0.25, 5.0, 0.0, 0.0]], &rows);
    let (replay, _) = replayed(&log, Settings::default());
    assert!((replay.pose().x() - (5.0 + 1.5 + 1.0)).abs() < 1e-12, "{}", replay.pose().x());
}

#[test]
fn a_delay_of_readings_is_told_between_the_rows_and_the_smoothed_track_ends_in_the_filter_s() {
    // Fixes of the true place, 0.15 s late: with that delay the innovations are as good as none.
    let mut rows = Vec::new();
    for k in 0..40 {
        let time = 0.5 * f64::from(k);
        rows.push((time, odometry(if k == 0 { 0.0 } else { 0.5 }, 0.0)));
        if k < 39 {
            rows.push((time + 0.2, Event::Position { x: time + 0.2 - 0.15, y: 0.0, sigma: Some(0.1) }));
        }
    }
    let log = drive(Motion::EvenOdometry, &[[0.0, 0.0, 0.0, 0.0]], &rows);
    let late = |delay| Settings { delays: Delays { fix: delay, ..Delays::default() }, ..Settings::default() };
    let squares =
        |delay| replayed(&log, late(delay)).1.sensors.fix.expect("fixes").mean_innovation.expect("many").abs();
    assert!(squares(0.15) < 1e-9 && squares(0.1) > 0.01 && squares(0.2) > 0.01);
    let course = Course::new(&log, late(0.15)).expect("sound settings");
    let mut replay = Replay::new(&course);
    while replay.take(&log, &course).expect("sound rows").is_some() {}
    let smoothed = Smoothed::new(&log, &course, &replay, 1).expect("factored");
    assert_eq!((smoothed.track.len(), smoothed.track[39].pose), (40, replay.pose()));
}
