//! The verdict on a log, which a worker goes on with suspect by suspect.

use crate::encode::{list, record};
use crate::errors::Thrown;
use crate::lab::RobotLog;
use crate::object::Held;
use crate::robot_log::logged;
use estimate::drive::{
    Against, Correlated, Gaps, Judgement, Noise, Sensor, Size, Standing, Stretch, Suspect, Thinning, Times,
};
use js_sys::Array;
use lab::Params;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A fault that was looked for in a log. */
export interface LogSuspect {
    fault: 'start' | 'clock' | 'bias' | 'scale' | 'odometry' | 'lengths' | 'wheel-size' | 'turn-scale'
        | 'unequal-wheels' | 'antenna' | 'tails' | 'sigma' | 'turned' | 'mirrored' | 'mirrored-bearings' | 'exchanged'
        | 'landmark-bias' | 'displaced';
    /**
     * The parameter that mends it; null of the start, and where none does. Of outliers, which a gate refuses, the σ of
     * their sensor, where that is another one behind the gate.
     */
    name: string | null;
    /** What mends it together with that one; of three sensors that are late together the second; beside an antenna. */
    with: string | null;
    /** The sensor that has outliers, else null. */
    sensor: 'fix' | 'heading' | 'range' | 'bearing' | null;
    /** The ids of two landmarks that are exchanged, or of the one that is displaced or biased, else null. */
    landmarks: number[] | null;
    /**
     * As it is set, where the readings are likeliest, and how well they tell it, null where they do not: of each
     * parameter; of the start x, y and θ in metres and radians; of a landmark x and y, or by how much its
     * ranges are too long; of outliers their share, and that σ; of
     * odometry the shares by which distances and, where it turns, turns are larger than they are read, and of turn
     * rates that share; of unequal wheels by how much more the robot turns to its left on each metre than is read,
     * radians; of the antenna how far ahead and to the left it stands, metres, and that delay. Empty where
     * nothing is set.
     */
    sizes: {
        now: number; value: number; sigma: number | null;
        /** Whether it is the last value that is tried: the readings are likeliest there or beyond. */
        end: boolean;
    }[];
    /**
     * Of a scale, how many times what is there is read, how well that is known, and what the filter takes it for as it
     * is set; and the unit that it may be in, with the one in which it is then taken. Else null.
     */
    times: { value: number; sigma: number | null; set: number; unit: [string, string] | null } | null;
    /** Of a factor on the σ that readings bring: the least of these, their median and the greatest; else null. */
    claims: [number, number, number] | null;
    /** Of a share of the turns by how much noise of what is read makes them look larger; its σ counts it. Else null. */
    dilution: number | null;
    /** By how much the log-likelihood of the readings rises where it is freed. */
    gain: number;
    /**
     * By how much that is more than chance brings in 97 of 100 logs without a fault; 0 at most where no size is two of
     * its own standard deviations away from what is set.
     */
    excess: number;
    /** Whether it is the one, may be one, or is no likelier than chance explains. */
    standing: 'sure' | 'maybe' | 'cleared';
    /**
     * Whether it may be the motion model's own, half a step between rows of motion: a delay of at most that is cleared,
     * and a longer one may be it where that and chance make the readings as likely. Of a share of odometry's turns,
     * whether noise of the turns does the same.
     */
    own: boolean;
    /** From where to where the likelihood of a delay is the same, where the motion has too few rows to tell more. */
    flat: [number, number] | null;
    /** How far the mended filter is from the truth, of those that were held against it, where there is a truth. */
    mended: LogAgainst | null;
}

/** How far a filter is from the truth. */
export interface LogAgainst {
    /** Root of the mean squared distance, metres. */
    rmse: number;
    /** The mean of eᵀP⁻¹e of the position, 2 if P is right. */
    nees: number;
    /** The share of the errors beyond the ellipse that should hold 95 of 100. */
    outside: number;
}

/** A stretch that stands out, seconds since the first row: what it has there, and the others have. */
export interface LogStretch {
    times: [number, number];
    there: number;
    elsewhere: number;
}

/** What of the innovations does not look like noise. */
export interface LogNoise {
    /** Where NIS for each output is high. */
    nis: LogStretch | null;
    /** Where gates refuse more than elsewhere, as a share. */
    refused: LogStretch | null;
    /** The sensor whose innovations are correlated most from one to the next: by how much, and what chance gives. */
    correlated: { sensor: 'fix' | 'heading' | 'range' | 'bearing'; by: number; chance: number } | null;
}

