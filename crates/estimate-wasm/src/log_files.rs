//! The files of a log as others write them: added one by one, read as guessed or as corrected.

use crate::decode::Arg;
use crate::encode::record;
use crate::errors::Thrown;
use crate::object::Held;
use crate::robot_log::{DriveLog, text_of};
use estimate::{Code, Error};
use js_sys::Array;
use robot_log::{Counting, File, Files, Frame, Role, WHEEL_NUMBERS, units_of};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What a file of a log is. */
export type LogRole = "log" | "velocities" | "odometry" | "encoders" | "sensors" | "sightings" | "ranges" | "landmarks"
    | "truth" | "barcodes" | "undecided" | "unused";
/** A value that a file's role has. */
export interface LogValue {
    name: string;
    /** Whether a file may do without it. */
    optional: boolean;
    /** The column it is read from, counted from 0. */
    column: number | null;
    /** The unit it is read in: null where it has none, or where that has to be said. */
    unit: string | null;
    /** The units it may be in. */
    units: string[];
    /** Whether its column or its unit has to be said. */
    asked: boolean;
    /** Three values of its column, as they stand in the file. */
    samples: string[];
}
/** Ticks of a turn of the wheel, its radius and the distance between the wheels in m, and how the encoders count. */
export interface LogWheels {
    ticks: number | null;
    radius: number | null;
    base: number | null;
    counting: "total" | "step" | "restarted" | null;
}
/** The rows of several robots or tags in one file, which a column tells apart. */
export interface LogSeveral {
    /** The column, counted from 0. */
    column: number;
    /** What stands in it, and in how many rows. */
    values: { value: string; rows: number }[];
    /** Whose rows are read; null where all are, and where that is asked. */
    only: string | null;
    /** Whether it has to be said whose rows are read. */
    asked: boolean;
}
/** Where the origin of a truth lies: where the fixes' does, or elsewhere, and the truth is moved onto the first fix. */
export interface LogOrigin {
    /** Null where it has to be said. */
    said: "same" | "moved" | null;
}
/** How a file of a log is read. */
export interface LogFile {
    name: string;
    role: LogRole;
    /** What its columns are called; empty of a log in the book's own format. */
    header: string[];
    values: LogValue[];
    /** What encoders need besides; null of another file. */
    wheels: LogWheels | null;
    /** The rows of several robots; null where no column tells such apart. */
    several: LogSeveral | null;
    /** Where the origin of a truth lies that counts its places from another point than the fixes do; null of a file
        that is not asked. */
    frame: LogOrigin | null;
    /** What has to be said before the file can be read: a guess that is not certain chooses nothing. */
    asks: string[];
    /** What follows from how it is read, in words, such as "20 Hz, 0 to 120 s, turned 2 turns". */
    follows: string;
}
"#;

/// The files of one log. A file that is added is guessed to be in the book's own format, or a table whose columns have
/// names: the five files of a UTIAS MRCLAM data set are such tables.
#[wasm_bindgen]
#[repr(transparent)]
pub struct LogFiles(Held);

const FILES: &str = "LogFiles";
const COUNTINGS: [(&str, Counting); 3] =
    [("total", Counting::Total), ("step", Counting::Step), ("restarted", Counting::Restarted)];
