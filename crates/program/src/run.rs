//! A step: each line in its turn, on numbers.

use crate::matrix::Matrix;
use crate::tree::{Function, Id, Name, Node, Sign, Span, Tree};
use crate::value::Value;
use crate::world::{World, robot};
use alloc::borrow::Cow;
use alloc::vec::Vec;

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

/// What names are at one line, and the one by which is differentiated.
struct Names<'a> {
    values: &'a [Value],
    varied: Option<(Name, &'a Value)>,
}

/// A value, or why there is none, and where: the number of a node.
type Valued<'a> = Result<Cow<'a, Value>, (Trouble, Id)>;

/// Runs all lines over the given values, and answers what each line has made: its name's whole value. In trouble, the
/// number of the line, and the node.
pub(crate) fn run(
    tree: &Tree,
    values: &mut Vec<Value>,
    names: usize,
) -> Result<Vec<Value>, (Trouble, usize, Option<Id>)> {
    values.resize(names, Value::number(0.0));
    let mut made = Vec::with_capacity(tree.lines.len());
    for (i, line) in tree.lines.iter().enumerate() {
        let Some(id) = line.value else { continue };
        let value = tree.value(id, &Names { values, varied: None });
        let value = value.map_err(|(trouble, id)| (trouble, i, Some(id)))?.into_owned();
        let value = match line.part {
            None => value,
            Some((rows, columns)) => {
                let whole = &values[line.name].m;
                filled(whole, ends(whole, rows, columns, values), &value.m)
            }
        };
        if !numerics::all_finite(&value.m.entries) {
            return Err((Trouble::NotFinite, i, None));
        }
        made.push(value.clone());
        values[line.name] = value;
    }
    Ok(made)
}

/// First and one past the last row, then column, from 0.
fn ends(whole: &Matrix, rows: Span, columns: Option<Span>, values: &[Value]) -> [usize; 4] {
    let (rows, columns) = match columns {
        Some(columns) => (rows, columns),
        None if whole.columns == 1 => (rows, (crate::size::Size::ONE, None)),
        None => ((crate::size::Size::ONE, None), rows),
    };
    // n, p and m are among the given names, before π and its other spelling.
    let letters = values.iter().position(|value| value.identity).map_or(0, |at| at + 1);
    let side = |size: crate::size::Size| {
        let of = |i: usize| size.letters[i] * values.get(letters + i).map_or(0.0, |value| value.m.at(0, 0)) as i32;
        (size.number + (0..3).map(of).sum::<i32>()).max(0) as usize
    };
    let [mut all, sides] = [[0; 4], [whole.rows, whole.columns, 0, 0]];
    for (i, (first, last)) in [rows, columns].into_iter().enumerate() {
        all[2 * i] = side(first).saturating_sub(1);
        all[2 * i + 1] = last.map_or(sides[i], side).min(sides[i]);
    }
    all
}

fn part(whole: &Matrix, [top, bottom, left, right]: [usize; 4]) -> Matrix {
    Matrix::made(bottom.saturating_sub(top), right.saturating_sub(left), &|i, j| whole.at(top + i, left + j))
}

fn filled(whole: &Matrix, [top, bottom, left, right]: [usize; 4], by: &Matrix) -> Value {
    let entry = |i: usize, j: usize| {
        let within = (top..bottom).contains(&i) && (left..right).contains(&j);
        if within { by.at(i - top, j - left) } else { whole.at(i, j) }
    };
    Matrix::made(whole.rows, whole.columns, &entry).into()
}

