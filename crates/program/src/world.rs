//! What a world gives a program and what it takes, in the letters of three books.

use crate::matrix::Matrix;
use crate::size::{LETTERS, Shape, Size};
use crate::value::Value;
use alloc::string::String;
use alloc::vec::Vec;

/// Whose letters a program is in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Notation {
    /// R is the gain, V and W are the noise.
    #[default]
    Choset,
    /// K is the gain, R and Q are the noise, A, B and C the system.
    Thrun,
    /// K is the gain, Q and R are the noise: Wikipedia's letters, filterpy's and MATLAB's.
    Common,
}

/// The world that a program is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum World {
    /// x(k+1) = F x + G u + v, y = H x + w.
    #[default]
    Linear,
    /// The chapter's robot: f(x, u), and one sighting of a known landmark, h(x, l).
    Robot,
}

/// The quantities that have a letter of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Letter {
    X,
    P,
    U,
    Y,
    V,
    W,
    F,
    G,
    H,
    Innovation,
    S,
    Gain,
}

use Letter as L;

/// Their letters by [`Notation`], and what they are.
const TABLE: [([&str; 3], &str); 12] = [
    (["x", "mu", "x"], "the estimate"),
    (["P", "Sigma", "P"], "the estimate’s covariance"),
    (["u", "u", "u"], "the input"),
    (["y", "z", "z"], "the reading"),
    (["V", "R", "Q"], "the noise of the motion"),
    (["W", "Q", "R"], "the noise of the reading"),
    (["F", "A", "F"], "what a step does to the state"),
    (["G", "B", "B"], "what an input does"),
    (["H", "C", "H"], "what a reading tells"),
    (["nu", "nu", "nu"], "the innovation"),
    (["S", "S", "S"], "the innovation’s covariance"),
    (["R", "K", "K"], "the gain"),
];

const LINEAR: [Letter; 9] = [L::X, L::P, L::U, L::Y, L::V, L::W, L::F, L::G, L::H];
const ROBOT: [Letter; 6] = [L::X, L::P, L::U, L::Y, L::V, L::W];

impl Notation {
    pub(crate) fn letter(self, letter: Letter) -> &'static str {
        TABLE[letter as usize].0[self as usize]
    }

    /// "Choset’s letters".
    pub(crate) fn whose(self) -> &'static str {
        ["Choset’s letters", "Thrun’s letters", "the common letters"][self as usize]
    }

    /// What a name means in letters that this notation has not: whose they are, what it is, and its name here.
    pub(crate) fn foreign(self, name: &str) -> Option<(&'static str, &'static str, &'static str)> {
        let others = [Self::Choset, Self::Thrun, Self::Common].into_iter().filter(|other| *other != self);
        others.into_iter().find_map(|other| {
            let (letters, meaning) = TABLE.iter().find(|(letters, _)| letters[other as usize] == name)?;
            Some((other.whose(), *meaning, letters[self as usize]))
        })
    }
}

/// Where the first names are found among all.
pub(crate) const X: usize = 0;
pub(crate) const P: usize = 1;
/// The robot's landmark.
const LANDMARK: usize = ROBOT.len();

