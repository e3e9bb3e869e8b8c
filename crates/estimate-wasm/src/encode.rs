//! Plain JavaScript values from the core's answers.

use crate::names::{name, of_fields};
use js_sys::Array;
use lab::{Field, Shape};
use std::slice::Iter;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

#[wasm_bindgen(module = "/js/lists.js")]
extern "C" {
    fn pair(first: f64, second: f64) -> JsValue;
    fn triple(first: f64, second: f64, third: f64) -> JsValue;
}

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = Array, js_name = from)]
    fn long(numbers: &[f64]) -> JsValue;

    #[wasm_bindgen(js_name = Object)]
    type Fresh;
    // On a new object neither fails. A number is handed over as it is, without a place in the table of references.
    #[wasm_bindgen(method, structural, indexing_setter)]
    fn put(this: &Fresh, name: &JsValue, value: &JsValue);
    #[wasm_bindgen(method, structural, indexing_setter)]
    fn put_number(this: &Fresh, name: &JsValue, value: f64);
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
            Shape::List(entry) | Shape::Between(_, _, entry) => {
                let length = self.number() as usize;
                self.entries(length, entry)
            }
            Shape::Record(_, fields) => self.fields(fields),
            Shape::Sparse(_, fields) => self.present(fields),
            Shape::Each(names, value) => self.each(names, value),
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
            return list(self.numbers(n));
        }
        let entries = Array::new();
        for _ in 0..n {
            entries.push(&self.value(entry));
        }
        entries.into()
    }

    /// The fields that hold something.
    fn present(&mut self, fields: &'static [Field]) -> JsValue {
        let object: Fresh = js_sys::Object::new().unchecked_into();
        for (field, name) in fields.iter().zip(of_fields(fields)) {
            let value = self.value(&field.shape);
            if !value.is_null() {
                object.put(name, &value);
            }
        }
        object.into()
    }

    /// One value where all are the same.
    fn each(&mut self, names: &'static [&'static str], shape: &'static Shape) -> JsValue {
        if shape.is_repeated(names.len(), self.0.as_slice()) {
            let value = self.value(shape);
            (1..names.len()).for_each(|_| drop(self.value(shape)));
            return value;
        }
        let object: Fresh = js_sys::Object::new().unchecked_into();
        for each in names {
            object.put(name(each), &self.value(shape));
        }
        object.into()
    }

    fn fields(&mut self, fields: &'static [Field]) -> JsValue {
        let object: Fresh = js_sys::Object::new().unchecked_into();
        for (field, name) in fields.iter().zip(of_fields(fields)) {
            match field.shape {
                Shape::Number | Shape::Whole => object.put_number(name, self.number()),
                ref shape => object.put(name, &self.value(shape)),
            }
        }
        object.into()
    }
}

/// The numbers as an array.
pub(crate) fn list(numbers: &[f64]) -> JsValue {
    match *numbers {
        [first, second] => pair(first, second),
        [first, second, third] => triple(first, second, third),
        _ => long(numbers),
    }
}

/// A number, or null where there is none.
#[cfg(feature = "arguments")]
pub(crate) fn number_or_null(number: Option<f64>) -> JsValue {
    number.map_or(JsValue::NULL, JsValue::from_f64)
}

/// An object of these fields.
pub(crate) fn record(fields: &[(&'static str, JsValue)]) -> JsValue {
    let object: Fresh = js_sys::Object::new().unchecked_into();
    for (field, value) in fields {
        object.put(name(field), value);
    }
    object.into()
}

#[cfg(feature = "arguments")]
pub(crate) use answers::{Arrays, rows, shown};

#[cfg(feature = "arguments")]
mod answers {
    use super::Row;
    use nalgebra::{Dim, Matrix, RawStorage};
    use wasm_bindgen::prelude::*;

    #[wasm_bindgen(module = "/js/arrays.js")]
    extern "C" {
        #[wasm_bindgen(js_name = matrixOf)]
        fn matrix_of(entries: &[f64], rows: usize) -> JsValue;
        #[wasm_bindgen(js_name = putFields)]
        fn put_fields(object: &JsValue, names: &JsValue, from: &[f64]);
    }

    fn by_rows<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(m: &Matrix<f64, R, C, S>) -> impl Iterator<Item = f64> {
        (0..m.nrows()).flat_map(move |i| (0..m.ncols()).map(move |j| m[(i, j)]))
    }

    /// A matrix as an array of rows.
    pub(crate) fn rows<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(m: &Matrix<f64, R, C, S>) -> JsValue {
        matrix_of(&by_rows(m).collect::<Vec<f64>>(), m.nrows())
    }

    /// Vectors and matrices that cross over together, as `arrays.js` describes them.
    #[derive(Default)]
    pub(crate) struct Arrays(Vec<f64>);

    impl Arrays {
        pub fn vector(mut self, entries: &[f64]) -> Self {
            self.0.extend([-1.0, entries.len() as f64]);
            self.0.extend(entries);
            self
        }

        pub fn matrix<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(mut self, m: &Matrix<f64, R, C, S>) -> Self {
            self.0.extend([m.nrows() as f64, m.ncols() as f64]);
            self.0.extend(by_rows(m));
            self
        }

        /// A matrix whose entries lie row by row.
        #[cfg(feature = "programs")]
        pub fn rows(mut self, [rows, columns]: [usize; 2], entries: &[f64]) -> Self {
            self.0.extend([rows as f64, columns as f64]);
            self.0.extend(entries);
            self
        }

        /// What is not there.
        #[cfg(feature = "programs")]
        pub fn nothing(mut self) -> Self {
            self.0.extend([-2.0, 0.0]);
            self
        }

        /// Puts them on an object, under these names.
        pub fn put(self, object: &JsValue, names: &'static [&'static str]) {
            put_fields(object, crate::names::array(names), &self.0);
        }
    }

    /// A plain value.
    pub(crate) fn shown<T: lab::Plain>(value: &T) -> JsValue {
        let mut numbers = Vec::new();
        value.write(&mut numbers);
        Row::new(&numbers).value(&T::SHAPE)
    }
}
