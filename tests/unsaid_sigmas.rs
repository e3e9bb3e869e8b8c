//! Verdicts on logs of precise fixes whose σ nobody has said: it stands far above their errors. Natively only.

use chapter_tests::planted::{Log, WORLDS, World, corrupted, judged};
use estimate::drive::{Fault, Fitted, Settings};

/// A log of fixes that err by 2 cm and of headings, read as if the fixes erred by a metre: both are so late, and the
/// compass is turned by so much.
fn precise(n: u64, late: f64, turned: f64) -> Log {
    let compass = WORLDS.into_iter().find(|it| it.name == "compass").expect("a world").even();
    let precise = World {
        settings: || {
            let usual = (WORLDS[3].settings)();
            Settings { sigma_fix: 0.02, sigma_distance: 0.01, sigma_turn: 0.004, ..usual }
        },
        ..compass
    };
    let mut log = precise.sound(9500 + n, n.is_multiple_of(2));
    for (number, by) in [(Fitted::DelayFix, late), (Fitted::DelayHeading, late), (Fitted::HeadingOffset, turned)] {
        log = corrupted(log, number, by);
    }
    let usual = Settings::default();
    (log.settings.sigma_fix, log.settings.sigma_distance) = (usual.sigma_fix, usual.sigma_distance);
    log.settings.sigma_turn = usual.sigma_turn;
    log
}

/// Beside a σ so large what is late and what is turned goes together as the errors of a receiver that wanders do. The
/// motion tells them apart: with the faults mended less noise of it is enough.
#[test]
fn fixes_that_are_late_beside_a_turned_compass_do_not_wander() {
    for (n, (late, turned)) in [(0.0, 0.0), (0.3, 0.0), (0.3, 0.035), (0.0, 0.035)].into_iter().enumerate() {
        let judgement = judged(&precise(n as u64, late, turned)).expect("a verdict");
        let first = &judgement.suspects[0];
        assert_eq!((first.fault, first.number), (Fault::Sigma, Some(Fitted::SigmaFix)), "{late} {turned}");
        assert_eq!(judgement.thinning, None, "{late} {turned}");
    }
}
