//! Plain values for a view: rows of numbers, ellipses.

use crate::declare::shape::put;
use crate::declare::typescript::Type;
use crate::declare::{Plain, Shape, record};
use estimate::kf::Gaussian;
use estimate::{Complex, Error};
use geom::Ellipse;
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, U2, Vector2};

record! {
    /// An ellipse as a view draws it.
    #[typescript = "Ellipse"]
    #[derive(Copy)]
    pub struct EllipseShape {
        /// Half the long axis.
        pub semi_major: f64,
        /// Half the short axis.
        pub semi_minor: f64,
        /// Angle of the long axis, radians in (−π/2, π/2].
        pub angle: f64,
    }
}

impl From<Ellipse> for EllipseShape {
    fn from(e: Ellipse) -> Self {
        Self { semi_major: e.semi_major, semi_minor: e.semi_minor, angle: e.angle }
    }
}

/// The one-sigma ellipse of a 2×2 covariance.
pub fn ellipse_of(p: &Matrix2<f64>) -> EllipseShape {
    Ellipse::from_covariance(p, 1.0).into()
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
        pub ellipse: EllipseShape,
    }
}

impl From<&Gaussian<U2>> for BenchBelief {
    fn from(belief: &Gaussian<U2>) -> Self {
        Self { x: pair(&belief.x), p: rows(&belief.p), ellipse: ellipse_of(&belief.p) }
    }
}

record! {
    /// A complex number.
    #[typescript = "Complex"]
    #[derive(Copy)]
    pub struct Root {
        /// Real part.
        pub re: f64,
        /// Imaginary part.
        pub im: f64,
    }
}

impl From<Complex<f64>> for Root {
    fn from(c: Complex<f64>) -> Self {
        Self { re: c.re, im: c.im }
    }
}

pub(crate) fn pair(v: &Vector2<f64>) -> [f64; 2] {
    [v[0], v[1]]
}

pub(crate) fn rows(m: &Matrix2<f64>) -> [[f64; 2]; 2] {
    [[m[(0, 0)], m[(0, 1)]], [m[(1, 0)], m[(1, 1)]]]
}

pub(crate) fn rows3(m: &Matrix3<f64>) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[(i, j)]))
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
    const TYPE: Type = Type::Array(&T::TYPE);

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
