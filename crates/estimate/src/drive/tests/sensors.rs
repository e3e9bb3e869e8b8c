//! Several sensors, each at its own time.

use super::*;

const STRAIGHT: Event = Event::Velocity { v: 1.0, omega: 0.0 };

fn speed(v: f64) -> Event {
    Event::Speed { v }
}

fn fix(x: f64, y: f64) -> Event {
    Event::Position { x, y, sigma: None }
}

fn held(rows: &[(f64, Event)]) -> Drive {
    drive(Motion::Velocity, &[], rows)
}

fn delayed(delays: Delays) -> Settings {
    Settings { delays, ..Settings::default() }
}

/// The rows as a replay takes them: index and time.
fn taken(drive: &Drive, settings: Settings) -> Vec<(usize, f64)> {
    let course = Course::new(drive, settings).expect("sound settings");
    let mut replay = Replay::new(&course);
    core::iter::from_fn(|| replay.take(drive, &course).expect("sound rows")).map(|it| (it.row, it.time)).collect()
}

#[test]
fn speeds_and_turn_rates_are_held_each_until_its_next() {
    let quarter = Event::TurnRate { omega: FRAC_PI_2 };
    let still = Event::TurnRate { omega: 0.0 };
    let rows = [(0.0, speed(2.0)), (1.0, quarter), (2.0, still), (3.0, speed(0.0)), (9.0, still)];
    let (replay, _) = replayed(&held(&rows), Settings::default());
    // Two metres east, then, along the old heading, two more; a quarter turn; two metres north.
    let pose = replay.pose();
    assert!((pose.x() - 4.0).abs() < 1e-15 && (pose.y() - 2.0).abs() < 1e-15 && pose.theta() == FRAC_PI_2);
    // A V row is a speed and a turn rate.
    let rows = [(0.0, Event::Velocity { v: 2.0, omega: 0.0 }), (1.0, quarter), (2.0, still)];
    assert!((replayed(&held(&rows), Settings::default()).0.pose().x() - 4.0).abs() < 1e-15);
}

#[test]
fn a_reading_belongs_to_the_time_at_which_it_was_measured() {
    // At 1 m/s the fix stamped 2 s, half a second late, is of the place at 1.5 s.
    let rows = [(0.0, STRAIGHT), (1.0, STRAIGHT), (2.0, fix(1.5, 0.0)), (3.0, STRAIGHT)];
    let start = Settings { start: Some([-1.5, 0.0, 0.0]), ..delayed(Delays { fix: 0.5, ..Delays::default() }) };
    assert_eq!(taken(&held(&rows), start), [(0, 0.0), (1, 1.0), (2, 1.5), (3, 3.0)]);
    let first = [(0.0, fix(0.0, 0.0)), (0.0, STRAIGHT), (2.0, fix(1.5, 0.0)), (3.0, STRAIGHT)];
    let late = |fix| replayed(&held(&first), delayed(Delays { fix, ..Delays::default() }));
    // The replay starts when the first fix was measured, and speeds from before it are held.
    let (replay, summary) = late(0.5);
    assert_eq!(replay.time(), 3.0);
    assert!(summary.nis.expect("used").abs() < 1e-3, "{summary:?}");
    assert!(late(0.0).1.sensors.fix.expect("fixes").mean_along.expect("used") < -0.1);
}

#[test]
fn at_equal_times_motion_comes_first_then_the_line() {
    let line = |time, event, line| Row { line, ..Row::new(time, event) };
    let heading = Event::Heading { theta: 0.0, sigma: None };
    let late = line(2.0, STRAIGHT, 2);
    let rows = vec![line(0.0, STRAIGHT, 0), line(1.0, fix(1.0, 0.0), 4), line(1.5, heading, 1), late];
    let log = Drive { rows, ..held(&[]) };
    let delays = Delays { speed: 1.0, turn: 1.0, heading: 0.5, ..Delays::default() };
    let order: Vec<usize> = taken(&log, delayed(delays)).into_iter().map(|(row, _)| row).collect();
    assert_eq!(order, [0, 3, 2, 1]);
}

