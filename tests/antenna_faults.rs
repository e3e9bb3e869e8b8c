//! Verdicts on logs whose fixes are of an antenna that does not stand where the robot's pose is. Natively only.

use chapter_tests::planted::{Log, WORLDS, judged};
use estimate::drive::{Event, Fault, Fitted, Pose, Standing};

/// A sound log of a world, whose fixes are then of an antenna so far ahead and to the left. Where the log has no truth
/// of its own, the one that the fixes are moved by is thrown away again.
fn mounted(world: &str, n: u64, [ahead, left]: [f64; 2]) -> Log {
    let world = WORLDS.iter().find(|it| it.name == world).expect("a world");
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
        let log = mounted(world, n as u64, at);
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
        let mut log = mounted("car", 20 + n as u64, at);
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
