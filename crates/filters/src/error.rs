//! What can go wrong in a filter.

use core::fmt;

/// Why a filter refused to answer. The belief it was asked to change is then as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// An argument, or a result computed from finite arguments, is a NaN or an infinity.
    NotFinite {
        /// The culprit.
        what: &'static str,
    },
    /// The innovation covariance S is not positive definite, or so near to singular that rounding would decide the
    /// answer.
    InnovationNotPositiveDefinite,
    /// A probability lies outside (0, 1), or a number of degrees of freedom is zero.
    OutOfRange {
        /// The culprit.
        what: &'static str,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { what } => write!(f, "{what} is not finite"),
            Self::InnovationNotPositiveDefinite => {
                write!(f, "the innovation covariance S is not positive definite to working accuracy")
            }
            Self::OutOfRange { what } => write!(f, "{what} is out of range"),
        }
    }
}

impl core::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_message_names_its_culprit() {
        let cases = [
            (Error::NotFinite { what: "the mean" }, "the mean"),
            (Error::InnovationNotPositiveDefinite, "S"),
            (Error::OutOfRange { what: "probability" }, "probability"),
        ];
        for (error, culprit) in cases {
            assert!(error.to_string().contains(culprit), "{error}");
        }
    }
}
