use super::*;
use crate::late_readings::drive::{continuous, start};
use crate::late_readings::plan::{CAMERA, ticks};
use estimate::dynamic::{Memory, Outcome, Sensor, Timeline};
use nalgebra::{DMatrix, DVector, dmatrix};
use sim::scenarios::THREE_SENSORS;

fn of(params: LateParams) -> LateFrame {
    LateReadings::new(params).expect("in reach").frame()
}

fn open(way: Way) -> LateParams {
    LateParams { way, ..LateParams::default() }
}

fn alone(way: Way) -> LateParams {
    LateParams { sonar_rate: 0.0, laser_rate: 0.0, ..open(way) }
}

/// The mean over 500 seeds of each of [`COSTS`] numbers.
fn over_seeds(params: LateParams) -> [f64; COSTS] {
    let costs = LateReadings::new(params).expect("in reach").seeds(0, SEEDS).expect("within the limit");
    std::array::from_fn(|i| costs.iter().skip(i).step_by(COSTS).sum::<f64>() / f64::from(SEEDS))
}

#[test]
fn going_back_answers_what_the_time_line_of_the_core_answers_at_every_moment() {
    for params in [
        open(Way::GoBack),
        LateParams { own_delay: Some(5.0), gap: Some([6.0, 7.5]), ..open(Way::GoBack) },
        LateParams { course: Course::ToAndFro, removed: true, delay: 1.3, camera_rate: 4.0, ..open(Way::GoBack) },
    ] {
        let lab = LateReadings::new(params).expect("in reach");
        let sensors = (0..3).map(|i| Sensor {
            name: i.to_string(),
            h: dmatrix![1.0, 0.0],
            w: dmatrix![THREE_SENSORS.sigma[i] * THREE_SENSORS.sigma[i]],
            delay: 0.0,
            gate: None,
        });
        let variances = THREE_SENSORS.p0_sigma.map(|sigma| sigma * sigma);
        let p = DMatrix::from_diagonal(&DVector::from_column_slice(&variances));
        let belief = Belief { x: DVector::from_column_slice(start().as_slice()), p };
        let memory = Memory { window: 20.0, capacity: 10_000 };
        let system = continuous().expect("the chapter's");
        let mut line = Timeline::new(system, &belief, 0.0, memory, sensors.collect()).expect("right");
        // Ticks for seconds: the input of a tick acts from it on.
        for (k, u) in lab.drive.inputs.iter().enumerate() {
            line.input(plan::seconds(k), &[*u]).expect("in order");
        }
        let (mut next, mut worst) = (0, 0.0_f64);
        for k in 1..=THREE_SENSORS.ticks {
            while let Some(one) = lab.plan.readings.get(next).filter(|one| one.came == k) {
                let y = lab.drive.readings[one.measured][one.sensor];
                let name = one.sensor.to_string();
                let placed = line.reading(&name, plan::seconds(one.measured), &[Some(y)], 0).expect("right");
                assert_eq!(placed.outcome, Outcome::Accepted);
                next += 1;
            }
            let at = line.at(plan::seconds(k)).expect("in the window");
            worst = worst.max((at.x[0] - lab.followed.live[k].x[0]).abs());
            worst = worst.max((at.p[(0, 0)] - lab.followed.live[k].p[(0, 0)]).abs());
        }
        // 400 steps in place of one from event to event, on positions up to 30 m.
        assert!(worst < 1e-9, "{worst}");
    }
}

#[test]
fn nothing_late_makes_the_three_ways_one() {
    let lab = LateReadings::new(LateParams { delay: 0.0, ..open(Way::AsNew) }).expect("in reach");
    let frame = lab.frame();
    assert_eq!(frame.ways[0], frame.ways[1]);
    assert_eq!(frame.ways[0], frame.ways[2]);
    assert_eq!(frame.travelled, 0.0);
    assert_eq!(frame.sensors[CAMERA].measured, frame.sensors[CAMERA].came);
}

