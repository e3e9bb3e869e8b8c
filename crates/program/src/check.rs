//! Sizes and names, before a number moves.

use crate::fault::{Faults, Place, line_of};
use crate::size::{Found, Shape, Size};
use crate::tree::{Function, Id, Name, Node, Sign, Span, Tree};
use crate::words::Words;
use crate::world::{Letter, Notation, P, World, X};
use alloc::string::String;
use alloc::vec::Vec;

/// Products and sums of one step.
pub(crate) const MOST_PRODUCTS: u64 = 200_000;
/// Rows or columns of one matrix.
const MOST_SIDE: i32 = 64;

pub(crate) struct Checker<'a, 'b> {
    pub text: &'a str,
    pub tree: &'a Tree,
    pub names: &'a [String],
    pub world: World,
    pub notation: Notation,
    pub found: Found,
    pub faults: &'a mut Faults<'b>,
    /// What each name is at the present line; none before a line makes it.
    pub shapes: Vec<Option<Shape>>,
    /// Products so far, where all sizes are known.
    pub products: u64,
    pub within_jacobian: bool,
    pub line: usize,
}

impl Checker<'_, '_> {
    pub fn check(&mut self) {
        self.shapes = self.world.shapes().into_iter().map(Some).collect();
        self.shapes.resize(self.names.len(), None);
        for (i, line) in self.tree.lines.iter().enumerate() {
            self.line = i;
            let shape = line.value.map_or(Shape::Unknown, |value| self.shape(value));
            match line.part {
                None => self.shapes[line.name] = Some(shape),
                Some((rows, columns)) => {
                    let whole = self.name(line.name, line.place);
                    let part = self.part(whole, rows, columns, line.place);
                    if !self.same(shape, part) {
                        let value = line.value.unwrap_or_default();
                        let mut words = self.sized(value, shape);
                        words.text(", and the part that it is to fill is ");
                        self.found.shape(part).say(&mut words);
                        words.text(".");
                        self.faults.words(line.place, &words);
                    }
                }
            }
        }
        self.outcome();
        if self.products > MOST_PRODUCTS {
            let mut words = Words::new("A step takes ");
            words.whole(self.products as i64).text(" products; at most ").whole(MOST_PRODUCTS as i64);
            let place = self.tree.lines.last().map_or(Place::default(), |line| line.place);
            self.faults.words(place, words.text(" are accepted."));
        }
    }

    /// What a world takes.
    fn outcome(&mut self) {
        let last = self.tree.lines.last().map_or(Place::default(), |line| line.place);
        for (name, letter) in [(X, Letter::X), (P, Letter::P)] {
            let made = self.tree.lines.iter().rev().find(|line| line.name == name);
            let Some(made) = made else {
                let mut words = Words::new("No line makes ");
                words.text(&self.names[name]).text(": a step of a filter makes a new ");
                words.text(&self.names[X]).text(" and a new ").text(&self.names[P]).text(" of the old ones.");
                // A program that lacks both lacks a last line twice.
                self.faults.words(if name == X { last } else { Place { from: last.from + 1, ..last } }, &words);
                continue;
            };
            self.fits(name, letter, made.place);
        }
        for letter in [Letter::Innovation, Letter::S, Letter::Gain] {
            let name = self.names.iter().position(|name| name == self.notation.letter(letter));
            let made = self.tree.lines.iter().rev().find(|line| Some(line.name) == name);
            if let (Some(name), Some(made)) = (name, made) {
                self.fits(name, letter, made.place);
            }
        }
    }

    fn fits(&mut self, name: Name, letter: Letter, place: Place) {
        let (shape, wanted) = (self.shapes[name].unwrap_or(Shape::Unknown), World::shape_of(letter));
        let is = self.found.shape(shape);
        if shape == Shape::Identity || !self.same(shape, wanted) {
            let mut words = Words::new(&self.names[name]);
            words.text(" becomes ");
            is.say(&mut words);
            words.text("; it must be ");
            self.found.shape(wanted).say(&mut words);
            self.faults.words(place, words.text("."));
        }
    }

