//! The class of a time line: several sensors, each reading at the time at which it was measured.

use crate::arguments::{belief_of, continuous_of, shown_belief};
use crate::decode::{Arg, Outputs};
use crate::encode::{list, number_or_null, record, rows};
use crate::errors::Thrown;
use crate::object::Held;
use estimate::Error;
use estimate::dynamic::{MAX_CAPACITY, MAX_SENSORS, Memory, Outcome, Placed, Sensor, Timeline as CoreTimeline};
use js_sys::Array;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("timeline.d.ts");
#[cfg(feature = "models")]
#[wasm_bindgen(typescript_custom_section)]
const OWN_TYPES: &str = include_str!("timeline_own.d.ts");
#[cfg(not(feature = "models"))]
#[wasm_bindgen(typescript_custom_section)]
const LINEAR_TYPES: &str = "export type AnyTimelineSensor = TimelineSensor\n";

/// A Kalman filter in continuous time for sensors with delays and rates of their own. Readings and inputs may come in
/// any order within a window: what comes late is put in its place and replayed, and the belief is that of the sorted
/// readings, to the last bit. At one time an input comes first, then the sensors in the order of `sensors`, then
/// readings by their id.
#[wasm_bindgen]
#[repr(transparent)]
pub struct Timeline(Held);

const CLASS: &str = "Timeline";

/// What a sensor reads of a state. A caller's own functions are in the whole module alone.
#[cfg(feature = "models")]
type Read = estimate::dynamic::AnyOutput<crate::errors::Refused>;
#[cfg(not(feature = "models"))]
type Read = nalgebra::DMatrix<f64>;
type Line = CoreTimeline<Read>;

#[wasm_bindgen]
impl Timeline {
    /// The time line of x' = A x + B u + noise of density Q, with the belief at `options.time`.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "ContinuousSystem")] system: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "TimelineOptions")] options: &JsValue,
    ) -> Result<Timeline, Thrown> {
        let (system, belief) = (continuous_of(system)?, belief_of(&Arg::new(belief, "belief"))?);
        let options = Arg::new(options, "options");
        options.only(["time", "window", "capacity", "sensors"].into_iter())?;
        let (mut time, mut capacity) = (0.0, 1000);
        options.given("time", |a| a.number(), &mut time)?;
        options.given("capacity", |a| a.whole(1, MAX_CAPACITY as u32), &mut capacity)?;
        let memory = Memory { window: options.field("window")?.number()?, capacity: capacity as usize };
        let sensors = options.field("sensors")?;
        let mut all = Vec::new();
        for (name, value) in sensors.own_fields(MAX_SENSORS as u32)? {
            // Decoded by itself: a caller's name is no part of the paths that an error spells out.
            all.push(sensor(&Arg::new(&value, SENSOR), name)?);
        }
        let line = Line::new(system, &belief, time, memory, all).map_err(|e| match &*e.argument {
            "belief" => e,
            _ => e.within("options"),
        })?;
        Ok(Self(Held::new(CLASS, line)))
    }

    /// The input is `u` from the time `t` on, until the next. Before the first it is zero.
    #[wasm_bindgen(unchecked_return_type = "TimelineInput")]
    pub fn input(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] t: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] u: &JsValue,
    ) -> Result<JsValue, Thrown> {
        let (t, u) = (Arg::new(t, "t").number()?, Arg::new(u, "u").short()?);
        let placed = self.0.write(CLASS, |line: &mut Line| line.input(t, &u))?;
        Ok(record(&[("outcome", word(placed.outcome).into())]))
    }

    /// The sensor of this name has read `y`, of which parts may be null, with the stamp `t`. Readings of one sensor at
    /// one time are told apart by `id`, a whole number, 0 when left out.
    #[wasm_bindgen(unchecked_return_type = "TimelineReading")]
    pub fn reading(
        &self,
        #[wasm_bindgen(unchecked_param_type = "string")] name: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] t: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "PartialVector | Float64Array")] y: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] id: &JsValue,
    ) -> Result<JsValue, Thrown> {
        let (name, t) = (Arg::new(name, "name").name()?, Arg::new(t, "t").number()?);
        let y = Arg::new(y, "y").reading().map(Outputs::parts)?;
        let id = match Arg::new(id, "id") {
            id if id.is_undefined() => 0,
            id => id.whole(0, u32::MAX)?,
        };
        let placed = self.0.write(CLASS, |line: &mut Line| line.reading(&name, t, &y, u64::from(id)))?;
        Ok(shown(&placed))
    }

    /// The belief at the time `t`, after all that was measured then. Asking changes nothing.
    #[wasm_bindgen(unchecked_return_type = "Belief")]
    pub fn at(&self, #[wasm_bindgen(unchecked_param_type = "number")] t: &JsValue) -> Result<JsValue, Thrown> {
        let t = Arg::new(t, "t").number()?;
        let belief = self.0.read(CLASS, |line: &Line| line.at(t))??;
        Ok(shown_belief(&belief))
    }

    /// What became of the readings of each sensor since the start, also of those before the window. It is of the sorted
    /// readings: what comes late may change it.
    #[wasm_bindgen(unchecked_return_type = "Record<string, SensorStatistics>")]
    pub fn statistics(&self) -> Result<JsValue, Thrown> {
        let all = self.0.read(CLASS, Line::statistics)?;
        let entries = Array::new();
        for it in &all {
            let mean = it.mean_innovation.iter().map(|mean| number_or_null(*mean)).collect::<Array>();
            let shown = record(&[
                ("used", (it.used as f64).into()),
                ("refused", (it.refused as f64).into()),
                ("nis", number_or_null(it.nis)),
                ("meanInnovation", mean.into()),
            ]);
            entries.push(&Array::of2(&it.name.as_str().into(), &shown));
        }
        Ok(js_sys::Object::from_entries(&entries).map_or(JsValue::NULL, Into::into))
    }

    /// The latest time at which something was measured, or that of the start.
    #[wasm_bindgen(getter, unchecked_return_type = "number")]
    pub fn newest(&self) -> Result<JsValue, Thrown> {
        self.0.read(CLASS, |line: &Line| line.newest().into())
    }

    /// How many inputs and readings are kept.
    #[wasm_bindgen(getter, unchecked_return_type = "number")]
    pub fn length(&self) -> Result<JsValue, Thrown> {
        self.0.read(CLASS, |line: &Line| (line.len() as f64).into())
    }
}

