//! The car's log, replayed to its end and smoothed under parameters that come as JSON: digest and frame, for the test
//! that compares the module with a native run.

mod read;

use lab::{Lab, Params, Shown};
use labs::{LogParams, LoggedDrive, RobotLog};
use serde_json::Value;
use std::error::Error;
use std::sync::Arc;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Value = serde_json::from_reader(std::io::stdin())?;
    let log = robot_log::parse(include_str!("../../../content/logs/car.csv"))?;
    let mut numbers = Vec::new();
    for parameter in LogParams::PARAMETERS {
        read::read(&parameter.shape, &given[parameter.name], &mut numbers).ok_or("no such parameter")?;
    }
    let params = LogParams::read(&mut numbers.iter());
    let mut lab = RobotLog::start(Arc::new(LoggedDrive::new(log.drive)), params)?;
    lab.run_all()?;
    lab.smooth()?;
    let digest = format!("{:016x}", lab.digest());
    println!("{}", serde_json::json!({ "digest": digest, "frame": Shown(&lab.frame()) }));
    Ok(())
}
