//! Where a log begins without a truth, as parameters of a lab.

use crate::encode::record;
use crate::errors::Thrown;
use crate::lab::RobotLog;
use estimate::drive::{Drive, Opening, Settings};
use lab::Params;
use labs::LogParams;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Where a log began, as parameters of a lab. */
export interface LogOpening {
    start: [number, number, number];
    startSigma: number;
    startSigmaHeading: number;
}
"#;

/// The settings of a lab's parameters.
pub(crate) fn settings(params: &JsValue) -> Result<Settings, Thrown> {
    let params = RobotLog::params(params)?;
    let params: LogParams = Params::read(&mut params.iter());
    params.check().map_err(|e| e.within("params"))?;
    Ok(Settings::from(params))
}

/// Where a drive began by its first fixes or ranges, if no truth says it; what has no σ of its own has the settings'.
pub(crate) fn began(drive: &Drive, settings: &Settings) -> Option<Opening> {
    drive.truth.poses().is_empty().then(|| drive.opening(settings)).flatten()
}

/// An opening as the page takes it.
pub(crate) fn shown(found: Option<Opening>) -> JsValue {
    found.map_or(JsValue::NULL, |Opening { pose, sigma, sigma_heading }| {
        record(&[
            ("start", crate::encode::list(&pose)),
            ("startSigma", sigma.into()),
            ("startSigmaHeading", sigma_heading.into()),
        ])
    })
}
