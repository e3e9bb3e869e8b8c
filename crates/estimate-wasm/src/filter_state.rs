//! A Kalman filter's state as plain values, and another filter that holds the same.

use crate::arguments::{belief_of, shown_belief, system_of_arg};
use crate::decode::Arg;
use crate::encode::{list, number_or_null, record, rows};
use crate::errors::Thrown;
use crate::kalman_filter::{CLASS, KalmanFilter};
use crate::object::Held;
use estimate::Error;
use estimate::dynamic::{Bound, Conditioning, FilterState, KalmanFilter as Filter, LastReading};
use wasm_bindgen::prelude::*;

const FIELDS: [&str; 7] = ["version", "system", "belief", "logLikelihood", "last", "conditioned", "rounding"];
const LAST: [&str; 4] = ["innovation", "S", "R", "nis"];

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("filter_state.d.ts");

#[wasm_bindgen]
impl KalmanFilter {
    /// Another filter that holds the same.
    #[wasm_bindgen(js_name = clone)]
    pub fn copy(&self) -> Result<KalmanFilter, Thrown> {
        self.0.read(CLASS, |filter: &Filter| Self(Held::new(CLASS, filter.clone())))
    }

    /// All that the filter holds, as plain values that JSON can hold.
    #[wasm_bindgen(unchecked_return_type = "KalmanFilterState")]
    pub fn state(&self) -> Result<JsValue, Thrown> {
        self.0.read(CLASS, |filter: &Filter| shown(&filter.state()))
    }

    /// The filter that holds this: it goes on, to the last bit, as the one whose `state()` it was.
    #[wasm_bindgen(js_name = from)]
    pub fn from_state(
        #[wasm_bindgen(unchecked_param_type = "KalmanFilterState")] state: &JsValue,
    ) -> Result<KalmanFilter, Thrown> {
        let state = read(&Arg::new(state, "state"))?;
        let filter = Filter::from_state(state).map_err(blamed)?;
        Ok(Self(Held::new(CLASS, filter)))
    }
}

fn shown(state: &FilterState) -> JsValue {
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

fn read(state: &Arg<'_>) -> Result<FilterState, Error> {
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
fn blamed(error: Error) -> Error {
    match &*error.argument {
        // Found while it was decoded, by its path.
        argument if argument.starts_with("state.") => error,
        argument if LAST.contains(&argument) => error.within("last").within("state"),
        _ => error.within("state"),
    }
}
