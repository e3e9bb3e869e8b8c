//! What TypeScript is told of a record beside its shape.

use crate::parameter::Parameter;
use crate::shape::{Plain, Shape};

/// What an interface of TypeScript says beside its shape. It is kept apart from the shape, so that no program carries
/// these words.
pub struct About {
    /// A record.
    pub shape: Shape,
    /// The record's doc comment.
    pub record: &'static str,
    /// The doc comment of each field.
    pub fields: &'static [&'static str],
    /// The limits of each field, where the fields are parameters.
    pub parameters: &'static [Parameter],
    /// The default of each, as it is written in the declaration.
    pub defaults: &'static [&'static str],
}

/// A record that TypeScript knows as an interface.
pub trait Interface: Plain {
    /// Shape and doc comments.
    const ABOUT: About;
}
