//! Plain values through serde, for programs that want JSON.

use crate::shape::{Field, Plain, Shape};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use std::cell::RefCell;
use std::slice::Iter;

/// A plain value, serialized as TypeScript knows it: names in camelCase, choices as words, an absent value as null.
#[derive(Debug)]
pub struct Shown<'a, T>(pub &'a T);

impl<T: Plain> Serialize for Shown<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut numbers = Vec::new();
        self.0.write(&mut numbers);
        Row { shape: &T::SHAPE, from: &RefCell::new(numbers.iter()) }.serialize(serializer)
    }
}

/// A shape, and the numbers that have not been read yet.
struct Row<'a> {
    shape: &'static Shape,
    from: &'a RefCell<Iter<'a, f64>>,
}

impl Row<'_> {
    fn next(&self) -> f64 {
        self.from.borrow_mut().next().copied().unwrap_or(f64::NAN)
    }

    fn of(&self, shape: &'static Shape) -> Self {
        Self { shape, from: self.from }
    }

    fn entries<S: Serializer>(&self, n: usize, entry: &'static Shape, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq((0..n).map(|_| self.of(entry)))
    }
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.shape {
            Shape::Number => serializer.serialize_f64(self.next()),
            Shape::Whole => serializer.serialize_u64(self.next() as u64),
            Shape::Flag => serializer.serialize_bool(self.next() == 1.0),
            Shape::Word(words) => serializer.serialize_str(words[self.next() as usize]),
            Shape::Text => {
                let letters = 0..self.next() as usize;
                let text: String = letters.filter_map(|_| char::from_u32(self.next() as u32)).collect();
                serializer.serialize_str(&text)
            }
            Shape::Maybe(_) if self.next() == 0.0 => serializer.serialize_none(),
            Shape::Maybe(value) => self.of(value).serialize(serializer),
            Shape::List(entry) => self.entries(self.next() as usize, entry, serializer),
            Shape::Exactly(n, entry) => self.entries(*n, entry, serializer),
            Shape::Sparse(_, fields) => {
                let there = |field: &&Field| {
                    let numbers = self.from.borrow();
                    numbers.as_slice().first() == Some(&1.0) || !matches!(field.shape, Shape::Maybe(_))
                };
                let mut map = serializer.serialize_map(None)?;
                for field in *fields {
                    if there(&field) {
                        map.serialize_entry(field.name, &self.of(&field.shape))?;
                    } else {
                        self.next();
                    }
                }
                map.end()
            }
            Shape::Each(names, value) if value.is_repeated(names.len(), self.from.borrow().as_slice()) => {
                let rest = self.from.borrow().as_slice();
                let length = value.length(rest);
                *self.from.borrow_mut() = rest[names.len() * length..].iter();
                let first = RefCell::new(rest[..length].iter());
                Row { shape: value, from: &first }.serialize(serializer)
            }
            Shape::Each(names, value) => serializer.collect_map(names.iter().map(|name| (name, self.of(value)))),
            Shape::Record(_, fields) => {
                serializer.collect_map(fields.iter().map(|field| (field.name, self.of(&field.shape))))
            }
        }
    }
}
