//! How far a pair (F, C) is from the nearest one that is not observable: the least singular value of [F − zI; C] over
//! all complex z (Eising, Systems and Control Letters 4, 1984, 225–229).
//!
//! The staircase finds what is not seen, but it does not tell how far a pair is from one that hides something: each of
//! its steps may be well above the tolerance, and their product far below.

use crate::decay::rounding;
use alloc::vec;
use core::f64::consts::SQRT_2;
use nalgebra::{Complex, DMatrix};
use numerics::{eigenvalues, hypot, singular_values};

/// How many places of the plane are looked at; if they do not suffice nothing is said.
const MAX_PLACES: usize = 2000;

/// A pair, each matrix as a part of its own size (the root of the sum of its squares), so that what is changed by a
/// part of each is changed by no more than that part.
pub(crate) struct Pair {
    f: DMatrix<f64>,
    c: DMatrix<f64>,
    /// The size of F.
    size: f64,
    /// How far off C may be besides, as a part of its size.
    blur: f64,
}

impl Pair {
    /// The pair `f` and `c`, which was computed and may be off by a matrix of the size of `off`; `None` where the
    /// numbers are too large or too small to be compared.
    pub fn new(f: &DMatrix<f64>, c: &DMatrix<f64>, off: &DMatrix<f64>) -> Option<Self> {
        let [of_f, of_c, blur] = [f, c, off].map(size);
        let fit = |size: f64| size.is_finite() && size > 0.0;
        (fit(of_f) && fit(of_c)).then(|| Self { f: f / of_f, c: c / of_c, size: of_f, blur: blur / of_c })
    }

    /// The modulus of an eigenvalue, the largest, that one change of no more than this part of F and of C hides from
    /// the outputs: a complex change where the eigenvalue is. It is looked for at the eigenvalues of F, so that `None`
    /// does not say that there is none.
    pub fn hidden_within(&self, part: f64) -> Option<f64> {
        let found = eigenvalues(&self.f).ok()?;
        let near = found.iter().filter(|z| z.im >= 0.0 && self.least(z.re, z.im).is_some_and(|least| least <= part));
        near.map(|z| hypot(z.re, z.im) * self.size).reduce(f64::max)
    }

    /// Whether every pair is observable of which F and C are each within `part` of these. `false` does not say that one
    /// is not: the places may not have sufficed.
    ///
    /// From one z to another the least singular value changes by no more than the way between them: so where it is
    /// larger than the way to the corners of a square, and by `part`, there is none such in the square. A z that is
    /// larger than F is none in any case, and the conjugate of one has the same value, F and C being real.
    pub fn is_observable_within(&self, part: f64) -> bool {
        // What both change together, and what rounding changes of the singular values.
        let part = hypot(part, part + self.blur) + 2.0 * rounding(self.f.nrows());
        if self.hidden_within(part).is_some() {
            return false;
        }
        let half = 0.5 * (1.0 + part);
        let mut open = vec![(-half, half, half), (half, half, half)];
        for _ in 0..MAX_PLACES {
            let Some((re, im, half)) = open.pop() else { return true };
            let way = SQRT_2 * half;
            if hypot(re, im) - way > 1.0 + part {
                continue;
            }
            let Some(least) = self.least(re, im).filter(|least| *least > part) else { return false };
            if least - way <= part {
                let h = 0.5 * half;
                open.extend([(re - h, im - h, h), (re + h, im - h, h), (re - h, im + h, h), (re + h, im + h, h)]);
            }
        }
        false
    }

    /// The least singular value of [F − (re + i im)I; C], from the real matrix of twice its size.
    fn least(&self, re: f64, im: f64) -> Option<f64> {
        let (n, p) = (self.f.nrows(), self.c.nrows());
        let z = Complex::new(re, im);
        let real = DMatrix::from_fn(2 * (n + p), 2 * n, |i, j| {
            let (a, b) = (i % (n + p), j % n);
            let one = if a == b { 1.0 } else { 0.0 };
            match (i < n + p, j < n) {
                (true, true) | (false, false) if a >= n => self.c[(a - n, b)],
                _ if a >= n => 0.0,
                (true, false) => z.im * one,
                (false, true) => -z.im * one,
                _ => self.f[(a, b)] - z.re * one,
            }
        });
        singular_values(real).ok()?.values.last().copied()
    }
}

/// The root of the sum of squares, which neither overflow nor vanish.
fn size(matrix: &DMatrix<f64>) -> f64 {
    let most = matrix.amax();
    if most > 0.0 { (matrix / most).norm() * most } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    fn pair(f: DMatrix<f64>, c: DMatrix<f64>) -> Pair {
        Pair::new(&f, &c, &(&c * 0.0)).expect("of ordinary size")
    }

    #[test]
    fn the_distance_is_that_of_the_change_that_hides_a_state() {
        // Two states that go alike but for d do so within d/2 of each, which is 0.35 d of the size of F.
        for d in [1e-2, 1e-4, 1e-6] {
            let f = dmatrix![1.0, 0.0; 0.0, 1.0 + d];
            let two = pair(f.clone(), dmatrix![1.0, 1.0]);
            assert!(two.is_observable_within(0.2 * d), "{d}");
            assert!(!two.is_observable_within(0.3 * d), "{d}");
        }
        assert_eq!(pair(dmatrix![0.5, 0.0; 0.0, 0.9], dmatrix![1.0, 1e-10]).hidden_within(1e-9), Some(0.9));
        assert_eq!(pair(dmatrix![0.5, 0.0; 0.0, 0.9], dmatrix![1.0, 1e-8]).hidden_within(1e-9), None);
    }

    #[test]
    fn a_turn_is_seen_by_either_of_its_states() {
        let turn = dmatrix![0.6, 0.8; -0.8, 0.6];
        assert!(pair(turn.clone(), dmatrix![0.0, 1.0]).is_observable_within(0.1));
        assert!(!pair(turn, dmatrix![0.0, 1.0]).is_observable_within(0.9));
        let one = dmatrix![1.0];
        assert!(Pair::new(&one, &dmatrix![0.0], &dmatrix![0.0]).is_none());
        let blurred = |off: f64| Pair::new(&one, &one, &dmatrix![off]).is_some_and(|it| it.is_observable_within(0.0));
        assert!(blurred(0.5) && !blurred(1.5));
    }

    #[test]
    fn a_repeated_eigenvalue_does_not_hide_that_all_is_seen() {
        let f = DMatrix::from_fn(4, 4, |i, j| if i == j || j == i + 1 { 1.0 } else { 0.0 });
        assert!(pair(f.clone(), dmatrix![1.0, 0.0, 0.0, 0.0]).is_observable_within(1e-3));
        assert!(!pair(f, dmatrix![0.0, 1.0, 0.0, 0.0]).is_observable_within(1e-9));
    }
}