/** What is wrong with a log or its settings. */
export interface LogJudgement {
    /** All that was looked for, the likeliest fault first; empty until all were looked at. */
    suspects: LogSuspect[];
    /** Readings that are counted. */
    readings: number;
    /** Rows that are judged, from the first on. */
    rows: number;
    /** Suspects that were tried, and how many there are. */
    tried: [number, number];
    /** How far the filter is from the truth as it is set; null without a truth. */
    against: LogAgainst | null;
    /** Whether gates were off, because they refuse more than one reading in ten. */
    ungated: boolean;
    /** Whether what the first suspect gains is counted beside a σ that is enlarged. */
    beside: boolean;
    /**
     * Where fixes go together so that they tell no fault, or (`either`) may have a smaller σ: the least time in seconds
     * between those that do not, how far neighbouring innovations are correlated, of all and of those, and how many
     * there are and how many that err apart tell as much. Else null.
     */
    thinning: { every: number; by: [number, number]; counts: [number, number]; either: boolean } | null;
    /**
     * By how much the log-likelihood rises where the robot turns on its way between two rows of motion; null where that
     * is no more than chance. The motion model drives straight and turns then.
     */
    arcs: number | null;
    /** The median time between rows of motion, seconds. */
    period: number;
    /** A delay of at most this may be the motion model's own, seconds: half of that, or all of it. */
    ownDelay: number;
    /** The mean distance of a second in which the robot drives, metres. */
    pace: number;
    /**
     * Half of the mean turn of a step, radians, by which the filter takes a sensor of bearings to be turned; 0 where
     * the sizes are those of a robot that turns on its way.
     */
    halfTurn: number;
    /** What of the innovations does not look like noise, once all was looked at. */
    noise: LogNoise;
    /**
     * Where no motion was read, by what is missing: how many gaps, from when to when the longest is, and the longest
     * stretch between them, seconds since the first row.
     */
    gaps: {
        what: 'held' | 'speed' | 'turn rate' | 'odometry'; count: number; longest: [number, number];
        between: [number, number];
    }[];
    /** Whether no suspect, mended, brings the filter nearer to the truth: something else is wrong. */
    other: boolean;
}
"#;

/// A verdict on a log: each number that may be wrong is freed by itself, and the readings say which of them makes them
/// likelier, and by how much.
#[wasm_bindgen]
#[repr(transparent)]
pub struct LogVerdict(Held);

const VERDICT: &str = "LogVerdict";

#[wasm_bindgen]
impl LogVerdict {
    /// A verdict on the log under `params`; what they leave out takes its default.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "DriveLog")] log: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Partial<LogParams>")] params: &JsValue,
    ) -> Result<LogVerdict, Thrown> {
        let log = logged(log)?;
        let params = RobotLog::params(params)?;
        let verdict = labs::LogVerdict::new(Arc::clone(&log), Params::read(&mut params.iter()));
        Ok(Self(Held::new(VERDICT, verdict.map_err(|e| e.within("params"))?)))
    }

    /// Looks at the next suspect, by one to some twenty replays; whether there is more to do.
    pub fn step(&self) -> Result<bool, Thrown> {
        self.0.write(VERDICT, labs::LogVerdict::step)
    }

    /// What has been found so far.
    #[wasm_bindgen(unchecked_return_type = "LogJudgement")]
    pub fn found(&self) -> Result<JsValue, Thrown> {
        self.0.read(VERDICT, |verdict: &labs::LogVerdict| shown(&verdict.found()))
    }
}

fn shown(judgement: &Judgement) -> JsValue {
    record(&[
        ("suspects", judgement.suspects.iter().map(suspect).collect::<Array>().into()),
        ("readings", judgement.readings.into()),
        ("rows", judgement.rows.into()),
        ("tried", list(&judgement.tried.map(f64::from))),
        ("against", against(judgement.against)),
        ("ungated", judgement.ungated.into()),
        ("beside", judgement.beside.into()),
        ("thinning", judgement.thinning.map_or(JsValue::NULL, thinning)),
        ("arcs", judgement.arcs.map_or(JsValue::NULL, Into::into)),
        ("period", judgement.period.into()),
        ("ownDelay", judgement.own_delay.into()),
        ("pace", judgement.pace.into()),
        ("halfTurn", judgement.half_turn.into()),
        ("noise", noise(&judgement.noise)),
        ("gaps", judgement.gaps.iter().map(gap).collect::<Array>().into()),
        ("other", judgement.other.into()),
    ])
}

