//! A number of the prose, with what computes it and the check that pins it.

use nalgebra::SMatrix;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A number of the prose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Number {
    /// Its name in the text: dotted, as `step1.P.11`.
    pub id: String,
    /// Its value.
    pub value: f64,
    /// What it is, for a reader who asks.
    pub about: Cow<'static, str>,
    /// The function that computes it.
    pub source: Cow<'static, str>,
    /// The check that pins it, if one does.
    pub check: Option<u8>,
}

/// Numbers as they are listed: one topic's functions name themselves and their check once.
#[derive(Clone, Debug, Default)]
pub struct Listing {
    /// The numbers so far.
    pub numbers: Vec<Number>,
    source: &'static str,
    check: Option<u8>,
}

impl Listing {
    /// No numbers.
    pub fn new() -> Self {
        Self::default()
    }

    /// What follows is computed by `source` and pinned by `check`.
    pub fn by(&mut self, source: &'static str, check: Option<u8>) -> &mut Self {
        self.source = source;
        self.check = check;
        self
    }

    /// A number of this name.
    pub fn add(&mut self, id: impl Into<String>, value: f64, about: &'static str) -> &mut Self {
        let (source, check) = (self.source, self.check);
        self.numbers.push(Number { id: id.into(), value, about: about.into(), source: source.into(), check });
        self
    }

    /// The upper triangle of a symmetric matrix as `id.11`, `id.12`, ….
    pub fn symmetric<const N: usize>(&mut self, id: &str, m: &SMatrix<f64, N, N>, about: &'static str) -> &mut Self {
        for (i, j) in (0..N).flat_map(|i| (i..N).map(move |j| (i, j))) {
            self.add(format!("{id}.{}{}", i + 1, j + 1), m[(i, j)], about);
        }
        self
    }

    /// The entries of a vector as `id.1`, `id.2`, ….
    pub fn vector<'a>(
        &mut self,
        id: &str,
        entries: impl IntoIterator<Item = &'a f64>,
        about: &'static str,
    ) -> &mut Self {
        for (i, entry) in entries.into_iter().enumerate() {
            self.add(format!("{id}.{}", i + 1), *entry, about);
        }
        self
    }
}
