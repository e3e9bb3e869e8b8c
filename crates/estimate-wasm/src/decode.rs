//! Strict decoding of JavaScript values: nothing is coerced, every step that could run a caller's code (a getter, a
//! proxy) may fail, and every refusal names the culprit.

use crate::names::name;
use estimate::{Code, Error};
use js_sys::Array;
use std::borrow::Cow;
use std::cell::Cell;
use std::fmt;
use wasm_bindgen::prelude::*;

/// The longest array that is looked at; what is longer is refused before it is walked.
const MAX_LENGTH: u32 = 10_000;

#[wasm_bindgen]
extern "C" {
    // js_sys::Array::is_array does not catch, and a revoked proxy makes it throw.
    #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
    fn is_array(value: &JsValue) -> Result<bool, JsValue>;

    #[wasm_bindgen(js_namespace = Number, js_name = isFinite)]
    fn is_finite(value: &JsValue) -> bool;

    // Reading anything may run a caller's code and throw. A call that answers a value leaves a place in the table of
    // references behind each time it throws; one that may answer nothing does not.
    #[wasm_bindgen(catch, js_namespace = Reflect, js_name = get)]
    fn get(of: &JsValue, name: &JsValue) -> Result<Option<JsValue>, JsValue>;
    #[wasm_bindgen(catch, js_namespace = Reflect, js_name = get)]
    fn get_entry(of: &JsValue, index: u32) -> Result<Option<JsValue>, JsValue>;
    #[wasm_bindgen(catch, js_namespace = Object, js_name = getOwnPropertyDescriptor)]
    fn descriptor(of: &JsValue, name: &JsValue) -> Result<Option<JsValue>, JsValue>;
    #[wasm_bindgen(catch, js_namespace = Reflect, js_name = ownKeys)]
    fn own_keys(of: &JsValue) -> Result<Option<Array>, JsValue>;
}

mod fields;
#[cfg(feature = "arguments")]
mod matrix;
#[cfg(feature = "labs")]
mod parameter;
#[cfg(feature = "arguments")]
mod plain;
#[cfg(feature = "arguments")]
pub(crate) use plain::Outputs;

/// Where in a call's arguments a value was found; spelt out for an error only.
#[derive(Clone, Copy)]
enum Path<'a> {
    Name(&'static str),
    Field(&'a Path<'a>, &'static str),
    Item(&'a Path<'a>, u32),
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(name) => f.write_str(name),
            Self::Field(whole, name) => write!(f, "{whole}.{name}"),
            Self::Item(whole, i) => write!(f, "{whole}[{i}]"),
        }
    }
}

/// A value with the path it was found under.
pub(crate) struct Arg<'a> {
    value: Cow<'a, JsValue>,
    path: Path<'a>,
    /// Whether it has been found to be an object, which is asked before each of its fields is read.
    is_object: Cell<bool>,
}

impl<'a> Arg<'a> {
    /// The argument `name` of a call.
    pub fn new(value: &'a JsValue, name: &'static str) -> Self {
        Self { value: Cow::Borrowed(value), path: Path::Name(name), is_object: Cell::new(false) }
    }

    fn found(value: JsValue, path: Path<'a>) -> Self {
        Self { value: Cow::Owned(value), path, is_object: Cell::new(false) }
    }

    pub fn is_undefined(&self) -> bool {
        self.value.is_undefined()
    }

    #[cfg(feature = "models")]
    pub fn is_string(&self) -> bool {
        self.value.is_string()
    }

    pub fn is_null(&self) -> bool {
        self.value.is_null()
    }

    fn refuse(&self, code: Code, message: impl Into<Cow<'static, str>>) -> Error {
        Error::new(code, self.path.to_string(), message)
    }

    fn wrong_type(&self, wanted: &str) -> Error {
        let kind = self.value.js_typeof().as_string().unwrap_or_default();
        let (article, kind) = match kind.as_str() {
            _ if self.value.is_null() => ("", "null"),
            "undefined" => ("", "undefined"),
            "object" if self.array() == Ok(true) => ("an ", "array"),
            "object" => ("an ", "object"),
            other => ("a ", other),
        };
        self.refuse(Code::Type, ["is ", article, kind, "; it must be ", wanted].concat())
    }

    /// A number; NaN and infinities too, which the core refuses by name.
    #[inline(never)]
    pub fn number(&self) -> Result<f64, Error> {
        // True of primitive finite numbers only; as_f64, of primitive numbers, passes its answer through memory.
        if is_finite(&self.value) {
            return Ok(self.value.unchecked_into_f64());
        }
        self.value.as_f64().ok_or_else(|| self.wrong_type("a number"))
    }

    /// A whole number between `least` and `most`.
    pub fn whole(&self, least: u32, most: u32) -> Result<u32, Error> {
        let number = self.number()?;
        if !number.is_finite() {
            return Err(self.refuse(Code::NotFinite, "is not finite; it must be a whole number"));
        }
        if number.fract() != 0.0 {
            return Err(self.refuse(Code::Type, "has a fraction; it must be a whole number"));
        }
        if number < f64::from(least) || number > f64::from(most) {
            let message = format!("must be at least {least} and at most {most}");
            return Err(self.refuse(Code::Limit, message));
        }
        Ok(number as u32)
    }

