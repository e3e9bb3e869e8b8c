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
    /** How many times distances of odometry, and turns or turn rates, are taken as they are read. */
    driven: [number, number];
    /** By how much more to its left the robot turns on each metre than is read, radians; 0 where nothing is said. */
    swerve?: number;
    /** The id, x and y of each landmark that stands elsewhere. */
    landmarks: [number, number, number][];
    /** The id of each landmark whose ranges are taken shorter than they are read, and by how much, metres. */
    ranges: [number, number][];
    /** From when to when the log is read, seconds since the first row of its files; null where all of it is. */
    kept?: [number, number] | null;
}
"#;

/// What a caller says of them: two factors, id, x and y of landmarks, id and metres of ranges, two times, and
/// radians for each metre; the last three may be left out.
pub(crate) fn read(
    driven: &JsValue,
    landmarks: &JsValue,
    ranges: &JsValue,
    kept: &JsValue,
    swerve: &JsValue,
) -> Result<Corrections, Error> {
    let driven = Arg::new(driven, "driven").exactly()?;
    let landmarks = Arg::new(landmarks, "landmarks").every(MAX_LANDMARKS, |place| {
        let [id, x, y] = place.exactly()?;
        Ok((id_of(id, "landmarks")?, [finite(x, "landmarks")?, finite(y, "landmarks")?]))
    })?;
    let ranges = Arg::new(ranges, "ranges");
    let shorter = |pair: &Arg<'_>| {
        let [id, by] = pair.exactly()?;
        Ok((id_of(id, "ranges")?, finite(by, "ranges")?))
    };
    let ranges = if ranges.is_undefined() { Vec::new() } else { ranges.every(MAX_LANDMARKS, shorter)? };
    let kept = Arg::new(kept, "kept");
    let kept = if kept.is_undefined() || kept.is_null() { None } else { Some(kept.exactly()?) };
    if kept.is_some_and(|[from, to]: [f64; 2]| from >= to) {
        return Err(Error::new(Code::Limit, "kept", "ends before it begins"));
    }
    let swerve = Arg::new(swerve, "swerve");
    let swerve = if swerve.is_undefined() { 0.0 } else { finite(swerve.number()?, "swerve")? };
    let (landmarks, ranges) = (landmarks.into_iter().collect(), ranges.into_iter().collect());
    Ok(Corrections { driven, swerve, landmarks, ranges, kept })
}

fn id_of(id: f64, name: &'static str) -> Result<u32, Error> {
    let whole = id >= 0.0 && id <= f64::from(u32::MAX) && id.fract() == 0.0;
    if whole { Ok(id as u32) } else { Err(Error::new(Code::Type, name, "have an id that is no whole number")) }
}

/// The same as a caller reads it.
pub(crate) fn shown(corrections: &Corrections) -> JsValue {
    let places = corrections.landmarks.iter().map(|(id, [x, y])| list(&[f64::from(*id), *x, *y]));
    let ranges = corrections.ranges.iter().map(|(id, by)| list(&[f64::from(*id), *by]));
    record(&[
        ("driven", list(&corrections.driven)),
        ("swerve", corrections.swerve.into()),
        ("landmarks", places.collect::<Array>().into()),
        ("ranges", ranges.collect::<Array>().into()),
        ("kept", corrections.kept.map_or(JsValue::NULL, |kept| list(&kept))),
    ])
}
