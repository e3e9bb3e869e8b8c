//! A Kalman filter's state as plain values.

use crate::arguments::{belief_of, shown_belief, system_of_arg};
use crate::decode::Arg;
use crate::encode::{list, number_or_null, record, rows};
use estimate::Error;
use estimate::dynamic::{Bound, Conditioning, FilterState, LastReading};
use wasm_bindgen::prelude::*;

const FIELDS: [&str; 7] = ["version", "system", "belief", "logLikelihood", "last", "conditioned", "rounding"];
const LAST: [&str; 4] = ["innovation", "S", "R", "nis"];

pub(crate) fn shown(state: &FilterState) -> JsValue {
    let FilterState { system, belief, log_likelihood, last, conditioning } = state;
    let system = [("F", &system.f), ("G", &system.g), ("H", &system.h), ("V", &system.v), ("W", &system.w)];
    let last = last.as_ref().map_or(JsValue::NULL, |last| {
        record(&[
            ("innovation", list(last.innovation.as_slice())),
            ("S", rows(&last.s)),
            ("R", rows(&last.r)),
            ("nis", number_or_null(last.nis)),
        ])
    });
    let rounding = match conditioning.bound() {
        Bound::Nothing => JsValue::NULL,
        Bound::OfEntries => "entries".into(),
        Bound::Carried(rounding) => rows(rounding),
    };
    record(&[
        ("version", 1.into()),
        ("system", record(&system.map(|(letter, m)| (letter, rows(m))))),
        ("belief", shown_belief(belief)),
        ("logLikelihood", number_or_null(*log_likelihood)),
        ("last", last),
        ("conditioned", conditioning.is_well_conditioned().into()),
        ("rounding", rounding),
    ])
}

pub(crate) fn read(state: &Arg<'_>) -> Result<FilterState, Error> {
    state.only(FIELDS.into_iter())?;
    state.field("version")?.whole(1, 1)?;
    let rounding = state.field("rounding")?;
    let bound = match () {
        () if rounding.is_null() => Bound::Nothing,
        () if rounding.is_string() => rounding.word(&["entries"]).map(|_| Bound::OfEntries)?,
        () => Bound::Carried(rounding.matrix()?),
    };
    let last = match state.field("last")? {
        last if last.is_null() => None,
        last => {
            last.only(LAST.into_iter())?;
            let innovation = last.field("innovation")?.vector()?;
            let (s, r) = (last.field("S")?.matrix()?, last.field("R")?.matrix()?);
            Some(LastReading { innovation, s, r, nis: last.field("nis")?.number_or_null()? })
        }
    };
    Ok(FilterState {
        system: system_of_arg(&state.field("system")?).map_err(blamed)?,
        belief: belief_of(&state.field("belief")?).map_err(blamed)?,
        log_likelihood: state.field("logLikelihood")?.number_or_null()?,
        last,
        conditioning: Conditioning::resumed(bound, !state.field("conditioned")?.boolean()?),
    })
}

/// An error of the core about a state's parts.
pub(crate) fn blamed(error: Error) -> Error {
    match &*error.argument {
        // Found while it was decoded, by its path.
        argument if argument.starts_with("state.") => error,
        argument if LAST.contains(&argument) => error.within("last").within("state"),
        _ => error.within("state"),
    }
}
