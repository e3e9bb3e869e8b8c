//! Verdicts on logs with one planted fault, and on logs without any. Natively only.

use chapter_tests::planted::{ARCS, EACH, FAULTS, Log, SOUND, WORLDS, judged, planted, sound};
use estimate::drive::{Event, Fault, Fit, Fitted, Motion, Settings, Standing, Suspect};

/// Whether a size is at least two of its own standard deviations away from what is set; outliers are counted.
fn clear(Suspect { fault, number, sizes, .. }: &Suspect) -> bool {
    let ratio = number.is_some_and(Fitted::is_sigma);
    let off = |now: f64, value: f64, sigma: f64| match ratio {
        true => (value / now).ln().abs() * value / sigma,
        false => (value - now).abs() / sigma,
    };
    let told = sizes.iter().filter(|size| size.sigma.is_finite());
    *fault == Fault::Tails || told.clone().count() == 0 || told.clone().any(|it| off(it.now, it.value, it.sigma) >= 2.0)
}

/// What is named first in each log of this fault; `None` where nothing is.
fn named(fault: Fault, even: bool) -> Vec<(Option<Fault>, bool)> {
    let first = |n| {
        let case = planted(fault, n, even);
        assert!((5.0..10.0).contains(&case.effect) && case.truth == (n % 2 == 0));
        let judgement = judged(&case.log).expect("a verdict");
        assert_eq!(judgement.against.is_some(), case.truth, "errors are known where the truth is");
        for suspect in judgement.suspects.iter().filter(|it| it.standing != Standing::Cleared) {
            assert!(clear(suspect), "{fault:?} {n}: {suspect:?}");
        }
        let first = &judgement.suspects[0];
        let named = (first.standing != Standing::Cleared).then_some(first.fault);
        (named, first.standing == Standing::Sure)
    };
    (0..EACH).map(first).collect()
}

fn nine_of_ten_are_named_first(even: bool) {
    for fault in FAULTS {
        let named = named(fault, even);
        let right = named.iter().filter(|(first, _)| *first == Some(fault)).count();
        assert!(10 * right >= 9 * named.len(), "{fault:?}: {right} of {}", named.len());
        let wrong = named.iter().filter(|(first, sure)| *sure && *first != Some(fault)).count();
        assert_eq!(wrong, 0, "{fault:?}: what is sure is right");
    }
}

#[test]
fn a_planted_fault_is_named_first_in_nine_of_ten_logs_of_its_kind() {
    nine_of_ten_are_named_first(false);
}

#[test]
fn a_planted_fault_is_named_first_where_rates_change_evenly() {
    nine_of_ten_are_named_first(true);
}

fn nothing_is_named_in_nine_of_ten(even: bool) {
    let first = |n| judged(&sound(n, even).log).expect("a verdict").suspects[0].standing;
    let standings: Vec<Standing> = (0..SOUND).map(first).collect();
    let cleared = standings.iter().filter(|standing| **standing == Standing::Cleared).count();
    assert!(10 * cleared >= 9 * standings.len(), "{cleared} of {}", standings.len());
}

#[test]
fn nothing_is_named_in_nine_of_ten_logs_without_a_fault() {
    nothing_is_named_in_nine_of_ten(false);
}

#[test]
fn nothing_is_named_in_nine_of_ten_sound_logs_whose_rates_change_evenly() {
    nothing_is_named_in_nine_of_ten(true);
}

/// The motion model drives a step straight and turns then. That is no fault of a log, and its clock is none.
#[test]
fn a_robot_that_turns_on_its_way_has_no_fault() {
    for (world, n) in ARCS.iter().flat_map(|world| (0..6).map(move |n| (world, n))) {
        let log = world.sound(7000 + n, n % 2 == 0);
        let judgement = judged(&log).expect("a verdict");
        assert!(judgement.suspects.iter().all(|it| it.standing == Standing::Cleared), "{n}: {:?}", judgement.suspects);
        assert!((judgement.period - world.period).abs() < 1e-9);
        assert!(world.period < 0.2 || judgement.arcs.is_some_and(|gain| gain > 20.0), "{:?}", judgement.arcs);
    }
}

/// Motion that is held looks as late as half a step, and fixes beside it as early; what is later than that is late.
#[test]
fn a_delay_of_half_a_step_is_set_apart_and_a_longer_one_is_named() {
    for (world, n) in ARCS.iter().flat_map(|world| (0..3).map(move |n| (world, n))) {
        for (steps, fault) in [(-0.4, None), (1.5, Some(Fault::Clock))] {
            let mut log = world.sound(7100 + n, false);
            later(&mut log, steps * world.period);
            let judgement = judged(&log).expect("a verdict");
            let first = &judgement.suspects[0];
            let named = (first.standing != Standing::Cleared).then_some(first.fault);
            assert_eq!(named, fault, "{} {steps} {n}: {:?}", world.period, judgement.suspects);
            let own = |it: &Suspect| it.own && it.number.is_some_and(Fitted::is_delay);
            assert!(fault.is_some() || judgement.suspects.iter().any(own), "{} {steps} {n}", world.period);
        }
    }
}

