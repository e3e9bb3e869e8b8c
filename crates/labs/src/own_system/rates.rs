//! Whether a matrix that is given as what one step does looks like one of a differential equation, of rates.
//!
//! A system that is sampled often enough has states that change little in a step, and turn by less than a quarter of a
//! turn: then some eigenvalue lies right of the imaginary axis, beside 1 as a rule. A differential equation whose
//! states die out has none there. So these are asked about:
//!
//! - a matrix with no eigenvalue right of the axis and one well beyond the unit circle: a step would throw every state
//!   to its other side and farther out each time, and as rates they die out;
//! - where the length T of a step is given, and even the fastest rate does little in it (|λ| T ≤ 1/2, so that I + FT is
//!   near I while F is not): a matrix with no eigenvalue right of the axis that has real ones alone, or a row that
//!   says of a state's rate only what other states it is made of (0 on the diagonal, as a speed is a place's rate); and
//!   one that has such a row and a real eigenvalue well below −1, as of a pendulum that stands on its head.
//!
//! It is a question and no verdict: a line of delays, or readings of a season, may have such a matrix too.

use estimate::Complex;
use nalgebra::DMatrix;
use numerics::hypot;

/// What grows by less in a step need not be of a differential equation: a process in discrete time may.
const WELL_BEYOND: f64 = 1.2;
/// What |λ| T is at most, of rates that are sampled often enough.
const LITTLE: f64 = 0.5;
/// Of three equal eigenvalues rounding leaves a third of the digits.
const ROUNDING: f64 = 1e-5;

/// Of F with these eigenvalues, of which the first is the largest, where a step lasts `period` seconds, or 0 for no one
/// knows how many.
pub(super) fn looks_like_rates(f: &DMatrix<f64>, eigenvalues: &[Complex<f64>], period: f64) -> bool {
    let radius = eigenvalues.first().map_or(0.0, |l| hypot(l.re, l.im));
    let real = |l: &Complex<f64>| l.im == 0.0;
    let left = eigenvalues.iter().all(|l| l.re <= ROUNDING * radius);
    let made_of_others = (0..f.nrows()).any(|i| f[(i, i)] == 0.0 && f.row(i).amax() > 0.0);
    let falls_over = eigenvalues.iter().any(|l| real(l) && l.re < -WELL_BEYOND);
    let often = period > 0.0 && radius * period <= LITTLE;
    left && radius > WELL_BEYOND
        || often && left && (made_of_others || eigenvalues.iter().all(real))
        || often && made_of_others && falls_over
}

#[cfg(test)]
mod tests {
    use super::*;
    use estimate::dynamic::Continuous;
    use nalgebra::{dmatrix, dvector};
    use numerics::eigenvalues;

    fn asked(f: &DMatrix<f64>, period: f64) -> bool {
        looks_like_rates(f, &eigenvalues(f).expect("found"), period)
    }

    /// Rates, with a length of a step that fits them.
    fn rates() -> Vec<(DMatrix<f64>, f64)> {
        vec![
            (dmatrix![0.0, 1.0, 0.0; 0.0, -10.0, 5.0; 0.0, -1.0, -20.0], 0.005),
            (dmatrix![0.0, 1.0; -4.0, -0.4], 0.01),
            (dmatrix![0.0, 1.0; 0.0, 0.0], 0.1),
            (dmatrix![0.0, 1.0, 0.0; 0.0, 0.0, 1.0; 0.0, 0.0, 0.0], 0.1),
            (dmatrix![0.0, 1.0; -1.0, 0.0], 0.1),
            (dmatrix![-0.5], 0.1),
            (dmatrix![0.0, 1.0; 9.81, 0.0], 0.01),
            (dmatrix![0.0, 1.0; 0.0, -0.1], 0.1),
            // Two tanks, an aircraft that pitches, a cart with a pendulum on its head, an orbit.
            (dmatrix![-0.1, 0.0; 0.1, -0.2], 1.0),
            (dmatrix![-0.313, 56.7, 0.0; -0.0139, -0.426, 0.0; 0.0, 56.7, 0.0], 0.01),
            (
                dmatrix![
                    0.0, 1.0, 0.0, 0.0; 0.0, -0.18, 2.67, 0.0;
                    0.0, 0.0, 0.0, 1.0; 0.0, -0.45, 31.18, 0.0
                ],
                0.01,
            ),
            (
                dmatrix![
                    0.0, 0.0, 1.0, 0.0; 0.0, 0.0, 0.0, 1.0;
                    3.6e-6, 0.0, 0.0, 0.0022; 0.0, 0.0, -0.0022, 0.0
                ],
                1.0,
            ),
        ]
    }

