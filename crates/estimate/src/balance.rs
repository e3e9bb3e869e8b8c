//! Units in which the numbers of a system are of one size (Osborne 1960; Parlett and Reinsch 1969).
//!
//! Whether a system is observable does not depend on the units of its states and outputs, but the size of a matrix
//! does, and with it what counts as small. Before a question is asked of (F, C), each state and each output therefore
//! gets units of its own.

use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, DVector};
use numerics::power_of_two;
use numerics::sqrt;

/// Sweeps over the states; a handful suffice.
const MAX_SWEEPS: usize = 40;
/// Units go this far, as powers of two: beyond it entries would overflow or vanish.
const FARTHEST: f64 = 1e120;

/// The pair (D⁻¹FD, ECD) with D and E diagonal, of powers of two, so that no number is rounded.
pub(crate) struct Balanced {
    /// D⁻¹FD, n×n.
    pub f: DMatrix<f64>,
    /// ECD, p×n; the largest entry of each row lies between a half and one.
    pub c: DMatrix<f64>,
    /// The diagonal of D: x = Dz for the state z in the new units.
    pub units: DVector<f64>,
    /// The diagonal of E.
    pub outputs: DVector<f64>,
}

impl Balanced {
    /// The pair with the caller's units of the states, and outputs of one size.
    pub fn given(f: &DMatrix<f64>, c: &DMatrix<f64>) -> Self {
        let ones = |n| DVector::repeat(n, 1.0);
        let mut to = Self { f: f.clone(), c: c.clone(), units: ones(f.nrows()), outputs: ones(c.nrows()) };
        to.even_outputs();
        to
    }

    /// A matrix of outputs, p×n, in these units.
    pub fn of_outputs(&self, c: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(c.nrows(), c.ncols(), |i, j| self.outputs[i] * c[(i, j)] * self.units[j])
    }

    fn even_outputs(&mut self) {
        for (mut row, unit) in self.c.row_iter_mut().zip(self.outputs.iter_mut()) {
            let size = power_of_two(row.amax());
            row /= size;
            *unit /= size;
        }
    }

    /// Evens out what these states together receive from the others and what they give. Whether they were even before.
    fn even_out(&mut self, group: &[usize]) -> bool {
        let others = || (0..self.f.nrows()).filter(|j| !group.contains(j));
        let sum = |at: &dyn Fn(usize, usize) -> f64| {
            group.iter().map(|&i| others().map(|j| at(i, j).abs()).sum::<f64>()).sum::<f64>()
        };
        let read: f64 = group.iter().map(|&i| self.c.column(i).lp_norm(1)).sum();
        let gives = sum(&|i, j| self.f[(j, i)]) + read;
        let receives = sum(&|i, j| self.f[(i, j)]);
        let ideal = match (gives > 0.0, receives > 0.0) {
            (true, true) => sqrt(receives / gives),
            (true, false) => 1.0 / gives,
            (false, true) => receives,
            (false, false) => 1.0,
        };
        // To the nearest power of two, hence 1 where the two sizes are alike.
        let unit = power_of_two(0.7 * ideal);
        let fits = |i: &usize| (1.0 / FARTHEST..=FARTHEST).contains(&(unit * self.units[*i]));
        if unit == 1.0 || !group.iter().all(fits) {
            return true;
        }
        for &i in group {
            self.units[i] *= unit;
            self.f.column_mut(i).scale_mut(unit);
            self.c.column_mut(i).scale_mut(unit);
            self.f.row_mut(i).scale_mut(1.0 / unit);
        }
        false
    }
}

/// The groups of several states, and not of all, each of which gives to every other of its group, in a step or in more.
///
/// Between the two states of a turn what each gives and receives is even in any unit that both share. Were only single
/// states evened out, a turn that is read and receives nothing would get smaller units in each sweep, without end: the
/// one that is read gives more than it receives, and the other follows.
fn rings(f: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let n = f.nrows();
    let mut gives = DMatrix::from_fn(n, n, |i, j| f[(j, i)] != 0.0);
    for via in 0..n {
        for i in 0..n {
            for j in 0..n {
                gives[(i, j)] |= gives[(i, via)] && gives[(via, j)];
            }
        }
    }
    let ring = |i: usize| (0..n).filter(|&j| j == i || gives[(i, j)] && gives[(j, i)]).collect::<Vec<_>>();
    let first = |i: usize, ring: &[usize]| ring.first() == Some(&i) && (2..n).contains(&ring.len());
    (0..n).map(|i| (i, ring(i))).filter(|(i, ring)| first(*i, ring)).map(|(_, ring)| ring).collect()
}

/// Evens out what each state receives (its row of F) and what it gives (its column of F and of `c`), and the same of
/// each of the [`rings`]. What only receives, or only gives, gets the units in which that is 1.
pub(crate) fn balanced(f: &DMatrix<f64>, c: &DMatrix<f64>) -> Balanced {
    let n = f.nrows();
    let mut to = Balanced::given(f, c);
    let groups: Vec<Vec<usize>> = (0..n).map(|i| vec![i]).chain(rings(f)).collect();
    for _ in 0..MAX_SWEEPS {
        to.even_outputs();
        let mut even = true;
        for group in &groups {
            even &= to.even_out(group);
        }
        if even {
            break;
        }
    }
    to
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    #[test]
    fn ordinary_numbers_keep_their_units() {
        let (f, c) = (dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![1.0, 0.0]);
        let even = balanced(&f, &c);
        let d = DMatrix::from_diagonal(&even.units);
        assert_eq!(&d * even.f, f * &d);
        assert!(even.units.iter().all(|unit| (0.5..=2.0).contains(unit)), "{}", even.units);
    }

    #[test]
    fn nanometres_and_kilometres_become_numbers_of_one_size() {
        let even = balanced(&dmatrix![1.0, 1e12; 0.0, 1.0], &dmatrix![1e-9, 0.0]);
        let sizes = [even.f[(0, 1)], even.c[(0, 0)]];
        assert!(sizes.iter().all(|size| (0.25..=2.0).contains(size)), "{sizes:?}");
        assert_eq!(even.f[(0, 0)], 1.0);
    }

    /// A turn that is read beside a state by itself: neither of the two gives to the other, and the output has both.
    #[test]
    fn a_turn_beside_another_state_keeps_its_size() {
        let turn = dmatrix![0.9976, 0.0699, 0.0; -0.0699, 0.9976, 0.0; 0.0, 0.0, 0.9];
        let even = balanced(&turn, &dmatrix![1.0, 0.0, 1.0]);
        assert!(even.c[(0, 0)] / even.c[(0, 2)] > 0.2, "{}", even.c);
        assert!(even.f[(0, 1)].abs() > 0.01 && even.f[(1, 0)].abs() > 0.01, "{}", even.f);
        // And of a turn that only receives.
        let even = balanced(&turn.transpose().insert_row(3, 0.0).insert_column(3, 1e-6), &dmatrix![0.0, 0.0, 1.0, 0.0]);
        let fed = [even.f[(0, 3)], even.f[(1, 3)]].map(f64::abs);
        assert!(fed.iter().all(|size| (0.01..=4.0).contains(size)), "{fed:?}");
    }
}