    /// `true` or `false`.
    #[cfg(any(feature = "labs", feature = "models"))]
    pub fn boolean(&self) -> Result<bool, Error> {
        self.value.as_bool().ok_or_else(|| self.wrong_type("true or false"))
    }

    /// A function, which may be left out.
    #[cfg(feature = "models")]
    pub fn function(&self) -> Result<Option<js_sys::Function>, Error> {
        match self.value.dyn_ref::<js_sys::Function>() {
            Some(function) => Ok(Some(function.clone())),
            None if self.is_undefined() => Ok(None),
            None => Err(self.wrong_type("a function")),
        }
    }

    /// One of the given words: its index.
    pub fn word(&self, words: &[&'static str]) -> Result<usize, Error> {
        if !self.value.is_string() {
            return Err(self.wrong_type(&listed(words.iter().copied())));
        }
        let found = words.iter().position(|word| self.value.as_ref() == name(word));
        found.ok_or_else(|| self.refuse(Code::Type, ["is none of ", &listed(words.iter().copied())].concat()))
    }

    /// A number that may be left out, or null.
    #[cfg(feature = "arguments")]
    pub fn number_or_null(&self) -> Result<Option<f64>, Error> {
        if self.is_undefined() || self.is_null() { Ok(None) } else { self.number().map(Some) }
    }

    /// The field `name` of an object; undefined when there is none. It is read once, since reading may run a caller's
    /// code.
    #[inline(never)]
    pub fn field(&self, name: &'static str) -> Result<Arg<'_>, Error> {
        self.object()?;
        let path = Path::Field(&self.path, name);
        let name = crate::names::name(name);
        let value = get(&self.value, name)
            .and_then(|found| found.map_or_else(|| self.nothing(name), Ok))
            .map_err(|_: JsValue| Error::new(Code::Type, path.to_string(), "could not be read: reading it threw"))?;
        Ok(Arg::found(value, path))
    }

    /// Reads the field `name` into `to`, when there is one.
    #[cfg(feature = "arguments")]
    pub fn given<T>(
        &self,
        name: &'static str,
        read: impl FnOnce(&Arg<'_>) -> Result<T, Error>,
        to: &mut T,
    ) -> Result<(), Error> {
        let field = self.field(name)?;
        if !field.is_undefined() {
            *to = read(&field)?;
        }
        Ok(())
    }

    fn object(&self) -> Result<(), Error> {
        if self.is_object.get() {
            return Ok(());
        }
        if !self.value.is_object() || self.array()? {
            return Err(self.wrong_type("an object"));
        }
        self.is_object.set(true);
        Ok(())
    }

    pub fn array(&self) -> Result<bool, Error> {
        is_array(&self.value).map_err(|_| self.refuse(Code::Type, "could not be read: it is a revoked proxy"))
    }

    /// The length of an array, at most [`MAX_LENGTH`].
    fn length(&self) -> Result<u32, Error> {
        if !self.array()? {
            return Err(self.wrong_type("an array"));
        }
        let length = get(&self.value, name("length")).map_err(|_| self.unreadable())?;
        // Of a proxy it may be anything.
        let whole = length.and_then(|length| length.as_f64()).filter(|length| *length >= 0.0 && length.fract() == 0.0);
        let length = whole.ok_or_else(|| self.refuse(Code::Type, "has a length that is no whole number"))?;
        if length > f64::from(MAX_LENGTH) {
            return Err(self.refuse(Code::Limit, format!("is too long; at most {MAX_LENGTH} entries are read")));
        }
        Ok(length as u32)
    }

    /// An entry of an array, whose length is not asked for again: a proxy may answer another.
    fn entry(&self, i: u32) -> Result<Arg<'_>, Error> {
        let value = get_entry(&self.value, i).and_then(|found| found.map_or_else(|| self.nothing(&i.into()), Ok));
        Ok(Arg::found(value.map_err(|_| self.unreadable())?, Path::Item(&self.path, i)))
    }

    /// What reading answered nothing of, null or undefined: the description of a field tells which. That of a getter
    /// does not, and counts as undefined.
    #[cold]
    fn nothing(&self, key: &JsValue) -> Result<JsValue, JsValue> {
        descriptor(&self.value, key)?.map_or(Ok(JsValue::UNDEFINED), |it| js_sys::Reflect::get(&it, name("value")))
    }

    fn unreadable(&self) -> Error {
        self.refuse(Code::Type, "could not be read: reading it threw")
    }
}

fn listed<'a>(words: impl Iterator<Item = &'a str>) -> String {
    words.fold(String::new(), |mut all, word| {
        if !all.is_empty() {
            all.push_str(", ");
        }
        all.push_str(word);
        all
    })
}
