//! Names as JavaScript has them, made once: making a string takes longer than reading or writing a field.

#[cfg(feature = "arguments")]
use js_sys::Array;
use lab::Field;
use std::cell::RefCell;
use wasm_bindgen::prelude::*;

/// The place and the length of names in the code, which tell them from all others.
type Key = (*const u8, usize);

thread_local! {
    static MADE: RefCell<Vec<(Key, &'static [JsValue])>> = const { RefCell::new(Vec::new()) };
}

/// What `make` made of these names at the first call.
#[inline(never)]
fn once(key: Key, make: &dyn Fn() -> Vec<JsValue>) -> &'static [JsValue] {
    let known = MADE.with_borrow(|all| all.iter().find(|(known, _)| *known == key).map(|(_, made)| *made));
    known.unwrap_or_else(|| {
        // Not while the list is borrowed: a call that ends in the engine, out of stack, would never give it back.
        let made = Vec::leak(make());
        MADE.with_borrow_mut(|all| all.push((key, made)));
        made
    })
}

/// `text` as a JavaScript string.
pub(crate) fn name(text: &'static str) -> &'static JsValue {
    &once((text.as_ptr(), text.len()), &|| vec![text.into()])[0]
}

/// An array of the names.
#[cfg(feature = "arguments")]
pub(crate) fn array(names: &'static [&'static str]) -> &'static JsValue {
    &once((names.as_ptr().cast(), names.len()), &|| vec![names.iter().copied().map(name).collect::<Array>().into()])[0]
}

/// The names of a record's fields.
pub(crate) fn of_fields(fields: &'static [Field]) -> &'static [JsValue] {
    once((fields.as_ptr().cast(), fields.len()), &|| fields.iter().map(|field| field.name.into()).collect())
}
