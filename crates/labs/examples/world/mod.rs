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

/// The log that the lab's figure fetches.
impl Sample for Arc<LoggedDrive> {
    fn sample(lab: &str) -> Result<Self, Box<dyn Error>> {
        let (car, mower) =
            (include_str!("../../../../content/logs/car.csv"), include_str!("../../../../content/logs/plaza1.csv"));
        let log = robot_log::parse(if lab == "car-log" { car } else { mower })?;
        Ok(Arc::new(LoggedDrive::new(log.drive)))
    }
}
