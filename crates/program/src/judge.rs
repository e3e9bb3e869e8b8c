//! Whether a program is a right filter: one step beside a right filter's on a dozen cases, and beside what the museum's
//! bugs make of the same cases.
//!
//! The right filter is the chapter's step with Joseph's form, as a program of this language; a test holds it to the
//! core's on all cases. A text is never compared: whatever gives the same numbers is right, in any form.

mod bugs;
mod cases;

pub use bugs::Bug;
pub use cases::cases;

use crate::words::Words;
use crate::{Matrix, Notation, Program, Quantity, Step, Stop, World};
use alloc::string::String;
use alloc::vec::Vec;

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
        return refused(fault.line, Words::default().text(&fault.message).0.clone());
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
    for bug in Bug::of(world) {
        for text in bugs::texts(world, *bug) {
            let Some(mutant) = Steps::known(world, &text, &cases) else { continue };
            if first_off(&theirs, &mutant).is_none() {
                return is_bug(*bug, &theirs, &ours, &mutant, &off);
            }
        }
    }
    is_wrong(&theirs, &ours, &off)
}

fn refused(line: u32, sentence: String) -> Verdict {
    Verdict { outcome: Outcome::Refused, line: Some(line), sentences: alloc::vec![sentence] }
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
        words.text("In case ").whole(of.steps[self.step].0 as i64 + 1).text(" ");
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

fn is_right(theirs: &Steps, ours: &Steps, cases: usize) -> Verdict {
    let (mut worst, mut lopsided) = (0.0, None);
    for (step, (case, _)) in theirs.steps.iter().enumerate() {
        for quantity in [Quantity::X, Quantity::P] {
            let ours = ours.on(*case).and_then(|step| ours.made(step, quantity));
            if let (Some(a), Some(b)) = (theirs.made(step, quantity), ours) {
                worst = f64::max(worst, apart(a, b));
                if quantity == Quantity::P && !a.is_symmetric() {
                    lopsided = lopsided.or(Some(*case));
                }
            }
        }
    }
    let [x, p] = [Quantity::X, Quantity::P].map(|quantity| theirs.program.notation().letter(quantity));
    let mut words = Words::new("Right: ");
    words.text(x).text(" and ").text(p).text(" are those of a right filter in all ");
    words.whole(theirs.steps.len() as i64).text(" cases, to ").number(worst).text(" of their largest entry.");
    let mut sentences = alloc::vec![words.0];
    if theirs.steps.len() < cases {
        let mut words = Words::new("The other ");
        words.whole((cases - theirs.steps.len()) as i64).text(" cases are of sizes that it is not written for.");
        sentences.push(words.0);
    }
    if let Some(case) = lopsided {
        let mut words = Words::new(p);
        words.text(" is not symmetric in its last digits, as in case ").whole(case as i64 + 1);
        words.text(": in the museum this is the bug “P is not symmetric”. A last line ").text(p).text(" = sym(");
        sentences.push(words.text(p).text(") cures it.").0.clone());
    }
    sentences.extend(breaks(theirs));
    let line = if sentences.len() > 1 { line_of(theirs, Quantity::P) } else { None };
    Verdict { outcome: Outcome::Right, line, sentences }
}

/// Where a form that is right on paper loses its digits: a prior that knows nothing.
fn breaks(theirs: &Steps) -> Option<String> {
    let hard = cases::knowing_nothing(theirs.program.world(), theirs.program.sizes())?;
    let mut words = Words::new("With a prior of 10²⁴ I and a reading of variance 0.04, ");
    let letter = theirs.program.notation().letter(Quantity::P);
    match theirs.program.clone().step(hard) {
        Ok(step) => {
            let variance = theirs.program.made(&step, Quantity::P)?.at(0, 0);
            if libm::fabs(variance - 0.04) < 1e-6 {
                return None;
            }
            words.text(letter).text("[1, 1] becomes ").number(variance);
            words.text(", where Joseph’s form has 0.04: on paper the form is right, in numbers it breaks there.");
        }
        Err(_) => {
            words.text("it has no value: on paper the form is right, in numbers it breaks there.");
        }
    }
    Some(words.0)
}

/// The first line that makes what a line of the bug makes and no line of the right filter.
fn is_bug(bug: Bug, theirs: &Steps, ours: &Steps, mutant: &Steps, off: &Off) -> Verdict {
    let same = |line: usize, of: &Steps, other: usize| {
        theirs.steps.iter().all(|(case, step)| {
            let (Some(a), Some(at)) = (step.made.get(line), of.on(*case)) else { return false };
            of.steps[at].1.made.get(other).is_some_and(|b| apart(a.value(), b.value()) <= TOLERANCE)
        })
    };
    let lines = |of: &Steps| of.steps.first().map_or(0, |(_, step)| step.made.len());
    // What a later line makes anew is no answer of a filter.
    let stays = |of: &Steps, line: usize| {
        let made = |line: usize| of.program.name(&of.steps[0].1.made[line]);
        (line + 1..lines(of)).all(|later| made(later) != made(line))
    };
    let any = |line: usize, of: &Steps| (0..lines(of)).any(|other| stays(of, other) && same(line, of, other));
    let tells = |line: &usize| any(*line, mutant) && !any(*line, ours);
    let first = (0..lines(theirs)).find(tells);
    let line = first.map(|line| theirs.steps[0].1.made[line].line).or_else(|| line_of(theirs, off.quantity));
    let mut words = Words::default();
    if let Some(line) = line {
        words.text("Line ").whole(i64::from(line)).text(": ");
    }
    words.text(bug.sentence());
    let mut numbers = Words::default();
    off.say(theirs, &mut numbers);
    numbers.text(" In all ").whole(theirs.steps.len() as i64).text(" cases the answer is that of this bug.");
    Verdict { outcome: Outcome::Bug(bug), line, sentences: alloc::vec![words.0, numbers.0] }
}

fn is_wrong(theirs: &Steps, ours: &Steps, off_first: &Off) -> Verdict {
    let mut words = Words::default();
    off_first.say(theirs, &mut words);
    let mut sentences = alloc::vec![words.0];
    let mut line = line_of(theirs, off_first.quantity);
    // The first of the named quantities that is off, with those before it that are right.
    let mut right = Vec::new();
    for quantity in [Quantity::Innovation, Quantity::S, Quantity::Gain] {
        let Some(at) = line_of(theirs, quantity) else { continue };
        if !(0..theirs.steps.len()).all(|step| theirs.made(step, quantity).is_some()) {
            continue;
        }
        let letter = theirs.program.notation().letter(quantity);
        match off(theirs, ours, quantity) {
            None => right.push(String::from(letter)),
            Some(off) => {
                let mut words = Words::default();
                if !right.is_empty() {
                    words.list(&right).text(if right.len() > 1 { " are right. " } else { " is right. " });
                }
                words.text("Line ").whole(i64::from(at)).text(" is off: ");
                off.entry(theirs, &mut words);
                words.text(" is ").number(off.theirs).text(" in case ");
                words.whole(theirs.steps[off.step].0 as i64 + 1).text(", and a right filter has ").number(off.ours);
                sentences.push(words.text(".").0.clone());
                return Verdict { outcome: Outcome::Wrong, line: Some(at), sentences };
            }
        }
    }
    if !right.is_empty() {
        let mut words = Words::default();
        words.list(&right).text(if right.len() > 1 { " are right" } else { " is right" });
        sentences.push(words.text(", so the fault is in what is made of them.").0.clone());
    }
    // Where x is right, P alone is off.
    if off_first.quantity == Quantity::P {
        let x = theirs.program.notation().letter(Quantity::X);
        let mut words = Words::new(x);
        sentences.push(words.text(" is right in all cases.").0.clone());
    } else if off(theirs, ours, Quantity::P).is_none() {
        let mut words = Words::new(theirs.program.notation().letter(Quantity::P));
        sentences.push(words.text(" is right in all cases.").0.clone());
    }
    line = line.or(Some(1));
    Verdict { outcome: Outcome::Wrong, line, sentences }
}
