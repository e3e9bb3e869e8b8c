//! The staircase form of a pair (F, C): which directions of the state the outputs tell apart, found one step of delay
//! after another by orthogonal changes of coordinates (Van Dooren 1981; Golub and Van Loan, Matrix Computations, §7.6).
//!
//! The powers of F are never formed, so neither their growth nor the repeated eigenvalues of F cost digits.

use crate::error::Error;
use nalgebra::DMatrix;
use numerics::singular_values;

/// F and C in the coordinates z = Tᵀx, T orthogonal: ⎡F₁₁ 0; F₂₁ F₂₂⎤ and [C₁ 0], with (F₁₁, C₁) observable.
#[derive(Clone, Debug)]
pub(crate) struct Staircase {
    /// T, n×n: its first columns are the directions that are seen, the others those that are not.
    pub basis: DMatrix<f64>,
    /// TᵀFT.
    pub f: DMatrix<f64>,
    /// How many directions are seen.
    pub seen: usize,
}

impl Staircase {
    /// The staircase of `f` n×n and `c` p×n. What is smaller than `threshold`, as a part of the matrix that it comes
    /// from, counts as zero.
    ///
    /// # Errors
    /// As [`singular_values`], blaming F.
    pub fn new(f: &DMatrix<f64>, c: &DMatrix<f64>, threshold: f64) -> Result<Self, Error> {
        let n = f.nrows();
        let mut to = Self { basis: DMatrix::identity(n, n), f: f.clone(), seen: 0 };
        let (mut outputs, mut size) = (c.clone(), c.norm());
        while to.seen < n {
            let found = singular_values(outputs).map_err(|e| Error::of_matrix(e, "F"))?;
            let rank = found.values.iter().filter(|value| **value > threshold * size).count();
            if rank == 0 {
                break;
            }
            let mut turn = DMatrix::identity(n, n);
            turn.view_mut((to.seen, to.seen), found.directions.shape()).copy_from(&found.directions);
            to.f = turn.transpose() * to.f * &turn;
            to.basis *= turn;
            // What is left is seen through what has just been found, one step later.
            let next = to.seen + rank;
            outputs = to.f.view((to.seen, next), (rank, n - next)).into_owned();
            size = f.norm();
            to.seen = next;
        }
        Ok(to)
    }

    /// F₁₁: the dynamics of what is seen.
    pub fn seen_block(&self) -> DMatrix<f64> {
        self.f.view((0, 0), (self.seen, self.seen)).into_owned()
    }

    /// F₂₂: the dynamics of what is not, with the eigenvalues that no gain moves.
    pub fn unseen_block(&self) -> DMatrix<f64> {
        let rest = self.f.nrows() - self.seen;
        self.f.view((self.seen, self.seen), (rest, rest)).into_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    #[test]
    fn what_is_not_seen_comes_last_and_stays_to_itself() {
        let (f, c) = (dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.0, 1.0]);
        let form = Staircase::new(&f, &c, 1e-12).expect("found");
        assert_eq!((form.seen, form.seen_block(), form.unseen_block()), (1, dmatrix![1.0], dmatrix![1.0]));
        assert_eq!(form.f[(0, 1)], 0.0);
        assert_eq!(Staircase::new(&f, &dmatrix![1.0, 0.0], 1e-12).expect("found").seen, 2);
        assert_eq!(Staircase::new(&f, &dmatrix![0.0, 0.0], 1e-12).expect("found").seen, 0);
    }

    #[test]
    fn the_coordinates_are_turned_and_not_stretched() {
        let f = dmatrix![0.9, 0.2, 0.1; -0.3, 0.8, 0.4; 0.5, -0.1, 0.7];
        let form = Staircase::new(&f, &dmatrix![1.0, 2.0, -1.0], 1e-12).expect("found");
        assert!((form.basis.transpose() * &form.basis - DMatrix::identity(3, 3)).norm() < 1e-14);
        assert!((&form.basis * &form.f * form.basis.transpose() - f).norm() < 1e-14);
        assert!(form.f[(0, 2)].abs() < 1e-15, "the third direction is seen two steps later only");
    }
}
