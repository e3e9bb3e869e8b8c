//! A filter as plain numbers, to be kept and gone on with.

use super::typed::Told;
use super::{Belief, Code, Error, KalmanFilter, Kind, Lately, System, belief_fits};
use crate::lti::Lti;
use crate::validate::{self, MAX_OUTPUTS};
use alloc::boxed::Box;
use filters::{Bound, Conditioning};
use nalgebra::{DMatrix, DVector};

/// What a reading has told.
#[derive(Clone, Debug, PartialEq)]
pub struct LastReading {
    /// ν = y − H x̂, of the parts that were read.
    pub innovation: DVector<f64>,
    /// S = H P Hᵀ + W.
    pub s: DMatrix<f64>,
    /// R = P Hᵀ S⁻¹, the gain.
    pub r: DMatrix<f64>,
    /// νᵀS⁻¹ν; nothing where S is singular to working accuracy.
    pub nis: Option<f64>,
}

impl LastReading {
    pub(super) fn of(told: &Told<'_>) -> Self {
        let p = told.innovation.len();
        Self {
            innovation: DVector::from_column_slice(told.innovation),
            s: DMatrix::from_column_slice(p, p, told.s),
            r: DMatrix::from_column_slice(told.k.len() / p, p, told.k),
            nis: told.d2,
        }
    }
}

/// All that a [`KalmanFilter`] holds. A filter made of it goes on to the last bit as the one it was taken of.
#[derive(Clone, Debug)]
pub struct FilterState {
    /// Its system.
    pub system: System,
    /// Its belief.
    pub belief: Belief,
    /// [`KalmanFilter::log_likelihood`].
    pub log_likelihood: Option<f64>,
    /// [`KalmanFilter::last`].
    pub last: Option<LastReading>,
    /// [`KalmanFilter::conditioned`], and what it is judged by from now on.
    pub conditioning: Conditioning,
}

impl KalmanFilter {
    /// What the filter holds.
    pub fn state(&self) -> FilterState {
        let (system, conditioning) = each!(&self.kind, filter => {
            let Lti { f, g, h, v, w } = &filter.system;
            let slices = [f.as_slice(), g.as_slice(), h.as_slice(), v.as_slice(), w.as_slice()];
            (slices, filter.belief.conditioning())
        });
        let (n, [f, g, h, v, w]) = (self.x().len(), system);
        let of = |rows: usize, numbers: &[f64]| DMatrix::from_column_slice(rows, numbers.len() / rows, numbers);
        let p = h.len() / n;
        let system = System { f: of(n, f), g: of(n, g), h: of(p, h), v: of(n, v), w: of(p, w) };
        let conditioning = conditioning.clone();
        let (belief, log_likelihood, last) = (self.belief(), self.log_likelihood(), self.last());
        FilterState { system, belief, log_likelihood, last, conditioning }
    }

    /// The filter that holds this.
    ///
    /// # Errors
    /// [`Code::Shape`] or [`Code::NotFinite`] naming belief, logLikelihood, innovation, S, R, nis or rounding.
    pub fn from_state(state: FilterState) -> Result<Self, Error> {
        let FilterState { system, belief, log_likelihood, last, conditioning } = state;
        let n = system.f.nrows();
        belief_fits(&belief, n)?;
        if let Bound::Carried(rounding) = conditioning.bound() {
            validate::matrix(rounding.clone(), (n, n), "rounding")?;
        }
        validate::finite(log_likelihood.unwrap_or(0.0), "logLikelihood")?;
        let lately = match last {
            Some(last) => Lately::Partly(Box::new(checked(last, n)?)),
            None => Lately::Nothing,
        };
        let mut kind = Kind::new(&system, &belief);
        let raw = each!(&mut kind, filter => filter.raw());
        (*raw.conditioning, *raw.log_likelihood) = (conditioning, log_likelihood);
        Ok(Self { kind, lately })
    }
}

fn checked(last: LastReading, n: usize) -> Result<LastReading, Error> {
    let p = last.innovation.len();
    if p == 0 || p > MAX_OUTPUTS {
        return Err(Error::new(Code::Shape, "innovation", "has as many entries as parts were read, from 1 to 8"));
    }
    validate::finite(last.nis.unwrap_or(0.0), "nis")?;
    Ok(LastReading {
        innovation: validate::vector(last.innovation, p, "innovation")?,
        s: validate::matrix(last.s, (p, p), "S")?,
        r: validate::matrix(last.r, (n, p), "R")?,
        nis: last.nis,
    })
}
