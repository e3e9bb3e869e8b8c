//! The part of an observer's error that a gain can move: what (F, HF) sees. The rest keeps its eigenvalues: those of
//! what H never sees, and a zero for each direction that F forgets.

use super::factor::{Factor, real_factors};
use super::{MET, ackermann, meets, not_placeable, several};
use crate::balance::balanced;
use crate::error::Error;
use crate::staircase::Staircase;
use crate::validate;
use alloc::vec::Vec;
use nalgebra::{Complex, DMatrix, DVector};
use numerics::eigenvalues;

/// What a gain can do to the eigenvalues of (I − KH)F = F − K·HF.
///
/// # Example
/// ```
/// use estimate::{Complex, Movable};
/// use nalgebra::dmatrix;
/// // The rail robot with a velocity sensor: the eigenvalue of the position stays at 1.
/// let movable = Movable::new(&dmatrix![1.0, 0.5; 0.0, 1.0], &dmatrix![0.0, 1.0], 1e-9)?;
/// assert_eq!((movable.count(), movable.fixed()?), (1, vec![Complex::from(1.0)]));
/// let k = movable.gain(&[Complex::from(0.2)])?;
/// assert!((k[1] - 0.8).abs() < 1e-15);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Movable {
    form: Staircase,
    /// HF in the staircase's coordinates, its columns of what is seen.
    outputs: DMatrix<f64>,
    /// The units of the states and of the outputs in which the staircase was found.
    units: [DVector<f64>; 2],
}

impl Movable {
    /// The movable part of a system with F n×n and H p×n, both finite. What is smaller than `tolerance`, as a part of
    /// the matrix that it comes from, counts as zero.
    ///
    /// # Errors
    /// [`Code::Tolerance`](crate::Code::Tolerance); [`Code::DidNotConverge`](crate::Code::DidNotConverge) or
    /// [`Code::NotFinite`](crate::Code::NotFinite) blaming F.
    pub fn new(f: &DMatrix<f64>, h: &DMatrix<f64>, tolerance: f64) -> Result<Self, Error> {
        let tolerance = validate::tolerance(tolerance, "tolerance")?;
        let even = balanced(f, &(h * f));
        let form = Staircase::new(&even.f, &even.c, tolerance.max(f64::EPSILON))?;
        let outputs = &even.c * form.basis.columns(0, form.seen);
        Ok(Self { form, outputs, units: [even.units, even.outputs] })
    }

    /// How many eigenvalues a gain moves.
    pub fn count(&self) -> usize {
        self.form.seen
    }

    /// The eigenvalues that no gain moves, by decreasing modulus.
    ///
    /// # Errors
    /// As [`eigenvalues`], blaming F.
    pub fn fixed(&self) -> Result<Vec<Complex<f64>>, Error> {
        eigenvalues(&self.form.unseen_block()).map_err(|e| Error::of_matrix(e, "F"))
    }

    /// The gain, n×p, that moves the movable eigenvalues to `poles`, as many as there are.
    ///
    /// # Errors
    /// [`Code::Poles`](crate::Code::Poles) or [`Code::NotFinite`](crate::Code::NotFinite) for the poles;
    /// [`Code::NotPlaceable`](crate::Code::NotPlaceable) when no gain was found that puts them there.
    pub fn gain(&self, poles: &[Complex<f64>]) -> Result<DMatrix<f64>, Error> {
        let factors = real_factors(poles, self.count())?;
        let k = self.solve(&factors).ok_or_else(not_placeable)?;
        let shape = k.shape();
        validate::matrix(k, shape, "poles")
    }

