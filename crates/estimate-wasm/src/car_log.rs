//! The car's log: replayed whole under each of its settings.

use crate::decode::Arg;
use crate::errors::Thrown;
use crate::lab::{AnyLab, CarLog};
use crate::robot_log::{DriveLog, logged, text_of};
use estimate::Error;
use labs::LoggedDrive;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export namespace CarLog {
    /** Reads a log, as `RobotLog.parse` does. */
    function parse(text: string): DriveLog;
}
export interface CarLog {
    /** The log-likelihood of the fixes with the speed late by `delay` seconds, all else as it is. */
    likelihood(delay: number): number;
}
"#;

#[wasm_bindgen]
impl CarLog {
    /// Reads a log. What is no log throws a `LogError`, which says in which line and column.
    pub fn parse(text: &JsValue) -> Result<DriveLog, Thrown> {
        let text = text_of(text)?;
        Ok(DriveLog::keep(robot_log::parse(&text)?.into()))
    }

    /// The log replayed; what `params` leaves out takes its default.
    #[wasm_bindgen(constructor)]
    pub fn new(log: &JsValue, params: &JsValue) -> Result<CarLog, Thrown> {
        let log = logged(log)?;
        Self::CLASS.open(params, &opener(&log)).map(Self)
    }

    /// The lab in a state that `state()` answered.
    pub fn from(log: &JsValue, state: &JsValue) -> Result<CarLog, Thrown> {
        let log = logged(log)?;
        Self::CLASS.open_state(state, &opener(&log)).map(Self)
    }

    /// The log-likelihood with another delay, as its type says.
    pub fn likelihood(&self, delay: &JsValue) -> Result<f64, Thrown> {
        self.0.is(Self::CLASS.name)?;
        let delay = Arg::new(delay, "delay").number()?;
        Self::CLASS.lab(&self.0, |lab: &labs::CarLog| lab.likelihood(delay))
    }
}

/// What makes a lab of this log.
fn opener(log: &Arc<LoggedDrive>) -> impl Fn(&[f64], u32) -> Result<AnyLab, Error> + '_ {
    |params, step| lab::open::<labs::CarLog>(Arc::clone(log), params, step)
}
