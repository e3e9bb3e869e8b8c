//! A step: each line in its turn, on numbers.

use crate::matrix::Matrix;
use crate::tree::{Function, Id, Name, Node, Tree};
use crate::value::Value;
use crate::world::robot;
use alloc::borrow::Cow;
use alloc::rc::Rc;
use alloc::vec::Vec;
use core::cell::Cell;

/// Why a line has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// A matrix that is inverted, or divides, has no inverse.
    Singular,
    /// A matrix whose Cholesky factor is taken is not positive definite.
    NotPositiveDefinite,
    /// A number is not finite any more.
    NotFinite,
}

/// Sees the value of a part of a formula, by its node.
pub(crate) type Look<'a> = &'a dyn Fn(Id, &Matrix);

/// One line at work.
pub(crate) struct Run<'a> {
    pub tree: &'a Tree,
    /// What each name is.
    pub values: &'a [Rc<Value>],
    /// The one by which is differentiated.
    pub varied: Option<(Name, &'a Value)>,
    /// Why there is no value, and at which node.
    pub trouble: &'a Cell<(Trouble, Id)>,
    /// Who sees what is computed.
    pub look: Option<Look<'a>>,
}

impl<'a> Run<'a> {
    /// A name's value is lent, and what is computed is the caller's: most of a step's time went into keeping parts of
    /// formulas that one reader has.
    pub fn value(&self, id: Id) -> Option<Cow<'a, Value>> {
        let value = match self.tree.node(id) {
            Node::Number(x) => Value::number(x),
            Node::Name(name) => {
                return Some(Cow::Borrowed(match self.varied {
                    Some((varied, value)) if varied == name => value,
                    _ => &self.values[name],
                }));
            }
            Node::Jacobian(a, name) => self.jacobian(a, name)?,
            Node::Call(function, from, to) => {
                let arguments = self.tree.arguments(from, to);
                let value = match *arguments {
                    [a] => call(function, &[self.value(a)?]),
                    [a, b] => call(function, &[self.value(a)?, self.value(b)?]),
                    _ => {
                        let mut values = Vec::with_capacity(arguments.len());
                        for argument in arguments {
                            values.push(self.value(*argument)?);
                        }
                        call(function, &values)
                    }
                };
                if value.is_none() {
                    let root = function == Function::Root;
                    self.trouble.set((if root { Trouble::NotPositiveDefinite } else { Trouble::Singular }, id));
                }
                value?
            }
        };
        if let Some(look) = self.look {
            look(id, &value.m);
        }
        Some(Cow::Owned(value))
    }

    fn jacobian(&self, a: Id, name: Name) -> Option<Value> {
        let at = &self.values[name];
        let n = at.m.rows;
        let mut columns = Vec::with_capacity(n);
        for i in 0..n {
            let along = Matrix::made(n, 1, &|j, _| f64::from(u8::from(i == j)));
            let varied = Value { m: at.m.clone(), d: Some(along), identity: false };
            columns.push(Run { varied: Some((name, &varied)), ..*self }.value(a)?.slope());
        }
        let rows = columns.first()?.rows;
        Some(Matrix::made(rows, n, &|i, j| columns[j].at(i, 0)).into())
    }
}

