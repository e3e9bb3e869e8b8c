//! What can go wrong, which argument is to blame, and what would have been accepted.

use core::fmt;
use std::borrow::Cow;

/// The kinds of error, one for each thing a caller can do something about.
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
    /// An eigenvalue or singular-value iteration met its cap.
    DidNotConverge,
}

/// Why a function refused to answer; what it was asked to change is as it was.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error(Box<Refusal>);

/// What an [`Error`] says, on the heap: a result is then no larger than its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// What kind of error.
    pub code: Code,
    /// The argument to blame, as a path: `P`, `system.F`, `landmarks[2].id`.
    pub argument: Cow<'static, str>,
    /// What was wrong, and what is accepted.
    pub message: Cow<'static, str>,
}

impl Error {
    /// An error blaming `argument`.
    pub fn new(code: Code, argument: impl Into<Cow<'static, str>>, message: impl Into<Cow<'static, str>>) -> Self {
        Self(Box::new(Refusal { code, argument: argument.into(), message: message.into() }))
    }

    /// The same error seen from outside: the argument is a part of `whole`.
    #[must_use]
    pub fn within(mut self, whole: &str) -> Self {
        self.argument = format!("{whole}.{}", self.argument).into();
        self
    }

    /// The same error from a function whose argument `to` is what the failing computation calls `from`.
    #[must_use]
    pub fn renamed(mut self, from: &str, to: &'static str) -> Self {
        if self.argument == from {
            self.argument = to.into();
        }
        self
    }

    /// The same error from an update by a reading, where only the range can have made an innovation or a mean infinite:
    /// a bearing is taken on the circle.
    pub(crate) fn of_a_range(self) -> Self {
        if self.code == Code::NotFinite { self.renamed("x", "range").renamed("y", "range") } else { self }
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

impl std::error::Error for Error {}

impl From<filters::Error> for Error {
    /// Thrun's words in Choset's letters; W is to blame for a singular S, since a greater W would mend it.
    fn from(error: filters::Error) -> Self {
        match error {
            filters::Error::NotFinite { what } => {
                let argument = match what {
                    "the innovation" | "the squared distance" => "y",
                    "the mean" | "the predicted mean" | "x" => "x",
                    "K" => "K",
                    _ => "P",
                };
                Self::new(Code::NotFinite, argument, format!("{what} became infinite: the numbers given are too large"))
            }
            filters::Error::InnovationNotPositiveDefinite => Self::new(
                Code::InnovationNotPositiveDefinite,
                "W",
                "the innovation covariance HPHᵀ + W is not positive definite to working accuracy; more sensor noise W, \
                 or outputs that are not copies of each other, would make it so",
            ),
            filters::Error::AtFeature => Self::new(
                Code::AtLandmark,
                "landmark",
                "the estimate stands on the landmark, where range and bearing cannot be linearized; a step aside mends it",
            ),
            filters::Error::OutOfRange { what } => Self::new(Code::Limit, what, "is out of range"),
        }
    }
}

impl From<numerics::Error> for Error {
    fn from(error: numerics::Error) -> Self {
        let code = match error {
            numerics::Error::NotSquare | numerics::Error::TooLarge => Code::Shape,
            numerics::Error::NotFinite => Code::NotFinite,
            numerics::Error::DidNotConverge => Code::DidNotConverge,
        };
        Self::new(code, "matrix", error.to_string())
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
    fn the_filter_s_words_come_back_with_choset_s_letters() {
        for (what, argument) in [
            ("the innovation", "y"),
            ("the mean", "x"),
            ("the predicted mean", "x"),
            ("the squared distance", "y"),
            ("x", "x"),
            ("K", "K"),
            ("the covariance", "P"),
            ("S", "P"),
        ] {
            let error = Error::from(filters::Error::NotFinite { what });
            assert_eq!((error.code, error.argument.as_ref()), (Code::NotFinite, argument));
            assert!(error.message.contains(what));
        }
        let singular = Error::from(filters::Error::InnovationNotPositiveDefinite);
        assert_eq!((singular.code, singular.argument.as_ref()), (Code::InnovationNotPositiveDefinite, "W"));
    }
}
