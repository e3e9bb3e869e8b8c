//! Sizes and names, before a number moves.

mod call;
mod name;

use crate::fault::{Faults, Span, line_of};
use crate::size::{Inferred, Shape, Size};
use crate::tree::{Function, Id, Line, Name, Node, Tree};
use crate::words::Words;
use crate::world::{Letter, Notation, P, World, X};
use alloc::string::String;
use alloc::vec::Vec;

/// Products and sums of one step.
pub(crate) const MOST_PRODUCTS: u64 = 200_000;

pub(crate) struct Checker<'a, 'b> {
    pub text: &'a str,
    pub tree: &'a Tree,
    pub names: &'a [String],
    pub world: World,
    pub notation: Notation,
    pub found: Inferred,
    pub faults: &'a mut Faults<'b>,
    /// What each name is at the present line; none before a line makes it.
    pub shapes: Vec<Option<Shape>>,
    /// What each part of a formula is.
    pub of: Vec<Shape>,
    /// Products so far, where all sizes are known.
    pub products: u64,
    pub within_jacobian: bool,
    pub line: usize,
}

impl Checker<'_, '_> {
    pub fn check(&mut self) {
        self.world.shapes(&mut self.shapes);
        self.shapes.resize(self.names.len(), None);
        self.of.resize(self.tree.nodes.len(), Shape::Unknown);
        for (i, line) in self.tree.lines.iter().enumerate() {
            self.line = i;
            let shape = line.value.map_or(Shape::Unknown, |value| self.shape(value));
            if let Some(part) = line.part {
                let part = self.shape(part);
                if !self.same(shape, part) {
                    let mut words = self.sized(line.value.unwrap_or_default(), shape);
                    words.text(", and the part that it is to fill is ");
                    self.found.say(part, &mut words);
                    self.told(line.place, words, ".");
                }
            } else {
                self.shapes[line.name] = Some(shape);
            }
        }
        // Behind the last sign.
        let mut end = self.text.len();
        while end > 0 && matches!(self.text.as_bytes()[end - 1], b'\n' | b'\r') {
            end -= 1;
        }
        let last = Span { from: end, to: end };
        self.outcome(last);
        if self.products > MOST_PRODUCTS {
            let mut words = Words::new("A step takes ");
            words.whole(self.products as i64).text(" products; at most ").whole(MOST_PRODUCTS as i64);
            self.told(last, words, " are accepted.");
        }
    }

    /// What a world takes: the new estimate and its covariance.
    fn outcome(&mut self, last: Span) {
        let mut missing = Words::new("No line makes ");
        for (name, letter) in [(X, Letter::X), (P, Letter::P)] {
            let Some(line) = self.tree.made(name) else {
                missing.text(if missing.0.ends_with(' ') { "" } else { ", and none " }).text(&self.names[name]);
                continue;
            };
            let (shape, wanted) = (self.shapes[name].unwrap_or(Shape::Unknown), World::shape_of(letter));
            if shape == Shape::Identity || !self.same(shape, wanted) {
                let mut words = Words::new(&self.names[name]);
                self.found.say(shape, words.text(" becomes "));
                self.found.say(wanted, words.text("; it must be "));
                self.told(line.place, words, ".");
            }
        }
        // What is missing is no line's fault: it is said where no line has one.
        if !missing.0.ends_with(' ') && self.faults.is_empty() {
            missing.text(": a step of a filter makes a new ").text(&self.names[X]).text(" and a new ");
            missing.text(&self.names[P]);
            missing.text(" of the old ones.");
            for name in [X, P] {
                let known = self.names[name].as_str();
                let begins = |name: &str| name.get(..known.len()).is_some_and(|head| head.eq_ignore_ascii_case(known));
                // A prediction is none, nor what a later line goes on with.
                let goes_on = |line: &Line| {
                    let of_it = |(node, place): &(Node, Span)| {
                        matches!(node, Node::Name(name) if *name == line.name) && place.from > line.place.from
                    };
                    self.tree.nodes.iter().any(of_it)
                };
                let other = |line: &&Line| {
                    begins(&self.names[line.name]) && !self.names[line.name].ends_with('⁻') && !goes_on(line)
                };
                if let (None, Some(line)) = (self.tree.made(name), self.tree.lines.iter().rev().find(other)) {
                    missing.text(" Line ").whole(i64::from(line_of(self.text, line.place.from))).text(" makes ");
                    missing
                        .text(&self.names[line.name])
                        .text(": if the reading has corrected it, call it ")
                        .text(known)
                        .text(".");
                }
            }
            self.faults.lacking = true;
            self.told(last, missing, "");
        }
    }

    #[inline(never)]
    fn same(&mut self, a: Shape, b: Shape) -> bool {
        match (a, b) {
            (Shape::Of(a, b), Shape::Of(c, d)) => self.found.unify(a, c) && self.found.unify(b, d),
            (Shape::Identity, Shape::Of(a, b)) | (Shape::Of(a, b), Shape::Identity) => self.found.unify(a, b),
            _ => true,
        }
    }

