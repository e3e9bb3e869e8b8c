//! The fields of an object, and texts.

#[cfg(feature = "arguments")]
use super::get;
use super::{Arg, listed, own_keys};
use crate::names::name;
use estimate::{Code, Error};
use js_sys::{Array, JsString};
use wasm_bindgen::prelude::*;

/// The longest name, in letters.
const LONGEST: u32 = 60;

impl Arg<'_> {
    /// A text.
    #[cfg(feature = "log")]
    pub fn text(&self) -> Result<String, Error> {
        self.value.as_string().ok_or_else(|| self.wrong_type("a text"))
    }

    /// A text of at most so many bytes.
    #[cfg(any(feature = "programs", feature = "filter"))]
    pub fn text_of(&self, most: usize) -> Result<String, Error> {
        match self.value.dyn_ref::<JsString>() {
            None => Err(self.wrong_type("a text")),
            Some(text) if text.length() as usize > most => {
                Err(self.refuse(Code::Limit, format!("is longer than {most} letters")))
            }
            Some(text) => Ok(String::from(text)),
        }
    }

    /// A name: a text that is not long.
    #[cfg(feature = "arguments")]
    pub fn name(&self) -> Result<String, Error> {
        match self.value.dyn_ref::<JsString>() {
            None => Err(self.wrong_type("a text")),
            Some(text) if text.length() > LONGEST => {
                Err(self.refuse(Code::Limit, format!("is longer than {LONGEST} letters")))
            }
            Some(text) => Ok(String::from(text)),
        }
    }

    /// Refuses an object with a field that is none of `known`: a misspelt parameter is not silently ignored.
    pub fn only(&self, known: impl Iterator<Item = &'static str> + Clone) -> Result<(), Error> {
        let keys = self.keys()?;
        let unknown = keys.iter().find(|key| !key.is_symbol() && known.clone().all(|text| key != name(text)));
        match unknown {
            None => Ok(()),
            Some(key) => {
                let path = format!("{}.{}", self.path, shortened(key));
                Err(Error::new(Code::Type, path, ["is unknown; there are ", &listed(known)].concat()))
            }
        }
    }

    /// The own fields of an object whose names are the caller's, in their order, and at most so many. Their values are
    /// to be decoded by themselves.
    #[cfg(feature = "arguments")]
    pub fn own_fields(&self, most: u32) -> Result<Vec<(String, JsValue)>, Error> {
        let keys = self.keys()?;
        if keys.length() > most {
            return Err(self.refuse(Code::Limit, format!("has {} fields; at most {most} are accepted", keys.length())));
        }
        let read = |key: JsValue| {
            let value = get(&self.value, &key).map_err(|_| self.unreadable())?;
            match Arg::found(key, self.path).name() {
                Ok(name) => Ok((name, value.unwrap_or_default())),
                Err(_) => Err(self.refuse(Code::Limit, format!("has a name of more than {LONGEST} letters"))),
            }
        };
        keys.iter().filter(|key| !key.is_symbol()).map(read).collect()
    }

    fn keys(&self) -> Result<Array, Error> {
        self.object()?;
        let keys = own_keys(&self.value).ok().flatten();
        keys.ok_or_else(|| self.refuse(Code::Type, "could not be read: listing its fields threw"))
    }
}

/// A name in an error: of a long one its first letters.
fn shortened(key: JsValue) -> String {
    let key: JsString = key.unchecked_into();
    if key.length() <= LONGEST { String::from(key) } else { String::from(key.slice(0, LONGEST)) + "…" }
}
