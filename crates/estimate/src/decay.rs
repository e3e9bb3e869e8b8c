//! Whether F makes every state die out: whether all its eigenvalues lie inside the unit circle, as far as its numbers
//! tell.
//!
//! An eigenvalue that occurs several times is known much worse than the numbers of the matrix: of two, only half the
//! digits are left. So the verdict rests on what is known well: on the distance from F to the nearest matrix with an
//! eigenvalue on the circle, and on the mean of eigenvalues that lie together.

use crate::balance::balanced;
use crate::error::Error;
use crate::verdict::Verdict;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;
use nalgebra::{Complex, DMatrix};
use numerics::{eigenvalues, hypot, singular_values};

/// How many places of the circle are looked at; if they do not suffice the verdict is left open.
const MAX_PLACES: usize = 2000;

/// What rounding leaves unknown of a matrix of `n` rows, as a part of its size.
pub(crate) fn rounding(n: usize) -> f64 {
    32.0 * n as f64 * f64::EPSILON
}

/// Whether Fᵏ tends to zero. An eigenvalue of modulus 1 − `tolerance` or more does not count as decaying.
///
/// # Errors
/// As [`eigenvalues`] and [`singular_values`], blaming F.
pub(crate) fn decays(f: &DMatrix<f64>, tolerance: f64) -> Result<Verdict, Error> {
    let n = f.nrows();
    if n == 0 {
        return Ok(Verdict::Yes);
    }
    let blame = |e| Error::of_matrix(e, "F");
    let f = balanced(f, &DMatrix::zeros(0, n)).f;
    let found = eigenvalues(&f).map_err(blame)?;
    let (noise, size) = (rounding(n), f.norm().max(1.0));
    let limit = 1.0 - tolerance.max(noise);
    let beyond: Vec<_> = found.iter().filter(|l| modulus(l) >= limit).collect();
    if !beyond.is_empty() {
        let certain = beyond.iter().any(|l| !may_be_inside(l, &found, limit, noise * size));
        return Ok(if certain { Verdict::No } else { Verdict::Undecided });
    }
    let near = comes_near(&f, &found, limit, tolerance.max(noise) * size).map_err(blame)?;
    Ok(if near { Verdict::Undecided } else { Verdict::Yes })
}

/// Whether an eigenvalue outside the `limit` may be one of several that are in truth equal and inside: rounding of size
/// `noise` takes m equal ones apart by about its m-th root, and leaves their mean where it is.
fn may_be_inside(eigenvalue: &Complex<f64>, all: &[Complex<f64>], limit: f64, noise: f64) -> bool {
    let distance = |other: &Complex<f64>| modulus(&(other - eigenvalue));
    let mut nearest = all.to_vec();
    // By insertion: there are few, and the standard library's sort weighs as much as all the rest of this file.
    for i in 1..nearest.len() {
        let mut j = i;
        while j > 0 && distance(&nearest[j]) < distance(&nearest[j - 1]) {
            nearest.swap(j, j - 1);
            j -= 1;
        }
    }
    (2..=all.len()).any(|m| {
        let mean = nearest[..m].iter().sum::<Complex<f64>>() / m as f64;
        distance(&nearest[m - 1]) <= 4.0 * libm::pow(noise, 1.0 / m as f64) && modulus(&mean) < limit
    })
}

/// Whether a matrix within `distance` of `f`, all of whose `eigenvalues` lie inside the circle of this radius, has one
/// on it: whether the least singular value of F − zI gets as small as that on the circle.
///
/// A stretch of the circle is left when one of two bounds says that it does not. From one place to another that
/// singular value changes by no more than the way between them. And the product of all n is |det(F − zI)|, while none
/// is larger than the norm of F − zI.
fn comes_near(
    f: &DMatrix<f64>,
    eigenvalues: &[Complex<f64>],
    radius: f64,
    distance: f64,
) -> Result<bool, numerics::Error> {
    let norm = f.norm() + radius;
    // The conjugate of a place has the same value, F being real: the upper half will do.
    let mut open = vec![(0.5 * PI, 0.5 * PI)];
    for _ in 0..MAX_PLACES {
        let Some((middle, half)) = open.pop() else { return Ok(false) };
        let place = Complex::new(radius * libm::cos(middle), radius * libm::sin(middle));
        let way = radius * half;
        let off = |l: &Complex<f64>| (radius - modulus(l)).max(modulus(&(l - place)) - way);
        if eigenvalues.iter().map(|l| off(l) / norm).product::<f64>() * norm > distance {
            continue;
        }
        let least = least_singular_value(f, place.re, place.im)?;
        if least <= distance {
            return Ok(true);
        }
        if least - way <= distance {
            open.extend([(middle - 0.5 * half, 0.5 * half), (middle + 0.5 * half, 0.5 * half)]);
        }
    }
    Ok(true)
}

