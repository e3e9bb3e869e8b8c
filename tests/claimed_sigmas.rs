//! Logs whose readings bring a standard deviation that is not theirs, as a verdict and a fit find them. Natively only.

use chapter_tests::planted::{Log, WORLDS, judged};
use estimate::drive::{Event, Fault, Fit, Fitted, Sensor, Standing};

/// By how much the standard deviation that readings bring is multiplied: a fifth, a half and four times what is true.
const CLAIMS: [f64; 3] = [0.2, 0.5, 4.0];
/// The worlds with fixes: a car, and a robot with a compass.
const WITH_FIXES: [usize; 2] = [2, 3];

/// A sound log whose fixes and headings bring so many times their own σ each, where that is said. As a page does it,
/// the filter starts by the first fixes.
fn claiming(world: usize, n: u64, fix: Option<f64>, heading: Option<f64>) -> Log {
    let mut log = WORLDS[world].sound(8000 + n, n.is_multiple_of(2));
    let (of_fix, of_heading) = (log.settings.sigma_fix, log.settings.sigma_heading);
    for row in &mut log.drive.rows {
        match &mut row.event {
            Event::Position { sigma, .. } => *sigma = fix.map(|times| times * of_fix),
            Event::Heading { sigma, .. } => *sigma = heading.map(|times| times * of_heading),
            _ => {}
        }
    }
    if log.drive.truth.poses().is_empty() {
        let opening = log.drive.opening(&log.settings).expect("fixes");
        log.settings.start = Some(opening.pose);
        (log.settings.start_sigma, log.settings.start_sigma_heading) = (opening.sigma, opening.sigma_heading);
    }
    log
}

#[test]
fn what_fixes_claim_is_named_first_with_the_factor_that_mends_it() {
    for (world, claim, n) in WITH_FIXES.iter().flat_map(|world| each().map(move |(claim, n)| (*world, claim, n))) {
        let mut log = claiming(world, n, Some(claim), Some(1.0));
        let judgement = judged(&log).expect("a verdict");
        let first = &judgement.suspects[0];
        assert_eq!((first.fault, first.number), (Fault::Sigma, Some(Fitted::FixSigmaScale)), "{world} {claim} {n}");
        assert_eq!(first.standing, Standing::Sure, "{world} {claim} {n}: {:?}", &judgement.suspects[..3]);
        let (size, claimed) = (first.sizes[0], log.settings.sigma_fix * claim);
        assert!((size.value - 1.0 / claim).abs() < 4.0 * size.sigma, "{world} {claim} {n}: {size:?}");
        assert!(size.sigma < 0.1 * size.value && size.now == 1.0, "{world} {claim} {n}: {size:?}");
        assert_eq!(first.claims, Some([claimed; 3]));
        let none = |it: &Fitted| *it == Fitted::SigmaFix;
        assert!(!judgement.suspects.iter().any(|it| it.number.as_ref().is_some_and(none)), "no fix has another σ");
        // Once it is mended, it is not named again.
        log.settings.fix_sigma_scale = size.value;
        let again = judged(&log).expect("a verdict").suspects;
        let named = again.iter().find(|it| it.number == Some(Fitted::FixSigmaScale)).expect("looked for");
        assert_eq!(named.standing, Standing::Cleared, "{world} {claim} {n}: {named:?}");
    }
}

#[test]
fn what_headings_claim_is_named_too() {
    for (claim, n) in each() {
        let first = judged(&claiming(3, n, None, Some(claim))).expect("a verdict").suspects.remove(0);
        assert_eq!((first.number, first.standing), (Some(Fitted::HeadingSigmaScale), Standing::Sure), "{claim} {n}");
        let size = first.sizes[0];
        assert!((size.value - 1.0 / claim).abs() < 4.0 * size.sigma && size.sigma < 0.1 * size.value, "{size:?}");
    }
}

#[test]
fn claims_that_hold_are_not_named() {
    let standing = |n: u64| judged(&claiming(2 + n as usize % 2, n, Some(1.0), Some(1.0))).expect("a verdict");
    let named = (0..40).filter(|n| standing(*n).suspects[0].standing != Standing::Cleared).count();
    assert!(named <= 4, "{named} of 40");
}

#[test]
fn a_fit_frees_the_factor_in_place_of_a_sigma_that_no_fix_takes() {
    for (claim, n) in CLAIMS.into_iter().zip(0..) {
        let mut log = claiming(2, n, Some(claim), None);
        let found = fitted(&log);
        assert!(found.iter().all(|(number, ..)| *number != Fitted::SigmaFix));
        let (_, factor, told) = find(&found, Fitted::FixSigmaScale);
        let told = told.expect("the log tells it");
        assert!((factor * claim - 1.0).abs() < 4.0 * told && told < 0.1, "{claim}: {factor} ± {told}");
        // Where some fixes bring none, both are found, each from its own.
        let mut odd = false;
        for row in &mut log.drive.rows {
            if let Event::Position { sigma, .. } = &mut row.event {
                odd = !odd;
                *sigma = sigma.filter(|_| odd);
            }
        }
        let found = fitted(&log);
        let (_, factor, _) = find(&found, Fitted::FixSigmaScale);
        let (_, sigma, _) = find(&found, Fitted::SigmaFix);
        assert!((factor * claim - 1.0).abs() < 0.3, "{claim}: {factor}");
        assert!((sigma / log.settings.sigma_fix - 1.0).abs() < 0.3, "{claim}: {sigma}");
        let (count, [least, most]) = log.drive.own_sigmas(Sensor::Fix).expect("half of them");
        assert!(count > 100 && least == most);
    }
}

type Found = Vec<(Fitted, f64, Option<f64>)>;

fn fitted(log: &Log) -> Found {
    let mut fit = Fit::new(&log.drive, log.settings).expect("readings");
    while fit.step(&log.drive).expect("a replay") {}
    fit.found().numbers
}

fn find(found: &Found, number: Fitted) -> (Fitted, f64, Option<f64>) {
    *found.iter().find(|(it, ..)| *it == number).expect("one of those that are looked for")
}

fn each() -> impl Iterator<Item = (f64, u64)> {
    CLAIMS.into_iter().flat_map(|claim| (0..4).map(move |n| (claim, n)))
}
