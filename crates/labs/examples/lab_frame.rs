//! Reads a lab's state from standard input, in the form a copied link carries it (`[version, lab, step, parameters]`),
//! and prints the frame this machine's own code computes for it, for the test that compares every readout of a figure in
//! the page with it. A number that is not finite is printed as null.

use labs::{BenchParams, HookParams, Lab, Mode, PictureParams, ProbeParams, Sensor, Sight, State};
use serde_json::Value;
use std::error::Error;
use std::io::Read;

type Answer<T> = Result<T, Box<dyn Error>>;

fn main() -> Answer<()> {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text)?;
    let (version, lab, step, params): (u32, String, u32, Value) = serde_json::from_str(&text)?;
    if version != 1 {
        return Err(format!("a state of version {version}; this knows version 1").into());
    }
    match lab.as_str() {
        labs::ObserverBench::NAME => print::<labs::ObserverBench>(step, bench(&params)?),
        labs::OdometryHook::NAME => print::<labs::OdometryHook>(step, hook(&params)?),
        labs::ObservabilityProbe::NAME => print::<labs::ObservabilityProbe>(step, probe(&params)?),
        labs::Picture::NAME => print::<labs::Picture>(step, picture(&params)?),
        _ => Err(format!("there is no lab {lab}").into()),
    }
}

fn print<L: Lab>(step: u32, params: L::Params) -> Answer<()> {
    let lab = L::from_state(State { params, step })?;
    println!("{}", serde_json::to_string(&lab.frame())?);
    Ok(())
}

fn bench(params: &Value) -> Answer<BenchParams> {
    let sensor = word(params, "sensor", &[("velocity", Sensor::Velocity), ("position", Sensor::Position)])?;
    let mode = word(params, "mode", &[("fixed", Mode::Fixed), ("filter", Mode::Filter)])?;
    Ok(BenchParams { sensor, mode, gain: read(params, "gain")?, seed: read(params, "seed")? })
}

fn hook(params: &Value) -> Answer<HookParams> {
    let (bias, slip) = (read(params, "bias")?, read(params, "slip")?);
    Ok(HookParams { bias, slip, fixes: read(params, "fixes")?, seed: read(params, "seed")? })
}

fn probe(params: &Value) -> Answer<ProbeParams> {
    Ok(ProbeParams {
        landmarks: read(params, "landmarks")?,
        count: read(params, "count")?,
        sensor: word(params, "sensor", &[("range", Sight::Range), ("range-bearing", Sight::RangeBearing)])?,
        stop: read(params, "stop")?,
        forget: read(params, "forget")?,
        tolerance: read(params, "tolerance")?,
        seed: read(params, "seed")?,
    })
}

fn picture(params: &Value) -> Answer<PictureParams> {
    Ok(PictureParams {
        mean: read(params, "mean")?,
        semi_major: read(params, "semiMajor")?,
        semi_minor: read(params, "semiMinor")?,
        angle: read(params, "angle")?,
        reading: read(params, "reading")?,
        noise: read(params, "noise")?,
        tilt: read(params, "tilt")?,
    })
}

/// The parameter `name`; every one must be there.
fn read<T: serde::de::DeserializeOwned>(params: &Value, name: &str) -> Answer<T> {
    let value = params.get(name).ok_or_else(|| format!("no parameter {name}"))?;
    serde_json::from_value(value.clone()).map_err(|e| format!("{name}: {e}").into())
}

/// The parameter `name`, one of the given words.
fn word<T: Copy>(params: &Value, name: &str, words: &[(&str, T)]) -> Answer<T> {
    let given: String = read(params, name)?;
    let found = words.iter().find(|(word, _)| *word == given);
    found.map(|(_, value)| *value).ok_or_else(|| format!("{name}: no {given}").into())
}
