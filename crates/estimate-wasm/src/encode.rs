//! Plain JavaScript values from the core's answers.

use js_sys::Array;
use labs::{Field, Shape};
use std::cell::RefCell;
use std::slice::Iter;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

#[wasm_bindgen]
extern "C" {
    /// The numbers as an array: one call for all of them.
    #[wasm_bindgen(js_namespace = Array, js_name = from)]
    pub(crate) fn list(numbers: &[f64]) -> JsValue;

    // Short lists are quicker to make of their entries than of a view of the memory.
    #[wasm_bindgen(js_namespace = Array, js_name = of)]
    fn pair(first: f64, second: f64) -> JsValue;
    #[wasm_bindgen(js_namespace = Array, js_name = of)]
    fn triple(first: f64, second: f64, third: f64) -> JsValue;

    #[wasm_bindgen(js_name = Object)]
    type Fresh;
    // On a new object neither fails. A number is handed over as it is, without a place in the table of references.
    #[wasm_bindgen(method, structural, indexing_setter)]
    fn put(this: &Fresh, name: &JsValue, value: &JsValue);
    #[wasm_bindgen(method, structural, indexing_setter)]
    fn put_number(this: &Fresh, name: &JsValue, value: f64);
}

type Names = Vec<(*const Field, &'static [JsValue])>;

thread_local! {
    /// The names of each record's fields as JavaScript has them: making a string takes longer than writing a field.
    static NAMES: RefCell<Names> = const { RefCell::new(Vec::new()) };
}

/// The names of a record's fields, made once.
fn names(fields: &'static [Field]) -> &'static [JsValue] {
    let key = fields.as_ptr();
    let known = NAMES.with_borrow(|all| all.iter().find(|(known, _)| *known == key).map(|(_, names)| *names));
    known.unwrap_or_else(|| {
        // Not while the list is borrowed: a call that ends in the engine, out of stack, would never give it back.
        let made: Vec<JsValue> = fields.iter().map(|field| field.name.into()).collect();
        let made: &'static [JsValue] = Vec::leak(made);
        NAMES.with_borrow_mut(|all| all.push((key, made)));
        made
    })
}

/// A row of numbers that is read along a shape.
pub(crate) struct Row<'a>(Iter<'a, f64>);

impl<'a> Row<'a> {
    pub fn new(numbers: &'a [f64]) -> Self {
        Self(numbers.iter())
    }

    fn number(&mut self) -> f64 {
        self.0.next().copied().unwrap_or(f64::NAN)
    }

    /// The next value, of this shape.
    pub fn value(&mut self, shape: &'static Shape) -> JsValue {
        match shape {
            Shape::Number | Shape::Whole => self.number().into(),
            Shape::Flag => (self.number() == 1.0).into(),
            Shape::Word(words) => words[self.number() as usize].into(),
            Shape::Text => {
                let length = self.number() as usize;
                self.numbers(length)
                    .iter()
                    .filter_map(|letter| char::from_u32(*letter as u32))
                    .collect::<String>()
                    .into()
            }
            Shape::Maybe(value) => {
                if self.number() == 1.0 {
                    self.value(value)
                } else {
                    JsValue::NULL
                }
            }
            Shape::Exactly(n, entry) => self.entries(*n, entry),
            Shape::List(entry) => {
                let length = self.number() as usize;
                self.entries(length, entry)
            }
            Shape::Record(_, fields) => self.fields(fields),
        }
    }

    /// The next `n` numbers.
    fn numbers(&mut self, n: usize) -> &'a [f64] {
        let (numbers, rest) = self.0.as_slice().split_at(n);
        self.0 = rest.iter();
        numbers
    }

    fn entries(&mut self, n: usize, entry: &'static Shape) -> JsValue {
        if matches!(entry, Shape::Number) {
            return match *self.numbers(n) {
                [first, second] => pair(first, second),
                [first, second, third] => triple(first, second, third),
                ref numbers => list(numbers),
            };
        }
        let entries = Array::new();
        for _ in 0..n {
            entries.push(&self.value(entry));
        }
        entries.into()
    }

    fn fields(&mut self, fields: &'static [Field]) -> JsValue {
        let object: Fresh = js_sys::Object::new().unchecked_into();
        for (field, name) in fields.iter().zip(names(fields)) {
            match field.shape {
                Shape::Number | Shape::Whole => object.put_number(name, self.number()),
                ref shape => object.put(name, &self.value(shape)),
            }
        }
        object.into()
    }
}

/// A plain value.
#[cfg(feature = "functions")]
pub(crate) fn shown<T: labs::Plain>(value: &T) -> JsValue {
    let mut numbers = Vec::new();
    value.write(&mut numbers);
    Row::new(&numbers).value(&T::SHAPE)
}

/// An object of these fields.
pub(crate) fn record(fields: &[(&str, JsValue)]) -> JsValue {
    let object: Fresh = js_sys::Object::new().unchecked_into();
    for (name, value) in fields {
        object.put(&(*name).into(), value);
    }
    object.into()
}

#[cfg(feature = "functions")]
pub(crate) use answers::{floats, numbers, plain, rows};

#[cfg(feature = "functions")]
mod answers {
    use crate::errors::thrown;
    use estimate::{Code, Error};
    use nalgebra::{DMatrix, DVector};
    use serde::Serialize;
    use serde_wasm_bindgen::Serializer;
    use wasm_bindgen::prelude::*;

    /// `value` as a plain object: maps as objects, what is absent as null.
    pub(crate) fn plain<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, JsValue> {
        let serializer = Serializer::new().serialize_maps_as_objects(true).serialize_missing_as_null(true);
        value.serialize(&serializer).map_err(|e| thrown(Error::new(Code::Type, "answer", e.to_string())))
    }

    /// A matrix by rows.
    pub(crate) fn rows(m: &DMatrix<f64>) -> Vec<Vec<f64>> {
        m.row_iter().map(|row| row.iter().copied().collect()).collect()
    }

    /// Numbers as a Float64Array.
    pub(crate) fn floats(numbers: &[f64]) -> JsValue {
        js_sys::Float64Array::from(numbers).into()
    }

    /// A vector as its numbers.
    pub(crate) fn numbers(v: &DVector<f64>) -> Vec<f64> {
        v.iter().copied().collect()
    }
}
