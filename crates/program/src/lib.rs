//! A filter as its reader writes it: lines `name = formula` in the chapter's letters, or as numpy, MATLAB and Julia
//! write them.
//!
//! A text is read whole ([`Program::new`]): names and sizes are checked before a number moves, and all faults are told
//! at once, each with its place. Then each step is one call ([`Program::step`]): it takes what the world gives and
//! answers what every line has made. Derivatives are those of dual numbers, factors and angles the core's, and all
//! work is bounded. [`judge`] says whether it is a right filter, beside the core's.

#![no_std]

extern crate alloc;

mod check;
mod fault;
// pub mod judge;
mod matrix;
mod parse;
mod run;
mod size;
mod token;
mod tree;
mod value;
pub mod words;
mod world;

pub use fault::Fault;
pub use matrix::Matrix;
pub use parse::MOST_LINES;
pub use run::Trouble;
pub use value::Value;
pub use world::{Notation, World};

use alloc::string::String;
use alloc::vec::Vec;
use check::Checker;
use fault::{Faults, Place, line_of};
use size::{Found, LETTERS};
use tree::Tree;
use words::Words;
use world::{Letter, P, X};

/// The longest text that is read, in bytes.
pub const MOST_TEXT: usize = 20_000;

/// A program: its text, what is wrong with it, and, where nothing is, how to run it.
#[derive(Clone, Debug)]
pub struct Program {
    text: String,
    world: World,
    notation: Notation,
    names: Vec<String>,
    tree: Tree,
    /// n, p and m, where the text tells them.
    found: Found,
    faults: Vec<Fault>,
    /// The sizes for which it has been found to fit.
    fitted: Option<[usize; 3]>,
}

/// What a line has made.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    /// The line of the text, from 1.
    pub line: u32,
    /// Which of the names, as a number.
    name: usize,
    /// Its value behind the line.
    pub value: Matrix,
}

/// One step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The new estimate, n×1.
    pub x: Matrix,
    /// Its covariance, n×n.
    pub p: Matrix,
    /// ν, where the program makes it.
    pub innovation: Option<Matrix>,
    /// S, where the program makes it.
    pub s: Option<Matrix>,
    /// The gain, where the program makes it.
    pub gain: Option<Matrix>,
    /// What each line has made, in the order of the text.
    pub made: Vec<Made>,
}

/// Why a step was not made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The program has faults, or does not fit a world of these sizes: the first fault.
    Fault(Fault),
    /// A line has no value.
    Trouble(Trouble, Fault),
    /// What is given is not of one system's sizes.
    Given,
}

