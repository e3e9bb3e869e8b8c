//! What every lab's class does: decode parameters, call, encode frames.

use crate::decode::Arg;
use crate::encode::{Row, record};
use crate::errors::thrown;
use crate::object::Held;
use estimate::{Code, Error};
use labs::{Experiment, Kind, MAX_STEP, Parameter, Shape};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = labs::TYPESCRIPT;

/// The version of a stored state; a state of another version is refused.
const VERSION: u32 = 1;

/// A lab of any kind.
type AnyLab = Box<dyn Experiment>;

/// A lab's class, which all of its methods name.
pub(crate) struct Class {
    pub name: &'static str,
    pub kind: Kind,
}

impl Class {
    pub fn open(&'static self, params: &JsValue) -> Result<Held, JsValue> {
        let arg = Arg::new(params, "params");
        let defaults = (self.kind.defaults)();
        let numbers = if arg.is_undefined() { Ok(defaults) } else { self.decode(&arg, &defaults) };
        let lab = numbers.and_then(|numbers| (self.kind.open)(&numbers, 0).map_err(|e| self.blame(e, "params")));
        Ok(Held::new(self.name, lab.map_err(thrown)?))
    }

    pub fn open_state(&'static self, state: &JsValue) -> Result<Held, JsValue> {
        let read = || -> Result<AnyLab, Error> {
            let arg = Arg::new(state, "state");
            arg.only(["version", "lab", "params", "step"].into_iter())?;
            arg.field("version")?.whole(VERSION, VERSION)?;
            arg.field("lab")?.word(&[self.kind.name])?;
            let step = arg.field("step")?.whole(0, MAX_STEP)?;
            let numbers = self.decode(&arg.field("params")?, &(self.kind.defaults)())?;
            (self.kind.open)(&numbers, step).map_err(|e| self.blame(e, "state.params"))
        };
        Ok(Held::new(self.name, read().map_err(thrown)?))
    }

    pub fn set(&'static self, held: &Held, params: &JsValue) -> Result<(), JsValue> {
        let (base, _) = held.read(self.name, |lab: &AnyLab| lab.state_numbers())?;
        let numbers = self.decode(&Arg::new(params, "params"), &base).map_err(thrown)?;
        held.write(self.name, |lab: &mut AnyLab| lab.set_params(&numbers).map_err(|e| self.blame(e, "params")))
    }

    pub fn run(&'static self, held: &Held, n: &JsValue) -> Result<(), JsValue> {
        held.is(self.name)?;
        let n = Arg::new(n, "n").whole(1, MAX_STEP).map_err(thrown)?;
        self.advance(held, n)
    }

    pub fn advance(&'static self, held: &Held, n: u32) -> Result<(), JsValue> {
        let blame = |e: Error| if e.argument == "n" { e } else { self.blame(e, "params") };
        held.write(self.name, |lab: &mut AnyLab| lab.run_on(n).map_err(blame))
    }

    pub fn frame(&'static self, held: &Held) -> Result<JsValue, JsValue> {
        let numbers = held.read(self.name, |lab: &AnyLab| lab.frame_numbers())?;
        Ok(Row::new(&numbers).value(&self.kind.frame))
    }

    pub fn state(&'static self, held: &Held) -> Result<JsValue, JsValue> {
        let (params, step) = held.read(self.name, |lab: &AnyLab| lab.state_numbers())?;
        Ok(record(&[
            ("version", VERSION.into()),
            ("lab", self.kind.name.into()),
            ("params", Row::new(&params).value(&self.kind.params)),
            ("step", step.into()),
        ]))
    }

