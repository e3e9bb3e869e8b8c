//! How many rows of the mower's log are replayed in a second natively: by the filter alone, and by the lab, which
//! replays dead reckoning beside it and keeps what the figure shows. One round, as JSON, for `scripts/bench-log.mjs`.

use estimate::drive::{Course, Replay, Settings};
use lab::Lab;
use labs::{LogParams, LoggedDrive, RobotLog};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

/// How often the log is replayed in a round.
const TIMES: u32 = 20;

fn main() -> Result<(), Box<dyn Error>> {
    let text = include_str!("../../../content/logs/plaza1.csv");
    let drive = robot_log::parse(text)?.drive;
    let rows = drive.rows.len() as f64;
    let mut rmse = None;
    let mut filter = || -> Result<(), Box<dyn Error>> {
        let course = Course::new(&drive, Settings::default())?;
        let mut replay = Replay::new(&course);
        while replay.take(&drive, &course)?.is_some() {}
        rmse = replay.summary(&course).rmse;
        Ok(())
    };
    let rate = |f: &mut dyn FnMut() -> Result<(), Box<dyn Error>>| -> Result<f64, Box<dyn Error>> {
        f()?;
        let start = Instant::now();
        for _ in 0..TIMES {
            f()?;
        }
        Ok(rows * f64::from(TIMES) / start.elapsed().as_secs_f64())
    };
    let alone = rate(&mut filter)?;
    let logged = Arc::new(LoggedDrive::new(robot_log::parse(text)?.drive));
    let lab = rate(&mut || Ok(RobotLog::start(Arc::clone(&logged), LogParams::default())?.run_all()?))?;
    println!("{{ \"filter\": {alone:.0}, \"lab\": {lab:.0}, \"rmse\": {} }}", rmse.unwrap_or(f64::NAN));
    Ok(())
}
