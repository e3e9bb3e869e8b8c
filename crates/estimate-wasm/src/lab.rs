//! What every lab's class does: decode parameters, call, encode frames.

use crate::decode::Arg;
use crate::encode::{Row, record};
use crate::errors::Thrown;
use crate::object::Held;
use estimate::Error;
use lab::{Experiment, Kind, Parameter, Shape};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = labs::TYPESCRIPT;

#[wasm_bindgen(typescript_custom_section)]
const OF_EVERY_LAB: &str = include_str!("lab.d.ts");

/// The version of a stored state; a state of another version is refused.
const VERSION: u32 = 1;

/// A lab of any kind.
pub(crate) type AnyLab = Box<dyn Experiment>;
/// Makes a lab of the numbers of its parameters, at a step.
pub(crate) type Open<'a> = &'a dyn Fn(&[f64], u32) -> Result<AnyLab, Error>;

/// A lab's class, which all of its methods name.
pub(crate) struct Class {
    pub name: &'static str,
    pub kind: &'static Kind,
}

impl Class {
    /// A lab at step 0, made by `open` of the parameters that `params` has; of its defaults where there are none.
    pub fn open(&'static self, params: &JsValue, open: Open<'_>) -> Result<Held, Thrown> {
        let arg = Arg::new(params, "params");
        let defaults = (self.kind.defaults)();
        let numbers = if arg.is_undefined() { Ok(defaults) } else { self.decode(&arg, &defaults) };
        let lab = numbers.and_then(|numbers| open(&numbers, 0).map_err(|e| self.blame(e, "params")));
        Ok(Held::new(self.name, lab?))
    }

    /// A lab in a state, made by `open`.
    pub fn open_state(&'static self, state: &JsValue, open: Open<'_>) -> Result<Held, Thrown> {
        let arg = Arg::new(state, "state");
        arg.only(["version", "lab", "params", "step"].into_iter())?;
        arg.field("version")?.whole(VERSION, VERSION)?;
        arg.field("lab")?.word(&[self.kind.name])?;
        let step = arg.field("step")?.whole(0, self.kind.last_step)?;
        let numbers = self.decode(&arg.field("params")?, &(self.kind.defaults)())?;
        Ok(Held::new(self.name, open(&numbers, step).map_err(|e| self.blame(e, "state.params"))?))
    }

