//! What is read otherwise than the files of a log have it.

use crate::decode::Arg;
use crate::encode::{list, record};
use estimate::validate::finite;
use estimate::{Code, Error};
use js_sys::Array;
use robot_log::{Corrections, MAX_LANDMARKS};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What is read otherwise than the files of a log have it. */
export interface LogCorrections {
    /** How many times distances and turns of odometry are taken as they are read. */
    driven: [number, number];
    /** The id, x and y of each landmark that stands elsewhere. */
    landmarks: [number, number, number][];
}
"#;

/// What a caller says of them: two factors, and id, x and y of landmarks.
pub(crate) fn read(driven: &JsValue, landmarks: &JsValue) -> Result<Corrections, Error> {
    let (driven, landmarks) = (Arg::new(driven, "driven"), Arg::new(landmarks, "landmarks"));
    let place = |place: &Arg<'_>| {
        let [id, x, y] = place.exactly()?;
        let whole = id >= 0.0 && id <= f64::from(u32::MAX) && id.fract() == 0.0;
        if !whole {
            return Err(Error::new(Code::Type, "landmarks", "have an id that is no whole number"));
        }
        Ok((id as u32, [finite(x, "landmarks")?, finite(y, "landmarks")?]))
    };
    let landmarks = landmarks.every(MAX_LANDMARKS, place)?;
    Ok(Corrections { driven: driven.exactly()?, landmarks: landmarks.into_iter().collect() })
}

/// The same as a caller reads it.
pub(crate) fn shown(corrections: &Corrections) -> JsValue {
    let places = corrections.landmarks.iter().map(|(id, [x, y])| list(&[f64::from(*id), *x, *y]));
    record(&[("driven", list(&corrections.driven)), ("landmarks", places.collect::<Array>().into())])
}
