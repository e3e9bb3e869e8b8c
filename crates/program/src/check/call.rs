//! The sizes of what operators and functions answer.

use super::Checker;
use crate::fault::Span;
use crate::size::{MOST_SIDE, Shape, Size};
use crate::tree::{Function, Id, Node};

const NEEDS_SIZE: &str = "Here I needs its size: eye(n), eye(p) or eye(2).";

impl Checker<'_, '_> {
    pub(super) fn call(&mut self, function: Function, arguments: &[Id], id: Id, place: Span) -> Shape {
        use Function as F;
        if let F::Eye | F::Zeros = function {
            let (Some(rows), Some(columns)) = (self.side(arguments[0]), self.side(arguments[arguments.len() - 1]))
            else {
                return self.fault(place, "A size is a whole number of at most 60 here, or n, p or m.");
            };
            return Shape::Of(rows, columns);
        }
        if let F::Row | F::Stack = function {
            return self.joined(arguments, function == F::Stack);
        }
        let Some(first) = arguments.first().copied() else {
            return self.fault(place, "Only between brackets there is an end.");
        };
        let a = self.shape(first);
        if function == F::Part {
            return self.part(a, &arguments[1..], place);
        }
        let last = arguments[arguments.len() - 1];
        let b = if arguments.len() > 1 { self.shape(last) } else { a };
        if a == Shape::Unknown || b == Shape::Unknown {
            return Shape::Unknown;
        }
        match function {
            F::Plus | F::Minus => {
                if let Shape::Of(rows, columns) = a {
                    self.count([rows, columns, Size::ONE]);
                }
                if !self.same(a, b) {
                    let number = self.is_number(a) || self.is_number(b);
                    let why = if number {
                        ": both sides of a sum have one size. The identity is I, and an inverse inv(S)."
                    } else {
                        ": both sides of a sum have one size."
                    };
                    return self.misfit(id, [(first, a), (last, b)], why);
                }
                if a == Shape::Identity { b } else { a }
            }
            F::Times => self.product(id, [(first, a), (last, b)]),
            F::Over if self.is_number(b) => a,
            F::Under if self.is_number(a) => b,
            F::Over | F::Under => {
                let over = function == F::Over;
                let (divided, by) = if over { (a, b) } else { (b, a) };
                let by = self.square(if over { last } else { first }, by, place);
                let (Shape::Of(n, _), Shape::Of(rows, columns)) = (by, divided) else {
                    return if divided == Shape::Identity { by } else { divided };
                };
                self.count([n, n, n]);
                self.count([n, rows, columns]);
                if self.found.unify(if over { columns } else { rows }, n) {
                    return divided;
                }
                let why = if over {
                    ": a / b needs as many columns in a as in b."
                } else {
                    ": a \\ b needs as many rows in a as in b."
                };
                self.misfit(id, [(first, a), (last, b)], why)
            }
            F::Negative | F::Array | F::Absolute | F::Wrap => a,
            F::Transpose => match a {
                Shape::Of(rows, columns) => Shape::Of(columns, rows),
                other => other,
            },
            F::Length | F::Norm => Shape::NUMBER,
            F::Inverse | F::Power(_) | F::Root | F::Symmetric | F::Trace | F::Determinant => {
                let square = self.square(first, a, place);
                if let Shape::Of(n, _) = square {
                    let times = if let F::Power(power) = function { power.abs() } else { 1 };
                    for _ in 0..=times {
                        self.count([n, n, n]);
                    }
                }
                if square == Shape::Identity && matches!(function, F::Root | F::Trace | F::Determinant) {
                    return self.fault(place, NEEDS_SIZE);
                }
                if square != Shape::Unknown && matches!(function, F::Trace | F::Determinant) {
                    return Shape::NUMBER;
                }
                square
            }
            F::Diagonal => match a {
                Shape::Of(rows, columns) if self.is_one(columns) => Shape::Of(rows, rows),
                _ => match self.square(first, a, place) {
                    Shape::Of(rows, _) => Shape::Of(rows, Size::ONE),
                    _ => Shape::Unknown,
                },
            },
            F::Motion | F::Sensor => {
                let column = |rows| Shape::Of(Size::number(rows), Size::ONE);
                if !self.same(a, column(3)) || !self.same(b, column(2)) {
                    let words = "f takes a state of 3×1 and an input of 2×1, h a state and a landmark of 2×1.";
                    return self.fault(place, words);
                }
                column(if function == F::Motion { 3 } else { 2 })
            }
            F::Angle if self.same(a, Shape::NUMBER) && self.same(b, Shape::NUMBER) => Shape::NUMBER,
            F::Angle => self.fault(place, "atan2 takes two numbers."),
            _ => match a {
                Shape::Of(rows, columns) if !self.is_one(rows) && !self.found.unify(columns, Size::ONE) => {
                    let words = self.sized(first, a);
                    let why = "; this function takes a number or a column. The root of a matrix is chol.";
                    self.told(place, words, why)
                }
                other => other,
            },
        }
    }

