//! A filter as lines of formulas.

use crate::arguments::{belief_of, system_of};
use crate::decode::Arg;
#[cfg(feature = "functions")]
use crate::encode::rows;
use crate::encode::{Arrays, list, record};
use crate::errors::Thrown;
use crate::object::Held;
use estimate::{Code, Error, validate};
use js_sys::Array;
use nalgebra::DMatrix;
#[cfg(feature = "functions")]
use program::judge::{Outcome, Verdict, judge};
use program::{Fault, Formula, Matrix, Notation, Program as Text, Quantity, Statement, Step, Stop, Trouble, World};
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
        self.0.read(CLASS, |program: &Text| {
            let all = Array::new();
            for fault in program.faults() {
                all.push(&shown(fault));
            }
            all.into()
        })
    }

    /// What each quantity is called in its letters.
    #[wasm_bindgen(getter, unchecked_return_type = "ProgramLetters")]
    pub fn letters(&self) -> Result<JsValue, Thrown> {
        self.0.read(CLASS, |program: &Text| record(&LETTERS.map(|(name, it)| (name, program.letter(it).into()))))
    }

    /// Its lines as trees, for who writes them in another notation or language. With the `sizes` n, p and m of a system
    /// each part of a formula has its rows and columns.
    #[wasm_bindgen(unchecked_return_type = "ProgramStatement[]")]
    pub fn tree(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "[number, number, number]")] sizes: &JsValue,
    ) -> Result<JsValue, Thrown> {
        let arg = Arg::new(sizes, "sizes");
        let sizes = if arg.is_undefined() { None } else { Some(sizes_of(&arg)?) };
        let lines = self.0.read(CLASS, |program: &Text| program.tree(sizes))?;
        let all = Array::new();
        for line in lines.map_err(|fault| refused(Stop::Fault(fault)))? {
            all.push(&statement(&line));
        }
        Ok(all.into())
    }

    /// One step from a belief, with the input `u` and the reading `y`.
    #[wasm_bindgen(unchecked_return_type = "ProgramStep")]
    pub fn step(
        &self,
        #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem | RobotSystem")] system: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] u: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] y: &JsValue,
    ) -> Result<JsValue, Thrown> {
        self.stepped(system, belief, u, y, answer)
    }

    fn stepped(
        &self,
        system: &JsValue,
        belief: &JsValue,
        u: &JsValue,
        y: &JsValue,
        answer: fn(&Text, &Step) -> JsValue,
    ) -> Result<JsValue, Thrown> {
        let world = self.0.read(CLASS, Text::world)?;
        let belief = belief_of(&Arg::new(belief, "belief"))?;
        let mut given = vec![Matrix::column(belief.x.as_slice()), matrix(&belief.p)];
        let arg = Arg::new(system, "system");
        let within = |e: Error| e.within("system");
        match world {
            World::Linear => {
                let system = system_of(system)?;
                given.push(column(u, "u", system.g.ncols())?);
                given.push(column(y, "y", system.h.nrows())?);
                for m in [&system.v, &system.w, &system.f, &system.g, &system.h] {
                    given.push(matrix(m));
                }
            }
            World::Robot => {
                arg.only(["V", "W", "landmark", "gate"].into_iter())?;
                given.push(column(u, "u", 2)?);
                given.push(column(y, "y", 2)?);
                for (name, n) in [("V", 3), ("W", 2)] {
                    given.push(matrix(&validate::covariance(arg.field(name)?.matrix()?, n, name).map_err(within)?));
                }
                let mark = validate::vector(arg.field("landmark")?.vector()?, 2, "landmark").map_err(within)?;
                given.push(Matrix::column(mark.as_slice()));
                let gate = arg.field("gate")?;
                let gate = if gate.is_undefined() { OPEN } else { gate.number()? };
                given.push(Matrix::column(&[validate::finite(gate, "gate").map_err(within)?]));
            }
        }
        self.0.write(CLASS, |program: &mut Text| match program.step(given) {
            Ok(step) => Ok(answer(program, &step)),
            Err(stop) => Err(refused(stop)),
        })
    }
}

/// What a program of the package can do beside that, and the figure's lab does by itself.
#[cfg(feature = "functions")]
#[wasm_bindgen]
impl Program {
    /// Whether it is a right filter: one step beside a right filter's on a dozen cases, and beside what bugs that real
    /// code has had make of the same cases. Any form is right that gives the same numbers.
    #[wasm_bindgen(unchecked_return_type = "ProgramVerdict")]
    pub fn judge(&self) -> Result<JsValue, Thrown> {
        self.0.read(CLASS, |program: &Text| verdict(&judge(program)))
    }

    /// What each line makes in this step, in the order of the text.
    #[wasm_bindgen(unchecked_return_type = "ProgramLine[]")]
    pub fn lines(
        &self,
        #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem | RobotSystem")] system: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] u: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] y: &JsValue,
    ) -> Result<JsValue, Thrown> {
        self.stepped(system, belief, u, y, lines)
    }
}

