//! Where a reading stands in its caller's arguments, so that an error can name it.

use crate::error::{Argument, Error};
use alloc::borrow::Cow;
use alloc::borrow::ToOwned;
use alloc::format;

/// A reading by itself, or an entry of a list: `log[3]`, `sightings[1]`.
#[derive(Clone, Copy)]
pub(crate) enum Blame {
    Alone,
    Entry(&'static str, usize),
}

impl Blame {
    /// The name of a field.
    pub fn name(self, field: &str) -> Cow<'static, str> {
        match self {
            Self::Alone => field.to_owned().into(),
            Self::Entry(list, i) => format!("{list}[{i}].{field}").into(),
        }
    }

    /// The reading's own error, whose argument is one of its fields.
    #[cold]
    pub fn field(self, mut error: Error) -> Error {
        error.argument = self.name(&error.argument);
        error
    }

    /// A filter's error at the reading. An infinite mean or innovation comes from the range, since a bearing is
    /// taken on the circle. W and P are no part of the reading.
    #[cold]
    pub fn step(self, error: Error) -> Error {
        error.called(|argument| match argument {
            Argument::Mean | Argument::Reading => self.name("range"),
            Argument::Landmark => self.name("landmark"),
            Argument::Input | Argument::Covariance | Argument::SensorNoise => argument.letter(),
        })
    }
}