#[test]
fn a_velocity_with_two_delays_counts_at_its_turn() {
    let rows = [(0.0, STRAIGHT), (1.0, Event::Velocity { v: 0.0, omega: 1.0 }), (2.0, STRAIGHT)];
    // Speeds are half a second older than turn rates.
    let early = delayed(Delays { speed: 0.5, ..Delays::default() });
    assert_eq!(taken(&held(&rows), early), [(0, 0.0), (1, 1.0), (2, 2.0)]);
    let (replay, _) = replayed(&held(&rows), early);
    // It drives for a second, from half a second before the first turn on; it stands for one, and drives again.
    assert_eq!((replay.pose().theta(), replay.rows(), replay.time()), (1.0, 3, 2.0));
    assert!((replay.pose().x() - (1.0 + 0.5 * libm::cos(0.5))).abs() < 1e-12, "{}", replay.pose().x());
    // Speeds that are newer than the turn of the last row belong to it.
    let late = delayed(Delays { turn: 0.5, ..Delays::default() });
    assert_eq!(taken(&held(&rows), late), [(0, -0.5), (1, 0.5), (2, 1.5)]);
    assert_eq!(replayed(&held(&rows), late).0.time(), 2.0);
}

#[test]
fn held_rows_before_the_start_say_what_is_held_and_other_rows_are_skipped() {
    let rows = [(0.0, STRAIGHT), (0.5, fix(9.0, 9.0)), (1.5, fix(0.5, 0.0)), (2.0, STRAIGHT)];
    let log = drive(Motion::Velocity, &[[1.0, 0.0, 0.0, 0.0]], &rows);
    let (replay, summary) = replayed(&log, Settings::default());
    assert_eq!((summary.used, replay.pose().x(), summary.rmse), (1, 1.0, Some(1.0)));
}

#[test]
fn the_start_is_the_truth_s_or_the_first_fix_s_or_the_first_row_s() {
    let start = Some([1.0, 2.0, 3.0]);
    let settings = Settings { start, fixes: false, ..delayed(Delays { fix: 0.25, ..Delays::default() }) };
    let course = |log: &Drive| Course::new(log, settings).expect("sound settings");
    let rows = [(0.0, STRAIGHT), (1.0, fix(0.0, 0.0))];
    let of_fix = course(&held(&rows));
    assert_eq!((of_fix.start(), of_fix.pose().to_vector()[2]), (0.75, 3.0), "also where fixes are off");
    assert_eq!(course(&held(&rows[..1])).start(), 0.0);
    let of_truth = course(&drive(Motion::Velocity, &[[0.5, 7.0, 0.0, 0.0]], &rows));
    assert_eq!((of_truth.start(), of_truth.pose().x()), (0.5, 7.0));
    let sigma = Settings { start_sigma: 3.0, start_sigma_heading: 0.5, ..Settings::default() };
    let p = Replay::new(&Course::new(&held(&rows), sigma).expect("sound")).covariance();
    assert_eq!((p[(0, 0)], p[(1, 1)], p[(2, 2)]), (9.0, 9.0, 0.25));
}

#[test]
fn a_sensor_is_heard_every_so_often_and_withheld_fixes_do_not_count() {
    let rows: Vec<(f64, Event)> = core::iter::once((0.0, STRAIGHT))
        .chain((0..=20).map(|i| (f64::from(i) * 0.1, fix(f64::from(i) * 0.1, 0.0))))
        .collect();
    let log = held(&rows);
    let every = BySensor { fix: 0.5, ..BySensor::default() };
    let (_, summary) = replayed(&log, Settings { every, ..Settings::default() });
    assert_eq!(summary.used, 5, "0, 0.5, 1, 1.5 and 2: a period to rounding is a period");
    // From 0.9 on; at 0.5 it was withheld, and so the next is 0.9.
    let withheld = Some([0.35, 0.85]);
    let (_, summary) = replayed(&log, Settings { every, withheld, ..Settings::default() });
    assert_eq!((summary.used, summary.withheld.expect("withheld").rows), (4, 5));
    let course = Course::new(&log, Settings { every, withheld, ..Settings::default() }).expect("sound settings");
    assert_eq!(course.looked_at(&log), 4);
    let (_, off) = replayed(&log, Settings { fixes: false, withheld, ..Settings::default() });
    assert_eq!((off.used, off.withheld), (0, None));
    assert_eq!(off.sensors.fix.map(|fix| (fix.used, fix.nis)), Some((0, None)), "the log has them all the same");
}

#[test]
fn a_gate_is_its_sensor_s() {
    let heading = Event::Heading { theta: 1.0, sigma: None };
    let log = held(&[(0.0, STRAIGHT), (0.0, fix(30.0, 0.0)), (0.0, heading)]);
    let gate = BySensor { fix: Some(0.99), ..BySensor::default() };
    let (replay, summary) = replayed(&log, Settings { gate, ..Settings::default() });
    let Sensors { fix: Some(fix), heading: Some(heading), range: None, bearing: None } = summary.sensors else {
        panic!("{summary:?}")
    };
    assert_eq!([fix.used, fix.refused, heading.used, heading.refused], [0, 1, 1, 0]);
    // 0.1² against 0.05²: four fifths of the way.
    assert!((replay.pose().theta() - 0.8).abs() < 1e-12 && replay.pose().x() == 0.0);
}

