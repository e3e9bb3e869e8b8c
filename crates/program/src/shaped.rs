//! A program as a tree whose sizes are known: what a printer needs to write it in another style or language.

use crate::fault::{Fault, Faults, line_of};
use crate::size::Shape;
use crate::tree::{Function, Id, Node};
use crate::{Program, checked};
use alloc::string::String;
use alloc::vec::Vec;

/// A part of a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// `number`, `name`, or what is done with the parts.
    pub word: &'static str,
    /// The number, or the exponent of a power.
    pub number: f64,
    /// The name; of a derivative the one by which is differentiated.
    pub name: String,
    /// Rows and columns; none of a multiple of I, which has the size of what it stands beside, and where no sizes were
    /// given.
    pub sides: Option<[usize; 2]>,
    /// What it is made of, in the order in which it is written.
    pub parts: Vec<Formula>,
}

/// A line of a program: `name = value`, or `name[…] = value`.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// The name that it makes.
    pub name: String,
    /// Which part of the name, where it is not the whole: a [`Formula`] whose word is `part`.
    pub part: Option<Formula>,
    /// The formula.
    pub value: Formula,
    /// Where it begins and ends: lines of the text, from 1.
    pub lines: [u32; 2],
}

impl Program {
    /// The lines as trees; with `sizes` n, p and m each part has its rows and columns.
    ///
    /// # Errors
    /// The first fault, of the text or of its sizes.
    pub fn tree(&self, sizes: Option<[usize; 3]>) -> Result<Vec<Statement>, Fault> {
        if let Some(fault) = self.read.faults.first() {
            return Err(fault.clone());
        }
        let mut reader = Reader { program: self, shapes: Vec::new(), found: self.read.found };
        if let Some(sizes) = sizes {
            self.clone().fit(sizes)?;
            reader.found.0 = sizes.map(|size| size as i32);
            let mut faults = Faults::new(&self.read.text);
            let checker = checked(
                &self.read.text,
                &self.read.tree,
                &self.read.names,
                self.read.world,
                self.read.notation,
                reader.found,
                &mut faults,
            );
            reader.shapes = checker.of;
        }
        let mut lines = Vec::with_capacity(self.read.tree.lines.len());
        for line in &self.read.tree.lines {
            let Some(value) = line.value else { continue };
            let ends = [line.place.from, self.read.tree.place(value).to.max(line.place.from + 1) - 1];
            lines.push(Statement {
                name: self.read.names[line.name].clone(),
                part: line.part.map(|part| reader.formula(part)),
                value: reader.formula(value),
                lines: ends.map(|at| line_of(&self.read.text, at)),
            });
        }
        Ok(lines)
    }
}

struct Reader<'a> {
    program: &'a Program,
    shapes: Vec<Shape>,
    found: crate::size::Inferred,
}

impl Reader<'_> {
    fn formula(&self, id: Id) -> Formula {
        let sides = match self.shapes.get(id) {
            Some(Shape::Of(rows, columns)) => {
                self.found.known(*rows).zip(self.found.known(*columns)).map(|(a, b)| [a as usize, b as usize])
            }
            _ => None,
        };
        let mut it = Formula { word: "number", number: 0.0, name: String::new(), sides, parts: Vec::new() };
        match self.program.read.tree.node(id) {
            Node::Number(number) => it.number = number,
            Node::Name(name) => (it.word, it.name) = ("name", self.program.read.names[name].clone()),
            Node::Jacobian(of, by) => {
                (it.word, it.name) = ("jac", self.program.read.names[by].clone());
                it.parts.push(self.formula(of));
            }
            Node::Call(function, from, to) => {
                it.word = word(function);
                if let Function::Power(power) = function {
                    it.number = f64::from(power);
                }
                for part in self.program.read.tree.arguments(from, to) {
                    it.parts.push(self.formula(*part));
                }
            }
        }
        it
    }
}

fn word(function: Function) -> &'static str {
    use Function as F;
    match function {
        F::Plus => "plus",
        F::Minus => "minus",
        F::Times => "times",
        F::Over => "over",
        F::Under => "under",
        F::Negative => "negative",
        F::Power(_) => "power",
        F::Part => "part",
        F::End => "end",
        F::Row => "row",
        F::Stack => "stack",
        F::Inverse => "inv",
        F::Eye => "eye",
        F::Zeros => "zeros",
        F::Diagonal => "diag",
        F::Square => "sqrt",
        F::Sine => "sin",
        F::Cosine => "cos",
        F::Angle => "atan2",
        F::Exponential => "exp",
        F::Wrap => "wrap",
        F::Determinant => "det",
        F::Trace => "trace",
        F::Norm => "norm",
        F::Root => "chol",
        F::Symmetric => "sym",
        F::Transpose => "transpose",
        F::Absolute => "abs",
        F::Length => "length",
        F::Array => "array",
        F::Jacobian => "jac",
        F::Motion => "f",
        F::Sensor => "h",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Notation, World};

    fn of(text: &str, sizes: Option<[usize; 3]>) -> Vec<Statement> {
        Program::new(text, World::Linear, Notation::Choset).tree(sizes).expect("no faults")
    }

    #[test]
    fn each_part_of_a_formula_has_its_rows_and_columns() {
        let lines = of("x = F x + G u\nP = (I - 2 P) P", Some([3, 2, 1]));
        let sides = |it: &Formula| (it.word, it.sides);
        assert_eq!(sides(&lines[0].value), ("plus", Some([3, 1])));
        assert_eq!(sides(&lines[0].value.parts[0].parts[0]), ("name", Some([3, 3])));
        assert_eq!(sides(&lines[0].value.parts[1].parts[0]), ("name", Some([3, 1])));
        // I has the size of what it stands beside.
        assert_eq!(sides(&lines[1].value.parts[0]), ("minus", Some([3, 3])));
        assert_eq!(sides(&lines[1].value.parts[0].parts[0]), ("name", None));
        let lines = of("x = F x + G u\nP = P", None);
        assert_eq!(lines[0].value.sides, None);
    }

    #[test]
    fn a_line_has_its_part_and_its_place_in_the_text() {
        let lines = of("x = F x\n\nP[1:2, 1] = P[:, 1] +\n 0 x\nP = P^-2 + jac(F x, x)", Some([2, 1, 0]));
        assert_eq!(lines.iter().map(|line| line.lines).collect::<Vec<_>>(), [[1, 1], [3, 4], [5, 5]]);
        let part = lines[1].part.as_ref().expect("a part");
        assert_eq!((part.word, part.sides, part.parts.len()), ("part", Some([2, 1]), 5));
        let [power, jacobian] = &lines[2].value.parts[..] else { panic!("a sum") };
        assert_eq!((power.word, power.number), ("power", -2.0));
        assert_eq!((jacobian.word, jacobian.name.as_str(), jacobian.sides), ("jac", "x", Some([2, 2])));
    }

    #[test]
    fn a_program_with_a_fault_or_of_other_sizes_has_no_tree() {
        let of = |text, sizes| Program::new(text, World::Linear, Notation::Choset).tree(sizes);
        assert!(of("x = F x +", None).is_err());
        let fault = of("x = eye(2) x\nP = P", Some([3, 1, 0])).expect_err("for two states");
        assert!(fault.message.contains("n = 2"), "{}", fault.message);
    }
}
