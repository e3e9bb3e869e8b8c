//! Whether a pair is observable whatever its entries are, each known to within a part of itself: Gaussian elimination
//! on intervals (Moore, Interval Analysis, 1966).
//!
//! The staircase holds each number against the largest of its matrix. Beside 1e20 a coupling of 0.1 then is nothing,
//! though the zeros around it, and with them what is seen, are as exact as the reader wrote them.

use alloc::vec::Vec;
use nalgebra::DMatrix;
use numerics::power_of_two;

/// What an operation's rounding adds to an interval, as a part of its result.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A number and how far off it may be.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Near {
    value: f64,
    off: f64,
}

impl Near {
    /// A product that underflows is off by less than the smallest normal number; a zero that is exact stays exact.
    fn times(self, other: Self) -> Self {
        let value = self.value * other.value;
        let off = self.value.abs() * other.off + self.off * (other.value.abs() + other.off);
        let exact = (self.value == 0.0 && self.off == 0.0) || (other.value == 0.0 && other.off == 0.0);
        Self { value, off: if exact { 0.0 } else { off * (1.0 + ROUNDING) + rounding_of(value) } }
    }

    fn plus(self, other: Self) -> Self {
        let value = self.value + other.value;
        let exact = self.value == 0.0 || other.value == 0.0;
        let rounding = if exact { 0.0 } else { rounding_of(value) };
        Self { value, off: (self.off + other.off) * (1.0 + ROUNDING) + rounding }
    }

    /// By a number whose interval does not contain 0.
    fn over(self, other: Self) -> Self {
        let (value, least) = (self.value / other.value, other.value.abs() - other.off);
        if self.value == 0.0 && self.off == 0.0 {
            return self;
        }
        Self { value, off: (self.off + value.abs() * other.off) / least * (1.0 + ROUNDING) + rounding_of(value) }
    }

    fn minus(self, other: Self) -> Self {
        self.plus(Self { value: -other.value, ..other })
    }
}

fn rounding_of(value: f64) -> f64 {
    ROUNDING * value.abs() + f64::MIN_POSITIVE
}

/// Whether all pairs with F and C, n×n and p×n, within `spread` of each entry are observable. Of column j of `c` each
/// entry may also be off by `blur` of the largest there.
pub(crate) fn is_observable(f: &DMatrix<f64>, c: &DMatrix<f64>, spread: f64, blur: f64) -> bool {
    let n = f.nrows();
    let near = |value: f64, beside: f64| Near { value, off: spread * value.abs() + blur * beside };
    let f = DMatrix::from_fn(n, n, |i, j| near(f[(i, j)], 0.0));
    let mut outputs = DMatrix::from_fn(c.nrows(), n, |i, j| near(c[(i, j)], c.column(j).amax()));
    let mut rows: Vec<Vec<Near>> = Vec::new();
    for _ in 0..n {
        even(&mut outputs);
        rows.extend(outputs.row_iter().map(|row| row.iter().copied().collect()));
        let zero = Near { value: 0.0, off: 0.0 };
        outputs = DMatrix::from_fn(outputs.nrows(), n, |i, j| {
            (0..n).fold(zero, |sum, k| sum.plus(outputs[(i, k)].times(f[(k, j)])))
        });
    }
    has_full_rank(rows, n)
}

/// Each row in a unit in which its largest number is about 1, so that powers of F do not overflow.
fn even(rows: &mut DMatrix<Near>) {
    for mut row in rows.row_iter_mut() {
        let unit = power_of_two(row.iter().fold(0.0, |most, near| near.value.abs().max(most)));
        row.apply(|near| *near = Near { value: near.value / unit, off: near.off / unit });
    }
}

/// Whether every matrix within these intervals has n independent rows. The pivot is the number that is known best.
fn has_full_rank(mut rows: Vec<Vec<Near>>, n: usize) -> bool {
    let mut open: Vec<usize> = (0..n).collect();
    while !open.is_empty() {
        let mut best = (0, 0, 1.0);
        for (i, row) in rows.iter().enumerate() {
            for (at, &j) in open.iter().enumerate() {
                let known = row[j].value.abs() / row[j].off.max(f64::MIN_POSITIVE);
                if known > best.2 && known < f64::INFINITY {
                    best = (i, at, known);
                }
            }
        }
        // No pivot: 0 may be any of what is left.
        if best.2 <= 1.0 {
            return false;
        }
        let pivot = rows.swap_remove(best.0);
        let column = open.swap_remove(best.1);
        for row in &mut rows {
            let part = row[column].over(pivot[column]);
            for &j in &open {
                row[j] = row[j].minus(part.times(pivot[j]));
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    #[test]
    fn a_zero_that_is_written_is_a_zero_beside_any_number() {
        for large in [1.0, 1e20, 1e60, 1e150] {
            let f = dmatrix![large, 0.1; 0.0, 1.0];
            assert!(is_observable(&f, &dmatrix![1.0, 0.0], 1e-9, 0.0), "{large}");
            assert!(!is_observable(&f, &dmatrix![0.0, 1.0], 1e-9, 0.0), "{large}");
        }
    }

    #[test]
    fn what_another_number_within_the_spread_hides_is_not_certain() {
        let alike = |off: f64| dmatrix![1.0, 0.0; 0.0, 1.0 + off];
        let c = dmatrix![1.0, 1.0];
        assert!(is_observable(&alike(1e-6), &c, 1e-9, 0.0));
        assert!(!is_observable(&alike(1e-11), &c, 1e-9, 0.0));
        assert!(!is_observable(&alike(0.0), &c, 1e-15, 0.0));
    }

    #[test]
    fn a_blurred_column_tells_nothing_by_what_is_small_in_it() {
        let c = dmatrix![1.0, 1.0; 1.0, 1.0 + 1e-13];
        assert!(is_observable(&DMatrix::identity(2, 2), &c, 1e-15, 0.0));
        assert!(!is_observable(&DMatrix::identity(2, 2), &c, 1e-15, 1e-12));
    }

    #[test]
    fn numbers_that_overflow_are_not_certain() {
        let f = dmatrix![1e300, 1e-300; 1e300, 1e300];
        is_observable(&f, &dmatrix![1e-300, 1e300], 1e-9, 0.0);
        assert!(!is_observable(&(f * f64::INFINITY), &dmatrix![1.0, 0.0], 1e-9, 0.0));
    }
}