    pub(super) fn solve(&self, factors: &[Factor]) -> Option<DMatrix<f64>> {
        let [states, outputs] = &self.units;
        if factors.is_empty() {
            return Some(DMatrix::zeros(states.len(), outputs.len()));
        }
        let (f, c) = (self.form.seen_block(), &self.outputs);
        let k = if c.nrows() == 1 { ackermann(&f, c, factors) } else { several::gain(&f, c, factors) }?;
        if !meets(&(f - &k * c), factors, MET) {
            return None;
        }
        let mut k = self.form.basis.columns(0, self.form.seen) * k;
        for (mut row, unit) in k.row_iter_mut().zip(states.iter()) {
            row *= *unit;
        }
        for (mut column, unit) in k.column_iter_mut().zip(outputs.iter()) {
            column *= *unit;
        }
        Some(k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Code;
    use crate::observer::error_matrix;
    use nalgebra::dmatrix;

    fn real(poles: &[f64]) -> Vec<Complex<f64>> {
        poles.iter().map(|p| Complex::from(*p)).collect()
    }

    /// The gain moves what it can to `poles`, the rest is as `fixed` says.
    fn check(f: &DMatrix<f64>, h: &DMatrix<f64>, poles: &[Complex<f64>]) {
        let movable = Movable::new(f, h, 1e-9).expect("found");
        let k = movable.gain(poles).expect("placed");
        let found = eigenvalues(&error_matrix(f, h, &k)).expect("found");
        for pole in poles.iter().chain(&movable.fixed().expect("found")) {
            let nearest = found.iter().map(|l| (l - pole).l1_norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-7, "{pole} among {found:?}");
        }
    }

    #[test]
    fn the_movable_eigenvalues_go_where_they_are_put() {
        let cv = dmatrix![1.0, 0.5; 0.0, 1.0];
        check(&cv, &dmatrix![0.0, 1.0], &real(&[0.3]));
        check(&cv, &DMatrix::identity(2, 2), &real(&[0.5, 0.2]));
        check(&DMatrix::identity(3, 3), &DMatrix::identity(3, 3), &real(&[0.5, 0.2, 0.1]));
        check(&cv, &dmatrix![1.0, 0.0; 2.0, 0.0], &[Complex::new(0.3, 0.2), Complex::new(0.3, -0.2)]);
        check(&dmatrix![1.0, 1e6; 0.0, 1.0], &dmatrix![1e-3, 0.0], &real(&[0.5, 0.2]));
    }

    #[test]
    fn several_outputs_place_what_one_of_them_cannot() {
        // Two tanks that do not touch: neither output sees both.
        let f = dmatrix![0.9, 0.0, 0.0, 0.0; 0.1, 0.8, 0.0, 0.0; 0.0, 0.0, 0.9, 0.0; 0.0, 0.0, 0.1, 0.8];
        let h = dmatrix![0.0, 1.0, 0.0, 0.0; 0.0, 0.0, 0.0, 1.0];
        check(&f, &h, &real(&[0.1, 0.2, 0.3, 0.4]));
        check(&f, &h, &[Complex::new(0.4, 0.3), Complex::new(0.4, -0.3), Complex::from(0.1), Complex::from(0.2)]);
    }

    #[test]
    fn a_direction_that_f_forgets_has_the_eigenvalue_zero() {
        let shift = dmatrix![0.0, 0.0, 0.0; 1.0, 0.0, 0.0; 0.0, 1.0, 0.5];
        let movable = Movable::new(&shift, &dmatrix![0.0, 0.0, 1.0], 1e-9).expect("found");
        assert_eq!((movable.count(), movable.fixed().expect("found")), (2, real(&[0.0])));
        check(&shift, &dmatrix![0.0, 0.0, 1.0], &real(&[0.1, 0.2]));
        assert_eq!(movable.gain(&real(&[0.1])).expect_err("too few").code, Code::Poles);
    }

    #[test]
    fn where_nothing_is_seen_nothing_moves() {
        let movable = Movable::new(&DMatrix::identity(2, 2), &DMatrix::zeros(2, 2), 1e-9).expect("found");
        assert_eq!((movable.count(), movable.gain(&[]).expect("none")), (0, DMatrix::zeros(2, 2)));
    }
}
