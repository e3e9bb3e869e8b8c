//! What a lab stands on when a program tries it.

use labs::LoggedDrive;
use std::error::Error;
use std::sync::Arc;

/// What a lab stands on, as the page has it.
pub trait Sample: Sized {
    /// That of the lab of this name.
    ///
    /// # Errors
    /// Where a file of it cannot be read.
    fn sample(_lab: &str) -> Result<Self, Box<dyn Error>>;
}

impl Sample for () {
    fn sample(_lab: &str) -> Result<Self, Box<dyn Error>> {
        Ok(())
    }
}

/// The log that the lab's figure fetches; one that has none here is an error, and no test passes on another's log.
impl Sample for Arc<LoggedDrive> {
    fn sample(lab: &str) -> Result<Self, Box<dyn Error>> {
        let text = match lab {
            "robot-log" => include_str!("../../../../content/logs/plaza1.csv"),
            "car-log" => include_str!("../../../../content/logs/car.csv"),
            _ => return Err(format!("crates/labs/examples/world has no log for {lab}").into()),
        };
        Ok(Arc::new(LoggedDrive::new(robot_log::parse(text)?.drive)))
    }
}
