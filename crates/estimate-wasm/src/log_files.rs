//! The files of a log as others write them: added one by one, read as guessed or as corrected.

use crate::decode::Arg;
use crate::errors::Thrown;
use crate::log_file::{COUNTINGS, FRAMES, shown};
use crate::object::Held;
use crate::robot_log::{DriveLog, text_of};
use estimate::{Code, Error};
use js_sys::Array;
use robot_log::{Files, MAX_TIME, Role, WHEEL_NUMBERS};
use wasm_bindgen::prelude::*;

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
        self.0.write(FILES, |files: &mut Files| {
            files.compare();
            Ok::<_, Error>((0..files.files().len()).map(|at| shown(files, at)).collect::<Array>().into())
        })
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

    /// Says which frame a truth is in, of which that is asked.
    #[wasm_bindgen(js_name = setFrame)]
    pub fn set_frame(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "'same' | 'moved' | 'own'")] frame: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let (_, frame) = FRAMES[Arg::new(frame, "frame").word(&FRAMES.map(|(name, _)| name))?];
        self.change(file, "file", |files, file| files.set_frame(file, frame))
    }

    /// Says at which latitude and longitude, in degrees, the origin of places in metres lies beside others in degrees.
    #[wasm_bindgen(js_name = setOrigin)]
    pub fn set_origin(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] latitude: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] longitude: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let [latitude, longitude] =
            [Arg::new(latitude, "latitude").number()?, Arg::new(longitude, "longitude").number()?];
        self.change(file, "origin", |files, file| files.set_origin(file, latitude, longitude))
    }

    /// Says how many seconds are added to the times of a file that has not the log's own clock.
    #[wasm_bindgen(js_name = setClockShift)]
    pub fn set_clock_shift(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] file: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] seconds: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let seconds = Arg::new(seconds, "seconds").number()?;
        if seconds.is_nan() || seconds.abs() > MAX_TIME {
            return Err(Error::new(Code::Limit, "seconds", "is no number, or longer than times of a log may be").into());
        }
        self.change(file, "file", |files, file| files.set_clock_shift(file, seconds))
    }

    /// Reads the log otherwise than its files have it: `driven` is how many times distances or speeds, and turns or
    /// turn rates, are taken as they are read, both above 0, `landmarks` lists id, x and y of each landmark that
    /// stands elsewhere, and `ranges`, which may be left out, id and by how much ranges to it are taken shorter, m;
    /// `kept`, which may be left out too, is from when to when the log is read, s since the first row of its files, and
    /// so may `swerve`, by how much more to its left the robot turns on each metre than is read, rad.
    pub fn correct(
        &self,
        #[wasm_bindgen(unchecked_param_type = "[number, number]")] driven: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "[number, number, number][]")] landmarks: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "[number, number][]")] ranges: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "[number, number] | null")] kept: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] swerve: &JsValue,
    ) -> Result<(), Thrown> {
        self.0.is(FILES)?;
        let corrections = crate::log_corrections::read(driven, landmarks, ranges, kept, swerve)?;
        self.0.write(FILES, |files: &mut Files| {
            let message = "has a factor that is not above 0";
            if files.correct(corrections) { Ok(()) } else { Err(Error::new(Code::Limit, "driven", message)) }
        })
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
        let read = self.0.write(FILES, |files: &mut Files| {
            files.compare();
            Ok::<_, Error>(files.read())
        })??;
        Ok(DriveLog::keep(read))
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
