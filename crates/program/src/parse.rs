//! Tokens as a tree: lines, and operators by their rank, as the chapter, numpy, MATLAB and Julia write them.

mod beginning;
mod bracket;
mod operand;

use crate::fault::{Faults, Span};
use crate::time::Time;
use crate::token::{Kind, Token};
use crate::tree::{Function, Id, Line, Name, Node, Tree};
use crate::words::Words;
use alloc::string::String;
use alloc::vec::Vec;

/// Brackets within brackets.
const DEEPEST: usize = 40;
/// Operations within one another, which a step goes through with one call each.
const DEEPEST_TREE: u8 = 120;
/// Parts of all formulas together.
const MOST_NODES: usize = 4000;
/// Lines with a formula.
pub const MOST_LINES: usize = 200;

pub(crate) struct Parser<'a, 'b> {
    tokens: &'a [Token],
    at: usize,
    names: &'a mut Vec<String>,
    /// Whether there are f and h.
    robot: bool,
    faults: &'a mut Faults<'b>,
    pub tree: Tree,
    /// What lines have made, with its time.
    assigned: Vec<(Name, Time, Span)>,
    /// How deep each node's tree is.
    deep: Vec<u8>,
    depth: usize,
    /// `(` where a line's end counts for nothing, a blank where blanks separate a matrix's parts, else a comma.
    within: char,
}

/// The place of the fault has been told.
pub(super) struct Told;
pub(super) type Parsed<T> = Result<T, Told>;

impl<'a, 'b> Parser<'a, 'b> {
    pub fn new(tokens: &'a [Token], names: &'a mut Vec<String>, robot: bool, faults: &'a mut Faults<'b>) -> Self {
        let (tree, assigned) = (Tree::default(), Vec::new());
        Self { tokens, at: 0, names, robot, faults, tree, assigned, deep: Vec::new(), depth: 0, within: ',' }
    }

    /// All lines; a line with a fault is left at its end.
    pub fn lines(&mut self) {
        loop {
            while matches!(self.kind(), Kind::Line | Kind::Sign(';')) {
                self.at += 1;
            }
            if self.kind() == Kind::End {
                return;
            }
            if self.tree.lines.len() >= MOST_LINES {
                self.faults.say(self.place(), "A program has at most 200 lines; what begins here is beyond them.");
                return;
            }
            (self.depth, self.within) = (0, ',');
            let first = self.at;
            if self.line().is_err() {
                self.leave(first);
            }
        }
    }

    /// To the end of a line with a fault. What it was to make counts as made, of a size that is not known.
    fn leave(&mut self, first: usize) {
        let at = core::mem::replace(&mut self.at, first);
        if let (Kind::Name(name), Kind::Sign('=' | '[')) = (self.kind(), self.ahead(1)) {
            let Token { time, place, .. } = self.token();
            self.assigned.push((name, time, place));
            self.tree.lines.push(Line { name, part: None, value: None, place });
        }
        self.at = at;
        while !matches!(self.kind(), Kind::Line | Kind::End) {
            self.at += 1;
        }
    }

    #[inline(never)]
    fn token(&self) -> Token {
        self.tokens[self.at.min(self.tokens.len() - 1)]
    }

    #[inline(never)]
    fn kind(&self) -> Kind {
        self.token().kind
    }

    #[inline(never)]
    fn ahead(&self, by: usize) -> Kind {
        self.tokens[(self.at + by).min(self.tokens.len() - 1)].kind
    }

    fn place(&self) -> Span {
        self.token().place
    }

    fn before(&self) -> Span {
        self.tokens[self.at.saturating_sub(1)].place
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.kind() == Kind::Sign(sign);
        self.at += usize::from(found);
        found
    }

    fn is(&self, name: Name, text: &str) -> bool {
        self.names[name] == text
    }

    #[inline(never)]
    fn fail<T>(&mut self, place: Span, words: &str) -> Parsed<T> {
        self.faults.say(place, words);
        Err(Told)
    }

    fn told<T>(&mut self, place: Span, words: Words) -> Parsed<T> {
        self.faults.words(place, words);
        Err(Told)
    }

    /// What is missing here; at a line's end there, where others have been passed over to look for it.
    fn missing<T>(&mut self, what: &str) -> Parsed<T> {
        let mut words = Words::new("Here ");
        words.text(what).text(" is missing.");
        let ends = self.tokens.iter().take(self.at + 1).rev().take_while(|token| token.kind == Kind::Line);
        self.told(ends.last().map_or(self.place(), |end| end.place), words)
    }

    #[inline(never)]
    fn node(&mut self, node: Node, from: Span) -> Parsed<Id> {
        if self.tree.nodes.len() >= MOST_NODES {
            return self.fail(from, "The program is too long: from here on it is not read.");
        }
        let mut deep = 0;
        if let Node::Call(_, from, to) = node {
            for id in self.tree.arguments(from, to) {
                deep = deep.max(self.deep[*id]);
            }
        }
        if deep >= DEEPEST_TREE {
            return self.fail(from, "The formula is too long: give a part of it a name in a line of its own.");
        }
        self.deep.push(deep + 1);
        let to = self.before().to.max(from.to);
        self.tree.nodes.push((node, Span { from: from.from, to }));
        Ok(self.tree.nodes.len() - 1)
    }

