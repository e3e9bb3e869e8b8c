//! The experiments of the page as plain Rust.
