use super::*;
use lab::Plain;
use std::f64::consts::PI;
use std::fmt::Write;

mod table;

fn logged(text: &str) -> Arc<LoggedDrive> {
    Arc::new(LoggedDrive::new(robot_log::parse(text).expect("a sound log").drive))
}

fn plaza() -> Arc<LoggedDrive> {
    logged(include_str!("../../../../content/logs/plaza1.csv"))
}

fn whole(logged: &Arc<LoggedDrive>, params: LogParams) -> RobotLog {
    let mut lab = RobotLog::start(Arc::clone(logged), params).expect("sound parameters");
    lab.run_all().expect("a sound log");
    lab
}

/// A circle of ten metres about a landmark in its middle, seen at every second row.
fn circle(rows: u32) -> String {
    let mut text = String::from("L,3,0,10\n");
    for i in 1..=rows / 2 {
        let time = f64::from(i) * 0.1;
        let _ = writeln!(text, "O,{time},0.1,0.01\nR,{time},3,{}", 10.0 + 0.1 * libm::sin(f64::from(i)));
    }
    text
}

#[test]
fn a_run_is_the_same_in_one_call_and_in_many() {
    let plaza = plaza();
    let params = LogParams { gate: BySensor::all(Some(0.999)), learn: true, ..LogParams::default() };
    let at_once = whole(&plaza, params);
    let mut in_parts = RobotLog::start(Arc::clone(&plaza), params).expect("sound parameters");
    for n in [1, 16, 5000, 100_000] {
        in_parts.run(n).expect("a sound log");
    }
    assert_eq!((in_parts.steps(), in_parts.digest), (plaza.rows(), at_once.digest));
    assert_eq!(in_parts.frame(), at_once.frame());
    let mut changed = whole(&plaza, LogParams::default());
    changed.set(params).expect("sound parameters");
    assert_eq!(changed.frame(), at_once.frame());
    let before = RobotLog::at(Arc::clone(&plaza), params, 5017).expect("within the log");
    let mut after = before.clone();
    after.run_all().expect("a sound log");
    assert_eq!(after.frame(), at_once.frame());
    assert_ne!(before.frame(), after.frame());
}

#[test]
fn what_is_refused_changes_nothing() {
    let plaza = plaza();
    let mut lab = RobotLog::at(Arc::clone(&plaza), LogParams::default(), 100).expect("within the log");
    let before = lab.frame();
    let bad = |change: fn(&mut LogParams)| {
        let mut params = LogParams::default();
        change(&mut params);
        params
    };
    for (params, argument) in [
        (bad(|p| p.gate = BySensor::all(Some(9.21))), "gate"),
        (bad(|p| p.gate = BySensor::all(Some(0.0))), "gate"),
        (bad(|p| p.gate = BySensor::all(Some(f64::NAN))), "gate"),
        (bad(|p| p.sigma_range = 0.0), "sigmaRange"),
        (bad(|p| p.sigma_distance = -0.1), "sigmaDistance"),
        (bad(|p| p.scale = f64::INFINITY), "scale"),
        (bad(|p| p.offset = f64::NAN), "offset"),
    ] {
        assert_eq!(lab.set(params).expect_err("refused").argument, argument);
        assert_eq!(RobotLog::start(Arc::clone(&plaza), params).expect_err("refused").argument, argument);
    }
    for n in [0, RobotLog::LAST_STEP + 1] {
        assert_eq!(lab.run(n).expect_err("refused").argument, "n");
    }
    let beyond = RobotLog::at(Arc::clone(&plaza), LogParams::default(), plaza.rows() + 1);
    assert_eq!(beyond.expect_err("refused").argument, "step");
    assert_eq!(lab.frame(), before);
}

#[test]
fn numbers_beyond_floating_point_are_refused_at_their_row() {
    let far = logged("L,1,0,5\nO,1,1,0\nR,1,1,5\nO,2,1e300,0\nR,2,1,5\nO,3,1,0\n");
    let mut lab = RobotLog::at(Arc::clone(&far), LogParams::default(), 2).expect("within the log");
    let before = (lab.steps(), lab.digest, lab.frame());
    assert!(lab.run_all().is_err());
    assert_eq!((lab.steps(), lab.digest, lab.frame()), before);
}

#[test]
fn a_frame_stays_small_however_long_the_log_is() {
    let numbers = |rows| {
        let lab = whole(&logged(&circle(rows)), LogParams::default());
        let mut numbers = Vec::new();
        lab.frame().write(&mut numbers);
        assert!(numbers.iter().all(|number| number.is_finite()));
        numbers.len()
    };
    assert!(numbers(40_000) < 12_000 && numbers(160_000) < 12_000, "{} {}", numbers(40_000), numbers(160_000));
}

