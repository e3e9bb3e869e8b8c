//! A filter as lines of formulas.

use crate::arguments::{belief_of, system_of};
use crate::decode::Arg;
use crate::encode::{list, record, rows};
use crate::errors::Thrown;
use crate::object::Held;
use estimate::dynamic::Belief;
use estimate::{Code, Error, validate};
use js_sys::Array;
use nalgebra::{DMatrix, DVector};
use program::{Fault, Matrix, Notation, Program as Text, Step, Stop, Trouble, World};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("program.d.ts");

/// A filter that its reader has written: lines `name = formula` in the letters of a notation. It is checked whole when
/// it is made; each step then takes what the world gives, and nothing is kept from one step to the next.
#[wasm_bindgen]
#[repr(transparent)]
pub struct Program(Held);

const CLASS: &str = "Program";

#[wasm_bindgen]
impl Program {
    /// Reads a program. A text with faults makes one all the same: `faults` lists them, and no step is made.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "ProgramOptions")] options: &JsValue,
    ) -> Result<Program, Thrown> {
        let text = Arg::new(text, "text").text_of(program::MOST_TEXT)?;
        let (mut notation, mut world) = (Notation::Choset, World::Linear);
        let options = Arg::new(options, "options");
        if !options.is_undefined() {
            options.only(["notation", "world"].into_iter())?;
            let notations = [Notation::Choset, Notation::Thrun, Notation::Common];
            let read = |it: &Arg<'_>| Ok(notations[it.word(&["choset", "thrun", "common"])?]);
            options.given("notation", read, &mut notation)?;
            let read = |it: &Arg<'_>| Ok([World::Linear, World::Robot][it.word(&["linear", "robot"])?]);
            options.given("world", read, &mut world)?;
        }
        Ok(Self(Held::new(CLASS, Text::new(&text, world, notation))))
    }

    /// What is wrong with it, in the order of the text.
    #[wasm_bindgen(getter, unchecked_return_type = "ProgramFault[]")]
    pub fn faults(&self) -> Result<JsValue, Thrown> {
        self.0.read(CLASS, |program: &Text| program.faults().iter().map(shown).collect::<Array>().into())
    }

    /// One step from a belief, with the input `u` and the reading `y`.
    #[wasm_bindgen(unchecked_return_type = "ProgramStep")]
    pub fn step(
        &self,
        #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem | RobotSystem")] system: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Belief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Vector")] u: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Vector")] y: &JsValue,
    ) -> Result<JsValue, Thrown> {
        let world = self.0.read(CLASS, Text::world)?;
        let belief = belief_of(&Arg::new(belief, "belief"))?;
        let given = match world {
            World::Linear => {
                let system = system_of(system)?;
                let [n, p, m] = [system.f.nrows(), system.h.nrows(), system.g.ncols()];
                let (belief, u, y) = common(&belief, u, y, [n, p, m])?;
                let rest = [&system.v, &system.w, &system.f, &system.g, &system.h].map(matrix);
                belief.into_iter().chain([u, y]).chain(rest).collect::<Vec<_>>()
            }
            World::Robot => {
                let arg = Arg::new(system, "system");
                arg.only(["V", "W", "landmark", "gate"].into_iter())?;
                let within = |e: Error| e.within("system");
                let v = validate::covariance(arg.field("V")?.matrix()?, 3, "V").map_err(within)?;
                let w = validate::covariance(arg.field("W")?.matrix()?, 2, "W").map_err(within)?;
                let mark = validate::vector(arg.field("landmark")?.vector()?, 2, "landmark").map_err(within)?;
                let gate = arg.field("gate")?;
                let gate = if gate.is_undefined() { 1e12 } else { gate.number()? };
                let gate = validate::finite(gate, "gate").map_err(within)?;
                let (belief, u, y) = common(&belief, u, y, [3, 2, 2])?;
                let rest = [matrix(&v), matrix(&w), Matrix::column(mark.as_slice()), Matrix::column(&[gate])];
                belief.into_iter().chain([u, y]).chain(rest).collect()
            }
        };
        self.0.write(CLASS, |program: &mut Text| match program.step(&given) {
            Ok(step) => Ok(answer(program, &step)),
            Err(stop) => Err(refused(stop)),
        })
    }
}

fn matrix(m: &DMatrix<f64>) -> Matrix {
    Matrix::new(m.nrows(), m.ncols(), m.transpose().as_slice().to_vec())
}

/// x, P, u and y of their sizes.
fn common(
    belief: &Belief,
    u: &JsValue,
    y: &JsValue,
    [n, p, m]: [usize; 3],
) -> Result<([Matrix; 2], Matrix, Matrix), Error> {
    if belief.x.len() != n {
        return Err(Error::new(Code::Shape, "belief", "is not of the system’s size"));
    }
    let vector = |value, name, length| -> Result<DVector<f64>, Error> {
        validate::vector(Arg::new(value, name).vector()?, length, name)
    };
    let (u, y) = (vector(u, "u", m)?, vector(y, "y", p)?);
    let column = |v: &DVector<f64>| Matrix::column(v.as_slice());
    Ok(([column(&belief.x), matrix(&belief.p)], column(&u), column(&y)))
}

fn shown(fault: &Fault) -> JsValue {
    record(&[
        ("line", fault.line.into()),
        ("column", fault.column.into()),
        ("length", fault.length.into()),
        ("message", fault.message.as_str().into()),
    ])
}

fn by_rows(m: &Matrix) -> JsValue {
    rows(&DMatrix::from_row_slice(m.rows, m.columns, &m.entries))
}

fn answer(program: &Text, step: &Step) -> JsValue {
    let maybe = |m: &Option<Matrix>| m.as_ref().map_or(JsValue::NULL, by_rows);
    let line = |made: &program::Made| {
        record(&[
            ("line", made.line.into()),
            ("name", program.name(made).into()),
            ("value", by_rows(&made.value)),
        ])
    };
    record(&[
        ("x", list(&step.x.entries)),
        ("P", by_rows(&step.p)),
        ("innovation", step.innovation.as_ref().map_or(JsValue::NULL, |nu| list(&nu.entries))),
        ("S", maybe(&step.s)),
        ("R", maybe(&step.gain)),
        ("lines", step.made.iter().map(line).collect::<Array>().into()),
    ])
}

/// What a step that was not made says: where, and why.
fn refused(stop: Stop) -> Error {
    let (code, fault) = match stop {
        Stop::Given => return Error::new(Code::Shape, "system", "does not fit the belief"),
        Stop::Fault(fault) => (Code::Shape, fault),
        Stop::Trouble(Trouble::NotFinite, fault) => (Code::NotFinite, fault),
        Stop::Trouble(_, fault) => (Code::NotPositiveSemidefinite, fault),
    };
    let mut message = program::words::Words::new("has a fault in line ");
    message.whole(i64::from(fault.line)).text(": ").text(&fault.message);
    Error::new(code, "program", message.0)
}
