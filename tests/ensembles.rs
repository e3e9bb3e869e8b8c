//! Where the single runs that the chapter quotes stand among 500 others. Natively only.
//!
//! The bands around percentiles are some four standard errors of a percentile of 500 runs: another stream of noise
//! would pass, another constant or a broken filter would not.

use chapter_kalman::checks::chapter_checks;
use chapter_kalman::ensembles::{Distribution, SEEDS, probe, probe_laps, probe_run, slam};
use filters::consistency::{chi2_interval, chi2_quantile};
use labs::SensorKind;
use sim::scenarios::{PROBE, RANGE_BEARING_SLAM};

fn near(spread: &Distribution, p: f64, value: f64, band: f64) {
    let found = spread.percentile(p);
    assert!((found - value).abs() <= band, "the {p} percentile is {found}, not {value} ± {band}");
}

/// Check 10 among its ensemble: Jacobians at wandering estimates scatter the trace about that of the true path.
#[test]
fn check_10_the_traces_scatter_about_those_of_the_true_path() {
    let checks = chapter_checks().expect("computed");
    let check = checks.iter().find(|c| c.id == 10).expect("there is such a check");
    for (landmarks, quoted, [low, high], band) in
        [(1, check.actual[0], [0.33, 0.62], 0.03), (2, check.actual[1], [0.033, 0.035], 0.0005)]
    {
        let ensemble = probe(landmarks, SEEDS).expect("computed");
        near(&ensemble.trace, 0.05, low, band);
        near(&ensemble.trace, 0.95, high, band);
        let share = ensemble.trace.share_below(quoted);
        assert!((0.2..0.8).contains(&share), "the quoted trace is an ordinary one: above {share} of the runs");
        let (run, _) = probe_run(landmarks, SensorKind::Range, 1).expect("computed");
        let share = ensemble.trace.share_below(run);
        assert!((0.02..0.98).contains(&share), "so is that of the quoted run: {share}");
    }
}

/// What the filter claims falls behind the true path's trace, lap after lap, and its NEES leaves χ² with 3 degrees of
/// freedom, whose median is 2.37.
#[test]
fn jacobians_at_estimates_claim_what_no_reading_shows() {
    let laps = probe_laps(&[240, 480, 960, 1920], SEEDS).expect("computed");
    for (laps, [trace, nees], band) in [
        (&laps[0], [0.47, 2.8], [0.04, 0.6]),
        (&laps[1], [0.75, 3.4], [0.08, 0.9]),
        (&laps[2], [0.95, 6.0], [0.1, 1.8]),
        (&laps[3], [1.04, 20.0], [0.12, 7.0]),
    ] {
        near(&laps.trace, 0.5, trace, band[0]);
        near(&laps.nees, 0.5, nees, band[1]);
    }
}

/// NEES over many runs: at any one step it is χ² with 3 degrees of freedom. The mean over a run is not that of 240
/// independent draws, since neighbouring errors are nearly equal; it scatters far more widely.
#[test]
fn the_mean_nees_is_three_and_scatters_more_than_independent_steps_would() {
    let two = probe(2, SEEDS).expect("computed").nees;
    let (low, high) = chi2_interval(3, PROBE.steps, 0.9).expect("in range");
    // χ² with 720 degrees of freedom, by 720: 1 ± 1.645 √(2/720) of 3, to the third digit.
    assert!((low - 2.745).abs() < 0.01 && (high - 3.264).abs() < 0.01, "{low} {high}");
    assert!(two.percentile(0.05) < low && two.percentile(0.95) > high);
    // Percentiles of 20 000 runs.
    near(&two, 0.05, 2.06, 0.15);
    near(&two, 0.5, 2.97, 0.15);
    near(&two, 0.9, 3.96, 0.2);
    near(&two, 0.95, 4.3, 0.3);
    // The mean of all: 3, of which the linearization takes a little away.
    assert!((two.mean() - 3.0).abs() < 0.15, "{}", two.mean());
    // Choset's companion quotes 3.8: high, and not out of the ordinary.
    assert!((0.8..0.95).contains(&two.share_below(3.8)), "{}", two.share_below(3.8));
    let (_, quoted) = probe_run(2, SensorKind::Range, 1).expect("computed");
    assert!((0.05..0.95).contains(&two.share_below(quoted)), "the quoted run is no favourite");
}

/// Check 12 among its ensemble.
#[test]
fn check_12_the_quoted_map_is_an_ordinary_one() {
    let ensemble = slam(RANGE_BEARING_SLAM.found, SEEDS).expect("computed");
    assert_eq!((ensemble.spurious, ensemble.wrong), (0, 0));
    // 99 % of 597 is what the gate, the 99 % quantile, lets through.
    assert!((chi2_quantile(2, 0.99).expect("in range") - RANGE_BEARING_SLAM.gate).abs() < 1e-3);
    assert_eq!(ensemble.matched.median(), 591.0);
    assert!(ensemble.matched.min() >= 575.0 && ensemble.matched.max() == 597.0);
    near(&ensemble.worst, 0.05, 0.023, 0.005);
    near(&ensemble.worst, 0.5, 0.064, 0.01);
    near(&ensemble.worst, 0.95, 0.15, 0.03);
    // The worst of three landmarks, in its own sigmas.
    near(&ensemble.sigma, 0.5, 1.36, 0.15);
    // The source's 588 matches and 0.12 m at 1.6 sigma are such a draw as well.
    assert!((0.02..0.5).contains(&ensemble.matched.share_below(588.0)));
    assert!((0.7..0.98).contains(&ensemble.worst.share_below(0.12)));

    let checks = chapter_checks().expect("computed");
    let run = &checks.iter().find(|c| c.id == 12).expect("there is such a check").actual;
    assert!((0.05..=0.95).contains(&ensemble.matched.share_below(run[4])), "matched {}", run[4]);
    assert!((0.05..=0.95).contains(&ensemble.worst.share_below(run[5])), "worst {}", run[5]);
}

#[test]
fn one_threshold_cannot_both_reject_and_found() {
    let with_spurious = |found| f64::from(slam(found, SEEDS).expect("computed").with_spurious) / f64::from(SEEDS);
    assert!(with_spurious(30.0) < 0.01);
    assert!((0.2..0.4).contains(&with_spurious(15.0)));
    assert!(
        with_spurious(RANGE_BEARING_SLAM.gate) > 0.9,
        "with the gate for both, spurious landmarks in nearly every run"
    );
}
