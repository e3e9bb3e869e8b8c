//! Verdicts on logs whose fixes are of an antenna that does not stand where the robot's pose is. Natively only.

use chapter_tests::planted::{Log, WORLDS, corrupted, judged};
use estimate::drive::{Event, Fault, Fitted, Pose, Settings, Standing};

/// A sound log of a world, which may change its rates evenly, whose fixes are then of an antenna so far ahead and to
/// the left. Where the log has no truth of its own, the one that the fixes are moved by is thrown away again.
fn mounted(name: &str, even: bool, n: u64, [ahead, left]: [f64; 2]) -> Log {
    let world = WORLDS.into_iter().find(|it| it.name == name).expect("a world");
    let world = if even { world.even() } else { world };
    let (known, mut log) = (world.sound(9300 + n, true), world.sound(9300 + n, n.is_multiple_of(2)));
    let poses: Vec<Pose> = known.drive.truth.poses().to_vec();
    for row in &mut log.drive.rows {
        if let Event::Position { x, y, .. } = &mut row.event {
            let at = poses.partition_point(|pose| pose.time < row.time).min(poses.len() - 1);
            let (sin, cos) = poses[at].theta.sin_cos();
            (*x, *y) = (*x + ahead * cos - left * sin, *y + ahead * sin + left * cos);
        }
    }
    log
}

#[test]
fn an_antenna_that_stands_elsewhere_is_named_with_its_place() {
    for (n, (world, at)) in
        [("car", [4.0, 0.0]), ("car", [-3.0, 1.5]), ("compass", [1.5, 0.0]), ("compass", [0.0, -1.5])]
            .into_iter()
            .enumerate()
    {
        let log = mounted(world, false, n as u64, at);
        let first = judged(&log).expect("a verdict").suspects.remove(0);
        assert_eq!(first.fault, Fault::Antenna, "{world} {at:?}: {first:?}");
        for (size, at) in first.sizes.iter().zip(at) {
            assert!((size.value - at).abs() < 3.0 * size.sigma, "{world} {at}: {size:?}");
        }
        let mut mended = log;
        mended.settings.antenna = [first.sizes[0].value, first.sizes[1].value];
        if let (Some([x, y, theta]), true) = (mended.settings.start, mended.drive.truth.poses().is_empty()) {
            let ([ahead, left], (sin, cos)) = (mended.settings.antenna, theta.sin_cos());
            mended.settings.start = Some([x - ahead * cos + left * sin, y - ahead * sin - left * cos, theta]);
        }
        let again = judged(&mended).expect("a verdict").suspects;
        let left = again.iter().find(|it| it.fault == Fault::Antenna).expect("it was looked for");
        assert_eq!(left.standing, Standing::Cleared, "{world}: {left:?}");
        assert!((left.sizes[0].now - mended.settings.antenna[0]).abs() < 1e-12);
    }
}

/// An antenna that stands ahead looks early, and a late one behind: what is named first may be either, and the next
/// verdicts lead on to both.
#[test]
fn an_antenna_that_stands_elsewhere_and_is_late_is_found_with_both() {
    for (n, at) in [[5.0, 1.0], [-4.0, 0.0]].into_iter().enumerate() {
        let mut log = mounted("car", false, 20 + n as u64, at);
        for row in &mut log.drive.rows {
            row.time += if row.event.is_motion() { 0.0 } else { 0.5 };
        }
        log.drive.rows.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.line.cmp(&b.line)));
        let mut presses = 0;
        let sizes = loop {
            let first = judged(&log).expect("a verdict").suspects.remove(0);
            presses += 1;
            assert!(presses < 4, "{at:?}: {first:?}");
            match (first.fault, first.number, &first.sizes[..]) {
                (Fault::Antenna, _, [ahead, left, late]) => break [*ahead, *left, *late],
                (Fault::Antenna, _, [ahead, left]) => log.settings.antenna = [ahead.value, left.value],
                (Fault::Clock, Some(Fitted::DelayFix), [late]) => log.settings.delays.fix = late.value,
                _ => panic!("{at:?}: {first:?}"),
            }
        };
        for (size, wanted) in sizes.into_iter().zip([at[0], at[1], 0.5]) {
            assert!((size.value - wanted).abs() < 3.0 * size.sigma, "{size:?} {wanted}");
        }
    }
}

