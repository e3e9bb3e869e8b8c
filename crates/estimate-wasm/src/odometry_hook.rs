//! The odometry hook's class.

use crate::decode::Arg;
use crate::lab::{Decoded, lab_class};
use estimate::Error;
use labs::HookParams;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface HookParams {
    /** The right wheel's nominal radius exceeds its true one by this fraction, 0 to 0.01; default 0.005. */
    bias: number;
    /** One sigma of what each wheel slips in a tick, 0 to 0.005 m; default 0.001. */
    slip: number;
    /** Whether sightings of the mapped corners correct the estimate; default false. */
    fixes: boolean;
    /** A whole number below 2³²; default 1. */
    seed: number;
}
/** A pose [x, y, θ], metres and radians; a 3×3 covariance; the one-sigma ellipse of the position. */
export interface PoseBelief extends Belief { ellipse: Ellipse }
/** One reading of a corner at (x, y); the bearing is from the landmark. */
export interface CornerSighting { landmark: number; x: number; y: number; range: number; bearing: number }
export interface HookFrame {
    /** Ticks of 0.1 s; 640 are a lap. */
    step: number;
    time: number;
    /** Whole laps driven. */
    lap: number;
    params: HookParams;
    /** What does not change: walls as [x1, y1, x2, y2], rooms, mapped corners, the corners of the course. */
    world: {
        walls: Vector[];
        rooms: { name: string; x: number; y: number; width: number; height: number }[];
        corners: { id: number; x: number; y: number }[];
        loop: Vector[];
        /** The sensor's, in metres. */
        reach: number;
    };
    truth: Vector;
    estimate: Vector;
    P: Matrix;
    ellipse: Ellipse;
    /** This tick's belief before its fixes. */
    predicted: PoseBelief;
    /** [Δs, Δθ] as the encoders say; null at step 0. */
    u: Vector | null;
    /** The corners read in this tick, used or not: each is read once as it comes within reach. */
    sightings: CornerSighting[];
    /** The last corner read, in which tick and from where. */
    lastSighting: (CornerSighting & { step: number; from: Vector }) | null;
    /** Estimate minus truth: distance, and turn in (−π, π]. */
    error: { position: number; heading: number };
    /** One sigma as claimed. */
    sigma: { position: number; heading: number };
    /** |error| over sigma; null while nothing is claimed. */
    ratio: { position: number | null; heading: number | null };
    /** The course of the last 641 positions, oldest first: the fewest of them that miss none by more than a millimetre. */
    tracks: { truth: Track; estimate: Track };
    /** The estimate's ellipse every 40 ticks, the last 17. */
    trail: { step: number; x: Vector; ellipse: Ellipse }[];
    /** Every fourth tick, the last 240. */
    series: { step: Vector; position: Vector; heading: Vector; sigmaPosition: Vector; sigmaHeading: Vector };
}
"#;

impl Decoded for labs::OdometryHook {
    fn decode(arg: &Arg<'_>, base: HookParams) -> Result<HookParams, Error> {
        arg.only(&["bias", "slip", "fixes", "seed"])?;
        let mut params = base;
        arg.given("bias", |a| a.number(), &mut params.bias)?;
        arg.given("slip", |a| a.number(), &mut params.slip)?;
        arg.given("fixes", |a| a.boolean(), &mut params.fixes)?;
        arg.given("seed", |a| a.whole(0, u32::MAX), &mut params.seed)?;
        Ok(params)
    }
}

lab_class! {
    "A loop of the corridor on encoders with a biased wheel, with or without fixes from the mapped corners.",
    OdometryHook: labs::OdometryHook, "Partial<HookParams>", "HookFrame", "LabState<HookParams>"
}
