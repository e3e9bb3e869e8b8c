//! Where the poles of an observer may go: Ackermann's formula on the pair (F, HF) (Theorem J.3.2, transposed).

mod factor;
mod movable;
mod several;

pub use movable::Movable;

use crate::error::{Code, Error};
use crate::observability::{analyze, observability_matrix};
use crate::validate;
use alloc::format;
use factor::{Factor, evaluate, real_factors};
use nalgebra::{Complex, DMatrix, DVector, SMatrix, SVector};

/// Singular values of Q or of [HF; …; HFⁿ] below this part of the largest count as zero.
const RANK_TOLERANCE: f64 = 1e-9;
/// A gain is refused when it misses its poles by more than this, as [`meets`] measures it.
const MET: f64 = 1e-6;

// ANCHOR: place
/// The gain K for which (I − KH)F has the eigenvalues `poles`, for a single output.
///
/// # Errors
/// [`Code::Poles`] when the poles are not n numbers closed under conjugation; [`Code::Unobservable`] when (F, H) is not
/// observable; [`Code::NotPlaceable`] when it is but F is singular, so that one eigenvalue is 0 whatever K is, and 0 is
/// not among the poles, or when F is so nearly singular that the poles are missed; [`Code::NotFinite`] for a pole that
/// is not, or with [`Code::DidNotConverge`] where the numbers are too large for either to be told.
///
/// # Example
/// ```
/// use estimate::{Complex, place_observer_gain};
/// use nalgebra::{Matrix2, RowVector2};
/// let (f, h) = (Matrix2::new(1.0, 0.5, 0.0, 1.0), RowVector2::new(1.0, 0.0));
/// let k = place_observer_gain(&f, &h, &[Complex::from(0.5), Complex::from(0.2)])?;
/// assert!((k[0] - 0.9).abs() < 1e-15 && (k[1] - 0.8).abs() < 1e-15);
/// # Ok::<(), estimate::Error>(())
/// ```
pub fn place_observer_gain<const N: usize>(
    f: &SMatrix<f64, N, N>,
    h: &SMatrix<f64, 1, N>,
    poles: &[Complex<f64>],
) -> Result<SVector<f64, N>, Error> {
    let f = DMatrix::from_iterator(N, N, f.iter().copied());
    let h = DMatrix::from_iterator(1, N, h.iter().copied());
    Ok(SVector::from_iterator(place(&f, &h, poles)?.iter().copied()))
}
// ANCHOR_END: place

/// [`place_observer_gain`] for run-time sizes: `f` n×n and `h` 1×n, finite. K is n×1.
///
/// # Errors
/// As there.
pub(crate) fn place(f: &DMatrix<f64>, h: &DMatrix<f64>, poles: &[Complex<f64>]) -> Result<DMatrix<f64>, Error> {
    let n = f.nrows();
    let factors = real_factors(poles, n)?;
    let seen = analyze(&observability_matrix(f, h), RANK_TOLERANCE)?;
    if seen.rank < n {
        let rank = seen.rank;
        let message =
            format!("(F, H) has observability rank {rank} of {n}: no gain moves the eigenvalues of the unseen part");
        return Err(Error::new(Code::Unobservable, "H", message));
    }
    let hf = h * f;
    let reached = analyze(&observability_matrix(f, &hf), RANK_TOLERANCE)?;
    let k = if reached.rank == n { ackermann(f, &hf, &factors) } else { beside_zeros(f, h, &factors)? };
    let k = validate::matrix(k.ok_or_else(not_placeable)?, (n, 1), "poles")?;
    if meets(&(f - &k * hf), &factors, MET) { Ok(k) } else { Err(not_placeable()) }
}

fn not_placeable() -> Error {
    let message = "is singular, or nearly: an eigenvalue of (I − KH)F stays at 0 whatever K is, and no gain was found \
        for these \
                   poles";
    Error::new(Code::NotPlaceable, "F", message)
}

/// Whether `closed` has the roots of `factors`, up to this `part` of its size. By Cayley and Hamilton the polynomial
/// with these roots vanishes at it, and at no matrix with other roots.
fn meets(closed: &DMatrix<f64>, factors: &[Factor], part: f64) -> bool {
    let size: f64 = factors.iter().map(|factor| factor.size(closed.norm())).product();
    evaluate(factors, closed).norm() <= part * size
}

/// The k for which f − k·c has the roots of `factors`, for a single row c; `None` when (f, c) is not observable.
fn ackermann(f: &DMatrix<f64>, c: &DMatrix<f64>, factors: &[Factor]) -> Option<DMatrix<f64>> {
    let n = f.nrows();
    let last = DVector::from_fn(n, |i, _| if i + 1 == n { 1.0 } else { 0.0 });
    let k = evaluate(factors, f) * observability_matrix(f, c).lu().solve(&last)?;
    Some(DMatrix::from_column_slice(n, 1, k.as_slice()))
}

