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

/// An `EstimateError`, as an export throws it: `?` makes it of an error of the core.
pub struct Thrown(JsValue);

impl From<Thrown> for JsValue {
    fn from(Thrown(error): Thrown) -> Self {
        error
    }
}

impl From<Error> for Thrown {
    #[cold]
    #[inline(never)]
    fn from(error: Error) -> Self {
        Self(named(&error.to_string(), name(error.code), &error.argument))
    }
}

/// Why a call that asks a caller's function was not answered.
#[cfg(feature = "models")]
pub enum Refused {
    /// The core refused.
    Ours(Error),
    /// The caller's function threw this.
    Theirs(JsValue),
}

#[cfg(feature = "models")]
impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        Self::Ours(error)
    }
}

#[cfg(feature = "models")]
impl From<Refused> for Thrown {
    fn from(refused: Refused) -> Self {
        match refused {
            Refused::Ours(error) => error.into(),
            Refused::Theirs(thrown) => Self(thrown),
        }
    }
}

/// A text that is no log.
#[cfg(feature = "log")]
impl From<robot_log::Error> for Thrown {
    fn from(error: robot_log::Error) -> Self {
        let js = named(&error.to_string(), "log", "text");
        for (key, value) in [("file", error.file as u32), ("line", error.line), ("column", error.column)] {
            let _ = Reflect::set(&js, &key.into(), &value.into());
        }
        Self(js)
    }
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
