use super::*;
use estimate::Code;

fn at(params: HookParams, steps: u32) -> OdometryHook {
    let mut hook = OdometryHook::new(params).expect("sound parameters");
    hook.run(steps).expect("within the limit");
    hook
}

fn with(bias: f64, fixes: bool) -> HookParams {
    HookParams { bias, fixes, ..HookParams::default() }
}

#[test]
fn without_bias_and_slip_the_estimate_is_the_truth_to_a_tick() {
    let frame = at(HookParams { bias: 0.0, slip: 0.0, ..HookParams::default() }, 640).frame();
    assert!(frame.error.position < 0.01 && frame.error.heading.abs() < 0.001);
    assert_eq!((frame.sigma.position, frame.sigma.heading), (0.0, 0.0));
    assert_eq!((frame.ratio.position, frame.ratio.heading), (None, None));
    assert_eq!(frame.lap, 1);
}

#[test]
fn with_bias_the_error_outruns_the_claim() {
    let frame = at(with(0.005, false), 640).frame();
    assert!(frame.ratio.heading.expect("a claim") > 2.0 && frame.ratio.position.expect("a claim") > 2.0);
    // The claim covers the slip alone: √640 ticks of √2 mm over 0.40 m.
    let claimed = (640.0 * 2.0_f64).sqrt() * 0.001 / 0.4;
    assert!((frame.sigma.heading - claimed).abs() < 1e-12);
}

#[test]
fn fixes_change_neither_truth_nor_encoders_and_rescue_the_position() {
    let (blind, fixed) = (at(with(0.005, false), 600).frame(), at(with(0.005, true), 600).frame());
    assert_eq!((blind.truth, blind.u), (fixed.truth, fixed.u));
    assert_eq!(blind.tracks.truth, fixed.tracks.truth);
    let (blind, fixed) = (at(with(0.005, false), 626).frame(), at(with(0.005, true), 626).frame());
    assert_eq!(blind.sightings, fixed.sightings, "corners are seen, used or not");
    assert_eq!(fixed.sightings.len(), 1);
    assert!(fixed.error.position < 0.3 * blind.error.position);
    assert!(fixed.sigma.heading < 0.3 * blind.sigma.heading);
}

#[test]
fn a_tick_without_a_corner_leaves_the_prediction() {
    let frame = at(with(0.005, true), 100).frame();
    assert!(frame.sightings.is_empty());
    assert_eq!((frame.predicted.x, frame.predicted.p), (frame.estimate, frame.p));
    let frame = at(with(0.005, true), 186).frame();
    assert_ne!(frame.predicted.x, frame.estimate);
}

#[test]
fn each_corner_is_read_once_as_it_comes_within_reach() {
    let mut hook = at(with(0.0, false), 1);
    let mut read = vec![(1, hook.frame().sightings[0].landmark)];
    while hook.steps() < 640 {
        hook.step().expect("within the limit");
        read.extend(hook.frame().sightings.iter().map(|seen| (hook.steps(), seen.landmark)));
    }
    assert_eq!(read, [(1, 0), (186, 1), (306, 2), (506, 3), (626, 0)]);
    let last = hook.frame().last_sighting.expect("five of them");
    assert_eq!((last.step, last.landmark), (626, 0));
}

#[test]
fn memory_is_one_lap_however_long_the_run() {
    let hook = at(with(0.005, true), 3000);
    let (tracks, frame) = (&hook.record.tracks, hook.frame());
    assert_eq!((tracks.truth.len(), tracks.estimate.len(), frame.trail.len()), (641, 641, 17));
    // Of the true course the corners are kept, and the two ends of the window.
    assert!(frame.tracks.truth.len() <= 7 && frame.tracks.estimate.len() < 100, "{:?}", frame.tracks);
    let ends = |track: &lab::Track| (track.x.front().copied(), track.y.back().copied());
    assert_eq!(ends(&frame.tracks.estimate), ends(&tracks.estimate));
    assert_eq!(frame.series.step.len(), lab::WINDOW);
    assert_eq!(frame.trail.back().map(|t| t.step), Some(3000));
    assert!(frame.error.position < 1.0, "{:?}", frame.error);
}

#[test]
fn a_change_replays_the_run_and_bad_parameters_change_nothing() {
    let mut hook = at(with(0.0, false), 30);
    hook.set(with(0.008, true)).expect("sound");
    assert_eq!(hook.frame(), at(with(0.008, true), 30).frame());
    let before = hook.digest();
    for (bad, name) in [(with(0.011, true), "bias"), (HookParams { slip: -1e-6, ..with(0.0, true) }, "slip")] {
        let error = hook.set(bad).expect_err("out of bounds");
        assert_eq!((error.code, error.argument.as_ref()), (Code::Limit, name));
    }
    assert_eq!(hook.set(with(f64::NAN, true)).expect_err("NaN").code, Code::NotFinite);
    assert_eq!(hook.digest(), before);
}

fn learning(bias: f64, fixes: bool) -> HookParams {
    HookParams { learn: true, ..with(bias, fixes) }
}

#[test]
fn with_fixes_the_bias_becomes_known_and_the_heading_s_claim_holds_again_before_a_corner() {
    // Tick 505 is the last before the fourth corner comes within reach.
    let (plain, learnt) = (at(with(0.005, true), 505).frame(), at(learning(0.005, true), 505).frame());
    let wheel = learnt.wheel.expect("the bias is a state");
    assert!(
        (wheel.epsilon - wheel.truth).abs() < 3.0 * wheel.sigma && wheel.sigma < 0.2 * HOOK.bias_sigma,
        "{wheel:?}"
    );
    assert!((wheel.truth - 0.005 / 1.005).abs() < 1e-15);
    assert!(plain.ratio.heading.expect("a claim") > 2.0, "{:?}", plain.ratio);
    assert!(learnt.ratio.heading.expect("a claim") < 1.0, "{:?}", learnt.ratio);
    assert_eq!(plain.wheel, None);
    assert_eq!((plain.truth, plain.u, plain.sightings), (learnt.truth, learnt.u, learnt.sightings));
}

#[test]
fn without_fixes_nothing_is_learned_of_the_bias_but_the_claim_contains_the_error() {
    let frame = at(learning(0.005, false), 640).frame();
    let wheel = frame.wheel.expect("the bias is a state");
    assert_eq!((wheel.epsilon, wheel.rank), (0.0, 0));
    assert!((wheel.sigma - HOOK.bias_sigma).abs() < 1e-15);
    assert!(
        frame.ratio.heading.expect("a claim") < 1.0
            && at(with(0.005, false), 640).frame().ratio.heading.expect("a claim") > 2.0
    );
}

#[test]
fn each_corner_shows_two_more_of_the_four_states() {
    // Corners are read at ticks 1, 186 and 306; the first one shows no bias, since hardly anything has been driven.
    let rank = |steps| at(learning(0.005, true), steps).frame().wheel.expect("a state").rank;
    assert_eq!([1, 185, 186, 306, 640].map(rank), [2, 2, 4, 4, 4]);
}

#[test]
fn a_bias_that_is_a_state_has_a_series_beside_the_others() {
    let frame = at(learning(0.005, true), 400).frame();
    let lengths = [&frame.series.step, &frame.series.epsilon, &frame.series.sigma_epsilon].map(|series| series.len());
    assert_eq!(lengths, [101; 3]);
    let memory = at(learning(0.005, true), 3000);
    assert_eq!(memory.frame().series.epsilon.len(), lab::WINDOW);
    assert!(at(with(0.005, true), 400).frame().series.epsilon.is_empty());
}
