//! Eigenvalues of a general matrix.
//!
//! Not nalgebra's: they never return on some finite matrices, the deadbeat ⎡0 0 0; 1 0 0; 0 1 0⎤ among them. An entry
//! beside two zeros of the diagonal is never negligible to them.

use crate::error::Error;
use crate::sqrt;
use crate::{all_finite, hypot, power_of_two};
use alloc::vec::Vec;
use core::cmp::Ordering;
use nalgebra::linalg::Hessenberg;
use nalgebra::{Complex, DMatrix, Vector3};

/// Iterations granted to one eigenvalue or pair; two or three are usual, and some matrices with a repeated eigenvalue
/// need more than a hundred. As many as LAPACK's `dlahqr` grants a small matrix.
const MAX_ITERATIONS: usize = 300;
/// Every so many iterations without an eigenvalue the shifts are exceptional.
const EXCEPTIONAL: usize = 10;

/// The eigenvalues of a square `m`, by decreasing modulus, then decreasing imaginary part, then decreasing real part.
///
/// Rows and columns that a permutation makes triangular have their eigenvalues on the diagonal, exactly: a pinned or a
/// deadbeat eigenvalue has no rounding. What remains is solved in closed form if it has two rows, else by the QR
/// iteration.
///
/// # Errors
/// [`Error::NotSquare`] when `m` is not square, [`Error::NotFinite`] when an entry is not finite,
/// [`Error::DidNotConverge`] when the iteration reaches its limit.
///
/// # Example
/// ```
/// let deadbeat = nalgebra::dmatrix![0.0, 0.0, 0.0; 1.0, 0.0, 0.0; 0.0, 1.0, 0.0];
/// assert!(numerics::eigenvalues(&deadbeat)?.iter().all(|l| l.re == 0.0 && l.im == 0.0));
/// # Ok::<(), numerics::Error>(())
/// ```
pub fn eigenvalues(m: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    found_with(m, iterated)
}

/// [`eigenvalues`] of a matrix of at most two rows. It needs no iteration, and a program that calls nothing else does
/// not contain one.
///
/// # Errors
/// As [`eigenvalues`]; [`Error::TooLarge`] when more than two rows remain.
///
/// # Example
/// ```
/// let found = numerics::eigenvalues_in_closed_form(&nalgebra::dmatrix![0.0, 1.0; 6.0, 1.0])?;
/// assert_eq!([found[0].re, found[1].re], [3.0, -2.0]);
/// # Ok::<(), numerics::Error>(())
/// ```
pub fn eigenvalues_in_closed_form(m: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    found_with(m, |_| Err(Error::TooLarge))
}

