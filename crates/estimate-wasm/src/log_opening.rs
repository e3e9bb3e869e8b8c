//! Where a log begins without a truth, as parameters of a lab.

use crate::encode::record;
use estimate::drive::{Drive, Opening, Settings};
use wasm_bindgen::prelude::*;

/// Where a drive began by its first fixes or ranges, if no truth says it; what has no σ of its own has the default's.
pub(crate) fn began(drive: &Drive) -> Option<Opening> {
    drive.truth.poses().is_empty().then(|| drive.opening(&Settings::default())).flatten()
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
