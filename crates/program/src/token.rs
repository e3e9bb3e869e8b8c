//! A text as tokens.

use crate::fault::{Faults, Span};
use crate::sign::{begins_name, is_blank, is_mark, raised_mark};
use crate::time::{Time, time};
use crate::tree::{FUNCTIONS, Name};
use alloc::string::String;
use alloc::vec::Vec;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Number(f64),
    /// The number of a name.
    Name(Name),
    /// `.T` and its like.
    Method(Name),
    /// One sign: an operator or a bracket; `i` for ⁻¹, `t` for a transpose, `2` to `9` for a raised digit.
    Sign(char),
    Line,
    End,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Token {
    pub kind: Kind,
    /// What stands behind a name, as in x(k+1|k).
    pub time: Time,
    pub place: Span,
    /// Whether a blank stands before it, and whether one stands behind.
    pub blank: bool,
    pub blank_behind: bool,
}

/// Packages whose functions are called by their own name.
const PACKAGES: [&str; 9] = ["np", "numpy", "linalg", "la", "scipy", "math", "jnp", "LA", "LinearAlgebra"];

const NO_SIGN: &str = "This sign belongs to no formula.";

/// What is said of a time that is none.
pub(crate) const TIMES: &str = "A time stands right behind its name, as in x(k+1|k) or x_k, or is left out.";

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    tokens: Vec<Token>,
    names: &'a mut Vec<String>,
    /// Whether what was read last is a blank.
    blank: bool,
    /// The time of the name that was read last.
    time: Time,
}

/// The tokens of a text, the last of which is its end. What belongs to no formula is a fault, and is left out.
pub(crate) fn tokens(text: &str, names: &mut Vec<String>, faults: &mut Faults<'_>) -> Vec<Token> {
    let mut lexer = Lexer { text, at: 0, tokens: Vec::new(), names, blank: false, time: Time::default() };
    loop {
        let from = lexer.at;
        let Some(c) = lexer.next() else { break };
        lexer.token(c, from, faults);
    }
    lexer.push(Kind::Line, text.len());
    lexer.push(Kind::End, text.len());
    lexer.tokens
}

