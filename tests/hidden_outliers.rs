//! Outliers that a σ hides: one that is larger than the sensor's lets them in, and one that was found among them is.
//! Natively only.

use chapter_tests::planted::{Log, WORLDS, judged};
use estimate::drive::{Event, Fault, Fitted};

/// One reading in fifteen is 10 σ too long: about what a wall or a leaf makes of a range.
fn spoiled(world: usize, n: u64) -> Log {
    let mut log = WORLDS[world].sound(9900 + n, n.is_multiple_of(2));
    let (ranges, s) = (!log.drive.landmarks.is_empty(), log.settings);
    let mut count = 0;
    for row in &mut log.drive.rows {
        if let Event::Range { range: value, .. } | Event::Position { x: value, .. } = &mut row.event {
            count += 1;
            let far = if ranges { 10.0 * s.sigma_range } else { 10.0 * s.sigma_fix };
            *value += if count % 15 == 0 { far } else { 0.0 };
        }
    }
    log
}

#[test]
fn outliers_are_named_whatever_sigma_is_set_and_with_the_sigma_of_the_others() {
    for (world, n) in [0, 2, 4].into_iter().flat_map(|world| (0..2).map(move |n| (world, n))) {
        for times in [5.0, 3.0, 0.4] {
            let mut log = spoiled(world, n);
            let s = log.settings;
            let ranges = !log.drive.landmarks.is_empty();
            let (name, sigma) =
                if ranges { (Fitted::SigmaRange, s.sigma_range) } else { (Fitted::SigmaFix, s.sigma_fix) };
            let set = if ranges { &mut log.settings.sigma_range } else { &mut log.settings.sigma_fix };
            *set = times * sigma;
            let judgement = judged(&log).expect("a verdict");
            let first = &judgement.suspects[0];
            assert_eq!((first.fault, first.number), (Fault::Tails, Some(name)), "{world} {n} {times}: {first:?}");
            let [share, found] = first.sizes.as_slice() else { panic!("{first:?}") };
            assert!((share.value - 1.0 / 15.0).abs() < 0.025, "{world} {n} {times}: {share:?}");
            let off = (found.value - sigma).abs() / found.sigma;
            assert!(off < 4.0 && found.sigma < 0.15 * sigma, "{world} {n} {times}: {found:?} of {sigma}");
        }
    }
}

/// Where the σ is right, no other is said.
#[test]
fn beside_a_sigma_that_is_right_outliers_are_named_alone() {
    for (world, n) in [0, 2, 4].into_iter().flat_map(|world| (0..2).map(move |n| (world, n))) {
        let judgement = judged(&spoiled(world, n)).expect("a verdict");
        let first = &judgement.suspects[0];
        assert_eq!((first.fault, first.number, first.sizes.len()), (Fault::Tails, None, 1), "{world} {n}: {first:?}");
    }
}