/// The setting of a motion's delay.
fn set(delay: Fitted, settings: &mut Settings) -> &mut f64 {
    match delay {
        Fitted::DelaySpeed => &mut settings.delays.speed,
        Fitted::DelayTurn => &mut settings.delays.turn,
        other => panic!("{other:?}"),
    }
}

/// Early fixes look like late motion. Where an antenna stands elsewhere and the speed or the turn rate alone is
/// late, no verdict takes the fixes for early, and both are found.
#[test]
fn an_antenna_that_stands_elsewhere_is_found_with_a_speed_that_is_late() {
    let cases = [(Fitted::DelaySpeed, 0.5, [5.0, 0.0]), (Fitted::DelaySpeed, 0.4, [-4.0, 1.0])];
    let turned = [(Fitted::DelayTurn, 0.6, [4.0, -1.0]), (Fitted::DelayTurn, 0.5, [-4.0, 0.0])];
    for (n, (number, late, at)) in cases.into_iter().chain(turned).enumerate() {
        let mut log = corrupted(mounted("car", true, 40 + n as u64, at), number, late);
        let mut found = [None; 3];
        for _ in 0..3 {
            let first = judged(&log).expect("a verdict").suspects.remove(0);
            match (first.fault, first.number.or(first.with), &first.sizes[..]) {
                (Fault::Antenna, delay, sizes) => {
                    log.settings.antenna = [sizes[0].value, sizes[1].value];
                    found[..2].copy_from_slice(&[Some(sizes[0]), Some(sizes[1])]);
                    if let (Some(delay), Some(size)) = (delay, sizes.get(2)) {
                        assert_eq!(delay, number, "{at:?}");
                        *set(delay, &mut log.settings) = size.value;
                        found[2] = Some(*size);
                    }
                }
                (Fault::Clock, Some(delay), [size]) => {
                    assert_eq!(delay, number, "{at:?}");
                    *set(delay, &mut log.settings) = size.value;
                    found[2] = Some(*size);
                }
                _ => break,
            }
        }
        for (size, wanted) in found.into_iter().zip([at[0], at[1], late]) {
            let size = size.expect("it was found");
            assert!((size.value - wanted).abs() < 3.0 * size.sigma, "{at:?} {number:?}: {size:?} {wanted}");
        }
    }
}

/// Readings that are worse than they claim bend what is found by them. The arm is named with the size that it has
/// beside the σ that they have, and that σ next.
#[test]
fn an_antenna_is_found_by_fixes_that_claim_too_much() {
    for (n, at) in [[4.0, 0.0], [-3.0, 1.0]].into_iter().enumerate() {
        let mut log = mounted("car", true, 60 + n as u64, at);
        let sigma = log.settings.sigma_fix;
        for row in &mut log.drive.rows {
            if let Event::Position { sigma: claimed, .. } = &mut row.event {
                *claimed = Some(0.25 * sigma);
            }
        }
        let first = judged(&log).expect("a verdict").suspects.remove(0);
        assert_eq!((first.fault, first.with), (Fault::Antenna, None), "{at:?}: {first:?}");
        for (size, at) in first.sizes.iter().zip(at) {
            assert!((size.value - at).abs() < 3.0 * size.sigma, "{at}: {size:?}");
        }
        log.settings.antenna = [first.sizes[0].value, first.sizes[1].value];
        let next = judged(&log).expect("a verdict").suspects.remove(0);
        assert_eq!((next.fault, next.number), (Fault::Sigma, Some(Fitted::FixSigmaScale)), "{at:?}: {next:?}");
        let factor = next.sizes[0].value;
        assert!((3.0..5.0).contains(&factor), "{at:?}: {factor}");
    }
}