    fn same(&mut self, a: Shape, b: Shape) -> bool {
        match (a, b) {
            (Shape::Of(a, b), Shape::Of(c, d)) => self.found.unify(a, c) && self.found.unify(b, d),
            (Shape::Identity, Shape::Of(a, b)) | (Shape::Of(a, b), Shape::Identity) => self.found.unify(a, b),
            _ => true,
        }
    }

    /// "F P is n×n"; of a long formula "the left side".
    fn sized(&self, id: Id, shape: Shape) -> Words {
        let Place { from, to } = self.tree.place(id);
        let text = self.text.get(from..to).unwrap_or_default();
        let mut words = Words::new(if text.len() <= 24 && !text.contains('\n') { text } else { "This part" });
        words.text(" is ");
        self.found.shape(shape).say(&mut words);
        words
    }

    fn misfit(&mut self, id: Id, [a, b]: [(Id, Shape); 2], why: &str) -> Shape {
        let mut words = self.sized(a.0, a.1);
        let other = self.sized(b.0, b.1);
        words.text(" and ").text(&other.0).text(": ").text(why);
        // The formula that is named, not the line that begins there.
        let place = Place { from: self.tree.place(a.0).from, to: self.tree.place(id).to };
        self.faults.words(place, &words);
        Shape::Unknown
    }

    fn count(&mut self, sides: [Size; 3]) {
        let known = sides.map(|side| self.found.size(side).known().unwrap_or(1).max(0) as u64);
        self.products = self.products.saturating_add(known[0] * known[1] * known[2]);
    }

    fn is_one(&self, size: Size) -> bool {
        self.found.size(size) == Size::ONE
    }

    fn is_number(&self, shape: Shape) -> bool {
        matches!(shape, Shape::Of(rows, columns) if self.is_one(rows) && self.is_one(columns))
    }

    fn name(&mut self, name: Name, place: Place) -> Shape {
        if let Some(shape) = self.shapes[name] {
            return shape;
        }
        let text = self.names[name].as_str();
        let mut words = Words::new(text);
        let later = self.tree.lines.iter().skip(self.line).find(|line| line.name == name);
        let own = |letter: Letter| self.notation.letter(letter) == text;
        if let Some(line) = later.filter(|line| line.place.from > place.from) {
            words.text(" is not known here; line ").whole(i64::from(line_of(self.text, line.place.from)));
            words.text(" makes it.");
        } else if self.world == World::Robot && (own(Letter::F) || own(Letter::H) || own(Letter::G)) {
            words.text(" is not given in this world: it is a derivative, jac(");
            words.text(if own(Letter::H) { "h, " } else { "f, " });
            words.text(if own(Letter::G) { "u" } else { &self.names[X] }).text(").");
        } else if let Some((whose, meaning, here)) = self.notation.foreign(text) {
            words.text(" is ").text(meaning).text(" in ").text(whose).text("; in ").text(self.notation.whose());
            words.text(", which this program is in, that is ").text(here).text(".");
        } else {
            words.text(" is not known: no line above makes it, and the world gives ");
            words.list(self.names[..self.world.own()].iter().map(String::as_str)).text(".");
        }
        self.faults.words(place, &words);
        // Once is enough.
        self.shapes[name] = Some(Shape::Unknown);
        Shape::Unknown
    }

