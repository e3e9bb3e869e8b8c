//! Plain values as a row of numbers, beside a constant that says what the numbers are.
//!
//! A view wants objects, a program JSON, a hash bits: each reads the row along the [`Shape`], so that one function
//! serves all frames where a generic one would be compiled for each.

use nalgebra::DVector;
use std::collections::VecDeque;

/// What a row of numbers holds.
#[derive(Debug)]
pub enum Shape {
    /// A number, as it is.
    Number,
    /// A whole number.
    Whole,
    /// `true` (1) or `false` (0).
    Flag,
    /// One of these words: its index.
    Word(&'static [&'static str]),
    /// A text: its length, then its characters.
    Text,
    /// 0 for nothing; 1 and the value.
    Maybe(&'static Shape),
    /// A length, then the entries.
    List(&'static Shape),
    /// As many entries as stated here.
    Exactly(usize, &'static Shape),
    /// A length within these bounds, then the entries.
    Between(usize, usize, &'static Shape),
    /// Each field in turn, of a record of this name.
    Record(&'static str, &'static [Field]),
    /// The same of a record that leaves out the fields that hold nothing: each is [`Shape::Maybe`].
    Sparse(&'static str, &'static [Field]),
    /// A value for each of these names in turn; outside, where they are all the same, one value.
    Each(&'static [&'static str], &'static Shape),
}

impl Shape {
    /// How many of the numbers are those of a value of this shape.
    pub fn length(&self, numbers: &[f64]) -> usize {
        let first = numbers.first().copied().unwrap_or(0.0);
        match self {
            Self::Number | Self::Whole | Self::Flag | Self::Word(_) => 1,
            Self::Text => 1 + first as usize,
            Self::Maybe(value) if first == 1.0 => 1 + value.length(&numbers[1..]),
            Self::Maybe(_) => 1,
            Self::List(entry) | Self::Between(_, _, entry) => 1 + many(first as usize, entry, &numbers[1..]),
            Self::Exactly(n, entry) => many(*n, entry, numbers),
            Self::Each(names, value) => many(names.len(), value, numbers),
            Self::Record(_, fields) | Self::Sparse(_, fields) => {
                fields.iter().fold(0, |length, field| length + field.shape.length(&numbers[length..]))
            }
        }
    }

    /// Whether `n` values of this shape are all the same, to the bit.
    pub fn is_repeated(&self, n: usize, numbers: &[f64]) -> bool {
        let length = self.length(numbers);
        let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
        let all = numbers.get(..n * length);
        all.is_some_and(|all| length > 0 && all.chunks(length).all(|each| bits(each) == bits(&all[..length])))
    }
}

fn many(n: usize, entry: &Shape, numbers: &[f64]) -> usize {
    (0..n).fold(0, |length, _| length + entry.length(&numbers[length..]))
}

/// A field of a record.
#[derive(Debug)]
pub struct Field {
    /// Its name outside.
    pub name: &'static str,
    /// What it holds.
    pub shape: Shape,
}

/// A value that is nothing but numbers, words and lists of them.
pub trait Plain {
    /// What [`Plain::write`] writes.
    const SHAPE: Shape;

    /// Appends the value's numbers.
    fn write(&self, to: &mut Vec<f64>);
}

/// Appends a number. Not inlined: a frame has hundreds, and the code that lets a list grow would stand at each.
#[inline(never)]
pub fn put(to: &mut Vec<f64>, number: f64) {
    to.push(number);
}

/// Single numbers.
macro_rules! number {
    ($($type:ty: $shape:ident;)*) => {$(
        impl Plain for $type {
            const SHAPE: Shape = Shape::$shape;

            fn write(&self, to: &mut Vec<f64>) {
                put(to, f64::from(*self));
            }
        }
    )*};
}

number! { f64: Number; u32: Whole; bool: Flag; }

impl Plain for usize {
    const SHAPE: Shape = Shape::Whole;

    fn write(&self, to: &mut Vec<f64>) {
        put(to, *self as f64);
    }
}

impl Plain for &'static str {
    const SHAPE: Shape = Shape::Text;

    fn write(&self, to: &mut Vec<f64>) {
        str::write(self, to);
    }
}

impl<T: Plain> Plain for Option<T> {
    const SHAPE: Shape = Shape::Maybe(&T::SHAPE);

    fn write(&self, to: &mut Vec<f64>) {
        put(to, f64::from(self.is_some()));
        if let Some(value) = self {
            value.write(to);
        }
    }
}

impl<T: Plain, const N: usize> Plain for [T; N] {
    const SHAPE: Shape = Shape::Exactly(N, &T::SHAPE);

    fn write(&self, to: &mut Vec<f64>) {
        self.iter().for_each(|entry| entry.write(to));
    }
}

/// Lists whose length may change.
macro_rules! list {
    ($($type:ty),*) => {$(
        impl<T: Plain + 'static> Plain for $type {
            const SHAPE: Shape = Shape::List(&T::SHAPE);

            fn write(&self, to: &mut Vec<f64>) {
                put(to, self.len() as f64);
                self.iter().for_each(|entry| entry.write(to));
            }
        }
    )*};
}

list!(Vec<T>, VecDeque<T>, &'static [T]);

impl Plain for DVector<f64> {
    const SHAPE: Shape = <&[f64]>::SHAPE;

    fn write(&self, to: &mut Vec<f64>) {
        put(to, self.len() as f64);
        to.extend(self.iter());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use estimate::drive::{BySensor, Sensors};

    fn numbers(value: &impl Plain) -> Vec<f64> {
        let mut numbers = Vec::new();
        value.write(&mut numbers);
        numbers
    }

    #[test]
    fn a_shape_knows_how_many_numbers_it_takes_of_a_row() {
        fn assert_length<T: Plain>(value: T) {
            let mut row = numbers(&value);
            let length = row.len();
            row.extend([7.0, 8.0]);
            assert_eq!(T::SHAPE.length(&row), length, "{:?}", T::SHAPE);
        }
        assert_length(1.5);
        assert_length("ab");
        assert_length([Some(1.0), None, Some(3.0)]);
        assert_length(vec![vec![1.0, 2.0], vec![]]);
        assert_length(BySensor { fix: Some(0.9), ..BySensor::default() });
        assert_length(Sensors::default());
    }

    #[test]
    fn values_are_repeated_where_they_are_the_same_to_the_bit() {
        let repeated = |by: BySensor<Option<f64>>| <Option<f64>>::SHAPE.is_repeated(4, &numbers(&by));
        assert!(repeated(BySensor::all(None)) && repeated(BySensor::all(Some(0.5))));
        assert!(!repeated(BySensor { bearing: Some(0.5), ..BySensor::all(None) }));
        assert!(!repeated(BySensor { heading: Some(-0.0), ..BySensor::all(Some(0.0)) }));
    }
}