fn first(log: &Log) -> Suspect {
    let mut suspects = judged(log).expect("a verdict").suspects;
    assert_eq!(suspects[0].standing, Standing::Sure, "{:?}", &suspects[..3]);
    suspects.remove(0)
}

fn spoiled(world: usize, n: u64, mut spoil: impl FnMut(&mut Event)) -> Log {
    let mut log = WORLDS[world].sound(7200 + n, n.is_multiple_of(2));
    log.drive.rows.iter_mut().for_each(|row| spoil(&mut row.event));
    log
}

/// All rows of a log's readings, stamped so much later.
fn later(log: &mut Log, by: f64) {
    for row in &mut log.drive.rows {
        row.time += if row.event.is_motion() { 0.0 } else { by };
    }
    log.drive.rows.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.line.cmp(&b.line)));
}

/// A receiver of positions and headings has one clock. Who mends the speed's instead meets the turn rate's.
#[test]
fn two_sensors_that_are_late_together_are_named_together_and_no_remedy_ends_before() {
    for n in 0..6 {
        let mut log = WORLDS[3].sound(7400 + n, n.is_multiple_of(2));
        later(&mut log, 0.4);
        let both = first(&log);
        assert_eq!(
            (both.fault, both.number, both.with),
            (Fault::Clock, Some(Fitted::DelayFix), Some(Fitted::DelayHeading))
        );
        for size in &both.sizes {
            assert!((size.value - 0.4).abs() < 4.0 * size.sigma && size.sigma < 0.1, "{size:?}");
        }
        assert_eq!(both.sizes.len(), 2);
        // The truth, which has a clock of its own, tells that apart.
        if n.is_multiple_of(2) {
            continue;
        }
        log.settings.delays.speed = -0.4;
        let turn = first(&log);
        assert_eq!((turn.fault, turn.number, turn.with), (Fault::Clock, Some(Fitted::DelayTurn), None), "{turn:?}");
        assert!((turn.sizes[0].value + 0.4).abs() < 4.0 * turn.sizes[0].sigma, "{turn:?}");
        log.settings.delays.turn = -0.4;
        let rest = judged(&log).expect("a verdict");
        assert_eq!(rest.suspects[0].standing, Standing::Cleared, "{:?}", rest.suspects[0]);
    }
}

#[test]
fn scale_and_offset_of_ranges_together_are_told_apart() {
    for n in 0..4 {
        let far = first(&spoiled(0, n, |event| {
            if let Event::Range { range, .. } = event {
                *range = 1.05 * *range + 0.6;
            }
        }));
        assert_eq!((far.number, far.with), (Some(Fitted::Scale), Some(Fitted::Offset)));
        for (size, truth) in far.sizes.iter().zip([0.05, 0.6]) {
            assert!((size.value - truth).abs() < 4.0 * size.sigma && size.sigma < 0.2 * truth, "{size:?}");
        }
        let scaled = first(&spoiled(0, n, |event| {
            if let Event::Range { range, .. } = event {
                *range *= 1.05;
            }
        }));
        assert_eq!((scaled.number, scaled.with), (Some(Fitted::Scale), None), "one number is enough");
    }
}

#[test]
fn turns_of_the_wrong_sign_are_named() {
    for (world, n) in [0, 1, 2, 3, 4].into_iter().flat_map(|world| (0..2).map(move |n| (world, n))) {
        let mirrored = first(&spoiled(world, n, |event| match event {
            Event::Velocity { omega: turn, .. } | Event::Odometry { turn, .. } => *turn = -*turn,
            _ => {}
        }));
        assert_eq!(mirrored.fault, Fault::Mirrored, "{world} {n}");
    }
}

#[test]
fn two_landmarks_that_are_exchanged_are_named() {
    for (world, n) in [0, 1, 4].into_iter().flat_map(|world| (0..3).map(move |n| (world, n))) {
        let mut log = spoiled(world, n, |_| {});
        let landmarks = &mut log.drive.landmarks;
        let (a, b) = (landmarks[1], landmarks[3]);
        (landmarks[1].x, landmarks[1].y, landmarks[3].x, landmarks[3].y) = (b.x, b.y, a.x, a.y);
        let exchanged = first(&log);
        assert_eq!((exchanged.fault, exchanged.landmarks.as_slice()), (Fault::Exchanged, &[1, 3][..]), "{world} {n}");
    }
}

