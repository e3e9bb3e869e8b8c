//! Which eigenvalues of a matrix are 0, as far as its numbers tell.
//!
//! Of an m-fold eigenvalue rounding leaves 1/m of the digits: a 0 that occurs six times comes out as numbers of size
//! 10⁻³. So it is not asked how small a computed eigenvalue is, but whether the matrix lies within its rounding of one
//! that has so many zeros. An orthogonal change of coordinates splits its null space off, what is left is asked again,
//! and each singular value that is dropped on the way is below the rounding (the staircase form of one eigenvalue,
//! Golub and Van Loan, Matrix Computations, §7.6). What is left has the other eigenvalues, which the zeros then no
//! longer blur. A simple eigenvalue of 10⁻⁶ is far above the rounding and stays.

use crate::balance::balanced;
use crate::decay::rounding;
use alloc::vec::Vec;
use nalgebra::{Complex, DMatrix};
use numerics::{all_finite, eigenvalues, hypot, singular_values};

/// The eigenvalues `found` of `m`, by decreasing modulus, with 0 for those that are 0 within the rounding of `m`, whose
/// entries were computed from numbers of these `sizes`.
pub(crate) fn with_zeros(found: Vec<Complex<f64>>, m: &DMatrix<f64>, sizes: &DMatrix<f64>) -> Vec<Complex<f64>> {
    let n = m.nrows();
    if !all_finite(sizes) {
        return found;
    }
    // Units that fit, of powers of two: a state in kilometres hides none in millimetres.
    let units = balanced(sizes, &DMatrix::zeros(0, n)).units;
    let own = |m: &DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| m[(i, j)] / units[i] * units[j]);
    let (m, noise) = (own(m), rounding(n) * own(sizes).norm());
    let Some(rest) = without_zeros(&m, noise) else { return found };
    let zeros = n - rest.nrows();
    let largest = found.iter().rev().take(zeros).map(|l| hypot(l.re, l.im)).fold(0.0, f64::max);
    // A chain of k zeros is moved by the k-th root of what moves the matrix. Where more has moved them, as in a matrix
    // whose eigenvectors are nearly parallel, no digit of an eigenvalue is known, and none is called 0.
    let size = m.norm();
    let most = || 4.0 * size * libm::pow(noise / size, 1.0 / zeros as f64);
    // What a permutation has split off is 0 already, and the others have their digits.
    if largest == 0.0 || largest > most() {
        return found;
    }
    let Ok(mut clear) = eigenvalues(&rest) else { return found };
    clear.resize(n, Complex::new(0.0, 0.0));
    clear
}

/// What is left of `m` when the zeros of a matrix within `noise` of it are split off, chain by chain; `None` where no
/// singular values are found.
fn without_zeros(m: &DMatrix<f64>, noise: f64) -> Option<DMatrix<f64>> {
    let mut rest = m.clone();
    while rest.nrows() > 0 {
        let found = singular_values(rest.clone()).ok()?;
        let kept = found.values.iter().filter(|value| **value > noise).count();
        if kept == rest.nrows() {
            break;
        }
        // The last columns of the turned matrix vanish: the block before them has the other eigenvalues.
        let directions = found.directions.columns(0, kept);
        rest = directions.transpose() * rest * directions;
    }
    Some(rest)
}

#[cfg(test)]
mod tests {
    use crate::dynamic::{System, error_eigenvalues, steady_state};
    use nalgebra::{Complex, DMatrix, DVector, dmatrix};
    use numerics::hypot;

    /// What has these states, beside so many steps in which a reading of the first is on its way.
    fn delayed(own: &DMatrix<f64>, noise: &[f64], steps: usize, w: f64) -> System {
        let n = own.nrows();
        let f = DMatrix::from_fn(n + steps, n + steps, |i, j| match i {
            _ if i < n => {
                if j < n {
                    own[(i, j)]
                } else {
                    0.0
                }
            }
            _ => f64::from(j == if i == n { 0 } else { i - 1 }),
        });
        let h = DMatrix::from_fn(1, n + steps, |_, j| f64::from(j + 1 == n + steps));
        let v = DVector::from_fn(n + steps, |i, _| noise.get(i).copied().unwrap_or(0.0));
        System::new(f, DMatrix::zeros(n + steps, 0), h, DMatrix::from_diagonal(&v), dmatrix![w]).expect("sound")
    }

    fn with_the_filter_s_gain(system: &System) -> Vec<Complex<f64>> {
        let n = system.f.nrows();
        let gain = steady_state(system, DMatrix::identity(n, n)).expect("a limit").r;
        error_eigenvalues(system, gain).expect("found")
    }