impl World {
    fn letters(self) -> &'static [Letter] {
        match self {
            Self::Linear => &LINEAR,
            Self::Robot => &ROBOT,
        }
    }

    /// The names that are given: those of the world, then I, n, p, m and π.
    pub(crate) fn names(self, notation: Notation) -> Vec<String> {
        let letters = self.letters().iter().map(|letter| notation.letter(*letter));
        let own: &[&str] = if self == Self::Robot { &["l", "gate"] } else { &[] };
        let names = letters.chain(own.iter().copied()).chain(["I"]).chain(LETTERS).chain(["pi", "π"]);
        names.map(String::from).collect()
    }

    /// How many names are the world's own, before I, n, p, m and π.
    pub(crate) fn own(self) -> usize {
        self.letters().len() + if self == Self::Robot { 2 } else { 0 }
    }

    /// The name that stands for n, p or m, if it is one.
    pub(crate) fn size_letter(self, name: usize) -> Option<usize> {
        name.checked_sub(self.own() + 1).filter(|letter| *letter < LETTERS.len())
    }

    pub(crate) fn shape_of(letter: Letter) -> Shape {
        let [n, p, m] = [0, 1, 2].map(Size::letter);
        let (rows, columns) = match letter {
            L::X => (n, Size::ONE),
            L::P | L::V | L::F => (n, n),
            L::U => (m, Size::ONE),
            L::Y | L::Innovation => (p, Size::ONE),
            L::W | L::S => (p, p),
            L::G => (n, m),
            L::H => (p, n),
            L::Gain => (n, p),
        };
        Shape::Of(rows, columns)
    }

    /// The shape of each name that is given.
    pub(crate) fn shapes(self) -> Vec<Shape> {
        let own: &[Shape] = match self {
            Self::Linear => &[],
            Self::Robot => &[Shape::Of(Size::number(2), Size::ONE), Shape::NUMBER],
        };
        let letters = self.letters().iter().map(|letter| Self::shape_of(*letter));
        letters.chain(own.iter().copied()).chain([Shape::Identity]).chain([Shape::NUMBER; 5]).collect()
    }

    /// The values of I, n, p, m and π.
    pub(crate) fn constants(sizes: [usize; 3]) -> impl Iterator<Item = Value> {
        let one = Value { identity: true, ..Value::number(1.0) };
        let pi = core::f64::consts::PI;
        core::iter::once(one).chain(sizes.map(|size| size as f64).into_iter().chain([pi, pi]).map(Value::number))
    }

    /// n, p and m of what is given; none where they do not fit one another.
    pub(crate) fn sizes(self, given: &[Matrix]) -> Option<[usize; 3]> {
        let sizes = [given.first()?.rows, given.get(3)?.rows, given.get(2)?.rows];
        let side = |size: Size| {
            let letters = (0..3).map(|i| size.letters[i] * sizes[i] as i32);
            (size.number + letters.sum::<i32>()) as usize
        };
        let fits = |(shape, m): (Shape, &Matrix)| match shape {
            Shape::Of(rows, columns) => (m.rows, m.columns) == (side(rows), side(columns)),
            _ => false,
        };
        (given.len() == self.own() && self.shapes().into_iter().zip(given).all(fits)).then_some(sizes)
    }
}

/// The robot's f and h, on numbers with a derivative.
pub(crate) mod robot {
    use super::{LANDMARK, Matrix, Value};

    const _: () = assert!(LANDMARK == 6);

    type Dual = (f64, f64);

    fn entry(of: &Value, i: usize) -> Dual {
        (of.m.at(i, 0), of.d.as_ref().map_or(0.0, |d| d.at(i, 0)))
    }

    fn column(entries: &[Dual], varied: bool) -> Value {
        let part = |pick: fn(&Dual) -> f64| Matrix::new(entries.len(), 1, entries.iter().map(pick).collect());
        Value { m: part(|e| e.0), d: varied.then(|| part(|e| e.1)), identity: false }
    }

    /// f(x, u): along the old heading, then the turn.
    pub fn motion(x: &Value, u: &Value) -> Value {
        let [(px, dpx), (py, dpy), (heading, dheading)] = [0, 1, 2].map(|i| entry(x, i));
        let [(s, ds), (turn, dturn)] = [0, 1].map(|i| entry(u, i));
        let (sin, cos) = libm::sincos(heading);
        let moved = [
            (px + s * cos, dpx + ds * cos - s * sin * dheading),
            (py + s * sin, dpy + ds * sin + s * cos * dheading),
            (geom::wrap(heading + turn), dheading + dturn),
        ];
        column(&moved, x.d.is_some() || u.d.is_some())
    }

    /// h(x, l): range and bearing, the bearing from the landmark.
    pub fn sensor(x: &Value, l: &Value) -> Value {
        let off = [0, 1].map(|i| {
            let ((a, da), (b, db)) = (entry(x, i), entry(l, i));
            (a - b, da - db)
        });
        let [(dx, ddx), (dy, ddy)] = off;
        let (heading, dheading) = entry(x, 2);
        let range = numerics::hypot(dx, dy);
        let square = range * range;
        let seen = [
            (range, (dx * ddx + dy * ddy) / range),
            (geom::wrap(libm::atan2(dy, dx) - heading), (dx * ddy - dy * ddx) / square - dheading),
        ];
        column(&seen, x.d.is_some() || l.d.is_some())
    }
}
