//! Placement with several outputs, reduced to one: after a first gain K₁ one combination q of the outputs sees the
//! whole state, and Ackermann's formula answers for (F − K₁C, qC) (Heymann, IEEE Transactions on Automatic Control 13,
//! 1968, 748–749).
//!
//! Almost every K₁ and q will do. A few are tried, always the same, and the smallest gain that puts the poles where
//! they belong is taken.

use super::factor::Factor;
use super::{ackermann, meets};
use nalgebra::DMatrix;

/// First gains that are tried beside none.
const FIRST_GAINS: usize = 4;
/// Combinations that are tried beside the single outputs.
const COMBINATIONS: usize = 4;
/// How closely the poles must be met for a gain to be taken, as [`meets`] measures it.
const CLOSE: f64 = 1e-9;

/// The K, n×p, for which f − K·c has the roots of `factors`; `None` where none was found.
pub(super) fn gain(f: &DMatrix<f64>, c: &DMatrix<f64>, factors: &[Factor]) -> Option<DMatrix<f64>> {
    let (n, p) = (f.nrows(), c.nrows());
    let size = 0.5 * (1.0 + f.norm()) / c.norm();
    let mut best: Option<(f64, DMatrix<f64>)> = None;
    let mut consider = |gain: Option<DMatrix<f64>>| {
        let Some(gain) = gain else { return };
        let length = gain.norm();
        let better = best.as_ref().is_none_or(|(least, _)| length < *least);
        if better && length.is_finite() && meets(&(f - &gain * c), factors, CLOSE) {
            best = Some((length, gain));
        }
    };
    consider(direct(f, c, factors));
    for first in 0..=FIRST_GAINS {
        let before = if first == 0 { DMatrix::zeros(n, p) } else { irregular(n, p, first) * size };
        let rest = f - &before * c;
        for choice in 0..p + COMBINATIONS {
            let unit = DMatrix::from_fn(1, p, |_, j| if j == choice { 1.0 } else { 0.0 });
            let q = if choice < p { unit } else { irregular(1, p, choice) };
            consider(ackermann(&rest, &(&q * c), factors).map(|k| &before + k * q));
        }
    }
    best.map(|(_, gain)| gain)
}

/// (F − Λ)C⁻¹ where the outputs are as many as the states and tell them all: each state has a pole of its own.
fn direct(f: &DMatrix<f64>, c: &DMatrix<f64>, factors: &[Factor]) -> Option<DMatrix<f64>> {
    let normal = c.transpose() * c;
    let mut wanted = DMatrix::zeros(f.nrows(), f.nrows());
    let mut at = 0;
    for factor in factors {
        match factor {
            Factor::Real(root) => wanted[(at, at)] = *root,
            Factor::Pair(root) => {
                let block = nalgebra::matrix![root.re, root.im; -root.im, root.re];
                wanted.view_mut((at, at), (2, 2)).copy_from(&block);
                at += 1;
            }
        }
        at += 1;
    }
    Some((f - wanted) * normal.lu().solve(&c.transpose())?)
}

/// A full matrix without pattern, the same for the same `number`; its entries lie between −1 and 1.
fn irregular(rows: usize, columns: usize, number: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |i, j| libm::sin(((7 * i + 3 * j + 1) * (2 * number + 1)) as f64))
}
