//! Strict decoding of JavaScript values: nothing is coerced, every step that could run a caller's code (a getter, a
//! proxy) may fail, and every refusal names the culprit.

#[cfg(feature = "functions")]
use estimate::Complex;
use estimate::{Code, Error};
use js_sys::Reflect;
#[cfg(feature = "functions")]
use nalgebra::{DMatrix, DVector};
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::fmt;
use wasm_bindgen::prelude::*;

/// The longest array that is looked at; what is longer is refused before it is walked.
const MAX_LENGTH: u32 = 10_000;

/// The most rows, and the most columns, of a matrix: no argument of any call has more. What has more is refused by its
/// lengths, since rows × columns entries of the longest arrays would take a minute to read, or more memory than there is.
#[cfg(feature = "functions")]
const MAX_SIDE: u32 = estimate::validate::MAX_STATES as u32;

#[wasm_bindgen]
extern "C" {
    // js_sys::Array::is_array does not catch, and a revoked proxy makes it throw.
    #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
    fn is_array(value: &JsValue) -> Result<bool, JsValue>;

    #[wasm_bindgen(js_namespace = Number, js_name = isFinite)]
    fn is_finite(value: &JsValue) -> bool;

    // Neither does js_sys::Array::length, and a proxy's may throw or be no number.
    #[wasm_bindgen(js_name = Array)]
    type Lengthy;
    #[wasm_bindgen(catch, method, structural, getter)]
    fn length(this: &Lengthy) -> Result<JsValue, JsValue>;
}

thread_local! {
    /// The names of fields as JavaScript has them: making one of a name takes longer than reading the field.
    static NAMES: RefCell<Vec<(&'static str, &'static JsValue)>> = const { RefCell::new(Vec::new()) };
}

