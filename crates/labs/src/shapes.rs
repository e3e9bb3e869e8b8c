//! Plain values for a view: rows of numbers, ellipses.

use estimate::kf::Gaussian;
use estimate::{Complex, Error};
use geom::Ellipse;
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, U2, Vector2};
use serde::Serialize;

/// An ellipse as a view draws it: half-axes, and the angle of the major axis in (−π/2, π/2].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct EllipseShape {
    /// Half the long axis.
    pub semi_major: f64,
    /// Half the short axis.
    pub semi_minor: f64,
    /// Angle of the long axis, radians.
    pub angle: f64,
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

/// A belief over two states.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Belief2 {
    /// The mean.
    pub x: [f64; 2],
    /// The covariance, by rows.
    #[serde(rename = "P")]
    pub p: [[f64; 2]; 2],
    /// Its one-sigma ellipse.
    pub ellipse: EllipseShape,
}

impl From<&Gaussian<U2>> for Belief2 {
    fn from(belief: &Gaussian<U2>) -> Self {
        Self { x: pair(&belief.x), p: rows(&belief.p), ellipse: ellipse_of(&belief.p) }
    }
}

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Root {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
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

/// What is read at once, one number or two: ν, or S by rows. On the stack, for a lab makes thousands of them that only the
/// last of is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum OneOrTwo<One, Two> {
    /// Of one output.
    One(One),
    /// Of two.
    Two(Two),
}

/// ν of one output or two.
pub type Innovation = OneOrTwo<[f64; 1], [f64; 2]>;
/// S of one output or two.
pub type InnovationCovariance = OneOrTwo<[[f64; 1]; 1], [[f64; 2]; 2]>;

/// ν and S for a view, of M outputs, which are one or two.
pub(crate) fn innovation<const M: usize>(
    nu: &SVector<f64, M>,
    s: &SMatrix<f64, M, M>,
) -> (Innovation, InnovationCovariance) {
    let last = M - 1;
    if M == 1 {
        (OneOrTwo::One([nu[0]]), OneOrTwo::One([[s[(0, 0)]]]))
    } else {
        let rows = [[s[(0, 0)], s[(0, last)]], [s[(last, 0)], s[(last, last)]]];
        (OneOrTwo::Two([nu[0], nu[last]]), OneOrTwo::Two(rows))
    }
}

/// The lower triangular root of a covariance that is known to be positive definite, a constant of a lab.
pub(crate) fn root<const N: usize>(p: &SMatrix<f64, N, N>, name: &'static str) -> Result<SMatrix<f64, N, N>, Error> {
    numerics::Spd::new(*p).map(|c| c.root()).ok_or_else(|| {
        Error::new(estimate::Code::NotPositiveSemidefinite, name, "has no Cholesky root: noise cannot be drawn from it")
    })
}
