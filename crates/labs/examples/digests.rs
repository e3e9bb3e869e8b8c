//! Runs each lab for 10,000 steps (that of the log for as many rows), as it opens and as a reader may set it, and prints the hash of every number it records,
//! for the test that compares this machine's own code with wasm in Node and in browsers.

use labs::{
    BenchParams, Bug, GainBy, HookParams, Lab, LogParams, LoggedDrive, LoopParams, Mode, MuseumParams, OwnParams,
    ProbeParams, RobotLog, Sensor, SensorKind, TuneParams,
};
use std::sync::Arc;

fn print<L: Lab>(params: L::Params) -> Result<(), Box<dyn std::error::Error>> {
    let given = serde_json::to_string(&labs::Shown(&params))?;
    let mut lab = L::new(params)?;
    lab.run(10_000)?;
    println!("{} {:016x} {given}", L::NAME, lab.digest());
    Ok(())
}

/// The log that the page fetches.
fn print_log(params: LogParams) -> Result<(), Box<dyn std::error::Error>> {
    let given = serde_json::to_string(&labs::Shown(&params))?;
    let log = robot_log::parse(include_str!("../../../content/logs/plaza1.csv"))?;
    let lab = RobotLog::at(Arc::new(LoggedDrive::new(log.drive)), params, 10_000)?;
    println!("{} {:016x} {given}", RobotLog::NAME, labs::Experiment::hash(&lab));
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (bench, hook, probe) = (BenchParams::default(), HookParams::default(), ProbeParams::default());
    print::<labs::ObserverBench>(bench)?;
    print::<labs::ObserverBench>(BenchParams { sensor: Sensor::Position, mode: Mode::Filter, ..bench })?;
    print::<labs::OdometryHook>(hook)?;
    print::<labs::OdometryHook>(HookParams { fixes: true, ..hook })?;
    print::<labs::OdometryHook>(HookParams { fixes: true, learn: true, ..hook })?;
    print::<labs::ObservabilityProbe>(probe)?;
    print::<labs::ObservabilityProbe>(ProbeParams { count: 3, sensor: SensorKind::RangeBearing, ..probe })?;
    print::<labs::ObservabilityProbe>(ProbeParams { count: 3, forget: true, ..probe })?;
    print::<labs::ObservabilityProbe>(ProbeParams { ghost: true, ghost_around: 0.1, ghost_turn: 0.2, ..probe })?;
    print::<labs::LoopClosure>(LoopParams::default())?;
    print::<labs::LoopClosure>(LoopParams { correlated: false, found: 12.0, ..LoopParams::default() })?;
    print_log(LogParams::default())?;
    print_log(LogParams { gate: Some(0.999), learn: true, ..LogParams::default() })?;
    print::<labs::Tune>(TuneParams { length: 1000, committed: true, ..TuneParams::default() })?;
    print::<labs::BugMuseum>(MuseumParams::default())?;
    print::<labs::BugMuseum>(MuseumParams { bug: Bug::ShortForm, second: Bug::Transposed, ..MuseumParams::default() })?;
    print::<labs::OwnSystem>(OwnParams::default())?;
    print::<labs::OwnSystem>(OwnParams { gain: GainBy::Placement, input: 1.0, ..OwnParams::default() })
}
