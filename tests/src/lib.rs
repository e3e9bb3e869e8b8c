//! Facts that hold across the crates.
