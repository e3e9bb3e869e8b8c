//! The track in the light of all readings.

use super::*;
use crate::dynamic::{System, kalman_smooth};
use nalgebra::{dmatrix, dvector};

fn fix(x: f64, y: f64) -> Event {
    Event::Position { x, y, sigma: None }
}

/// A winding drive of `n` seconds with fixes, headings and sightings, and with the truth at every second. The robot
/// strays a little from what its speeds and turn rates say.
fn winding(n: u32) -> Drive {
    let (mut rows, mut truth, mut at) = (Vec::new(), Vec::new(), SE2::new(0.0, 0.0, 0.1));
    for i in 0..10 * n {
        let time = f64::from(i) * 0.1;
        let (v, omega) = (1.0 + 0.2 * libm::cos(time), 0.3 * libm::sin(0.2 * time));
        rows.push((time, Event::Velocity { v, omega }));
        if i % 10 == 0 {
            truth.push([time, at.x(), at.y(), at.theta()]);
        }
        if i % 25 == 7 {
            rows.push((time, fix(at.x() + libm::sin(7.0 * time), at.y() + libm::cos(5.0 * time))));
            rows.push((time, Event::Heading { theta: at.theta() + 0.2 * libm::sin(3.0 * time), sigma: Some(0.2) }));
        }
        if i % 40 == 3 {
            let range = numerics::hypot(MAP[0].x - at.x(), MAP[0].y - at.y());
            rows.push((time, Event::Range { landmark: 0, range: range + 0.5 * libm::cos(11.0 * time) }));
        }
        let stray = 0.1 * libm::sin(1.7 * time);
        let forward = SE2::new((v + stray) * 0.1, 0.0, (omega + 0.3 * stray) * 0.1);
        at = at.compose(forward);
    }
    drive(Motion::Velocity, &truth, &rows)
}

fn course(drive: &Drive, settings: Settings) -> Course {
    Course::new(drive, settings).expect("sound settings")
}

/// The filter's pose and P after each row of motion, and the replay at the end.
fn filtered(drive: &Drive, course: &Course) -> (Vec<(SE2, Matrix3<f64>)>, Replay) {
    let (mut replay, mut track) = (Replay::new(course), Vec::new());
    while let Some(taken) = replay.take(drive, course).expect("sound rows") {
        if drive.rows[taken.row].event.is_motion() && !taken.early {
            track.push((replay.pose(), replay.covariance().fixed_view::<3, 3>(0, 0).into_owned()));
        }
    }
    (track, replay)
}

fn every_state(settings: Settings) -> [Settings; 4] {
    [
        settings,
        Settings { learn: true, ..settings },
        Settings { learn_speed: true, learn_bias: true, ..settings },
        Settings { learn: true, learn_speed: true, learn_bias: true, ..settings },
    ]
}

#[test]
fn its_covariance_is_never_above_the_filter_s_and_its_last_state_is_the_filter_s() {
    let log = winding(60);
    for settings in every_state(Settings::default()) {
        let course = course(&log, settings);
        let (track, replay) = filtered(&log, &course);
        let smoothed = Smoothed::new(&log, &course, &replay, 1).expect("factored");
        assert_eq!(smoothed.track.len(), track.len());
        let mut less = 0;
        for (of, (_, p)) in smoothed.track.iter().zip(&track) {
            assert_eq!(of.p, of.p.transpose(), "exactly symmetric");
            let (gained, own) = (p - of.p, of.p.symmetric_eigenvalues().min());
            assert!(gained.symmetric_eigenvalues().min() > -1e-12 * p.trace() && own > 0.0, "at {}", of.time);
            less += usize::from(of.p.trace() < 0.9 * p.trace());
        }
        assert!(less > track.len() / 2, "it says more than the filter: {less} of {}", track.len());
        let last = smoothed.track.last().expect("rows");
        assert_eq!((last.pose, last.p), *track.last().expect("rows"));
        // How far it is from the truth at the rows of motion is what it says.
        let far = |at: &SmoothedPose| {
            let [x, y] = log.truth.position(at.time).expect("known");
            numerics::hypot(at.pose.x() - x, at.pose.y() - y)
        };
        let squares: f64 = smoothed.track.iter().map(|at| far(at) * far(at)).sum();
        let rmse = smoothed.told(replay.summary(&course)).rmse_smoothed.expect("there is a truth");
        assert!((rmse - libm::sqrt(squares / track.len() as f64)).abs() < 1e-12 && rmse < 1.0);
    }
}

