//! Tokens as a tree: operators by their rank, as the chapter, numpy, MATLAB and Julia write them.

use crate::fault::{Faults, Place};
use crate::size::{LETTERS, Size};
use crate::token::{Kind, Token};
use crate::tree::{FUNCTIONS, Function, Id, Line, Name, Node, Sign, Span, Tree};
use crate::words::Words;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

/// Brackets within brackets.
const DEEPEST: usize = 40;
/// Parts of all formulas together.
const MOST_NODES: usize = 4000;
/// Lines with a formula.
pub const MOST_LINES: usize = 200;

pub(crate) struct Parser<'a, 'b> {
    pub tokens: &'a [Token],
    pub at: usize,
    pub names: &'a mut Vec<String>,
    /// Names from here on are the program's own.
    pub given: usize,
    /// Whether there are f and h.
    pub robot: bool,
    pub faults: &'a mut Faults<'b>,
    pub tree: Tree,
    assigned: Vec<Name>,
    depth: usize,
    /// Whether blanks separate parts, as between a MATLAB matrix's brackets.
    blanks: bool,
}

/// The place of the fault has been told.
struct Told;
type Parsed<T> = Result<T, Told>;

impl<'a, 'b> Parser<'a, 'b> {
    pub fn new(tokens: &'a [Token], names: &'a mut Vec<String>, robot: bool, faults: &'a mut Faults<'b>) -> Self {
        let given = names.len();
        let (tree, assigned) = (Tree::default(), Vec::new());
        Self { tokens, at: 0, names, given, robot, faults, tree, assigned, depth: 0, blanks: false }
    }

    /// All lines; a line with a fault is left at its end.
    pub fn lines(&mut self) {
        loop {
            while matches!(self.kind(), Kind::Line | Kind::Sign(';')) {
                self.at += 1;
            }
            if *self.kind() == Kind::End {
                return;
            }
            if self.tree.lines.len() >= MOST_LINES {
                self.faults.say(self.place(), "A program has at most 200 lines; what begins here is beyond them.");
                return;
            }
            (self.depth, self.blanks) = (0, false);
            let first = self.at;
            if self.line().is_err() {
                self.leave(first);
            }
        }
    }

    /// To the end of a line with a fault. What it was to make counts as made, of a size that is not known.
    fn leave(&mut self, first: usize) {
        let assigns = matches!(self.tokens.get(first + 1).map(|token| &token.kind), Some(Kind::Sign('=' | '[')));
        if let (Kind::Name(name), true) = (&self.tokens[first].kind, assigns) {
            let (name, place) = (self.named(name), self.tokens[first].place);
            self.assigned.push(name);
            self.tree.lines.push(Line { name, part: None, value: None, place });
        }
        while !matches!(self.kind(), Kind::Line | Kind::End) {
            self.at += 1;
        }
    }

