//! One step of a program: what each line makes of what the world gives.

use crate::fault::{self, Fault, Span};
use crate::matrix::Matrix;
use crate::run::{self, Run, Trouble};
use crate::tree;
use crate::value::Value;
use crate::words::Words;
use crate::{Notation, Program, Quantity, World};
use alloc::rc::Rc;
use alloc::vec::Vec;
use core::cell::Cell;

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
    /// The name that a line makes.
    pub fn name(&self, made: &Made) -> &str {
        &self.read.names[made.name]
    }

    /// One step with what the world gives: x, P, u, y, V, W, then F, G, H in a linear world, the landmark and the gate
    /// in the robot's. Nothing is kept from one step to the next.
    ///
    /// # Errors
    /// See [`Stop`].
    pub fn step(&mut self, given: Vec<Matrix>) -> Result<Step, Stop> {
        self.step_seen(given, None)
    }

    /// The same, where `look` sees the value of each part of a formula that is computed.
    pub(crate) fn step_seen(&mut self, given: Vec<Matrix>, look: Option<run::Look<'_>>) -> Result<Step, Stop> {
        let sizes = self.read.world.sizes(&given).ok_or(Stop::Given)?;
        self.fit(sizes).map_err(Stop::Fault)?;
        let mut values = Vec::with_capacity(self.read.names.len());
        for m in given {
            values.push(Rc::new(Value::from(m)));
        }
        values.extend_from_slice(&self.constants);
        values.resize(self.read.names.len(), values[0].clone());
        let mut made = Vec::with_capacity(self.read.tree.lines.len());
        for (line, number) in self.read.tree.lines.iter().zip(&self.read.lines) {
            let Some(id) = line.value else { continue };
            let trouble = Cell::new((Trouble::NotFinite, id));
            let run = Run { tree: &self.read.tree, values: &values, varied: None, trouble: &trouble, look };
            let Some(value) = run.value(id) else {
                let (trouble, id) = trouble.get();
                return Err(self.trouble(trouble, line, self.read.tree.place(id)));
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
        let last = |text: &str| step.made.iter().rev().find(|made| self.read.names[made.name] == text);
        let found = last(self.read.notation.letter(quantity));
        // filterpy calls the innovation y.
        let common = self.read.notation == Notation::Common && quantity == Quantity::Innovation;
        let found = found.or_else(|| last("y").filter(|_| common)).map(Made::value)?;
        World::fits(World::shape_of(quantity), found, step.sizes).then_some(found)
    }

    fn trouble(&self, trouble: Trouble, line: &tree::Line, place: Span) -> Stop {
        let mut words = Words::default();
        match trouble {
            Trouble::Singular => words.text("What is divided by here has no inverse."),
            Trouble::NotPositiveDefinite => words.text("The matrix whose root is taken here is not positive definite."),
            Trouble::NotFinite => words.text(&self.read.names[line.name]).text(" is not finite any more."),
        };
        Stop::Trouble(trouble, fault::shown(&self.read.text, place, words.0))
    }
}
