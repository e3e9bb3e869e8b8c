//! What a system lets an observer know: decode, call, encode.

use crate::arguments::{number_or, system_of};
use crate::decode::Arg;
use crate::encode::{list, record, shown};
use crate::errors::Thrown;
use estimate::{Error, Reachability, dynamic};
use js_sys::Array;
use nalgebra::DVector;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("analysis.d.ts");

/// Whether (F, H) is observable, and whether it is detectable: what is unseen dies out by itself. The tolerance, 1e-9
/// when left out, says how well the numbers are known, each in units that fit it; an eigenvalue of modulus 1 −
/// tolerance or more does not decay. At most 16 states and 8 outputs.
#[wasm_bindgen(unchecked_return_type = "Detectability")]
pub fn detectability(
    #[wasm_bindgen(js_name = F, unchecked_param_type = "Rows")] f: &JsValue,
    #[wasm_bindgen(js_name = H, unchecked_param_type = "Rows")] h: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] tolerance: &JsValue,
) -> Result<JsValue, Thrown> {
    let tolerance = tolerance_of(tolerance)?;
    let found = dynamic::detectability(Arg::new(f, "F").tall()?, Arg::new(h, "H").tall()?, tolerance)?;
    Ok(record(&[
        ("observable", shown(&found.observable)),
        ("detectable", shown(&found.detectable)),
        ("unseen", directions(&found.unseen)),
        ("modes", shown(&found.modes)),
    ]))
}

/// Whether the input matrix `B` reaches every direction of the state, and whether what it does not reach dies out by
/// itself. At most 16 states and 16 inputs; the tolerance is as in `detectability`.
#[wasm_bindgen(unchecked_return_type = "Reachability")]
pub fn stabilizability(
    #[wasm_bindgen(js_name = F, unchecked_param_type = "Rows")] f: &JsValue,
    #[wasm_bindgen(js_name = B, unchecked_param_type = "Rows")] b: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] tolerance: &JsValue,
) -> Result<JsValue, Thrown> {
    let tolerance = tolerance_of(tolerance)?;
    Ok(reach(&dynamic::stabilizability(Arg::new(f, "F").tall()?, Arg::new(b, "B").wide()?, tolerance)?))
}

/// `stabilizability` of (F, V^½): what noise of the covariance `V` reaches.
#[wasm_bindgen(js_name = noiseReach, unchecked_return_type = "Reachability")]
pub fn noise_reach(
    #[wasm_bindgen(js_name = F, unchecked_param_type = "Rows")] f: &JsValue,
    #[wasm_bindgen(js_name = V, unchecked_param_type = "Rows")] v: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] tolerance: &JsValue,
) -> Result<JsValue, Thrown> {
    let tolerance = tolerance_of(tolerance)?;
    Ok(reach(&dynamic::noise_reach(Arg::new(f, "F").tall()?, Arg::new(v, "V").matrix()?, tolerance)?))
}

/// Whether P(k+1 | k) tends to a limit, and why: `RiccatiLimit` says what each word means.
#[wasm_bindgen(js_name = riccatiLimit, unchecked_return_type = "RiccatiLimit")]
pub fn riccati_limit(
    #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] tolerance: &JsValue,
) -> Result<JsValue, Thrown> {
    Ok(shown(&dynamic::riccati_limit(&system_of(system)?, tolerance_of(tolerance)?)?))
}

pub(crate) fn tolerance_of(value: &JsValue) -> Result<f64, Error> {
    number_or(value, "tolerance", 1e-9)
}

fn reach(found: &Reachability) -> JsValue {
    record(&[
        ("reachable", shown(&found.reachable)),
        ("stabilizable", shown(&found.stabilizable)),
        ("unreached", directions(&found.unreached)),
        ("modes", shown(&found.modes)),
    ])
}

fn directions(all: &[DVector<f64>]) -> JsValue {
    all.iter().map(|v| list(v.as_slice())).collect::<Array>().into()
}
