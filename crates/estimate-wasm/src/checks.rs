//! The chapter's checks, run where the reader is.

use crate::encode::plain;
use crate::errors::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface Check {
    /** 1 to 13, the chapter's numbering. */
    id: number;
    title: string;
    /** What the chapter claims. */
    expected: Vector;
    /** The same numbers, computed just now. */
    actual: Vector;
    /** The largest difference allowed. */
    tolerance: number;
    passed: boolean;
}
"#;

/// Runs the chapter's checks, single runs only.
#[wasm_bindgen(js_name = chapterChecks, unchecked_return_type = "Check[]")]
pub fn chapter_checks() -> Result<JsValue, JsValue> {
    plain(&labs::checks::chapter_checks().map_err(thrown)?)
}