/// The quantities by their names in a system and in an answer.
const LETTERS: [(&str, Quantity); 12] = [
    ("x", Quantity::X),
    ("P", Quantity::P),
    ("u", Quantity::U),
    ("y", Quantity::Y),
    ("V", Quantity::V),
    ("W", Quantity::W),
    ("F", Quantity::F),
    ("G", Quantity::G),
    ("H", Quantity::H),
    ("innovation", Quantity::Innovation),
    ("S", Quantity::S),
    ("R", Quantity::Gain),
];

/// A gate that refuses nothing.
const OPEN: f64 = 1e12;

fn column(value: &JsValue, name: &'static str, length: usize) -> Result<Matrix, Error> {
    Ok(Matrix::column(validate::vector(Arg::new(value, name).vector()?, length, name)?.as_slice()))
}

/// n, p and m.
fn sizes_of(arg: &Arg<'_>) -> Result<[usize; 3], Error> {
    let given = validate::vector(arg.vector()?, 3, "sizes")?;
    let mut sizes = [0; 3];
    for (size, given) in sizes.iter_mut().zip(given.iter()) {
        if *given != given.trunc() || !(0.0..=16.0).contains(given) {
            return Err(Error::new(Code::Shape, "sizes", "holds whole numbers of at most 16: n, p and m"));
        }
        *size = *given as usize;
    }
    Ok(sizes)
}

fn formula(it: &Formula) -> JsValue {
    let parts = Array::new();
    for part in &it.parts {
        parts.push(&formula(part));
    }
    record(&[
        ("word", it.word.into()),
        ("number", it.number.into()),
        ("name", it.name.as_str().into()),
        ("sides", it.sides.map_or(JsValue::NULL, |sides| list(&sides.map(|side| side as f64)))),
        ("parts", parts.into()),
    ])
}

fn statement(it: &Statement) -> JsValue {
    record(&[
        ("name", it.name.as_str().into()),
        ("part", it.part.as_ref().map_or(JsValue::NULL, formula)),
        ("value", formula(&it.value)),
        ("lines", list(&it.lines.map(f64::from))),
    ])
}

fn matrix(m: &DMatrix<f64>) -> Matrix {
    Matrix::new(m.nrows(), m.ncols(), m.transpose().data.into())
}

/// What is said of a program.
#[cfg(feature = "functions")]
fn verdict(verdict: &Verdict) -> JsValue {
    let (outcome, bug) = match verdict.outcome {
        Outcome::Refused => ("refused", None),
        Outcome::Right => ("right", None),
        Outcome::Bug(bug) => ("bug", Some(bug.word())),
        Outcome::Unfinished => ("unfinished", None),
        Outcome::Wrong => ("wrong", None),
    };
    let sentences = Array::new();
    for sentence in &verdict.sentences {
        sentences.push(&sentence.as_str().into());
    }
    record(&[
        ("outcome", outcome.into()),
        ("bug", bug.map_or(JsValue::NULL, JsValue::from_str)),
        ("line", verdict.line.map_or(JsValue::NULL, JsValue::from)),
        ("sentences", sentences.into()),
    ])
}

fn shown(fault: &Fault) -> JsValue {
    record(&[
        ("line", fault.line.into()),
        ("column", fault.column.into()),
        ("length", fault.length.into()),
        ("message", fault.message.as_str().into()),
    ])
}

#[cfg(feature = "functions")]
fn by_rows(m: &Matrix) -> JsValue {
    rows(&DMatrix::from_row_slice(m.rows, m.columns, &m.entries))
}

fn answer(program: &Text, step: &Step) -> JsValue {
    let mut arrays = Arrays::default();
    for quantity in [Quantity::X, Quantity::P, Quantity::Innovation, Quantity::S, Quantity::Gain] {
        arrays = match program.made(step, quantity) {
            None => arrays.nothing(),
            Some(m) if matches!(quantity, Quantity::X | Quantity::Innovation) => arrays.vector(&m.entries),
            Some(m) => arrays.rows([m.rows, m.columns], &m.entries),
        };
    }
    let object = record(&[]);
    arrays.put(&object, &["x", "P", "innovation", "S", "R"]);
    object
}

#[cfg(feature = "functions")]
fn lines(program: &Text, step: &Step) -> JsValue {
    let lines = Array::new();
    for made in &step.made {
        let fields =
            [("line", made.line.into()), ("name", program.name(made).into()), ("value", by_rows(made.value()))];
        lines.push(&record(&fields));
    }
    lines.into()
}

/// What a step that was not made says: where, and why.
fn refused(stop: Stop) -> Error {
    let (code, fault) = match stop {
        Stop::Given => return Error::new(Code::Shape, "system", "does not fit the belief, the input or the reading"),
        Stop::Fault(fault) => (Code::Shape, fault),
        Stop::Trouble(Trouble::NotFinite, fault) => (Code::NotFinite, fault),
        Stop::Trouble(_, fault) => (Code::NotPositiveSemidefinite, fault),
    };
    let mut message = program::words::Words::new("has a fault in line ");
    message.whole(i64::from(fault.line)).text(": ").text(&fault.message);
    Error::new(code, "program", message.0)
}
