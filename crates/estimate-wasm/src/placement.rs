//! Where a gain puts the eigenvalues of an observer: decode, call, encode.

use crate::analysis::tolerance_of;
use crate::decode::Arg;
use crate::encode::{record, rows, shown};
use crate::errors::Thrown;
use estimate::{Complex, Error, dynamic};
use nalgebra::DMatrix;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("placement.d.ts");

/// The gain K that gives (I − KH)F the eigenvalues `poles`, for a single output (Ackermann on (F, HF)) and at most 16
/// states. Where F is singular one eigenvalue is 0 whatever K is, and 0 must be among the poles.
#[wasm_bindgen(js_name = placeObserverGain, unchecked_return_type = "Matrix")]
pub fn place_observer_gain(
    #[wasm_bindgen(js_name = F, unchecked_param_type = "Rows")] f: &JsValue,
    #[wasm_bindgen(js_name = H, unchecked_param_type = "Rows")] h: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "(number | Complex)[]")] poles: &JsValue,
) -> Result<JsValue, Thrown> {
    let poles = poles_of(poles)?;
    let k = dynamic::place_observer_gain(Arg::new(f, "F").tall()?, Arg::new(h, "H").tall()?, &poles)?;
    Ok(rows(&DMatrix::from_column_slice(k.len(), 1, k.as_slice())))
}

/// The gain K that moves those eigenvalues of (I − KH)F that a gain can move to `poles`, for one output or several, and
/// the eigenvalues that stay where they are. With several outputs K is the smallest gain of those tried. At most 16
/// states and 8 outputs.
#[wasm_bindgen(js_name = placeMovable, unchecked_return_type = "Placement")]
pub fn place_movable(
    #[wasm_bindgen(js_name = F, unchecked_param_type = "Rows")] f: &JsValue,
    #[wasm_bindgen(js_name = H, unchecked_param_type = "Rows")] h: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "(number | Complex)[]")] poles: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] tolerance: &JsValue,
) -> Result<JsValue, Thrown> {
    let (poles, tolerance) = (poles_of(poles)?, tolerance_of(tolerance)?);
    let movable = dynamic::movable(Arg::new(f, "F").tall()?, Arg::new(h, "H").tall()?, tolerance)?;
    Ok(record(&[("K", rows(&movable.gain(&poles)?)), ("fixed", shown(&movable.fixed()?))]))
}

/// Poles: real numbers, or complex ones `{ re, im }`.
fn poles_of(value: &JsValue) -> Result<Vec<Complex<f64>>, Error> {
    Arg::new(value, "poles").entries()?.iter().map(Arg::complex).collect()
}
