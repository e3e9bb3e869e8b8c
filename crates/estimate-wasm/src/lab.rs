//! What every lab's class does: decode parameters, call, encode frames.

use crate::decode::Arg;
use crate::encode::plain;
use crate::errors::thrown;
use estimate::{Code, Error};
use labs::{Lab, MAX_STEP, State};
use serde::Serialize;
use std::cell::RefCell;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** All it takes to find a lab again, to the last digit. */
export interface LabState<Params> { version: 1; lab: string; params: Params; step: number }
"#;

/// The version of [`LabState`]; a state of another version is refused.
const VERSION: u32 = 1;

/// A lab whose parameters can be read from JavaScript.
pub(crate) trait Decoded: Lab<Params: Serialize> {
    /// `base` with the fields that `arg` has; a field that is unknown, or no parameter at all, is refused.
    fn decode(arg: &Arg<'_>, base: Self::Params) -> Result<Self::Params, Error>;
}

/// A lab behind a shared reference: arguments are decoded before it is borrowed, so that a getter of a caller's object
/// which calls back into the lab finds it free.
pub(crate) struct Held<L>(RefCell<L>);

impl<L: Decoded> Held<L> {
    pub fn new(params: &JsValue) -> Result<Self, JsValue> {
        let arg = Arg::new(params, "params");
        let base = L::Params::default();
        let params = if arg.is_undefined() { Ok(base) } else { L::decode(&arg, base) };
        let lab = params.and_then(L::new).map_err(blame_params).map_err(thrown)?;
        Ok(Self(RefCell::new(lab)))
    }

    pub fn from_state(state: &JsValue) -> Result<Self, JsValue> {
        let read = || -> Result<L, Error> {
            let arg = Arg::new(state, "state");
            arg.only(&["version", "lab", "params", "step"])?;
            arg.field("version")?.whole(VERSION, VERSION)?;
            arg.field("lab")?.word(&[(L::NAME, ())])?;
            let step = arg.field("step")?.whole(0, MAX_STEP)?;
            let params = L::decode(&arg.field("params")?, L::Params::default())?;
            L::from_state(State { params, step }).map_err(blame_params)
        };
        Ok(Self(RefCell::new(read().map_err(thrown)?)))
    }

    pub fn set(&self, params: &JsValue) -> Result<(), JsValue> {
        let base = self.read(|lab| lab.params().clone())?;
        let params = L::decode(&Arg::new(params, "params"), base).map_err(thrown)?;
        self.write(|lab| lab.set(params).map_err(blame_params))
    }

    pub fn run(&self, n: &JsValue) -> Result<(), JsValue> {
        let n = Arg::new(n, "n").whole(1, MAX_STEP).map_err(thrown)?;
        self.write(|lab| lab.run(n))
    }

    pub fn step(&self) -> Result<(), JsValue> {
        self.write(Lab::step)
    }

    pub fn frame(&self) -> Result<JsValue, JsValue> {
        plain(&self.read(Lab::frame)?)
    }

    pub fn state(&self) -> Result<JsValue, JsValue> {
        let State { params, step } = self.read(Lab::state)?;
        plain(&StateAnswer { version: VERSION, lab: L::NAME, params, step })
    }

    pub fn digest(&self) -> Result<String, JsValue> {
        Ok(format!("{:016x}", self.read(Lab::digest)?))
    }

    pub fn read<T>(&self, f: impl FnOnce(&L) -> T) -> Result<T, JsValue> {
        self.0.try_borrow().map(|lab| f(&lab)).map_err(|_| busy())
    }

    fn write(&self, f: impl FnOnce(&mut L) -> Result<(), Error>) -> Result<(), JsValue> {
        let mut lab = self.0.try_borrow_mut().map_err(|_| busy())?;
        f(&mut lab).map_err(thrown)
    }
}

#[derive(Serialize)]
struct StateAnswer<P> {
    version: u32,
    lab: &'static str,
    params: P,
    step: u32,
}

/// A lab names its parameters alone; the reader of the error sees where they stood.
fn blame_params(error: Error) -> Error {
    if error.argument.starts_with("params") || error.argument == "step" { error } else { error.within("params") }
}

/// What a call from within a call is told.
pub(crate) fn busy() -> JsValue {
    thrown(Error::new(Code::Type, "this", "is in the middle of a call"))
}

/// The class of a lab, with the TypeScript names of its partial parameters, its frame and its state:
/// `lab_class!("What it is.", Name: labs::Name, "Partial<Params>", "Frame", "LabState<Params>")`. What it is comes as plain
/// text: of a doc comment that has gone through a macro, wasm-bindgen writes the quotes too.
macro_rules! lab_class {
    ($doc:tt, $name:ident: $lab:ty, $partial:tt, $frame:tt, $state:tt) => {
        #[doc = $doc]
        #[wasm_bindgen]
        pub struct $name($crate::lab::Held<$lab>);

        #[wasm_bindgen]
        impl $name {
            /// The lab at step 0; what `params` leaves out takes its default.
            #[wasm_bindgen(constructor)]
            pub fn new(
                #[wasm_bindgen(unchecked_optional_param_type = $partial)] params: &JsValue,
            ) -> Result<$name, JsValue> {
                $crate::lab::Held::new(params).map(Self)
            }

            /// The lab in a state that `state()` answered.
            pub fn from(#[wasm_bindgen(unchecked_param_type = $state)] state: &JsValue) -> Result<$name, JsValue> {
                $crate::lab::Held::from_state(state).map(Self)
            }

            /// Changes the parameters given, and replays the run to the present step.
            pub fn set(
                &self,
                #[wasm_bindgen(unchecked_param_type = $partial)] params: &JsValue,
            ) -> Result<(), JsValue> {
                self.0.set(params)
            }

            /// One step.
            pub fn step(&self) -> Result<(), JsValue> {
                self.0.step()
            }

            /// `n` steps, at most to step 100 000.
            pub fn run(&self, #[wasm_bindgen(unchecked_param_type = "number")] n: &JsValue) -> Result<(), JsValue> {
                self.0.run(n)
            }

            /// What there is to draw.
            #[wasm_bindgen(unchecked_return_type = $frame)]
            pub fn frame(&self) -> Result<JsValue, JsValue> {
                self.0.frame()
            }

            /// Parameters and step: all it takes to find this lab again.
            #[wasm_bindgen(unchecked_return_type = $state)]
            pub fn state(&self) -> Result<JsValue, JsValue> {
                self.0.state()
            }

            /// A hash of what the run has recorded at every step (truth, readings, estimates, covariances and their
            /// comparison), bit for bit, in hexadecimal.
            pub fn digest(&self) -> Result<String, JsValue> {
                self.0.digest()
            }
        }
    };
}
pub(crate) use lab_class;