impl Tree {
    fn value<'a>(&self, id: Id, names: &Names<'a>) -> Valued<'a> {
        let of = |id: Id| self.value(id, names);
        let singular = (Trouble::Singular, id);
        Ok(Cow::Owned(match &self.nodes[id].0 {
            Node::Number(x) => Value::number(*x),
            Node::Name(name) => {
                return Ok(Cow::Borrowed(match names.varied {
                    Some((varied, value)) if varied == *name => value,
                    _ => &names.values[*name],
                }));
            }
            Node::Negative(a) => of(*a)?.linear(&|m| m.scaled(-1.0)),
            Node::Transpose(a) => of(*a)?.transposed(),
            Node::Power(a, power) => {
                let base = of(*a)?;
                let base = if *power < 0 { Cow::Owned(base.inverse().ok_or(singular)?) } else { base };
                let one = Value { identity: !base.m.is_number() || base.identity, ..Value::number(1.0) };
                let first = if *power == 0 {
                    one.times(&base.times(&Value::number(0.0))).plus(1.0, &one)
                } else {
                    base.clone().into_owned()
                };
                (1..power.unsigned_abs()).fold(first, |all, _| all.times(&base))
            }
            Node::Binary(sign, a, b) => {
                let (a, b) = (of(*a)?, of(*b)?);
                match sign {
                    Sign::Plus => a.plus(1.0, &b),
                    Sign::Minus => a.plus(-1.0, &b),
                    Sign::Times => a.times(&b),
                    Sign::Over if b.m.is_number() => a.times(&b.inverse().ok_or(singular)?),
                    Sign::Over => b.transposed().solved(&a.transposed()).ok_or(singular)?.transposed(),
                    Sign::Under => a.solved(&b).ok_or(singular)?,
                }
            }
            Node::Call(function, arguments) => self.call(*function, arguments, id, names)?,
            Node::Part(a, rows, columns) => {
                let whole = of(*a)?;
                let ends = ends(&whole.m, *rows, *columns, names.values);
                whole.linear(&|m| part(m, ends))
            }
            Node::Block(rows) => {
                let mut parts = Vec::with_capacity(rows.len());
                for row in rows {
                    parts.push(row.iter().map(|id| of(*id)).collect::<Result<Vec<_>, _>>()?);
                }
                block(&parts)
            }
            Node::Jacobian(a, name) => {
                let at = &names.values[*name];
                let mut columns = Vec::with_capacity(at.m.rows);
                for i in 0..at.m.rows {
                    let mut along = Matrix::zeros(at.m.rows, 1);
                    along.entries[i] = 1.0;
                    let varied = Value { d: Some(along), ..at.clone() };
                    let of = self.value(*a, &Names { values: names.values, varied: Some((*name, &varied)) });
                    columns.push(of.map_err(|trouble| trouble)?.slope());
                }
                let rows = columns.first().map_or(0, |column| column.rows);
                Matrix::made(rows, columns.len(), &|i, j| columns[j].at(i, 0)).into()
            }
        }))
    }

    fn call(&self, function: Function, arguments: &[Id], id: Id, names: &Names<'_>) -> Result<Value, (Trouble, Id)> {
        use Function as F;
        let first = self.value(arguments[0], names)?;
        let second = match arguments.get(1) {
            Some(id) => Some(self.value(*id, names)?),
            None => None,
        };
        let other = second.as_deref().unwrap_or(&first);
        let (singular, side) = ((Trouble::Singular, id), |of: &Value| of.m.at(0, 0) as usize);
        Ok(match function {
            F::Inverse => first.inverse().ok_or(singular)?,
            F::Eye => Matrix::made(side(&first), side(other), &|i, j| if i == j { 1.0 } else { 0.0 }).into(),
            F::Zeros => Matrix::zeros(side(&first), side(other)).into(),
            F::Diagonal if first.m.columns == 1 => {
                first.linear(&|m| Matrix::made(m.rows, m.rows, &|i, j| if i == j { m.at(i, 0) } else { 0.0 }))
            }
            F::Diagonal => first.linear(&|m| Matrix::made(m.rows, 1, &|i, _| m.at(i, i))),
            F::Square => first.mapped(numerics::sqrt, |x| 0.5 / numerics::sqrt(x)),
            F::Sine => first.mapped(libm::sin, libm::cos),
            F::Cosine => first.mapped(libm::cos, |x| -libm::sin(x)),
            F::Tangent => first.mapped(libm::tan, |x| 1.0 + libm::tan(x) * libm::tan(x)),
            F::Angle => first.angle(other),
            F::Exponential => first.mapped(libm::exp, libm::exp),
            F::Logarithm => first.mapped(libm::log, |x| 1.0 / x),
            F::Wrap => first.mapped(geom::wrap, |_| 1.0),
            F::Absolute => first.mapped(libm::fabs, |x| libm::copysign(1.0, x)),
            F::Determinant => first.determinant().ok_or(singular)?,
            F::Trace => first.trace(),
            F::Norm if second.is_some() => {
                block(&[alloc::vec![first.clone()], alloc::vec![Cow::Borrowed(other)]]).norm()
            }
            F::Norm => first.norm(),
            F::Root => first.root().ok_or((Trouble::NotPositiveDefinite, id))?,
            F::Symmetric if first.identity => first.into_owned(),
            F::Symmetric => first.linear(&|m| m.scaled(0.5).plus(0.5, &m.transposed())),
            F::Transpose => first.transposed(),
            F::Solve => first.solved(other).ok_or(singular)?,
            F::Product => first.times(other),
            F::Length if side(other) == 2 && second.is_some() => Value::number(first.m.columns as f64),
            F::Length => Value::number(first.m.rows as f64),
            F::Array | F::Jacobian => first.into_owned(),
            F::Motion => robot::motion(&first, other),
            F::Sensor => robot::sensor(&first, other),
        })
    }
}

fn block(rows: &[Vec<Cow<'_, Value>>]) -> Value {
    let high: usize = rows.iter().map(|row| row[0].m.rows).sum();
    let wide: usize = rows[0].iter().map(|part| part.m.columns).sum();
    let put = |pick: &dyn Fn(&Value) -> Cow<'_, Matrix>| {
        let (mut all, mut top) = (Matrix::zeros(high, wide), 0);
        for row in rows {
            let mut left = 0;
            for value in row {
                let m = pick(value);
                for i in 0..m.rows {
                    for j in 0..m.columns {
                        all.entries[(top + i) * wide + left + j] = m.at(i, j);
                    }
                }
                left += m.columns;
            }
            top += row[0].m.rows;
        }
        all
    };
    let varies = rows.iter().flatten().any(|value| value.d.is_some());
    Value {
        m: put(&|value| Cow::Borrowed(&value.m)),
        d: varies.then(|| put(&|value| Cow::Owned(value.slope()))),
        identity: false,
    }
}

/// What is given, in the order of the world's names, with its constants.
pub(crate) fn given(given: &[Matrix], sizes: [usize; 3]) -> Vec<Value> {
    given.iter().cloned().map(Value::from).chain(World::constants(sizes)).collect()
}
