//! A belief: a normal distribution, and what a linear prediction and a linear reading make of it.

use crate::covariance::{finite, is_finite, mend};
use crate::error::{Error, Quantity};
use crate::linear::{self, Gain};
use crate::sizes::Sizes;
use crate::update::Update;
use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector, Storage, Vector};

/// The normal distribution N(x, P) of N states: `Gaussian<U2>` of two, `Gaussian<Dyn>` of a number known at run time
/// only.
#[derive(Clone, Debug, PartialEq)]
pub struct Gaussian<N: Dim>
where
    DefaultAllocator: Sizes<N>,
{
    /// The mean μ, n.
    pub x: OVector<f64, N>,
    /// The covariance Σ, n×n, symmetric positive semidefinite.
    pub p: OMatrix<f64, N, N>,
}

impl<N: Dim> Copy for Gaussian<N>
where
    DefaultAllocator: Sizes<N>,
    OVector<f64, N>: Copy,
    OMatrix<f64, N, N>: Copy,
{
}

impl<N: Dim> Gaussian<N>
where
    DefaultAllocator: Sizes<N>,
{
    /// The belief after x⁺ = A x + B u + noise of covariance R: μ̄ = A μ + B u, Σ̄ = A Σ Aᵀ + R. `input` is (B, u), or
    /// nothing where no input acts.
    ///
    /// # Errors
    /// [`Error::NotFinite`] when an argument is not finite or a product overflows.
    // Where a binary is fetched, one function for each size, and none in each caller.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    pub fn predicted<U: Dim>(
        &self,
        a: &OMatrix<f64, N, N>,
        r: &OMatrix<f64, N, N>,
        input: Option<(&OMatrix<f64, N, U>, &OVector<f64, U>)>,
    ) -> Result<Self, Error>
    where
        DefaultAllocator: Allocator<N, U> + Allocator<U>,
    {
        let mut belief = self.clone();
        belief.predict(a, r, input)?;
        Ok(belief)
    }

    /// [`predicted`](Self::predicted), in the place of the belief itself; after an error it is as it was. Answers
    /// whether Σ̄ is regular: whether the rounding of its entries is nothing beside it in any direction.
    ///
    /// # Errors
    /// As there.
    // In line, with `correct`: of few states, an answer that is handed over in memory may cost more than its
    // arithmetic.
    #[inline(always)]
    pub fn predict<U: Dim, S: Storage<f64, U>>(
        &mut self,
        a: &OMatrix<f64, N, N>,
        r: &OMatrix<f64, N, N>,
        input: Option<(&OMatrix<f64, N, U>, &Vector<f64, U, S>)>,
    ) -> Result<bool, Error>
    where
        DefaultAllocator: Allocator<N, U>,
    {
        let mut x = a * &self.x;
        if let Some((b, u)) = input {
            x += b * u;
            if !is_finite(&x) {
                finite(b * u, Quantity::Input)?;
            }
        }
        if !is_finite(&x) {
            return Err(Error::NotFinite(Quantity::PredictedMean));
        }
        let mut p = linear::congruence(a, &self.p, r);
        let regular = mend(&mut p)?;
        (self.x, self.p) = (x, p);
        Ok(regular)
    }

    /// The belief after the reading z = C x + noise of covariance Q: μ = μ̄ + K(z − C μ̄), added in just this order,
    /// and Σ in Joseph's form.
    ///
    /// # Errors
    /// [`Error::InnovationNotPositiveDefinite`], or [`Error::NotFinite`] when an argument is not finite or a product
    /// overflows.
    ///
    /// # Example
    /// ```
    /// use filters::Gaussian;
    /// use nalgebra::{Matrix1, Vector1};
    /// let one = Matrix1::new(1.0);
    /// let predicted = Gaussian { x: Vector1::new(0.0), p: Matrix1::new(2.0) };
    /// let (corrected, update) = predicted.corrected(&Vector1::new(3.0), &one, &one)?;
    /// assert_eq!((update.innovation[0], update.s[0]), (3.0, 3.0));
    /// assert!((corrected.x[0] - 2.0).abs() < 1e-15 && (corrected.p[0] - 2.0 / 3.0).abs() < 1e-15);
    /// # Ok::<(), filters::Error>(())
    /// ```
    // Where a binary is fetched, one function for each size, and none in each caller.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    pub fn corrected<M: Dim>(
        &self,
        z: &OVector<f64, M>,
        c: &OMatrix<f64, M, N>,
        q: &OMatrix<f64, M, M>,
    ) -> Result<(Self, Update<N, M>), Error>
    where
        DefaultAllocator: Sizes<N, M>,
    {
        let mut belief = self.clone();
        let update = belief.correct(z, c, q)?;
        Ok((belief, update))
    }

    /// [`corrected`](Self::corrected), in the place of the belief itself; after an error it is as it was.
    ///
    /// # Errors
    /// As there.
    #[inline(always)]
    pub fn correct<M: Dim>(
        &mut self,
        z: &OVector<f64, M>,
        c: &OMatrix<f64, M, N>,
        q: &OMatrix<f64, M, M>,
    ) -> Result<Update<N, M>, Error>
    where
        DefaultAllocator: Sizes<N, M>,
    {
        let innovation = z - c * &self.x;
        if !is_finite(&innovation) {
            finite(c * &self.x, Quantity::PredictedOutput)?;
            return Err(Error::NotFinite(Quantity::Innovation));
        }
        let gain = linear::gain_in_line(&self.p, c, q)?;
        let x = &self.x + &gain.k * &innovation;
        if !is_finite(&x) {
            return Err(Error::NotFinite(Quantity::Mean));
        }
        let (d2, Gain { k, s, p, doubted, .. }) = (gain.d2(&innovation), gain);
        (self.x, self.p) = (x, p);
        Ok(Update { innovation, s, k, d2, doubted })
    }

    /// The product of two Gaussian densities, which is a Gaussian up to its scale (Theorem 8.2.1): mean z₁ + 𝒬(z₂ − z₁)
    /// and covariance C₁ − 𝒬C₁ with 𝒬 = C₁(C₁ + C₂)⁻¹. It is the correction of this belief by a reading z₂ of the whole
    /// state with noise C₂, and is computed so.
    ///
    /// # Errors
    /// [`Error::InnovationNotPositiveDefinite`] when C₁ + C₂ is singular, [`Error::NotFinite`] on overflow.
    ///
    /// # Example
    /// ```
    /// use filters::Gaussian;
    /// use nalgebra::{Matrix1, Vector1};
    /// let a = Gaussian { x: Vector1::new(0.0), p: Matrix1::new(1.0) };
    /// let b = Gaussian { x: Vector1::new(4.0), p: Matrix1::new(3.0) };
    /// let c = a.product(&b)?;
    /// assert_eq!((c.x[0], c.p[0]), (1.0, 0.75));
    /// # Ok::<(), filters::Error>(())
    /// ```
    pub fn product(&self, other: &Self) -> Result<Self, Error> {
        let n = self.x.shape_generic().0;
        let (product, _) = self.corrected(&other.x, &OMatrix::identity_generic(n, n), &other.p)?;
        Ok(product)
    }
}