#[test]
fn the_drive_and_the_noise_stay_when_anything_else_changes() {
    let first = LateReadings::new(open(Way::AsNew)).expect("in reach");
    let mut other = first.clone();
    other.set(LateParams { sonar_rate: 2.0, delay: 1.5, gap: Some([3.0, 4.0]), ..open(Way::Drop) }).expect("in reach");
    assert_eq!(first.frame().position, other.frame().position);
    assert!(Rc::ptr_eq(&first.drive, &other.drive));
    other.set(LateParams { seed: 2, ..open(Way::Drop) }).expect("in reach");
    assert_ne!(first.frame().position, other.frame().position);
}

#[test]
fn a_late_reading_taken_as_new_is_off_by_the_way_driven_since() {
    for delay in [0.3, 0.6, 1.2] {
        let frame = of(LateParams { delay, ..alone(Way::AsNew) });
        // Alone the estimate follows the late readings, and its innovations tell nothing: the error is all in the lag.
        let camera = frame.sensors[CAMERA].mean.expect("read");
        assert!((frame.lag - frame.travelled).abs() < 0.05, "{} {}", frame.lag, frame.travelled);
        assert!(camera.abs() < 0.05, "{camera}");
        // Beside others it lags by its share, and the innovation has the rest.
        let beside = of(LateParams { delay, ..open(Way::AsNew) });
        let camera = beside.sensors[CAMERA].mean.expect("read");
        assert!(beside.lag > 0.5 * beside.travelled && beside.lag < 0.9 * beside.travelled);
        assert!(camera < -0.3 * beside.travelled && camera > -beside.travelled, "{camera}");
        // In its place it is a reading like any other.
        let back = of(LateParams { delay, ..open(Way::GoBack) });
        assert!(back.sensors[CAMERA].mean.expect("read").abs() < 0.05 && back.lag.abs() < 0.05);
    }
}

#[test]
fn dropping_costs_little_beside_another_fine_sensor_and_much_alone() {
    let [new, new_nees, dropped, dropped_nees, back, back_nees] = over_seeds(open(Way::AsNew));
    assert!(new > 3.0 * dropped && dropped < 1.4 * back && dropped > back, "{new} {dropped} {back}");
    // The means of 500 runs of 301 correlated values, each of mean 2.
    assert!((dropped_nees - 2.0).abs() < 0.1 && (back_nees - 2.0).abs() < 0.1 && new_nees > 50.0);
    let [new, _, dropped, _, back, _] = over_seeds(alone(Way::AsNew));
    assert!(dropped > 4.0 * new && new > 4.0 * back, "{new} {dropped} {back}");
}

#[test]
fn a_gap_grows_as_its_noise_says_and_the_smoother_closes_it_from_both_ends() {
    let params = LateParams { gap: Some([8.0, 13.0]), delay: 0.0, smooth: true, ..open(Way::GoBack) };
    let lab = LateReadings::new(params).expect("in reach");
    let gap = lab.frame().gap.expect("open");
    // From the last tick before the gap on: P₁₁ + 2 t P₁₂ + t² P₂₂ + q t³/3.
    let (before, after) = (ticks(gap.from) - 1, ticks(gap.to) - 1);
    let p = &lab.followed.live[before].p;
    let t = plan::seconds(after - before);
    let grown = p[(0, 0)] + 2.0 * t * p[(0, 1)] + t * t * p[(1, 1)] + THREE_SENSORS.q * t * t * t / 3.0;
    assert!((gap.sigma_after - grown.sqrt()).abs() < 1e-9, "{} {}", gap.sigma_after, grown.sqrt());
    let (worst, helped) = (gap.worst_place.expect("smoothed"), gap.helped_place.expect("smoothed"));
    assert!((0.35..0.65).contains(&worst) && helped > 0.95, "{worst} {helped}");
    assert!(gap.sigma_smoothed.expect("smoothed") < 0.3 * gap.sigma_after);
    // Nowhere is the smoother less sure than the filter, and at the end they are one.
    for (k, later) in lab.smoothed.iter().enumerate() {
        assert!(later.p[(0, 0)] <= lab.followed.live[k + 1].p[(0, 0)] + 1e-12);
    }
    let (last, live) = (lab.smoothed.last().expect("there"), lab.followed.live.last().expect("there"));
    assert!((last.x[0] - live.x[0]).abs() < 1e-9);
}