    fn shape(&mut self, id: Id) -> Shape {
        let (node, place) = &self.tree.nodes[id];
        match node {
            Node::Number(_) => Shape::NUMBER,
            Node::Name(name) => self.name(*name, *place),
            Node::Negative(a) => self.shape(*a),
            Node::Transpose(a) => match self.shape(*a) {
                Shape::Of(rows, columns) => Shape::Of(columns, rows),
                other => other,
            },
            Node::Power(a, power) => {
                let shape = self.shape(*a);
                let shape = self.square(*a, shape, *place);
                for _ in 0..power.unsigned_abs() {
                    self.multiplied(shape, shape);
                }
                shape
            }
            Node::Binary(sign, a, b) => self.binary(id, *sign, *a, *b),
            Node::Call(function, arguments) => self.call(*function, arguments, *place),
            Node::Part(a, rows, columns) => {
                let whole = self.shape(*a);
                self.part(whole, *rows, *columns, *place)
            }
            Node::Block(rows) => self.block(rows),
            Node::Jacobian(a, name) => self.jacobian(*a, *name, *place),
        }
    }

    fn multiplied(&mut self, a: Shape, b: Shape) {
        if let (Shape::Of(rows, columns), Shape::Of(_, more)) = (a, b) {
            self.count([rows, columns, more]);
        }
    }

    fn square(&mut self, id: Id, shape: Shape, place: Place) -> Shape {
        if let Shape::Of(rows, columns) = shape
            && !self.found.unify(rows, columns)
        {
            let mut words = self.sized(id, shape);
            self.faults.words(place, words.text("; this needs as many rows as columns."));
            return Shape::Unknown;
        }
        shape
    }

    fn binary(&mut self, id: Id, sign: Sign, a: Id, b: Id) -> Shape {
        let (left, right) = (self.shape(a), self.shape(b));
        let pair = [(a, left), (b, right)];
        if left == Shape::Unknown || right == Shape::Unknown {
            return Shape::Unknown;
        }
        match sign {
            Sign::Plus | Sign::Minus => {
                self.count([if let Shape::Of(rows, _) = left { rows } else { Size::ONE }, Size::ONE, Size::ONE]);
                if self.same(left, right) {
                    return if left == Shape::Identity { right } else { left };
                }
                self.misfit(id, pair, "both sides of a sum have one size.")
            }
            Sign::Times => self.product(id, pair),
            Sign::Over if self.is_number(right) => left,
            Sign::Under if self.is_number(left) => right,
            Sign::Over | Sign::Under => {
                let (divided, of, id_by) = if sign == Sign::Over { (left, right, b) } else { (right, left, a) };
                let by = self.square(id_by, of, self.tree.place(id_by));
                let (Shape::Of(n, _), Shape::Of(rows, columns)) = (by, divided) else {
                    return if divided == Shape::Identity { of } else { divided };
                };
                self.count([n, n, n]);
                self.count([n, n, if sign == Sign::Over { rows } else { columns }]);
                let side = if sign == Sign::Over { columns } else { rows };
                if self.found.unify(side, n) {
                    return divided;
                }
                let why = "division from the right needs columns alike, from the left rows alike.";
                self.misfit(id, pair, why)
            }
        }
    }

    fn product(&mut self, id: Id, pair: [(Id, Shape); 2]) -> Shape {
        let (left, right) = (pair[0].1, pair[1].1);
        self.multiplied(left, right);
        match (left, right) {
            (Shape::Identity, other) if self.is_number(other) => left,
            (other, Shape::Identity) if self.is_number(other) => right,
            (Shape::Identity, other) | (other, Shape::Identity) => other,
            _ if self.is_number(left) => right,
            _ if self.is_number(right) => left,
            (Shape::Of(rows, inner), Shape::Of(other, columns)) => {
                if self.found.unify(inner, other) {
                    return Shape::Of(rows, columns);
                }
                self.misfit(id, pair, "a product needs as many columns on the left as rows on the right.")
            }
            _ => Shape::Unknown,
        }
    }

