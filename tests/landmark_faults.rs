//! Verdicts on logs in which one landmark stands elsewhere than its row says, and on gates that refuse as many readings
//! as are outliers. Natively only.

use chapter_tests::planted::{Log, WORLDS, judged};
use estimate::drive::{Event, Fault, Fitted, Standing, Suspect};

/// A sound log of a world, with a truth or without.
fn sound(world: usize, n: u64) -> Log {
    WORLDS[world].sound(7000 + n, n.is_multiple_of(2))
}

#[test]
fn a_landmark_that_stands_elsewhere_is_named_with_where_it_stands() {
    for (world, n) in [0, 1].into_iter().flat_map(|world| (0..4).map(move |n| (world, n))) {
        let mut log = sound(world, n);
        let at = n as usize % log.drive.landmarks.len();
        let stands = log.drive.landmarks[at];
        (log.drive.landmarks[at].x, log.drive.landmarks[at].y) = (stands.x + 1.2, stands.y - 0.8);
        let judgement = judged(&log).expect("a verdict");
        let first = &judgement.suspects[0];
        assert_eq!((first.fault, first.landmarks.as_slice()), (Fault::Displaced, &[stands.id][..]), "{world} {n}");
        assert_eq!(first.standing, Standing::Sure, "{world} {n}: {first:?}");
        for (size, (stands, said)) in first.sizes.iter().zip([(stands.x, stands.x + 1.2), (stands.y, stands.y - 0.8)]) {
            assert!((size.now - said).abs() < 1e-12, "{world} {n}: {size:?}");
            assert!(
                (size.value - stands).abs() < 4.0 * size.sigma && size.sigma < 0.3,
                "{world} {n}: {size:?} {stands}"
            );
        }
        // Mended so, nothing is wrong with it.
        (log.drive.landmarks[at].x, log.drive.landmarks[at].y) = (first.sizes[0].value, first.sizes[1].value);
        let again = judged(&log).expect("a verdict");
        let left = again.suspects.iter().find(|it| it.fault == Fault::Displaced).expect("it was looked for");
        assert_eq!(left.standing, Standing::Cleared, "{world} {n}: {left:?}");
    }
}

/// Where a robot sees a landmark from about one side, another place of it looks the same.
#[test]
fn ranges_of_one_landmark_that_are_too_long_are_named() {
    for (world, n) in [0, 1, 4].into_iter().flat_map(|world| (0..4).map(move |n| (world, n))) {
        let mut log = sound(world, n);
        let at = n as usize % log.drive.landmarks.len();
        let by = if n < 2 { 0.6 } else { -0.6 };
        for row in &mut log.drive.rows {
            if let Event::Range { landmark, range } | Event::RangeBearing { landmark, range, .. } = &mut row.event {
                *range += if *landmark == at { by } else { 0.0 };
            }
        }
        let judgement = judged(&log).expect("a verdict");
        let [first, second] = [0, 1].map(|i| &judgement.suspects[i]);
        let id = log.drive.landmarks[at].id;
        let of = |suspect: &Suspect| suspect.fault == Fault::LandmarkBias && suspect.landmarks == [id];
        let rival = |suspect: &Suspect| suspect.fault == Fault::Displaced && first.standing == Standing::Maybe;
        assert!(of(first) || of(second) && rival(first), "{world} {n}: {first:?} {second:?}");
        let biased = if of(first) { first } else { second };
        let size = biased.sizes[0];
        assert!((size.value - by).abs() < 4.0 * size.sigma && size.sigma < 0.2, "{world} {n}: {size:?}");
    }
}

#[test]
fn a_gate_that_refuses_as_many_readings_as_are_outliers_is_kept() {
    for n in 0..4 {
        let mut log = sound(2, n);
        let mut count = 0;
        for row in &mut log.drive.rows {
            if let Event::Position { x, y, .. } = &mut row.event {
                count += 1;
                if count % 8 == 5 {
                    let side = if count % 16 == 5 { 1.0 } else { -1.0 };
                    (*x, *y) = (*x + 15.0 * side, *y - 9.0 * side);
                }
            }
        }
        let open = judged(&log).expect("a verdict");
        assert_eq!((open.suspects[0].fault, open.ungated), (Fault::Tails, false), "{n}: {:?}", open.suspects[0]);
        log.settings.gate.fix = Some(0.999);
        let gated = judged(&log).expect("a verdict");
        assert!(!gated.ungated, "{n}");
        let sigmas = [Some(Fitted::SigmaFix), Some(Fitted::FixSigmaScale)];
        let first = &gated.suspects[0];
        assert!(first.standing == Standing::Cleared || !sigmas.contains(&first.number), "{n}: {first:?}");
    }
}
