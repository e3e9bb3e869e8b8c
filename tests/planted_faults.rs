//! Verdicts on logs with one planted fault, and on logs without any. Natively only.

use chapter_tests::planted::{ARCS, EACH, FAULTS, Log, SOUND, WORLDS, judged, planted, sound};
use estimate::drive::{Event, Fault, Fit, Fitted, Settings, Standing, Suspect};

/// What is named first in each log of this fault; `None` where nothing is.
fn named(fault: Fault) -> Vec<(Option<Fault>, bool)> {
    let first = |n| {
        let case = planted(fault, n);
        assert!((5.0..10.0).contains(&case.effect) && case.truth == (n % 2 == 0));
        let judgement = judged(&case.log).expect("a verdict");
        assert_eq!(judgement.against.is_some(), case.truth, "errors are known where the truth is");
        let first = &judgement.suspects[0];
        let named = (first.standing != Standing::Cleared).then_some(first.fault);
        (named, first.standing == Standing::Sure)
    };
    (0..EACH).map(first).collect()
}

#[test]
fn a_planted_fault_is_named_first_in_nine_of_ten_logs_of_its_kind() {
    for fault in FAULTS {
        let named = named(fault);
        let right = named.iter().filter(|(first, _)| *first == Some(fault)).count();
        assert!(10 * right >= 9 * named.len(), "{fault:?}: {right} of {}", named.len());
        let wrong = named.iter().filter(|(first, sure)| *sure && *first != Some(fault)).count();
        assert_eq!(wrong, 0, "{fault:?}: what is sure is right");
    }
}

#[test]
fn nothing_is_named_in_nine_of_ten_logs_without_a_fault() {
    let first = |n| judged(&sound(n).log).expect("a verdict").suspects[0].standing;
    let standings: Vec<Standing> = (0..SOUND).map(first).collect();
    let cleared = standings.iter().filter(|standing| **standing == Standing::Cleared).count();
    assert!(10 * cleared >= 9 * standings.len(), "{cleared} of {}", standings.len());
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
            for row in &mut log.drive.rows {
                row.time += if row.event.is_motion() { 0.0 } else { steps * world.period };
            }
            log.drive.rows.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.line.cmp(&b.line)));
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
    let first = judged(log).expect("a verdict").suspects.remove(0);
    assert_eq!(first.standing, Standing::Sure, "{first:?}");
    first
}

fn spoiled(world: usize, n: u64, spoil: impl Fn(&mut Event)) -> Log {
    let mut log = WORLDS[world].sound(7200 + n, n.is_multiple_of(2));
    log.drive.rows.iter_mut().for_each(|row| spoil(&mut row.event));
    log
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
        assert_eq!((exchanged.fault, exchanged.landmarks), (Fault::Exchanged, Some([1, 3])), "{world} {n}");
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
        for row in &mut log.drive.rows {
            row.time += if row.event.is_motion() { 0.0 } else { 0.4 };
        }
        log.drive.rows.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.line.cmp(&b.line)));
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