fn found_with(
    m: &DMatrix<f64>,
    beyond_two: impl FnOnce(&DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error>,
) -> Result<Vec<Complex<f64>>, Error> {
    if !m.is_square() {
        return Err(Error::NotSquare);
    }
    if !all_finite(m) {
        return Err(Error::NotFinite);
    }
    let (mut found, rest) = isolated(m);
    let core = DMatrix::from_fn(rest.len(), rest.len(), |i, j| m[(rest[i], rest[j])]);
    match core.nrows() {
        0 => {}
        2 => found.extend(of_two_by_two(&core)),
        _ => found.extend(beyond_two(&core)?),
    }
    let modulus = |l: &Complex<f64>| hypot(l.re, l.im);
    // By insertion: eigenvalues are few, and a general sort is much code where a binary has to be small.
    let mut ordered: Vec<Complex<f64>> = Vec::with_capacity(found.len());
    for l in found {
        let before = |o: &Complex<f64>| {
            let order = modulus(&l).total_cmp(&modulus(o)).then(l.im.total_cmp(&o.im)).then(l.re.total_cmp(&o.re));
            order == Ordering::Greater
        };
        let at = ordered.iter().position(before).unwrap_or(ordered.len());
        ordered.insert(at, l);
    }
    Ok(ordered)
}

/// The diagonal entries that stand alone in their row or column among the indices not yet taken (eigenvalues, exactly),
/// and the indices that are left.
fn isolated(m: &DMatrix<f64>) -> (Vec<Complex<f64>>, Vec<usize>) {
    let mut rest: Vec<usize> = (0..m.nrows()).collect();
    let mut found = Vec::with_capacity(m.nrows());
    let alone = |i: usize, rest: &[usize]| {
        rest.iter().all(|&j| j == i || m[(i, j)] == 0.0) || rest.iter().all(|&j| j == i || m[(j, i)] == 0.0)
    };
    while let Some(at) = rest.iter().position(|&i| alone(i, &rest)) {
        let i = rest.remove(at);
        found.push(Complex::new(m[(i, i)], 0.0));
    }
    (found, rest)
}

/// Both roots of λ² − (a + d)λ + ad − bc. The smaller real one is the determinant over the larger, so that neither is a
/// difference of near-equals; discriminant and determinant keep what is lost in the rounding of their products, or sum
/// and product of two close roots would not be the trace and the determinant.
fn of_two_by_two(m: &DMatrix<f64>) -> [Complex<f64>; 2] {
    let scale = power_of_two(m.amax());
    let (a, b, c, d) = (m[(0, 0)] / scale, m[(0, 1)] / scale, m[(1, 0)] / scale, m[(1, 1)] / scale);
    let half_trace = 0.5 * (a + d);
    let half_difference = 0.5 * (a - d);
    let lost_of_difference = 0.5 * difference_error(a, d);
    let bc = b * c;
    let lost_of_bc = libm::fma(b, c, -bc);
    let discriminant =
        libm::fma(half_difference, half_difference, bc) + (lost_of_bc + 2.0 * half_difference * lost_of_difference);
    let root = sqrt(discriminant.abs());
    if discriminant < 0.0 {
        let (re, im) = (scale * half_trace, scale * root);
        return [Complex::new(re, im), Complex::new(re, -im)];
    }
    let larger = half_trace + libm::copysign(root, half_trace);
    let determinant = libm::fma(a, d, -bc) - lost_of_bc;
    let smaller = if larger == 0.0 { 0.0 } else { determinant / larger };
    [Complex::new(scale * larger, 0.0), Complex::new(scale * smaller, 0.0)]
}

/// What the rounding of a − d lost (Knuth's two-sum).
fn difference_error(a: f64, d: f64) -> f64 {
    let difference = a - d;
    let subtracted = a - difference;
    (a - (difference + subtracted)) + (subtracted - d)
}

/// The eigenvalues by the QR iteration with Francis's double shift on a Hessenberg matrix (Golub and Van Loan, Matrix
/// Computations, §7.5; the exceptional shifts are those of EISPACK's `hqr`).
///
/// An iteration works on the last block that no zero below the diagonal divides. Blocks of one and of two rows have
/// their eigenvalues in closed form.
fn iterated(m: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    let scale = power_of_two(m.amax());
    let mut h = Hessenberg::new(m / scale).unpack_h();
    let norm = h.norm();
    let mut found = Vec::with_capacity(h.nrows());
    let (mut end, mut iteration) = (h.nrows(), 0);
    while end > 0 {
        let start = (1..end).rev().find(|&i| negligible(&h, i, norm, iteration)).unwrap_or(0);
        match end - start {
            1 => found.push(Complex::new(h[(start, start)], 0.0)),
            2 => found.extend(of_two_by_two(&h.view((start, start), (2, 2)).into_owned())),
            _ if iteration == MAX_ITERATIONS => return Err(Error::DidNotConverge),
            _ => {
                iteration += 1;
                francis_step(&mut h, start, end, iteration);
                continue;
            }
        }
        (end, iteration) = (start, 0);
    }
    Ok(found.iter().map(|l| l * scale).collect())
}

/// Whether the entry below the diagonal in row `i` counts as zero: it is rounding beside its neighbours on the
/// diagonal. Beside two zeros, and where the iteration makes no progress, it is held to the whole matrix, whose
/// rounding is as large.
fn negligible(h: &DMatrix<f64>, i: usize, norm: f64, iteration: usize) -> bool {
    let neighbours = h[(i, i)].abs() + h[(i - 1, i - 1)].abs();
    let size = if neighbours == 0.0 || iteration > EXCEPTIONAL { norm } else { neighbours };
    h[(i, i - 1)].abs() <= f64::EPSILON * size
}

/// One step of the iteration on the rows from `start` to before `end`, at least three: both eigenvalues of the last two
/// rows are its shifts.
fn francis_step(h: &mut DMatrix<f64>, start: usize, end: usize, iteration: usize) {
    let last = end - 1;
    let (mut sum, mut product) = (
        h[(last - 1, last - 1)] + h[(last, last)],
        h[(last - 1, last - 1)] * h[(last, last)] - h[(last - 1, last)] * h[(last, last - 1)],
    );
    if iteration.is_multiple_of(EXCEPTIONAL) {
        // Matrices that the usual shifts leave as they are, such as permutations, move under another pair.
        let size = h[(last, last - 1)].abs() + h[(last - 1, last - 2)].abs();
        (sum, product) = (1.5 * size, size * size);
    }
    // The first column of H² − sum·H + product·I.
    let (a, b) = (h[(start, start)], h[(start + 1, start)]);
    let mut column = Vector3::new(
        a * a + h[(start, start + 1)] * b - sum * a + product,
        b * (a + h[(start + 1, start + 1)] - sum),
        b * h[(start + 2, start + 1)],
    );
    for k in start..last {
        let rows = 3.min(end - k);
        if k > start {
            column = Vector3::from_fn(|i, _| if i < rows { h[(k + i, k - 1)] } else { 0.0 });
        }
        let size = column.amax();
        if size == 0.0 {
            continue;
        }
        // Scaled, since the square of a tiny entry vanishes.
        let mut v = column / size;
        v[0] += libm::copysign(v.norm(), v[0]);
        let twice = 2.0 / v.norm_squared();
        for j in k.saturating_sub(1).max(start)..end {
            let dot = twice * (0..rows).map(|i| v[i] * h[(k + i, j)]).sum::<f64>();
            (0..rows).for_each(|i| h[(k + i, j)] -= dot * v[i]);
        }
        for i in start..end.min(k + 4) {
            let dot = twice * (0..rows).map(|j| h[(i, k + j)] * v[j]).sum::<f64>();
            (0..rows).for_each(|j| h[(i, k + j)] -= dot * v[j]);
        }
    }
}

#[cfg(test)]
mod tests;