#[test]
fn on_a_straight_way_it_is_the_linear_smoother() {
    // Heading and its noise are zero, so x and y are two linear systems; a fix in every second but from 20 to 40 s.
    let quiet = Settings { sigma_turn: 0.0, start_sigma_heading: 1e-9, sigma_distance: 0.4, ..Settings::default() };
    let fixes: Vec<Option<f64>> =
        (0..60).map(|k| (!(20..40).contains(&k)).then(|| f64::from(k) + libm::sin(f64::from(3 * k)))).collect();
    let mut rows = Vec::new();
    for (k, reading) in fixes.iter().enumerate() {
        rows.push((k as f64, Event::Velocity { v: 1.0, omega: 0.0 }));
        rows.extend(reading.map(|x| (k as f64, fix(x, 0.0))));
    }
    let log = drive(Motion::Velocity, &[], &rows);
    let course = course(&log, quiet);
    let (_, replay) = filtered(&log, &course);
    let smoothed = Smoothed::new(&log, &course, &replay, 1).expect("factored");
    let one = dmatrix![1.0];
    let system = System::new(one.clone(), one.clone(), one.clone(), dmatrix![0.16], one).expect("sound");
    // A row of a linear log moves before it is read: the belief a second before the first fix.
    let belief = crate::validate::belief(dvector![0.0], dmatrix![0.04]).expect("sound");
    let first = system_at_start(&system, &belief, &fixes);
    for (at, of) in smoothed.track.iter().zip(&first) {
        assert!((at.pose.x() - of.x[0]).abs() < 1e-9 && (at.p[(0, 0)] - of.p[(0, 0)]).abs() < 1e-9, "{}", at.time);
    }
    // A gap grows from both ends, and is widest in its middle.
    let sigma = |k: usize| smoothed.track[k].p[(0, 0)];
    assert!(sigma(30) > sigma(22) && sigma(30) > sigma(38));
}

/// The linear smoother over readings of which the first comes before any motion: a first row without motion stands for
/// it, by an input that takes the metre back and a belief that has the second's noise less.
fn system_at_start(
    system: &System,
    belief: &crate::dynamic::Belief,
    fixes: &[Option<f64>],
) -> Vec<crate::dynamic::Belief> {
    let inputs: Vec<Vec<f64>> = (0..fixes.len()).map(|k| vec![if k == 0 { 0.0 } else { 1.0 }]).collect();
    let readings: Vec<Vec<Option<f64>>> = fixes.iter().map(|reading| vec![*reading]).collect();
    let still = System { v: dmatrix![0.0], ..system.clone() };
    // The first reading, without motion.
    let known = kalman_smooth(&still, belief, &inputs[..1], &readings[..1]).expect("sound");
    let mut track = kalman_smooth(system, &known[0], &inputs[1..], &readings[1..]).expect("sound");
    // And the first state in the light of the second.
    let (p, q) = (known[0].p[0], system.v[0]);
    let (predicted, next) = (p + q, &track[0]);
    let c = p / predicted;
    let x = known[0].x[0] + c * (next.x[0] - (known[0].x[0] + 1.0));
    let first = crate::validate::belief(dvector![x], dmatrix![p + c * c * (next.p[0] - predicted)]).expect("sound");
    track.insert(0, first);
    track
}

