//! Units in which the numbers of a system are of one size (Osborne 1960; Parlett and Reinsch 1969).
//!
//! Whether a system is observable does not depend on the units of its states and outputs, but the size of a matrix
//! does, and with it what counts as small. Before a question is asked of (F, C), each state and each output therefore
//! gets units of its own.

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

    fn even_outputs(&mut self) {
        for (mut row, unit) in self.c.row_iter_mut().zip(self.outputs.iter_mut()) {
            let size = power_of_two(row.amax());
            row /= size;
            *unit /= size;
        }
    }
}

/// Evens out what each state receives (its row of F) and what it gives (its column of F and of `c`). A state that only
/// receives, or only gives, gets the units in which that is 1.
pub(crate) fn balanced(f: &DMatrix<f64>, c: &DMatrix<f64>) -> Balanced {
    let n = f.nrows();
    let mut to = Balanced::given(f, c);
    for _ in 0..MAX_SWEEPS {
        to.even_outputs();
        let mut even = true;
        for i in 0..n {
            let others = |at: &dyn Fn(usize) -> f64| (0..n).filter(|&j| j != i).map(|j| at(j).abs()).sum::<f64>();
            let gives = others(&|j| to.f[(j, i)]) + to.c.column(i).lp_norm(1);
            let receives = others(&|j| to.f[(i, j)]);
            let ideal = match (gives > 0.0, receives > 0.0) {
                (true, true) => sqrt(receives / gives),
                (true, false) => 1.0 / gives,
                (false, true) => receives,
                (false, false) => 1.0,
            };
            // To the nearest power of two, hence 1 where the two sizes are alike.
            let unit = power_of_two(0.7 * ideal);
            let units = unit * to.units[i];
            if unit == 1.0 || !(1.0 / FARTHEST..=FARTHEST).contains(&units) {
                continue;
            }
            even = false;
            to.units[i] = units;
            to.f.column_mut(i).scale_mut(unit);
            to.c.column_mut(i).scale_mut(unit);
            to.f.row_mut(i).scale_mut(1.0 / unit);
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
}
