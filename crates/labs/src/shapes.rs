//! Plain values for a view: rows of numbers, ellipses.

use estimate::Error;
use estimate::kf::Gaussian;
use filters::consistency::chi2_interval;
use geom::Ellipse;
use lab::{Plain, Shape, put, record};
use nalgebra::{Matrix2, SMatrix, SVector, U2};
use std::sync::LazyLock;

/// Where 95 % of single values of χ² with 3 degrees of freedom lie, as the NEES of a pose does.
pub(crate) static POSE_BAND: LazyLock<[f64; 2]> =
    LazyLock::new(|| chi2_interval(3, 1, 0.95).map_or([f64::NAN; 2], |(low, high)| [low, high]));

/// The one-sigma ellipse of a 2×2 covariance.
pub fn ellipse_of(p: &Matrix2<f64>) -> Ellipse {
    Ellipse::from_covariance(p, 1.0)
}

/// The probability that a Gaussian of two states gives to its ellipse of so many standard deviations, 1 −
/// exp(−radius²/2).
pub fn inside(radius: f64) -> f64 {
    1.0 - libm::exp(-0.5 * radius * radius)
}

record! {
    /// A belief over two states.
    #[derive(Copy)]
    pub struct BenchBelief {
        /// The mean.
        pub x: [f64; 2],
        /// The covariance, by rows.
        #[name = "P"]
        pub p: [[f64; 2]; 2],
        /// Its one-sigma ellipse.
        pub ellipse: Ellipse,
    }
}

impl From<&Gaussian<U2>> for BenchBelief {
    fn from(belief: &Gaussian<U2>) -> Self {
        Self { x: belief.x.into(), p: rows(&belief.p), ellipse: ellipse_of(&belief.p) }
    }
}

/// The rows of a square matrix.
pub(crate) fn rows<const N: usize>(m: &SMatrix<f64, N, N>) -> [[f64; N]; N] {
    m.transpose().into()
}

/// One entry or two, for sensors of one output and of two. On the stack: a lab makes thousands, and draws the last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneOrTwo<T> {
    count: usize,
    entries: [T; 2],
}

impl<T> OneOrTwo<T> {
    /// The entries there are.
    pub fn entries(&self) -> &[T] {
        &self.entries[..self.count]
    }
}

impl<T: Plain + 'static> Plain for OneOrTwo<T> {
    const SHAPE: Shape = Shape::List(&T::SHAPE);

    fn write(&self, to: &mut Vec<f64>) {
        put(to, self.count as f64);
        self.entries().iter().for_each(|entry| entry.write(to));
    }
}

/// ν of one output or two.
pub type Innovation = OneOrTwo<f64>;
/// S of one output or two, by rows.
pub type InnovationCovariance = OneOrTwo<OneOrTwo<f64>>;

/// ν and S for a view, of M outputs, which are one or two.
pub(crate) fn innovation<const M: usize>(
    nu: &SVector<f64, M>,
    s: &SMatrix<f64, M, M>,
) -> (Innovation, InnovationCovariance) {
    let last = M - 1;
    let row = |i: usize| OneOrTwo { count: M, entries: [s[(i, 0)], s[(i, last)]] };
    (OneOrTwo { count: M, entries: [nu[0], nu[last]] }, OneOrTwo { count: M, entries: [row(0), row(last)] })
}

/// The lower triangular root of a covariance that is known to be positive definite, a constant of a lab.
pub(crate) fn root<const N: usize>(p: &SMatrix<f64, N, N>, name: &'static str) -> Result<SMatrix<f64, N, N>, Error> {
    numerics::Spd::new(*p).map(|c| c.root()).ok_or_else(|| {
        Error::new(estimate::Code::NotPositiveSemidefinite, name, "has no Cholesky root: noise cannot be drawn from it")
    })
}