    fn kind(&self) -> &'a Kind {
        &self.tokens[self.at.min(self.tokens.len() - 1)].kind
    }

    fn ahead(&self, by: usize) -> &'a Kind {
        &self.tokens[(self.at + by).min(self.tokens.len() - 1)].kind
    }

    fn token(&self) -> &'a Token {
        &self.tokens[self.at.min(self.tokens.len() - 1)]
    }

    fn place(&self) -> Place {
        self.token().place
    }

    fn take(&mut self, sign: char) -> bool {
        let found = *self.kind() == Kind::Sign(sign);
        self.at += usize::from(found);
        found
    }

    fn fail<T>(&mut self, place: Place, words: &str) -> Parsed<T> {
        self.faults.say(place, words);
        Err(Told)
    }

    /// What is missing here.
    fn missing<T>(&mut self, what: &str) -> Parsed<T> {
        let mut words = Words::new("Here ");
        words.text(what).text(" is missing.");
        let place = self.place();
        self.faults.words(place, &words);
        Err(Told)
    }

    fn named(&mut self, name: &str) -> Name {
        self.names.iter().position(|known| known == name).unwrap_or_else(|| {
            self.names.push(name.into());
            self.names.len() - 1
        })
    }

    fn is_assigned(&self, name: &str) -> bool {
        self.assigned.iter().any(|known| self.names[*known] == name)
    }

    fn node(&mut self, node: Node, from: Place) -> Parsed<Id> {
        let to = if self.at > 0 { self.tokens[self.at - 1].place.to } else { from.to };
        if self.tree.nodes.len() >= MOST_NODES {
            return self.fail(from, "The program is too long: from here on it is not read.");
        }
        self.tree.nodes.push((node, Place { from: from.from, to: to.max(from.to) }));
        Ok(self.tree.nodes.len() - 1)
    }

    fn line(&mut self) -> Parsed<()> {
        let place = self.place();
        let Kind::Name(text) = self.kind() else {
            return self.fail(place, "A line begins with the name that it makes: name = formula.");
        };
        self.at += 1;
        match text.as_str() {
            "return" | "end" => {
                return self.fail(place, "A program needs no end: what its names are then is its answer.");
            }
            "import" | "from" | "using" => {
                return self.fail(place, "A program needs no packages: leave this line out.");
            }
            "def" | "function" | "for" | "while" | "if" | "let" | "const" => {
                return self.fail(place, "A program is lines of formulas, without loops, choices and functions.");
            }
            _ => {}
        }
        let part = match self.kind() {
            Kind::Sign(opening @ ('[' | '(')) => {
                self.at += 1;
                Some(self.spans(if *opening == '[' { ']' } else { ')' })?)
            }
            _ => None,
        };
        // `x += a` is x = x + a.
        let added = match (self.kind(), self.ahead(1)) {
            (Kind::Sign(sign @ ('+' | '-' | '*')), Kind::Sign('=')) => Some(*sign),
            _ => None,
        };
        self.at += usize::from(added.is_some());
        let equals = self.place();
        if !self.take('=') {
            return self.missing("a =");
        }
        if *self.kind() == Kind::Sign('=') {
            return self.fail(equals, "A formula makes a name with a single =.");
        }
        let name = self.named(text);
        let mut value = self.formula()?;
        if let Some(sign) = added {
            let old = self.node(Node::Name(name), place)?;
            let old = match part {
                Some((rows, columns)) => self.node(Node::Part(old, rows, columns), place)?,
                None => old,
            };
            let sign = match sign {
                '+' => Sign::Plus,
                '-' => Sign::Minus,
                _ => Sign::Times,
            };
            value = self.node(Node::Binary(sign, old, value), place)?;
        }
        match self.kind() {
            Kind::Line | Kind::End | Kind::Sign(';') => {}
            Kind::Sign('=') => {
                return self.fail(self.place(), "A line makes one name: a second = belongs in another line.");
            }
            Kind::Sign(',') => return self.fail(self.place(), "A line makes one name by one formula."),
            Kind::Sign(')' | ']') => return self.fail(self.place(), "This bracket was never opened."),
            _ => return self.missing("a sign of an operation"),
        }
        self.assigned.push(name);
        self.tree.lines.push(Line { name, part, value: Some(value), place });
        Ok(())
    }

    fn formula(&mut self) -> Parsed<Id> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return self.fail(self.place(), "Too many brackets stand within one another.");
        }
        let from = self.place();
        let mut left = self.term()?;
        loop {
            let token = self.token();
            let sign = match token.kind {
                Kind::Sign('+') => Sign::Plus,
                Kind::Sign('-') => Sign::Minus,
                _ => break,
            };
            // Between a matrix's brackets `a -b` are two parts, and `a - b` is one.
            if self.blanks && token.blank && !token.blank_behind {
                break;
            }
            self.at += 1;
            self.go_on();
            let right = self.term()?;
            left = self.node(Node::Binary(sign, left, right), from)?;
        }
        self.depth -= 1;
        Ok(left)
    }

    /// A formula that ends with an operator goes on in the next line.
    fn go_on(&mut self) {
        while *self.kind() == Kind::Line && !matches!(self.ahead(1), Kind::End) {
            self.at += 1;
        }
    }

    fn term(&mut self) -> Parsed<Id> {
        let from = self.place();
        let mut left = self.signed()?;
        loop {
            let token = self.token();
            let sign = match &token.kind {
                Kind::Sign('*') => Sign::Times,
                Kind::Sign('/') => Sign::Over,
                Kind::Sign('\\') => Sign::Under,
                Kind::Name(_) | Kind::Number(_) | Kind::Sign('(' | '[') if !(self.blanks && token.blank) => {
                    let right = self.signed()?;
                    left = self.node(Node::Binary(Sign::Times, left, right), from)?;
                    continue;
                }
                _ => return Ok(left),
            };
            self.at += 1;
            self.go_on();
            let right = self.signed()?;
            left = self.node(Node::Binary(sign, left, right), from)?;
        }
    }

    fn signed(&mut self) -> Parsed<Id> {
        let from = self.place();
        let mut negative = false;
        while matches!(self.kind(), Kind::Sign('-' | '+')) {
            negative ^= *self.kind() == Kind::Sign('-');
            self.at += 1;
        }
        let value = self.powered()?;
        if negative { self.node(Node::Negative(value), from) } else { Ok(value) }
    }

    /// An operand with what stands behind it.
    fn powered(&mut self) -> Parsed<Id> {
        let from = self.place();
        let mut value = self.operand()?;
        loop {
            let token = self.token();
            if self.blanks && token.blank {
                return Ok(value);
            }
            let node = match &token.kind {
                Kind::Sign('t') => Node::Transpose(value),
                Kind::Sign('i') => Node::Power(value, -1),
                Kind::Sign(digit @ ('2' | '3')) => Node::Power(value, *digit as i32 - '0' as i32),
                Kind::Sign('^') => {
                    self.at += 1;
                    let node = self.power(value)?;
                    value = self.node(node, from)?;
                    continue;
                }
                Kind::Sign('[') if !token.blank => {
                    self.at += 1;
                    let (rows, columns) = self.spans(']')?;
                    value = self.node(Node::Part(value, rows, columns), from)?;
                    continue;
                }
                Kind::Method(name) => {
                    value = self.method(name, value, from)?;
                    continue;
                }
                _ => return Ok(value),
            };
            self.at += 1;
            value = self.node(node, from)?;
        }
    }

    /// Behind ^: a whole number, or T for the transpose.
    fn power(&mut self, value: Id) -> Parsed<Node> {
        let bracket = self.take('(');
        let negative = self.take('-');
        let node = match self.kind() {
            Kind::Name(name) if name == "T" && !negative => Node::Transpose(value),
            Kind::Number(power) if libm::trunc(*power) == *power && *power <= 16.0 => {
                Node::Power(value, if negative { -(*power as i32) } else { *power as i32 })
            }
            _ => return self.fail(self.place(), "A power is a whole number of at most 16; a root is sqrt or chol."),
        };
        self.at += 1;
        if bracket && !self.take(')') { self.missing("a )") } else { Ok(node) }
    }

    fn method(&mut self, name: &str, value: Id, from: Place) -> Parsed<Id> {
        let place = self.place();
        self.at += 1;
        match name {
            "T" => self.node(Node::Transpose(value), from),
            "L" => Ok(value),
            "transpose" | "inverse" | "dot" | "copy" => {
                if !self.take('(') {
                    return self.missing("a (");
                }
                let function = match name {
                    "transpose" => Function::Transpose,
                    "inverse" => Function::Inverse,
                    "dot" => Function::Product,
                    _ => Function::Array,
                };
                let mut arguments = vec![value];
                self.arguments(&mut arguments)?;
                if arguments.len() != 1 + usize::from(name == "dot") {
                    return self.fail(place, "This has another count of arguments than it takes.");
                }
                self.node(Node::Call(function, arguments), from)
            }
            _ => self.fail(place, "Behind a point only T is known, the transpose."),
        }
    }

    fn operand(&mut self) -> Parsed<Id> {
        let (token, from) = (self.token(), self.place());
        match &token.kind {
            Kind::Number(number) => {
                self.at += 1;
                self.node(Node::Number(*number), from)
            }
            Kind::Name(name) => {
                self.at += 1;
                self.name(name, from)
            }
            Kind::Sign('(') => {
                self.at += 1;
                let blanks = core::mem::replace(&mut self.blanks, false);
                let value = self.within(Self::formula)?;
                self.blanks = blanks;
                self.close(')', from)?;
                Ok(value)
            }
            Kind::Sign('[') => {
                self.at += 1;
                self.block(from)
            }
            Kind::Line | Kind::End => self.missing("a formula"),
            _ => self.missing("a name, a number or a bracket"),
        }
    }

    /// Between brackets a line's end counts for nothing.
    fn within<T>(&mut self, read: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        self.skip_lines();
        let value = read(self)?;
        self.skip_lines();
        Ok(value)
    }

    /// Over ends of lines, but not into the next formula: then a bracket is open, and whoever opened it says so.
    fn skip_lines(&mut self) {
        while *self.kind() == Kind::Line && !matches!((self.ahead(1), self.ahead(2)), (Kind::Name(_), Kind::Sign('=')))
        {
            if *self.ahead(1) == Kind::End {
                return;
            }
            self.at += 1;
        }
    }

    fn close(&mut self, sign: char, opened: Place) -> Parsed<()> {
        if self.take(sign) {
            return Ok(());
        }
        if matches!(self.kind(), Kind::Line | Kind::End) {
            return self.fail(opened, "This bracket is never closed.");
        }
        self.missing(if sign == ')' { "a )" } else { "a ]" })
    }

    fn name(&mut self, text: &str, from: Place) -> Parsed<Id> {
        let open = *self.kind() == Kind::Sign('(');
        let close_by = open && !self.token().blank;
        let function = FUNCTIONS.iter().find(|(name, function, ..)| {
            *name == text && (self.robot || !matches!(function, Function::Motion | Function::Sensor))
        });
        if let (Some((_, function, least, most)), true) = (function, open && !self.is_assigned(text)) {
            self.at += 1;
            if *function == Function::Jacobian {
                return self.jacobian(from);
            }
            let mut arguments = Vec::new();
            // numpy puts sizes into brackets of their own.
            let pair = *function == Function::Zeros && self.take('(');
            self.arguments(&mut arguments)?;
            if pair {
                self.close(')', from)?;
            }
            let count = arguments.len();
            if count < *least || count > *most {
                let mut words = Words::new(text);
                words.text(" takes ").whole(*most as i64).text(if *most == 1 { " argument; " } else { " arguments; " });
                words.text("here it has ").whole(count as i64).text(".");
                self.faults.words(from, &words);
                return Err(Told);
            }
            return self.node(Node::Call(*function, arguments), from);
        }
        let name = self.named(text);
        let value = self.node(Node::Name(name), from)?;
        // MATLAB takes parts with round brackets; a formula in them is a factor.
        if close_by && self.is_part() {
            self.at += 1;
            let (rows, columns) = self.spans(')')?;
            return self.node(Node::Part(value, rows, columns), from);
        }
        Ok(value)
    }

    /// Whether round brackets hold numbers of rows and columns: a whole number alone, a colon, or a comma.
    fn is_part(&self) -> bool {
        if matches!((self.ahead(1), self.ahead(2)), (Kind::Number(_), Kind::Sign(')'))) {
            return true;
        }
        let mut depth = 0;
        for by in 1.. {
            match self.ahead(by) {
                Kind::Sign('(' | '[') => depth += 1,
                Kind::Sign(')' | ']') if depth == 0 => return false,
                Kind::Sign(')' | ']') => depth -= 1,
                Kind::Sign(':' | ',') if depth == 0 => return true,
                Kind::Line | Kind::End => return false,
                _ => {}
            }
        }
        false
    }

    /// Arguments up to the closing bracket.
    fn arguments(&mut self, arguments: &mut Vec<Id>) -> Parsed<()> {
        let opened = self.tokens[self.at - 1].place;
        let blanks = core::mem::replace(&mut self.blanks, false);
        self.skip_lines();
        if !self.take(')') {
            loop {
                arguments.push(self.within(Self::formula)?);
                if !self.take(',') {
                    break;
                }
            }
            self.close(')', opened)?;
        }
        self.blanks = blanks;
        Ok(())
    }

    /// `jac(formula, name)`; of `jac(f, name)` and `jac(h, name)` the other argument is the world's own.
    fn jacobian(&mut self, from: Place) -> Parsed<Id> {
        let opened = self.tokens[self.at - 1].place;
        let blanks = core::mem::replace(&mut self.blanks, false);
        let start = self.at;
        let bare = match (self.kind(), self.ahead(1)) {
            (Kind::Name(name), Kind::Sign(',')) if self.robot && !self.is_assigned(name) => match name.as_str() {
                "f" => Some((Function::Motion, ["x", "u"])),
                "h" => Some((Function::Sensor, ["x", "l"])),
                _ => None,
            },
            _ => None,
        };
        let formula = match bare {
            Some(_) => {
                self.at += 1;
                None
            }
            None => Some(self.within(Self::formula)?),
        };
        if !self.take(',') {
            return self.missing("a comma, and the name by which is differentiated,");
        }
        self.skip_lines();
        let place = self.place();
        let Kind::Name(by) = self.kind() else {
            return self.fail(place, "jac takes a formula and the name by which is differentiated: jac(f(x, u), x).");
        };
        self.at += 1;
        let by = self.named(by);
        self.skip_lines();
        self.close(')', opened)?;
        let formula = match (formula, bare) {
            (Some(formula), _) => formula,
            (None, Some((function, [state, other]))) => {
                // The robot's state is named after the notation: it is the first of the given names.
                let (state, other) = (if state == "x" { 0 } else { self.named(state) }, self.named(other));
                let first = if by == other { state } else { by };
                let place = self.tokens[start].place;
                let arguments = vec![self.node(Node::Name(first), place)?, self.node(Node::Name(other), place)?];
                self.node(Node::Call(function, arguments), place)?
            }
            (None, None) => return Err(Told),
        };
        self.blanks = blanks;
        self.node(Node::Jacobian(formula, by), from)
    }

    /// Numbers of rows and columns up to the closing bracket.
    fn spans(&mut self, closing: char) -> Parsed<(Span, Option<Span>)> {
        let opened = self.tokens[self.at - 1].place;
        let rows = self.span()?;
        let columns = if self.take(',') { Some(self.span()?) } else { None };
        self.close(closing, opened)?;
        Ok((rows, columns))
    }

    fn span(&mut self) -> Parsed<Span> {
        if self.take(':') {
            return Ok((Size::ONE, None));
        }
        let first = self.side()?;
        if !self.take(':') {
            return Ok((first, Some(first)));
        }
        if matches!(self.kind(), Kind::Sign(']' | ')' | ',')) {
            return Ok((first, None));
        }
        if matches!(self.kind(), Kind::Name(name) if name == "end") {
            self.at += 1;
            return Ok((first, None));
        }
        Ok((first, Some(self.side()?)))
    }

    /// One number of a row or column, from 1: a whole number, n, p or m.
    fn side(&mut self) -> Parsed<Size> {
        let place = self.place();
        let size = match self.kind() {
            Kind::Number(number) if libm::trunc(*number) == *number && *number <= 999.0 => Size::number(*number as i32),
            Kind::Name(name) => match LETTERS.iter().position(|letter| letter == name) {
                Some(letter) => Size::letter(letter),
                None => return self.fail(place, "A row or a column is a whole number here, or n, p or m."),
            },
            _ => return self.fail(place, "A row or a column is a whole number here, from 1 on."),
        };
        self.at += 1;
        if size == Size::number(0) {
            return self.fail(place, "Rows and columns are counted from 1 here: x[1] is the first.");
        }
        Ok(size)
    }

    /// Rows of parts up to the closing bracket. Without a comma, blanks separate the parts of a row, as in MATLAB.
    fn block(&mut self, opened: Place) -> Parsed<Id> {
        let blanks = {
            let separate = !self.has_comma();
            core::mem::replace(&mut self.blanks, separate)
        };
        let (mut rows, mut row): (Vec<Vec<Id>>, Vec<Id>) = (Vec::new(), Vec::new());
        loop {
            let line = matches!(self.kind(), Kind::Line) && !row.is_empty();
            self.skip_lines();
            if matches!(self.kind(), Kind::Sign(']')) {
                break;
            }
            if matches!(self.kind(), Kind::Line | Kind::End) {
                return self.fail(opened, "This bracket is never closed.");
            }
            if self.take(';') || line {
                if !row.is_empty() {
                    rows.push(core::mem::take(&mut row));
                }
                continue;
            }
            row.push(self.formula()?);
            if self.take(',') {
                self.skip_lines();
            }
        }
        self.at += 1;
        if !row.is_empty() {
            rows.push(row);
        }
        self.blanks = blanks;
        if rows.is_empty() {
            return self.fail(opened, "Between these brackets a matrix is missing.");
        }
        // numpy writes a matrix as a list of its rows.
        let is_list = |id: &Id| matches!(self.tree.nodes[*id].0, Node::Block(_));
        if let [only] = rows.as_slice()
            && only.iter().all(is_list)
        {
            rows = only.iter().map(|id| vec![*id]).collect();
        }
        self.node(Node::Block(rows), opened)
    }

    /// Whether there is a comma between these brackets, and not only between others within.
    fn has_comma(&self) -> bool {
        let mut depth = 0;
        for by in 0.. {
            match self.ahead(by) {
                Kind::Sign('(' | '[') => depth += 1,
                Kind::Sign(')' | ']') if depth == 0 => return false,
                Kind::Sign(')' | ']') => depth -= 1,
                Kind::Sign(',') if depth == 0 => return true,
                Kind::Line if matches!((self.ahead(by + 1), self.ahead(by + 2)), (Kind::Name(_), Kind::Sign('='))) => {
                    break;
                }
                Kind::End => break,
                _ => {}
            }
        }
        false
    }
}
