//! Filters of a caller's own models: a motion f and a reading h that are functions on lists of numbers.

mod extended;
mod function;
mod unscented;

pub use extended::ExtendedKalmanFilter;
pub use unscented::{SIGMA_POINTS, UnscentedKalmanFilter};

use super::partial::rows_there;
use super::{Belief, Judged};
use crate::error::{Argument, Code, Error};
use crate::validate::{self, MAX_OUTPUTS, size};
use alloc::string::ToString;
use alloc::vec::Vec;
use function::{Function, wrap_at};
use nalgebra::{DMatrix, DVector};

/// A function of a caller's, on the numbers of a state. It may fail in a way of its own, which comes through.
pub type Model<'a, E> = &'a mut dyn FnMut(&[f64]) -> Result<Vec<f64>, E>;
/// The Jacobian of a [`Model`], at the numbers of a state.
pub type Jacobian<'a, E> = &'a mut dyn FnMut(&[f64]) -> Result<DMatrix<f64>, E>;

/// A reading of one's own sensor: y = h(x) + w, Cov w = W.
#[derive(Clone, Debug)]
pub struct OwnReading<'a> {
    /// What was read, p numbers; a part that is missing is none.
    pub y: &'a [Option<f64>],
    /// W, p×p.
    pub w: DMatrix<f64>,
    /// The components of y that are angles, whose differences are taken the short way round.
    pub angles: &'a [usize],
    /// A reading whose χ² is greater is not used; none where every reading is.
    pub gate: Option<f64>,
}

/// What became of a reading.
#[derive(Clone, Debug, PartialEq)]
pub struct Gated {
    /// Whether it has corrected the belief.
    pub accepted: bool,
    /// How it compares with what was expected.
    pub judged: Judged,
}

impl OwnReading<'_> {
    /// The reading with its fields checked: the numbers that are there, their rows, and W whole.
    fn checked(&self) -> Result<Whole, Error> {
        let p = self.y.len();
        size(p, MAX_OUTPUTS, "y")?;
        let numbers: Vec<f64> = self.y.iter().map(|part| part.unwrap_or(0.0)).collect();
        validate::entries(&numbers, p, "y")?;
        if self.y.iter().all(Option::is_none) {
            return Err(Error::new(Code::Shape, "y", "has no part that was read"));
        }
        indices(self.angles, p)?;
        if let Some(gate) = self.gate
            && validate::finite(gate, "gate")? <= 0.0
        {
            return Err(Error::new(Code::Limit, "gate", "a gate on χ² is positive, or null"));
        }
        Ok(Whole { y: DVector::from_vec(numbers), w: validate::covariance(self.w.clone(), p, "W")? })
    }

    /// The innovation, the rows of H = ∂h/∂x at x (given, or by central differences) and W, of the parts that are
    /// there.
    ///
    /// # Errors
    /// What `h` answers; [`Error`] naming `h(x)`, `H(x)`, y, W, gate or angles.
    pub(super) fn linearized<E: From<Error>>(
        &self,
        x: &DVector<f64>,
        h: Model<'_, E>,
        jacobian: Option<Jacobian<'_, E>>,
    ) -> Result<Linearized, E> {
        let whole = self.checked()?;
        let outputs = self.y.len();
        let mut h = Function { model: h, name: "h(x)", len: outputs, angles: self.angles };
        let expected = h.at(x)?;
        let slope = match jacobian {
            Some(jacobian) => validate::matrix(jacobian(x.as_slice())?, (outputs, x.len()), "H(x)")?,
            None => h.differences(x)?,
        };
        let (h, w) = rows_there(&slope, &whole.w, self.y);
        Ok(Linearized { innovation: self.innovation(&whole.y, &expected), h, w })
    }

    fn accepts(&self, judged: &Judged) -> bool {
        self.gate.is_none_or(|gate| judged.chi2.is_some_and(|chi2| chi2 <= gate))
    }

    /// y − ŷ of the parts that are there, angles the short way round.
    fn innovation(&self, y: &DVector<f64>, expected: &DVector<f64>) -> DVector<f64> {
        let mut innovation = y - expected;
        wrap_at(self.angles, &mut innovation);
        self.there(&innovation)
    }

    fn there(&self, whole: &DVector<f64>) -> DVector<f64> {
        let there = whole.iter().zip(self.y).filter(|(_, part)| part.is_some());
        DVector::from_vec(there.map(|(number, _)| *number).collect())
    }
}

/// A reading beside what was expected, of the parts that are there.
pub(super) struct Linearized {
    pub innovation: DVector<f64>,
    pub h: DMatrix<f64>,
    pub w: DMatrix<f64>,
}

/// A reading with zeros for the parts that are missing.
struct Whole {
    y: DVector<f64>,
    w: DMatrix<f64>,
}

/// The belief and the indices of its angles, checked.
fn checked(belief: &Belief, angles: &[usize]) -> Result<(DVector<f64>, Vec<usize>), Error> {
    indices(angles, belief.x.len())?;
    let mut x = belief.x.clone();
    wrap_at(angles, &mut x);
    Ok((x, angles.to_vec()))
}

pub(super) fn indices(angles: &[usize], below: usize) -> Result<(), Error> {
    match angles.iter().position(|&angle| angle >= below) {
        None => Ok(()),
        Some(i) => {
            let at = ["angles[", &i.to_string(), "]"].concat();
            Err(Error::new(Code::Index, at, "is the index of no component; they count from 0"))
        }
    }
}

#[cold]
fn named(error: filters::Error) -> Error {
    Error::from(error).called(Argument::letter)
}
