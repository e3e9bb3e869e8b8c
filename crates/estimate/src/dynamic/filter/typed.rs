//! A filter with matrices of given sizes.

use crate::dynamic::{Belief, System};
use crate::error::Error;
use crate::followed::Followed;
use crate::likelihood::log_density;
use crate::lti::{Lti, SystemSizes};
use crate::validate;
use alloc::vec::Vec;
use filters::{Conditioning, Gaussian, Update};
use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, Dyn, OMatrix, U1, VectorView};

/// What a filter of any sizes holds, as plain numbers: what is done once in a while is done through it, and compiled
/// once for all sizes.
pub struct Raw<'a> {
    pub x: &'a mut [f64],
    pub p: &'a mut [f64],
    pub conditioning: &'a mut Conditioning,
    pub log_likelihood: &'a mut Option<f64>,
}

/// What a reading has told, as plain numbers.
pub struct Told<'a> {
    pub innovation: &'a [f64],
    pub s: &'a [f64],
    pub k: &'a [f64],
    pub d2: Option<f64>,
}

/// The filter with matrices of the sizes N and M; how many inputs there are is known at run time only.
#[derive(Clone, Debug)]
pub struct Filter<N: Dim, M: Dim>
where
    DefaultAllocator: SystemSizes<N, Dyn, M>,
{
    pub system: Lti<N, Dyn, M>,
    pub belief: Followed<N>,
    pub log_likelihood: Option<f64>,
    /// What the last whole reading has told.
    pub last: Option<Update<N, M>>,
}

impl<N: Dim, M: Dim> Filter<N, M>
where
    DefaultAllocator: SystemSizes<N, Dyn, M>,
{
    /// `system` and `belief`, which are of the sizes (n, p).
    pub fn new(system: &System, belief: &Belief, (n, p): (N, M)) -> Self {
        let system = Lti {
            f: kept(n, n, system.f.as_slice()),
            g: kept(n, Dyn(system.g.ncols()), system.g.as_slice()),
            h: kept(p, n, system.h.as_slice()),
            v: kept(n, n, system.v.as_slice()),
            w: kept(p, p, system.w.as_slice()),
        };
        let belief = Gaussian { x: kept(n, U1, belief.x.as_slice()), p: kept(n, n, belief.p.as_slice()) };
        Self { system, belief: belief.into(), log_likelihood: Some(0.0), last: None }
    }

    // Where a binary is fetched, a half is one function, in a step too: in line it would be there twice.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    pub fn predict(&mut self, u: &[f64]) -> Result<(), Error> {
        let system = &self.system;
        let u = VectorView::from_slice_generic(u, system.g.shape_generic().1, U1);
        Ok(self.belief.predict(&system.f, &system.v, Some((&system.g, &u)))?)
    }

    #[cfg_attr(target_arch = "wasm32", inline(never))]
    pub fn update(&mut self, y: &[f64]) -> Result<(), Error> {
        let system = &self.system;
        let y = sized(system.h.shape_generic().0, U1, y);
        let update = self.belief.correct(&y, &system.h, &system.w)?;
        self.note(log_density(&update.innovation, &update.s));
        self.last = Some(update);
        Ok(())
    }

    pub fn raw(&mut self) -> Raw<'_> {
        let (x, p, conditioning) = self.belief.raw();
        Raw { x, p, conditioning, log_likelihood: &mut self.log_likelihood }
    }

    /// Innovation, S, gain and d² of the last whole reading.
    pub fn told(&self) -> Option<Told<'_>> {
        let last = self.last.as_ref()?;
        Some(Told { innovation: last.innovation.as_slice(), s: last.s.as_slice(), k: last.k.as_slice(), d2: last.d2 })
    }

    #[inline]
    pub fn step(&mut self, u: &[f64], y: &[f64]) -> Result<(), Error> {
        let before = self.belief.clone();
        self.predict(u)?;
        self.update(y).inspect_err(|_| self.belief = before)
    }

    pub fn replay(&mut self, inputs: &[f64], readings: &[f64]) -> Result<(Vec<f64>, Vec<f64>), (Error, usize)> {
        let (p, n) = self.system.h.shape_generic();
        let (n, m, p) = (n.value(), self.system.g.ncols(), p.value());
        let steps = readings.len() / p;
        let (mut x, mut variances) = (Vec::with_capacity(steps * n), Vec::with_capacity(steps * n));
        for k in 0..steps {
            let (u, y) = (&inputs[k * m..(k + 1) * m], &readings[k * p..(k + 1) * p]);
            self.predict(u).and_then(|()| self.update(y)).map_err(|e| (e, k + 1))?;
            x.extend(self.belief.x.iter());
            variances.extend((0..n).map(|i| self.belief.p[(i, i)]));
        }
        Ok((x, variances))
    }

    pub fn input(&self, u: &[f64]) -> Result<(), Error> {
        validate::entries(u, self.system.g.ncols(), "u")
    }

    pub fn reading(&self, y: &[f64]) -> Result<(), Error> {
        validate::entries(y, self.system.h.nrows(), "y")
    }

    /// The density of a reading.
    fn note(&mut self, density: Option<f64>) {
        self.log_likelihood = summed(self.log_likelihood, density, self.belief.conditioned());
    }
}

/// The likelihood with that of one more reading.
pub fn summed(sum: Option<f64>, density: Option<f64>, conditioned: bool) -> Option<f64> {
    sum.zip(density).map(|(sum, density)| sum + density).filter(|sum| sum.is_finite() && conditioned)
}

/// [`sized`] where it is called once for a filter, of which there are many sizes.
#[cfg_attr(target_arch = "wasm32", inline(never))]
fn kept<R: Dim, C: Dim>(rows: R, columns: C, entries: &[f64]) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    sized(rows, columns, entries)
}

pub fn sized<R: Dim, C: Dim>(rows: R, columns: C, entries: &[f64]) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    OMatrix::from_column_slice_generic(rows, columns, entries)
}
