//! Verdicts on logs with one planted fault, and on logs without any. Natively only.

use chapter_tests::planted::{EACH, FAULTS, SOUND, judged, planted, sound};
use estimate::drive::{Fault, Standing};

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