#[test]
fn a_log_without_truth_is_held_against_dead_reckoning() {
    let text = circle(400);
    let lab = whole(&logged(&text), LogParams { sigma_range: 0.1, ..LogParams::default() });
    let frame = lab.frame();
    assert_eq!((frame.truth, frame.summary.rmse, frame.reckoned_rmse), (None, None, None));
    assert!(frame.tracks.truth.is_empty() && frame.errors.error.is_empty() && !frame.errors.bound.is_empty());
    // Dead reckoning drives the circle on which every range is 10 m, so what is read less that is the reading's own
    // wave.
    assert!(frame.ranges.range.iter().all(|range| (range - 10.0).abs() < 0.1), "{:?}", frame.ranges.range);
    assert_eq!(frame.summary.used, 200);
    let held = whole(&logged(&text), LogParams { sightings: false, ..LogParams::default() }).frame();
    assert_eq!((held.summary.used, held.bands, held.sighting), (0, None, None));
    assert_eq!(held.ranges, frame.ranges, "what is read does not depend on the filter");
    assert!(held.innovations.time.is_empty() && held.correlation.values.is_empty());
}

#[test]
fn the_statistics_of_the_frame_are_those_of_the_summary() {
    let LogFrame { summary, correlation, nis, histogram, bands, innovations, .. } =
        whole(&plaza(), LogParams::default()).frame();
    let near = |a: f64, b: f64, by: f64| assert!((a - b).abs() < by, "{a} against {b}");
    near(correlation.values[0], summary.lag1.expect("sightings were used"), 1e-12);
    // The blocks leave a rest of less than one block out.
    let mean = nis.mean.iter().sum::<f64>() / nis.mean.len() as f64;
    near(mean, summary.nis.expect("sightings were used"), 0.1);
    let within: f64 = histogram.density.iter().sum::<f64>() * histogram.width;
    near(within + histogram.beyond, 1.0, 1e-12);
    let Some(LogBands { nis: [low, high], mean }) = bands else { panic!("sightings were used") };
    assert!(low < 1.0 && 1.0 < high && mean > 0.0 && high - low < 0.1);
    assert!(innovations.used.iter().all(|used| *used));
}

#[test]
fn the_timeline_leads_to_every_part_of_the_log() {
    let plaza = plaza();
    let LogTimeline { time, step } = plaza.timeline();
    assert!(time.len() <= 241 && time.windows(2).all(|pair| pair[0] <= pair[1]));
    assert_eq!((step[0], step[step.len() - 1]), (1, plaza.rows()));
    let at = RobotLog::at(Arc::clone(&plaza), LogParams::default(), step[100]).expect("within the log");
    assert_eq!(at.frame().time, time[100]);
    assert_eq!(logged("O,5,1,0\n").timeline().step, [1]);
}

#[test]
fn bearings_and_velocities_are_replayed_too() {
    let mut text = String::from("L,1,5,5\nL,2,-5,5\nG,0,0,0,0\nV,0,1,0.1\n");
    let mut pose = [0.0, 0.0, 0.0_f64];
    for i in 1..=200 {
        pose = [pose[0] + 0.05 * libm::cos(pose[2]), pose[1] + 0.05 * libm::sin(pose[2]), pose[2] + 0.005];
        let to = |x: f64, y: f64| {
            let (dx, dy) = (x - pose[0], y - pose[1]);
            (dx.hypot(dy), libm::atan2(dy, dx) - pose[2])
        };
        let (id, (range, bearing)) = if i % 2 == 0 { (1, to(5.0, 5.0)) } else { (2, to(-5.0, 5.0)) };
        let time = 0.05 * f64::from(i);
        let _ = writeln!(text, "B,{time},{id},{range},{bearing}\nG,{time},{},{},{}", pose[0], pose[1], pose[2]);
    }
    text.push_str("V,10,0,0\n");
    let lab = whole(&logged(&text), LogParams::default());
    let frame = lab.frame();
    assert!(frame.bearings && frame.summary.rmse.expect("there is a truth") < 0.1, "{:?}", frame.summary);
    assert_eq!(frame.summary.used, 200);
}

#[test]
fn readings_are_counted_for_each_landmark() {
    let plaza = plaza();
    let frame = whole(&plaza, LogParams { gate: BySensor::all(Some(0.999)), ..LogParams::default() }).frame();
    let [used, refused] = frame.by_landmark.iter().fold([0, 0], |[u, r], it| [u + it.used, r + it.refused]);
    assert_eq!((used, refused), (frame.summary.used, frame.summary.refused));
    assert_eq!(frame.by_landmark.iter().map(|it| it.id).collect::<Vec<_>>(), [0, 1, 6, 5]);
    let dead = whole(&plaza, LogParams { sightings: false, ..LogParams::default() }).frame();
    assert!(dead.by_landmark.is_empty());
}

/// A car's log under the settings of the reference.
fn car(params: LogParams) -> RobotLog {
    let log = logged(include_str!("../../../../content/logs/car.csv"));
    whole(&log, LogParams { sigma_distance: 0.3, sigma_turn: 0.03, start_sigma: 1.0, ..params })
}

