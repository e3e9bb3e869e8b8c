//! A lab's parameters: how far each goes, and what is refused.

use crate::shape::{Plain, Shape};
use crate::text::Text;
use estimate::{Code, Error};
use std::slice::Iter;

/// What is known of one parameter.
#[derive(Debug)]
pub struct Parameter {
    /// Its name outside.
    pub name: &'static str,
    /// What it holds.
    pub shape: Shape,
    /// The least value of each number in it.
    pub least: f64,
    /// The greatest.
    pub greatest: f64,
    /// The step in which a reader changes it.
    pub step: f64,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// The limits in words; empty where every number is accepted.
    pub bounds: &'static str,
}

impl Parameter {
    /// A parameter within the limits of its type.
    pub const fn of<T: Knob>(name: &'static str) -> Self {
        let [least, greatest, step] = T::LIMITS;
        Self { name, shape: T::SHAPE, least, greatest, step, unit: "", bounds: "" }
    }

    /// The same within limits of its own: least, greatest, step.
    pub const fn within(self, [least, greatest, step]: [f64; 3], unit: &'static str, bounds: &'static str) -> Self {
        Self { least, greatest, step, unit, bounds, ..self }
    }

    /// The first number out of bounds: its place in the parameter, and what is wrong with it.
    fn fault(&self, shape: &Shape, from: &mut Iter<'_, f64>) -> Option<(String, Code)> {
        match shape {
            Shape::Exactly(n, entry) => {
                (0..*n).find_map(|i| self.fault(entry, from).map(|(place, code)| (format!("[{i}]{place}"), code)))
            }
            Shape::Each(names, value) => {
                let one = value.is_repeated(names.len(), from.as_slice());
                let place = |name: &str| if one { String::new() } else { format!(".{name}") };
                names
                    .iter()
                    .find_map(|name| self.fault(value, from).map(|(inner, code)| ([place(name), inner].concat(), code)))
            }
            Shape::Between(_, most, entry) => {
                let length = from.next().map_or(0, |length| *length as usize).min(*most);
                (0..length).find_map(|i| self.fault(entry, from).map(|(place, code)| (format!("[{i}]{place}"), code)))
            }
            Shape::Maybe(value) => match from.next() {
                Some(&1.0) => self.fault(value, from),
                _ => None,
            },
            Shape::Number | Shape::Whole => {
                let number = from.next().copied().unwrap_or(f64::NAN);
                let code = if !number.is_finite() {
                    Code::NotFinite
                } else if number < self.least || number > self.greatest {
                    Code::Limit
                } else {
                    return None;
                };
                Some((String::new(), code))
            }
            Shape::Flag | Shape::Word(_) => from.next().and(None),
            Shape::Text => {
                let length = from.next().map_or(0, |length| *length as usize);
                from.take(length).last().and(None)
            }
            Shape::List(_) | Shape::Record(..) | Shape::Sparse(..) => None,
        }
    }
}

/// "from 0 to 6 m".
pub const fn bounds([least, greatest]: [f64; 2], unit: &str) -> Text<64> {
    let mut text = Text::new();
    text.put("from ");
    text.put_number(least);
    text.put(" to ");
    text.put_number(greatest);
    if !unit.is_empty() {
        text.put(" ");
        text.put(unit);
    }
    text
}

/// A type that a parameter can have.
pub trait Knob: Plain {
    /// The least and greatest value of the type, and the step in which a reader changes it.
    const LIMITS: [f64; 3];

    /// Reads the value from its numbers, in the order in which [`Plain::write`] wrote them.
    fn read(from: &mut Iter<'_, f64>) -> Self;
}

impl Knob for f64 {
    const LIMITS: [f64; 3] = [f64::MIN, f64::MAX, 0.01];

    fn read(from: &mut Iter<'_, f64>) -> Self {
        from.next().copied().unwrap_or(f64::NAN)
    }
}

impl Knob for u32 {
    const LIMITS: [f64; 3] = [0.0, u32::MAX as f64, 1.0];

    fn read(from: &mut Iter<'_, f64>) -> Self {
        from.next().map_or(0, |number| *number as u32)
    }
}

impl Knob for bool {
    const LIMITS: [f64; 3] = [0.0, 1.0, 1.0];

    fn read(from: &mut Iter<'_, f64>) -> Self {
        from.next() == Some(&1.0)
    }
}

impl<T: Knob> Knob for Option<T> {
    const LIMITS: [f64; 3] = T::LIMITS;

    fn read(from: &mut Iter<'_, f64>) -> Self {
        bool::read(from).then(|| T::read(from))
    }
}

impl<T: Knob, const N: usize> Knob for [T; N] {
    const LIMITS: [f64; 3] = T::LIMITS;

    fn read(from: &mut Iter<'_, f64>) -> Self {
        std::array::from_fn(|_| T::read(from))
    }
}

/// A lab's parameters, declared by `params!`.
pub trait Params: Plain + Clone + Default {
    /// Each parameter, in the order of its numbers.
    const PARAMETERS: &'static [Parameter];

    /// Reads the parameters from their numbers, in the order in which [`Plain::write`] wrote them.
    fn read(from: &mut Iter<'_, f64>) -> Self;

    /// The parameters' numbers.
    fn numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.write(&mut numbers);
        numbers
    }

    /// Refuses parameters beyond their limits.
    ///
    /// # Errors
    /// [`Code::NotFinite`] or [`Code::Limit`], naming the parameter and the place in it.
    fn check(&self) -> Result<(), Error> {
        check(Self::PARAMETERS, &self.numbers())
    }
}

fn check(parameters: &[Parameter], numbers: &[f64]) -> Result<(), Error> {
    let mut from = numbers.iter();
    for parameter in parameters {
        let Some((place, code)) = parameter.fault(&parameter.shape, &mut from) else { continue };
        let message = match code {
            Code::NotFinite => "is not finite; it must be a number".into(),
            _ => ["is out of bounds; it must be ", parameter.bounds].concat(),
        };
        return Err(Error::new(code, [parameter.name, &place].concat(), message));
    }
    Ok(())
}
