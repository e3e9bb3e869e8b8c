//! A log of a linear system, filtered in one call: for sizes known at run time, and at the pace of typed code for the
//! chapter's own.

use super::{Belief, System, kalman_step};
use crate::error::{Code, Error};
use filters::linear::{self, Correction};
use nalgebra::allocator::Allocator;
use nalgebra::{Const, DMatrix, DVector, DefaultAllocator, Dim, Dyn, OMatrix, OVector, U1};

/// The most steps of a log of a linear system.
pub const MAX_LOG: usize = 100_000;

/// What a filtered log answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Replayed {
    /// x̂(k | k) after each step, steps × n, row by row.
    pub x: Vec<f64>,
    /// The diagonal of P(k | k), in the same order.
    pub variances: Vec<f64>,
    /// P(k | k) after the last step, n×n.
    pub p: DMatrix<f64>,
}

/// One [`kalman_step`](super::kalman_step) for each row of `readings` (steps × p, row by row), with the row of `inputs`
/// (steps × m) beside it.
///
/// # Errors
/// Those of the step, saying at which, with `inputs` for u and `readings` for y; [`Code::Shape`] when the rows do not
/// fit the system or each other, [`Code::NotFinite`] naming the number, [`Code::Limit`] for no step or more than
/// [`MAX_LOG`].
pub fn kalman_replay(system: &System, belief: &Belief, inputs: &[f64], readings: &[f64]) -> Result<Replayed, Error> {
    let (n, m, p) = (system.f.nrows(), system.g.ncols(), system.h.nrows());
    system.fits(belief)?;
    let steps = readings.len() / p;
    if !(1..=MAX_LOG).contains(&steps) && readings.len().is_multiple_of(p) {
        let message = format!("holds {steps} steps; a log has at least 1 and at most {MAX_LOG}");
        return Err(Error::new(Code::Limit, "readings", message));
    }
    rows(readings, (steps, p), "readings")?;
    rows(inputs, (steps, m), "inputs")?;
    let log = Log { inputs, readings, steps };
    match (n, m, p) {
        (2, 1, 1) => Filter::new(system, belief, (Const::<2>, Const::<1>, Const::<1>)).run(system, &log),
        _ => Filter::new(system, belief, (Dyn(n), Dyn(m), Dyn(p))).run(system, &log),
    }
}

/// # Errors
/// [`Code::Shape`] unless `numbers` are so many rows of so many, [`Code::NotFinite`] naming the first that is not.
fn rows(numbers: &[f64], (steps, each): (usize, usize), name: &str) -> Result<(), Error> {
    if numbers.len() != steps * each {
        let message = match numbers.len().checked_rem(each) {
            Some(0) => format!("has {} rows of {each}; the readings are of {steps} steps", numbers.len() / each),
            Some(_) => format!("has {} numbers, which are no whole number of rows of {each}", numbers.len()),
            None => format!("has {} numbers; the system has no input", numbers.len()),
        };
        return Err(Error::new(Code::Shape, name.to_owned(), message));
    }
    match numbers.iter().position(|number| !number.is_finite()) {
        Some(i) => Err(Error::new(Code::NotFinite, format!("{name}[{i}]"), "must be a finite number")),
        None => Ok(()),
    }
}

struct Log<'a> {
    inputs: &'a [f64],
    readings: &'a [f64],
    steps: usize,
}

/// A system and a belief, sized alike.
struct Filter<N: Dim, U: Dim, M: Dim>
where
    DefaultAllocator: Allocator<N> + Allocator<N, N> + Allocator<N, U> + Allocator<M, N> + Allocator<M, M>,
{
    f: OMatrix<f64, N, N>,
    g: OMatrix<f64, N, U>,
    h: OMatrix<f64, M, N>,
    v: OMatrix<f64, N, N>,
    w: OMatrix<f64, M, M>,
    x: OVector<f64, N>,
    p: OMatrix<f64, N, N>,
    sizes: (N, U, M),
}

impl<N: Dim, U: Dim, M: Dim> Filter<N, U, M>
where
    DefaultAllocator: Allocator<N>
        + Allocator<U>
        + Allocator<M>
        + Allocator<N, N>
        + Allocator<N, U>
        + Allocator<M, N>
        + Allocator<N, M>
        + Allocator<M, M>,
{
    fn new(system: &System, belief: &Belief, (n, m, p): (N, U, M)) -> Self {
        Self {
            f: sized(n, n, system.f.as_slice()),
            g: sized(n, m, system.g.as_slice()),
            h: sized(p, n, system.h.as_slice()),
            v: sized(n, n, system.v.as_slice()),
            w: sized(p, p, system.w.as_slice()),
            x: sized(n, U1, belief.x.as_slice()),
            p: sized(n, n, belief.p.as_slice()),
            sizes: (n, m, p),
        }
    }

    fn run(mut self, system: &System, log: &Log<'_>) -> Result<Replayed, Error> {
        let (n, m, p) = (self.sizes.0.value(), self.sizes.1.value(), self.sizes.2.value());
        let (mut x, mut variances) = (Vec::with_capacity(log.steps * n), Vec::with_capacity(log.steps * n));
        for k in 0..log.steps {
            let (u, y) = (&log.inputs[k * m..(k + 1) * m], &log.readings[k * p..(k + 1) * p]);
            self.step(u, y).map_err(|e| self.refused(e, system, (u, y), k + 1))?;
            x.extend(self.x.iter());
            variances.extend((0..n).map(|i| self.p[(i, i)]));
        }
        let p = DMatrix::from_column_slice(n, n, self.p.as_slice());
        Ok(Replayed { x, variances, p })
    }

    /// Why a step was refused, in the words and with the culprit of [`kalman_step`].
    fn refused(&self, e: filters::Error, system: &System, (u, y): (&[f64], &[f64]), step: usize) -> Error {
        let x = DVector::from_column_slice(self.x.as_slice());
        let belief = Belief { p: DMatrix::from_column_slice(x.len(), x.len(), self.p.as_slice()), x };
        let (u, y) = (DVector::from_column_slice(u), DVector::from_column_slice(y));
        let mut e = kalman_step(system, &belief, u, y).err().unwrap_or_else(|| e.into());
        e = e.renamed("u", "inputs").renamed("y", "readings");
        e.message = format!("{}; at step {step}", e.message).into();
        e
    }

    fn step(&mut self, u: &[f64], y: &[f64]) -> Result<(), filters::Error> {
        let (_, m, p) = self.sizes;
        let push = &self.g * sized(m, U1, u);
        let x = linear::finite(&self.f * &self.x + push, "the predicted mean")?;
        let predicted = linear::predicted_covariance(&self.f, &self.p, &self.v)?;
        let Correction { x, p, .. } = linear::correct(&x, &predicted, &sized(p, U1, y), &self.h, &self.w)?;
        (self.x, self.p) = (x, p);
        Ok(())
    }
}

fn sized<R: Dim, C: Dim>(rows: R, columns: C, entries: &[f64]) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    OMatrix::from_iterator_generic(rows, columns, entries.iter().copied())
}