#[test]
fn a_reading_in_hand_comes_when_it_is_put_and_is_gone_when_it_is_removed() {
    let count = |params| of(params).sensors[CAMERA].came.len();
    let all = count(open(Way::GoBack));
    let held = of(LateParams { own_delay: Some(4.0), ..open(Way::GoBack) });
    let picked = held.picked.expect("the camera reads");
    assert!((picked.came - picked.measured - 4.0).abs() < 1e-12);
    assert_eq!(count(LateParams { removed: true, ..open(Way::GoBack) }), all - 1);
    // One that comes after the end of the run never comes in it.
    let late = LateParams { picked: 99, own_delay: Some(9.0), ..open(Way::GoBack) };
    assert!(of(late).picked.expect("there").came > 20.0 && count(late) == all);
    // What is put where it came from changes nothing.
    let same = LateParams { own_delay: Some(0.6), ..open(Way::GoBack) };
    assert_eq!(of(same).error, of(open(Way::GoBack)).error);
    assert!(of(LateParams { gap: Some([9.0, 11.0]), ..open(Way::Drop) }).picked.expect("there").missing);
    assert_eq!(of(LateParams { camera_rate: 0.0, ..open(Way::Drop) }).picked, None);
}

#[test]
fn without_any_sensor_there_is_a_frame_all_the_same() {
    let frame = of(LateParams { camera_rate: 0.0, gap: Some([5.0, 5.0]), smooth: true, ..alone(Way::GoBack) });
    assert!(frame.sensors.iter().all(|one| one.mean.is_none() && one.nis.is_none() && one.period == 0.0));
    assert!(frame.gap.is_none() && frame.ways.iter().all(|way| way.rms.is_finite() && way.nees.is_finite()));
    let whole = of(LateParams { gap: Some([20.0, 0.0]), smooth: true, ..open(Way::GoBack) }).gap.expect("all of it");
    assert!(whole.sigma_before == THREE_SENSORS.p0_sigma[0] && whole.sigma_after > 1.0);
}

#[test]
fn the_seeds_are_runs_of_the_lab() {
    let lab = LateReadings::new(LateParams { course: Course::ToAndFro, ..open(Way::AsNew) }).expect("in reach");
    let costs = lab.seeds(7, 2).expect("within the limit");
    for (i, seed) in [7, 8].into_iter().enumerate() {
        let run = of(LateParams { seed, course: Course::ToAndFro, ..open(Way::Drop) });
        let expected: Vec<f64> = run.ways.iter().flat_map(|way| [way.rms, way.nees]).collect();
        assert_eq!(costs[COSTS * i..COSTS * (i + 1)], expected);
    }
    assert_eq!(lab.seeds(0, 501).expect_err("too many").argument, "count");
}

#[test]
fn bad_parameters_of_the_late_readings_are_refused_by_name() {
    let refused = |params| LateReadings::new(params).expect_err("refused");
    assert_eq!(refused(LateParams { delay: 2.1, ..open(Way::Drop) }).argument, "delay");
    assert_eq!(refused(LateParams { gap: Some([1.0, 20.5]), ..open(Way::Drop) }).argument, "gap[1]");
    assert_eq!(refused(LateParams { own_delay: Some(f64::NAN), ..open(Way::Drop) }).code, Code::NotFinite);
    assert_eq!(refused(LateParams { sonar_rate: -1.0, ..open(Way::Drop) }).code, Code::Limit);
}