    pub fn digest(&'static self, held: &Held) -> Result<String, JsValue> {
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
    fn decode(&self, arg: &Arg<'_>, base: &[f64]) -> Result<Vec<f64>, Error> {
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
        let first = error.argument.split('[').next().unwrap_or_default();
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
        Shape::Maybe(value) => {
            to.extend(from.next());
            if to.last() == Some(&1.0) {
                copy(value, from, to);
            }
        }
        _ => to.extend(from.next()),
    }
}

/// The class of a lab, with the TypeScript names of its partial parameters, its frame and its state:
/// `lab_class!("What it is.", Name: labs::Name, "Partial<Params>", "Frame", "LabState<Params>")`. What it is comes as plain
/// text: of a doc comment that has gone through a macro, wasm-bindgen writes the quotes too.
macro_rules! lab_class {
    ($doc:tt, $name:ident: $lab:ty, $partial:tt, $frame:tt, $state:tt) => {
        #[doc = $doc]
        #[wasm_bindgen]
        #[repr(transparent)]
        pub struct $name($crate::object::Held);

        impl $name {
            const CLASS: &'static $crate::lab::Class =
                &$crate::lab::Class { name: stringify!($name), kind: labs::Kind::of::<$lab>() };
        }

        #[wasm_bindgen]
        impl $name {
            /// The lab at step 0; what `params` leaves out takes its default.
            #[wasm_bindgen(constructor)]
            pub fn new(
                #[wasm_bindgen(unchecked_optional_param_type = $partial)] params: &JsValue,
            ) -> Result<$name, JsValue> {
                Self::CLASS.open(params).map(Self)
            }

            /// The lab in a state that `state()` answered.
            pub fn from(#[wasm_bindgen(unchecked_param_type = $state)] state: &JsValue) -> Result<$name, JsValue> {
                Self::CLASS.open_state(state).map(Self)
            }

            /// The parameters: how far each goes, in which steps, and its default.
            #[wasm_bindgen(unchecked_return_type = "Parameter[]")]
            pub fn parameters() -> JsValue {
                Self::CLASS.parameters()
            }

            /// The last step a run can reach.
            #[wasm_bindgen(js_name = lastStep)]
            pub fn last_step() -> u32 {
                labs::MAX_STEP
            }

            /// Changes the parameters given, and replays the run to the present step.
            pub fn set(
                &self,
                #[wasm_bindgen(unchecked_param_type = $partial)] params: &JsValue,
            ) -> Result<(), JsValue> {
                Self::CLASS.set(&self.0, params)
            }

            /// One step.
            pub fn step(&self) -> Result<(), JsValue> {
                Self::CLASS.advance(&self.0, 1)
            }

            /// `n` steps, at most to step 100 000.
            pub fn run(&self, #[wasm_bindgen(unchecked_param_type = "number")] n: &JsValue) -> Result<(), JsValue> {
                Self::CLASS.run(&self.0, n)
            }

            /// What there is to draw.
            #[wasm_bindgen(unchecked_return_type = $frame)]
            pub fn frame(&self) -> Result<JsValue, JsValue> {
                Self::CLASS.frame(&self.0)
            }

            /// Parameters and step: all it takes to find this lab again.
            #[wasm_bindgen(unchecked_return_type = $state)]
            pub fn state(&self) -> Result<JsValue, JsValue> {
                Self::CLASS.state(&self.0)
            }

            /// A hash of what the run has recorded at every step (truth, readings, estimates, covariances and their
            /// comparison), bit for bit, in hexadecimal.
            pub fn digest(&self) -> Result<String, JsValue> {
                Self::CLASS.digest(&self.0)
            }
        }
    };
}

lab_class! {
    "The rail robot of §8.2.6 under an observer whose gain the reader sets, or the filter does.",
    ObserverBench: labs::ObserverBench, "Partial<BenchParams>", "BenchFrame", "LabState<BenchParams>"
}

lab_class! {
    "A loop of the corridor on encoders with a biased wheel, with or without fixes from the mapped corners.",
    OdometryHook: labs::OdometryHook, "Partial<HookParams>", "HookFrame", "LabState<HookParams>"
}

lab_class! {
    "Rusty on a square in room A: which landmarks does it take to know where it is?",
    ObservabilityProbe: labs::ObservabilityProbe, "Partial<ProbeParams>", "ProbeFrame", "LabState<ProbeParams>"
}

lab_class! {
    "A prediction, the states that explain a reading, and the two ways of stepping onto them.",
    Picture: labs::Picture, "Partial<PictureParams>", "PictureFrame", "LabState<PictureParams>"
}

#[wasm_bindgen]
impl ObservabilityProbe {
    /// Where landmark `j` (from 0) must stand to be in line with the estimate and the nearest other landmark shown.
    #[wasm_bindgen(js_name = collinearPoint, unchecked_return_type = "Vector")]
    pub fn collinear_point(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] j: &JsValue,
    ) -> Result<JsValue, JsValue> {
        self.0.is(Self::CLASS.name)?;
        let j = Arg::new(j, "j").whole(0, 2).map_err(thrown)?;
        let point = self.0.read(Self::CLASS.name, |lab: &AnyLab| {
            let probe = lab.as_any().downcast_ref::<labs::ObservabilityProbe>();
            probe.map_or_else(|| Err(Error::new(Code::Type, "this", "is no Probe")), |probe| probe.collinear_point(j))
        })?;
        Ok(crate::encode::list(&point.map_err(thrown)?))
    }
}