    fn misfit(&mut self, id: Id, [a, b]: [(Id, Shape); 2], why: &str) -> Shape {
        let mut words = self.sized(a.0, a.1);
        let other = self.sized(b.0, b.1);
        words.text(" and ").text(&other.0).text(why);
        // The formula that is named, not the line that begins there.
        let place = Span { from: self.tree.place(a.0).from, to: self.tree.place(id).to };
        self.told(place, words, "")
    }

    fn product(&mut self, id: Id, pair: [(Id, Shape); 2]) -> Shape {
        let [(_, left), (_, right)] = pair;
        match (left, right) {
            (Shape::Identity, other) if self.is_number(other) => left,
            (other, Shape::Identity) if self.is_number(other) => right,
            (Shape::Identity, other) | (other, Shape::Identity) => other,
            (Shape::Of(rows, inner), Shape::Of(other, columns)) => {
                self.count([rows, inner, columns]);
                self.count([other, columns, Size::ONE]);
                if self.is_number(left) {
                    right
                } else if self.is_number(right) {
                    left
                } else if self.found.unify(inner, other) {
                    Shape::Of(rows, columns)
                } else {
                    self.misfit(id, pair, ": a product needs as many columns on the left as rows on the right.")
                }
            }
            _ => Shape::Unknown,
        }
    }

    fn joined(&mut self, parts: &[Id], below: bool) -> Shape {
        let (mut along, mut across) = (Size::number(0), None);
        for id in parts {
            let (part, place) = (self.shape(*id), self.tree.place(*id));
            let (rows, columns) = match part {
                Shape::Of(rows, columns) => (rows, columns),
                Shape::Identity => return self.fault(place, NEEDS_SIZE),
                Shape::Unknown => return Shape::Unknown,
            };
            let (long, wide) = if below { (rows, columns) } else { (columns, rows) };
            if !self.found.unify(*across.get_or_insert(wide), wide) {
                let words = self.sized(*id, part);
                let why = if below {
                    "; rows below one another are as wide as the first."
                } else {
                    "; parts of a row are as high as the first."
                };
                return self.told(place, words, why);
            }
            along = along.plus(1, long);
            // Parts of parts would double without end.
            if self.found.is_beyond(along) {
                return self.fault(place, "A matrix has at most 60 rows and 60 columns.");
            }
            self.count([rows, columns, Size::number(parts.len().min(60) as i8)]);
        }
        let across = across.unwrap_or(Size::ONE);
        if below { Shape::Of(along, across) } else { Shape::Of(across, along) }
    }

    /// The size that an argument of eye or zeros names.
    pub(super) fn side(&mut self, id: Id) -> Option<Size> {
        let size = match self.tree.node(id) {
            Node::Number(x) if libm::trunc(x) == x && (0.0..=f64::from(MOST_SIDE)).contains(&x) => {
                Size::number(x as i8)
            }
            Node::Name(name) => Size::letter(name.checked_sub(self.world.identity() + 1).filter(|letter| *letter < 3)?),
            Node::Call(Function::Length, from, to) => {
                let arguments = self.tree.arguments(from, to);
                let Shape::Of(rows, columns) = self.shape(arguments[0]) else { return None };
                let second = matches!(arguments.get(1).map(|id| self.tree.node(*id)), Some(Node::Number(2.0)));
                if second { columns } else { rows }
            }
            _ => return None,
        };
        Some(size)
    }
}
