//! A program as a tree.

use crate::fault::Span;
use alloc::vec::Vec;

/// The number of a node.
pub(crate) type Id = usize;
/// The number of a name.
pub(crate) type Name = usize;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Plus,
    Minus,
    Times,
    /// a b⁻¹.
    Over,
    /// a⁻¹ b.
    Under,
    Negative,
    Power(i8),
    /// Of a matrix, from a row to a row, and from a column to a column where there are five arguments.
    Part,
    /// The last row or column of what it is a part of.
    End,
    /// Parts beside one another.
    Row,
    /// Parts below one another.
    Stack,
    Inverse,
    Eye,
    Zeros,
    Diagonal,
    Square,
    Sine,
    Cosine,
    Angle,
    Exponential,
    Wrap,
    Determinant,
    Trace,
    Norm,
    Root,
    Symmetric,
    Transpose,
    Absolute,
    Length,
    /// `np.array` and its like, which leave rows as they are.
    Array,
    Jacobian,
    /// f of the robot's world.
    Motion,
    /// h of it.
    Sensor,
}

use Function as F;

/// The names of functions, in every spelling that is read, with their least and greatest count of arguments.
pub(crate) static FUNCTIONS: [(&str, Function, u8, u8); 39] = [
    ("inv", F::Inverse, 1, 1),
    ("pinv", F::Inverse, 1, 1),
    ("eye", F::Eye, 1, 2),
    ("identity", F::Eye, 1, 1),
    ("zeros", F::Zeros, 1, 2),
    ("diag", F::Diagonal, 1, 1),
    ("Diagonal", F::Diagonal, 1, 1),
    ("sqrt", F::Square, 1, 1),
    ("sin", F::Sine, 1, 1),
    ("cos", F::Cosine, 1, 1),
    ("atan2", F::Angle, 2, 2),
    ("arctan2", F::Angle, 2, 2),
    ("exp", F::Exponential, 1, 1),
    ("wrap", F::Wrap, 1, 1),
    ("wrapToPi", F::Wrap, 1, 1),
    ("det", F::Determinant, 1, 1),
    ("trace", F::Trace, 1, 1),
    ("tr", F::Trace, 1, 1),
    ("norm", F::Norm, 1, 1),
    ("chol", F::Root, 1, 1),
    ("cholesky", F::Root, 1, 1),
    ("sym", F::Symmetric, 1, 1),
    ("Symmetric", F::Symmetric, 1, 1),
    ("transpose", F::Transpose, 1, 1),
    ("solve", F::Under, 2, 2),
    ("dot", F::Times, 2, 2),
    ("matmul", F::Times, 2, 2),
    ("abs", F::Absolute, 1, 1),
    ("len", F::Length, 1, 1),
    ("length", F::Length, 1, 1),
    ("size", F::Length, 1, 2),
    ("array", F::Array, 1, 1),
    ("matrix", F::Array, 1, 1),
    ("Matrix", F::Array, 1, 1),
    ("jac", F::Jacobian, 2, 2),
    ("jacobian", F::Jacobian, 2, 2),
    ("f", F::Motion, 2, 2),
    ("h", F::Sensor, 2, 2),
    ("inverse", F::Inverse, 1, 1),
];

#[derive(Clone, Copy, Debug)]
pub(crate) enum Node {
    Number(f64),
    Name(Name),
    /// A function or an operator, and where its arguments are among all.
    Call(Function, usize, usize),
    /// The derivative of a column by the name.
    Jacobian(Id, Name),
}

/// `name = value`, or `name[…] = value`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub name: Name,
    /// Where in it, as a part of it.
    pub part: Option<Id>,
    pub value: Option<Id>,
    pub place: Span,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    pub nodes: Vec<(Node, Span)>,
    /// The arguments of all calls, one after another.
    pub arguments: Vec<Id>,
    pub lines: Vec<Line>,
}

impl Tree {
    pub fn place(&self, id: Id) -> Span {
        self.nodes[id].1
    }

    #[inline(never)]
    pub fn node(&self, id: Id) -> Node {
        self.nodes[id].0
    }

    pub fn arguments(&self, from: usize, to: usize) -> &[Id] {
        self.arguments.get(from..to).unwrap_or_default()
    }

    /// Whether a node is a call of this function.
    #[inline(never)]
    pub fn calls(&self, id: Id, function: Function) -> bool {
        matches!(self.node(id), Node::Call(other, ..) if other == function)
    }

    /// The last line that makes a name.
    #[inline(never)]
    pub fn made(&self, name: Name) -> Option<&Line> {
        self.lines.iter().rev().find(|line| line.name == name)
    }
}
