//! What the museum's text says of single bugs besides the figures of its table, over 100 seeds. Natively only.

use chapter_kalman::ensembles::Distribution;
use lab::{Lab, State};
use labs::{Bug, BugMuseum, MuseumFrame, MuseumParams, MuseumSeries};
use sim::scenarios::BUG_MUSEUM;

const SEEDS: u32 = 100;

/// The run of each seed with a bug on.
fn runs(bug: Bug) -> Vec<MuseumFrame> {
    let run = |seed| {
        let params = MuseumParams { bug, seed, ..MuseumParams::default() };
        BugMuseum::from_state(State { params, step: BUG_MUSEUM.steps }).expect("within the limit").frame()
    };
    (0..SEEDS).map(run).collect()
}

/// Of the middle run: the root mean square error of the position, and the mean standard deviation that is claimed of x
/// and of y.
fn error_and_claims(runs: &[MuseumFrame]) -> [f64; 3] {
    let middle =
        |of: fn(&MuseumSeries) -> f64| Distribution::new(runs.iter().map(|run| of(&run.series))).percentile(0.5);
    [
        middle(|run| (run.x.iter().chain(run.y.iter()).map(|e| e * e).sum::<f64>() / run.step.len() as f64).sqrt()),
        middle(|run| run.two_sigma_x.iter().sum::<f64>() / 2.0 / run.step.len() as f64),
        middle(|run| run.two_sigma_y.iter().sum::<f64>() / 2.0 / run.step.len() as f64),
    ]
}

/// The share of the steps of the first lap, and of the rest, in which the NEES of a run is above its band.
fn beyond(run: &MuseumFrame) -> [f64; 2] {
    let above: Vec<bool> = run.series.nees.iter().map(|nees| nees.is_nan() || nees > run.nees_band[1]).collect();
    let lap = (run.driven / run.lap) as usize;
    [&above[1..lap], &above[lap..]].map(|part| part.iter().filter(|it| **it).count() as f64 / part.len() as f64)
}

#[test]
fn jacobians_computed_once_make_errors_large_and_a_transpose_makes_claims_small() {
    let [right, once, transposed] =
        [Bug::None, Bug::FrozenJacobian, Bug::Transposed].map(|bug| error_and_claims(&runs(bug)));
    let ratios = |of: [f64; 3]| [0, 1, 2].map(|i| of[i] / right[i]);
    let [error, x, y] = ratios(once);
    assert!(error > 1.3 && (0.75..1.33).contains(&x) && (0.75..1.33).contains(&y), "once: {error} {x} {y}");
    let [error, x, y] = ratios(transposed);
    assert!((0.75..1.33).contains(&error) && x < 1.0 && y < 0.75 && y < x, "transposed: {error} {x} {y}");
}

#[test]
fn a_wrong_derivative_shows_in_many_runs_after_a_lap_and_late_readings_from_the_start() {
    let share = |bug, holds: fn([f64; 2]) -> bool| {
        runs(bug).iter().filter(|run| holds(beyond(run))).count() as f64 / f64::from(SEEDS)
    };
    let late = share(Bug::Late, |[first, _]| first > 0.5);
    let wrong = share(Bug::WrongDerivative, |[first, rest]| first < 0.5 && rest > 0.5);
    assert!(late > 0.9 && wrong > 0.33, "late {late}, wrong derivative {wrong}");
}

#[test]
fn a_covariance_that_is_never_made_symmetric_is_asymmetric_at_nearly_every_step() {
    for run in runs(Bug::Asymmetric) {
        let symmetric = run.series.asymmetry.iter().filter(|asymmetry| *asymmetry == 0.0).count();
        assert!(symmetric < 24, "seed {}: symmetric at {symmetric} steps", run.params.seed);
    }
}
