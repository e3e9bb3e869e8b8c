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
pub mod judge;
mod letters;
mod matrix;
mod parse;
mod run;
mod shaped;
mod size;
mod token;
mod tree;
mod value;
pub mod words;
mod world;

pub use fault::Fault;
pub use letters::{given, relettered};
pub use matrix::Matrix;
pub use parse::MOST_LINES;
pub use run::Trouble;
pub use shaped::{Formula, Statement};
pub use world::{Letter as Quantity, Notation, World};

use alloc::rc::Rc;
use alloc::string::String;
use alloc::vec::Vec;
use check::Checker;
use core::cell::Cell;
use fault::{Faults, Place, line_of};
use run::Run;
use size::{Found, LETTERS};
use tree::Tree;
use value::Value;
use words::Words;

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
    /// Where in the text each line of the tree is, from 1.
    lines: Vec<u32>,
    /// n, p and m, where the text tells them.
    found: Found,
    faults: Vec<Fault>,
    /// The sizes for which it has been found to fit, and the values of I, n, p, m and π there.
    fitted: Option<[usize; 3]>,
    constants: Vec<Rc<Value>>,
}

/// What a line has made.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    /// The line of the text, from 1.
    pub line: u32,
    /// Which of the names, as a number.
    name: usize,
    value: Rc<Value>,
}

impl Made {
    /// The name's value behind the line.
    pub fn value(&self) -> &Matrix {
        &self.value.m
    }
}

