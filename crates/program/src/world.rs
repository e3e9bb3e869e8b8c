//! What a world gives a program and what it takes, in the letters of three books.

use crate::matrix::Matrix;
use crate::size::{Inferred, LETTERS, Shape, Size};
use crate::value::Value;
use crate::words::Words;
use alloc::rc::Rc;
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

/// The quantities that have a letter of their own, in Choset's letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letter {
    /// The estimate.
    X,
    /// Its covariance.
    P,
    /// The input.
    U,
    /// The reading.
    Y,
    /// The covariance of the motion's noise.
    V,
    /// That of the reading's.
    W,
    /// What a step does to the state.
    F,
    /// What an input does.
    G,
    /// What a reading tells.
    H,
    /// ν.
    Innovation,
    /// Its covariance.
    S,
    /// The gain.
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
/// How many of them the robot's world gives.
const ROBOT: usize = 6;
/// States, readings or inputs of a system.
const MOST_STATES: usize = 16;

impl Letter {
    pub(crate) const ALL: [Self; 12] =
        [L::X, L::P, L::U, L::Y, L::V, L::W, L::F, L::G, L::H, L::Innovation, L::S, L::Gain];

    pub(crate) fn meaning(self) -> &'static str {
        TABLE[self as usize].1
    }
}

impl Notation {
    pub(crate) fn letter(self, letter: Letter) -> &'static str {
        TABLE[letter as usize].0[self as usize]
    }

    /// "Choset’s letters".
    pub(crate) fn whose(self) -> &'static str {
        ["Choset’s letters", "Thrun’s letters", "the common letters"][self as usize]
    }

    /// Says what a name means in other letters, and its name here; whether it means anything there.
    pub(crate) fn say_foreign(self, name: &str, words: &mut Words) -> bool {
        let (mut said, mut before) = (false, "");
        for other in [Self::Choset, Self::Thrun, Self::Common] {
            let meant = TABLE.iter().find(|(letters, _)| letters[other as usize] == name);
            let Some((letters, meaning)) = meant.filter(|(letters, _)| other != self && letters[self as usize] != name)
            else {
                continue;
            };
            if *meaning == before {
                words.text(", and so in ").text(other.whose());
                continue;
            }
            words.text(if said { "; " } else { "" }).text(meaning).text(" in ").text(other.whose());
            words.text(", here ").text(letters[self as usize]);
            (said, before) = (true, meaning);
        }
        said
    }
}

/// Where the first names are found among all.
pub(crate) const X: usize = 0;
pub(crate) const P: usize = 1;
impl World {
    pub(crate) fn letters(self) -> &'static [Letter] {
        match self {
            Self::Linear => &LINEAR,
            Self::Robot => &LINEAR[..ROBOT],
        }
    }

    /// The names that are given: those of the world, then I, n, p, m and π.
    pub(crate) fn names(self, notation: Notation) -> Vec<String> {
        let mut names = Vec::new();
        for letter in self.letters() {
            names.push(notation.letter(*letter).into());
        }
        for name in ["l", "gate", "I", LETTERS[0], LETTERS[1], LETTERS[2], "pi", "π"] {
            if self == Self::Robot || name.len() != 4 && name != "l" {
                names.push(name.into());
            }
        }
        names
    }

    /// How many names are the world's own, and where I is, before n, p, m and π.
    pub(crate) fn identity(self) -> usize {
        match self {
            Self::Linear => LINEAR.len(),
            Self::Robot => ROBOT + 2,
        }
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

    /// The shape of the name that is given as this one: of a letter, or of the landmark and the gate.
    fn shape(self, at: usize) -> Shape {
        match self.letters().get(at) {
            Some(letter) => Self::shape_of(*letter),
            None if at == ROBOT => Shape::Of(Size::number(2), Size::ONE),
            None => Shape::NUMBER,
        }
    }

    /// The shape of each name that is given.
    pub(crate) fn shapes(self, shapes: &mut Vec<Option<Shape>>) {
        for at in 0..self.identity() {
            shapes.push(Some(self.shape(at)));
        }
        shapes.push(Some(Shape::Identity));
        shapes.resize(shapes.len() + 5, Some(Shape::NUMBER));
    }

    /// Appends the values of I, n, p, m and π.
    pub(crate) fn constants(sizes: [usize; 3], values: &mut Vec<Rc<Value>>) {
        let [n, p, m] = sizes.map(|size| size as f64);
        let pi = core::f64::consts::PI;
        for (i, constant) in [1.0, n, p, m, pi, pi].into_iter().enumerate() {
            values.push(Rc::new(Value { identity: i == 0, ..Value::number(constant) }));
        }
    }

    /// Whether a matrix has a shape, for n, p and m.
    pub(crate) fn fits(shape: Shape, m: &Matrix, sizes: [usize; 3]) -> bool {
        let Shape::Of(rows, columns) = shape else { return false };
        let [n, p, inputs] = sizes;
        let found = Inferred([n as i32, p as i32, inputs as i32]);
        found.known(rows) == Some(m.rows as i32) && found.known(columns) == Some(m.columns as i32)
    }

    /// n, p and m of what is given; none where they do not fit one another.
    pub(crate) fn sizes(self, given: &[Matrix]) -> Option<[usize; 3]> {
        let sizes = [given.first()?.rows, given.get(3)?.rows, given.get(2)?.rows];
        if given.len() != self.identity() || sizes.iter().any(|size| *size > MOST_STATES) {
            return None;
        }
        for (at, m) in given.iter().enumerate() {
            if !Self::fits(self.shape(at), m, sizes) {
                return None;
            }
        }
        Some(sizes)
    }
}

/// The robot's f and h, on numbers with a derivative.
pub(crate) mod robot {
    use super::{Matrix, Value};

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
