//! What a filter's correction computes.

use crate::sizes::Sizes;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};

/// What a correction computes beside the new belief.
#[derive(Clone, Debug, PartialEq)]
pub struct Update<N: Dim, M: Dim>
where
    DefaultAllocator: Sizes<N, M>,
{
    /// ν = z − C μ̄, the innovation.
    pub innovation: OVector<f64, M>,
    /// S = C Σ̄ Cᵀ + Q, its covariance.
    pub s: OMatrix<f64, M, M>,
    /// K = Σ̄ Cᵀ S⁻¹, the gain.
    pub k: OMatrix<f64, N, M>,
    /// d² = νᵀS⁻¹ν; `None` where S is singular to working accuracy, or d² too large for a number.
    pub d2: Option<f64>,
    /// Whether the numbers of the step gave cause to look closer, and perhaps to compute it anew from square roots;
    /// [`Conditioning`](crate::Conditioning) says whether that was enough.
    pub doubted: bool,
}
