//! The sizes of a filter's matrices, fixed in the type or known at run time only.

use nalgebra::DefaultAllocator;
use nalgebra::Dim;
use nalgebra::allocator::Allocator;

/// What nalgebra must be able to store for a filter of N states and M outputs. It is so for all fixed sizes
/// (`Const<N>`, or [`U2`](type@nalgebra::U2) and its like) and for [`Dyn`](nalgebra::Dyn): a function over sizes asks
/// for this one bound on [`DefaultAllocator`] in place of six.
///
/// # Example
/// ```
/// use filters::Sizes;
/// use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};
/// fn output<N: Dim, M: Dim>(c: &OMatrix<f64, M, N>, x: &OVector<f64, N>) -> OVector<f64, M>
/// where
///     DefaultAllocator: Sizes<N, M>,
/// {
///     c * x
/// }
/// assert_eq!(output(&nalgebra::dmatrix![1.0, 2.0], &nalgebra::dvector![3.0, 4.0])[0], 11.0);
/// ```
pub trait Sizes<N: Dim, M: Dim = N>:
    Allocator<N> + Allocator<M> + Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>
{
}

impl<N: Dim, M: Dim> Sizes<N, M> for DefaultAllocator where
    Self: Allocator<N> + Allocator<M> + Allocator<N, N> + Allocator<M, N> + Allocator<N, M> + Allocator<M, M>
{
}