/// `text` as a JavaScript string, made once for each name in the code.
#[inline(never)]
fn name(text: &'static str) -> &'static JsValue {
    let known =
        NAMES.with_borrow(|names| names.iter().find(|(known, _)| std::ptr::eq(*known, text)).map(|(_, made)| *made));
    known.unwrap_or_else(|| {
        // Not while the list is borrowed: a call that ends in the engine, out of stack, would never give it back.
        let made: &'static JsValue = Box::leak(Box::new(text.into()));
        NAMES.with_borrow_mut(|names| names.push((text, made)));
        made
    })
}

#[cfg(feature = "functions")]
#[wasm_bindgen]
extern "C" {
    // What a typed array is and holds, by the getters and the method of its class: a subclass, or what has been given its
    // prototype, may answer anything.
    #[wasm_bindgen(catch, js_namespace = Reflect, js_name = get)]
    fn get_as(class: &JsValue, name: &JsValue, of: &JsValue) -> Result<JsValue, JsValue>;
    #[wasm_bindgen(catch, js_namespace = ["Float64Array", "prototype", "set"], js_name = call)]
    fn copy_floats(to: &mut [f64], from: &JsValue) -> Result<(), JsValue>;
    #[wasm_bindgen(catch, js_namespace = ["Uint32Array", "prototype", "set"], js_name = call)]
    fn copy_wholes(to: &mut [u32], from: &JsValue) -> Result<(), JsValue>;
}

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

    pub fn is_null(&self) -> bool {
        self.value.is_null()
    }

    fn refuse(&self, code: Code, message: impl Into<Cow<'static, str>>) -> Error {
        Error::new(code, self.path.to_string(), message)
    }

    fn wrong_type(&self, wanted: &str) -> Error {
        let found = match self.value.js_typeof().as_string() {
            _ if self.value.is_null() => "null".into(),
            Some(kind) => kind,
            None => "unreadable".into(),
        };
        self.refuse(Code::Type, format!("is {found}; it must be {wanted}"))
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
    pub fn boolean(&self) -> Result<bool, Error> {
        self.value.as_bool().ok_or_else(|| self.wrong_type("true or false"))
    }

    /// One of the given words.
    pub fn word<T: Copy>(&self, words: &[(&str, T)]) -> Result<T, Error> {
        let listed = || listed(words.iter().map(|(word, _)| *word));
        let given = self.value.as_string().ok_or_else(|| self.wrong_type(&listed()))?;
        let found = words.iter().find(|(word, _)| *word == given).map(|(_, value)| *value);
        found.ok_or_else(|| self.refuse(Code::Type, format!("is none of {}", listed())))
    }

    /// The field `name` of an object; undefined when there is none.
    #[inline(never)]
    pub fn field(&self, name: &'static str) -> Result<Arg<'_>, Error> {
        self.object()?;
        let path = Path::Field(&self.path, name);
        let value = Reflect::get(&self.value, self::name(name))
            .map_err(|_| Error::new(Code::Type, path.to_string(), "could not be read: reading it threw"))?;
        Ok(Arg::found(value, path))
    }

    /// Reads the field `name` into `to`, when there is one.
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

    /// Refuses an object with a field that is none of `known`: a misspelt parameter is not silently ignored.
    pub fn only(&self, known: &[&'static str]) -> Result<(), Error> {
        self.object()?;
        let unreadable = |_| self.refuse(Code::Type, "could not be read: listing its fields threw");
        let keys = Reflect::own_keys(&self.value).map_err(unreadable)?;
        let unknown = keys.iter().find(|key| !key.is_symbol() && known.iter().all(|text| key != name(text)));
        match unknown.and_then(|key| key.as_string()) {
            None => Ok(()),
            Some(key) => {
                let path = format!("{}.{key}", self.path);
                Err(Error::new(Code::Type, path, format!("is unknown; there are {}", listed(known.iter().copied()))))
            }
        }
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

    /// The entries of an array.
    pub fn entries(&self) -> Result<Vec<Arg<'_>>, Error> {
        (0..self.length()?).map(|i| self.entry(i)).collect()
    }

    /// The length of an array, at most [`MAX_LENGTH`].
    fn length(&self) -> Result<u32, Error> {
        if !self.array()? {
            return Err(self.wrong_type("an array"));
        }
        let length = self.value.unchecked_ref::<Lengthy>().length().map_err(|_| self.unreadable())?;
        // Of a proxy it may be anything.
        let whole = length.as_f64().filter(|length| *length >= 0.0 && length.fract() == 0.0);
        let length = whole.ok_or_else(|| self.refuse(Code::Type, "has a length that is no whole number"))?;
        if length > f64::from(MAX_LENGTH) {
            return Err(self.refuse(Code::Limit, format!("is too long; at most {MAX_LENGTH} entries are read")));
        }
        Ok(length as u32)
    }

    /// An entry of an array, whose length is not asked for again: a proxy may answer another.
    fn entry(&self, i: u32) -> Result<Arg<'_>, Error> {
        let value = Reflect::get_u32(&self.value, i).map_err(|_| self.unreadable())?;
        Ok(Arg::found(value, Path::Item(&self.path, i)))
    }

    fn unreadable(&self) -> Error {
        self.refuse(Code::Type, "could not be read: reading it threw")
    }

    /// An array of numbers.
    pub fn numbers(&self) -> Result<Vec<f64>, Error> {
        self.first_numbers(self.length()?)
    }

    fn first_numbers(&self, length: u32) -> Result<Vec<f64>, Error> {
        (0..length).map(|i| self.entry(i)?.number()).collect()
    }
}

#[cfg(feature = "functions")]
impl Arg<'_> {
    /// A vector.
    pub fn vector(&self) -> Result<DVector<f64>, Error> {
        self.numbers().map(DVector::from_vec)
    }

    /// An array of rows of one length. One too large is of the wrong shape: another argument says what its sides must be.
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
        let side = |length: u32, code: Code, of: &str| match length {
            0..=MAX_SIDE => Ok(length),
            _ => Err(self.refuse(code, format!("has {length} {of}; at most {MAX_SIDE} are accepted"))),
        };
        let numbers = |i: u32| {
            let row = self.entry(i)?;
            row.first_numbers(side(row.length()?, wide, "columns")?)
        };
        let count = side(self.length()?, tall, "rows")?;
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
        class: &str,
        most: u32,
        copy: impl FnOnce(&mut [T], &JsValue) -> Result<(), JsValue>,
    ) -> Result<Vec<T>, Error> {
        let length = || {
            let of_floats = Reflect::get_prototype_of(&js_sys::Float64Array::new_with_length(0)).ok()?;
            let of_any = Reflect::get_prototype_of(&of_floats).ok()?;
            let tag = get_as(&of_any, &js_sys::Symbol::to_string_tag(), &self.value).ok()?.as_string();
            get_as(&of_any, name("length"), &self.value).ok().filter(|_| tag.as_deref() == Some(class))?.as_f64()
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
    pub fn complex(&self) -> Result<Complex<f64>, Error> {
        if self.value.as_f64().is_some() {
            return self.number().map(Complex::from);
        }
        Ok(Complex::new(self.field("re")?.number()?, self.field("im")?.number()?))
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
