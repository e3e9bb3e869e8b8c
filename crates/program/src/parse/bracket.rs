//! Square brackets, and round ones where MATLAB has them: matrices by their parts, and parts of matrices.

use super::{Parsed, Parser};
use crate::fault::Span;
use crate::token::Kind;
use crate::tree::{Function, Id, Node};
use alloc::vec;
use alloc::vec::Vec;

impl Parser<'_, '_> {
    /// Whether round brackets hold numbers of rows and columns: a whole number alone, a colon, or a comma.
    pub(super) fn is_part(&self) -> bool {
        matches!((self.ahead(1), self.ahead(2)), (Kind::Number(_), Kind::Sign(')'))) || self.holds(1, &[':', ','])
    }

    /// Whether one of the signs stands between these brackets, and not only between others within.
    fn holds(&self, from: usize, signs: &[char]) -> bool {
        let mut depth = 0;
        for by in from.. {
            match self.ahead(by) {
                Kind::Sign('(' | '[') => depth += 1,
                Kind::Sign(')' | ']') if depth == 0 => break,
                Kind::Sign(')' | ']') => depth -= 1,
                Kind::Sign(sign) if depth == 0 && signs.contains(&sign) => return true,
                Kind::Line if self.ahead(by + 2) == Kind::Sign('=') => {
                    break;
                }
                Kind::End => break,
                _ => {}
            }
        }
        false
    }

    /// Whether blanks separate the parts of a matrix: there is no comma, and a number or a sign stands behind a blank
    /// where a product would have a name, as in `[1 0; 0 1]` and `[c -s; s c]`. In `[u[1] c; u[2]]` a blank is a
    /// product.
    fn separates(&self) -> bool {
        let mut depth = 0;
        let mut behind = false;
        for at in self.at..self.tokens.len() {
            let token = self.tokens[at];
            match token.kind {
                Kind::Sign('(' | '[') => depth += 1,
                Kind::Sign(')' | ']') if depth == 0 => break,
                Kind::Sign(')' | ']') => depth -= 1,
                Kind::Sign('-') if depth == 0 && behind && token.blank && !token.blank_behind => {
                    return !self.holds(0, &[',']);
                }
                Kind::Number(_) if depth == 0 && behind && token.blank => return !self.holds(0, &[',']),
                Kind::End => break,
                _ => {}
            }
            behind = !matches!(
                token.kind,
                Kind::Line | Kind::Sign('+' | '-' | '*' | '/' | '\\' | '^' | '(' | '[' | ',' | ';')
            );
        }
        false
    }

    /// The numbers of rows and columns of a part, up to the closing bracket.
    pub(super) fn part(&mut self, whole: Id, closing: char, from: Span) -> Parsed<Id> {
        let opened = self.before();
        let within = core::mem::replace(&mut self.within, '(');
        let mut arguments = vec![whole];
        loop {
            let first = self.bound()?;
            arguments.push(first);
            let second = if self.take(':') { self.bound()? } else { first };
            arguments.push(second);
            if arguments.len() > 4 || !self.take(',') {
                break;
            }
        }
        self.close(closing, opened)?;
        self.within = within;
        self.call(Function::Part, &arguments, from)
    }

    /// One number of a row or column; left out, or as `end`, it is the last, and before a colon the first.
    fn bound(&mut self) -> Parsed<Id> {
        let place = self.place();
        match self.kind() {
            Kind::Sign(':') => self.node(Node::Number(1.0), place),
            Kind::Sign(']' | ')' | ',') => self.call(Function::End, &[], place),
            Kind::Name(name) if self.is(name, "end") => {
                self.at += 1;
                self.call(Function::End, &[], place)
            }
            _ => self.formula(),
        }
    }

    /// Rows of parts up to the closing bracket. Without a comma, blanks separate the parts of a row, as in MATLAB.
    pub(super) fn block(&mut self, opened: Span) -> Parsed<Id> {
        let separator = if self.separates() { ' ' } else { ',' };
        let within = core::mem::replace(&mut self.within, separator);
        let (mut rows, mut row) = (Vec::new(), Vec::new());
        loop {
            let line = self.kind() == Kind::Line;
            self.skip_lines();
            let closed = self.kind() == Kind::Sign(']');
            if (closed || line || self.take(';')) && !row.is_empty() {
                let parts = core::mem::take(&mut row);
                // numpy writes a matrix as a list of its rows.
                let lists = parts.iter().all(|id| self.tree.calls(*id, Function::Row));
                rows.push(self.call(if lists { Function::Stack } else { Function::Row }, &parts, opened)?);
            }
            match self.kind() {
                Kind::Sign(']') => break,
                Kind::Sign(';') => self.at += 1,
                Kind::Line | Kind::End => return self.fail(opened, "This bracket is never closed."),
                _ => {
                    row.push(self.formula()?);
                    if self.take(',') {
                        self.skip_lines();
                    }
                }
            }
        }
        self.at += 1;
        self.within = within;
        match rows.len() {
            0 => self.fail(opened, "Between these brackets a matrix is missing."),
            1 => Ok(rows[0]),
            _ => self.call(Function::Stack, &rows, opened),
        }
    }
}
