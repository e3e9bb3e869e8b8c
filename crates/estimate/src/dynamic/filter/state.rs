//! A filter as plain numbers, to be kept and gone on with.

use super::{Belief, Code, Error, KalmanFilter, Kind, Last, System, belief_fits};
use crate::validate::{self, MAX_OUTPUTS};
use filters::{Bound, Conditioning, Sizes, Update};
use nalgebra::{DMatrix, DVector, DefaultAllocator, Dim};

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
    pub(super) fn of<N: Dim, M: Dim>(update: &Update<N, M>) -> Self
    where
        DefaultAllocator: Sizes<N, M>,
    {
        let (n, p) = update.k.shape();
        Self {
            innovation: DVector::from_column_slice(update.innovation.as_slice()),
            s: DMatrix::from_column_slice(p, p, update.s.as_slice()),
            r: DMatrix::from_column_slice(n, p, update.k.as_slice()),
            nis: update.d2,
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
        let (system, conditioning) = each!(&self.0, filter => {
            let (m, (p, n)) = (filter.system.g.ncols(), filter.system.h.shape());
            let of = DMatrix::from_column_slice;
            let system = System {
                f: of(n, n, filter.system.f.as_slice()),
                g: of(n, m, filter.system.g.as_slice()),
                h: of(p, n, filter.system.h.as_slice()),
                v: of(n, n, filter.system.v.as_slice()),
                w: of(p, p, filter.system.w.as_slice()),
            };
            (system, filter.belief.conditioning().clone())
        });
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
        let last = last.map(|last| checked(last, n)).transpose()?;
        let mut kind = Kind::new(&system, &belief);
        each!(&mut kind, filter => {
            filter.belief.judge_by(conditioning);
            filter.log_likelihood = log_likelihood;
            if let Some(last) = last {
                filter.last = Last::Partly(last);
            }
        });
        Ok(Self(kind))
    }
}

fn checked(last: LastReading, n: usize) -> Result<Update<nalgebra::Dyn, nalgebra::Dyn>, Error> {
    let p = last.innovation.len();
    if p == 0 || p > MAX_OUTPUTS {
        return Err(Error::new(Code::Shape, "innovation", "has as many entries as parts were read, from 1 to 8"));
    }
    validate::finite(last.nis.unwrap_or(0.0), "nis")?;
    Ok(Update {
        innovation: validate::vector(last.innovation, p, "innovation")?,
        s: validate::matrix(last.s, (p, p), "S")?,
        k: validate::matrix(last.r, (n, p), "R")?,
        d2: last.nis,
        doubted: false,
    })
}
