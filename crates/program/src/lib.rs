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
mod sign;
mod size;
mod step;
mod time;
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
pub use step::{Made, Step, Stop};
pub use world::{Letter as Quantity, Notation, World};

use alloc::rc::Rc;
use alloc::string::String;
use alloc::vec::Vec;
use check::Checker;
use fault::{Faults, Span, line_of};
use size::{Inferred, LETTERS};
use tree::Tree;
use value::Value;
use words::Words;

/// The longest text that is read, in bytes.
pub const MOST_TEXT: usize = 20_000;

/// A program: its text, what is wrong with it, and, where nothing is, how to run it.
#[derive(Clone, Debug)]
pub struct Program {
    read: Rc<Read>,
    /// The sizes for which it has been found to fit, and the values of I, n, p, m and π there.
    fitted: Option<[usize; 3]>,
    constants: Vec<Rc<Value>>,
}

/// What has been read of a text: copies of a program share it.
#[derive(Debug)]
struct Read {
    text: String,
    world: World,
    notation: Notation,
    names: Vec<String>,
    tree: Tree,
    /// Where in the text each line of the tree is, from 1.
    lines: Vec<u32>,
    /// n, p and m, where the text tells them.
    found: Inferred,
    faults: Vec<Fault>,
    /// Whether all that is wrong is that no line makes a new estimate, or none its covariance.
    lacking: bool,
}

impl Program {
    /// Reads a text.
    pub fn new(text: &str, world: World, notation: Notation) -> Self {
        let mut faults = Faults::new(text);
        let (mut names, mut tree) = (world.names(notation), Tree::default());
        let mut found = world_sizes(world);
        if text.len() > MOST_TEXT {
            faults.say(Span::default(), "The text is too long: at most 20000 characters are read.");
        } else {
            let tokens = token::tokens(text, &mut names, &mut faults);
            let mut parser = parse::Parser::new(&tokens, &mut names, world == World::Robot, &mut faults);
            parser.lines();
            tree = parser.tree;
            if tree.lines.is_empty() && faults.is_empty() {
                let words = "The program is empty: its lines make a new estimate and a new covariance of the old ones.";
                faults.say(Span::default(), words);
            } else {
                found = checked(text, &tree, &names, world, notation, found, &mut faults).found;
            }
        }
        let lines = tree.lines.iter().map(|line| line_of(text, line.place.from)).collect();
        let (text, lacking, faults) = (text.into(), faults.lacking, faults.sorted());
        let read = Read { text, world, notation, names, tree, lines, found, faults, lacking };
        Self { read: Rc::new(read), fitted: None, constants: Vec::new() }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.read.text
    }

    /// Whose letters it is in.
    pub fn notation(&self) -> Notation {
        self.read.notation
    }

    /// The world that it is for.
    pub fn world(&self) -> World {
        self.read.world
    }

    /// What a quantity is called in its letters.
    pub fn letter(&self, quantity: Quantity) -> &'static str {
        self.read.notation.letter(quantity)
    }

    /// What is wrong with it, in the order of the text.
    pub fn faults(&self) -> &[Fault] {
        &self.read.faults
    }

    /// What its lines make, each name once, in the order of the text.
    pub fn makes(&self) -> Vec<String> {
        let mut made: Vec<String> = Vec::new();
        for line in &self.read.tree.lines {
            let name = &self.read.names[line.name];
            if line.value.is_some() && !made.contains(name) {
                made.push(name.clone());
            }
        }
        made
    }

    /// n, p and m, where the text alone tells them: a number in it may say how many states there are.
    pub fn sizes(&self) -> [Option<usize>; 3] {
        [0, 1, 2].map(|letter| usize::try_from(self.read.found.0[letter]).ok())
    }

    /// Makes sure that it fits a system of `sizes` n, p and m.
    ///
    /// # Errors
    /// The first fault, of the text or of its sizes.
    pub fn fit(&mut self, sizes: [usize; 3]) -> Result<(), Fault> {
        if let Some(fault) = self.read.faults.first() {
            return Err(fault.clone());
        }
        if self.fitted == Some(sizes) {
            return Ok(());
        }
        let mut faults = Faults::new(&self.read.text);
        let wanted = sizes.map(|size| size as i32);
        checked(
            &self.read.text,
            &self.read.tree,
            &self.read.names,
            self.read.world,
            self.read.notation,
            Inferred(wanted),
            &mut faults,
        );
        // By itself the text is right: what it says of sizes is another than the system's. Where a number takes the
        // place of a column, no formula shows it.
        let mut words = Words::default();
        for (i, letter) in LETTERS.iter().enumerate() {
            let known = self.read.found.0[i];
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
                let place = self.read.tree.lines.first().map_or(Span::default(), |line| line.place);
                Err(fault::shown(&self.read.text, place, words.0))
            }
            None => {
                self.fitted = Some(sizes);
                self.constants.clear();
                World::constants(sizes, &mut self.constants);
                Ok(())
            }
        }
    }
}

/// n, p and m of a world, where it has its own.
fn world_sizes(world: World) -> Inferred {
    if world == World::Robot { Inferred([3, 2, 2]) } else { Inferred::NOTHING }
}

fn checked<'a, 'b>(
    text: &'a str,
    tree: &'a Tree,
    names: &'a [String],
    world: World,
    notation: Notation,
    found: Inferred,
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
