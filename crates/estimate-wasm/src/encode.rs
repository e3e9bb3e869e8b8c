//! Plain JavaScript values from the core's answers.

use crate::errors::thrown;
use estimate::{Code, Error};
#[cfg(feature = "functions")]
use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** At most 10 000 entries are read of any array. */
export type Vector = number[];
/** An array of rows; as an argument at most 16 rows and 16 columns. */
export type Matrix = number[][];
/** N(x, P). */
export interface Belief { x: Vector; P: Matrix }
/** Positions over time, metres, oldest first. */
export interface Track { x: Vector; y: Vector }
export interface Complex { re: number; im: number }
export interface Ellipse { semiMajor: number; semiMinor: number; /** of the major axis, in (−π/2, π/2] */ angle: number }
"#;

/// `value` as a plain object: maps as objects, what is absent as null.
pub(crate) fn plain<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, JsValue> {
    let serializer = Serializer::new().serialize_maps_as_objects(true).serialize_missing_as_null(true);
    value.serialize(&serializer).map_err(|e| thrown(Error::new(Code::Type, "answer", e.to_string())))
}

/// A matrix by rows.
#[cfg(feature = "functions")]
pub(crate) fn rows(m: &DMatrix<f64>) -> Vec<Vec<f64>> {
    m.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// Numbers as a Float64Array.
#[cfg(feature = "functions")]
pub(crate) fn floats(numbers: &[f64]) -> JsValue {
    js_sys::Float64Array::from(numbers).into()
}

/// A vector as its numbers.
#[cfg(feature = "functions")]
pub(crate) fn numbers(v: &DVector<f64>) -> Vec<f64> {
    v.iter().copied().collect()
}
