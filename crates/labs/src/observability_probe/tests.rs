use super::*;

fn at(params: ProbeParams, steps: u32) -> ObservabilityProbe {
    let mut probe = ObservabilityProbe::new(params).expect("sound parameters");
    probe.run(steps).expect("within the limit");
    probe
}

fn with(count: u32, sensor: SensorKind) -> ProbeParams {
    ProbeParams { count, sensor, ..Default::default() }
}

#[test]
fn one_range_bearing_landmark_has_rank_three_frozen_and_two_along_the_path() {
    let frame = at(with(1, SensorKind::RangeBearing), 100).frame();
    assert_eq!((frame.frozen.rank, frame.along_path.rank), (3, 2));
    // The invisible turn about the landmark: [−Δy, Δx, 1] at the true pose.
    let (dx, dy) = (frame.truth[0] - 6.0, frame.truth[1] - 6.0);
    let [x, y, turn] = frame.along_path.directions[0];
    assert!((x / turn + dy).abs() < 1e-6 && (y / turn - dx).abs() < 1e-6);
}

#[test]
fn the_invisible_direction_of_one_range_is_a_tangent_frozen_and_a_turn_along_the_path() {
    let frame = at(with(1, SensorKind::Range), 100).frame();
    assert_eq!((frame.frozen.rank, frame.along_path.rank), (2, 2));
    let (dx, dy) = (frame.estimate[0] - 6.0, frame.estimate[1] - 6.0);
    let [x, y, turn] = frame.frozen.directions[0];
    assert!(turn.abs() < 1e-9 && (x * dx + y * dy).abs() < 1e-9, "frozen: across the line of sight");
    assert!(frame.along_path.directions[0][2].abs() > 0.05, "along the path: heading included");
}

#[test]
fn two_landmarks_show_everything_and_shrink_the_ellipse() {
    let (one, two) = (at(with(1, SensorKind::Range), 240).frame(), at(with(2, SensorKind::Range), 240).frame());
    assert_eq!((two.frozen.rank, two.along_path.rank), (3, 3));
    assert!(one.trace.total > 8.0 * two.trace.total);
    assert_eq!(one.trace.reference, two.trace.reference);
    assert!((two.trace.reference - 0.03402).abs() < 5e-6);
    assert_eq!(one.truth, two.truth);
}

#[test]
fn stopped_a_range_and_bearing_cannot_pin_three() {
    let params = ProbeParams { stop: Some(50), ..with(1, SensorKind::RangeBearing) };
    let frame = at(params, 90).frame();
    assert_eq!((frame.frozen.rank, frame.along_path.rank, frame.moving), (2, 2, false));
    assert_eq!(frame.truth, at(params, 50).frame().truth);
    let driving = at(ProbeParams { stop: None, ..params }, 50).frame();
    assert_eq!(driving.truth, frame.truth);
}

#[test]
fn stopped_one_range_leaves_two_directions_open() {
    let frame = at(ProbeParams { stop: Some(50), ..with(1, SensorKind::Range) }, 51).frame();
    assert_eq!((frame.frozen.rank, frame.frozen.directions.len()), (1, 2));
}

#[test]
fn snapped_onto_the_line_a_landmark_costs_a_rank() {
    let probe = at(with(2, SensorKind::Range), 75);
    assert_eq!(probe.frame().frozen.rank, 3);
    for j in 0..2 {
        let mut params = probe.params;
        params.landmarks[j as usize] = probe.collinear_point(j).expect("two are shown");
        let snapped = at(params, 75).frame();
        assert_eq!(snapped.frozen.rank, 2, "landmark {j}: {:?}", snapped.frozen.relative);
        assert_eq!(snapped.along_path.rank, 3, "crossing a line is momentary");
    }
    assert_eq!(probe.collinear_point(2).expect_err("not shown").code, Code::Index);
    assert_eq!(at(with(1, SensorKind::Range), 5).collinear_point(0).expect_err("no line").code, Code::Index);
}