impl Lexer<'_> {
    fn peek(&self) -> Option<char> {
        self.text.get(self.at..)?.chars().next()
    }

    fn next(&mut self) -> Option<char> {
        let c = self.peek()?;
        self.at += c.len_utf8();
        Some(c)
    }

    #[inline(never)]
    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    fn push(&mut self, kind: Kind, from: usize) {
        let blank = core::mem::take(&mut self.blank);
        let blank_behind = self.peek().is_some_and(|c| is_blank(c) || c == '\n');
        let time = core::mem::take(&mut self.time);
        self.tokens.push(Token { kind, time, place: Span { from, to: self.at }, blank, blank_behind });
    }

    fn token(&mut self, c: char, from: usize, faults: &mut Faults<'_>) {
        let sign = match c {
            '\n' => return self.push(Kind::Line, from),
            c if is_blank(c) => return self.blank = true,
            '#' | '%' => return self.comment(),
            '/' if self.take('/') => return self.comment(),
            '0'..='9' => return self.number(from, faults),
            '.' => match self.peek() {
                Some('0'..='9') => return self.number(from, faults),
                // MATLAB's sign for a formula that goes on in the next line.
                Some('.') => {
                    self.comment();
                    self.take('\n');
                    return;
                }
                Some(c) if begins_name(c) => {
                    self.next();
                    let name = self.name(c);
                    let name = named(self.names, &name);
                    return self.push(Kind::Method(name), from);
                }
                Some('\'') => {
                    self.next();
                    't'
                }
                _ => {
                    self.next();
                    let words = "Products of single entries are not part of the language: * is the matrices' product.";
                    return faults.say(Span { from, to: self.at }, words);
                }
            },
            '−' | '–' => '-',
            '×' | '·' | '⋅' | '@' => '*',
            '*' if self.take('*') => '^',
            'ᵀ' | '⊤' | '′' | '’' | '\'' => 't',
            '⁻' if self.take('¹') => 'i',
            '²' => '2',
            '³' => '3',
            ':' if self.take('=') => '=',
            '←' => '=',
            '{' => '(',
            '}' => ')',
            '+' | '-' | '*' | '/' | '\\' | '^' | '(' | ')' | '[' | ']' | ',' | ';' | ':' | '=' => c,
            c if begins_name(c) => {
                let name = self.name(c);
                // A hat by itself.
                if name.is_empty() {
                    return faults.say(Span { from, to: self.at }, NO_SIGN);
                }
                if PACKAGES.contains(&name.as_str()) && self.take('.') {
                    return;
                }
                let name = named(self.names, &name);
                return self.push(Kind::Name(name), from);
            }
            '|' | '∣' => return faults.say(Span { from, to: self.at }, TIMES),
            '—' | '―' | '‒' | '‑' | '‐' => {
                let words = "This is a dash of texts, not a sign of an operation. A minus is typed -.";
                faults.say(Span { from, to: self.at }, words);
                '-'
            }
            _ => return faults.say(Span { from, to: self.at }, NO_SIGN),
        };
        self.push(Kind::Sign(sign), from);
    }

    fn comment(&mut self) {
        while self.peek().is_some_and(|c| c != '\n') {
            self.next();
        }
    }

    /// A name in one spelling: Greek letters written out, hats taken off, and a minus behind a prediction. An estimate
    /// behind its reading is the one that is taken.
    fn name(&mut self, first: char) -> String {
        let (mut name, mut predicted) = (String::new(), false);
        let mut next = Some(first);
        while let Some(c) = next {
            match c {
                '⁻' => predicted = true,
                '⁺' => {}
                'ν' => name.push_str("nu"),
                'μ' | 'µ' => name.push_str("mu"),
                'Σ' => name.push_str("Sigma"),
                'θ' => name.push_str("theta"),
                '\u{302}' => {}
                _ => name.push(c),
            }
            let rest = self.text.get(self.at..).unwrap_or_default();
            let minus_one = rest.starts_with("⁻¹");
            let timed = self.time != Time::default();
            let behind = |c: &char| is_mark(*c) || !timed && (begins_name(*c) || c.is_ascii_digit());
            if let Some((time, length)) = time(rest).filter(|_| !timed && self.has_times(&name, rest)) {
                predicted |= time.predicts();
                (self.time, self.at, next) = (time, self.at + length, Some('⁺'));
            } else if let Some(mark) = raised_mark(rest) {
                self.at += 1 + mark.len_utf8();
                next = Some(if mark == '+' { '⁺' } else { '⁻' });
            } else {
                next = self.peek().filter(|c| behind(c) && !minus_one);
                self.at += next.map_or(0, char::len_utf8);
            }
        }
        if let Some(end) = name.strip_suffix("_hat").map(str::len).filter(|end| *end > 0) {
            name.truncate(end);
        }
        if name == "xhat" {
            name.truncate(1);
        }
        if predicted {
            name.push('⁻');
        }
        name
    }

    /// Whether brackets behind a name may hold a time: it is no function's, and the text has no k or t of its own.
    fn has_times(&self, name: &str, rest: &str) -> bool {
        let own = |pair: &[Token]| {
            matches!(pair, [Token { kind: Kind::Name(name), .. }, Token { kind: Kind::Sign('='), .. }]
            if matches!(self.names[*name].as_str(), "k" | "t"))
        };
        !rest.starts_with(['(', '['])
            || !FUNCTIONS.iter().any(|known| known.0 == name) && !self.tokens.windows(2).any(own)
    }

    /// A number of at most fifteen digits or so, whose power of ten a number holds exactly: it is then right to the
    /// last bit with one product or quotient.
    fn number(&mut self, from: usize, faults: &mut Faults<'_>) {
        self.at = from;
        let (mut whole, mut power, mut fraction, mut exact) = (0_u64, 0_i32, false, true);
        while let Some(c) = self.peek() {
            match c {
                '0'..='9' => {
                    whole = whole.saturating_mul(10).saturating_add(u64::from(c as u32 - 48));
                    exact &= whole < 1 << 53;
                    power = power.saturating_sub(i32::from(fraction));
                }
                // A point before a sign or a name is that of an operator or a method.
                '.' if !fraction
                    && !matches!(self.text.as_bytes().get(self.at + 1), Some(b'*' | b'/' | b'^' | b'\'' | b'T')) =>
                {
                    fraction = true
                }
                _ => break,
            }
            self.at += 1;
        }
        let rest = self.text.as_bytes().get(self.at..).unwrap_or_default();
        let (sign, digits) = match rest {
            [b'e' | b'E', b'-', after @ ..] => (-1, after),
            [b'e' | b'E', b'+', after @ ..] => (1, after),
            [b'e' | b'E', after @ ..] => (1, after),
            _ => (1, &rest[..0]),
        };
        let count = digits.iter().take_while(|digit| digit.is_ascii_digit()).count();
        if count > 0 {
            let exponent = digits[..count]
                .iter()
                .fold(0_i32, |all, digit| all.saturating_mul(10).saturating_add(i32::from(digit - b'0')).min(1000));
            power = power.saturating_add(sign * exponent);
            self.at += rest.len() - digits.len() + count;
        }
        if whole == 0 && exact {
            power = 0;
        }
        if !exact || power.abs() > 22 {
            let words = "A number has at most 15 digits, and at most 22 places before or behind the point.";
            faults.say(Span { from, to: self.at }, words);
        }
        let unit = (0..power.abs().min(22)).fold(1.0, |unit, _| 10.0 * unit);
        let number = if power < 0 { whole as f64 / unit } else { whole as f64 * unit };
        self.push(Kind::Number(number), from);
    }
}

/// The number of a name, which is new if it is not among them.
pub(crate) fn named(names: &mut Vec<String>, name: &str) -> Name {
    names.iter().position(|known| known == name).unwrap_or_else(|| {
        names.push(name.into());
        names.len() - 1
    })
}
