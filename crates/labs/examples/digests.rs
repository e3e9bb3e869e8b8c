//! Runs each lab for 10,000 steps, as it opens and as a reader may set it, and prints the hash of every number it records,
//! for the test that compares this machine's own code with wasm in Node and in browsers.

use labs::{BenchParams, HookParams, Lab, LoopParams, Mode, ProbeParams, Sensor, SensorKind, TuneParams};

fn print<L: Lab>(params: L::Params) -> Result<(), Box<dyn std::error::Error>> {
    let given = serde_json::to_string(&labs::Shown(&params))?;
    let mut lab = L::new(params)?;
    lab.run(10_000)?;
    println!("{} {:016x} {given}", L::NAME, lab.digest());
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (bench, hook, probe) = (BenchParams::default(), HookParams::default(), ProbeParams::default());
    print::<labs::ObserverBench>(bench)?;
    print::<labs::ObserverBench>(BenchParams { sensor: Sensor::Position, mode: Mode::Filter, ..bench })?;
    print::<labs::OdometryHook>(hook)?;
    print::<labs::OdometryHook>(HookParams { fixes: true, ..hook })?;
    print::<labs::ObservabilityProbe>(probe)?;
    print::<labs::ObservabilityProbe>(ProbeParams { count: 3, sensor: SensorKind::RangeBearing, ..probe })?;
    print::<labs::ObservabilityProbe>(ProbeParams { count: 3, forget: true, ..probe })?;
    print::<labs::LoopClosure>(LoopParams::default())?;
    print::<labs::LoopClosure>(LoopParams { correlated: false, found: 12.0, ..LoopParams::default() })?;
    print::<labs::Tune>(TuneParams { length: 1000, committed: true, ..TuneParams::default() })
}
