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
    /// The state stands on the feature that was read, where the reading's model does not exist.
    AtFeature,
    /// A probability, a number of degrees of freedom, an index or the like is not among what is accepted.
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
            Self::AtFeature => write!(f, "the state stands on the feature: nothing can be linearized there"),
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
