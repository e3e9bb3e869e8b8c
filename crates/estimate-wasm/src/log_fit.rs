//! The fit of a log's noise and delays, which a worker goes on with replay by replay.

use crate::decode::Arg;
use crate::encode::{list, record};
use crate::errors::Thrown;
use crate::lab::RobotLog;
use crate::object::Held;
use crate::robot_log::logged;
use estimate::Error;
use estimate::drive::{FitResult, Fitted};
use js_sys::Array;
use lab::Params;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What a fit has found so far. */
export interface LogFound {
    /**
     * Each number, by its name among the parameters, and how well the log tells it: a σ's standard deviation relative
     * to it, another's in its unit; null where the log does not tell it, and before the search has ended. `relative`
     * says which of the two.
     */
    numbers: {
        name: string; value: number; relative: boolean; sigma: number | null;
        /** Of a delay, from where to where the likelihood is the same: a log of odometry tells no more; else null. */
        flat: [number, number] | null;
        /** Of a σ that may as well be smaller, the greatest that is about as likely; else null. */
        most: number | null;
    }[];
    /** The log-likelihood of the counted readings before and after. */
    logLikelihood: [number, number];
    /** How many readings are counted, and how many of them are taken for outliers; null where no gate is on. */
    readings: number;
    outliers: number | null;
    /**
     * How many the gates refuse, as they are set, under what was found: far more where a filter that once refuses loses
     * its way; null where no gate is on, 0 before the search has ended.
     */
    refused: number | null;
    /** Replays so far, and how many there may be at most. */
    replays: [number, number];
    /** Whether the search has ended where no step leads up. */
    settled: boolean;
    /** How many of the other readings lie far out, and which share is expected to: more have bent the fit. */
    beyond: number;
    expected: number;
    /** The mean distance of a second in which the robot drives, metres: what σ of the distance is held against. */
    pace: number;
    /** Half of the mean turn of a step, radians: by so much the filter takes a sensor of bearings to be turned. */
    halfTurn: number;
    /** The median time between rows of motion, seconds. */
    period: number;
    /** A delay of at most this may be the motion model's own, seconds: half of that, or all of it. */
    ownDelay: number;
}
"#;

/// A search for the σ, the delays, the scale and the offset of ranges, and the offsets of bearings and headings under
/// which a log's readings are likeliest. Where a gate is on, a reading that is likelier an outlier is taken for one,
/// whatever the gate's level. The turn rate's delay is 0, and the readings are the same in every replay.
#[wasm_bindgen]
#[repr(transparent)]
pub struct LogFit(Held);

const FIT: &str = "LogFit";

#[wasm_bindgen]
impl LogFit {
    /// A search that begins at `params`; what they leave out takes its default. `only` names the numbers to look for,
    /// as far as the log may tell them.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "DriveLog")] log: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Partial<LogParams>")] params: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "string[]")] only: &JsValue,
    ) -> Result<LogFit, Thrown> {
        let log = logged(log)?;
        let params = RobotLog::params(params)?;
        let only = Arg::new(only, "only");
        let only = if only.is_undefined() { None } else { Some(only.every(Fitted::ALL.len(), number_of)?) };
        let fit = labs::LogFit::new(Arc::clone(&log), Params::read(&mut params.iter()), only.as_deref());
        Ok(Self(Held::new(FIT, fit.map_err(|e| e.within("params"))?)))
    }

    /// Replays the log once more; whether there is more to do.
    pub fn step(&self) -> Result<bool, Thrown> {
        self.0.write(FIT, labs::LogFit::step)
    }

    /// What has been found so far.
    #[wasm_bindgen(unchecked_return_type = "LogFound")]
    pub fn found(&self) -> Result<JsValue, Thrown> {
        self.0.read(FIT, |fit: &labs::LogFit| shown(&fit.found()))
    }
}

fn number_of(arg: &Arg<'_>) -> Result<Fitted, Error> {
    Ok(Fitted::ALL[arg.word(&Fitted::ALL.map(Fitted::name))?])
}

fn shown(found: &FitResult) -> JsValue {
    let flat = |of: &Fitted| found.flat.iter().find(|(number, _)| number == of).map(|(_, flat)| list(flat));
    let most = |of: &Fitted| found.at_most.iter().find(|(number, _)| number == of).map(|(_, most)| (*most).into());
    let numbers = found.numbers.iter().map(|(number, value, sigma)| {
        record(&[
            ("name", number.name().into()),
            ("value", (*value).into()),
            ("relative", number.is_sigma().into()),
            ("sigma", sigma.map_or(JsValue::NULL, Into::into)),
            ("flat", flat(number).unwrap_or(JsValue::NULL)),
            ("most", most(number).unwrap_or(JsValue::NULL)),
        ])
    });
    record(&[
        ("numbers", numbers.collect::<Array>().into()),
        ("logLikelihood", list(&found.log_likelihood)),
        ("readings", found.readings.into()),
        ("outliers", found.outliers.map_or(JsValue::NULL, Into::into)),
        ("refused", found.refused.map_or(JsValue::NULL, Into::into)),
        ("replays", list(&found.replays.map(f64::from))),
        ("settled", found.settled.into()),
        ("beyond", found.beyond.into()),
        ("expected", found.expected.into()),
        ("pace", found.pace.into()),
        ("halfTurn", found.half_turn.into()),
        ("period", found.period.into()),
        ("ownDelay", found.own_delay.into()),
    ])
}
