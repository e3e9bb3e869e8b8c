//! The chapter's checks, run where the reader is.

use crate::decode::Arg;
use crate::errors::Thrown;
use chapter_kalman::checks::{self, CHECKS};
use estimate::{Code, Error};
use serde_wasm_bindgen::to_value;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("checks.d.ts");

/// Runs the chapter's checks, single runs only.
#[wasm_bindgen(js_name = chapterChecks, unchecked_return_type = "Check[]")]
pub fn chapter_checks() -> Result<JsValue, JsValue> {
    Ok(to_value(&checks::chapter_checks().map_err(Thrown::from)?)?)
}

/// Runs the check with the number `id`, counted from 1; any other whole number is an error with the code "index".
#[wasm_bindgen(js_name = chapterCheck, unchecked_return_type = "Check")]
pub fn chapter_check(#[wasm_bindgen(unchecked_param_type = "number")] id: &JsValue) -> Result<JsValue, JsValue> {
    // A number that no counter holds is the number of no check either.
    let as_index = |mut e: Error| {
        if e.code == Code::Limit {
            e.code = Code::Index;
        }
        e
    };
    let id = Arg::new(id, "id").whole(1, CHECKS.len() as u32).map_err(as_index).map_err(Thrown::from)?;
    Ok(to_value(&checks::chapter_check(id).map_err(Thrown::from)?)?)
}
