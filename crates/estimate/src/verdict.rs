//! The answer to a question about a system whose numbers are known within a tolerance only.

/// Whether something holds of a system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds, and of every system within the tolerance too.
    Yes,
    /// It does not hold.
    No,
    /// The tolerance does not decide: it holds of some systems within the tolerance and not of others.
    Undecided,
}

impl Verdict {
    /// The verdict of `holds` on which all of `answers` agree; [`Verdict::Undecided`] where they do not.
    pub(crate) fn of_all(answers: impl IntoIterator<Item = Self>) -> Self {
        answers.into_iter().reduce(|a, b| if a == b { a } else { Self::Undecided }).unwrap_or(Self::Undecided)
    }
}

impl From<bool> for Verdict {
    fn from(holds: bool) -> Self {
        if holds { Self::Yes } else { Self::No }
    }
}

#[cfg(test)]
mod tests {
    use super::Verdict::{self, No, Undecided, Yes};

    #[test]
    fn answers_that_differ_leave_a_question_undecided() {
        assert_eq!(Verdict::of_all([Yes, Yes]), Yes);
        assert_eq!(Verdict::of_all([No]), No);
        assert_eq!(Verdict::of_all([No, Yes]), Undecided);
        assert_eq!(Verdict::of_all([Undecided, Yes]), Undecided);
        assert_eq!(Verdict::of_all([]), Undecided);
    }
}
