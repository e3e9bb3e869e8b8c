//! The question of what a file is, where that is not certain.

use crate::role::Role;

/// The question of what a file is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Question {
    pub words: String,
    /// The roles that it names as its answers; none where any may be one.
    pub answers: &'static [Role],
}

impl Question {
    /// A question that any role may answer.
    pub fn open(words: impl Into<String>) -> Self {
        Self { words: words.into(), answers: &[] }
    }
}
