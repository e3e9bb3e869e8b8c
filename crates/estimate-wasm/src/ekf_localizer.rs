//! The EKF localizer's class.

use crate::arguments::{belief_of, shown_belief};
use crate::decode::Arg;
use crate::encode::{list, record, rows};
use crate::errors::Thrown;
use crate::object::Held;
use estimate::localizer::{EkfLocalizer as Localizer, LandmarkReading, Localized, Logged, MAX_LOG, SensorKind};
use estimate::{Code, Error, Landmark};
use wasm_bindgen::prelude::*;

/// The EKF over the pose [x, y, θ] among known landmarks (§8.3), at most 1000 of them.
#[wasm_bindgen]
#[repr(transparent)]
pub struct EkfLocalizer(Held);

const CLASS: &str = "EkfLocalizer";

fn shown(answer: &Localized) -> JsValue {
    record(&[
        ("outcome", if answer.accepted { "accepted" } else { "rejected" }.into()),
        ("landmark", answer.landmark.into()),
        ("innovation", list(answer.innovation.as_slice())),
        ("S", rows(&answer.s)),
        ("chi2", answer.chi2.into()),
    ])
}

#[wasm_bindgen]
impl EkfLocalizer {
    /// A localizer with a belief over [x, y, θ] and a map.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Landmark[]")] landmarks: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "LocalizerOptions")] options: &JsValue,
    ) -> Result<EkfLocalizer, Thrown> {
        let belief = belief_of(&Arg::new(belief, "belief"))?;
        let map = Arg::new(landmarks, "landmarks").entries()?.iter().map(landmark).collect::<Result<_, _>>()?;
        let options = Arg::new(options, "options");
        options.only(["W", "gate", "sensor"].into_iter())?;
        let gate = options.field("gate")?.number_or_null()?;
        let mut sensor = SensorKind::default();
        let kind = |a: &Arg<'_>| {
            let kinds = [SensorKind::Range, SensorKind::RangeBearing];
            a.word(&["range", "range-bearing"]).map(|i| kinds[i])
        };
        options.given("sensor", kind, &mut sensor)?;
        let ekf = Localizer::new(belief, map, options.field("W")?.matrix()?, gate, sensor);
        Ok(Self(Held::new(CLASS, ekf.map_err(|e| e.part_of("options", &["W", "gate"]))?)))
    }

    /// The pose moves by `u` = [Δs, Δθ] along the old heading; `V`, 3×3, is the process noise in the state.
    pub fn predict(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] u: &JsValue,
        #[wasm_bindgen(js_name = V, unchecked_param_type = "Rows")] v: &JsValue,
    ) -> Result<(), Thrown> {
        let (u, v) = (Arg::new(u, "u").vector()?, Arg::new(v, "V").matrix()?);
        self.write(|ekf| ekf.predict(u, v))
    }

    /// Corrects the belief with a reading, of the landmark named or of the one it is found to be of; the gate holds in
    /// both cases.
    #[wasm_bindgen(unchecked_return_type = "LandmarkUpdate")]
    pub fn update(
        &self,
        #[wasm_bindgen(unchecked_param_type = "LandmarkReading")] reading: &JsValue,
    ) -> Result<JsValue, Thrown> {
        let reading = read(&Arg::new(reading, "reading"))?;
        let blame = |e: Error| e.part_of("reading", &["range", "bearing", "landmark"]);
        self.write(|ekf| ekf.update(reading).map_err(blame)).map(|answer| shown(&answer))
    }

    /// Predicts and corrects once for each step of a log of at most 1 000 000 steps, in one call where thousands would
    /// cross over one by one. A step is [Δs, Δθ, range, bearing] in `log` (without the bearing for a range sensor) and
    /// the id of its landmark in `landmarks`; `V` is that of `predict`. The answer holds the pose [x, y, θ] after each
    /// step. A step that is refused refuses the log: the belief is then what it was before.
    pub fn replay(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Float64Array")] log: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Uint32Array")] landmarks: &JsValue,
        #[wasm_bindgen(js_name = V, unchecked_param_type = "Rows")] v: &JsValue,
    ) -> Result<Vec<f64>, Thrown> {
        let most = MAX_LOG as u32;
        let landmarks = Arg::new(landmarks, "landmarks").wholes(most)?;
        let numbers = Arg::new(log, "log").floats(4 * most)?;
        let v = Arg::new(v, "V").matrix()?;
        self.write(|ekf| {
            let width = match ekf.sensor() {
                SensorKind::RangeBearing => 4,
                SensorKind::Range => 3,
            };
            if numbers.len() != width * landmarks.len() {
                let message = format!("has {} numbers; {} landmarks need {width} each", numbers.len(), landmarks.len());
                return Err(Error::new(Code::Shape, "log", message));
            }
            let logged = |(step, &id): (&[f64], &u32)| Logged {
                u: [step[0], step[1]],
                reading: LandmarkReading { range: step[2], bearing: step.get(3).copied(), landmark: Some(id) },
            };
            Ok(ekf.replay(numbers.chunks_exact(width).zip(&landmarks).map(logged), v)?.into_flattened())
        })
    }

    /// The present belief, θ in (−π, π].
    #[wasm_bindgen(unchecked_return_type = "Belief")]
    pub fn belief(&self) -> Result<JsValue, Thrown> {
        self.0.read(CLASS, Localizer::belief).map(|belief| shown_belief(&belief))
    }

    fn write<T>(&self, f: impl FnOnce(&mut Localizer) -> Result<T, Error>) -> Result<T, Thrown> {
        self.0.write(CLASS, f)
    }
}

fn landmark(arg: &Arg<'_>) -> Result<Landmark, Error> {
    arg.only(["id", "x", "y"].into_iter())?;
    let id = arg.field("id")?.whole(0, u32::MAX)?;
    Ok(Landmark { id, x: arg.field("x")?.number()?, y: arg.field("y")?.number()? })
}

fn read(arg: &Arg<'_>) -> Result<LandmarkReading, Error> {
    arg.only(["range", "bearing", "landmark"].into_iter())?;
    let (mut bearing, mut landmark) = (None, None);
    arg.given("bearing", |a| a.number().map(Some), &mut bearing)?;
    arg.given("landmark", |a| a.whole(0, u32::MAX).map(Some), &mut landmark)?;
    Ok(LandmarkReading { range: arg.field("range")?.number()?, bearing, landmark })
}
