//! The class of range–bearing SLAM.

use crate::decode::Arg;
use crate::encode::{plain, rows};
use crate::errors::thrown;
use crate::functions::belief_of;
use crate::lab::busy;
use estimate::Error;
use estimate::slam::{EkfSlam as Slam, Outcome, Reading, Report};
use serde::Serialize;
use std::cell::RefCell;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface SlamOptions {
    /** Noise covariance of a sighting, 2×2. */
    W: Matrix;
    /** A sighting whose χ² is greater is not used; null, or absent, for none. */
    gate?: number | null;
    /** A sighting whose χ² is greater for every landmark founds a new one; far above the gate. */
    found: number;
}
/** The bearing is measured from the landmark. Left out, the landmark is associated, or founded. */
export interface SlamSighting { range: number; bearing: number; landmark?: number }
export interface SlamUpdate {
    outcome: "matched" | "founded" | "rejected";
    /** The landmark matched, founded, or (when rejected) nearest. */
    landmark: number | null;
    /** Against it, at the prediction; null for a new one. */
    innovation: Vector | null;
    S: Matrix | null;
    chi2: number | null;
}
export interface MappedLandmark { id: number; x: number; y: number; P: Matrix }
"#;

/// Range–bearing SLAM on the unicycle (§8.4.2): the state [x, y, θ, x₁, y₁, …] grows to at most 500 landmarks; at most
/// 100 sightings in one update.
#[wasm_bindgen]
pub struct EkfSlam(RefCell<Slam>);

#[derive(Serialize)]
struct Answer {
    outcome: &'static str,
    landmark: Option<u32>,
    innovation: Option<[f64; 2]>,
    #[serde(rename = "S")]
    s: Option<[[f64; 2]; 2]>,
    chi2: Option<f64>,
}

impl From<&Report> for Answer {
    fn from(report: &Report) -> Self {
        Self {
            outcome: match report.outcome {
                Outcome::Matched => "matched",
                Outcome::Founded => "founded",
                Outcome::Rejected => "rejected",
            },
            landmark: report.landmark,
            innovation: report.evidence.map(|(nu, ..)| nu.into()),
            // Symmetric: columns are rows.
            s: report.evidence.map(|(_, s, _)| s.into()),
            chi2: report.evidence.map(|(.., chi2)| chi2),
        }
    }
}

#[derive(Serialize)]
struct BeliefAnswer<'a> {
    x: &'a [f64],
    #[serde(rename = "P")]
    p: Vec<Vec<f64>>,
}

#[derive(Serialize)]
struct LandmarkAnswer {
    id: u32,
    x: f64,
    y: f64,
    #[serde(rename = "P")]
    p: [[f64; 2]; 2],
}

#[wasm_bindgen]
impl EkfSlam {
    /// A robot with a belief over [x, y, θ] and an empty map.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Belief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "SlamOptions")] options: &JsValue,
    ) -> Result<EkfSlam, JsValue> {
        let read = || -> Result<Slam, Error> {
            let belief = belief_of(&Arg::new(belief, "belief"))?;
            let options = Arg::new(options, "options");
            options.only(&["W", "gate", "found"])?;
            let mut gate = None;
            options.given("gate", |a| if a.is_null() { Ok(None) } else { a.number().map(Some) }, &mut gate)?;
            let (w, found) = (options.field("W")?.matrix()?, options.field("found")?.number()?);
            Slam::from_belief(&belief, w, gate, found).map_err(|e| match e.argument.as_ref() {
                "W" | "gate" | "found" => e.within("options"),
                _ => e,
            })
        };
        read().map(|slam| Self(RefCell::new(slam))).map_err(thrown)
    }

    /// The pose moves by `u` = [Δs, Δθ] along the old heading; `V`, 3×3, is the process noise in the pose.
    pub fn predict(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Vector")] u: &JsValue,
        #[wasm_bindgen(js_name = V, unchecked_param_type = "Matrix")] v: &JsValue,
    ) -> Result<(), JsValue> {
        let (u, v) = (Arg::new(u, "u").vector().map_err(thrown)?, Arg::new(v, "V").matrix().map_err(thrown)?);
        self.write(|slam| slam.predict_by(u, v))
    }

    /// One sighting, or an array of all sightings of one step, stacked; the answer is one of its kind.
    #[wasm_bindgen(unchecked_return_type = "SlamUpdate | SlamUpdate[]")]
    pub fn update(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SlamSighting | SlamSighting[]")] sightings: &JsValue,
    ) -> Result<JsValue, JsValue> {
        let arg = Arg::new(sightings, "sightings");
        let several = arg.array().map_err(thrown)?;
        let read = || if several { arg.entries()?.iter().map(sighting).collect() } else { Ok(vec![sighting(&arg)?]) };
        let readings: Vec<Reading> = read().map_err(thrown)?;
        // The core counts sightings where there are several; an array of one is counted too.
        let whole = if several { "sightings[0]" } else { "sightings" };
        let blame = |e: Error| match e.argument.as_ref() {
            "range" | "bearing" | "landmark" => e.within(whole),
            _ => e,
        };
        let reports = self.write(|slam| slam.update(&readings).map_err(blame))?;
        let answers: Vec<Answer> = reports.iter().map(Answer::from).collect();
        match answers.as_slice() {
            [one] if !several => plain(one),
            all => plain(all),
        }
    }

    /// The whole belief: x and P over pose and map.
    #[wasm_bindgen(unchecked_return_type = "Belief")]
    pub fn belief(&self) -> Result<JsValue, JsValue> {
        let slam = self.0.try_borrow().map_err(|_| busy())?;
        let (x, p) = slam.belief();
        plain(&BeliefAnswer { x, p: rows(&p) })
    }

    /// The map, in the order in which it was founded.
    #[wasm_bindgen(unchecked_return_type = "MappedLandmark[]")]
    pub fn landmarks(&self) -> Result<JsValue, JsValue> {
        let slam = self.0.try_borrow().map_err(|_| busy())?;
        let answer =
            |l: estimate::slam::Mapped| LandmarkAnswer { id: l.id, x: l.position[0], y: l.position[1], p: l.p.into() };
        plain(&slam.landmarks().map(answer).collect::<Vec<_>>())
    }

    fn write<T>(&self, f: impl FnOnce(&mut Slam) -> Result<T, Error>) -> Result<T, JsValue> {
        f(&mut *self.0.try_borrow_mut().map_err(|_| busy())?).map_err(thrown)
    }
}

fn sighting(arg: &Arg<'_>) -> Result<Reading, Error> {
    arg.only(&["range", "bearing", "landmark"])?;
    let mut landmark = None;
    arg.given("landmark", |a| a.whole(0, u32::MAX).map(Some), &mut landmark)?;
    Ok(Reading { range: arg.field("range")?.number()?, bearing: arg.field("bearing")?.number()?, landmark })
}