    /// What `f` answers of the lab itself, for what one kind of lab has beyond the others.
    #[cfg(any(feature = "late", feature = "log", feature = "filter"))]
    pub fn lab<L: Experiment + 'static, A>(
        &'static self,
        held: &Held,
        f: impl FnOnce(&L) -> Result<A, Error>,
    ) -> Result<A, Thrown> {
        let other = || Error::new(estimate::Code::Type, "this", "is a lab of another kind");
        Ok(held.read(self.name, |lab: &AnyLab| lab.as_any().downcast_ref().ok_or_else(other).and_then(f))??)
    }

    /// The same where `f` may change the lab.
    #[cfg(feature = "log")]
    pub fn change<L: Experiment + 'static>(
        &'static self,
        held: &Held,
        f: impl FnOnce(&mut L) -> Result<(), Error>,
    ) -> Result<(), Thrown> {
        let other = || Error::new(estimate::Code::Type, "this", "is a lab of another kind");
        held.write(self.name, |lab: &mut AnyLab| {
            lab.as_any_mut().downcast_mut().ok_or_else(other).and_then(f).map_err(|e| self.blame(e, "params"))
        })
    }

    pub fn set(&'static self, held: &Held, params: &JsValue) -> Result<(), Thrown> {
        let (base, _) = held.read(self.name, |lab: &AnyLab| lab.state_numbers())?;
        let numbers = self.decode(&Arg::new(params, "params"), &base)?;
        held.write(self.name, |lab: &mut AnyLab| lab.set_params(&numbers).map_err(|e| self.blame(e, "params")))
    }

    pub fn run(&'static self, held: &Held, n: &JsValue) -> Result<(), Thrown> {
        held.is(self.name)?;
        let n = Arg::new(n, "n").whole(1, self.kind.last_step)?;
        self.advance(held, n)
    }

    pub fn advance(&'static self, held: &Held, n: u32) -> Result<(), Thrown> {
        let blame = |e: Error| if e.argument == "n" { e } else { self.blame(e, "params") };
        held.write(self.name, |lab: &mut AnyLab| lab.run_on(n).map_err(blame))
    }

    pub fn frame(&'static self, held: &Held) -> Result<JsValue, Thrown> {
        let numbers = held.read(self.name, |lab: &AnyLab| lab.frame_numbers())?;
        Ok(Row::new(&numbers).value(&self.kind.frame))
    }

    pub fn state(&'static self, held: &Held) -> Result<JsValue, Thrown> {
        let (params, step) = held.read(self.name, |lab: &AnyLab| lab.state_numbers())?;
        Ok(record(&[
            ("version", VERSION.into()),
            ("lab", self.kind.name.into()),
            ("params", Row::new(&params).value(&self.kind.params)),
            ("step", step.into()),
        ]))
    }

    pub fn digest(&'static self, held: &Held) -> Result<String, Thrown> {
        held.read(self.name, |lab: &AnyLab| format!("{:016x}", lab.hash()))
    }

    pub fn parameters(&'static self) -> JsValue {
        let defaults = (self.kind.defaults)();
        let mut row = Row::new(&defaults);
        let described = |p: &'static Parameter| {
            let words = match p.shape {
                Shape::Word(words) => {
                    words.iter().map(|word| JsValue::from_str(word)).collect::<js_sys::Array>().into()
                }
                _ => JsValue::NULL,
            };
            record(&[
                ("name", p.name.into()),
                ("unit", p.unit.into()),
                ("least", p.least.into()),
                ("greatest", p.greatest.into()),
                ("step", p.step.into()),
                ("default", row.value(&p.shape)),
                ("words", words),
            ])
        };
        self.kind.parameters.iter().map(described).collect::<js_sys::Array>().into()
    }

    /// `base` with the parameters that `arg` has; a field that is unknown, or no parameter at all, is refused.
    pub fn decode(&self, arg: &Arg<'_>, base: &[f64]) -> Result<Vec<f64>, Error> {
        arg.only(self.kind.parameters.iter().map(|p| p.name))?;
        let (mut old, mut numbers) = (base.iter(), Vec::new());
        for p in self.kind.parameters {
            let from = numbers.len();
            copy(&p.shape, &mut old, &mut numbers);
            let field = arg.field(p.name)?;
            if !field.is_undefined() {
                numbers.truncate(from);
                field.shaped(p, &p.shape, &mut numbers)?;
            }
        }
        Ok(numbers)
    }

    /// A lab names its parameters alone; whoever reads the error sees where they stood: below `place`.
    fn blame(&self, error: Error, place: &'static str) -> Error {
        let first = error.argument.split(['[', '.']).next().unwrap_or_default();
        if error.argument == "step" {
            error.within("state")
        } else if self.kind.parameters.iter().any(|p| p.name == first) {
            error.within(place)
        } else {
            let (code, message) = (error.code, error.message.clone());
            Error::new(code, place, message)
        }
    }
}

/// Copies the numbers of one parameter.
fn copy(shape: &Shape, from: &mut std::slice::Iter<'_, f64>, to: &mut Vec<f64>) {
    match shape {
        Shape::Exactly(n, entry) => (0..*n).for_each(|_| copy(entry, from, to)),
        Shape::Each(names, value) => names.iter().for_each(|_| copy(value, from, to)),
        Shape::Between(_, _, entry) => {
            let length = from.next().copied().unwrap_or(0.0);
            to.push(length);
            (0..length as usize).for_each(|_| copy(entry, from, to));
        }
        Shape::Text => {
            let length = from.next().copied().unwrap_or(0.0);
            to.push(length);
            to.extend(from.take(length as usize));
        }
        Shape::Maybe(value) => {
            to.extend(from.next());
            if to.last() == Some(&1.0) {
                copy(value, from, to);
            }
        }
        _ => to.extend(from.next()),
    }
}