const FRAMES: [(&str, Frame); 2] = [("same", Frame::Same), ("moved", Frame::Moved)];
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

    /// Reads a value in another unit.
    #[wasm_bindgen(js_name = setUnit)]
    pub fn set_unit(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "string")] value: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "string")] unit: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let value = Arg::new(value, "value").text()?;
        let unit = Arg::new(unit, "unit").text()?;
        self.change(file, "unit", |files, file| files.set_unit(file, &value, &unit))
    }

    /// Reads only the rows of one of several robots, by what stands in the column that tells them apart, or of all, by
    /// null.
    #[wasm_bindgen(js_name = setOnly)]
    pub fn set_only(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "string | null")] only: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let only = Arg::new(only, "only");
        let only = if only.is_null() { None } else { Some(only.text()?) };
        self.change(file, "only", |files, file| files.set_only(file, only.as_deref()))
    }

    /// Says where the origin of a truth lies, of which that is asked.
    #[wasm_bindgen(js_name = setFrame)]
    pub fn set_frame(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "'same' | 'moved'")] frame: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let (_, frame) = FRAMES[Arg::new(frame, "frame").word(&FRAMES.map(|(name, _)| name))?];
        self.change(file, "file", |files, file| files.set_frame(file, frame))
    }

    /// Says a number of encoders, above 0: `"ticks"` of a turn of the wheel, its `"radius"` or the wheels' `"base"`, m.
    #[wasm_bindgen(js_name = setWheel)]
    pub fn set_wheel(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "'ticks' | 'radius' | 'base'")] name: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] number: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let name = WHEEL_NUMBERS[Arg::new(name, "name").word(&WHEEL_NUMBERS)?];
        let number = Arg::new(number, "number").number()?;
        if number <= 0.0 {
            return Err(Error::new(Code::Limit, "number", "must be above 0").into());
        }
        self.change(file, "file", |files, file| files.set_wheel(file, name, number))
    }

    /// Says whether encoders count on, or anew from row to row, or count on and begin anew where they jump.
    #[wasm_bindgen(js_name = setCounting)]
    pub fn set_counting(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "'total' | 'step' | 'restarted'")] counting: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let (_, counting) = COUNTINGS[Arg::new(counting, "counting").word(&COUNTINGS.map(|(name, _)| name))?];
        self.change(file, "file", |files, file| files.set_counting(file, counting))
    }

    /// The log that the files make. What is no log throws a `LogError`, which says in which file, line and column.
    #[wasm_bindgen(unchecked_return_type = "DriveLog")]
    pub fn read(&self) -> Result<DriveLog, Thrown> {
        let read = self.0.read(FILES, |files: &Files| files.read())??;
        Ok(DriveLog::keep(read.log, read.notes, read.landmarks, read.wheels))
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

fn texts<T: AsRef<str>>(all: impl IntoIterator<Item = T>) -> JsValue {
    all.into_iter().map(|text| JsValue::from_str(text.as_ref())).collect::<Array>().into()
}

/// The rows of several robots in a file.
fn several(file: &File) -> JsValue {
    let Some((column, values)) = file.several() else { return JsValue::NULL };
    let each = values.iter().map(|(value, rows)| record(&[("value", value.into()), ("rows", (*rows as f64).into())]));
    record(&[
        ("column", (column as u32).into()),
        ("values", each.collect::<Array>().into()),
        ("only", file.only().flatten().map_or(JsValue::NULL, Into::into)),
        ("asked", file.only().is_none().into()),
    ])
}

/// Where the origin of a truth lies.
fn origin(file: &File) -> JsValue {
    let said = FRAMES.iter().find(|(_, frame)| file.frame() == Some(*frame)).map(|(name, _)| *name);
    let record = || record(&[("said", said.map_or(JsValue::NULL, Into::into))]);
    if file.is_foreign() { record() } else { JsValue::NULL }
}

fn shown(file: &File) -> JsValue {
    let columns = file.columns().iter().zip(file.units());
    let values = file.role().values().iter().zip(columns).enumerate().map(|(i, (value, (column, unit)))| {
        record(&[
            ("name", value.name.into()),
            ("optional", value.optional.into()),
            ("column", column.map_or(JsValue::NULL, |column| (column as u32).into())),
            ("unit", unit.map_or(JsValue::NULL, |unit| unit.name.into())),
            ("units", texts(units_of(value.quantity).iter().map(|unit| unit.name))),
            ("asked", file.is_asked(i).into()),
            ("samples", texts(column.map_or(Vec::new(), |column| file.samples(column)))),
        ])
    });
    let wheels = || {
        let said = |counting| COUNTINGS.iter().find(|(_, it)| *it == counting).map(|(name, _)| *name);
        let counting = file.wheels().counting.and_then(said);
        let numbers = WHEEL_NUMBERS.map(|name| (name, file.wheels().number(name).map_or(JsValue::NULL, Into::into)));
        let [ticks, radius, base] = numbers;
        record(&[ticks, radius, base, ("counting", counting.map_or(JsValue::NULL, Into::into))])
    };
    record(&[
        ("name", file.name().into()),
        ("role", file.role().name().into()),
        ("header", texts(file.header())),
        ("values", values.collect::<Array>().into()),
        ("several", several(file)),
        ("wheels", if file.role() == Role::Encoders { wheels() } else { JsValue::NULL }),
        ("frame", origin(file)),
        ("asks", texts(file.asks())),
        ("follows", file.follows().into()),
    ])
}
