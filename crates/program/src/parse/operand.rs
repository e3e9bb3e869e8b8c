//! What stands between operators: names, numbers, brackets, calls, and what stands behind them.

use super::{Parsed, Parser, Told};
use crate::fault::{Span, line_of};
use crate::time::Time;
use crate::token::{Kind, Token, named};
use crate::tree::{FUNCTIONS, Function, Id, Name, Node};
use crate::words::Words;
use crate::world::X;
use alloc::vec;
use alloc::vec::Vec;

impl Parser<'_, '_> {
    /// An operand with what stands behind it.
    pub(super) fn powered(&mut self) -> Parsed<Id> {
        let from = self.place();
        let mut value = self.operand()?;
        loop {
            let token = self.token();
            if self.within == ' ' && token.blank {
                return Ok(value);
            }
            let function = match token.kind {
                Kind::Sign('t') => Function::Transpose,
                Kind::Sign('i') => Function::Inverse,
                Kind::Sign('2') => Function::Power(2),
                Kind::Sign('3') => Function::Power(3),
                Kind::Sign('^') => {
                    self.at += 1;
                    self.power()?
                }
                Kind::Sign('[') if !token.blank => {
                    self.at += 1;
                    value = self.part(value, ']', from)?;
                    continue;
                }
                Kind::Method(name) => {
                    value = self.method(name, value, from)?;
                    continue;
                }
                _ => return Ok(value),
            };
            self.at += 1;
            value = self.call(function, &[value], from)?;
        }
    }

    /// Behind ^: a whole number, or T for the transpose; its last token is left.
    fn power(&mut self) -> Parsed<Function> {
        self.at -= 1;
        let caret = self.place();
        self.at += 1;
        let bracket = self.take('(');
        let sign = if self.take('-') { -1.0 } else { 1.0 };
        let function = match self.kind() {
            Kind::Name(name) if (self.is(name, "T") || self.is(name, "t")) && sign > 0.0 => Function::Transpose,
            Kind::Number(power) if libm::trunc(power) == power && (1.0..=16.0).contains(&power) => {
                Function::Power((sign * power) as i8)
            }
            Kind::Number(_) | Kind::Name(_) => {
                return self.fail(self.place(), "A power is a whole number of at most 16; a root is sqrt or chol.");
            }
            _ => {
                return self
                    .fail(caret, "Here ^ has no power. Name a prediction xm or Pm, and an estimate x, without a hat.");
            }
        };
        self.at += usize::from(bracket);
        if bracket && self.kind() != Kind::Sign(')') { self.missing("a )") } else { Ok(function) }
    }

    fn method(&mut self, name: Name, value: Id, from: Span) -> Parsed<Id> {
        let place = self.place();
        self.at += 1;
        let function = match self.names[name].as_str() {
            "T" => return self.call(Function::Transpose, &[value], from),
            "L" => return Ok(value),
            "transpose" => Function::Transpose,
            "inverse" => Function::Inverse,
            "dot" => Function::Times,
            "copy" => Function::Array,
            _ => return self.fail(place, "Behind a point stands T, transpose(), inverse() or dot()."),
        };
        if !self.take('(') {
            return self.missing("a (");
        }
        let mut arguments = vec![value];
        self.arguments(&mut arguments)?;
        if arguments.len() != 1 + usize::from(function == Function::Times) {
            return self.fail(place, "This has another count of arguments than it takes.");
        }
        self.call(function, &arguments, from)
    }

