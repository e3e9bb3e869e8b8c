//! The cases on which filters are compared: correlated covariances, several readings, small noise, readings far off,
//! and for the robot headings and bearings near ±π. They are made of a fixed sequence, so they are always the same.

use crate::run::{cos, sin};
use crate::{Matrix, World};
use alloc::vec;
use alloc::vec::Vec;

/// n, p and m of the linear cases.
const SIZES: [[usize; 3]; 12] = [
    [2, 1, 1],
    [3, 2, 1],
    [2, 2, 2],
    [4, 3, 1],
    [1, 1, 1],
    [3, 1, 0],
    [2, 1, 1],
    [4, 2, 2],
    [3, 3, 1],
    [2, 2, 1],
    [5, 2, 1],
    [3, 1, 2],
];

/// Numbers from −1 to 1, the same on every machine.
struct Sequence(u32);

impl Sequence {
    fn next(&mut self) -> f64 {
        // Of 24 bits, which Numerical Recipes' constants mix well enough for a case.
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(self.0 >> 8) / f64::from(1_u32 << 23) - 1.0
    }

    fn matrix(&mut self, rows: usize, columns: usize, scale: f64) -> Matrix {
        let mut entries = Vec::with_capacity(rows * columns);
        for _ in 0..rows * columns {
            entries.push(scale * self.next());
        }
        Matrix::new(rows, columns, entries)
    }

    /// A covariance whose entries all differ from 0.
    fn covariance(&mut self, n: usize, scale: f64) -> Matrix {
        let root = self.matrix(n, n, 1.0);
        let square = root.times(&root.transposed()).plus(0.3, &Matrix::identity(n)).scaled(scale);
        square.scaled(0.5).plus(0.5, &square.transposed())
    }

    /// Readings are independent of one another, so that they may be used one by one.
    fn diagonal(&mut self, n: usize, scale: f64) -> Matrix {
        let mut m = Matrix::zeros(n, n);
        for i in 0..n {
            m.entries[i * (n + 1)] = scale * (0.6 + 0.4 * self.next());
        }
        m
    }
}

/// The cases of a world, each what is given to a step. In a linear world those sizes hold that a program is written
/// for.
pub fn cases(world: World, written_for: [Option<usize>; 3]) -> Vec<Vec<Matrix>> {
    let mut all = Vec::with_capacity(SIZES.len());
    for (i, sizes) in SIZES.into_iter().enumerate() {
        let mut dice = Sequence(7 + i as u32);
        // Small noise, and a reading far off.
        let noise = if i % 4 == 1 { 1e-3 } else { 1.0 };
        let far = if i % 4 == 2 { 40.0 } else { 1.0 };
        all.push(match world {
            World::Linear => linear(&mut dice, [0, 1, 2].map(|k| written_for[k].unwrap_or(sizes[k])), noise, far),
            World::Robot => robot(&mut dice, i, noise, far),
        });
    }
    all
}

fn linear(dice: &mut Sequence, [n, p, m]: [usize; 3], noise: f64, far: f64) -> Vec<Matrix> {
    vec![
        dice.matrix(n, 1, 3.0),
        dice.covariance(n, 2.0),
        dice.matrix(m, 1, 1.0),
        dice.matrix(p, 1, 3.0 * far),
        dice.covariance(n, 0.4),
        dice.diagonal(p, 1.5 * noise),
        dice.matrix(n, n, 1.0),
        dice.matrix(n, m, 1.0),
        dice.matrix(p, n, 1.0),
    ]
}

/// Headings near ±π in every third case, bearings near ±π in every other.
fn robot(dice: &mut Sequence, i: usize, noise: f64, far: f64) -> Vec<Matrix> {
    let pi = core::f64::consts::PI;
    let (turning, behind) = (i.is_multiple_of(3), i.is_multiple_of(2));
    let heading = if turning { pi - 0.02 } else { 2.5 * dice.next() };
    let [x, y] = [dice.next(), dice.next()];
    let (s, turn) = (0.6 + 0.2 * dice.next(), if turning { 0.019 } else { 0.4 * dice.next() });
    let moved = [x + s * cos(heading), y + s * sin(heading), geom::wrap(heading + turn)];
    // From this landmark the robot is seen at that bearing.
    let bearing = if behind { geom::wrap(pi + 0.02 * dice.next()) } else { 2.0 * dice.next() };
    let (range, direction) = (2.5 + dice.next(), bearing + moved[2]);
    let mark = [moved[0] - range * cos(direction), moved[1] - range * sin(direction)];
    let off = if behind { -libm::copysign(0.3, bearing) } else { 0.05 * dice.next() };
    // Past ±π the reading comes out at the other end, where an innovation that is not wrapped is off by a turn.
    let read = [range + 0.1 * far * dice.next(), geom::wrap(bearing - off)];
    vec![
        Matrix::column(&[x, y, heading]),
        dice.covariance(3, 0.05),
        Matrix::column(&[s, turn]),
        Matrix::column(&read),
        dice.covariance(3, 0.002),
        Matrix::new(2, 2, vec![0.01 * noise, 0.0, 0.0, 0.0009 * noise]),
        Matrix::column(&mark),
        Matrix::column(&[9.21]),
    ]
}

/// The chapter's example of a form that breaks: a prior of 10²⁴ I, and a reading of the first state with W = 0.04. None
/// in the robot's world.
pub(super) fn knowing_nothing(world: World, written_for: [Option<usize>; 3]) -> Option<Vec<Matrix>> {
    let [n, p, m] = [0, 1, 2].map(|k| written_for[k].unwrap_or([2, 1, 1][k]));
    if world == World::Robot || p > n {
        return None;
    }
    let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
    let zeros = Matrix::zeros;
    let (p0, w) = (Matrix::identity(n).scaled(1e24), Matrix::identity(p).scaled(0.04));
    let h = Matrix::made(p, n, &unit);
    Some(vec![zeros(n, 1), p0, zeros(m, 1), zeros(p, 1), zeros(n, n), w, Matrix::identity(n), zeros(n, m), h])
}
