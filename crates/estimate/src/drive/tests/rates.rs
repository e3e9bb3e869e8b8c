//! Rates that change evenly: between two rows the robot drives with the mean of both, and turns on its way.

use super::*;

fn even(rows: &[(f64, Event)]) -> Drive {
    drive(Motion::EvenVelocity, &[[0.0, 0.0, 0.0, 0.0]], rows)
}

/// Where the motion alone leads under these delays.
fn reckoned(log: &Drive, delays: Delays) -> SE2 {
    let dark = Settings { fixes: false, headings: false, sightings: false, ..Settings::default() };
    replayed(log, Settings { delays, ..dark }).0.pose()
}

#[test]
fn a_robot_that_speeds_up_is_where_it_is_at_every_row_and_half_a_step_behind_where_its_speed_is_held() {
    let rows: Vec<(f64, Event)> =
        (0..=8).map(|k| 0.5 * f64::from(k)).map(|time| (time, Event::Velocity { v: 0.6 * time, omega: 0.0 })).collect();
    for n in 2..=rows.len() {
        let (time, log) = (rows[n - 1].0, even(&rows[..n]));
        let [mean, held] = [reckoned(&log, Delays::default()), {
            let held = Drive { motion: Motion::Velocity, ..log };
            reckoned(&held, Delays::default())
        }];
        assert!((mean.x() - 0.3 * time * time).abs() < 1e-12, "{}", mean.x());
        // ∫ 0.6 t dt less 0.6 · 0.5/2 for each second.
        assert!((held.x() - (0.3 * time * time - 0.15 * time)).abs() < 1e-12, "{}", held.x());
    }
}

#[test]
fn speeds_and_turn_rates_in_rows_of_their_own_and_in_one_are_the_same() {
    let (v, omega) = (|t: f64| 1.0 + 0.3 * libm::sin(t), |t: f64| 0.2 * libm::cos(0.7 * t));
    let times = || (0..40).map(|k| 0.25 * f64::from(k));
    let one: Vec<_> = times().map(|t| (t, Event::Velocity { v: v(t), omega: omega(t) })).collect();
    let two: Vec<_> =
        times().flat_map(|t| [(t, Event::Speed { v: v(t) }), (t, Event::TurnRate { omega: omega(t) })]).collect();
    assert_eq!(reckoned(&even(&one), Delays::default()), reckoned(&even(&two), Delays::default()));
    let apart = Delays { speed: 0.1, turn: -0.05, ..Delays::default() };
    assert_eq!(reckoned(&even(&one), apart), reckoned(&even(&two), apart));
}

#[test]
fn a_rate_of_its_own_times_has_the_mean_with_the_next_of_its_kind_and_the_last_is_held() {
    let turns = |time| (time, Event::TurnRate { omega: 0.0 });
    let rows = [
        (0.0, Event::Speed { v: 1.0 }),
        turns(0.0),
        turns(1.0),
        (2.0, Event::Speed { v: 3.0 }),
        turns(2.0),
        turns(5.0),
    ];
    // 2 m/s for two seconds, and 3 m/s, the last, for three.
    assert!((reckoned(&even(&rows), Delays::default()).x() - 13.0).abs() < 1e-12);
}

#[test]
fn a_rate_is_held_over_a_long_step() {
    // A robot that is not read while it stands: two seconds at 1 m/s, slowing down in the third, then nothing for 20 s.
    let v = |time: f64, v: f64| (time, Event::Velocity { v, omega: 0.0 });
    let rows = [v(0.0, 1.0), v(1.0, 1.0), v(2.0, 1.0), v(3.0, 0.0), v(23.0, 2.0), v(24.0, 2.0), v(26.0, 4.0)];
    // 2.5 m until it stands, 2 m in the second after, and a step of two medians is no long one: 6 m.
    assert!((reckoned(&even(&rows), Delays::default()).x() - 10.5).abs() < 1e-12);
}

#[test]
fn a_circle_of_few_rows_is_met_between_them_to_within_its_chords() {
    let turns = Event::Velocity { v: 0.2, omega: 0.1 };
    let rows: Vec<_> = (0..30).map(|k| (f64::from(k), turns)).collect();
    let at = reckoned(&even(&rows), Delays::default());
    let radius = numerics::hypot(at.x(), at.y() - 2.0);
    assert!((radius - 2.0).abs() < 2.0 * 0.1 * 0.1 / 8.0, "{radius}");
    let held = reckoned(&Drive { motion: Motion::Velocity, ..even(&rows) }, Delays::default());
    assert!(numerics::hypot(held.x() - at.x(), held.y() - at.y()) > 0.05, "held, it turns behind each step");
}

#[test]
fn a_delay_of_the_fixes_is_told_to_a_hundredth_of_a_step() {
    // A robot that swings to and fro, read at 2 Hz, and fixes of its true place that are 0.15 s late.
    let place = |t: f64| 3.0 * libm::sin(0.4 * t);
    let speed = |t: f64| 1.2 * libm::cos(0.4 * t);
    let mut rows = Vec::new();
    for k in 0..120 {
        let time = 0.5 * f64::from(k);
        rows.push((time, Event::Velocity { v: speed(time), omega: 0.0 }));
        rows.push((time + 0.2, Event::Position { x: place(time + 0.05), y: 0.0, sigma: Some(0.02) }));
    }
    let innovation = |motion, fix| {
        let log = Drive { motion, ..even(&rows) };
        let settings = Settings { delays: Delays { fix, ..Delays::default() }, ..Settings::default() };
        let mut sum = 0.0;
        let course = Course::new(&log, settings).expect("sound settings");
        let mut replay = Replay::new(&course);
        while let Some(taken) = replay.take(&log, &course).expect("sound rows") {
            sum += taken.judged.map_or(0.0, |judged| -judged.log_likelihood());
        }
        sum
    };
    let best = |motion| {
        (-100..=100)
            .map(|k| 0.005 * f64::from(k))
            .min_by(|a, b| innovation(motion, *a).total_cmp(&innovation(motion, *b)))
    };
    assert_eq!(best(Motion::EvenVelocity), Some(0.15));
    assert!(best(Motion::Velocity).is_some_and(|it| (it - 0.15).abs() > 0.2), "held, half a step of it is the model's");
}
