//! The JavaScript face of the estimate core.
