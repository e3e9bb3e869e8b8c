//! Where the poles of an observer may go: Ackermann's formula on the pair (F, HF) (Theorem J.3.2, transposed).

use crate::error::{Code, Error};
use crate::observability::{analyze, observability_matrix};
use crate::validate;
use nalgebra::{Complex, DMatrix, DVector, SMatrix, SVector};
use std::borrow::Cow;

/// Singular values of Q or of [HF; …; HFⁿ] below this part of the largest count as zero.
const RANK_TOLERANCE: f64 = 1e-9;

// ANCHOR: place
/// The gain K for which (I − KH)F has the eigenvalues `poles`, for a single output.
///
/// # Errors
/// [`Code::Poles`] when the poles are not n numbers closed under conjugation; [`Code::Unobservable`] when (F, H) is not
/// observable; [`Code::NotPlaceable`] when it is but F is singular, so that one eigenvalue is 0 whatever K is, and 0 is not
/// among the poles, or when F is so nearly singular that the poles are missed; [`Code::NotFinite`] for a pole that is not, or
/// with [`Code::DidNotConverge`] where the numbers are too large for either to be told.
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

/// [`place_observer_gain`] for run-time sizes: `f` n×n and `h` 1×n, finite.
pub(crate) fn place(f: &DMatrix<f64>, h: &DMatrix<f64>, poles: &[Complex<f64>]) -> Result<DVector<f64>, Error> {
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
    let k =
        if reached.rank == n { ackermann(f, &hf, &factors) } else { beside_zero(f, &hf, &factors, &reached.nullspace) };
    let not_placeable = || {
        let message = "is singular, or nearly: an eigenvalue of (I − KH)F stays at 0 whatever K is, and Ackermann's formula \
                       has no answer for these poles";
        Error::new(Code::NotPlaceable, "F", message)
    };
    let k = validate::vector(k.ok_or_else(not_placeable)?, n, "poles")?;
    // By Cayley and Hamilton the polynomial with these roots vanishes at (I − KH)F, and at no matrix with other roots.
    let closed = f - &k * hf;
    let residual = evaluate(&factors, &closed).norm();
    let size: f64 = poles.iter().map(|p| closed.norm() + numerics::hypot(p.re, p.im)).product();
    if residual <= 1e-6 * size { Ok(k) } else { Err(not_placeable()) }
}

/// The k for which f − k·c has the roots of `factors`; `None` when (f, c) is not observable.
fn ackermann(f: &DMatrix<f64>, c: &DMatrix<f64>, factors: &[Factor]) -> Option<DVector<f64>> {
    let n = f.nrows();
    let last = DVector::from_fn(n, |i, _| if i + 1 == n { 1.0 } else { 0.0 });
    Some(evaluate(factors, f) * observability_matrix(f, c).lu().solve(&last)?)
}

/// [`ackermann`] where Fv = 0 for the one direction `v` that (F, HF) does not see: (I − KH)F keeps that eigenvalue 0, and
/// its others are those of what F does across v. `None` when 0 is not among the poles.
fn beside_zero(
    f: &DMatrix<f64>,
    hf: &DMatrix<f64>,
    factors: &[Factor],
    unseen: &[DVector<f64>],
) -> Option<DVector<f64>> {
    let [v] = unseen else { return None };
    let zero = factors.iter().position(|factor| matches!(factor, Factor::Real(root) if *root == 0.0))?;
    let mut others = factors.to_vec();
    others.remove(zero);
    let n = f.nrows();
    if n == 1 {
        return Some(DVector::zeros(1));
    }
    // The rows beside the first of the reflection that takes v to the first axis: an orthonormal basis across v.
    let turned = v + DVector::from_fn(n, |i, _| if i == 0 { libm::copysign(1.0, v[0]) } else { 0.0 });
    let mirror = DMatrix::identity(n, n) - &turned * turned.transpose() * (2.0 / turned.norm_squared());
    let across = mirror.columns(1, n - 1).into_owned();
    let k = ackermann(&(across.transpose() * f * &across), &(hf * &across), &others)?;
    Some(across * k)
}

/// A real polynomial in factors: λ − a, or λ² − bλ + c for a conjugate pair.
#[derive(Clone, Copy)]
enum Factor {
    Real(f64),
    Pair { sum: f64, product: f64 },
}

fn real_factors(poles: &[Complex<f64>], n: usize) -> Result<Vec<Factor>, Error> {
    let refuse = |message: Cow<'static, str>| Err(Error::new(Code::Poles, "poles", message));
    if poles.len() != n {
        return refuse(format!("are {}; a system of {n} states needs {n}", poles.len()).into());
    }
    if poles.iter().any(|p| !p.re.is_finite() || !p.im.is_finite()) {
        return Err(Error::new(Code::NotFinite, "poles", "hold a NaN or an infinity; every pole must be finite"));
    }
    let mut factors: Vec<Factor> = poles.iter().filter(|p| p.im == 0.0).map(|p| Factor::Real(p.re)).collect();
    let mut lower: Vec<&Complex<f64>> = poles.iter().filter(|p| p.im < 0.0).collect();
    for upper in poles.iter().filter(|p| p.im > 0.0) {
        let Some(at) = lower.iter().position(|l| l.re == upper.re && l.im == -upper.im) else {
            return refuse("hold a complex number without its conjugate".into());
        };
        lower.swap_remove(at);
        factors.push(Factor::Pair { sum: 2.0 * upper.re, product: upper.re * upper.re + upper.im * upper.im });
    }
    if lower.is_empty() { Ok(factors) } else { refuse("hold a complex number without its conjugate".into()) }
}

fn evaluate(factors: &[Factor], m: &DMatrix<f64>) -> DMatrix<f64> {
    let identity = DMatrix::identity(m.nrows(), m.ncols());
    factors.iter().fold(identity.clone(), |product, factor| match factor {
        Factor::Real(root) => product * (m - &identity * *root),
        Factor::Pair { sum, product: c } => product * (m * m - m * *sum + &identity * *c),
    })
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
        let k = DMatrix::from_column_slice(3, 1, k.as_slice());
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
        assert!((k - nalgebra::dvector![0.0, -0.3]).amax() < 1e-15);
        assert_eq!(place(&dmatrix![0.0], &dmatrix![2.0], &real(&[0.0])), Ok(DVector::zeros(1)));

        let f = dmatrix![0.5, 1.0, -0.2; 1.0, 2.0, -0.4; 0.3, -0.7, 0.9];
        let h = dmatrix![1.0, 0.4, 0.2];
        let poles = [Complex::new(0.4, 0.3), Complex::new(0.4, -0.3), Complex::from(0.0)];
        let k = place(&f, &h, &poles).expect("0 is among them");
        let found = eigenvalues(&error_matrix(&f, &h, &DMatrix::from_column_slice(3, 1, k.as_slice()))).expect("found");
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
