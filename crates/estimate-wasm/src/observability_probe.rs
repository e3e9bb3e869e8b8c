//! The Observability Probe's class.

use crate::decode::Arg;
use crate::encode::plain;
use crate::errors::thrown;
use crate::lab::{Decoded, lab_class};
use estimate::{Code, Error};
use labs::{MAX_STEP, ProbeParams, Sight};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface ProbeParams {
    /** Three landmarks [x, y] in room A, each coordinate from 0 to 6 m. */
    landmarks: Vector[];
    /** How many of them are seen: 1 to 3; default 1. */
    count: number;
    /** What is read of them; default "range". */
    sensor: "range" | "range-bearing";
    /** The step at which the robot stops; null drives on. */
    stop: number | null;
    /** Whether the robot has lost its map and founds it anew (with range and bearing, whatever the sensor says). */
    forget: boolean;
    /** Below this part of the largest a singular value counts as zero; 0 to 1, default 1e-6. */
    tolerance: number;
    /** A whole number below 2³²; default 1. */
    seed: number;
}
export interface ProbeRanks {
    rank: number;
    n: number;
    singularValues: Vector;
    /** Each over the largest. */
    relative: Vector;
    /** Orthonormal; of a stack, at its start. */
    nullspace: Vector[];
    /** The same at the present pose, robot's part: [dx, dy, dθ] of length 1 in the plane, or a pure turn. */
    directions: Vector[];
    /** Steps stacked; 0 when frozen. */
    steps: number;
}
export interface ProbeSighting {
    landmark: number;
    range: number;
    bearing: number | null;
    innovation: Vector | null;
    S: Matrix | null;
    chi2: number | null;
    outcome: "accepted" | "matched" | "founded" | "rejected";
    /** Where the landmark it was taken for is believed to be. */
    to: Vector | null;
}
export interface ProbeMap {
    /** `truth` is the index of the landmark it was founded on; `sigma` the error in its own standard deviations. */
    landmarks: {
        id: number; x: number; y: number; P: Matrix; ellipse: Ellipse; truth: number; error: number; sigma: number;
    }[];
    sightings: number;
    matched: number;
    founded: number;
    rejected: number;
    /** Matched to another landmark than the one seen. */
    wrong: number;
    /** Founded though it was in the map. */
    spurious: number;
    worst: { error: number; sigma: number } | null;
}
export interface ProbeFrame {
    step: number;
    lap: number;
    params: ProbeParams;
    /** The sensor in effect. */
    sensor: "range" | "range-bearing";
    room: { width: number; height: number };
    square: Vector[];
    /** Whether the next step moves. */
    moving: boolean;
    truth: Vector;
    estimate: Vector;
    P: Matrix;
    ellipse: Ellipse;
    /** Truth less estimate. */
    error: Vector;
    landmarks: { x: number; y: number; shown: boolean }[];
    sightings: ProbeSighting[];
    /** Jacobians at the present estimate, as if they lasted. */
    frozen: ProbeRanks;
    /** Stacked along the last 30 steps of the true path. */
    alongPath: ProbeRanks;
    /** m² and rad² added, the two apart, and the same for two range-only landmarks with Jacobians on the true path. */
    trace: {
        total: number; position: number; heading: number;
        reference: number; referencePosition: number; referenceHeading: number;
    };
    nees: number | null;
    nis: number | null;
    nisDof: number;
    /** Over the run: expected 3, and 1. */
    mean: { nees: number | null; nisPerDof: number | null };
    /** Where 95 % of a consistent filter's steps lie, [low, high] for 0 to 6 degrees of freedom; NaN for none. */
    bands: Vector[];
    /** The last 240 steps; NaN where there is none. */
    series: {
        step: Vector; trace: Vector; tracePosition: Vector; traceHeading: Vector; reference: Vector;
        nees: Vector; nis: Vector; nisDof: Vector;
    };
    /** The course of the last 241 positions, as the hook's. */
    tracks: { truth: Track; estimate: Track };
    slam: ProbeMap | null;
}
"#;

impl Decoded for labs::ObservabilityProbe {
    fn decode(arg: &Arg<'_>, base: ProbeParams) -> Result<ProbeParams, Error> {
        arg.only(&["landmarks", "count", "sensor", "stop", "forget", "tolerance", "seed"])?;
        let mut params = base;
        let sights = [("range", Sight::Range), ("range-bearing", Sight::RangeBearing)];
        arg.given("landmarks", points, &mut params.landmarks)?;
        arg.given("count", |a| a.whole(1, 3), &mut params.count)?;
        arg.given("sensor", |a| a.word(&sights), &mut params.sensor)?;
        arg.given("stop", |a| if a.is_null() { Ok(None) } else { a.whole(0, MAX_STEP).map(Some) }, &mut params.stop)?;
        arg.given("forget", |a| a.boolean(), &mut params.forget)?;
        arg.given("tolerance", |a| a.number(), &mut params.tolerance)?;
        arg.given("seed", |a| a.whole(0, u32::MAX), &mut params.seed)?;
        Ok(params)
    }
}

/// Three points of two numbers.
fn points(arg: &Arg<'_>) -> Result<[[f64; 2]; 3], Error> {
    let points: Vec<[f64; 2]> = arg.entries()?.iter().map(point).collect::<Result<_, _>>()?;
    points
        .try_into()
        .map_err(|_| Error::new(Code::Shape, "params.landmarks", "has not three points: the Probe has three"))
}

fn point(arg: &Arg<'_>) -> Result<[f64; 2], Error> {
    let numbers = arg.numbers()?;
    numbers.try_into().map_err(|_| Error::new(Code::Shape, "params.landmarks", "holds a point that is not [x, y]"))
}

lab_class! {
    "Rusty on a square in room A: which landmarks does it take to know where it is?",
    ObservabilityProbe: labs::ObservabilityProbe, "Partial<ProbeParams>", "ProbeFrame", "LabState<ProbeParams>"
}

#[wasm_bindgen]
impl ObservabilityProbe {
    /// Where landmark `j` (from 0) must stand to be in line with the estimate and the nearest other landmark shown.
    #[wasm_bindgen(js_name = collinearPoint, unchecked_return_type = "Vector")]
    pub fn collinear_point(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] j: &JsValue,
    ) -> Result<JsValue, JsValue> {
        let j = Arg::new(j, "j").whole(0, 2).map_err(thrown)?;
        let point = self.0.read(|lab| lab.collinear_point(j))?.map_err(thrown)?;
        plain(&point)
    }
}
