//! Exact arithmetic on whole matrices.

use nalgebra::DMatrix;

/// A prime near 2⁶¹: the rank of a whole matrix modulo it is, but for one chance in 10¹⁸, its rank.
const PRIME: i128 = (1 << 61) - 1;

/// G/d with a whole G.
#[derive(Clone, Debug)]
pub struct Whole {
    pub g: DMatrix<i64>,
    pub divisor: i64,
}

impl Whole {
    /// G/d in floating point.
    pub fn matrix(&self) -> DMatrix<f64> {
        self.g.map(|e| e as f64 / self.divisor as f64)
    }

    /// The coefficients of det(λI − G/d), the leading one first, by Faddeev and LeVerrier.
    pub fn characteristic_polynomial(&self) -> Vec<f64> {
        let n = self.g.nrows();
        let g = self.g.map(i128::from);
        let mut m = DMatrix::<i128>::zeros(n, n);
        let (mut coefficient, mut power) = (1_i128, 1.0);
        let mut found = vec![1.0];
        for k in 1..=n {
            m = product(&g, &m);
            for i in 0..n {
                m[(i, i)] += coefficient;
            }
            coefficient = -product(&g, &m).trace() / k as i128;
            power *= self.divisor as f64;
            found.push(coefficient as f64 / power);
        }
        found
    }
}

/// The rank of [H; HG; …; HGⁿ⁻¹], which that of the pair's divisors does not change.
pub fn observability_rank(g: &Whole, h: &Whole) -> usize {
    let n = g.g.nrows();
    let reduced = |m: &DMatrix<i64>| m.map(|e| i128::from(e).rem_euclid(PRIME));
    let (g, mut block) = (reduced(&g.g), reduced(&h.g));
    let mut rows: Vec<Vec<i128>> = Vec::new();
    for _ in 0..n {
        rows.extend(block.row_iter().map(|r| r.iter().copied().collect::<Vec<_>>()));
        block = product(&block, &g).map(|e| e.rem_euclid(PRIME));
    }
    let mut rank = 0;
    for column in 0..n {
        let Some(at) = (rank..rows.len()).find(|&i| rows[i][column] != 0) else { continue };
        rows.swap(rank, at);
        let inverse = power(rows[rank][column], PRIME - 2);
        let pivot = rows[rank].clone();
        for row in &mut rows[rank + 1..] {
            let factor = row[column] * inverse % PRIME;
            for (e, p) in row.iter_mut().zip(&pivot) {
                *e = (*e - factor * p % PRIME).rem_euclid(PRIME);
            }
        }
        rank += 1;
    }
    rank
}

fn product(a: &DMatrix<i128>, b: &DMatrix<i128>) -> DMatrix<i128> {
    DMatrix::from_fn(a.nrows(), b.ncols(), |i, j| (0..a.ncols()).map(|k| a[(i, k)] * b[(k, j)]).sum())
}

fn power(base: i128, exponent: i128) -> i128 {
    let (mut base, mut exponent, mut result) = (base, exponent, 1);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = result * base % PRIME;
        }
        base = base * base % PRIME;
        exponent >>= 1;
    }
    result
}
