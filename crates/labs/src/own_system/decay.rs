//! How fast an error dies out, and how long a run has to be to show it.

use super::frame::{OwnDecay, OwnEigenvalue};

/// A modulus that differs from 1 by less is 1 up to rounding.
pub(super) const ON_CIRCLE: f64 = 1e-12;
/// What is left of an error when it counts as gone.
const LEFT: f64 = 0.05;
/// The shortest run.
const SHORTEST: f64 = 40.0;
/// The longest one, and the most work of a run, as steps times the square of states and readings: a reader who drags a
/// slider waits for it.
const LONGEST: f64 = 6000.0;
const MOST_WORK: f64 = 240_000.0;

/// Steps until 5 % are left of what shrinks by `modulus` in each; `None` where it does not shrink.
fn steps(modulus: f64) -> Option<f64> {
    match modulus {
        0.0 => Some(1.0),
        _ if modulus < 1.0 - ON_CIRCLE => Some(libm::log(LEFT) / libm::log(modulus)),
        _ => None,
    }
}

/// Each eigenvalue's decay, where a step lasts `period` seconds, or 0 for no one knows how many.
pub(super) fn decay_of(eigenvalues: &[OwnEigenvalue], period: f64) -> Vec<OwnDecay> {
    let of = |l: &OwnEigenvalue| {
        let dies = l.modulus > 0.0 && l.modulus < 1.0 - ON_CIRCLE && period > 0.0;
        OwnDecay { steps: steps(l.modulus), seconds: dies.then(|| -period / libm::log(l.modulus)) }
    };
    eigenvalues.iter().map(of).collect()
}

/// Steps of a run that is as long as the slowest of those that die out, for `size` states and readings.
pub(super) fn run_length(eigenvalues: &[OwnEigenvalue], size: usize) -> u32 {
    let slowest = eigenvalues.iter().filter_map(|l| steps(l.modulus)).fold(0.0, f64::max);
    let most = LONGEST.min(MOST_WORK / (size * size) as f64);
    (slowest.min(most).max(SHORTEST) / 10.0).ceil() as u32 * 10
}
