//! A basis of directions that can be read: each has a 1 in one place where the others have 0, and no number that is
//! rounding.

use nalgebra::{DMatrix, DVector};

/// Entries below this are rounding errors: the largest entry of a direction is 1.
const ROUNDING: f64 = 1e-9;

/// The basis of the same directions by elimination with the largest entries as pivots, in the order of these.
pub(super) fn readable(directions: &[DVector<f64>]) -> Vec<Vec<f64>> {
    let Some(n) = directions.first().map(|v| v.len()) else { return Vec::new() };
    let mut rows = DMatrix::from_fn(directions.len(), n, |i, j| directions[i][j]);
    let mut done: Vec<(usize, usize)> = Vec::new();
    for _ in 0..rows.nrows() {
        let open = |i: usize| done.iter().all(|(row, _)| *row != i);
        let mut pivot = (0, 0, 0.0_f64);
        for (i, row) in rows.row_iter().enumerate().filter(|(i, _)| open(*i)) {
            for (j, entry) in row.iter().enumerate() {
                // Of entries that differ by rounding alone the first one is taken.
                if entry.abs() > pivot.2.abs() * (1.0 + ROUNDING) {
                    pivot = (i, j, *entry);
                }
            }
        }
        let (row, column, entry) = pivot;
        if entry == 0.0 {
            break;
        }
        let scaled = rows.row(row) / entry;
        rows.row_mut(row).copy_from(&scaled);
        for i in (0..rows.nrows()).filter(|i| *i != row) {
            let less = rows.row(i) - &scaled * rows[(i, column)];
            rows.row_mut(i).copy_from(&less);
        }
        done.push((row, column));
    }
    done.sort_by_key(|(_, column)| *column);
    let shown = |entry: &f64| if entry.abs() < ROUNDING { 0.0 } else { *entry };
    done.into_iter().map(|(row, _)| rows.row(row).iter().map(shown).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dvector;

    #[test]
    fn a_plane_is_told_by_two_directions_that_differ_in_two_places() {
        let found = readable(&[dvector![0.75, 1.0, 0.0], dvector![0.0, 0.0, -1.0]]);
        assert_eq!(found, [vec![0.75, 1.0, 0.0], vec![0.0, 0.0, 1.0]]);
        let turned = readable(&[dvector![1.0, 1.0, 1.0], dvector![1.0, -1.0, 1.0]]);
        assert_eq!(turned, [vec![1.0, 0.0, 1.0], vec![0.0, 1.0, 0.0]]);
        assert!(readable(&[]).is_empty());
    }
}
