//! The replay compared with its parts by themselves, and what it refuses.

use super::*;
use crate::{Code, Landmark};
use core::f64::consts::{FRAC_PI_2, PI};
use nalgebra::DMatrix;

const MAP: [Landmark; 2] = [Landmark { id: 7, x: 10.0, y: 0.0 }, Landmark { id: 9, x: 0.0, y: 10.0 }];

fn drive(motion: Motion, truth: &[[f64; 4]], rows: &[(f64, Event)]) -> Drive {
    let pose = |at: &[f64; 4]| Pose { time: at[0], x: at[1], y: at[2], theta: at[3] };
    Drive {
        landmarks: MAP.to_vec(),
        truth: Truth::new(truth.iter().map(pose).collect()),
        rows: rows.iter().map(|&(time, event)| Row::new(time, event)).collect(),
        motion,
    }
}

fn odometry(distance: f64, turn: f64) -> Event {
    Event::Odometry { distance, turn }
}

fn replayed(drive: &Drive, settings: Settings) -> Replay {
    let mut replay = Replay::new(drive, settings).expect("sound settings");
    for row in &drive.rows {
        replay.take(drive, row).expect("a sound row");
    }
    replay
}

#[test]
fn velocities_are_held_until_the_next_and_before_the_first_the_robot_stands() {
    let range = Event::Range { landmark: 0, range: 9.0 };
    let rows = [
        (0.0, range),
        (1.0, Event::Velocity { v: 2.0, omega: 0.0 }),
        (1.5, range),
        (3.0, Event::Velocity { v: 0.0, omega: 0.5 }),
        (4.0, range),
    ];
    let dark = Settings { sightings: false, ..Settings::default() };
    let replay = replayed(&drive(Motion::Velocity, &[], &rows), dark);
    let pose = replay.pose();
    assert_eq!((pose.x(), pose.y(), pose.theta(), replay.time()), (4.0, 0.0, 0.5, 4.0));
}

#[test]
fn rows_before_the_first_truth_are_skipped() {
    let rows = [(0.5, odometry(5.0, 1.0)), (1.0, Event::Range { landmark: 0, range: 1.0 }), (2.0, odometry(1.0, 0.0))];
    let replay = replayed(&drive(Motion::Odometry, &[[1.5, 3.0, 4.0, FRAC_PI_2]], &rows), Settings::default());
    assert!((replay.pose().x() - 3.0).abs() < 1e-15 && (replay.pose().y() - 5.0).abs() < 1e-15);
    assert_eq!(replay.summary().used, 0, "the range stands before the start");
    // P grew over the half second from the start to the odometry.
    assert!((replay.covariance()[(2, 2)] - (0.01 + 0.02 * 0.02 * 0.5)).abs() < 1e-15);
}

#[test]
fn input_noise_goes_through_the_input_s_jacobian() {
    let settings = Settings { sigma_distance: 0.3, sigma_turn: 0.1, ..Settings::default() };
    let rows = [(0.0, odometry(0.0, FRAC_PI_2)), (4.0, odometry(0.0, 0.0))];
    let p = replayed(&drive(Motion::Odometry, &[], &rows), settings).covariance();
    // The robot faces north: the distance's noise is in y, for four seconds.
    let expected = DMatrix::from_diagonal(&nalgebra::dvector![0.04, 0.04 + 0.09 * 4.0, 0.01 + 0.01 * 4.0]);
    assert!((p - expected).amax() < 1e-15);
}

#[test]
fn a_bearing_from_the_nose_is_choset_s_and_half_a_turn() {
    // The landmark stands straight ahead, and is seen there.
    let ahead = Event::RangeBearing { landmark: 0, range: 10.0, bearing: 0.0 };
    let replay =
        replayed(&drive(Motion::Odometry, &[], &[(0.0, odometry(0.0, 0.0)), (0.0, ahead)]), Settings::default());
    let summary = replay.summary();
    assert_eq!((summary.used, summary.mean_innovation), (1, Some(0.0)));
    assert!(replay.pose().theta().abs() < 1e-15);
    // Seen behind, it turns the estimate by as much as the prior allows.
    let behind = Event::RangeBearing { landmark: 0, range: 10.0, bearing: PI - 0.1 };
    let turned =
        replayed(&drive(Motion::Odometry, &[], &[(0.0, odometry(0.0, 0.0)), (0.0, behind)]), Settings::default());
    assert!(turned.pose().theta().abs() > 1.0);
}