    fn part(&mut self, whole: Shape, rows: Span, columns: Option<Span>, place: Place) -> Shape {
        let Shape::Of(height, width) = whole else { return Shape::Unknown };
        let (rows, columns) = match columns {
            Some(columns) => (rows, columns),
            None if self.is_one(width) => (rows, (Size::ONE, None)),
            None if self.is_one(height) => ((Size::ONE, None), rows),
            None => {
                let mut words = Words::new("This is ");
                self.found.shape(whole).say(&mut words);
                self.faults.words(place, words.text(": a part of it needs a row and a column, as P[1, 2] or H[1, :]."));
                return Shape::Unknown;
            }
        };
        let mut sides = [Size::ONE; 2];
        for (side, ((first, last), all)) in sides.iter_mut().zip([(rows, height), (columns, width)]) {
            let last = last.unwrap_or(all);
            *side = last.plus(-1, first).plus(1, Size::ONE);
            let beyond = self.found.size(last.plus(-1, all)).known().is_some_and(|over| over > 0);
            let empty = self.found.size(*side).known().is_some_and(|count| count < 1);
            if beyond || empty {
                let mut words = Words::new("This is ");
                self.found.shape(whole).say(&mut words);
                self.faults.words(place, words.text(": it has no such rows or columns."));
                return Shape::Unknown;
            }
        }
        Shape::Of(sides[0], sides[1])
    }

    fn block(&mut self, rows: &[Vec<Id>]) -> Shape {
        let (mut height, mut width) = (Size::number(0), None);
        for row in rows {
            let (mut high, mut across) = (None, Size::number(0));
            for id in row {
                let place = self.tree.place(*id);
                let (tall, wide) = match self.shape(*id) {
                    Shape::Of(tall, wide) => (tall, wide),
                    Shape::Identity => {
                        self.faults.say(place, "Between brackets I needs its size: eye(n), eye(p) or eye(2).");
                        return Shape::Unknown;
                    }
                    Shape::Unknown => return Shape::Unknown,
                };
                if !self.found.unify(*high.get_or_insert(tall), tall) {
                    let mut words = self.sized(*id, Shape::Of(tall, wide));
                    self.faults.words(place, words.text("; all parts of a row have as many rows as its first."));
                    return Shape::Unknown;
                }
                across = across.plus(1, wide);
            }
            if !self.found.unify(*width.get_or_insert(across), across) {
                let place = self.tree.place(row[0]);
                self.faults.say(place, "This row is not as wide as the one above it.");
                return Shape::Unknown;
            }
            height = height.plus(1, high.unwrap_or(Size::ONE));
            // Blocks of blocks would double without end.
            if [height, across].iter().any(|side| self.found.size(*side).is_beyond(MOST_SIDE)) {
                self.faults.say(self.tree.place(row[0]), "A matrix has at most 64 rows and 64 columns.");
                return Shape::Unknown;
            }
        }
        Shape::Of(height, width.unwrap_or(Size::ONE))
    }

    fn jacobian(&mut self, a: Id, name: Name, place: Place) -> Shape {
        if self.within_jacobian {
            self.faults.say(place, "A derivative of a derivative is not known here.");
            return Shape::Unknown;
        }
        let by = self.name(name, place);
        let before = self.products;
        self.within_jacobian = true;
        let of = self.shape(a);
        self.within_jacobian = false;
        let (Shape::Of(rows, of_width), Shape::Of(columns, by_width)) = (of, by) else { return Shape::Unknown };
        if !self.found.unify(of_width, Size::ONE) || !self.found.unify(by_width, Size::ONE) {
            let mut words = self.sized(a, of);
            words.text(" and ").text(&self.names[name]).text(" is ");
            self.found.shape(by).say(&mut words);
            self.faults.words(place, words.text(": a derivative is of a column by a column."));
            return Shape::Unknown;
        }
        let times = self.found.size(columns).known().unwrap_or(1).max(0) as u64;
        let once = self.products - before;
        self.products = self.products.saturating_add(once.saturating_mul(3 * times));
        Shape::Of(rows, columns)
    }

