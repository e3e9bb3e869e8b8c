//! What the lab of a reader's filter can do beside the rest, and the many worlds that a worker counts.

use super::WriteFilter;
use crate::decode::Arg;
use crate::encode::Row;
use crate::errors::Thrown;
use crate::object::Held;
use estimate::{Code, Error};
use lab::Plain;
use labs::worlds::Worlds;
use labs::{Letters, WriteWorld, WriteWorlds};
use program::Stop;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface WriteFilter {
    /** The program's text in the letters of a notation: only names change. */
    textIn(notation: "choset" | "thrun" | "common"): string;
    /** The first ten steps of the run's world, on which the program is tested in another language. */
    world(): WriteWorld;
    /** The program in the worlds of 500 seeds, none of which has been run yet. */
    worlds(): FilterWorlds;
}
"#;

#[wasm_bindgen]
impl WriteFilter {
    /// The text in other letters, as its type says.
    #[wasm_bindgen(js_name = textIn)]
    pub fn text_in(&self, notation: &JsValue) -> Result<String, Thrown> {
        self.0.is(Self::CLASS.name)?;
        let letters = [Letters::Choset, Letters::Thrun, Letters::Common];
        let letters = letters[Arg::new(notation, "notation").word(&["choset", "thrun", "common"])?];
        Self::CLASS.lab(&self.0, |lab: &labs::WriteFilter| Ok(lab.text_in(letters)))
    }

    /// The first steps of the run's world, as its type says.
    pub fn world(&self) -> Result<JsValue, Thrown> {
        let world = Self::CLASS.lab(&self.0, labs::WriteFilter::world)?;
        let mut numbers = Vec::new();
        world.write(&mut numbers);
        Ok(Row::new(&numbers).value(&<WriteWorld as Plain>::SHAPE))
    }

    /// The program in many worlds, as its type says.
    pub fn worlds(&self) -> Result<FilterWorlds, Thrown> {
        let worlds = Self::CLASS.lab(&self.0, |lab: &labs::WriteFilter| Ok(lab.worlds()))?;
        Ok(FilterWorlds(Held::new(WORLDS, worlds)))
    }
}

/// A program in the worlds of 500 seeds, which a worker counts one by one.
#[wasm_bindgen]
#[repr(transparent)]
pub struct FilterWorlds(Held);

const WORLDS: &str = "FilterWorlds";

#[wasm_bindgen]
impl FilterWorlds {
    /// No world yet, of the program that the parameters say; what they leave out takes its default.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Partial<WriteParams>")] params: &JsValue,
    ) -> Result<FilterWorlds, Thrown> {
        WriteFilter::new(params)?.worlds()
    }

    /// Runs the program in the next world; whether there is another.
    pub fn step(&self) -> Result<bool, Thrown> {
        self.0.write(WORLDS, |worlds: &mut Worlds| {
            let next = if worlds.is_done() { Ok(()) } else { worlds.next_world() };
            next.map(|()| !worlds.is_done()).map_err(stopped)
        })
    }

    /// What the worlds so far say.
    #[wasm_bindgen(unchecked_return_type = "WriteWorlds")]
    pub fn found(&self) -> Result<JsValue, Thrown> {
        let found = self.0.read(WORLDS, |worlds: &Worlds| WriteWorlds::of(worlds))??;
        let mut numbers = Vec::new();
        found.write(&mut numbers);
        Ok(Row::new(&numbers).value(&<WriteWorlds as Plain>::SHAPE))
    }
}

/// Why a world was not run to its end.
fn stopped(stop: Stop) -> Error {
    match stop {
        Stop::Fault(fault) | Stop::Trouble(_, fault) => {
            let mut words = program::words::Words::new("has a fault in line ");
            words.whole(i64::from(fault.line)).text(": ").text(&fault.message);
            Error::new(Code::NotFinite, "program", words.0)
        }
        Stop::Given => Error::new(Code::Shape, "program", "makes no estimate and no covariance of the world's size"),
    }
}
