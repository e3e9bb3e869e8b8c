//! The replay compared with its parts by themselves, and what it refuses.

use super::*;
use crate::{Code, Landmark};
use core::f64::consts::{FRAC_PI_2, PI};
use geom::SE2;
use nalgebra::{DMatrix, Matrix3};

mod even;
mod opening;
mod opening_ranges;
mod rates;
mod sensors;
mod smoothing;

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

/// A replay at the end of its drive, and what it says.
fn replayed(drive: &Drive, settings: Settings) -> (Replay, Summary) {
    let course = Course::new(drive, settings).expect("sound settings");
    let mut replay = Replay::new(&course);
    while replay.take(drive, &course).expect("a sound row").is_some() {}
    let summary = replay.summary(&course);
    (replay, summary)
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
    let (replay, _) = replayed(&drive(Motion::Velocity, &[], &rows), dark);
    let pose = replay.pose();
    assert_eq!((pose.x(), pose.y(), pose.theta(), replay.time()), (4.0, 0.0, 0.5, 4.0));
}

#[test]
fn rows_before_the_first_truth_are_skipped() {
    let rows = [(0.5, odometry(5.0, 1.0)), (1.0, Event::Range { landmark: 0, range: 1.0 }), (2.0, odometry(1.0, 0.0))];
    let log = drive(Motion::Odometry, &[[1.5, 3.0, 4.0, FRAC_PI_2]], &rows);
    let (replay, summary) = replayed(&log, Settings::default());
    assert!((replay.pose().x() - 3.0).abs() < 1e-15 && (replay.pose().y() - 5.0).abs() < 1e-15);
    assert_eq!(summary.used, 0, "the range stands before the start");
    // P grew over the half second from the start to the odometry.
    assert!((replay.covariance()[(2, 2)] - (0.01 + 0.02 * 0.02 * 0.5)).abs() < 1e-15);
}

#[test]
fn input_noise_goes_through_the_input_s_jacobian() {
    let settings = Settings { sigma_distance: 0.3, sigma_turn: 0.1, ..Settings::default() };
    let rows = [(0.0, odometry(0.0, FRAC_PI_2)), (4.0, odometry(0.0, 0.0))];
    let p = replayed(&drive(Motion::Odometry, &[], &rows), settings).0.covariance();
    // The robot faces north: the distance's noise is in y, for four seconds.
    let expected = DMatrix::from_diagonal(&nalgebra::dvector![0.04, 0.04 + 0.09 * 4.0, 0.01 + 0.01 * 4.0]);
    assert!((p - expected).amax() < 1e-15);
}

#[test]
fn a_bearing_from_the_nose_is_choset_s_and_half_a_turn() {
    // The landmark stands straight ahead, and is seen there.
    let ahead = Event::RangeBearing { landmark: 0, range: 10.0, bearing: 0.0 };
    let log = |seen| drive(Motion::Odometry, &[], &[(0.0, odometry(0.0, 0.0)), (0.0, seen)]);
    let (replay, summary) = replayed(&log(ahead), Settings::default());
    assert_eq!((summary.used, summary.mean_innovation), (1, Some(0.0)));
    assert!(replay.pose().theta().abs() < 1e-15);
    // Seen behind, it turns the estimate by as much as the prior allows.
    let behind = Event::RangeBearing { landmark: 0, range: 10.0, bearing: PI - 0.1 };
    let (turned, _) = replayed(&log(behind), Settings::default());
    assert!(turned.pose().theta().abs() > 1.0);
}

#[test]
fn a_gate_refuses_what_lies_beyond_it_and_keeps_the_estimate() {
    let far = Event::Range { landmark: 0, range: 13.0 };
    let log = drive(Motion::Odometry, &[], &[(0.0, odometry(0.0, 0.0)), (0.0, far)]);
    // ν = 3 m and S = 0.2² + 0.6² = 0.4 m²: d² = 22.5.
    let gated = |p| Settings { gate: BySensor::all(Some(p)), ..Settings::default() };
    let (replay, summary) = replayed(&log, gated(0.999));
    assert_eq!((summary.used, summary.refused, replay.pose().x()), (0, 1, 0.0));
    let (_, summary) = replayed(&log, gated(0.999_999_99));
    assert_eq!((summary.used, summary.refused), (1, 0));
    assert!((summary.nis.expect("used") - 22.5).abs() < 1e-12);
}

#[test]
fn a_landmark_underfoot_is_refused_and_the_replay_goes_on() {
    let at_landmark = drive(
        Motion::Odometry,
        &[[0.0, 10.0, 0.0, 0.0]],
        &[(0.0, Event::Range { landmark: 0, range: 0.1 }), (1.0, odometry(1.0, 0.0))],
    );
    let (replay, summary) = replayed(&at_landmark, Settings::default());
    assert_eq!((summary.refused, replay.pose().x()), (1, 11.0));
}