    /// "F P is n×n"; of a long formula "This part".
    fn sized(&self, id: Id, shape: Shape) -> Words {
        let Span { from, to } = self.tree.place(id);
        let text = self.text.get(from..to).unwrap_or_default();
        let mut words = Words::new(if text.len() <= 24 && !text.contains('\n') { text } else { "This part" });
        self.found.say(shape, words.text(" is "));
        words
    }

    #[inline(never)]
    fn fault(&mut self, place: Span, words: &str) -> Shape {
        self.faults.say(place, words);
        Shape::Unknown
    }

    #[inline(never)]
    fn told(&mut self, place: Span, mut words: Words, last: &str) -> Shape {
        words.text(last);
        self.faults.words(place, words);
        Shape::Unknown
    }

    fn count(&mut self, sides: [Size; 3]) {
        let mut product = 1;
        for side in sides {
            product *= self.found.known(side).unwrap_or(1).max(0) as u64;
        }
        self.products = self.products.saturating_add(product);
    }

    #[inline(never)]
    fn is_one(&self, size: Size) -> bool {
        self.found.known(size) == Some(1)
    }

    fn is_number(&self, shape: Shape) -> bool {
        matches!(shape, Shape::Of(rows, columns) if self.is_one(rows) && self.is_one(columns))
    }

    fn shape(&mut self, id: Id) -> Shape {
        let place = self.tree.place(id);
        let shape = match self.tree.node(id) {
            Node::Number(_) => Shape::NUMBER,
            Node::Name(name) => self.name(name, place),
            Node::Call(function, from, to) => self.call(function, self.tree.arguments(from, to), id, place),
            Node::Jacobian(a, name) => self.jacobian(a, name, place),
        };
        self.of[id] = shape;
        shape
    }

    fn square(&mut self, id: Id, shape: Shape, place: Span) -> Shape {
        match shape {
            Shape::Of(rows, columns) if !self.found.unify(rows, columns) => {
                let words = self.sized(id, shape);
                self.told(place, words, "; this needs as many rows as columns.")
            }
            other => other,
        }
    }

    /// A part of `whole`: `bounds` are its first and last row, and its first and last column.
    fn part(&mut self, whole: Shape, bounds: &[Id], place: Span) -> Shape {
        let Shape::Of(height, width) = whole else { return Shape::Unknown };
        let mut words = Words::new("This is ");
        self.found.say(whole, &mut words);
        let mut sides = [height, width];
        let first = if bounds.len() == 4 || self.is_one(width) {
            0
        } else if self.is_one(height) {
            1
        } else {
            return self.told(place, words, ": a part of it needs a row and a column, as P[1, 2] or H[1, :].");
        };
        for (pair, side) in bounds.chunks_exact(2).zip(&mut sides[first..]) {
            let mut of = [*side; 2];
            for (of, id) in of.iter_mut().zip(pair) {
                if !self.tree.calls(*id, Function::End) {
                    let Some(size) = self.side(*id) else {
                        let place = self.tree.place(*id);
                        return self.fault(place, "A row or a column is a whole number here, or n, p or m.");
                    };
                    *of = size;
                }
                if *of == Size::number(0) {
                    return self.fault(place, "Rows and columns are counted from 1 here: x[1] is the first.");
                }
            }
            let over = self.found.known(of[1].plus(-1, *side));
            *side = of[1].plus(-1, of[0]).plus(1, Size::ONE);
            let count = self.found.known(*side);
            if over.unwrap_or(0) > 0 || count.unwrap_or(1) < 1 {
                return self.told(place, words, ": it has no such rows or columns.");
            }
        }
        Shape::Of(sides[0], sides[1])
    }

    fn jacobian(&mut self, a: Id, name: Name, place: Span) -> Shape {
        if self.within_jacobian {
            return self.fault(place, "A derivative of a derivative is not known here.");
        }
        let by = self.name(name, place);
        let before = self.products;
        self.within_jacobian = true;
        let of = self.shape(a);
        self.within_jacobian = false;
        let (Shape::Of(rows, of_width), Shape::Of(columns, by_width)) = (of, by) else { return Shape::Unknown };
        if !self.found.unify(of_width, Size::ONE) || !self.found.unify(by_width, Size::ONE) {
            let mut words = self.sized(a, of);
            self.found.say(by, words.text(" and ").text(&self.names[name]).text(" is "));
            return self.told(place, words, ": a derivative is of a column by a column.");
        }
        let times = self.found.known(columns).unwrap_or(1).max(0) as u64;
        let once = self.products - before;
        self.products = self.products.saturating_add(once.saturating_mul(3 * times));
        Shape::Of(rows, columns)
    }
}