#[test]
fn the_forgotten_map_is_founded_once_and_matched_after() {
    let params = ProbeParams { forget: true, count: 3, ..Default::default() };
    let frame = at(params, 199).frame();
    let slam = frame.slam.expect("a map");
    assert_eq!((slam.sightings, slam.founded, slam.spurious, slam.wrong), (600, 3, 0, 0));
    assert_eq!(slam.matched + slam.rejected, 597);
    assert_eq!(frame.sensor, SensorKind::RangeBearing);
    // A shift and a turn of the whole world change no reading: three directions of nine are unseen.
    assert_eq!((frame.along_path.n, frame.along_path.rank), (9, 6));
    assert_eq!(frame.sightings.len(), 3);
    assert!(frame.sightings.iter().all(|s| s.to.is_some()));
}

#[test]
fn a_lab_opened_from_its_state_is_the_same_lab() {
    for forget in [false, true] {
        let probe = at(ProbeParams { forget, count: 2, seed: 9, ..Default::default() }, 130);
        let again = ObservabilityProbe::from_state(probe.state()).expect("a state of its own");
        assert_eq!(again.digest(), probe.digest());
        let json = |p: &ObservabilityProbe| serde_json::to_string(&lab::Shown(&p.frame())).expect("plain");
        assert_eq!(json(&again), json(&probe));
    }
}

#[test]
fn memory_is_bounded_however_long_the_run() {
    let probe = at(Default::default(), 3000);
    let frame = probe.frame();
    assert_eq!((frame.series.trace.len(), probe.tracks.truth.len()), (lab::WINDOW, TRACK));
    assert!(frame.tracks.truth.len() < 10, "the corners of the square");
    assert_eq!(frame.along_path.steps, PATH_STEPS);
    assert_eq!(frame.lap, 25);
}

#[test]
fn bad_parameters_are_refused_by_name() {
    let base = ProbeParams::default();
    let mut outside = base;
    outside.landmarks[1][0] = 6.5;
    let mut nan = base;
    nan.landmarks[2][1] = f64::NAN;
    for (params, code, argument) in [
        (outside, Code::Limit, "landmarks[1][0]"),
        (nan, Code::NotFinite, "landmarks[2][1]"),
        (ProbeParams { count: 0, ..base }, Code::Limit, "count"),
        (ProbeParams { count: 4, ..base }, Code::Limit, "count"),
        (ProbeParams { tolerance: -1.0, ..base }, Code::Tolerance, "tolerance"),
        (ProbeParams { tolerance: 1.5, ..base }, Code::Tolerance, "tolerance"),
    ] {
        let error = ObservabilityProbe::new(params).expect_err(argument);
        assert_eq!((error.code, error.argument.as_ref()), (code, argument));
    }
}

/// Landmarks on the path, on each other, in a corner: nothing that can be dragged to stops the run.
#[test]
fn every_arrangement_runs() {
    let spots = [[0.0, 0.0], [1.5, 1.5], [4.5, 1.5], [3.0, 1.5], [3.0, 3.0], [6.0, 6.0], [1.6, 1.5]];
    for a in spots {
        for b in spots {
            for (sensor, forget) in
                [(SensorKind::Range, false), (SensorKind::RangeBearing, false), (SensorKind::Range, true)]
            {
                let params = ProbeParams { landmarks: [a, b, a], count: 3, sensor, forget, ..Default::default() };
                let frame = at(params, 130).frame();
                assert!(frame.estimate.iter().chain(frame.p.iter().flatten()).all(|e| e.is_finite()), "{params:?}");
            }
        }
    }
}

/// Three landmarks so close together that a sighting of one is often taken for a new one.
#[test]
fn a_map_of_ghosts_is_closed_when_it_is_full() {
    let params =
        ProbeParams { count: 3, forget: true, landmarks: [[2.0, 3.0], [2.3, 3.0], [2.6, 3.0]], ..Default::default() };
    let slam = |steps| at(params, steps).frame().slam.expect("a map");
    let full = slam(10_000);
    assert!(full.full && full.landmarks.len() <= MAX_MAP, "{} landmarks", full.landmarks.len());
    assert!(full.spurious > 0);
    assert!(!slam(1).full);
}

