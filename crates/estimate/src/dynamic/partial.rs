//! A reading of which parts are missing.

use alloc::vec::Vec;
use nalgebra::DMatrix;

/// The rows of H that belong to the parts of `y` that are there, and these rows and columns of W.
pub(super) fn rows_there(h: &DMatrix<f64>, w: &DMatrix<f64>, y: &[Option<f64>]) -> (DMatrix<f64>, DMatrix<f64>) {
    let rows: Vec<usize> = (0..y.len()).filter(|i| y[*i].is_some()).collect();
    (
        DMatrix::from_fn(rows.len(), h.ncols(), |i, j| h[(rows[i], j)]),
        DMatrix::from_fn(rows.len(), rows.len(), |i, j| w[(rows[i], rows[j])]),
    )
}