fn named(sensor: Sensor) -> &'static str {
    match sensor {
        Sensor::Fix => "fix",
        Sensor::Heading => "heading",
        Sensor::Range => "range",
        Sensor::Bearing => "bearing",
    }
}

fn noise(noise: &Noise) -> JsValue {
    let stretch = |it: Option<Stretch>| {
        it.map_or(JsValue::NULL, |Stretch { times, there, elsewhere }| {
            record(&[("times", list(&times)), ("there", there.into()), ("elsewhere", elsewhere.into())])
        })
    };
    let correlated = noise.correlated.map_or(JsValue::NULL, |Correlated { sensor, by, chance }| {
        record(&[("sensor", named(sensor).into()), ("by", by.into()), ("chance", chance.into())])
    });
    record(&[("nis", stretch(noise.nis)), ("refused", stretch(noise.refused)), ("correlated", correlated)])
}

fn suspect(suspect: &Suspect) -> JsValue {
    let sensor = suspect.sensor.map(named);
    let standing = match suspect.standing {
        Standing::Sure => "sure",
        Standing::Maybe => "maybe",
        Standing::Cleared => "cleared",
    };
    record(&[
        ("fault", suspect.fault.name().into()),
        ("name", suspect.number.map_or(JsValue::NULL, |number| number.name().into())),
        ("with", suspect.with.map_or(JsValue::NULL, |number| number.name().into())),
        ("sensor", sensor.map_or(JsValue::NULL, Into::into)),
        ("landmarks", landmarks(&suspect.landmarks)),
        ("sizes", suspect.sizes.iter().map(size).collect::<Array>().into()),
        ("times", suspect.times().map_or(JsValue::NULL, times)),
        ("claims", suspect.claims.map_or(JsValue::NULL, |claims| list(&claims))),
        ("dilution", suspect.dilution.map_or(JsValue::NULL, Into::into)),
        ("gain", suspect.gain.into()),
        ("excess", suspect.excess.into()),
        ("standing", standing.into()),
        ("own", suspect.own.into()),
        ("flat", suspect.flat.map_or(JsValue::NULL, |flat| list(&flat))),
        ("mended", against(suspect.mended)),
    ])
}

fn landmarks(ids: &[u32]) -> JsValue {
    let ids: Vec<f64> = ids.iter().copied().map(f64::from).collect();
    if ids.is_empty() { JsValue::NULL } else { list(&ids) }
}

fn gap(gaps: &Gaps) -> JsValue {
    let (longest, between) = (list(&gaps.longest), list(&gaps.between));
    record(&[
        ("what", gaps.what.name().into()),
        ("count", gaps.count.into()),
        ("longest", longest),
        ("between", between),
    ])
}

fn size(Size { now, value, sigma, end }: &Size) -> JsValue {
    let sigma = if sigma.is_finite() { (*sigma).into() } else { JsValue::NULL };
    record(&[("now", (*now).into()), ("value", (*value).into()), ("sigma", sigma), ("end", (*end).into())])
}

fn times(Times { value, sigma, set, unit }: Times) -> JsValue {
    let sigma = if sigma.is_finite() { sigma.into() } else { JsValue::NULL };
    let names = |unit: [&str; 2]| unit.iter().map(|name| JsValue::from(*name)).collect::<Array>().into();
    record(&[
        ("value", value.into()),
        ("sigma", sigma),
        ("set", set.into()),
        ("unit", unit.map_or(JsValue::NULL, names)),
    ])
}

fn thinning(Thinning { every, by, counts, either, .. }: Thinning) -> JsValue {
    let [by, counts] = [by, counts].map(|pair| list(&pair));
    record(&[("every", every.into()), ("by", by), ("counts", counts), ("either", either.into())])
}

fn against(against: Option<Against>) -> JsValue {
    against.map_or(JsValue::NULL, |Against { rmse, nees, outside }| {
        record(&[("rmse", rmse.into()), ("nees", nees.into()), ("outside", outside.into())])
    })
}