    fn modes(f: DMatrix<f64>) -> Vec<Complex<f64>> {
        let n = f.nrows();
        let h = DMatrix::from_fn(1, n, |_, j| f64::from(j == 0));
        let one = |count| DMatrix::identity(count, count);
        let system = System::new(f, DMatrix::zeros(n, 0), h, one(n), one(1)).expect("sound");
        error_eigenvalues(&system, DMatrix::zeros(n, 1)).expect("found")
    }

    /// How many are 0, to the bit, and the largest modulus of the others.
    fn zeros(found: &[Complex<f64>]) -> (usize, f64) {
        (found.iter().filter(|l| l.re == 0.0 && l.im == 0.0).count(), hypot(found[0].re, found[0].im))
    }

    #[test]
    fn the_delays_of_a_reading_leave_eigenvalues_of_0_and_no_digits_of_rounding() {
        let tracked = dmatrix![1.0, 0.1, 0.005; 0.0, 1.0, 0.1; 0.0, 0.0, 1.0];
        for (own, noise) in [
            (dmatrix![1.0], &[0.01][..]),
            (dmatrix![0.9], &[0.3]),
            (dmatrix![1.0, 0.1; 0.0, 0.98], &[1e-6, 4e-4]),
            (tracked, &[0.0, 0.0, 1e-4]),
        ] {
            for w in [2.5e-5, 1.0, 100.0] {
                // What the reading's delay adds to the eigenvalues is zeros alone.
                let [three, six] = [3, 6].map(|steps| {
                    let found = with_the_filter_s_gain(&delayed(&own, noise, steps, w));
                    let (count, largest) = zeros(&found);
                    assert_eq!(count, steps, "{own} {w}: {found:?}");
                    largest
                });
                assert!((three - six).abs() < 1e-9, "{own} {w}: {three} {six}");
            }
        }
    }

    #[test]
    fn the_other_eigenvalues_are_no_longer_blurred() {
        // Of one state the limit is known: λ = w / (p + w) with p = 0.01 + p w / (p + w).
        let (v, w) = (0.01f64, 2.5e-5);
        let p = 0.5 * (v + (v * v + 4.0 * v * w).sqrt());
        let found = with_the_filter_s_gain(&delayed(&dmatrix![1.0], &[v], 6, w));
        assert!((found[0].re - w / (p + w)).abs() < 1e-12 && found[0].im == 0.0, "{found:?}");
    }

    #[test]
    fn nothing_and_a_chain_of_zeros_have_no_other_eigenvalues() {
        assert_eq!(zeros(&modes(DMatrix::zeros(3, 3))), (3, 0.0));
        let chain = dmatrix![0.0, 1.0, 0.0; 0.0, 0.0, 1.0; 0.0, 0.0, 0.0];
        assert_eq!(zeros(&modes(chain.clone())), (3, 0.0));
        // The same in coordinates that are turned, where no entry is 0; and 0.5 beside it.
        let turn = |n: usize| {
            let u = DVector::from_fn(n, |i, _| 1.0 + i as f64);
            DMatrix::identity(n, n) - &u * u.transpose() * (2.0 / u.norm_squared())
        };
        assert_eq!(zeros(&modes(turn(3) * &chain * turn(3))), (3, 0.0));
        let beside =
            DMatrix::from_fn(4, 4, |i, j| if i < 3 && j < 3 { chain[(i, j)] } else { 0.5 * f64::from(i == j) });
        let (count, largest) = zeros(&modes(turn(4) * beside * turn(4)));
        assert!(count == 3 && (largest - 0.5).abs() < 1e-14, "{count} {largest}");
    }

    #[test]
    fn a_small_eigenvalue_that_the_numbers_tell_stays() {
        let turned = dmatrix![0.6, 0.8; -0.8, 0.6];
        let small = |l: f64| modes(&turned * dmatrix![0.9, 0.0; 0.0, l] * turned.transpose())[1].re;
        assert!((small(1e-6) - 1e-6).abs() < 1e-15 && (small(1e-9) - 1e-9).abs() < 1e-15);
        assert_eq!(small(1e-18), 0.0);
        // Twice 10⁻⁶, and a pair of ±10⁻⁸ that has its digits in units that fit.
        assert!(modes(dmatrix![1e-6, 1.0; 0.0, 1e-6]).iter().all(|l| l.re == 1e-6));
        let found = modes(dmatrix![0.0, 1.0; 1e-16, 0.0]);
        assert!((found[0].re - 1e-8).abs() < 1e-20 && (found[1].re + 1e-8).abs() < 1e-20, "{found:?}");
    }
}