#[test]
fn a_gate_refuses_what_lies_beyond_it_and_keeps_the_estimate() {
    let far = Event::Range { landmark: 0, range: 13.0 };
    let log = drive(Motion::Odometry, &[], &[(0.0, odometry(0.0, 0.0)), (0.0, far)]);
    // ν = 3 m and S = 0.2² + 0.6² = 0.4 m²: d² = 22.5.
    let gated = replayed(&log, Settings { gate: Some(0.999), ..Settings::default() });
    assert_eq!((gated.summary().used, gated.summary().refused, gated.pose().x()), (0, 1, 0.0));
    let open = replayed(&log, Settings { gate: Some(0.999_999_99), ..Settings::default() });
    assert_eq!((open.summary().used, open.summary().refused), (1, 0));
    assert!((open.summary().nis.expect("used") - 22.5).abs() < 1e-12);
}

#[test]
fn a_landmark_underfoot_is_refused_and_the_replay_goes_on() {
    let at_landmark = drive(
        Motion::Odometry,
        &[[0.0, 10.0, 0.0, 0.0]],
        &[(0.0, Event::Range { landmark: 0, range: 0.1 }), (1.0, odometry(1.0, 0.0))],
    );
    let replay = replayed(&at_landmark, Settings::default());
    assert_eq!((replay.summary().refused, replay.pose().x()), (1, 11.0));
}

#[test]
fn a_refused_row_leaves_the_replay_as_it_was() {
    let log = drive(Motion::Odometry, &[], &[(0.0, odometry(1.0, 0.0))]);
    let mut replay = replayed(&log, Settings::default());
    let before = replay.summary();
    let too_far = Row::new(1.0, odometry(1e308, 0.0));
    let nowhere = Row::new(1.0, Event::Range { landmark: 5, range: 1.0 });
    let endless = Row::new(1.0, Event::Range { landmark: 0, range: 1e300 });
    for (row, code) in [(too_far, Code::NotFinite), (nowhere, Code::Limit), (endless, Code::NotFinite)] {
        assert_eq!(replay.take(&log, &row).expect_err("refused").code, code);
        assert_eq!(replay.summary(), before);
    }
    let mut gated = replayed(&log, Settings { gate: Some(0.9), ..Settings::default() });
    assert!(gated.take(&log, &endless).is_ok_and(|judged| judged.is_some_and(|j| !j.used)));
}

#[test]
fn settings_out_of_bounds_are_refused_by_name() {
    let log = drive(Motion::Odometry, &[], &[(0.0, odometry(1.0, 0.0))]);
    let sound = Settings::default();
    for (settings, code, name) in [
        (Settings { sigma_distance: -0.1, ..sound }, Code::Limit, "sigmaDistance"),
        (Settings { sigma_turn: f64::NAN, ..sound }, Code::NotFinite, "sigmaTurn"),
        (Settings { sigma_range: 0.0, ..sound }, Code::Limit, "sigmaRange"),
        (Settings { sigma_bearing: f64::INFINITY, ..sound }, Code::NotFinite, "sigmaBearing"),
        (Settings { gate: Some(9.21), ..sound }, Code::Limit, "gate"),
        (Settings { gate: Some(f64::NAN), ..sound }, Code::Limit, "gate"),
        (Settings { scale: -1.0, ..sound }, Code::Limit, "scale"),
        (Settings { offset: f64::NAN, ..sound }, Code::NotFinite, "offset"),
    ] {
        let error = Replay::new(&log, settings).expect_err("out of bounds");
        assert_eq!((error.code, error.argument.as_ref()), (code, name));
    }
}
