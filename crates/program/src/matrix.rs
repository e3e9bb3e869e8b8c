//! Matrices of a few rows, stored by rows. The factor of a symmetric positive definite one is the core's.

use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;
use numerics::Spd;

/// A real matrix; a number is 1×1.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    /// Rows.
    pub rows: usize,
    /// Columns.
    pub columns: usize,
    /// The entries, row after row.
    pub entries: Vec<f64>,
}

impl Matrix {
    /// The matrix of these entries, row after row; what is missing is 0.
    pub fn new(rows: usize, columns: usize, mut entries: Vec<f64>) -> Self {
        entries.resize(rows * columns, 0.0);
        Self { rows, columns, entries }
    }

    /// A column.
    pub fn column(entries: &[f64]) -> Self {
        Self::new(entries.len(), 1, entries.to_vec())
    }

    pub(crate) fn zeros(rows: usize, columns: usize) -> Self {
        Self::made(rows, columns, &|_, _| 0.0)
    }

    pub(crate) fn number(x: f64) -> Self {
        Self::new(1, 1, vec![x])
    }

    pub(crate) fn identity(n: usize) -> Self {
        Self::made(n, n, &|i, j| if i == j { 1.0 } else { 0.0 })
    }

    /// Entry (i, j), from 0; 0 beyond its ends.
    #[inline(never)]
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.entries.get(i * self.columns + j).copied().unwrap_or(0.0)
    }

    pub(crate) fn is_number(&self) -> bool {
        self.rows == 1 && self.columns == 1
    }

    /// Entry by entry, row after row: `entry(i, j)`.
    #[inline(never)]
    pub(crate) fn made(rows: usize, columns: usize, entry: &dyn Fn(usize, usize) -> f64) -> Self {
        let mut entries = Vec::with_capacity(rows * columns);
        for i in 0..rows {
            for j in 0..columns {
                entries.push(entry(i, j));
            }
        }
        Self { rows, columns, entries }
    }

    pub(crate) fn transposed(&self) -> Self {
        Self::made(self.columns, self.rows, &|i, j| self.at(j, i))
    }

    pub(crate) fn scaled(&self, by: f64) -> Self {
        let mut scaled = self.clone();
        for entry in &mut scaled.entries {
            *entry *= by;
        }
        scaled
    }

    /// self + by · other, of one size.
    pub(crate) fn plus(&self, by: f64, other: &Self) -> Self {
        let mut sum = self.clone();
        for (entry, other) in sum.entries.iter_mut().zip(&other.entries) {
            *entry += by * other;
        }
        sum
    }

    /// The product; where either is a number, the multiple.
    pub(crate) fn times(&self, other: &Self) -> Self {
        if self.is_number() {
            return other.scaled(self.at(0, 0));
        }
        if other.is_number() {
            return self.scaled(other.at(0, 0));
        }
        let mut entries = Vec::with_capacity(self.rows * other.columns);
        for row in self.entries.chunks(self.columns.max(1)) {
            for j in 0..other.columns {
                let column = other.entries.iter().skip(j).step_by(other.columns);
                let mut sum = 0.0;
                for (a, b) in row.iter().zip(column) {
                    sum += a * b;
                }
                entries.push(sum);
            }
        }
        Self::new(self.rows, other.columns, entries)
    }

    fn dense(&self) -> DMatrix<f64> {
        DMatrix::from_row_slice(self.rows, self.columns, &self.entries)
    }

    fn of(dense: &DMatrix<f64>) -> Self {
        Self::made(dense.nrows(), dense.ncols(), &|i, j| dense[(i, j)])
    }

    pub(crate) fn is_symmetric(&self) -> bool {
        let mut symmetric = self.rows == self.columns;
        for i in 0..self.rows {
            for j in 0..i {
                symmetric &= self.at(i, j) == self.at(j, i);
            }
        }
        symmetric
    }

    /// L with LLᵀ = self, of which the lower triangle is read; none where it is not positive definite.
    pub(crate) fn root(&self) -> Option<Self> {
        Spd::new(self.dense()).map(|factor| Self::of(&factor.root()))
    }

    /// self⁻¹ b and det self: by the core's factor where self is symmetric and positive definite, else by Gauss's
    /// elimination with the largest pivot of each column. None where a pivot is 0 or not finite.
    pub(crate) fn solved(&self, b: &Self) -> Option<Self> {
        if self.is_symmetric()
            && let Some(factor) = Spd::new(self.dense())
        {
            return Some(Self::of(&factor.solve(&b.dense())));
        }
        let mut x = b.clone();
        self.eliminated(&mut x).map(|_| x)
    }

    pub(crate) fn determinant(&self) -> f64 {
        self.eliminated(&mut Self::zeros(self.rows, 0)).unwrap_or(0.0)
    }

    /// Solves for `x` in its place, and answers the determinant.
    fn eliminated(&self, x: &mut Self) -> Option<f64> {
        let (mut a, n, mut determinant) = (self.clone(), self.rows, 1.0);
        for k in 0..n {
            let mut best = k;
            for i in k + 1..n {
                if libm::fabs(a.at(i, k)) > libm::fabs(a.at(best, k)) {
                    best = i;
                }
            }
            // In the place of an exchange the best row is added: the sign of the determinant stays.
            if best != k {
                let by = if a.at(best, k) * a.at(k, k) < 0.0 { -1.0 } else { 1.0 };
                a.add_row(k, by, best);
                x.add_row(k, by, best);
            }
            let pivot = a.at(k, k);
            if !(libm::fabs(pivot) >= f64::MIN_POSITIVE && pivot.is_finite()) {
                return None;
            }
            determinant *= pivot;
            for i in 0..n {
                if i != k {
                    let by = -a.at(i, k) / pivot;
                    a.add_row(i, by, k);
                    x.add_row(i, by, k);
                }
            }
            a.scale_row(k, 1.0 / pivot);
            x.scale_row(k, 1.0 / pivot);
        }
        Some(determinant)
    }

    fn scale_row(&mut self, row: usize, by: f64) {
        for j in 0..self.columns {
            self.put(row, j, by * self.at(row, j));
        }
    }

    fn put(&mut self, i: usize, j: usize, x: f64) {
        if let Some(entry) = self.entries.get_mut(i * self.columns + j) {
            *entry = x;
        }
    }

    fn add_row(&mut self, to: usize, by: f64, from: usize) {
        for j in 0..self.columns {
            self.put(to, j, self.at(to, j) + by * self.at(from, j));
        }
    }
}
