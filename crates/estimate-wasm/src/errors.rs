//! The core's errors as JavaScript sees them.

use estimate::{Code, Error};
use js_sys::Reflect;
use wasm_bindgen::prelude::*;

/// The documented name of a code.
pub(crate) fn name(code: Code) -> &'static str {
    match code {
        Code::NotFinite => "not-finite",
        Code::Shape => "shape",
        Code::NotSymmetric => "not-symmetric",
        Code::NotPositiveSemidefinite => "not-positive-semidefinite",
        Code::InnovationNotPositiveDefinite => "innovation-not-positive-definite",
        Code::Unobservable => "unobservable",
        Code::Poles => "poles",
        Code::Tolerance => "tolerance",
        Code::Index => "index",
        Code::AtLandmark => "at-landmark",
        Code::NotPlaceable => "not-placeable",
        Code::Limit => "limit",
        Code::Type => "type",
        Code::DidNotConverge => "did-not-converge",
    }
}

/// The `EstimateError` to throw.
pub(crate) fn thrown(error: Error) -> JsValue {
    named(&error.to_string(), name(error.code), &error.argument)
}

/// The `EstimateError` of a text that is no log.
#[cfg(feature = "log")]
pub(crate) fn thrown_at(message: &str, line: u32, column: u32) -> JsValue {
    let js = named(&format!("line {line}, column {column}: {message}"), "log", "text");
    for (key, value) in [("line", line), ("column", column)] {
        let _ = Reflect::set(&js, &key.into(), &value.into());
    }
    js
}

fn named(message: &str, code: &str, argument: &str) -> JsValue {
    let js = js_sys::Error::new(message);
    js.set_name("EstimateError");
    for (key, value) in [("code", code), ("argument", argument)] {
        // Fails on a frozen object only, which a new Error is not.
        let _ = Reflect::set(&js, &key.into(), &value.into());
    }
    js.into()
}
