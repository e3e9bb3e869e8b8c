//! Whether P falls for ever as the variance of an average does, by 1/k and not by a factor in each step (after Chan,
//! Goodwin and Sin, IEEE Transactions on Automatic Control 29, 1984, 110–118, who ask what becomes of modes on the unit
//! circle that noise does not reach).
//!
//! With the limit P∞ from a start, its gain R and Φ = F(I − RH), what is left of the difference from the limit after k
//! steps is Φᵏ D₀ (I + S_k D₀)⁻¹ Φᵏᵀ, where S_k sums what k readings tell of the start. It falls by a factor in each
//! step but for what Φ keeps on the circle. Of that, S_k grows with k only where a reading tells it: so it is 1/k that
//! remains of what is read, and nothing falls of what is not. A gain cannot take from the circle what it never hears
//! of, nor what noise does not feed, whose gain tends to 0.
//!
//! So P falls as an average where a combination cᵀx exists with cᵀF = λcᵀ, |λ| = 1, that noise does not feed (cᵀV = 0)
//! and that the readings tell by itself (cᵀu = 0 for every direction u that they do not tell). Then it is an average of
//! readings. A constant that the readings tell only in a sum with a state that noise feeds is none: only the start
//! tells the two apart, and beyond that no reading counts. Both conditions are one: noise of V and more noise along all
//! that is unseen would not reach λ.

use crate::balance::balanced;
use crate::detectability::detectability;
use crate::error::Error;
use crate::lti::Lti;
use crate::reachability::noise_reach_beside;
use crate::verdict::Verdict::{self, No, Undecided, Yes};
use nalgebra::Dyn;
use numerics::hypot;

/// What is farther from the circle than this is not on it: of two equal eigenvalues rounding leaves half the digits.
const OFF: f64 = 1e-6;
/// A state that has a smaller part in an unseen direction, each in its own unit, has none: else the noise along it
/// would be said to reach that state.
const ROUNDING: f64 = 1e-13;

/// Whether P falls as the variance of an average does from every start that does not know for certain what is averaged.
///
/// # Errors
/// As [`detectability`]; as [`noise_reach_beside`].
pub(crate) fn falls_as_average(system: &Lti<Dyn, Dyn, Dyn>, tolerance: f64) -> Result<Verdict, Error> {
    let Lti { f, h, v, .. } = system;
    let units = balanced(f, h).units;
    let mut unseen = detectability(f, h, tolerance)?.unseen;
    for direction in &mut unseen {
        let own = direction.component_div(&units);
        (0..own.len()).filter(|i| own[*i].abs() <= ROUNDING * own.amax()).for_each(|i| direction[i] = 0.0);
    }
    let found = noise_reach_beside(f, v, &unseen, tolerance)?;
    let off = found.modes.iter().map(|l| (hypot(l.re, l.im) - 1.0).abs()).fold(f64::INFINITY, f64::min);
    Ok(match found.stabilizable {
        Yes => No,
        No if off <= tolerance => Yes,
        // What grows by itself is followed by a gain that has a limit.
        No if off > tolerance.max(OFF) => No,
        _ => Undecided,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamic::{System, steady_state};
    use nalgebra::{DMatrix, dmatrix};

    /// The verdict, and whether iterating agrees: of a fall by 1/k half is left after twice as many steps.
    fn verdict(f: DMatrix<f64>, h: DMatrix<f64>, v: &[f64], start: f64) -> Verdict {
        let (n, p) = (f.nrows(), h.nrows());
        let v = DMatrix::from_diagonal(&nalgebra::DVector::from_column_slice(v));
        let system = System::new(f, DMatrix::zeros(n, 0), h, v, DMatrix::identity(p, p) * 0.2).expect("sound");
        let p0 = DMatrix::identity(n, n) * start;
        let after = |steps: usize| system.steady_state_gain(&p0, steps, 0.0).expect("runs").p;
        let [one, two, four] = [4000, 8000, 16_000].map(after);
        let averages = (&two - &four).amax() > 0.2 * (&one - &two).amax() && (&two - &four).amax() > 1e-9;
        let found = falls_as_average(&system, 1e-12).expect("found");
        assert_eq!(found == Yes, averages, "{found:?}: {one} {two} {four}");
        if found == No {
            let limit = steady_state(&system, p0).expect("a limit");
            assert!(limit.converged && (limit.p - four).amax() < 1e-9, "the limit is that of iterating");
        }
        found
    }

    #[test]
    fn a_constant_that_is_told_only_beside_a_state_that_noise_moves_is_no_average() {
        let (f, h) = (DMatrix::from_diagonal(&nalgebra::dvector![0.9, 1.0, 1.0]), dmatrix![1.0, 1.0, 1.0]);
        assert_eq!(verdict(f.clone(), h.clone(), &[0.1, 0.001, 0.0], 1.0), No);
        assert_eq!(verdict(f, h.clone(), &[0.1, 0.01, 0.0], 1.0), No);
        let turned = DMatrix::from_diagonal(&nalgebra::dvector![1.0, 0.9, 1.0]);
        assert_eq!(verdict(turned, h, &[0.0, 0.1, 0.001], 2.0), No);
        assert_eq!(verdict(DMatrix::identity(2, 2), dmatrix![1.0, 1.0], &[0.001, 0.0], 1.0), No);
    }

    #[test]
    fn a_constant_that_is_told_by_itself_is_an_average_whatever_else_is_unseen() {
        assert_eq!(verdict(dmatrix![1.0], dmatrix![1.0], &[0.0], 1.0), Yes);
        assert_eq!(verdict(DMatrix::identity(2, 2), dmatrix![1.0, 1.0], &[0.0, 0.0], 1.0), Yes);
        // A second reading tells the third state, beside a sum whose parts only the start tells.
        let both = dmatrix![1.0, 1.0, 0.0; 0.0, 0.0, 1.0];
        assert_eq!(verdict(DMatrix::identity(3, 3), both, &[0.001, 0.0, 0.0], 1.0), Yes);
        // What is unseen beside it dies out, and is found but for rounding.
        let dying = DMatrix::from_diagonal(&nalgebra::dvector![1.0, 0.9, 0.9]);
        let beside = dmatrix![1.0, 0.0, 0.0; 1.0, 1.0, 1.0];
        assert_eq!(verdict(dying.clone(), beside, &[0.0, 0.001, 0.1], 1.0), Yes);
        assert_eq!(verdict(dying, dmatrix![1.0, 1.0, 1.0], &[0.0, 0.001, 0.0], 1.0), Yes);
        let dying = DMatrix::from_diagonal(&nalgebra::dvector![0.5, 1.0, 0.5]);
        assert_eq!(verdict(dying, dmatrix![1.0, 0.0, 1.0; 1.0, 1.0, 1.0], &[0.001, 0.0, 0.001], 1.0), Yes);
        // A turn that no noise feeds.
        assert_eq!(verdict(dmatrix![0.6, 0.8; -0.8, 0.6], dmatrix![1.0, 0.0], &[0.0, 0.0], 1.0), Yes);
    }

    #[test]
    fn what_dies_out_or_grows_is_no_average_and_neither_is_what_noise_feeds() {
        assert_eq!(verdict(dmatrix![0.9], dmatrix![1.0], &[0.0], 1.0), No);
        assert_eq!(verdict(dmatrix![1.2], dmatrix![1.0], &[0.0], 1.0), No);
        assert_eq!(verdict(dmatrix![1.0], dmatrix![1.0], &[0.01], 1.0), No);
        assert_eq!(verdict(dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![1.0, 0.0], &[0.0, 0.01], 1.0), No);
    }
}