/// A second search from the end of the first, as a reader who presses Fit again would do it.
#[test]
fn a_fit_ends_where_another_finds_no_better() {
    let fitted = |log: &Log, settings: Settings| {
        let mut fit = Fit::new(&log.drive, settings).expect("readings");
        while fit.step(&log.drive).expect("a replay") {}
        fit.found()
    };
    for (world, n) in [0, 3].into_iter().flat_map(|world| (0..2).map(move |n| (world, n))) {
        let mut log = WORLDS[world].sound(7300 + n, false);
        later(&mut log, 0.4);
        let found = fitted(&log, log.settings);
        let mut settings = log.settings;
        for (number, value, _) in &found.numbers {
            match number {
                Fitted::DelayFix => settings.delays.fix = *value,
                Fitted::DelayHeading => settings.delays.heading = *value,
                Fitted::DelaySpeed => settings.delays.speed = *value,
                Fitted::DelaySighting => settings.delays.sighting = *value,
                Fitted::SigmaFix => settings.sigma_fix = *value,
                Fitted::SigmaHeading => settings.sigma_heading = *value,
                Fitted::SigmaRange => settings.sigma_range = *value,
                Fitted::SigmaDistance => settings.sigma_distance = *value,
                Fitted::SigmaTurn => settings.sigma_turn = *value,
                Fitted::Scale => settings.scale = *value,
                Fitted::Offset => settings.offset = *value,
                Fitted::HeadingOffset => settings.heading_offset = *value,
                _ => panic!("{number:?} is not among them"),
            }
        }
        let again = fitted(&log, settings).log_likelihood;
        assert!(found.settled && again[1] - found.log_likelihood[1] < 0.5, "{world} {n}: {found:?} {again:?}");
    }
}

/// Between two rows of odometry the estimate stands still: a delay is told to within a step, and no better.
#[test]
fn a_delay_beside_odometry_is_told_as_a_stair() {
    let mut log = WORLDS[4].sound(7500, false);
    log.drive.motion = Motion::Odometry;
    later(&mut log, 0.35);
    let Suspect { number, flat: Some([from, to]), .. } = first(&log) else { panic!("a stair") };
    assert!(number == Some(Fitted::DelaySighting) && (from - 0.25).abs() < 0.02 && (to - 0.35).abs() < 0.02);
    let mut fit = Fit::only(&log.drive, log.settings, &[Fitted::DelaySighting]).expect("readings");
    while fit.step(&log.drive).expect("a replay") {}
    let [(Fitted::DelaySighting, [from, to])] = fit.found().flat[..] else { panic!("a stair") };
    assert!((from - 0.25).abs() < 0.02 && (to - 0.35).abs() < 0.02, "{from} {to}");
    for world in [0, 4] {
        let mut log = WORLDS[world].sound(7500, false);
        later(&mut log, 0.35);
        let Suspect { flat, sizes, .. } = first(&log);
        assert_eq!(flat, None, "what is held, or driven evenly, drives on in between");
        assert!((sizes[0].value - 0.35).abs() < 3.0 * sizes[0].sigma, "{world} {sizes:?}");
    }
}

#[test]
fn a_fit_counts_the_outliers_that_have_bent_it() {
    let beyond = |log: &Log| {
        let mut fit = Fit::only(&log.drive, log.settings, &[Fitted::SigmaRange, Fitted::Offset]).expect("readings");
        assert_eq!(fit.found().beyond, 0);
        while fit.step(&log.drive).expect("a replay") {}
        f64::from(fit.found().beyond) / f64::from(fit.found().readings)
    };
    assert!(beyond(&WORLDS[0].sound(7600, false)) < 0.006);
    let mut k = 0;
    let bent = beyond(&spoiled(0, 1, |event| {
        if let Event::Range { range, .. } = event {
            k += 1;
            *range += if k % 40 == 0 { 3.0 } else { 0.0 };
        }
    }));
    assert!((0.01..0.03).contains(&bent), "{bent}");
}

/// What hardly more than chance speaks for, and the truth against, is no fault.
#[test]
fn what_the_truth_speaks_against_is_not_named_for_a_little_evidence() {
    let camera = WORLDS.iter().find(|world| world.name == "camera").expect("a world");
    let judgement = judged(&camera.sound(20_147, true)).expect("a verdict");
    let first = &judgement.suspects[0];
    let (after, before) = (first.mended.expect("it was held against the truth"), judgement.against.expect("a truth"));
    assert!(first.excess > 0.0 && first.excess < 3.0 && after.rmse > before.rmse, "{first:?}");
    assert_eq!((first.standing, judgement.other), (Standing::Cleared, false));
}