impl Program {
    /// Reads a text.
    pub fn new(text: &str, world: World, notation: Notation) -> Self {
        let mut faults = Faults::new(text);
        let (mut names, mut tree) = (world.names(notation), Tree::default());
        let mut found = world_sizes(world);
        if text.len() > MOST_TEXT {
            faults.say(Place::default(), "The text is too long: at most 20000 characters are read.");
        } else {
            let tokens = token::tokens(text, &mut faults);
            let mut parser = parse::Parser::new(&tokens, &mut names, world == World::Robot, &mut faults);
            parser.lines();
            tree = parser.tree;
            if tree.lines.is_empty() && faults.is_empty() {
                let words = "The program is empty: its lines make a new estimate and a new covariance of the old ones.";
                faults.say(Place::default(), words);
            } else {
                found = checked(text, &tree, &names, world, notation, found, &mut faults);
            }
        }
        Self { text: text.into(), world, notation, names, tree, found, faults: faults.sorted(), fitted: None }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whose letters it is in.
    pub fn notation(&self) -> Notation {
        self.notation
    }

    /// The world that it is for.
    pub fn world(&self) -> World {
        self.world
    }

    /// What is wrong with it, in the order of the text.
    pub fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// The name that a line makes.
    pub fn name(&self, made: &Made) -> &str {
        &self.names[made.name]
    }

    /// n, p and m, where the text alone tells them: a number in it may say how many states there are.
    pub fn sizes(&self) -> [Option<usize>; 3] {
        [0, 1, 2].map(|letter| self.found.get(letter).map(|size| size as usize))
    }

    /// Makes sure that it fits a system of `sizes` n, p and m.
    ///
    /// # Errors
    /// The first fault, of the text or of its sizes.
    pub fn fit(&mut self, sizes: [usize; 3]) -> Result<(), Fault> {
        if let Some(fault) = self.faults.first() {
            return Err(fault.clone());
        }
        if self.fitted == Some(sizes) {
            return Ok(());
        }
        let mut faults = Faults::new(&self.text);
        let wanted = sizes.map(|size| size as i32);
        for (i, letter) in LETTERS.iter().enumerate() {
            if let Some(known) = self.found.get(i).filter(|known| *known != wanted[i]) {
                let mut words = Words::new("The program is written for ");
                words.text(letter).text(" = ").whole(i64::from(known)).text(", and this system has ");
                words.text(letter).text(" = ").whole(i64::from(wanted[i])).text(".");
                faults.words(self.tree.lines.first().map_or(Place::default(), |line| line.place), &words);
            }
        }
        if faults.is_empty() {
            let found = Found::of(wanted);
            checked(&self.text, &self.tree, &self.names, self.world, self.notation, found, &mut faults);
        }
        match faults.sorted().into_iter().next() {
            Some(fault) => Err(fault),
            None => {
                self.fitted = Some(sizes);
                Ok(())
            }
        }
    }

    /// One step with what the world gives: x, P, u, y, V, W, then F, G, H in a linear world, the landmark and the gate
    /// in the robot's. Nothing is kept from one step to the next.
    ///
    /// # Errors
    /// See [`Stop`].
    pub fn step(&mut self, given: &[Matrix]) -> Result<Step, Stop> {
        let sizes = self.world.sizes(given).ok_or(Stop::Given)?;
        self.fit(sizes).map_err(Stop::Fault)?;
        let mut values = run::given(given, sizes);
        let made = run::run(&self.tree, &mut values, self.names.len());
        let made = made.map_err(|(trouble, line, id)| Stop::Trouble(trouble, self.trouble(trouble, line, id)))?;
        let lines = self.tree.lines.iter().zip(made);
        let made: Vec<Made> = lines.map(|(line, value)| self.made(line, value.m)).collect();
        let output = |letter: Letter| {
            let name = self.names.iter().position(|name| name == self.notation.letter(letter))?;
            made.iter().rev().find(|made| made.name == name).map(|made| made.value.clone())
        };
        let common = || if self.notation == Notation::Common { self.named("y", &made) } else { None };
        Ok(Step {
            x: values[X].m.clone(),
            p: values[P].m.clone(),
            innovation: output(Letter::Innovation).or_else(common),
            s: output(Letter::S),
            gain: output(Letter::Gain),
            made,
        })
    }

    fn named(&self, text: &str, made: &[Made]) -> Option<Matrix> {
        made.iter().rev().find(|made| self.names[made.name] == text).map(|made| made.value.clone())
    }

    fn made(&self, line: &tree::Line, value: Matrix) -> Made {
        Made { line: line_of(&self.text, line.place.from), name: line.name, value }
    }

    fn trouble(&self, trouble: Trouble, line: usize, id: Option<tree::Id>) -> Fault {
        let line = &self.tree.lines[line];
        let place = id.map_or(line.place, |id| self.tree.place(id));
        let mut words = Words::default();
        match trouble {
            Trouble::Singular => words.text("What is divided by here has no inverse."),
            Trouble::NotPositiveDefinite => words.text("The matrix whose root is taken here is not positive definite."),
            Trouble::NotFinite => words.text(&self.names[line.name]).text(" is not finite any more."),
        };
        let mut faults = Faults::new(&self.text);
        faults.words(place, &words);
        let mut sorted = faults.sorted();
        sorted.remove(0)
    }
}

/// n, p and m of a world, where it has its own.
fn world_sizes(world: World) -> Found {
    if world == World::Robot { Found::of([3, 2, 2]) } else { Found::default() }
}

fn checked(
    text: &str,
    tree: &Tree,
    names: &[String],
    world: World,
    notation: Notation,
    found: Found,
    faults: &mut Faults<'_>,
) -> Found {
    let shapes = Vec::new();
    let (products, within_jacobian, line) = (0, false, 0);
    let mut checker =
        Checker { text, tree, names, world, notation, found, faults, shapes, products, within_jacobian, line };
    checker.check();
    checker.found
}

#[cfg(test)]
mod tests;
