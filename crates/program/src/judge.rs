//! Whether a program is a right filter: one step beside a right filter's on a dozen cases, and beside what the museum's
//! bugs make of the same cases.
//!
//! The right filter is the chapter's step with Joseph's form, as a program of this language; a test holds it to the
//! core's on all cases. A text is never compared: whatever gives the same numbers is right, in any form.

mod bugs;
mod cases;
mod forms;
mod sentences;
mod unfinished;

pub use bugs::Bug;
pub use cases::cases;
pub use forms::{divides, has_gain};

use crate::words::Words;
use crate::{Made, Matrix, Notation, Program, Quantity, Step, Stop, World};
use alloc::string::String;
use alloc::vec::Vec;
use sentences::{is_bug, is_right, is_wrong};

/// Two matrices are equal that differ by no more than this part of the largest entry.
const TOLERANCE: f64 = 1e-8;

/// What a program is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It has faults, or no value in one of the cases.
    Refused,
    /// It gives what a right filter gives.
    Right,
    /// It gives what a bug of the museum gives.
    Bug(Bug),
    /// What stands there is right, and no line corrects the estimate or its covariance by the reading yet.
    Unfinished,
    /// It gives something else.
    Wrong,
}

/// What is said of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// What it is.
    pub outcome: Outcome,
    /// The line to look at, from 1, where one can be told.
    pub line: Option<u32>,
    /// Why, in sentences.
    pub sentences: Vec<String>,
    /// Whether a right form loses its digits where the prior knows nothing.
    pub breaks: bool,
}

/// What a right filter's lines make, as a program in Choset's letters.
pub fn right(world: World) -> String {
    bugs::text(world, None)
}

/// The steps of a program on all cases that fit it, by the number of the case.
struct Steps {
    program: Program,
    steps: Vec<(usize, Step)>,
}

impl Steps {
    fn of(mut program: Program, cases: &[Vec<Matrix>]) -> Result<Self, (usize, Stop)> {
        let (mut steps, mut misfit) = (Vec::new(), None);
        for (i, case) in cases.iter().enumerate() {
            match program.step(case.clone()) {
                Ok(step) => steps.push((i, step)),
                // A program for three states is not asked for two.
                Err(stop @ Stop::Fault(_)) => misfit = misfit.or(Some((i, stop))),
                Err(stop) => return Err((i, stop)),
            }
        }
        match misfit {
            Some(misfit) if steps.is_empty() => Err(misfit),
            _ => Ok(Self { program, steps }),
        }
    }

    /// The same for a text that is known to be without faults.
    fn known(world: World, text: &str, cases: &[Vec<Matrix>]) -> Option<Self> {
        Self::of(Program::new(text, world, Notation::Choset), cases).ok()
    }

    fn made(&self, step: usize, quantity: Quantity) -> Option<&Matrix> {
        self.program.made(&self.steps[step].1, quantity)
    }

    /// What the lines of a name have made on a case.
    fn line(&self, case: usize, name: &str) -> Option<&Matrix> {
        let (_, step) = &self.steps[self.on(case)?];
        step.made.iter().find(|made| self.program.name(made) == name).map(Made::value)
    }

    /// Its step on a case.
    fn on(&self, case: usize) -> Option<usize> {
        self.steps.iter().position(|(at, _)| *at == case)
    }
}

/// How far two matrices are apart, as a part of the largest entry; more than all where they are of another size.
fn apart(a: &Matrix, b: &Matrix) -> f64 {
    if (a.rows, a.columns) != (b.rows, b.columns) {
        return f64::INFINITY;
    }
    let largest = b.entries.iter().fold(0.0, |all: f64, x| all.max(libm::fabs(*x)));
    let off = a.entries.iter().zip(&b.entries).fold(0.0, |all: f64, (a, b)| all.max(libm::fabs(a - b)));
    if off == 0.0 { 0.0 } else { off / largest.max(f64::MIN_POSITIVE) }
}