/// One step: what each line has made, in the order of the text.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Line by line.
    pub made: Vec<Made>,
    /// n, p and m.
    sizes: [usize; 3],
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
            let tokens = token::tokens(text, &mut names, &mut faults);
            let mut parser = parse::Parser::new(&tokens, &mut names, world == World::Robot, &mut faults);
            parser.lines();
            tree = parser.tree;
            if tree.lines.is_empty() && faults.is_empty() {
                let words = "The program is empty: its lines make a new estimate and a new covariance of the old ones.";
                faults.say(Place::default(), words);
            } else {
                found = checked(text, &tree, &names, world, notation, found, &mut faults).found;
            }
        }
        let lines = tree.lines.iter().map(|line| line_of(text, line.place.from)).collect();
        let (text, faults) = (text.into(), faults.sorted());
        Self { text, world, notation, names, tree, lines, found, faults, fitted: None, constants: Vec::new() }
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

    /// What a quantity is called in its letters.
    pub fn letter(&self, quantity: Quantity) -> &'static str {
        self.notation.letter(quantity)
    }

    /// What is wrong with it, in the order of the text.
    pub fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// The name that a line makes.
    pub fn name(&self, made: &Made) -> &str {
        &self.names[made.name]
    }

    /// What its lines make, each name once, in the order of the text.
    pub fn makes(&self) -> Vec<String> {
        let mut made: Vec<String> = Vec::new();
        for line in &self.tree.lines {
            let name = &self.names[line.name];
            if line.value.is_some() && !made.contains(name) {
                made.push(name.clone());
            }
        }
        made
    }

    /// n, p and m, where the text alone tells them: a number in it may say how many states there are.
    pub fn sizes(&self) -> [Option<usize>; 3] {
        [0, 1, 2].map(|letter| usize::try_from(self.found.0[letter]).ok())
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
        checked(&self.text, &self.tree, &self.names, self.world, self.notation, Found(wanted), &mut faults);
        // By itself the text is right: what it says of sizes is another than the system's. Where a number takes the
        // place of a column, no formula shows it.
        let mut words = Words::default();
        for (i, letter) in LETTERS.iter().enumerate() {
            let known = self.found.0[i];
            if known >= 0 && known != wanted[i] {
                words.text("The program is written for ").text(letter).text(" = ").whole(i64::from(known));
                words.text(", and this system has ").text(letter).text(" = ").whole(i64::from(wanted[i])).text(". ");
            }
        }
        match faults.sorted().into_iter().next() {
            Some(mut fault) => {
                fault.message = words.text(&fault.message).0.clone();
                Err(fault)
            }
            None if !words.0.is_empty() => {
                words.0.pop();
                let place = self.tree.lines.first().map_or(Place::default(), |line| line.place);
                Err(fault::shown(&self.text, place, words.0))
            }
            None => {
                self.fitted = Some(sizes);
                self.constants.clear();
                World::constants(sizes, &mut self.constants);
                Ok(())
            }
        }
    }

    /// One step with what the world gives: x, P, u, y, V, W, then F, G, H in a linear world, the landmark and the gate
    /// in the robot's. Nothing is kept from one step to the next.
    ///
    /// # Errors
    /// See [`Stop`].
    pub fn step(&mut self, given: Vec<Matrix>) -> Result<Step, Stop> {
        let sizes = self.world.sizes(&given).ok_or(Stop::Given)?;
        self.fit(sizes).map_err(Stop::Fault)?;
        let mut values = Vec::with_capacity(self.names.len());
        for m in given {
            values.push(Rc::new(Value::from(m)));
        }
        values.extend_from_slice(&self.constants);
        values.resize(self.names.len(), values[0].clone());
        let mut made = Vec::with_capacity(self.tree.lines.len());
        for (line, number) in self.tree.lines.iter().zip(&self.lines) {
            let Some(id) = line.value else { continue };
            let trouble = Cell::new((Trouble::NotFinite, id));
            let run = Run { tree: &self.tree, values: &values, varied: None, trouble: &trouble };
            let Some(value) = run.value(id) else {
                let (trouble, id) = trouble.get();
                return Err(self.trouble(trouble, line, self.tree.place(id)));
            };
            let filled = line.part.and_then(|part| run::refilled(&run, &values[line.name].m, part, &value.m));
            let value = Rc::new(filled.map_or_else(|| value.into_owned(), Value::from));
            if !numerics::all_finite(&value.m.entries) {
                return Err(self.trouble(Trouble::NotFinite, line, line.place));
            }
            made.push(Made { line: *number, name: line.name, value: value.clone() });
            values[line.name] = value;
        }
        Ok(Step { made, sizes })
    }

    /// What a step has made of a quantity; none where the program has no line for it, or where what it calls so is of
    /// another size.
    pub fn made<'a>(&self, step: &'a Step, quantity: Quantity) -> Option<&'a Matrix> {
        let last = |text: &str| step.made.iter().rev().find(|made| self.names[made.name] == text);
        let found = last(self.notation.letter(quantity));
        // filterpy calls the innovation y.
        let common = self.notation == Notation::Common && quantity == Quantity::Innovation;
        let found = found.or_else(|| last("y").filter(|_| common)).map(Made::value)?;
        World::fits(World::shape_of(quantity), found, step.sizes).then_some(found)
    }

    fn trouble(&self, trouble: Trouble, line: &tree::Line, place: Place) -> Stop {
        let mut words = Words::default();
        match trouble {
            Trouble::Singular => words.text("What is divided by here has no inverse."),
            Trouble::NotPositiveDefinite => words.text("The matrix whose root is taken here is not positive definite."),
            Trouble::NotFinite => words.text(&self.names[line.name]).text(" is not finite any more."),
        };
        Stop::Trouble(trouble, fault::shown(&self.text, place, words.0))
    }
}

/// n, p and m of a world, where it has its own.
fn world_sizes(world: World) -> Found {
    if world == World::Robot { Found([3, 2, 2]) } else { Found::NOTHING }
}

fn checked<'a, 'b>(
    text: &'a str,
    tree: &'a Tree,
    names: &'a [String],
    world: World,
    notation: Notation,
    found: Found,
    faults: &'a mut Faults<'b>,
) -> Checker<'a, 'b> {
    let (shapes, of) = (Vec::new(), Vec::new());
    let (products, within_jacobian, line) = (0, false, 0);
    let mut checker =
        Checker { text, tree, names, world, notation, found, faults, shapes, of, products, within_jacobian, line };
    checker.check();
    checker
}

#[cfg(test)]
mod tests;
