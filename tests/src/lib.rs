//! Facts that hold across the crates.

/// The Rust example of the book's README.
#[cfg(doctest)]
// A code block of JavaScript names the file that the tests of the npm package save it as.
#[allow(rustdoc::invalid_codeblock_attributes)]
#[doc = include_str!("../../README.md")]
pub struct Readme;

pub mod planted;