/// The judgement of a program.
pub fn judge(program: &Program) -> Verdict {
    let world = program.world();
    if let Some(fault) = program.faults().first() {
        let verdict = refused(fault.line, fault.message.clone());
        // What is missing is no line's fault.
        return if program.read.lacking { Verdict { line: None, ..verdict } } else { verdict };
    }
    let cases = cases(world, program.sizes());
    let theirs = match Steps::of(program.clone(), &cases) {
        Ok(steps) => steps,
        Err((case, Stop::Trouble(_, fault))) => {
            let mut words = Words::new("In case ");
            words.whole(case as i64 + 1).text(" of ").whole(cases.len() as i64).text(" this line has no value: ");
            return refused(fault.line, words.text(&fault.message).0.clone());
        }
        Err((_, Stop::Fault(fault))) => return refused(fault.line, fault.message),
        Err((_, Stop::Given)) => return refused(1, String::from("No case is of the program’s sizes.")),
    };
    let Some(ours) = Steps::known(world, &right(world), &cases) else {
        return refused(1, String::from("The right filter has no value."));
    };
    let Some(off) = first_off(&theirs, &ours) else { return is_right(&theirs, &ours, cases.len()) };
    let (lacks, unfinished) = unfinished::judged(&theirs, &ours);
    if let Some(verdict) = unfinished {
        return verdict;
    }
    for bug in Bug::of(world) {
        for text in bugs::texts(world, *bug) {
            let Some(mutant) = Steps::known(world, &text, &cases) else { continue };
            if first_off(&theirs, &mutant).is_none() {
                return is_bug(*bug, &theirs, &ours, &mutant, &off);
            }
        }
    }
    // What is not corrected yet is right so far: the other is off.
    let other = if lacks == [Quantity::X] { self::off(&theirs, &ours, Quantity::P) } else { None };
    let mut verdict = is_wrong(&theirs, &ours, &other.unwrap_or(off));
    if !lacks.is_empty() {
        verdict.sentences.push(unfinished::said(&theirs, &lacks, "No line corrects "));
    }
    verdict
}

fn refused(line: u32, sentence: String) -> Verdict {
    Verdict { outcome: Outcome::Refused, line: Some(line), sentences: alloc::vec![sentence], breaks: false }
}

/// An entry that is off: which quantity, in which step of theirs, and where.
struct Off {
    quantity: Quantity,
    step: usize,
    at: (usize, usize),
    theirs: f64,
    ours: f64,
}

/// The first of the answers that another filter does not give.
fn first_off(theirs: &Steps, ours: &Steps) -> Option<Off> {
    [Quantity::X, Quantity::P].into_iter().find_map(|quantity| off(theirs, ours, quantity))
}

fn off(theirs: &Steps, ours: &Steps, quantity: Quantity) -> Option<Off> {
    for (step, (case, _)) in theirs.steps.iter().enumerate() {
        let (Some(a), Some(b)) = (theirs.made(step, quantity), ours.made(ours.on(*case)?, quantity)) else { continue };
        if apart(a, b) <= TOLERANCE {
            continue;
        }
        let mut worst = Off { quantity, step, at: (0, 0), theirs: a.at(0, 0), ours: b.at(0, 0) };
        for i in 0..b.rows {
            for j in 0..b.columns {
                if libm::fabs(a.at(i, j) - b.at(i, j)) > libm::fabs(worst.theirs - worst.ours) {
                    worst = Off { at: (i, j), theirs: a.at(i, j), ours: b.at(i, j), ..worst };
                }
            }
        }
        return Some(worst);
    }
    None
}

impl Off {
    /// "In case 1 P[1, 2] is 3.2, and a right filter has 2.9."
    fn say(&self, of: &Steps, words: &mut Words) {
        words.text("In case ").whole(of.steps[self.step].0 as i64 + 1).text(", ");
        self.entry(of, words);
        words.text(" is ").number(self.theirs).text(", and a right filter has ").number(self.ours).text(".");
    }

    fn entry(&self, of: &Steps, words: &mut Words) {
        words.text(of.program.notation().letter(self.quantity)).text("[").whole(self.at.0 as i64 + 1);
        if !matches!(self.quantity, Quantity::X | Quantity::Innovation) {
            words.text(", ").whole(self.at.1 as i64 + 1);
        }
        words.text("]");
    }
}

/// The last line that makes a quantity.
fn line_of(of: &Steps, quantity: Quantity) -> Option<u32> {
    let letter = of.program.notation().letter(quantity);
    let (_, step) = of.steps.first()?;
    step.made.iter().rev().find(|made| of.program.name(made) == letter).map(|made| made.line)
}
