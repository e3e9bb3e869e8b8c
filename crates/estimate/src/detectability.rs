//! What the outputs see, and whether what they do not see dies out by itself: observability and detectability (Anderson
//! and Moore, Optimal Filtering, appendix C).
//!
//! The tolerance says how well the numbers of a system are known. A verdict is given twice, with what is smaller than
//! the tolerance counted and not counted; where the two differ, the verdict is that the tolerance does not decide.

use crate::balance::{Balanced, balanced};
use crate::by_entry::is_observable;
use crate::decay::{decays, rounding};
use crate::error::{Code, Error};
use crate::nearest_unobservable::Pair;
use crate::staircase::Staircase;
use crate::validate;
use crate::verdict::Verdict;
use alloc::vec;
use alloc::vec::Vec;
use filters::covariance::is_finite;
use nalgebra::{Complex, DMatrix, DVector};
use numerics::eigenvalues;
use numerics::sqrt;

/// What a pair (F, C) of dynamics and outputs lets an observer know.
#[derive(Clone, Debug, PartialEq)]
pub struct Detectability {
    /// Whether every direction of the state is seen.
    pub observable: Verdict,
    /// Whether every direction that is not seen dies out by itself.
    pub detectable: Verdict,
    /// An orthonormal basis of the directions that count as unseen: those that the outputs see less of than the
    /// tolerance.
    pub unseen: Vec<DVector<f64>>,
    /// The eigenvalues of F along them, by decreasing modulus. No gain moves them.
    pub modes: Vec<Complex<f64>>,
    /// Whether every pair whose entries are these to within the tolerance, each as a part of itself, is observable. If
    /// directions count as unseen nevertheless, it is because these entries are small beside others.
    pub by_entry: bool,
}

/// Whether (`f`, `c`), n×n and p×n and finite, is observable, and whether it is detectable: each state and each output
/// is given a unit that fits it, so that the caller need not choose fitting units. If the staircase sees more in the
/// caller's units, the answer is taken in these.
///
/// An eigenvalue of an unseen direction decays when its modulus is below 1 − `tolerance`.
///
/// # Errors
/// [`Code::Tolerance`]; [`Code::DidNotConverge`] or [`Code::NotFinite`] blaming F.
pub(crate) fn detectability(f: &DMatrix<f64>, c: &DMatrix<f64>, tolerance: f64) -> Result<Detectability, Error> {
    blurred(f, c, 0.0, tolerance)
}

/// The same of a `c` that was computed: each entry may be off by `blur` of the largest in its column.
///
/// # Errors
/// As [`detectability`].
pub(crate) fn blurred(f: &DMatrix<f64>, c: &DMatrix<f64>, blur: f64, tolerance: f64) -> Result<Detectability, Error> {
    let tolerance = validate::tolerance(tolerance, "tolerance")?;
    let (n, noise) = (f.nrows(), rounding(f.nrows()));
    let given = balanced(f, c);
    if !is_finite(&given.f) || !is_finite(&given.c) {
        return Err(Error::new(Code::NotFinite, "F", "its numbers are too large or too small to be compared"));
    }
    let mut units = given.units.clone();
    let mut at_tolerance = Staircase::new(&given.f, &given.c, tolerance.max(noise))?;
    let callers = Balanced::given(f, c);
    // Numbers too large for the caller's units say nothing against the others.
    if let Ok(form) = Staircase::new(&callers.f, &callers.c, tolerance.max(noise))
        && form.seen > at_tolerance.seen
    {
        (at_tolerance, units) = (form, callers.units.clone());
    }
    let mut forms = vec![Staircase::new(&given.f, &given.c, noise)?];
    if let Some(rounded) = without_rounding(f) {
        let Balanced { f, c, .. } = balanced(&rounded, c);
        forms.push(Staircase::new(&f, &c, noise)?);
    }
    forms.push(at_tolerance.clone());
    let decaying = |form: &Staircase| decays(&form.unseen_block(), tolerance);
    let mut verdicts: Vec<Verdict> = forms.iter().map(decaying).collect::<Result<_, _>>()?;
    let mut all_seen: Vec<Verdict> = forms.iter().map(|form| Verdict::from(form.seen == n)).collect();
    // The size of a matrix says nothing of its zeros: what these let see is never said to be unseen.
    if is_observable(f, c, noise, blur) {
        verdicts.push(Verdict::Yes);
        all_seen.push(Verdict::Yes);
    }
    let off = DMatrix::from_fn(c.nrows(), n, |_, j| blur * c.column(j).amax());
    let (mut observable, mut detectable) = (Verdict::of_all(all_seen), Verdict::of_all(verdicts));
    if at_tolerance.seen == n {
        let pairs = [&callers, &given].map(|units| Pair::new(&units.f, &units.c, &units.of_outputs(&off)));
        // An entry that may be a zero is no larger than rounding in the caller's units only.
        let sure = if forms.len() > 2 { 1 } else { 2 };
        (observable, detectable) = by_distance((observable, detectable), &pairs, sure, tolerance.max(noise));
    }
    Ok(Detectability {
        observable,
        detectable,
        unseen: unseen(&at_tolerance, &units),
        modes: eigenvalues(&at_tolerance.unseen_block()).map_err(|e| Error::of_matrix(e, "F"))?,
        by_entry: is_observable(f, c, tolerance.max(noise), blur),
    })
}

/// The verdicts, observable and detectable, of a pair of which the staircase sees all within the tolerance, in the
/// caller's units and in others. What is open is decided where one of the first `sure` is farther than the tolerance
/// from every pair that is not observable. What is decided is open where both are nearer to one.
fn by_distance(
    (observable, detectable): (Verdict, Verdict),
    pairs: &[Option<Pair>; 2],
    sure: usize,
    tolerance: f64,
) -> (Verdict, Verdict) {
    use Verdict::{Undecided, Yes};
    if observable == Undecided || detectable == Undecided {
        let far = pairs.iter().take(sure).flatten().any(|pair| pair.is_observable_within(tolerance));
        return if far { (Yes, Yes) } else { (observable, detectable) };
    }
    let [one, other] = pairs.each_ref().map(|pair| pair.as_ref().and_then(|pair| pair.hidden_within(tolerance)));
    match (one, other) {
        (Some(one), Some(other)) if one.min(other) >= 1.0 - tolerance => (Undecided, Undecided),
        (Some(_), Some(_)) => (Undecided, detectable),
        _ => (observable, detectable),
    }
}

/// F with zeros where its numbers are no larger than the rounding of those beside them; `None` where there is no such
/// number.
fn without_rounding(f: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let doubtful = |i: usize, j: usize| {
        let beside = sqrt(f.row(i).amax()) * sqrt(f.column(j).amax());
        f[(i, j)] != 0.0 && f[(i, j)].abs() <= 4.0 * f64::EPSILON * beside
    };
    let rounded = DMatrix::from_fn(f.nrows(), f.ncols(), |i, j| if doubtful(i, j) { 0.0 } else { f[(i, j)] });
    (rounded != *f).then_some(rounded)
}

/// An orthonormal basis of the unseen directions, in the caller's units.
fn unseen(form: &Staircase, units: &DVector<f64>) -> Vec<DVector<f64>> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    for direction in form.basis.columns(form.seen, form.basis.ncols() - form.seen).column_iter() {
        let given = direction.component_mul(units);
        let across = basis.iter().fold(&given / given.amax(), |rest, known| &rest - known * known.dot(&rest));
        let length = across.norm();
        basis.push(across / length);
    }
    basis
}

#[cfg(test)]
mod tests;