    fn call(&mut self, function: Function, arguments: &[Id], from: Span) -> Parsed<Id> {
        let first = self.tree.arguments.len();
        self.tree.arguments.extend_from_slice(arguments);
        self.node(Node::Call(function, first, first + arguments.len()), from)
    }

    fn line(&mut self) -> Parsed<()> {
        let Token { kind, time, place, .. } = self.token();
        let Kind::Name(name) = kind else {
            let why = match kind {
                Kind::Number(_) => "A line begins with the name that it makes; a number before it is left out.",
                Kind::Sign('\\') => "A letter is typed by its name alone: mu, Sigma, nu.",
                _ => "A line begins with the name that it makes: name = formula.",
            };
            return self.fail(place, why);
        };
        self.begins(name, place)?;
        self.at += 1;
        let closing = match self.kind() {
            Kind::Sign('[') => Some(']'),
            Kind::Sign('(') => Some(')'),
            _ => None,
        };
        let mut part = None;
        if let Some(closing) = closing {
            self.at += 1;
            let whole = self.node(Node::Name(name), place)?;
            part = Some(self.part(whole, closing, place)?);
        }
        // `x += a` is x = x + a, and `x- = a` is a name that cannot be.
        let close = !self.tokens[(self.at + 1).min(self.tokens.len() - 1)].blank;
        let added = match (self.kind(), self.ahead(1)) {
            _ if !close => None,
            (Kind::Sign('+'), Kind::Sign('=')) => Some(Function::Plus),
            (Kind::Sign('-'), Kind::Sign('=')) => Some(Function::Minus),
            _ => None,
        };
        self.at += usize::from(added.is_some());
        self.names_one(name, place)?;
        if !self.take('=') {
            return self.missing("a =");
        }
        let mut value = self.formula()?;
        if let Some(sign) = added {
            let old = match part {
                Some(part) => part,
                None => self.node(Node::Name(name), place)?,
            };
            value = self.call(sign, &[old, value], place)?;
        }
        match self.kind() {
            Kind::Line | Kind::End | Kind::Sign(';') => {}
            Kind::Sign('=' | ',') => return self.fail(self.place(), "A line makes one name by one formula."),
            Kind::Sign(')' | ']') => return self.fail(self.place(), "This bracket was never opened."),
            _ => return self.missing("a sign of an operation"),
        }
        self.assigned.push((name, time, place));
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
            let token = self.operator();
            let sign = match token.kind {
                Kind::Sign('+') => Function::Plus,
                Kind::Sign('-') => Function::Minus,
                _ => break,
            };
            // Between a matrix's brackets `a -b` are two parts, and `a - b` is one. Before = the sign is of +=.
            if self.within == ' ' && token.blank && !token.blank_behind {
                break;
            }
            left = self.joined(sign, left, from, Self::term)?;
        }
        self.depth -= 1;
        Ok(left)
    }

    /// The left side, with what stands behind the operator.
    fn joined(&mut self, sign: Function, left: Id, from: Span, read: fn(&mut Self) -> Parsed<Id>) -> Parsed<Id> {
        self.at += 1;
        // A formula that ends with an operator goes on in the next line.
        self.skip_lines();
        let right = read(self)?;
        self.call(sign, &[left, right], from)
    }

    /// The token behind an operand.
    fn operator(&mut self) -> Token {
        if self.within == '(' {
            self.skip_lines();
        }
        self.token()
    }

    fn term(&mut self) -> Parsed<Id> {
        let from = self.place();
        let mut left = self.signed()?;
        loop {
            let token = self.operator();
            let sign = match token.kind {
                Kind::Sign('*') => Function::Times,
                Kind::Sign('/') => Function::Over,
                Kind::Sign('\\') => Function::Under,
                Kind::Name(_) | Kind::Number(_) | Kind::Sign('(' | '[') if !(self.within == ' ' && token.blank) => {
                    let right = self.powered()?;
                    left = self.call(Function::Times, &[left, right], from)?;
                    continue;
                }
                _ => return Ok(left),
            };
            left = self.joined(sign, left, from, Self::signed)?;
        }
    }

    fn signed(&mut self) -> Parsed<Id> {
        let from = self.place();
        let mut negative = false;
        while let Kind::Sign(sign @ ('-' | '+')) = self.kind() {
            negative ^= sign == '-';
            self.at += 1;
        }
        let value = self.powered()?;
        if negative { self.call(Function::Negative, &[value], from) } else { Ok(value) }
    }

    /// Over ends of lines, but not into the next formula: then a bracket is open, and whoever opened it says so.
    fn skip_lines(&mut self) {
        while self.kind() == Kind::Line {
            match (self.ahead(1), self.ahead(2)) {
                (Kind::Name(_), Kind::Sign('=')) | (Kind::End, _) => return,
                _ => self.at += 1,
            }
        }
    }
}
