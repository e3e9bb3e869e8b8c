//! What can go wrong, which argument is to blame, and what would have been accepted.

use alloc::borrow::Cow;
use alloc::boxed::Box;
use alloc::format;
use alloc::string::ToString;
use core::fmt;
use filters::{Parameter, Quantity};

/// The kinds of error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// A number is a NaN or an infinity, or finite arguments overflowed into one.
    NotFinite,
    /// Sizes do not fit together.
    Shape,
    /// A covariance is not symmetric.
    NotSymmetric,
    /// A covariance has a negative eigenvalue.
    NotPositiveSemidefinite,
    /// HPHᵀ + W is singular, or so near to it that rounding would decide the answer.
    InnovationNotPositiveDefinite,
    /// (F, H) is not observable.
    Unobservable,
    /// The poles are not n numbers closed under conjugation.
    Poles,
    /// A tolerance is negative or not a number.
    Tolerance,
    /// No such thing under this number.
    Index,
    /// Range or bearing to a landmark the robot stands on.
    AtLandmark,
    /// (F, H) is observable but F is singular, or nearly, so the poles cannot be had.
    NotPlaceable,
    /// A count or a size is beyond its documented cap.
    Limit,
    /// An argument is not of the kind asked for.
    Type,
    /// An eigenvalue or singular-value iteration reached its limit.
    DidNotConverge,
}

/// Why a function refused to answer; what it was asked to change is as it was.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error(Box<Refusal>);

/// What an [`Error`] says. It is on the heap, so that a result is no larger than its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// What kind of error.
    pub code: Code,
    /// The argument to blame, as a path: `P`, `system.F`, `landmarks[2].id`.
    pub argument: Cow<'static, str>,
    /// What was wrong, and what is accepted.
    pub message: Cow<'static, str>,
    /// The argument of a filter's step that is to blame, where a step refused.
    step: Option<Argument>,
}

/// An argument of a filter's step. Each caller has its own name for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Argument {
    /// u.
    Input,
    /// x̂.
    Mean,
    /// P.
    Covariance,
    /// y.
    Reading,
    /// W.
    SensorNoise,
    /// The landmark that was read.
    Landmark,
}

impl Argument {
    /// Choset's letter for it.
    pub fn letter(self) -> Cow<'static, str> {
        match self {
            Self::Input => "u",
            Self::Mean => "x",
            Self::Covariance => "P",
            Self::Reading => "y",
            Self::SensorNoise => "W",
            Self::Landmark => "landmark",
        }
        .into()
    }
}

impl From<Quantity> for Argument {
    /// The argument to blame for a quantity that is not finite.
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::Input => Self::Input,
            Quantity::PredictedMean | Quantity::PredictedOutput | Quantity::Mean => Self::Mean,
            Quantity::Innovation | Quantity::SquaredDistance => Self::Reading,
            Quantity::PredictedCovariance | Quantity::InnovationCovariance | Quantity::Gain | Quantity::Covariance => {
                Self::Covariance
            }
        }
    }
}

impl Error {
    /// An error blaming `argument`.
    pub fn new(code: Code, argument: impl Into<Cow<'static, str>>, message: impl Into<Cow<'static, str>>) -> Self {
        Self(Box::new(Refusal { code, argument: argument.into(), message: message.into(), step: None }))
    }

    /// The same error seen from outside: the argument is a part of `whole`.
    #[must_use]
    pub fn within(mut self, whole: &str) -> Self {
        self.argument = format!("{whole}.{}", self.argument).into();
        self
    }

    /// The same error where its argument is one of the `parts` of `whole`; any other error as it is.
    #[must_use]
    pub fn part_of(self, whole: &str, parts: &[&str]) -> Self {
        if parts.contains(&&*self.argument) { self.within(whole) } else { self }
    }

    /// The same error, where a filter's step refused, with the caller's `name` of the argument to blame.
    #[must_use]
    pub(crate) fn called(mut self, name: impl FnOnce(Argument) -> Cow<'static, str>) -> Self {
        if let Some(argument) = self.step {
            self.argument = name(argument);
        }
        self
    }

