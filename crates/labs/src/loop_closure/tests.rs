use super::*;
use crate::observability_probe::Fate;
use estimate::Code;

fn at(params: LoopParams, steps: u32) -> LoopFrame {
    let mut lab = LoopClosure::new(params).expect("sound parameters");
    lab.run(steps).expect("within the limit");
    lab.frame()
}

#[test]
fn closing_the_loop_shrinks_every_landmark_s_ellipse_at_once() {
    let mut lab = LoopClosure::new(LoopParams::default()).expect("sound");
    let closure = loop {
        lab.step().expect("within the limit");
        assert!(lab.step < LOOP_CLOSURE.course.lap() + 10, "a lap leads back to the start");
        if let Some(closure) = lab.closure {
            break closure;
        }
    };
    assert_eq!(closure.step, lab.step);
    assert!(closure.after < 0.8 * closure.before, "{closure:?}");
    let frame = lab.frame();
    let seen: Vec<usize> = frame.sightings.iter().map(|sighting| sighting.landmark).collect();
    let far: Vec<_> = frame.pulls.iter().filter(|pull| !seen.contains(&(pull.id as usize))).collect();
    assert!(far.len() > 5, "landmarks that were not read are pulled too");
    assert!(far.iter().all(|pull| pull.reach > 0.0 && pull.from != pull.to), "{far:?}");
    lab.step().expect("within the limit");
    assert!(lab.frame().pulls.is_empty(), "only the closing step has pulls");
    lab = LoopClosure::new(LoopParams::default()).expect("sound");
    lab.run(closure.step).expect("within the limit");
    for (before, after) in lab.predicted.landmarks().zip(lab.mapping.slam.landmarks()) {
        assert!(after.p.trace() < before.p.trace(), "landmark {}", after.id);
    }
}

#[test]
fn the_right_filter_correlates_all_and_the_wrong_one_nothing() {
    let [right, wrong] = [true, false].map(|correlated| at(LoopParams { correlated, ..Default::default() }, 100));
    let off = |frame: &LoopFrame| {
        let c = &frame.correlation;
        assert_eq!(c.len(), frame.map.landmarks.len() + 1);
        (0..c.len()).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| c[i][j].abs()).collect::<Vec<_>>()
    };
    assert!(right.correlation.iter().enumerate().all(|(i, row)| (row[i] - 1.0).abs() < 1e-15));
    let (right, wrong) = (off(&right), off(&wrong));
    assert!(right.iter().all(|c| *c > 0.0 && *c <= 1.0 + 1e-12), "{right:?}");
    assert!(wrong.iter().all(|c| *c == 0.0), "{wrong:?}");
}

#[test]
fn the_wrong_filter_sees_the_same_and_claims_too_much() {
    let [right, wrong] = [true, false].map(|correlated| at(LoopParams { correlated, ..Default::default() }, 100));
    assert_eq!(right.truth, wrong.truth);
    let ranges = |frame: &LoopFrame| frame.sightings.iter().map(|s| (s.landmark, s.range)).collect::<Vec<_>>();
    assert_eq!(ranges(&right), ranges(&wrong));
    let claims = |frame: &LoopFrame| frame.series.sigma.iter().last().expect("steps");
    assert!(claims(&wrong) < 0.5 * claims(&right), "{} {}", claims(&wrong), claims(&right));
}

#[test]
fn thresholds_that_cross_found_ghosts() {
    let apart = at(LoopParams::default(), 160);
    assert_eq!((apart.map.spurious, apart.map.wrong), (0, 0));
    let crossed = at(LoopParams { found: 5.0, ..Default::default() }, 160);
    assert_eq!((crossed.thresholds.gate, crossed.thresholds.found), (5.0, 5.0));
    assert!(crossed.map.spurious > 0);
    assert_eq!(apart.truth, crossed.truth);
    // 1 − exp(−9.21/2): the 99 % that the gate was chosen for.
    assert!((apart.thresholds.passes - 0.99).abs() < 1e-4);
}

/// Each sighting is within the drawn gate of the landmark that it was matched to, and the gate's edge is where χ² is
/// the gate.
#[test]
fn a_gate_s_edge_is_where_its_chi2_is_the_gate() {
    let frame = at(LoopParams::default(), 70);
    assert!(!frame.gates.is_empty() && !frame.sightings.is_empty());
    let [x, y, theta] = frame.predicted;
    for gate in &frame.gates {
        assert_eq!((gate.x.len(), gate.x.first(), gate.y.first()), (49, gate.x.last(), gate.y.last()));
        let s = nalgebra::Matrix2::from_fn(|i, j| gate.s[i][j]);
        for (ex, ey) in gate.x.iter().zip(&gate.y) {
            let (dx, dy) = (x - ex, y - ey);
            let range = numerics::hypot(dx, dy);
            let bearing = libm::atan2(dy, dx) - theta;
            let off = Vector2::new(range - gate.expected[0], angle_diff(bearing, gate.expected[1]));
            let chi2 = mahalanobis_squared(&off, &s).expect("positive definite");
            assert!((chi2 / frame.thresholds.gate - 1.0).abs() < 1e-9, "{chi2}");
        }
    }
}

#[test]
fn a_sighting_s_place_on_the_chi2_axis_says_what_becomes_of_it() {
    let mut lab = LoopClosure::new(LoopParams { found: 15.0, ..Default::default() }).expect("sound");
    let mut fates = [0; 3];
    for _ in 0..300 {
        lab.step().expect("within the limit");
        let frame = lab.frame();
        for sighting in &frame.sightings {
            let chi2 = sighting.chi2.expect("the map is not empty");
            let (fate, right) = match sighting.outcome {
                Fate::Matched => (0, chi2 <= 9.21),
                // Near a landmark that another sighting of the step was matched to, none is founded or matched.
                Fate::Rejected => (1, chi2 <= 15.0),
                _ => (2, chi2 > 15.0),
            };
            assert!(right, "{sighting:?}");
            fates[fate] += 1;
        }
    }
    assert!(fates[0] > 500 && fates[1] > 0 && fates[2] >= 13, "{fates:?}");
}

#[test]
fn a_state_restores_the_run_to_the_last_bit() {
    for correlated in [true, false] {
        let mut lab =
            LoopClosure::new(LoopParams { correlated, seed: 9, found: 12.0, ..Default::default() }).expect("sound");
        lab.run(150).expect("within the limit");
        let again = LoopClosure::from_state(lab.state()).expect("a state of its own");
        assert_eq!(again.digest(), lab.digest());
        let json = |lab: &LoopClosure| serde_json::to_string(&lab::Shown(&lab.frame())).expect("plain");
        assert_eq!(json(&again), json(&lab));
    }
}

#[test]
fn long_runs_keep_their_memory() {
    for params in [LoopParams::default(), LoopParams { gate: 0.5, found: 0.5, ..Default::default() }] {
        let frame = at(params, 1500);
        assert!(frame.map.landmarks.len() <= MAX_MAP && frame.series.nees.len() == lab::WINDOW);
    }
}

#[test]
fn a_parameter_out_of_bounds_is_refused_by_name() {
    let base = LoopParams::default();
    for (params, code, argument) in [
        (LoopParams { gate: 0.0, ..base }, Code::Limit, "gate"),
        (LoopParams { found: 101.0, ..base }, Code::Limit, "found"),
        (LoopParams { gate: f64::NAN, ..base }, Code::NotFinite, "gate"),
    ] {
        let error = LoopClosure::new(params).expect_err(argument);
        assert_eq!((error.code, error.argument.as_ref()), (code, argument));
    }
}
