//! The files of a log as others write them: added one by one, read as guessed or as corrected.

use crate::decode::Arg;
use crate::encode::record;
use crate::errors::Thrown;
use crate::object::Held;
use crate::robot_log::{DriveLog, text_of};
use estimate::{Code, Error};
use js_sys::Array;
use robot_log::{File, Files, Role};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What a file of a log is. */
export type LogRole = "log" | "velocities" | "odometry" | "sightings" | "landmarks" | "truth" | "barcodes" | "unused";
/** A unit of time, of length or of angles. */
export type LogUnit = "s" | "ms" | "us" | "ns" | "m" | "cm" | "mm" | "rad" | "deg";
/** How a file of a log is read. */
export interface LogFile {
    name: string;
    role: LogRole;
    /** What its columns are called; empty of a log in the book's own format. */
    header: string[];
    /** Each value of its role, whether a file may do without it, and the column it is read from, counted from 0. */
    values: { name: string; optional: boolean; column: number | null }[];
    /** The units of its numbers. */
    time: LogUnit;
    length: LogUnit;
    angle: LogUnit;
}
"#;

/// The files of one log. A file that is added is guessed to be in the book's own format, or a table whose columns have
/// names: the five files of a UTIAS MRCLAM data set are such tables.
#[wasm_bindgen]
#[repr(transparent)]
pub struct LogFiles(Held);

const FILES: &str = "LogFiles";
/// The most files, rows of a header, or columns that an index may count.
const MOST: u32 = 10_000;

#[wasm_bindgen]
impl LogFiles {
    /// No file yet.
    #[wasm_bindgen(constructor)]
    #[allow(clippy::new_without_default)]
    pub fn new() -> LogFiles {
        Self(Held::new(FILES, Files::default()))
    }

    /// Adds a file, and guesses how it is read. More than 16 files, or 64 MB of text, throw a `LogError`.
    pub fn add(
        &self,
        #[wasm_bindgen(unchecked_param_type = "string")] name: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let name = Arg::new(name, "name").text()?;
        let text = text_of(text)?;
        Ok(self.0.write(FILES, |files: &mut Files| Ok::<_, Error>(files.add(&name, &text)))??)
    }

    /// The files and how each is read.
    #[wasm_bindgen(unchecked_return_type = "LogFile[]")]
    pub fn files(&self) -> Result<JsValue, Thrown> {
        self.0.read(FILES, |files: &Files| files.files().iter().map(shown).collect::<Array>().into())
    }

    /// Reads a file as another role; its columns are guessed anew.
    #[wasm_bindgen(js_name = setRole)]
    pub fn set_role(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "LogRole")] role: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let role = Arg::new(role, "role").word(&Role::ALL.map(|(_, name)| name))?;
        self.change(file, "role", |files, file| files.set_role(file, Role::ALL[role].0))
    }

    /// Reads a value from another column, or from none.
    #[wasm_bindgen(js_name = setColumn)]
    pub fn set_column(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "string")] value: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number | null")] column: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let value = Arg::new(value, "value").text()?;
        let column = Arg::new(column, "column");
        let column = if column.is_null() { None } else { Some(column.whole(0, MOST)? as usize) };
        self.change(file, "column", |files, file| files.set_column(file, &value, column))
    }

    /// Reads a file in another unit of time, length or angles.
    #[wasm_bindgen(js_name = setUnit)]
    pub fn set_unit(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "LogUnit")] unit: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let unit = Arg::new(unit, "unit").text()?;
        self.change(file, "unit", |files, file| files.set_unit(file, &unit))
    }

    /// The log that the files make. What is no log throws a `LogError`, which says in which file, line and column.
    #[wasm_bindgen(unchecked_return_type = "DriveLog")]
    pub fn read(&self) -> Result<DriveLog, Thrown> {
        let read = self.0.read(FILES, |files: &Files| files.read())??;
        Ok(DriveLog::keep(read.log, read.notes))
    }

    /// Changes how a file is read; what there is not is refused in the name of `argument`.
    fn change(
        &self,
        file: &JsValue,
        argument: &'static str,
        f: impl FnOnce(&mut Files, usize) -> bool,
    ) -> Result<(), Thrown> {
        let file = Arg::new(file, "file").whole(0, MOST)? as usize;
        self.0.write(FILES, |files: &mut Files| {
            if f(files, file) { Ok(()) } else { Err(Error::new(Code::Index, argument, "is not there in this file")) }
        })
    }
}

fn shown(file: &File) -> JsValue {
    let values = file.role().values().iter().zip(file.columns()).map(|(value, column)| {
        record(&[
            ("name", value.name.into()),
            ("optional", value.optional.into()),
            ("column", column.map_or(JsValue::NULL, |column| (column as u32).into())),
        ])
    });
    record(&[
        ("name", file.name().into()),
        ("role", file.role().name().into()),
        ("header", file.header().iter().map(|name| JsValue::from_str(name)).collect::<Array>().into()),
        ("values", values.collect::<Array>().into()),
        ("time", file.units().time.into()),
        ("length", file.units().length.into()),
        ("angle", file.units().angle.into()),
    ])
}
