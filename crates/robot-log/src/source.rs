//! How a file of a log is read.

use crate::role::{Role, Units};
use crate::table::Table;

/// How a file is read.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Source {
    pub role: Role,
    pub table: Option<Table>,
    /// The column of each of the role's values.
    pub columns: Vec<Option<usize>>,
    pub units: Units,
}