/// The least singular value of F − (re + i im)I, from the real matrix of twice its size.
fn least_singular_value(f: &DMatrix<f64>, re: f64, im: f64) -> Result<f64, numerics::Error> {
    let n = f.nrows();
    let real = DMatrix::from_fn(2 * n, 2 * n, |i, j| {
        let (a, b) = (i % n, j % n);
        let one = if a == b { 1.0 } else { 0.0 };
        match (i < n, j < n) {
            (true, false) => im * one,
            (false, true) => -im * one,
            _ => f[(a, b)] - re * one,
        }
    });
    Ok(singular_values(real)?.values[2 * n - 1])
}

fn modulus(l: &Complex<f64>) -> f64 {
    hypot(l.re, l.im)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DVector, dmatrix};

    fn verdict(f: &DMatrix<f64>) -> Verdict {
        decays(f, 1e-9).expect("found")
    }

    fn jordan(n: usize, eigenvalue: f64) -> DMatrix<f64> {
        DMatrix::from_fn(n, n, |i, j| {
            if i == j {
                eigenvalue
            } else if j == i + 1 {
                1.0
            } else {
                0.0
            }
        })
    }

    /// QFQᵀ with a full orthogonal Q.
    fn turned(f: &DMatrix<f64>) -> DMatrix<f64> {
        let n = f.nrows();
        let v = DVector::from_fn(n, |i, _| 1.0 + libm::sin(i as f64));
        let q = DMatrix::identity(n, n) - &v * v.transpose() * (2.0 / v.norm_squared());
        &q * f * &q
    }

    #[test]
    fn an_eigenvalue_within_the_tolerance_of_the_circle_does_not_decay() {
        assert_eq!(verdict(&dmatrix![1.0 - 1e-10]), Verdict::No);
        assert_eq!(verdict(&dmatrix![1.0 - 1e-7]), Verdict::Yes);
        assert_eq!(verdict(&dmatrix![-1.0]), Verdict::No);
        assert_eq!(verdict(&dmatrix![0.0, 1.0; -1.0, 0.0]), Verdict::No);
        assert_eq!(verdict(&DMatrix::zeros(0, 0)), Verdict::Yes);
    }

    #[test]
    fn a_repeated_eigenvalue_on_the_circle_is_not_taken_for_one_inside() {
        for n in 2..=4 {
            assert_eq!(verdict(&turned(&jordan(n, 1.0))), Verdict::No, "{n} times 1");
            assert_eq!(verdict(&turned(&jordan(n, 0.9))), Verdict::Yes, "{n} times 0.9");
            assert_eq!(verdict(&turned(&jordan(n, 0.0))), Verdict::Yes, "{n} times 0");
        }
    }

    #[test]
    fn a_repeated_eigenvalue_that_the_tolerance_moves_across_the_circle_is_left_undecided() {
        assert_eq!(verdict(&turned(&jordan(4, 0.9999))), Verdict::Undecided);
        assert_eq!(verdict(&turned(&jordan(2, 1.0 - 1e-5))), Verdict::Undecided);
        assert_eq!(verdict(&turned(&jordan(2, 1.0 - 1e-3))), Verdict::Yes);
    }

    #[test]
    fn units_do_not_matter() {
        assert_eq!(verdict(&dmatrix![0.5, 1e9; 0.0, 0.5]), Verdict::Yes);
        assert_eq!(verdict(&dmatrix![0.5, 1e9; -1e-10, 0.5]), Verdict::Yes);
        assert_eq!(verdict(&dmatrix![0.5, 1e9; 1e-8, 0.5]), Verdict::No);
    }
}