const SENSOR: &str = "sensor";

fn sensor(arg: &Arg<'_>, name: String) -> Result<Sensor<Read>, Error> {
    let read = || {
        let mut delay = 0.0;
        let w = arg.field("W")?.matrix()?;
        let h = output(arg, &w)?;
        arg.given("delay", |a| a.number(), &mut delay)?;
        Ok((h, w, delay, arg.field("gate")?.number_or_null()?))
    };
    match read() {
        Ok((h, w, delay, gate)) => Ok(Sensor { name, h, w, delay, gate }),
        // The sensor's name in place of what it was called while it was decoded.
        Err(error) => {
            let mut error: Error = error;
            let field = error.argument.strip_prefix(SENSOR).unwrap_or_default();
            error.argument = ["options.sensors.", &name, field].concat().into();
            Err(error)
        }
    }
}

#[cfg(not(feature = "models"))]
fn output(arg: &Arg<'_>, _: &nalgebra::DMatrix<f64>) -> Result<Read, Error> {
    arg.only(["H", "W", "delay", "gate"].into_iter())?;
    arg.field("H")?.tall()
}

/// H, or a function h with as many outputs as W has rows.
#[cfg(feature = "models")]
fn output(arg: &Arg<'_>, w: &nalgebra::DMatrix<f64>) -> Result<Read, Error> {
    use crate::own_models::{angles_of, called, slope};
    use estimate::dynamic::OwnOutput;
    use std::rc::Rc;
    let Some(h) = arg.field("h")?.function()? else {
        arg.only(["H", "W", "delay", "gate"].into_iter())?;
        return Ok(Read::Linear(arg.field("H")?.tall()?));
    };
    arg.only(["h", "H", "W", "angles", "delay", "gate"].into_iter())?;
    let jacobian = arg.field("H")?.function()?;
    Ok(Read::Own(OwnOutput {
        outputs: w.nrows(),
        h: Rc::new(move |x: &[f64]| called(&h, x, "h(x)")),
        jacobian: jacobian.map(|jacobian| Rc::new(move |x: &[f64]| slope(&jacobian, x, "H(x)")) as _),
        angles: angles_of(arg, estimate::validate::MAX_OUTPUTS)?,
    }))
}

fn word(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Accepted => "accepted",
        Outcome::Rejected => "rejected",
        Outcome::TooLate => "too-late",
        Outcome::Ahead => "ahead",
        Outcome::Duplicate => "duplicate",
        Outcome::Full => "full",
    }
}

fn shown(placed: &Placed) -> JsValue {
    let judged = placed.judged.as_ref();
    record(&[
        ("outcome", word(placed.outcome).into()),
        ("innovation", judged.map_or(JsValue::NULL, |it| list(it.innovation.as_slice()))),
        ("S", judged.map_or(JsValue::NULL, |it| rows(&it.s))),
        ("chi2", number_or_null(judged.and_then(|it| it.chi2))),
    ])
}
