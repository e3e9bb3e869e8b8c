//! The last few hundred values of a number over time: a long run needs no more memory than a short one.

use crate::record;
use crate::shape::{Plain, Shape};
use std::collections::VecDeque;

/// How far a position that is left out may lie from the outline, metres.
const NEAR: f64 = 1e-3;
/// How many of the last values a series keeps, if not stated otherwise.
pub const WINDOW: usize = 240;

/// Appends a value to a window of at most `most`, dropping the oldest when it is full.
pub fn keep<T>(window: &mut VecDeque<T>, value: T, most: usize) {
    if window.len() == most {
        window.pop_front();
    }
    window.push_back(value);
}

/// [`keep`], once for all series.
#[inline(never)]
fn keep_number(window: &mut VecDeque<f64>, value: f64, most: usize) {
    keep(window, value, most);
}

/// The last values of a number, oldest first: at most `MOST` of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series<const MOST: usize = WINDOW>(VecDeque<f64>);

impl<const MOST: usize> Plain for Series<MOST> {
    const SHAPE: Shape = VecDeque::<f64>::SHAPE;

    fn write(&self, to: &mut Vec<f64>) {
        self.0.write(to);
    }
}

impl<const MOST: usize> Series<MOST> {
    /// Appends a value, dropping the oldest when the window is full.
    pub fn push(&mut self, value: f64) {
        keep_number(&mut self.0, value, MOST);
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

record! {
    /// The course of something that moves, oldest position first.
    #[derive(Default)]
    pub struct Track {
        /// Metres.
        pub x: VecDeque<f64>,
        /// Metres.
        pub y: VecDeque<f64>,
    }

    /// Where the robot was and where it believed to be; positions within a millimetre of the lines between others are
    /// left out.
    #[derive(Default)]
    pub struct Tracks {
        /// True positions.
        pub truth: Track,
        /// Estimated positions.
        pub estimate: Track,
    }
}

impl Track {
    /// Appends a position, dropping the oldest where there are `most`.
    pub fn push(&mut self, x: f64, y: f64, most: usize) {
        keep_number(&mut self.x, x, most);
        keep_number(&mut self.y, y, most);
    }

    /// The same course in fewer positions, the first and the last among them. Each that is left out lies within a
    /// millimetre of the lines between those kept, a small part of a pixel in every figure (Ramer 1972; Douglas and
    /// Peucker 1973).
    pub fn outlined(&self) -> Self {
        let points: Vec<[f64; 2]> = self.x.iter().zip(&self.y).map(|(x, y)| [*x, *y]).collect();
        let mut kept = vec![false; points.len()];
        let mut open = Vec::new();
        if let Some(last) = points.len().checked_sub(1) {
            (kept[0], kept[last]) = (true, true);
            open.push((0, last));
        }
        while let Some((from, to)) = open.pop() {
            let (mut farthest, mut most) = (None, NEAR * NEAR);
            for i in from + 1..to {
                let distance = squared_distance(points[i], points[from], points[to]);
                if distance > most {
                    (farthest, most) = (Some(i), distance);
                }
            }
            if let Some(i) = farthest {
                kept[i] = true;
                open.extend([(from, i), (i, to)]);
            }
        }
        let of = |a: usize| points.iter().zip(&kept).filter(|(_, kept)| **kept).map(|(point, _)| point[a]).collect();
        Self { x: of(0), y: of(1) }
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

/// The squared distance from `p` to the straight line between `a` and `b`.
fn squared_distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length = along[0] * along[0] + along[1] * along[1];
    let part = if length > 0.0 { ((to[0] * along[0] + to[1] * along[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
    let off = [to[0] - part * along[0], to[1] - part * along[1]];
    off[0] * off[0] + off[1] * off[1]
}

impl Tracks {
    /// Both courses as a frame carries them; see [`Track::outlined`].
    pub fn outlined(&self) -> Self {
        Self { truth: self.truth.outlined(), estimate: self.estimate.outlined() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track(points: impl IntoIterator<Item = [f64; 2]>) -> Track {
        let mut track = Track::default();
        points.into_iter().for_each(|[x, y]| track.push(x, y, 1000));
        track
    }

    #[test]
    fn an_outline_has_the_corners_and_misses_nothing() {
        // Along a side, back half of it, around a corner.
        let legs: [([f64; 2], [f64; 2]); 3] =
            [([0.0, 0.0], [0.1, 0.0]), ([2.0, 0.0], [-0.1, 0.0]), ([1.0, 0.0], [0.0, 0.1])];
        let steps = [20, 10, 30];
        let at = |leg: usize, i: i32| [0, 1].map(|a| legs[leg].0[a] + f64::from(i) * legs[leg].1[a]);
        let points = (0..3).flat_map(|leg| (0..=steps[leg]).map(move |i| at(leg, i)));
        let outline = track(points).outlined();
        let corners: Vec<[f64; 2]> = outline.x.iter().zip(&outline.y).map(|(x, y)| [*x, *y]).collect();
        let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-9;
        let expected = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 3.0]];
        assert!(corners.len() == 4 && corners.iter().zip(expected).all(|(a, b)| near(*a, b)), "{corners:?}");

        let wave = track((0..600).map(|k| [0.05 * f64::from(k), libm::sin(0.02 * f64::from(k))]));
        let outline = wave.outlined();
        assert!(outline.len() < 200, "{} positions", outline.len());
        for (x, y) in wave.x.iter().zip(&wave.y) {
            let off = |i: usize| {
                squared_distance([*x, *y], [outline.x[i], outline.y[i]], [outline.x[i + 1], outline.y[i + 1]])
            };
            let nearest = (0..outline.len() - 1).map(off).fold(f64::INFINITY, f64::min);
            assert!(nearest <= NEAR * NEAR, "{x}, {y}");
        }
        assert_eq!(Track::default().outlined(), Track::default());
        assert_eq!(track([[1.0, 2.0]]).outlined(), track([[1.0, 2.0]]));
        assert_eq!(track([[1.0, 2.0]; 5]).outlined().len(), 2);
    }

    #[test]
    fn the_window_slides() {
        let mut series: Series = Series::default();
        assert!(series.is_empty());
        for k in 0..WINDOW + 3 {
            series.push(k as f64);
        }
        assert_eq!((series.len(), series.iter().next(), series.iter().last()), (WINDOW, Some(3.0), Some(242.0)));
    }
}