#[test]
fn the_log_likelihood_is_that_of_the_innovations() {
    // ν = (3, −4) with S = 0.2² + 1² in both: ln N(ν; 0, S).
    let (_, summary) = replayed(&held(&[(0.0, STRAIGHT), (0.0, fix(3.0, -4.0))]), Settings::default());
    let s = 1.04_f64;
    let expected = -0.5 * (2.0 * libm::log(2.0 * PI * s) + 25.0 / s);
    assert!((summary.log_likelihood.expect("used") - expected).abs() < 1e-12);
    let along = summary.sensors.fix.expect("fixes");
    assert!((along.mean_along.expect("used") - 3.0 / libm::sqrt(s)).abs() < 1e-12);
    assert!((along.mean_across.expect("used") + 4.0 / libm::sqrt(s)).abs() < 1e-12);
}

#[test]
fn a_reading_s_own_sigma_comes_before_that_of_the_settings() {
    let own = Event::Position { x: 1.0, y: 0.0, sigma: Some(0.2) };
    let (replay, _) = replayed(&held(&[(0.0, STRAIGHT), (0.0, own)]), Settings::default());
    assert!((replay.pose().x() - 0.5).abs() < 1e-15);
}

#[test]
fn scale_and_bias_that_are_known_undo_what_the_sensors_add() {
    let rows = [(0.0, Event::Velocity { v: 0.8, omega: 0.5 }), (2.0, STRAIGHT)];
    let settings = Settings { speed_scale: 0.25, turn_bias: 0.5, ..Settings::default() };
    let pose = replayed(&held(&rows), settings).0.pose();
    assert_eq!((pose.x(), pose.y(), pose.theta()), (2.0, 0.0, 0.0));
}

#[test]
fn scale_and_bias_are_learned_from_fixes_and_headings() {
    // The robot drives a circle at 1 m/s and 0.1 rad/s; its sensors read 0.8 m/s and 0.13 rad/s.
    let (mut rows, radius) = (vec![(0.0, Event::Velocity { v: 0.8, omega: 0.13 })], 10.0);
    for i in 1..=3000 {
        let (time, angle) = (f64::from(i) * 0.1, f64::from(i) * 0.01);
        rows.push((time, fix(radius * libm::sin(angle), radius * (1.0 - libm::cos(angle)))));
        rows.push((time, Event::Heading { theta: angle, sigma: Some(0.01) }));
    }
    let learning = Settings { learn_speed: true, learn_bias: true, sigma_fix: 0.05, ..Settings::default() };
    let (replay, summary) = replayed(&held(&rows), learning);
    let [Some(scale), Some(bias)] = [summary.speed_scale, summary.turn_bias] else { panic!("learned") };
    assert!((scale - 0.25).abs() < 0.01 && (bias - 0.03).abs() < 0.003, "{scale} {bias}");
    assert!(summary.speed_scale_sigma.expect("learned") < 0.01 && summary.x.len() == 5);
    assert_eq!((replay.covariance().nrows(), summary.epsilon), (5, None));
}

#[test]
fn a_bearing_s_offset_is_taken_off() {
    let ahead = Event::RangeBearing { landmark: 0, range: 10.0, bearing: 0.3 };
    let log = drive(Motion::Odometry, &[], &[(0.0, odometry(0.0, 0.0)), (0.0, ahead)]);
    let (replay, summary) = replayed(&log, Settings { bearing_offset: 0.3, ..Settings::default() });
    assert!(replay.pose().theta().abs() < 1e-15);
    let bearing = summary.sensors.bearing.expect("bearings");
    assert!(bearing.mean_bearing.expect("used").abs() < 1e-12 && bearing.lag1_bearing.is_none());
}

#[test]
fn a_refused_row_of_two_times_leaves_the_replay_as_it_was() {
    let rows =
        [(0.0, STRAIGHT), (1.0, Event::Velocity { v: 1e308, omega: 0.0 }), (20.0, Event::TurnRate { omega: 0.0 })];
    let log = held(&rows);
    let course = Course::new(&log, delayed(Delays { speed: 0.5, ..Delays::default() })).expect("sound settings");
    let mut replay = Replay::new(&course);
    while replay.rows() < 1 {
        replay.take(&log, &course).expect("a sound row");
    }
    let before = (replay.summary(&course), replay.rows(), replay.time());
    for _ in 0..2 {
        assert_eq!(replay.take(&log, &course).expect_err("too far").code, Code::NotFinite);
        assert_eq!((replay.summary(&course), replay.rows(), replay.time()), before);
    }
}