/// The gain of a system whose eigenvalue 0 no gain moves, as often as F has it: `None` when 0 is not as often among the
/// poles.
fn beside_zeros(f: &DMatrix<f64>, h: &DMatrix<f64>, factors: &[Factor]) -> Result<Option<DMatrix<f64>>, Error> {
    let movable = Movable::new(f, h, RANK_TOLERANCE)?;
    let mut others = factors.to_vec();
    for _ in movable.count()..f.nrows() {
        let Some(zero) = others.iter().position(|factor| *factor == Factor::Real(0.0)) else { return Ok(None) };
        others.remove(zero);
    }
    Ok(movable.solve(&others))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observer::error_matrix;
    use nalgebra::{Matrix2, RowVector2, dmatrix};
    use numerics::eigenvalues;

    fn code(f: DMatrix<f64>, h: DMatrix<f64>, poles: &[Complex<f64>]) -> Code {
        place(&f, &h, poles).expect_err("refused").code
    }

    fn real(poles: &[f64]) -> Vec<Complex<f64>> {
        poles.iter().map(|p| Complex::from(*p)).collect()
    }

    #[test]
    fn placed_poles_are_met_also_in_conjugate_pairs() {
        let f = dmatrix![1.0, 0.1, 0.005; 0.0, 1.0, 0.1; 0.0, 0.0, 1.0];
        let h = dmatrix![1.0, 0.0, 0.0];
        let poles = [Complex::new(0.6, 0.3), Complex::new(0.6, -0.3), Complex::new(-0.1, 0.0)];
        let k = place(&f, &h, &poles).expect("observable");
        let found = eigenvalues(&error_matrix(&f, &h, &k)).expect("found");
        for (found, pole) in found.iter().zip(poles) {
            assert!((found - pole).l1_norm() < 1e-11, "{found} against {pole}");
        }
    }

    #[test]
    fn a_deadbeat_observer_can_be_placed() {
        let (f, h) = (Matrix2::new(1.0, 0.5, 0.0, 1.0), RowVector2::new(1.0, 0.0));
        let k = place_observer_gain(&f, &h, &real(&[0.0, 0.0])).expect("observable");
        let m = error_matrix(&f, &h, &k);
        assert!((m * m).norm() < 1e-15);
    }

    #[test]
    fn an_unobservable_pair_is_named_so() {
        assert_eq!(code(dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.0, 1.0], &real(&[0.5, 0.2])), Code::Unobservable);
    }

    #[test]
    fn beside_the_zero_of_a_singular_f_the_other_poles_are_met() {
        let k = place(&dmatrix![0.0, 1.0; 0.0, 0.0], &dmatrix![1.0, 0.0], &real(&[0.0, 0.3])).expect("0 is among them");
        assert!((k - dmatrix![0.0; -0.3]).amax() < 1e-15);
        assert_eq!(place(&dmatrix![0.0], &dmatrix![2.0], &real(&[0.0])), Ok(DMatrix::zeros(1, 1)));

        let f = dmatrix![0.5, 1.0, -0.2; 1.0, 2.0, -0.4; 0.3, -0.7, 0.9];
        let h = dmatrix![1.0, 0.4, 0.2];
        let poles = [Complex::new(0.4, 0.3), Complex::new(0.4, -0.3), Complex::from(0.0)];
        let k = place(&f, &h, &poles).expect("0 is among them");
        let found = eigenvalues(&error_matrix(&f, &h, &k)).expect("found");
        for (found, pole) in found.iter().zip(poles) {
            assert!((found - pole).l1_norm() < 1e-13, "{found} against {pole}");
        }
        assert_eq!(code(f, h, &real(&[0.5, 0.2, 0.1])), Code::NotPlaceable);
    }

    #[test]
    fn an_observable_pair_with_a_singular_f_is_not_placeable_without_its_zero() {
        assert_eq!(code(dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![1.0, 0.0], &real(&[0.5, 0.2])), Code::NotPlaceable);
    }

    #[test]
    fn poles_must_be_n_finite_and_conjugate() {
        let (f, h) = (dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![1.0, 0.0]);
        assert_eq!(code(f.clone(), h.clone(), &real(&[0.5])), Code::Poles);
        for pole in [f64::NAN, f64::INFINITY] {
            assert_eq!(code(f.clone(), h.clone(), &real(&[0.5, pole])), Code::NotFinite);
        }
        assert_eq!(code(f.clone(), h.clone(), &[Complex::new(0.5, 0.1), Complex::new(0.5, 0.1)]), Code::Poles);
        assert_eq!(code(f.clone(), h.clone(), &[Complex::new(0.5, -0.1), Complex::from(0.5)]), Code::Poles);
        assert_eq!(code(f, h, &[Complex::new(0.5, 0.1), Complex::new(0.4, -0.1)]), Code::Poles);
    }

    #[test]
    fn overflowing_poles_are_refused() {
        let (f, h) = (dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![1.0, 0.0]);
        assert_eq!(code(f, h, &real(&[1e200, 1e200])), Code::NotFinite);
    }
}
