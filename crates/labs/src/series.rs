//! A number over time, its last few hundred values: a long run keeps its memory.

use serde::Serialize;
use std::collections::VecDeque;

/// How many of the last values a series keeps.
pub const WINDOW: usize = 240;

/// Appends a value to a window of at most `most`, dropping the oldest when it is full.
pub(crate) fn keep<T>(window: &mut VecDeque<T>, value: T, most: usize) {
    if window.len() == most {
        window.pop_front();
    }
    window.push_back(value);
}

/// The last [`WINDOW`] values of a number, oldest first.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Series(VecDeque<f64>);

impl Series {
    /// Appends a value, dropping the oldest when the window is full.
    pub fn push(&mut self, value: f64) {
        keep(&mut self.0, value, WINDOW);
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

/// The last positions of something that moves, oldest first.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Track {
    /// Metres.
    pub x: VecDeque<f64>,
    /// Metres.
    pub y: VecDeque<f64>,
}

impl Track {
    pub(crate) fn push(&mut self, x: f64, y: f64, most: usize) {
        keep(&mut self.x, x, most);
        keep(&mut self.y, y, most);
    }

    /// How many positions there are.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.x.is_empty()
    }
}

/// Where the robot was, and where it believed to be.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Tracks {
    /// True positions.
    pub truth: Track,
    /// Estimated positions.
    pub estimate: Track,
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
