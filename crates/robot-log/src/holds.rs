//! What a table holds besides what it is read as, and which file is read once more for that.

/// What a table holds besides what it is read as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holds {
    Truth,
    Positions,
    Motion,
    Ranges,
}

/// A file that is read once more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Again {
    /// Which of the log's files, by its index.
    pub of: usize,
    pub holds: Holds,
}
