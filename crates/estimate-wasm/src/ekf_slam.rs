//! The class of range–bearing SLAM.

use crate::arguments::belief_of;
use crate::decode::Arg;
use crate::encode::{list, record, rows};
use crate::errors::Thrown;
use crate::object::Held;
use estimate::Error;
use estimate::slam::{EkfSlam as Slam, LandmarkReading, Mapped, Outcome, Report};
use js_sys::Array;
use wasm_bindgen::prelude::*;

/// Range–bearing SLAM on the unicycle (§8.4.2): the state [x, y, θ, x₁, y₁, …] grows to at most 500 landmarks; at most
/// 100 sightings in one update.
#[wasm_bindgen]
#[repr(transparent)]
pub struct EkfSlam(Held);

const CLASS: &str = "EkfSlam";

fn shown(report: &Report) -> JsValue {
    let outcome = match report.outcome {
        Outcome::Matched => "matched",
        Outcome::Founded => "founded",
        Outcome::Rejected => "rejected",
    };
    let evidence = report.evidence.as_ref();
    record(&[
        ("outcome", outcome.into()),
        ("landmark", report.landmark.map_or(JsValue::NULL, JsValue::from)),
        ("innovation", evidence.map_or(JsValue::NULL, |(nu, ..)| list(nu.as_slice()))),
        ("S", evidence.map_or(JsValue::NULL, |(_, s, _)| rows(s))),
        ("chi2", evidence.map_or(JsValue::NULL, |(.., chi2)| (*chi2).into())),
    ])
}

fn shown_landmark(landmark: &Mapped) -> JsValue {
    record(&[
        ("id", landmark.id.into()),
        ("x", landmark.position[0].into()),
        ("y", landmark.position[1].into()),
        ("P", rows(&landmark.p)),
    ])
}

#[wasm_bindgen]
impl EkfSlam {
    /// A robot with a belief over [x, y, θ] and an empty map.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "SlamOptions")] options: &JsValue,
    ) -> Result<EkfSlam, Thrown> {
        let belief = belief_of(&Arg::new(belief, "belief"))?;
        let options = Arg::new(options, "options");
        options.only(["W", "gate", "found"].into_iter())?;
        let gate = options.field("gate")?.number_or_null()?;
        let slam = Slam::from_belief(&belief, options.field("W")?.matrix()?, gate, options.field("found")?.number()?);
        Ok(Self(Held::new(CLASS, slam.map_err(|e| e.part_of("options", &["W", "gate", "found"]))?)))
    }

    /// The pose moves by `u` = [Δs, Δθ] along the old heading; `V`, 3×3, is the process noise in the pose.
    pub fn predict(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] u: &JsValue,
        #[wasm_bindgen(js_name = V, unchecked_param_type = "Rows")] v: &JsValue,
    ) -> Result<(), Thrown> {
        let (u, v) = (Arg::new(u, "u").vector()?, Arg::new(v, "V").matrix()?);
        self.write(|slam| slam.predict_by(u, v))
    }

    /// One sighting, or an array of all sightings of one step, stacked; the answer is one of its kind.
    #[wasm_bindgen(unchecked_return_type = "SlamUpdate | SlamUpdate[]")]
    pub fn update(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SlamSighting | SlamSighting[]")] sightings: &JsValue,
    ) -> Result<JsValue, Thrown> {
        let arg = Arg::new(sightings, "sightings");
        let several = arg.array()?;
        let read = || if several { arg.entries()?.iter().map(sighting).collect() } else { Ok(vec![sighting(&arg)?]) };
        let readings: Vec<LandmarkReading> = read()?;
        // The core counts sightings where there are several; an array of one is counted too.
        let whole = if several { "sightings[0]" } else { "sightings" };
        let blame = |e: Error| e.part_of(whole, &["range", "bearing", "landmark"]);
        let reports = self.write(|slam| slam.update(&readings).map_err(blame))?;
        Ok(match reports.as_slice() {
            [one] if !several => shown(one),
            all => all.iter().map(shown).collect::<Array>().into(),
        })
    }

    /// The whole belief: x and P over pose and map.
    #[wasm_bindgen(unchecked_return_type = "Belief")]
    pub fn belief(&self) -> Result<JsValue, Thrown> {
        let (x, p) = self.0.read(CLASS, |slam: &Slam| {
            let (x, p) = slam.belief();
            (x.to_vec(), p)
        })?;
        Ok(record(&[("x", list(&x)), ("P", rows(&p))]))
    }

    /// The map, in the order in which it was founded.
    #[wasm_bindgen(unchecked_return_type = "MappedLandmark[]")]
    pub fn landmarks(&self) -> Result<JsValue, Thrown> {
        let landmarks: Vec<Mapped> = self.0.read(CLASS, |slam: &Slam| slam.landmarks().collect())?;
        Ok(landmarks.iter().map(shown_landmark).collect::<Array>().into())
    }

    fn write<T>(&self, f: impl FnOnce(&mut Slam) -> Result<T, Error>) -> Result<T, Thrown> {
        self.0.write(CLASS, f)
    }
}

fn sighting(arg: &Arg<'_>) -> Result<LandmarkReading, Error> {
    arg.only(["range", "bearing", "landmark"].into_iter())?;
    let mut landmark = None;
    arg.given("landmark", |a| a.whole(0, u32::MAX).map(Some), &mut landmark)?;
    Ok(LandmarkReading { range: arg.field("range")?.number()?, bearing: arg.field("bearing")?.number()?, landmark })
}