#[test]
fn it_is_one_track_whatever_is_kept_of_it() {
    // More steps than a block has, and rows between two poses that are kept: F of them is one.
    let log = Drive { truth: Truth::default(), ..winding(200) };
    let start = Settings { start: Some([0.0, 0.0, 0.3]), ..Settings::default() };
    for settings in every_state(start) {
        let course = course(&log, settings);
        let (_, replay) = filtered(&log, &course);
        let each = Smoothed::new(&log, &course, &replay, 1).expect("factored").track;
        let some = Smoothed::new(&log, &course, &replay, 37).expect("factored").track;
        assert_eq!(some.len(), each.len().div_ceil(37));
        for (one, other) in some.iter().zip(each.iter().step_by(37)) {
            assert!(one.row == other.row && one.pose.boxminus(other.pose).amax() < 1e-9, "at {}", one.time);
            assert!((one.p - other.p).amax() < 1e-9 * other.p.amax(), "at {}", one.time);
        }
    }
}

#[test]
fn of_a_vast_start_it_keeps_its_digits() {
    let log = Drive { truth: Truth::default(), ..winding(30) };
    let vast = Settings { start_sigma: 1e6, start_sigma_heading: 3.0, sigma_fix: 0.01, ..Settings::default() };
    let course = course(&log, vast);
    let (_, replay) = filtered(&log, &course);
    let first = Smoothed::new(&log, &course, &replay, 1).expect("factored").track[0];
    assert!(first.p.symmetric_eigenvalues().min() > 0.0 && first.p[(0, 0)] < 1.0, "{}", first.p);
}

#[test]
fn withheld_fixes_are_nearer_to_it_than_to_the_filter() {
    let (log, withheld) = (winding(60), Some([20.0, 35.0]));
    let course = course(&log, Settings { withheld, ..Settings::default() });
    let (_, replay) = filtered(&log, &course);
    let before = replay.summary(&course).withheld.expect("withheld");
    assert_eq!((before.rms_smoothed, before.worst_smoothed), (None, None));
    let after = Smoothed::new(&log, &course, &replay, 1000).expect("factored").told(replay.summary(&course));
    let after = after.withheld.expect("withheld");
    assert_eq!((after.rows, after.rms), (before.rows, before.rms));
    assert!(after.rms_smoothed < after.rms && after.worst_smoothed < after.worst, "{after:?}");
}

#[test]
fn of_odometry_and_before_the_first_row_it_is_the_filter() {
    let range = Event::Range { landmark: 0, range: 9.0 };
    let rows = [(0.0, odometry(0.0, 0.0)), (0.0, range), (0.0, range), (1.0, odometry(1.0, 0.1)), (1.0, range)];
    let log = drive(Motion::Odometry, &[], &rows);
    let course = course(&log, Settings::default());
    let (track, replay) = filtered(&log, &course);
    let smoothed = Smoothed::new(&log, &course, &replay, 1).expect("factored").track;
    assert!(smoothed[0].p.trace() < track[0].1.trace() && smoothed[1].p.trace() < track[1].1.trace());
    assert_eq!(Smoothed::new(&log, &course, &Replay::new(&course), 1).expect("nothing"), Smoothed::default());
}

#[test]
fn a_prediction_that_cannot_be_factored_names_its_row() {
    // Nothing is uncertain but what no number can hold: the squares of these are 0.
    let quiet = Settings {
        sigma_distance: 0.0,
        sigma_turn: 0.0,
        start_sigma: 1e-200,
        start_sigma_heading: 1e-200,
        ..Settings::default()
    };
    let drives = Event::Velocity { v: 1.0, omega: 0.0 };
    let log = drive(Motion::Velocity, &[], &[(0.0, drives), (1.0, fix(1.5, 0.0)), (2.0, drives)]);
    let course = course(&log, quiet);
    let (_, replay) = filtered(&log, &course);
    let refused = Smoothed::new(&log, &course, &replay, 1).expect_err("singular");
    assert_eq!((refused.code, refused.argument.as_ref()), (Code::InnovationNotPositiveDefinite, "P"));
    assert!(refused.message.contains("row 2 of the replay, measured at 1 s"), "{}", refused.message);
}
