//! The systems, by family: system `index` of a family is always the same one.

use super::exact::Whole;
use nalgebra::DMatrix;

/// A family: its systems (F, H) by index.
pub type Family = fn(u64) -> (Whole, Whole);

/// All of them.
pub const FAMILIES: [Family; 10] =
    [rotation, small_whole, decimal, turned, companion, jordan, permutation, nilpotent, repeated_rows, every_three];

/// SplitMix64: numbers in no visible order from an index.
struct Mix(u64);

impl Mix {
    /// A whole number from `low` to `high`.
    fn between(&mut self, low: i64, high: i64) -> i64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + ((z ^ (z >> 31)) % (high - low + 1) as u64) as i64
    }

    fn size(&mut self) -> usize {
        self.between(2, 6) as usize
    }

    fn matrix(&mut self, rows: usize, columns: usize, most: i64) -> DMatrix<i64> {
        DMatrix::from_fn(rows, columns, |_, _| self.between(-most, most))
    }

    /// An output of one row, or of two in one system of four.
    fn output(&mut self, n: usize) -> Whole {
        let rows = 1 + usize::from(self.between(0, 3) == 0);
        Whole { g: self.matrix(rows, n, 10), divisor: 10 }
    }

    /// `m` in another basis, by a few additions of one row to another and back: the eigenvalues stay.
    fn disguised(&mut self, mut m: DMatrix<i64>) -> DMatrix<i64> {
        let n = m.nrows();
        for _ in 0..self.between(0, n as i64) {
            let (i, j, by) = (self.between(0, n as i64 - 1) as usize, self.between(0, n as i64 - 1) as usize, 1);
            if i != j {
                let row = m.row(j) * by;
                let sum = m.row(i) + row;
                m.set_row(i, &sum);
                let column = m.column(i) * by;
                let difference = m.column(j) - column;
                m.set_column(j, &difference);
            }
        }
        m
    }
}

fn whole(g: DMatrix<i64>) -> Whole {
    Whole { g, divisor: 1 }
}

/// The rotation of 3, 4 and 5, and others, with H on a grid of hundredths.
fn rotation(index: u64) -> (Whole, Whole) {
    let (i, j) = ((index % 313) as i64 - 156, (index / 313 % 320) as i64 - 160);
    let (c, s, r) = [(6, 8, 10), (5, 12, 13), (0, 1, 1), (1, 1, 1), (24, 7, 25)][(index % 5) as usize];
    (
        Whole { g: DMatrix::from_row_slice(2, 2, &[c, -s, s, c]), divisor: r },
        Whole { g: DMatrix::from_row_slice(1, 2, &[i, j]), divisor: 100 },
    )
}

fn small_whole(index: u64) -> (Whole, Whole) {
    let mut mix = Mix(index);
    let n = mix.size();
    (whole(mix.matrix(n, n, 3)), mix.output(n))
}

fn decimal(index: u64) -> (Whole, Whole) {
    let mut mix = Mix(index);
    let n = mix.size();
    (Whole { g: mix.matrix(n, n, 20), divisor: 10 }, mix.output(n))
}

/// Products of two plane rotations by 3, 4 and 5 in up to six dimensions.
fn turned(index: u64) -> (Whole, Whole) {
    let mut mix = Mix(index);
    let n = mix.size();
    let mut plane = || {
        let i = mix.between(0, n as i64 - 2) as usize;
        let j = mix.between(i as i64 + 1, n as i64 - 1) as usize;
        let mut g = DMatrix::from_diagonal_element(n, n, 10);
        let s = 8 * (2 * mix.between(0, 1) - 1);
        (g[(i, i)], g[(j, j)], g[(i, j)], g[(j, i)]) = (6, 6, -s, s);
        g
    };
    let g = plane() * plane();
    (Whole { g, divisor: 100 }, mix.output(n))
}

fn companion(index: u64) -> (Whole, Whole) {
    let mut mix = Mix(index);
    let n = mix.size();
    let mut g = DMatrix::from_fn(n, n, |i, j| i64::from(j == i + 1));
    for j in 0..n {
        g[(n - 1, j)] = mix.between(-4, 4);
    }
    let g = if mix.between(0, 1) == 0 { g } else { g.transpose() };
    (whole(g), mix.output(n))
}

fn jordan(index: u64) -> (Whole, Whole) {
    let mut mix = Mix(index);
    let n = mix.size();
    let mut g = DMatrix::zeros(n, n);
    let mut value = mix.between(-2, 2);
    for i in 0..n {
        g[(i, i)] = value;
        if i + 1 < n {
            if mix.between(0, 2) > 0 {
                g[(i, i + 1)] = 1;
            } else {
                value = mix.between(-2, 2);
            }
        }
    }
    let g = mix.disguised(g);
    (whole(g), mix.output(n))
}

/// A permutation, with signs in every second.
fn permutation(index: u64) -> (Whole, Whole) {
    let mut mix = Mix(index);
    let n = mix.size();
    let mut order: Vec<usize> = (0..n).collect();
    for i in (1..n).rev() {
        order.swap(i, mix.between(0, i as i64) as usize);
    }
    let lowest = if mix.between(0, 1) == 0 { 0 } else { -1 };
    let mut g = DMatrix::zeros(n, n);
    for (i, j) in order.into_iter().enumerate() {
        g[(i, j)] = 2 * mix.between(lowest, 0) + 1;
    }
    (whole(g), mix.output(n))
}

fn nilpotent(index: u64) -> (Whole, Whole) {
    let mut mix = Mix(index);
    let n = mix.size();
    let g = DMatrix::from_fn(n, n, |i, j| if j > i { mix.between(-2, 2) } else { 0 });
    let g = mix.disguised(g);
    (whole(g), mix.output(n))
}

fn repeated_rows(index: u64) -> (Whole, Whole) {
    let mut mix = Mix(index);
    let n = mix.size();
    let mut g = mix.matrix(n, n, 9);
    for i in 0..n {
        let from = mix.between(0, i as i64) as usize;
        let row = g.row(from).into_owned();
        g.set_row(i, &row);
    }
    (Whole { g, divisor: 10 }, mix.output(n))
}

/// Every 3×3 matrix of −1, 0 and 1, one after another.
fn every_three(index: u64) -> (Whole, Whole) {
    let mut digits = index % 19_683;
    let g = DMatrix::from_fn(3, 3, |_, _| {
        let digit = (digits % 3) as i64 - 1;
        digits /= 3;
        digit
    });
    (whole(g), Mix(index).output(3))
}
