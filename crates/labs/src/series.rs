//! A number over time, its last few hundred values: a long run keeps its memory.

use serde::Serialize;
use std::collections::VecDeque;

/// How many of the last values a series keeps.
pub const WINDOW: usize = 240;

/// The last [`WINDOW`] values of a number, oldest first.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Series(VecDeque<f64>);

impl Series {
    /// Appends a value, dropping the oldest when the window is full.
    pub fn push(&mut self, value: f64) {
        if self.0.len() == WINDOW {
            self.0.pop_front();
        }
        self.0.push_back(value);
    }

    /// How many values there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The values, oldest first.
    pub fn iter(&self) -> impl Iterator<Item = f64> + '_ {
        self.0.iter().copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_window_slides() {
        let mut series = Series::default();
        assert!(series.is_empty());
        for k in 0..WINDOW + 3 {
            series.push(k as f64);
        }
        assert_eq!((series.len(), series.iter().next(), series.iter().last()), (WINDOW, Some(3.0), Some(242.0)));
    }
}