    #[test]
    fn rates_are_asked_about_and_not_what_they_do_in_a_step() {
        for (f, period) in rates() {
            assert!(asked(&f, period), "{f}");
            let n = f.nrows();
            let sampled = Continuous::new(f.clone(), DMatrix::zeros(n, 0), DMatrix::zeros(n, n)).expect("sound");
            let step = sampled.discretize(period).expect("sampled").f;
            assert!(!asked(&step, period) && !asked(&step, 0.0), "{step}");
            assert!(!asked(&(DMatrix::identity(n, n) + &f * period), period), "I + FT of {f}");
        }
    }

    #[test]
    fn what_would_be_thrown_from_side_to_side_is_asked_about_whatever_the_length_of_a_step() {
        for period in [0.0, 0.1, 5.0] {
            assert!(asked(&dmatrix![0.0, 1.0; -4.0, -0.4], period));
            assert!(asked(&dmatrix![0.0, 1.0, 0.0; 0.0, -10.0, 5.0; 0.0, -1.0, -20.0], period));
        }
        // What may be either is not asked about where nobody says how long a step lasts.
        assert!(!asked(&dmatrix![0.0, 1.0; 0.0, 0.0], 0.0) && !asked(&dmatrix![-0.5], 0.0));
    }

    fn turn(radius: f64, degrees: f64) -> DMatrix<f64> {
        let (c, s) = (radius * libm::cos(degrees.to_radians()), radius * libm::sin(degrees.to_radians()));
        dmatrix![c, -s; s, c]
    }

    /// Usual systems in discrete time, also those that grow and those that turn.
    fn usual() -> Vec<DMatrix<f64>> {
        let diagonal = |all: &[f64]| DMatrix::from_diagonal(&nalgebra::DVector::from_column_slice(all));
        let (level, season) = (dmatrix![1.0], dmatrix![-1.0, -1.0, -1.0; 1.0, 0.0, 0.0; 0.0, 1.0, 0.0]);
        let both = DMatrix::from_fn(4, 4, |i, j| match (i, j) {
            (0, 0) => level[0],
            (0, _) | (_, 0) => 0.0,
            _ => season[(i - 1, j - 1)],
        });
        vec![
            dmatrix![1.0],
            dmatrix![0.9],
            dmatrix![1.1],
            dmatrix![2.0],
            dmatrix![1.0, 0.1; 0.0, 1.0],
            dmatrix![1.0, 0.5, 0.125; 0.0, 1.0, 0.5; 0.0, 0.0, 1.0],
            dmatrix![1.0, 1.0; 0.0, 0.9],
            dmatrix![0.9, 0.0; 0.1, 0.8],
            DMatrix::identity(3, 3),
            diagonal(&[0.9, 1.0, 1.0]),
            diagonal(&[0.9, -0.5]),
            diagonal(&[1.2, -1.3]),
            turn(1.0, 10.0),
            turn(0.95, 45.0),
            turn(1.05, 60.0),
            turn(1.0, 120.0),
            turn(0.9, 170.0),
            turn(1.1, 120.0),
            // Processes of second and third order, as rows of what comes next.
            dmatrix![0.0, 1.0; -0.9, 1.8],
            dmatrix![1.5, -0.7; 1.0, 0.0],
            dmatrix![0.0, 1.0; -1.1, 1.9],
            dmatrix![0.0, 1.0; 0.5, 0.2],
            dmatrix![0.0, 1.0, 0.0; 0.0, 0.0, 1.0; 0.5, -1.2, 1.6],
            dmatrix![1.0, 1.0; 1.0, 0.0],
            // A place and the one before, an input that comes a step later, a population by its ages, a weather.
            dmatrix![1.0, 0.0; 1.0, 0.0],
            dmatrix![1.0, 0.1, 0.0; 0.0, 0.9, 0.1; 0.0, 0.0, 0.0],
            dmatrix![0.0, 1.5, 1.0; 0.5, 0.0, 0.0; 0.0, 0.3, 0.0],
            dmatrix![0.7, 0.4; 0.3, 0.6],
            dmatrix![0.0, 1.0; 1.0, 0.0],
            both,
            dmatrix![0.9515, 0.0979; -0.9602, 0.9417],
            DMatrix::from_diagonal(&dvector![0.5, 0.5, 0.5]),
        ]
    }

    #[test]
    fn a_usual_system_in_discrete_time_is_not_asked_about() {
        let all = usual();
        assert!(all.len() >= 30);
        for f in all {
            for period in [0.0, 0.01, 0.1, 1.0] {
                assert!(!asked(&f, period), "T = {period}: {f}");
            }
        }
        // Where no length of a step is given, neither are delays, seasons, and what turns its sign.
        for f in [dmatrix![-0.9], dmatrix![-1.1], dmatrix![0.0, 1.0; -1.0, 0.0], dmatrix![0.0, 1.0; 6.0, 1.0]] {
            assert!(!asked(&f, 0.0), "{f}");
        }
        assert!(!asked(&dmatrix![-1.0, -1.0, -1.0; 1.0, 0.0, 0.0; 0.0, 1.0, 0.0], 0.0));
    }
}
