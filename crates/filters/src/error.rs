//! What can go wrong in a filter.

use core::fmt;

/// Why a filter refused to answer. The belief it was asked to change is then as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// An argument is a NaN or an infinity, or finite arguments overflowed.
    NotFinite(Quantity),
    /// The innovation covariance S is not positive definite, or so near to singular that rounding would decide the
    /// answer.
    InnovationNotPositiveDefinite,
    /// The state stands on the feature that was read, where the reading's model does not exist.
    AtFeature,
    /// A parameter lies outside its range.
    OutOfRange(Parameter),
}

/// What a filter computes, or is given, on its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// B u, what the input adds to the mean.
    Input,
    /// μ̄, the mean after a prediction.
    PredictedMean,
    /// Σ̄, the covariance after a prediction.
    PredictedCovariance,
    /// C μ̄, the reading that the prediction expects.
    PredictedOutput,
    /// z − C μ̄.
    Innovation,
    /// S = C Σ̄ Cᵀ + Q.
    InnovationCovariance,
    /// K = Σ̄ Cᵀ S⁻¹.
    Gain,
    /// μ, the mean after a correction.
    Mean,
    /// Σ, the covariance after a correction, or before a prediction.
    Covariance,
    /// d² = νᵀS⁻¹ν.
    SquaredDistance,
}

/// What a caller chooses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// A probability lies between 0 and 1, both excluded.
    Probability,
    /// Degrees of freedom are at least 1.
    DegreesOfFreedom,
    /// A number of samples is at least 1, and its product with the degrees of freedom below 2³².
    Samples,
    /// α and n + κ are positive, and α²(n + κ) and β finite.
    SigmaPoints,
    /// The covariance from which sigma points are drawn is positive definite.
    Covariance,
    /// A feature's number is below the number of features.
    Feature,
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Input => "the input's part of the mean",
            Self::PredictedMean => "the predicted mean",
            Self::PredictedCovariance => "the predicted covariance",
            Self::PredictedOutput => "the predicted output",
            Self::Innovation => "the innovation",
            Self::InnovationCovariance => "the innovation covariance S",
            Self::Gain => "the gain",
            Self::Mean => "the mean",
            Self::Covariance => "the covariance",
            Self::SquaredDistance => "the squared distance",
        })
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(quantity) => write!(f, "{quantity} is not finite"),
            Self::InnovationNotPositiveDefinite => {
                write!(f, "the innovation covariance S is not positive definite to working accuracy")
            }
            Self::AtFeature => write!(f, "the state stands on the feature, where its reading cannot be linearized"),
            Self::OutOfRange(parameter) => write!(f, "{parameter}"),
        }
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Probability => "the probability must lie between 0 and 1",
            Self::DegreesOfFreedom => "the degrees of freedom must be at least 1",
            Self::Samples => "the samples must be at least 1, and fewer than 2³² with the degrees of freedom",
            Self::SigmaPoints => "the sigma points need a positive α and n + κ, and a finite β",
            Self::Covariance => "the covariance must be positive definite",
            Self::Feature => "the map has no such feature",
        })
    }
}

impl core::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_message_names_its_culprit() {
        let cases = [
            (Error::NotFinite(Quantity::Mean), "the mean"),
            (Error::NotFinite(Quantity::InnovationCovariance), "S"),
            (Error::InnovationNotPositiveDefinite, "S"),
            (Error::OutOfRange(Parameter::Probability), "probability"),
        ];
        for (error, culprit) in cases {
            assert!(error.to_string().contains(culprit), "{error}");
        }
    }
}
