//! Reads a lab's state from standard input, in the form a copied link carries it (`[version, lab, step, parameters]`),
//! and prints the frame this machine's own code computes for it, for the test that compares every readout of a figure in
//! the page with it. A number that is not finite is printed as null.

use labs::{
    BugMuseum, Lab, LogParams, LoggedDrive, LoopClosure, ObservabilityProbe, ObserverBench, OdometryHook, OwnSystem,
    Params, Picture, RobotLog, Shape, Shown, State, Tune,
};
use serde_json::Value;
use std::error::Error;
use std::io::Read;
use std::sync::Arc;

type Answer<T> = Result<T, Box<dyn Error>>;

fn main() -> Answer<()> {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text)?;
    let (version, lab, step, params): (u32, String, u32, Value) = serde_json::from_str(&text)?;
    if version != 1 {
        return Err(format!("a state of version {version}; this knows version 1").into());
    }
    match lab.as_str() {
        ObserverBench::NAME => print::<ObserverBench>(step, &params),
        OdometryHook::NAME => print::<OdometryHook>(step, &params),
        ObservabilityProbe::NAME => print::<ObservabilityProbe>(step, &params),
        Picture::NAME => print::<Picture>(step, &params),
        LoopClosure::NAME => print::<LoopClosure>(step, &params),
        OwnSystem::NAME => print::<OwnSystem>(step, &params),
        Tune::NAME => print::<Tune>(step, &params),
        BugMuseum::NAME => print::<BugMuseum>(step, &params),
        RobotLog::NAME => print_log(step, &params),
        _ => Err(format!("there is no lab {lab}").into()),
    }
}

fn print<L: Lab>(step: u32, params: &Value) -> Answer<()> {
    let lab = L::from_state(State { params: given(params)?, step })?;
    println!("{}", serde_json::to_string(&Shown(&lab.frame()))?);
    Ok(())
}

/// The lab of the log that the page fetches.
fn print_log(step: u32, params: &Value) -> Answer<()> {
    let log = robot_log::parse(include_str!("../../../content/logs/plaza1.csv"))?;
    let lab = RobotLog::at(Arc::new(LoggedDrive::new(log.drive)), given::<LogParams>(params)?, step)?;
    println!("{}", serde_json::to_string(&Shown(&lab.frame()))?);
    Ok(())
}

fn given<P: Params>(params: &Value) -> Answer<P> {
    let mut numbers = Vec::new();
    for parameter in P::PARAMETERS {
        read(&parameter.shape, &params[parameter.name], &mut numbers)
            .ok_or_else(|| format!("no {}", parameter.name))?;
    }
    Ok(P::read(&mut numbers.iter()))
}

/// Appends the numbers of a parameter, every one of which must be there.
fn read(shape: &Shape, value: &Value, to: &mut Vec<f64>) -> Option<()> {
    match shape {
        Shape::Number | Shape::Whole => to.push(value.as_f64()?),
        Shape::Flag => to.push(f64::from(value.as_bool()?)),
        Shape::Word(words) => to.push(words.iter().position(|word| value == word)? as f64),
        Shape::Maybe(_) if value.is_null() => to.push(0.0),
        Shape::Maybe(inner) => {
            to.push(1.0);
            read(inner, value, to)?;
        }
        Shape::Exactly(n, entry) => {
            let entries = value.as_array().filter(|entries| entries.len() == *n)?;
            entries.iter().try_for_each(|each| read(entry, each, to))?;
        }
        Shape::Text | Shape::List(_) | Shape::Record(..) => return None,
    }
    Some(())
}