#[test]
fn a_refused_row_leaves_the_replay_as_it_was() {
    let endless = Event::Range { landmark: 0, range: 1e300 };
    for (event, code) in [
        (odometry(1e308, 0.0), Code::NotFinite),
        (Event::Range { landmark: 5, range: 1.0 }, Code::Limit),
        (endless, Code::NotFinite),
    ] {
        let log = drive(Motion::Odometry, &[], &[(0.0, odometry(1.0, 0.0)), (1.0, event)]);
        let course = Course::new(&log, Settings::default()).expect("sound settings");
        let mut replay = Replay::new(&course);
        replay.take(&log, &course).expect("a sound row");
        let before = (replay.summary(&course), replay.rows());
        for _ in 0..2 {
            assert_eq!(replay.take(&log, &course).expect_err("refused").code, code);
            assert_eq!((replay.summary(&course), replay.rows()), before);
        }
    }
    let log = drive(Motion::Odometry, &[], &[(0.0, odometry(1.0, 0.0)), (1.0, endless)]);
    let (_, gated) = replayed(&log, Settings { gate: BySensor::all(Some(0.9)), ..Settings::default() });
    assert_eq!((gated.used, gated.refused), (0, 1), "what overflows is within no gate");
}

#[test]
fn settings_out_of_bounds_are_refused_by_name() {
    let log = drive(Motion::Odometry, &[], &[(0.0, odometry(1.0, 0.0))]);
    let (sound, none) = (Settings::default(), Delays::default());
    for (settings, code, name) in [
        (Settings { sigma_distance: -0.1, ..sound }, Code::Limit, "sigmaDistance"),
        (Settings { sigma_turn: f64::NAN, ..sound }, Code::NotFinite, "sigmaTurn"),
        (Settings { sigma_range: 0.0, ..sound }, Code::Limit, "sigmaRange"),
        (Settings { sigma_bearing: f64::INFINITY, ..sound }, Code::NotFinite, "sigmaBearing"),
        (Settings { gate: BySensor::all(Some(9.21)), ..sound }, Code::Limit, "gate"),
        (Settings { gate: BySensor { heading: Some(f64::NAN), ..sound.gate }, ..sound }, Code::Limit, "gate.heading"),
        (Settings { every: BySensor { range: -1.0, ..sound.every }, ..sound }, Code::Limit, "every.range"),
        (Settings { every: BySensor::all(f64::INFINITY), ..sound }, Code::NotFinite, "every"),
        (Settings { scale: -1.0, ..sound }, Code::Limit, "scale"),
        (Settings { offset: f64::NAN, ..sound }, Code::NotFinite, "offset"),
        (Settings { bearing_offset: f64::NAN, ..sound }, Code::NotFinite, "bearingOffset"),
        (Settings { sigma_fix: 0.0, ..sound }, Code::Limit, "sigmaFix"),
        (Settings { sigma_heading: -1.0, ..sound }, Code::Limit, "sigmaHeading"),
        (Settings { start_sigma: 0.0, ..sound }, Code::Limit, "startSigma"),
        (Settings { start_sigma_heading: f64::NAN, ..sound }, Code::NotFinite, "startSigmaHeading"),
        (Settings { start: Some([0.0, f64::NAN, 0.0]), ..sound }, Code::NotFinite, "start"),
        (Settings { withheld: Some([2.0, 1.0]), ..sound }, Code::Limit, "withheld"),
        (Settings { withheld: Some([f64::NEG_INFINITY, 1.0]), ..sound }, Code::NotFinite, "withheld"),
        (Settings { delays: Delays { fix: 10.1, ..none }, ..sound }, Code::Limit, "delayFix"),
        (Settings { delays: Delays { heading: f64::NAN, ..none }, ..sound }, Code::NotFinite, "delayHeading"),
        (Settings { delays: Delays { sighting: -11.0, ..none }, ..sound }, Code::Limit, "delaySighting"),
        // Of speeds and turn rates, which a log of O rows has not.
        (Settings { delays: Delays { speed: 0.1, ..none }, ..sound }, Code::Limit, "delaySpeed"),
        (Settings { delays: Delays { turn: 0.1, ..none }, ..sound }, Code::Limit, "delayTurn"),
        (Settings { speed_scale: 0.1, ..sound }, Code::Limit, "speedScale"),
        (Settings { turn_bias: 0.1, ..sound }, Code::Limit, "turnBias"),
        (Settings { learn_speed: true, ..sound }, Code::Limit, "learnSpeed"),
        (Settings { learn_bias: true, ..sound }, Code::Limit, "learnBias"),
    ] {
        let error = Course::new(&log, settings).expect_err("out of bounds");
        assert_eq!((error.code, error.argument.as_ref()), (code, name));
    }
}
