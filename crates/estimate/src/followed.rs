//! A belief that is carried from step to step, with what rounding may have left in it.

use core::ops::Deref;
use filters::{Conditioning, Error, Gaussian, Sizes, Update};
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DVector, DefaultAllocator, Dim, Dyn, OMatrix, OVector, Storage, Vector};

/// A belief, followed since the filter began.
#[derive(Clone, Debug)]
pub(crate) struct Followed<N: Dim>
where
    DefaultAllocator: Sizes<N>,
{
    belief: Gaussian<N>,
    conditioning: Conditioning,
}

impl<N: Dim> From<Gaussian<N>> for Followed<N>
where
    DefaultAllocator: Sizes<N>,
{
    fn from(belief: Gaussian<N>) -> Self {
        Self { belief, conditioning: Conditioning::default() }
    }
}

impl<N: Dim> Deref for Followed<N>
where
    DefaultAllocator: Sizes<N>,
{
    type Target = Gaussian<N>;

    fn deref(&self) -> &Gaussian<N> {
        &self.belief
    }
}

impl<N: Dim> Followed<N>
where
    DefaultAllocator: Sizes<N>,
{
    /// Whether S and P have been right so far.
    pub fn conditioned(&self) -> bool {
        self.conditioning.is_well_conditioned()
    }

    /// What S and P are judged by.
    pub fn conditioning(&self) -> &Conditioning {
        &self.conditioning
    }

    /// [`Gaussian::predict`].
    #[inline(always)]
    pub fn predict<U: Dim, S: Storage<f64, U>>(
        &mut self,
        f: &OMatrix<f64, N, N>,
        v: &OMatrix<f64, N, N>,
        input: Option<(&OMatrix<f64, N, U>, &Vector<f64, U, S>)>,
    ) -> Result<(), Error>
    where
        DefaultAllocator: Allocator<N, U>,
    {
        let before = self.belief.p.clone();
        let regular = self.belief.predict(f, v, input)?;
        self.conditioning.predicted(f, &before, v, regular);
        Ok(())
    }

    /// [`Gaussian::correct`].
    #[inline(always)]
    pub fn correct<M: Dim>(
        &mut self,
        y: &OVector<f64, M>,
        h: &OMatrix<f64, M, N>,
        w: &OMatrix<f64, M, M>,
    ) -> Result<Update<N, M>, Error>
    where
        DefaultAllocator: Sizes<N, M>,
    {
        let before = self.belief.p.clone();
        let update = self.belief.correct(y, h, w)?;
        self.conditioning.corrected(&before, (h, w), &update, &self.belief);
        Ok(update)
    }

    /// Its numbers, and what they are judged by.
    pub fn raw(&mut self) -> (&mut [f64], &mut [f64], &mut Conditioning) {
        (self.belief.x.as_mut_slice(), self.belief.p.as_mut_slice(), &mut self.conditioning)
    }
}

/// [`Followed::predict`] of a belief whose size is known at run time only, given by its numbers.
pub(crate) fn predict(
    (x, p): (&mut [f64], &mut [f64]),
    conditioning: &mut Conditioning,
    (f, v): (&DMatrix<f64>, &DMatrix<f64>),
    input: Option<(&DMatrix<f64>, &DVector<f64>)>,
) -> Result<(), Error> {
    let mut belief = belief(x, p);
    let regular = belief.predict(f, v, input)?;
    conditioning.predicted(f, &DMatrix::from_column_slice(x.len(), x.len(), p), v, regular);
    x.copy_from_slice(belief.x.as_slice());
    p.copy_from_slice(belief.p.as_slice());
    Ok(())
}

/// [`Followed::correct`] of a belief whose size is known at run time only, given by its numbers.
pub(crate) fn correct(
    (x, p): (&mut [f64], &mut [f64]),
    conditioning: &mut Conditioning,
    y: &DVector<f64>,
    (h, w): (&DMatrix<f64>, &DMatrix<f64>),
) -> Result<Update<Dyn, Dyn>, Error> {
    let before = belief(x, p);
    let (posterior, update) = before.corrected(y, h, w)?;
    conditioning.corrected(&before.p, (h, w), &update, &posterior);
    x.copy_from_slice(posterior.x.as_slice());
    p.copy_from_slice(posterior.p.as_slice());
    Ok(update)
}

fn belief(x: &[f64], p: &[f64]) -> Gaussian<Dyn> {
    Gaussian { x: DVector::from_column_slice(x), p: DMatrix::from_column_slice(x.len(), x.len(), p) }
}