#[test]
fn the_bands_are_the_intervals_of_chi_squared_to_the_last_bit() {
    let bits = |band: [f64; 2]| band.map(f64::to_bits);
    assert!(view::BANDS[0].iter().all(|bound| bound.is_nan()), "nothing is read, and no bound is known");
    for (dof, band) in (1..).zip(&view::BANDS[1..]) {
        let (low, high) = filters::consistency::chi2_interval(dof, 1, 0.95).expect("in range");
        assert_eq!(bits(*band), bits([low, high]), "{dof} degrees of freedom: {band:?}, and not [{low:?}, {high:?}]");
    }
}

fn haunted(count: u32, sensor: SensorKind, [around, shift, turn]: [f64; 3]) -> ProbeParams {
    let ghost =
        ProbeParams { ghost: true, ghost_around: around, ghost_shift: shift, ghost_turn: turn, ..Default::default() };
    ProbeParams { count, sensor, ..ghost }
}

#[test]
fn turned_about_the_one_landmark_with_its_heading_the_ghost_reads_what_the_robot_reads() {
    for sensor in [SensorKind::Range, SensorKind::RangeBearing] {
        let frame = at(haunted(1, sensor, [0.2, 0.0, 0.2]), 240).frame();
        let ghost = frame.ghost.expect("it drives along");
        // Rounding of a drive of 240 steps; the ghost is more than a metre away.
        assert!(ghost.range_gap < 1e-12 && ghost.bearing_gap.unwrap_or(0.0) < 1e-12 && ghost.moved > 1.0, "{ghost:?}");
        let (by_hand, computed) = (ghost.by_hand.expect("a direction"), frame.along_path.directions[0]);
        assert!((0..3).all(|i| (by_hand[i] - computed[i]).abs() < 1e-6), "{by_hand:?} and {computed:?}");
        assert_eq!(ghost.bearing_gap.is_some(), sensor == SensorKind::RangeBearing);
        assert_eq!(ghost.readings[0].range.len(), frame.series.step.len());
    }
}

#[test]
fn any_other_mix_changes_a_reading_and_a_second_landmark_leaves_no_mix() {
    let gap = |params| at(params, 240).frame().ghost.expect("it drives along").range_gap;
    for dials in [[0.2, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.2], [0.2, 0.0, 0.1], [0.2, 0.0, -0.2], [0.2, 0.1, 0.2]]
    {
        assert!(gap(haunted(1, SensorKind::Range, dials)) > 0.05, "{dials:?}");
    }
    assert!(gap(haunted(2, SensorKind::Range, [0.2, 0.0, 0.2])) > 0.5);
    // With the heading left alone the range is that of the start, and the bearing already is another.
    let start = at(haunted(1, SensorKind::RangeBearing, [0.2, 0.0, 0.2]), 240);
    let alone = ObservabilityProbe::new(haunted(1, SensorKind::RangeBearing, [0.2, 0.0, 0.0])).expect("sound");
    let ghost = alone.frame().ghost.expect("it stands there");
    assert!(ghost.range_gap < 1e-14 && (ghost.bearing_gap.expect("read") - 0.2).abs() < 1e-14);
    assert_eq!(
        start.frame().tracks,
        at(with(1, SensorKind::RangeBearing), 240).frame().tracks,
        "the robot knows of no ghost"
    );
}

#[test]
fn there_is_no_ghost_unless_one_is_wanted_and_none_without_a_map() {
    assert_eq!(at(Default::default(), 5).frame().ghost, None);
    assert_eq!(at(ProbeParams { forget: true, ..haunted(1, SensorKind::Range, [0.1; 3]) }, 5).frame().ghost, None);
    let still = at(haunted(1, SensorKind::Range, [0.0; 3]), 50).frame().ghost.expect("it drives along");
    assert_eq!((still.by_hand, still.moved, still.range_gap), (None, 0.0, 0.0));
}