    /// The size that an argument of eye or zeros names.
    fn side(&mut self, id: Id) -> Option<Size> {
        let size = match &self.tree.nodes[id].0 {
            Node::Number(x) if libm::trunc(*x) == *x && *x >= 0.0 => Size::number((*x).min(1000.0) as i32),
            Node::Name(name) => Size::letter(self.world.size_letter(*name)?),
            Node::Call(Function::Length, arguments) => {
                let Shape::Of(rows, columns) = self.shape(arguments[0]) else { return None };
                let second = matches!(arguments.get(1).map(|id| &self.tree.nodes[*id].0), Some(Node::Number(2.0)));
                if second { columns } else { rows }
            }
            _ => return None,
        };
        self.found.size(size).known().is_none_or(|known| known <= MOST_SIDE).then_some(size)
    }

    fn call(&mut self, function: Function, arguments: &[Id], place: Place) -> Shape {
        use Function as F;
        let first = arguments[0];
        if let F::Eye | F::Zeros = function {
            let sides: Option<Vec<Size>> = arguments.iter().map(|id| self.side(*id)).collect();
            let Some(sides) = sides else {
                self.faults.say(place, "A size is a whole number of at most 64 here, or n, p or m.");
                return Shape::Unknown;
            };
            let columns = *sides.last().unwrap_or(&sides[0]);
            return Shape::Of(sides[0], columns);
        }
        let shape = self.shape(first);
        let second = arguments.get(1).map(|id| self.shape(*id));
        if shape == Shape::Unknown || second == Some(Shape::Unknown) {
            return Shape::Unknown;
        }
        let size = |number| Shape::Of(Size::number(number), Size::ONE);
        match function {
            F::Length => Shape::NUMBER,
            F::Array => shape,
            F::Transpose => match shape {
                Shape::Of(rows, columns) => Shape::Of(columns, rows),
                other => other,
            },
            F::Inverse | F::Root | F::Symmetric | F::Trace | F::Determinant => {
                let square = self.square(first, shape, place);
                if let Shape::Of(n, _) = square {
                    self.count([n, n, n]);
                    self.count([n, n, n]);
                }
                let number = matches!(function, F::Trace | F::Determinant) && square != Shape::Unknown;
                if square == Shape::Identity && function != F::Inverse && function != F::Symmetric {
                    self.faults.say(place, "Here I needs its size: eye(n), eye(p) or eye(2).");
                    return Shape::Unknown;
                }
                if number { Shape::NUMBER } else { square }
            }
            F::Solve | F::Product => {
                let sign = if function == F::Solve { Sign::Under } else { Sign::Times };
                self.binary(first, sign, first, arguments[1])
            }
            F::Diagonal => match shape {
                Shape::Of(rows, columns) if self.is_one(columns) => Shape::Of(rows, rows),
                _ => match self.square(first, shape, place) {
                    Shape::Of(rows, _) => Shape::Of(rows, Size::ONE),
                    other => other,
                },
            },
            F::Norm => Shape::NUMBER,
            F::Absolute | F::Wrap => shape,
            F::Motion | F::Sensor => {
                let state = size(3);
                let fits = self.same(shape, state) && second.is_some_and(|second| self.same(second, size(2)));
                if !fits {
                    let words = "f takes a state of 3×1 and an input of 2×1, h a state and a landmark of 2×1.";
                    self.faults.say(place, words);
                    return Shape::Unknown;
                }
                if function == F::Motion { state } else { size(2) }
            }
            F::Angle => {
                if !self.same(shape, Shape::NUMBER) || !second.is_some_and(|second| self.same(second, Shape::NUMBER)) {
                    self.faults.say(place, "atan2 takes two numbers.");
                    return Shape::Unknown;
                }
                Shape::NUMBER
            }
            _ => {
                let Shape::Of(rows, columns) = shape else { return shape };
                if self.is_one(rows) || self.found.unify(columns, Size::ONE) {
                    return shape;
                }
                let mut words = self.sized(first, shape);
                words.text("; this function takes a number or a column. The root of a matrix is chol.");
                self.faults.words(place, &words);
                Shape::Unknown
            }
        }
    }
}
