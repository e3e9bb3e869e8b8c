//! A symmetric matrix of which only the lower triangle is stored, row after row. A map that grows appends rows.

use alloc::vec::Vec;
use nalgebra::DMatrix;

/// A symmetric n×n matrix in n(n + 1)/2 numbers.
///
/// # Example
/// ```
/// let mut p = numerics::PackedSymmetric::from_fn(2, |i, j| if i == j { 1.0 } else { 0.5 });
/// p.push_row([0.1, 0.2, 3.0]);
/// assert_eq!((p.get(0, 2), p.get(2, 0), p.get(2, 2)), (0.1, 0.1, 3.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PackedSymmetric {
    n: usize,
    data: Vec<f64>,
}

/// Where row `i` begins.
const fn start(i: usize) -> usize {
    i * (i + 1) / 2
}

impl PackedSymmetric {
    /// The matrix whose lower triangle `entry` gives.
    pub fn from_fn(n: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let data = (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))).map(|(i, j)| entry(i, j)).collect();
        Self { n, data }
    }

    /// Entry (i, j), which is entry (j, i).
    pub fn get(&self, i: usize, j: usize) -> f64 {
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        self.data[start(i) + j]
    }

    /// Sets entry (i, j) and, by symmetry, entry (j, i).
    pub fn set(&mut self, i: usize, j: usize, value: f64) {
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        self.data[start(i) + j] = value;
    }

    /// Entries 0 to i of row `i`.
    pub fn row(&self, i: usize) -> &[f64] {
        &self.data[start(i)..=start(i) + i]
    }

    /// As [`row`](Self::row), to be changed.
    pub fn row_mut(&mut self, i: usize) -> &mut [f64] {
        &mut self.data[start(i)..=start(i) + i]
    }

    /// Appends a row and, by symmetry, a column: n + 1 numbers, the diagonal last.
    pub fn push_row(&mut self, row: impl IntoIterator<Item = f64>) {
        self.data.extend(row);
        self.n += 1;
        debug_assert_eq!(self.data.len(), start(self.n));
    }

    /// Row `c` of the whole symmetric matrix, into `out`.
    pub fn column(&self, c: usize, out: &mut [f64]) {
        out[..=c].copy_from_slice(self.row(c));
        let mut at = start(c) + c;
        for (i, entry) in out.iter_mut().enumerate().skip(c + 1) {
            at += i;
            *entry = self.data[at];
        }
    }

    /// The diagonal, from the first row on.
    pub fn diagonal(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.n).map(|i| self.data[start(i) + i])
    }

    /// P − KLᵀ − LKᵀ for two columns of K and of L. Both products of a pair are added before they are subtracted, so
    /// the answer would be symmetric to the last bit had both triangles been kept.
    pub fn subtract_pairs(&mut self, k: [&[f64]; 2], l: [&[f64]; 2]) {
        let mut rest = self.data.as_mut_slice();
        for i in 0..self.n {
            let (row, below) = rest.split_at_mut(i + 1);
            rest = below;
            let ([ka, kb], [la, lb]) = (k.map(|c| &c[..=i]), l.map(|c| &c[..=i]));
            let (kai, kbi, lai, lbi) = (ka[i], kb[i], la[i], lb[i]);
            for (j, entry) in row.iter_mut().enumerate() {
                *entry -= (kai * la[j] + lai * ka[j]) + (kbi * lb[j] + lbi * kb[j]);
            }
        }
    }

    /// Both triangles.
    pub fn to_dense(&self) -> DMatrix<f64> {
        DMatrix::from_fn(self.n, self.n, |i, j| self.get(i, j))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DVector;

    fn example() -> PackedSymmetric {
        PackedSymmetric::from_fn(4, |i, j| (10 * i + j) as f64)
    }

    #[test]
    fn an_entry_and_its_mirror_image_are_one() {
        let mut p = example();
        assert_eq!((p.get(1, 3), p.get(3, 1), p.get(2, 2)), (31.0, 31.0, 22.0));
        p.set(0, 2, -5.0);
        assert_eq!(p.row(2), [-5.0, 21.0, 22.0]);
        p.row_mut(1)[0] = 7.0;
        assert_eq!(p.to_dense()[(0, 1)], 7.0);
        assert_eq!(p.diagonal().collect::<Vec<_>>(), [0.0, 11.0, 22.0, 33.0]);
    }

    #[test]
    fn a_column_reads_across_and_down() {
        let (p, mut out) = (example(), [0.0; 4]);
        for c in 0..4 {
            p.column(c, &mut out);
            assert_eq!(out.as_slice(), p.to_dense().column(c).as_slice());
        }
    }

    #[test]
    fn an_appended_row_is_also_a_column() {
        let mut p = example();
        p.push_row([1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!((p.n, p.get(2, 4), p.get(4, 4)), (5, 3.0, 5.0));
    }

    #[test]
    fn subtracting_pairs_is_the_dense_product() {
        let mut p = example();
        let before = p.to_dense();
        let column = |seed: f64| DVector::from_fn(4, |i, _| libm::sin(seed + 3.0 * i as f64));
        let (k, l) = ([column(1.0), column(2.0)], [column(3.0), column(4.0)]);
        p.subtract_pairs([k[0].as_slice(), k[1].as_slice()], [l[0].as_slice(), l[1].as_slice()]);
        let dense = (0..2).fold(before, |m, a| m - &k[a] * l[a].transpose() - &l[a] * k[a].transpose());
        assert!((p.to_dense() - dense).amax() < 1e-14);
    }
}
