//! The usual way of vectors and matrices: plain arrays of finite numbers, read in one call. Of any other the answer is
//! nothing, and the strict way, entry by entry, says what is wrong.

use super::Arg;
use super::matrix::MAX_SIDE;
use estimate::{Code, Error};
use nalgebra::{DMatrix, DVector};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(module = "/js/arrays.js")]
extern "C" {
    #[wasm_bindgen(js_name = readArray)]
    fn read_array(array: &JsValue, to: &mut [f64]) -> bool;
    #[wasm_bindgen(js_name = readNumbers)]
    fn read_numbers(array: &JsValue, to: &mut [f64]) -> i32;
    #[wasm_bindgen(js_name = readFields)]
    fn read_fields(object: &JsValue, names: &JsValue, to: &mut [f64]) -> bool;
}

/// Room for the largest matrix.
const ROOM: usize = 2 + (MAX_SIDE * MAX_SIDE) as usize;

/// A reading, of which parts may be missing.
pub(crate) enum Outputs {
    Whole(Vec<f64>),
    Partial(Vec<Option<f64>>),
}

impl Outputs {
    /// The parts, and where there is none.
    pub fn parts(self) -> Vec<Option<f64>> {
        match self {
            Self::Whole(numbers) => numbers.into_iter().map(Some).collect(),
            Self::Partial(parts) => parts,
        }
    }
}

/// Arrays one behind another, as `arrays.js` describes them.
pub(crate) struct Plain<'a>(&'a [f64]);

impl Plain<'_> {
    /// The next array, which must be a vector.
    pub fn vector(&mut self) -> Option<DVector<f64>> {
        let [-1.0, length, rest @ ..] = self.0 else { return None };
        let (entries, rest) = rest.split_at_checked(*length as usize)?;
        self.0 = rest;
        Some(DVector::from_column_slice(entries))
    }

    /// The next array, which must be a matrix.
    pub fn matrix(&mut self) -> Option<DMatrix<f64>> {
        let [rows, columns, rest @ ..] = self.0 else { return None };
        if *rows < 0.0 {
            return None;
        }
        let (rows, columns) = (*rows as usize, *columns as usize);
        let (entries, rest) = rest.split_at_checked(rows * columns)?;
        self.0 = rest;
        Some(DMatrix::from_row_slice(rows, columns, entries))
    }
}

impl Arg<'_> {
    /// What `take` finds in this argument.
    pub fn plain<T>(&self, take: impl FnOnce(&mut Plain<'_>) -> Option<T>) -> Option<T> {
        let mut room = [0.0; ROOM];
        if read_array(&self.value, &mut room) { take(&mut Plain(&room)) } else { None }
    }

    /// The numbers of a short array or Float64Array.
    pub fn short(&self) -> Result<Vec<f64>, Error> {
        match self.plain_numbers() {
            Some(numbers) => Ok(numbers),
            None if self.is_short_array()? => self.numbers(),
            None => self.short_floats(),
        }
    }

    /// The same, where an entry may be null.
    pub fn reading(&self) -> Result<Outputs, Error> {
        match self.plain_numbers() {
            Some(numbers) => Ok(Outputs::Whole(numbers)),
            None if self.is_short_array()? => {
                let parts = self.entries()?;
                parts.iter().map(Arg::part).collect::<Result<_, Error>>().map(Outputs::Partial)
            }
            None => self.short_floats().map(Outputs::Whole),
        }
    }

    /// Whether this is an array; one that no input or reading fills is refused before it is read.
    fn is_short_array(&self) -> Result<bool, Error> {
        Ok(self.array()? && self.side(self.length()?, Code::Shape, "entries").map(|_| true)?)
    }

    fn part(&self) -> Result<Option<f64>, Error> {
        if self.is_null() { Ok(None) } else { self.number().map(Some) }
    }

    fn plain_numbers(&self) -> Option<Vec<f64>> {
        let mut room = [0.0; MAX_SIDE as usize];
        // -1 is beyond any room.
        let length = read_numbers(&self.value, &mut room) as usize;
        room.get(..length).map(<[f64]>::to_vec)
    }

    pub(super) fn short_floats(&self) -> Result<Vec<f64>, Error> {
        self.floats(MAX_SIDE).map_err(|error| match error.code {
            Code::Type => self.wrong_type("an array of numbers or a Float64Array"),
            _ => error,
        })
    }

    /// What `take` finds in the fields `names`, at most five of them.
    pub fn plain_fields<T>(
        &self,
        names: &'static [&'static str],
        take: impl FnOnce(&mut Plain<'_>) -> Option<T>,
    ) -> Option<T> {
        let mut room = [0.0; 5 * ROOM];
        let read = read_fields(&self.value, crate::names::array(names), &mut room);
        if read { take(&mut Plain(&room)) } else { None }
    }
}