    fn operand(&mut self) -> Parsed<Id> {
        let from = self.place();
        match self.kind() {
            Kind::Number(number) => {
                self.at += 1;
                self.node(Node::Number(number), from)
            }
            Kind::Name(name) => {
                self.timely(name)?;
                self.at += 1;
                self.name(name, from)
            }
            Kind::Sign('(') => {
                self.at += 1;
                let within = core::mem::replace(&mut self.within, '(');
                self.skip_lines();
                let value = self.formula()?;
                self.close(')', from)?;
                self.within = within;
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
    pub(super) fn close(&mut self, sign: char, opened: Span) -> Parsed<()> {
        self.skip_lines();
        if self.take(sign) {
            return Ok(());
        }
        if matches!(self.kind(), Kind::Line | Kind::End) {
            return self.fail(opened, "This bracket is never closed.");
        }
        self.missing(if sign == ')' { "a )" } else { "a ]" })
    }

    fn name(&mut self, name: Name, from: Span) -> Parsed<Id> {
        let open = self.kind() == Kind::Sign('(');
        if open && self.made(name).is_none() {
            for &(text, function, least, most) in &FUNCTIONS {
                let known = self.robot || !matches!(function, Function::Motion | Function::Sensor);
                if known && self.is(name, text) {
                    self.at += 1;
                    return self.function(function, [least, most], text, from);
                }
            }
        }
        let close_by = open && !self.token().blank;
        let value = self.node(Node::Name(name), from)?;
        // MATLAB takes parts with round brackets; a formula in them is a factor.
        if close_by && self.is_part() {
            self.at += 1;
            return self.part(value, ')', from);
        }
        Ok(value)
    }

    /// The last line that has made a name, with its time.
    fn made(&self, name: Name) -> Option<(Name, Time, Span)> {
        self.assigned.iter().rev().find(|made| made.0 == name).copied()
    }

    /// Whether a name is read with the time with which the last line made it, or what to do is told: of two times a
    /// program would keep one, and the other would be wrong in silence.
    fn timely(&mut self, name: Name) -> Parsed<()> {
        let Token { time, place, .. } = self.token();
        let Some((.., made)) = self.made(name).filter(|made| made.1 != time) else { return Ok(()) };
        let text = |place: Span| self.faults.text.get(place.from..place.to).unwrap_or_default();
        let mut words = Words::new(text(place));
        words.text(" is read here, and line ").whole(i64::from(line_of(self.faults.text, made.from)));
        words.text(" makes ").text(text(made)).text(": they are one name, which keeps one value. ");
        words.text("Give the old value a name of its own before, as x0 = x.");
        self.told(place, words)
    }

    fn function(&mut self, function: Function, [least, most]: [u8; 2], text: &str, from: Span) -> Parsed<Id> {
        if function == Function::Jacobian {
            return self.jacobian(from);
        }
        let mut arguments = Vec::new();
        // numpy puts sizes into brackets of their own.
        let pair = function == Function::Zeros && self.take('(');
        self.arguments(&mut arguments)?;
        if pair {
            self.close(')', from)?;
        }
        let count = arguments.len();
        if count < usize::from(least) || count > usize::from(most) {
            let mut words = Words::new(text);
            words.text(" takes ").whole(i64::from(most)).text(if most == 1 { " argument" } else { " arguments" });
            words.text("; here it has ").whole(count as i64).text(".");
            return self.told(from, words);
        }
        self.call(function, &arguments, from)
    }

    /// Arguments up to the closing bracket.
    fn arguments(&mut self, arguments: &mut Vec<Id>) -> Parsed<()> {
        let opened = self.before();
        let within = core::mem::replace(&mut self.within, '(');
        self.skip_lines();
        while self.kind() != Kind::Sign(')') {
            self.skip_lines();
            arguments.push(self.formula()?);
            if !self.take(',') {
                break;
            }
        }
        self.close(')', opened)?;
        self.within = within;
        Ok(())
    }

    /// `jac(formula, name)`; of `jac(f, name)` and `jac(h, name)` the other argument is the world's own.
    fn jacobian(&mut self, from: Span) -> Parsed<Id> {
        let (opened, place) = (self.before(), self.place());
        let within = core::mem::replace(&mut self.within, '(');
        let mut bare = None;
        if let (Kind::Name(name), Kind::Sign(',')) = (self.kind(), self.ahead(1))
            && self.robot
            && self.made(name).is_none()
        {
            for (text, function, other) in [("f", Function::Motion, "u"), ("h", Function::Sensor, "l")] {
                if self.is(name, text) {
                    bare = Some((function, named(self.names, other)));
                }
            }
        }
        self.at += usize::from(bare.is_some());
        let formula = if bare.is_some() { None } else { Some(self.formula()?) };
        if !self.take(',') {
            return self.missing("a comma, and the name by which is differentiated,");
        }
        self.skip_lines();
        let Kind::Name(by) = self.kind() else {
            let words = "jac takes a formula and the name by which is differentiated: jac(f(x, u), x).";
            return self.fail(self.place(), words);
        };
        self.at += 1;
        self.close(')', opened)?;
        let formula = match (formula, bare) {
            (Some(formula), _) => formula,
            (None, Some((function, other))) => {
                let state = self.node(Node::Name(if by == other { X } else { by }), place)?;
                let other = self.node(Node::Name(other), place)?;
                self.call(function, &[state, other], place)?
            }
            (None, None) => return Err(Told),
        };
        self.within = within;
        self.node(Node::Jacobian(formula, by), from)
    }
}