/// First and one past the last row, then column, from 0, by the numbers behind a part's matrix. The end is 0.
fn ends(whole: &Matrix, bounds: &[Cow<'_, Value>]) -> [usize; 4] {
    let mut ends = [0, whole.rows, 0, whole.columns];
    // One pair of bounds is of the rows of a column, or of the columns of a row.
    let skipped = if bounds.len() == 2 && whole.columns != 1 { 2 } else { 0 };
    for (i, bound) in bounds.iter().enumerate() {
        let (at, number) = (i + skipped, bound.m.at(0, 0) as usize);
        if at < 4 && i % 2 == 0 {
            ends[at] = if number > 0 { number } else { ends[at + 1] }.saturating_sub(1);
        } else if at < 4 && number > 0 {
            ends[at] = number.min(ends[at]);
        }
    }
    ends
}

/// A matrix with another part.
pub(crate) fn refilled(run: &Run<'_>, whole: &Matrix, part: Id, by: &Matrix) -> Option<Matrix> {
    let Node::Call(_, from, to) = run.tree.node(part) else { return None };
    let mut bounds = Vec::new();
    for bound in run.tree.arguments(from + 1, to) {
        bounds.push(run.value(*bound)?);
    }
    Some(filled(whole, ends(whole, &bounds), by))
}

fn part(whole: &Matrix, [top, bottom, left, right]: [usize; 4]) -> Matrix {
    Matrix::made(bottom.saturating_sub(top), right.saturating_sub(left), &|i, j| whole.at(top + i, left + j))
}

fn filled(whole: &Matrix, [top, bottom, left, right]: [usize; 4], by: &Matrix) -> Matrix {
    Matrix::made(whole.rows, whole.columns, &|i, j| {
        let within = i >= top && i < bottom && j >= left && j < right;
        if within { by.at(i - top, j - left) } else { whole.at(i, j) }
    })
}

/// Sine and cosine as the models' own take them: both at once.
pub(crate) fn sin(x: f64) -> f64 {
    libm::sincos(x).0
}

pub(crate) fn cos(x: f64) -> f64 {
    libm::sincos(x).1
}

/// None where an inverse or a root is missing.
fn call(function: Function, values: &[Cow<'_, Value>]) -> Option<Value> {
    use Function as F;
    if function == F::End {
        return Some(Value::number(0.0));
    }
    let (a, b): (&Value, &Value) = (values.first()?, values.last()?);
    let side = |of: &Value| of.m.at(0, 0) as usize;
    Some(match function {
        F::Plus => a.plus(1.0, b),
        F::Minus => a.plus(-1.0, b),
        F::Times => a.times(b),
        F::Over if b.m.is_number() => a.times(&b.inverse()?),
        F::Over => b.transposed().solved(&a.transposed())?.transposed(),
        F::Under => a.solved(b)?,
        F::Negative => a.linear(&|m| m.scaled(-1.0)),
        F::Power(power) => {
            let base = if power < 0 { &a.inverse()? } else { a };
            let mut all = base.clone();
            for _ in 1..power.unsigned_abs() {
                all = all.times(base);
            }
            all
        }
        F::Part => {
            let ends = ends(&a.m, &values[1..]);
            a.linear(&|m| part(m, ends))
        }
        F::End => return None,
        F::Row => joined(values, false),
        F::Stack => joined(values, true),
        F::Inverse => a.inverse()?,
        F::Eye => Matrix::made(side(a), side(b), &|i, j| f64::from(u8::from(i == j))).into(),
        F::Zeros => Matrix::zeros(side(a), side(b)).into(),
        F::Diagonal => {
            let column = a.m.columns == 1;
            let by = |m: &Matrix, i: usize, j: usize| if i != j { 0.0 } else { m.at(i, 0) };
            a.linear(&|m| match column {
                true => Matrix::made(m.rows, m.rows, &|i, j| by(m, i, j)),
                false => Matrix::made(m.rows, 1, &|i, _| m.at(i, i)),
            })
        }
        F::Square => a.mapped(numerics::sqrt, |x| 0.5 / numerics::sqrt(x)),
        F::Sine => a.mapped(sin, cos),
        F::Cosine => a.mapped(cos, |x| -sin(x)),
        F::Angle => a.angle(b),
        F::Exponential => a.mapped(libm::exp, libm::exp),
        F::Wrap => a.mapped(geom::wrap, |_| 1.0),
        F::Absolute => a.mapped(libm::fabs, |x| libm::copysign(1.0, x)),
        F::Determinant => a.determinant()?,
        F::Trace => a.trace(),
        F::Norm => a.norm(),
        F::Root => a.root()?,
        F::Symmetric if a.identity => a.clone(),
        F::Symmetric => a.linear(&|m| m.scaled(0.5).plus(0.5, &m.transposed())),
        F::Transpose => a.transposed(),
        F::Length => Value::number(if values.len() > 1 && side(b) == 2 { a.m.columns } else { a.m.rows } as f64),
        F::Array | F::Jacobian => a.clone(),
        F::Motion => robot::motion(a, b),
        F::Sensor => robot::sensor(a, b),
    })
}

/// Parts beside or below one another.
fn joined(values: &[Cow<'_, Value>], below: bool) -> Value {
    let join = |slope: bool| {
        let (mut rows, mut columns) = (0, 0);
        for value in values {
            rows = if below { rows + value.m.rows } else { value.m.rows };
            columns = if below { value.m.columns } else { columns + value.m.columns };
        }
        let (mut all, mut at) = (Matrix::zeros(rows, columns), 0);
        for value in values {
            let ends = if below { [at, at + value.m.rows, 0, columns] } else { [0, rows, at, at + value.m.columns] };
            all = if slope { filled(&all, ends, &value.slope()) } else { filled(&all, ends, &value.m) };
            at += if below { value.m.rows } else { value.m.columns };
        }
        all
    };
    let varies = values.iter().any(|value| value.d.is_some());
    Value { m: join(false), d: varies.then(|| join(true)), identity: false }
}
