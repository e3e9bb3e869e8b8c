//! A log and its replay as tables, for a reader who takes the numbers away.

use crate::decode::Arg;
use crate::errors::Thrown;
use crate::lab::RobotLog;
use crate::object::Held;
use crate::robot_log::logged;
use lab::{Lab, Params};
use labs::LogTableKind;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// A log's replay that is written as CSV while it goes on: `"track"` has the estimate at each row of motion, before
/// the readings of its time, `"innovations"` what the filter made of each reading, and the estimate after it. `"log"`
/// is the log itself in the book's own format, whatever it was read from: read again it is the same log to the bit.
/// Lengths are in metres, times in seconds by the log's own clock, angles in radians.
#[wasm_bindgen]
#[repr(transparent)]
pub struct LogTable(Held);

const TABLE: &str = "LogTable";

#[wasm_bindgen]
impl LogTable {
    /// The table before its first row; what `params` leaves out takes its default.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "DriveLog")] log: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Partial<LogParams>")] params: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "'track' | 'innovations' | 'log'")] kind: &JsValue,
    ) -> Result<LogTable, Thrown> {
        let log = logged(log)?;
        let params = RobotLog::params(params)?;
        let kind = Arg::new(kind, "kind").word(&["track", "innovations", "log"])?;
        let kind = [LogTableKind::Track, LogTableKind::Innovations, LogTableKind::Log][kind];
        let table = labs::LogTable::new(Arc::clone(&log), Params::read(&mut params.iter()), kind);
        Ok(Self(Held::new(TABLE, table.map_err(|e| e.within("params"))?)))
    }

    /// What the next `n` rows of the log add to the table, before the first of them its header; undefined behind the
    /// last.
    pub fn next(&self, #[wasm_bindgen(unchecked_param_type = "number")] n: &JsValue) -> Result<Option<String>, Thrown> {
        self.0.is(TABLE)?;
        let n = Arg::new(n, "n").whole(1, labs::RobotLog::LAST_STEP)?;
        self.0.write(TABLE, |table: &mut labs::LogTable| table.next(n))
    }
}