#[test]
fn fixes_are_drawn_with_what_became_of_them() {
    let every = BySensor { fix: 1.0, ..BySensor::default() };
    let params = LogParams { every, withheld: Some([100.0, 130.0]), ..LogParams::default() };
    let LogFrame { fixes, fix_innovations, innovations, every, every_looked, summary, smoothed, .. } =
        car(params).frame();
    assert_eq!((every, every_looked, smoothed), (5, 1, None));
    assert_eq!(fixes.x.len(), 2067_usize.div_ceil(5));
    let count = |outcome| fixes.outcome.iter().filter(|other| **other == outcome).count();
    assert!((60..65).contains(&count(FixOutcome::Withheld)) && count(FixOutcome::Refused) == 0);
    assert!(count(FixOutcome::Used) > 20 && count(FixOutcome::Unused) > 250);
    // Every fix that is looked at is there.
    assert_eq!((fix_innovations.along.len(), innovations.time.len()), (summary.used as usize, summary.used as usize));
    let mean = fix_innovations.along.iter().sum::<f64>() / f64::from(summary.used);
    let fix = summary.sensors.fix.expect("fixes");
    assert!((mean - fix.mean_along.expect("used")).abs() < 1e-12);
    let off = car(LogParams { fixes: false, ..LogParams::default() }).frame();
    assert!(off.fixes.outcome.iter().all(|outcome| *outcome == FixOutcome::Unused) && off.innovations.time.is_empty());
    assert_eq!(off.tracks.estimate, off.tracks.reckoning);
}

#[test]
fn a_smoothed_track_is_of_the_rows_that_are_taken() {
    let log = logged(include_str!("../../../../content/logs/car.csv"));
    let mut lab = RobotLog::at(log, LogParams::default(), 5000).expect("within the log");
    let digest = lab.digest();
    lab.smooth().expect("factored");
    let frame = lab.frame();
    let smoothed = frame.smoothed.expect("asked for");
    assert_eq!((&smoothed.time, lab.digest()), (&frame.errors.time, digest));
    let narrower = smoothed.bound.iter().zip(&frame.errors.bound).filter(|(smoothed, filter)| smoothed < filter);
    assert!(narrower.count() > smoothed.bound.len() / 2);
    lab.run(1).expect("sound");
    assert_eq!(lab.frame().smoothed, None);
}

#[test]
fn one_value_for_all_sensors_and_a_sensor_that_is_not_there_are_shown_so() {
    let json = |params: LogParams| {
        let frame = serde_json::to_value(lab::Shown(&car(params).frame())).expect("numbers");
        (frame["params"]["gate"].clone(), frame["summary"]["sensors"].clone())
    };
    let (gate, sensors) = json(LogParams { gate: BySensor::all(Some(0.9)), ..LogParams::default() });
    assert_eq!(gate, 0.9);
    assert_eq!(
        sensors.as_object().map(|sensors| sensors.keys().cloned().collect::<Vec<_>>()),
        Some(vec!["fix".into()])
    );
    let (gate, _) =
        json(LogParams { gate: BySensor { fix: Some(0.9), ..BySensor::default() }, ..LogParams::default() });
    assert_eq!(gate, serde_json::json!({ "fix": 0.9, "heading": null, "range": null, "bearing": null }));
}

#[test]
fn a_turned_camera_shows_in_the_bearings_of_each_landmark() {
    let places = [[9.0, 0.0], [0.0, 9.0], [-9.0, 0.0], [0.0, -9.0]];
    let turned = 2.0_f64.to_radians();
    let (mut text, mut at) = (String::from("L,1,9,0\nL,2,0,9\nL,3,-9,0\nL,4,0,-9\n"), [5.0, 0.0, 0.5 * PI]);
    for i in 0..400_u32 {
        let ([x, y, theta], time) = (at, 0.1 * f64::from(i));
        let [lx, ly] = places[i as usize % 4];
        let (range, bearing) = (libm::hypot(lx - x, ly - y), libm::atan2(ly - y, lx - x) - theta + turned);
        let _ = writeln!(text, "G,{time},{x},{y},{theta}\nV,{time},2.5,0.5\nB,{time},{},{range},{bearing}", 1 + i % 4);
        at = [x + 0.25 * libm::cos(theta), y + 0.25 * libm::sin(theta), theta + 0.05];
    }
    let sigmas = LogParams { sigma_distance: 0.01, sigma_turn: 0.001, sigma_range: 0.02, ..LogParams::default() };
    let frame = |bearing_offset| whole(&logged(&text), LogParams { bearing_offset, ..sigmas }).frame();
    let LogFrame { mean_bearing, landmark_statistics: each, innovations, .. } = frame(0.0);
    assert!(mean_bearing.is_some_and(|mean| (0.8..1.1).contains(&(mean / turned))), "{mean_bearing:?}");
    assert!(each.iter().all(|seen| seen.mean_bearing.is_some_and(|mean| mean > 0.5 * turned)));
    assert_eq!((innovations.second.len(), innovations.landmark[1]), (innovations.time.len(), Some(2)));
    let told = frame(turned).mean_bearing;
    assert!(told.is_some_and(|mean| mean.abs() < 1e-3), "{told:?}");
}

#[test]
fn the_settings_that_a_reader_finds_are_those_of_the_core() {
    assert_eq!(Settings::from(LogParams::default()), Settings::default());
}
