//! What a sensor of a time line reads of a state: y = H x, or y = h(x) of a caller's own.

use super::sensor::Judged;
use crate::dynamic::Belief;
use crate::dynamic::own::{Linearized, OwnReading, indices};
use crate::dynamic::partial::rows_there;
use crate::error::{Argument, Error};
use crate::validate::{self, MAX_OUTPUTS, size};
use alloc::rc::Rc;
use alloc::vec::Vec;
use core::fmt;
use filters::Update;
use nalgebra::{DMatrix, DVector, Dyn};

/// What a sensor reads of a state, with p outputs.
pub trait Output: Sized {
    /// Why a reading could not be compared with what was expected.
    type Fault: From<Error>;

    /// p.
    fn outputs(&self) -> usize;

    /// The output of a system of n states.
    ///
    /// # Errors
    /// Naming H or angles.
    fn checked(self, n: usize) -> Result<Self, Error>;

    /// The belief after the reading `y` of noise covariance W, and how that compares with what was expected.
    ///
    /// # Errors
    /// Those of a correction, and of a caller's function.
    fn corrected(&self, belief: &Belief, y: &[Option<f64>], w: &DMatrix<f64>) -> Result<(Belief, Judged), Self::Fault>;
}

/// y = H x, with H p×n.
impl Output for DMatrix<f64> {
    type Fault = Error;

    fn outputs(&self) -> usize {
        self.nrows()
    }

    fn checked(self, n: usize) -> Result<Self, Error> {
        let p = self.nrows();
        size(p, MAX_OUTPUTS, "H")?;
        validate::matrix(self, (p, n), "H")
    }

    fn corrected(&self, belief: &Belief, y: &[Option<f64>], w: &DMatrix<f64>) -> Result<(Belief, Judged), Error> {
        let (h, w) = rows_there(self, w, y);
        let there = DVector::from_vec(y.iter().flatten().copied().collect());
        let (corrected, update) = belief.corrected(&there, &h, &w).map_err(named)?;
        Ok((corrected, judged(update)))
    }
}

/// A function of a caller's own on the numbers of a state, which answers the same whenever it is asked the same: what
/// comes late has it asked again.
pub type Map<T, E> = Rc<dyn Fn(&[f64]) -> Result<T, E>>;

/// y = h(x), a caller's own. It is linearized at the state that is expected when the reading was measured.
pub struct OwnOutput<E> {
    /// p.
    pub outputs: usize,
    /// h, which answers p numbers.
    pub h: Map<Vec<f64>, E>,
    /// H = ∂h/∂x at x, p×n; by central differences where it is left out.
    pub jacobian: Option<Map<DMatrix<f64>, E>>,
    /// The components of y that are angles, whose differences are taken the short way round.
    pub angles: Vec<usize>,
}

impl<E> Clone for OwnOutput<E> {
    fn clone(&self) -> Self {
        let Self { outputs, h, jacobian, angles } = self;
        Self { outputs: *outputs, h: h.clone(), jacobian: jacobian.clone(), angles: angles.clone() }
    }
}

impl<E> fmt::Debug for OwnOutput<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { outputs, angles, .. } = self;
        f.debug_struct("OwnOutput").field("outputs", outputs).field("angles", angles).finish_non_exhaustive()
    }
}

impl<E: From<Error>> Output for OwnOutput<E> {
    type Fault = E;

    fn outputs(&self) -> usize {
        self.outputs
    }

    fn checked(self, _: usize) -> Result<Self, Error> {
        size(self.outputs, MAX_OUTPUTS, "W")?;
        indices(&self.angles, self.outputs)?;
        Ok(self)
    }

    fn corrected(&self, belief: &Belief, y: &[Option<f64>], w: &DMatrix<f64>) -> Result<(Belief, Judged), E> {
        let reading = OwnReading { y, w: w.clone(), angles: &self.angles, gate: None };
        let mut h = |x: &[f64]| (self.h)(x);
        let Linearized { innovation, h, w } = match &self.jacobian {
            Some(jacobian) => reading.linearized(&belief.x, &mut h, Some(&mut |x| jacobian(x)))?,
            None => reading.linearized(&belief.x, &mut h, None)?,
        };
        // What is corrected is the estimate's error, whose mean is zero.
        let error = Belief { x: DVector::zeros(belief.x.len()), p: belief.p.clone() };
        let (Belief { x: error, p }, update) = error.corrected(&innovation, &h, &w).map_err(named)?;
        let x = &belief.x + error;
        validate::entries(x.as_slice(), x.len(), "x")?;
        Ok((Belief { x, p }, judged(update)))
    }
}

/// The one or the other: the sensors of one time line may differ.
#[derive(Debug)]
pub enum AnyOutput<E> {
    /// y = H x.
    Linear(DMatrix<f64>),
    /// y = h(x).
    Own(OwnOutput<E>),
}

impl<E: From<Error>> Output for AnyOutput<E> {
    type Fault = E;

    fn outputs(&self) -> usize {
        match self {
            Self::Linear(h) => h.outputs(),
            Self::Own(h) => h.outputs(),
        }
    }

    fn checked(self, n: usize) -> Result<Self, Error> {
        Ok(match self {
            Self::Linear(h) => Self::Linear(h.checked(n)?),
            Self::Own(h) => Self::Own(h.checked(n)?),
        })
    }

    fn corrected(&self, belief: &Belief, y: &[Option<f64>], w: &DMatrix<f64>) -> Result<(Belief, Judged), E> {
        match self {
            Self::Linear(h) => Ok(h.corrected(belief, y, w)?),
            Self::Own(h) => h.corrected(belief, y, w),
        }
    }
}

fn judged(update: Update<Dyn, Dyn>) -> Judged {
    Judged { innovation: update.innovation, s: update.s, chi2: update.d2 }
}

#[cold]
fn named(error: filters::Error) -> Error {
    Error::from(error).called(Argument::letter)
}
