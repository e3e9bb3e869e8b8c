//! What 500 seeds say of the fitted noise levels and of the corridor's loop. Natively only.

use chapter_kalman::ensembles::{SEEDS, fits, loops};
use filters::consistency::chi2_quantile;

/// The truth lies within the 95 % region that each fit claims in 95 of 100 logs. The standard error of a share of 500
/// runs is 1 %; in a log of 200 readings the likelihood is not yet a paraboloid, which moves the share by another 1 %.
#[test]
fn a_fit_covers_the_truth_as_its_own_information_claims() {
    let runs = fits(200, SEEDS).expect("computed");
    assert!(runs.held < 10, "{} fits were held by a bound", runs.held);
    assert!((0.92..0.98).contains(&runs.covered), "covered {}", runs.covered);
    assert!((0.92..0.98).contains(&runs.within), "within {}", runs.within);
    // Not at 95 % alone: the squared distance is χ² with 2 degrees of freedom, of mean 2 and standard deviation 2.
    assert!((runs.distance.mean() - 2.0).abs() < 0.4, "{}", runs.distance.mean());
    for share in [0.25, 0.5, 0.75] {
        let quantile = chi2_quantile(2, share).expect("in range");
        // Three standard errors of the share at the middle.
        assert!((runs.distance.share_below(quantile) - share).abs() < 0.07, "{share}");
    }
}

#[test]
fn four_times_the_log_tells_noise_levels_twice_as_well_and_their_ratio_least() {
    let [short, long] = [100, 400].map(|length| fits(length, SEEDS).expect("computed"));
    let gain = short.sigma_q.median() / long.sigma_q.median();
    assert!((1.8..2.3).contains(&gain), "{gain}");
    // The long axis of the region lies nearer to (1, −1), along which q/W changes and q·W stays, than to (1, 1).
    assert!(long.along_ratio.median() > core::f64::consts::FRAC_1_SQRT_2, "{}", long.along_ratio.median());
}

#[test]
fn a_loop_is_consistent_with_its_cross_covariances_and_overconfident_without() {
    let [right, apart] = [true, false].map(|correlated| loops(correlated, SEEDS).expect("computed"));
    // 3, less where single runs wander and more where their linearization fails. Some 4 standard errors of a median of
    // 500.
    assert!((2.4..3.2).contains(&right.nees.median()), "{}", right.nees.median());
    assert!((2.8..3.8).contains(&right.nees.mean()), "{}", right.nees.mean());
    assert!(apart.nees.percentile(0.05) > right.nees.percentile(0.95), "nearly every run tells them apart");
    assert!(apart.nees.median() > 30.0 * right.nees.median(), "{}", apart.nees.median());
    assert!(apart.sigma.median() < right.sigma.median() && apart.error.median() > 2.0 * right.error.median());
    assert_eq!((right.with_ghosts, right.with_wrong), (0, 0));
    assert!(apart.with_ghosts > SEEDS / 5, "{}", apart.with_ghosts);
    // Nearly every lap of the right filter is closed, and that always shrinks the map.
    assert!(right.shrinks.len() as f64 > 0.98 * f64::from(SEEDS), "{}", right.shrinks.len());
    assert!(right.shrinks.min() > 1.0 && right.shrinks.median() > 1.3, "{}", right.shrinks.median());
    assert!((0.9..1.1).contains(&apart.shrinks.median()), "{}", apart.shrinks.median());
}
