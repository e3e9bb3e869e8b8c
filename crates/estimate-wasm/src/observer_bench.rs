//! The Observer Bench's class.

use crate::decode::Arg;
use crate::lab::{Decoded, lab_class};
use estimate::Error;
use labs::{BenchParams, Mode, Sensor};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface BenchParams {
    /** What the sensor measures; default "velocity". */
    sensor: "velocity" | "position";
    /** Who chooses the gain; default "fixed". */
    mode: "fixed" | "filter";
    /** The knob g in K = g · R∞, from 0 to 8; default 1. */
    gain: number;
    /** A whole number below 2³²; default 1. */
    seed: number;
}
export interface BenchBelief extends Belief { ellipse: Ellipse }
export interface BenchFrame {
    step: number;
    /** Seconds. */
    time: number;
    params: BenchParams;
    /** The run left every reasonable bound and stands still. */
    diverged: boolean;
    /** Position in metres, velocity in metres per second. */
    truth: Vector;
    /** Null at step 0, as all that depends on it. */
    reading: number | null;
    predicted: BenchBelief;
    posterior: BenchBelief;
    innovation: number | null;
    S: number | null;
    /** The gain used in this step (in the next one, at step 0). */
    R: Vector;
    /** The filter's own R(k). */
    filterGain: Vector;
    /** R∞ */
    steadyGain: Vector;
    /** The one row of H. */
    H: Vector;
    mostLikelyOutput: number | null;
    /** The points of Ω nearest to the prediction in either metric. */
    feet: { euclidean: Vector; mahalanobis: Vector } | null;
    /** Of (I − KH)F. */
    eigenvalues: Complex[];
    spectralRadius: number;
    /** Which eigenvalue no gain moves. */
    pinned: number | null;
    /** Every eigenvalue that a gain can move is inside the unit disc. */
    stable: boolean;
    /** The knob at which the last movable eigenvalue leaves the disc. */
    stableUpTo: number;
    /** HK / HR∞: the setting of the knob that takes over the same share of the innovation as the gain in use. */
    equivalentKnob: number;
    /** The last 240 steps. */
    series: {
        step: Vector; r1: Vector; r2: Vector; p11: Vector; p22: Vector; e1: Vector; e2: Vector; knob: Vector;
    };
}
"#;

impl Decoded for labs::ObserverBench {
    fn decode(arg: &Arg<'_>, base: BenchParams) -> Result<BenchParams, Error> {
        arg.only(&["sensor", "mode", "gain", "seed"])?;
        let mut params = base;
        let sensors = [("velocity", Sensor::Velocity), ("position", Sensor::Position)];
        arg.given("sensor", |a| a.word(&sensors), &mut params.sensor)?;
        arg.given("mode", |a| a.word(&[("fixed", Mode::Fixed), ("filter", Mode::Filter)]), &mut params.mode)?;
        arg.given("gain", |a| a.number(), &mut params.gain)?;
        arg.given("seed", |a| a.whole(0, u32::MAX), &mut params.seed)?;
        Ok(params)
    }
}

lab_class! {
    "The rail robot of §8.2.6 under an observer whose gain the reader sets, or the filter does.",
    ObserverBench: labs::ObserverBench, "Partial<BenchParams>", "BenchFrame", "LabState<BenchParams>"
}