    /// Why a matrix computation has no answer, blaming `argument`.
    pub(crate) fn of_matrix(error: numerics::Error, argument: &'static str) -> Self {
        let code = match error {
            numerics::Error::NotSquare | numerics::Error::TooLarge => Code::Shape,
            numerics::Error::NotFinite => Code::NotFinite,
            numerics::Error::DidNotConverge => Code::DidNotConverge,
        };
        Self::new(code, argument, error.to_string())
    }

    fn of_step(code: Code, argument: Argument, message: impl Into<Cow<'static, str>>) -> Self {
        let mut error = Self::new(code, argument.letter(), message);
        error.0.step = Some(argument);
        error
    }
}

impl core::ops::Deref for Error {
    type Target = Refusal;

    fn deref(&self) -> &Refusal {
        &self.0
    }
}

impl core::ops::DerefMut for Error {
    fn deref_mut(&mut self) -> &mut Refusal {
        &mut self.0
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.argument, self.message)
    }
}

impl core::error::Error for Error {}

impl From<filters::Error> for Error {
    /// Thrun's words in Choset's letters; W is to blame for a singular S, since a greater W would mend it.
    fn from(error: filters::Error) -> Self {
        match error {
            filters::Error::NotFinite(quantity) => Self::of_step(
                Code::NotFinite,
                quantity.into(),
                format!("{quantity} is not finite: a number given is not, or is too large"),
            ),
            filters::Error::InnovationNotPositiveDefinite => Self::of_step(
                Code::InnovationNotPositiveDefinite,
                Argument::SensorNoise,
                "the innovation covariance HPHᵀ + W is not positive definite to working accuracy; more sensor noise W, \
                 or outputs that are not copies of each other, would make it so",
            ),
            filters::Error::AtFeature => Self::of_step(
                Code::AtLandmark,
                Argument::Landmark,
                "the estimate stands on the landmark, where range and bearing cannot be linearized; move the estimate \
                    away \
                 from it",
            ),
            filters::Error::OutOfRange(parameter) => {
                let argument = match parameter {
                    Parameter::Probability => "probability",
                    Parameter::DegreesOfFreedom => "dof",
                    Parameter::Samples => "samples",
                    Parameter::SigmaPoints => "points",
                    Parameter::Covariance => "P",
                    Parameter::Feature => "landmark",
                };
                Self::new(Code::Limit, argument, parameter.to_string())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_names_the_argument_and_what_was_wrong() {
        let error = Error::new(Code::Shape, "F", "is empty").within("system");
        assert_eq!(error.to_string(), "system.F: is empty");
    }

    #[test]
    fn a_filter_s_error_comes_back_in_choset_s_letters() {
        for (quantity, argument) in [
            (Quantity::Input, "u"),
            (Quantity::Innovation, "y"),
            (Quantity::SquaredDistance, "y"),
            (Quantity::PredictedOutput, "x"),
            (Quantity::Mean, "x"),
            (Quantity::PredictedMean, "x"),
            (Quantity::Covariance, "P"),
            (Quantity::InnovationCovariance, "P"),
        ] {
            let error = Error::from(filters::Error::NotFinite(quantity));
            assert_eq!((error.code, error.argument.as_ref()), (Code::NotFinite, argument));
            assert!(error.message.contains(&quantity.to_string()));
        }
        let singular = Error::from(filters::Error::InnovationNotPositiveDefinite);
        assert_eq!((singular.code, singular.argument.as_ref()), (Code::InnovationNotPositiveDefinite, "W"));
    }

    #[test]
    fn a_caller_renames_a_step_s_argument_and_no_other() {
        let name = |argument| match argument {
            Argument::Mean => "belief.x".into(),
            other => other.letter(),
        };
        let blamed = |error: Error| error.called(name).argument.to_string();
        assert_eq!(blamed(filters::Error::NotFinite(Quantity::Mean).into()), "belief.x");
        assert_eq!(blamed(filters::Error::InnovationNotPositiveDefinite.into()), "W");
        assert_eq!(blamed(Error::new(Code::Shape, "x", "is empty")), "x");
    }
}