/// What the class of a lab can do. Its TypeScript is written from the lab's declarations, where `$world` is the type of
/// what it stands on; such a lab has its constructor where its world is.
#[allow(unused_macros)]
macro_rules! lab_class {
    ($name:ident $($world:ident)?) => {
        #[cfg(target_arch = "wasm32")]
        const _: () = {
            #[wasm_bindgen(typescript_custom_section)]
            const TYPES: &str =
                const { &lab::class::<labs::$name>(stringify!($name), concat!($(stringify!($world))?)) }.as_str();
        };

        /// A lab of the page.
        #[wasm_bindgen(skip_typescript)]
        #[repr(transparent)]
        pub struct $name(pub(crate) Held);

        impl $name {
            pub(crate) const CLASS: &'static Class =
                &Class { name: stringify!($name), kind: const { &Kind::of::<labs::$name>() } };
        }

        #[wasm_bindgen]
        impl $name {
            /// The parameters: how far each goes, in which steps, and its default.
            pub fn parameters() -> JsValue {
                Self::CLASS.parameters()
            }

            /// The last step a run can reach.
            #[wasm_bindgen(js_name = lastStep)]
            pub fn last_step() -> u32 {
                Self::CLASS.kind.last_step
            }

            /// Changes the parameters given, and replays the run to the present step.
            pub fn set(&self, params: &JsValue) -> Result<(), Thrown> {
                Self::CLASS.set(&self.0, params)
            }

            /// One step.
            pub fn step(&self) -> Result<(), Thrown> {
                Self::CLASS.advance(&self.0, 1)
            }

            /// `n` steps, at most to the last step.
            pub fn run(&self, n: &JsValue) -> Result<(), Thrown> {
                Self::CLASS.run(&self.0, n)
            }

            /// What there is to draw.
            pub fn frame(&self) -> Result<JsValue, Thrown> {
                Self::CLASS.frame(&self.0)
            }

            /// Parameters and step: all it takes to find this lab again.
            pub fn state(&self) -> Result<JsValue, Thrown> {
                Self::CLASS.state(&self.0)
            }

            /// A hash of what the run has recorded at every step, bit for bit, in hexadecimal.
            pub fn digest(&self) -> Result<String, Thrown> {
                Self::CLASS.digest(&self.0)
            }
        }

        lab_start! { $name $($world)? }
    };
}

/// How a lab is made that stands on its parameters alone.
#[allow(unused_macros)]
macro_rules! lab_start {
    ($name:ident) => {
        #[wasm_bindgen]
        impl $name {
            /// The lab at step 0; what `params` leaves out takes its default.
            #[wasm_bindgen(constructor)]
            pub fn new(params: &JsValue) -> Result<$name, Thrown> {
                Self::CLASS.open(params, &|params, step| lab::open::<labs::$name>((), params, step)).map(Self)
            }

            /// The lab in a state that `state()` answered.
            pub fn from(state: &JsValue) -> Result<$name, Thrown> {
                Self::CLASS.open_state(state, &|params, step| lab::open::<labs::$name>((), params, step)).map(Self)
            }
        }
    };
    ($name:ident $world:ident) => {};
}

/// The classes of the labs whose build this is.
macro_rules! lab_classes {
    ($($module:ident::$name:ident $(of $world:ident)? in $build:literal $(, was $was:literal)?;)*) => {
        $(#[cfg(feature = $build)] lab_class! { $name $($world)? })*
    };
}

labs::figures!(lab_classes);

/// What some labs can do beside the rest.
#[cfg(feature = "filter")]
mod filter;
#[cfg(feature = "filter")]
pub use filter::FilterWorlds;
#[cfg(feature = "late")]
mod late;
