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

    /// Goes on with what another filter was judged by.
    pub fn judge_by(&mut self, conditioning: Conditioning) {
        self.conditioning = conditioning;
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

    /// [`correct`](Self::correct) by a reading whose size is known at run time only.
    pub fn correct_partly(
        &mut self,
        y: &DVector<f64>,
        h: &DMatrix<f64>,
        w: &DMatrix<f64>,
    ) -> Result<Update<Dyn, Dyn>, Error> {
        let n = self.belief.x.len();
        let x = DVector::from_column_slice(self.belief.x.as_slice());
        let p = DMatrix::from_column_slice(n, n, self.belief.p.as_slice());
        let (x, p, update) = corrected((x, p), &mut self.conditioning, y, h, w)?;
        self.belief.x.copy_from_slice(x.as_slice());
        self.belief.p.copy_from_slice(p.as_slice());
        Ok(update)
    }
}

impl Followed<Dyn> {
    /// Takes the mean out of a belief about an error: what is left has the mean zero.
    pub fn recentred(&mut self) -> DVector<f64> {
        let n = self.belief.x.len();
        core::mem::replace(&mut self.belief.x, DVector::zeros(n))
    }
}

/// [`Followed::correct`] of a belief whose size is known at run time only.
fn corrected(
    (x, p): (DVector<f64>, DMatrix<f64>),
    conditioning: &mut Conditioning,
    y: &DVector<f64>,
    h: &DMatrix<f64>,
    w: &DMatrix<f64>,
) -> Result<(DVector<f64>, DMatrix<f64>, Update<Dyn, Dyn>), Error> {
    let belief = Gaussian { x, p };
    let (posterior, update) = belief.corrected(y, h, w)?;
    conditioning.corrected(&belief.p, (h, w), &update, &posterior);
    Ok((posterior.x, posterior.p, update))
}
