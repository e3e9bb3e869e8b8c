//! Why a matrix has no eigenvalues or singular values here.

use core::fmt;

/// Why [`eigenvalues`](crate::eigenvalues) or [`singular_values`](crate::singular_values) has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// The matrix is not square, so it has no eigenvalues.
    NotSquare,
    /// The matrix has more than two rows, where only the closed form was asked for.
    TooLarge,
    /// The matrix holds a NaN or an infinity.
    NotFinite,
    /// The iteration reached its limit.
    DidNotConverge,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotSquare => "is not square, so it has no eigenvalues",
            Self::TooLarge => "has more than two rows",
            Self::NotFinite => "holds a NaN or an infinity",
            Self::DidNotConverge => "needs more iterations than the limit allows",
        })
    }
}

impl core::error::Error for Error {}
