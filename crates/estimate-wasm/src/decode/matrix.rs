//! Vectors, matrices and typed arrays as arguments.

use super::Arg;
use crate::names::name;
#[cfg(feature = "analysis")]
use estimate::Complex;
use estimate::{Code, Error};
use js_sys::Reflect;
use nalgebra::{DMatrix, DVector};
use wasm_bindgen::prelude::*;

/// The most rows, and the most columns, of a matrix: no argument of any call has more. What has more is refused by its
/// lengths, since rows × columns entries of the longest arrays would take a minute to read, or more memory than there
/// is.
pub(super) const MAX_SIDE: u32 = estimate::validate::MAX_STATES as u32;

#[wasm_bindgen]
extern "C" {
    // What a typed array is and holds, by the getters and the method of its class: a subclass, or what has been given
    // its prototype, may answer anything.
    #[wasm_bindgen(catch, js_namespace = Reflect, js_name = get)]
    fn get_as(class: &JsValue, name: &JsValue, of: &JsValue) -> Result<Option<JsValue>, JsValue>;
    #[wasm_bindgen(catch, js_namespace = ["Float64Array", "prototype", "set"], js_name = call)]
    fn copy_floats(to: &mut [f64], from: &JsValue) -> Result<(), JsValue>;
    #[wasm_bindgen(catch, js_namespace = ["Uint32Array", "prototype", "set"], js_name = call)]
    fn copy_wholes(to: &mut [u32], from: &JsValue) -> Result<(), JsValue>;
}

impl Arg<'_> {
    /// The entries of an array.
    pub fn entries(&self) -> Result<Vec<Arg<'_>>, Error> {
        (0..self.length()?).map(|i| self.entry(i)).collect()
    }

    /// An array of numbers.
    pub fn numbers(&self) -> Result<Vec<f64>, Error> {
        self.first_numbers(self.length()?)
    }

    fn first_numbers(&self, length: u32) -> Result<Vec<f64>, Error> {
        (0..length).map(|i| self.entry(i)?.number()).collect()
    }

    /// A vector: an array or a Float64Array.
    pub fn vector(&self) -> Result<DVector<f64>, Error> {
        self.short().map(DVector::from_vec)
    }

    /// An array of rows of one length, each an array or a Float64Array. One too large is of the wrong shape: another
    /// argument says what its sides must be.
    pub fn matrix(&self) -> Result<DMatrix<f64>, Error> {
        self.matrix_within(Code::Shape, Code::Shape)
    }

    /// A matrix whose rows are the states or outputs, so that too many of them are beyond a limit.
    pub fn tall(&self) -> Result<DMatrix<f64>, Error> {
        self.matrix_within(Code::Limit, Code::Shape)
    }

    /// A matrix whose columns are the inputs, so that too many of them are beyond a limit.
    pub fn wide(&self) -> Result<DMatrix<f64>, Error> {
        self.matrix_within(Code::Shape, Code::Limit)
    }

    /// A matrix of at most [`MAX_SIDE`] rows and columns; the codes are for one with too many of either.
    fn matrix_within(&self, tall: Code, wide: Code) -> Result<DMatrix<f64>, Error> {
        if let Some(matrix) = self.plain(|arrays| arrays.matrix()) {
            return Ok(matrix);
        }
        let numbers = |i: u32| {
            let row = self.entry(i)?;
            if !row.array()? {
                return row.short_floats();
            }
            row.first_numbers(self.side(row.length()?, wide, "columns")?)
        };
        let count = self.side(self.length()?, tall, "rows")?;
        let rows = (0..count).map(numbers).collect::<Result<Vec<_>, _>>()?;
        let width = rows.first().map_or(0, Vec::len);
        match rows.iter().position(|row| row.len() != width) {
            Some(i) => {
                let message = format!("is ragged: row {i} has {} entries, row 0 has {width}", rows[i].len());
                Err(self.refuse(Code::Shape, message))
            }
            None => Ok(DMatrix::from_row_iterator(rows.len(), width, rows.into_iter().flatten())),
        }
    }

    /// A length of at most [`MAX_SIDE`]; the code is for a greater one.
    pub(super) fn side(&self, length: u32, code: Code, of: &str) -> Result<u32, Error> {
        match length {
            0..=MAX_SIDE => Ok(length),
            _ => Err(self.refuse(code, format!("has {length} {of}; at most {MAX_SIDE} are accepted"))),
        }
    }

    /// The numbers of a Float64Array of at most `most`.
    pub fn floats(&self, most: u32) -> Result<Vec<f64>, Error> {
        self.typed("Float64Array", most, copy_floats)
    }

    /// The numbers of a Uint32Array of at most `most`.
    pub fn wholes(&self, most: u32) -> Result<Vec<u32>, Error> {
        self.typed("Uint32Array", most, copy_wholes)
    }

    fn typed<T: Copy + Default>(
        &self,
        class: &'static str,
        most: u32,
        copy: impl FnOnce(&mut [T], &JsValue) -> Result<(), JsValue>,
    ) -> Result<Vec<T>, Error> {
        let length = || {
            let of_floats = Reflect::get_prototype_of(&js_sys::Float64Array::new_with_length(0)).ok()?;
            let of_any = Reflect::get_prototype_of(&of_floats).ok()?;
            let tag = get_as(&of_any, &js_sys::Symbol::to_string_tag(), &self.value).ok()??;
            if tag != *name(class) {
                return None;
            }
            get_as(&of_any, name("length"), &self.value).ok()??.as_f64()
        };
        let length = length().ok_or_else(|| self.wrong_type(&format!("a {class}")))?;
        if length > f64::from(most) {
            return Err(self.refuse(Code::Limit, format!("is too long; at most {most} numbers")));
        }
        let mut numbers = vec![T::default(); length as usize];
        copy(&mut numbers, &self.value).map_err(|_| self.unreadable())?;
        Ok(numbers)
    }

    /// A number, or `{ re, im }`.
    #[cfg(feature = "analysis")]
    pub fn complex(&self) -> Result<Complex<f64>, Error> {
        if self.value.as_f64().is_some() {
            return self.number().map(Complex::from);
        }
        Ok(Complex::new(self.field("re")?.number()?, self.field("im")?.number()?))
    }
}
