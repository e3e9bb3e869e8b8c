//! What a lab stands on when a program tries it.

use labs::LoggedDrive;
use std::error::Error;
use std::sync::Arc;

/// What a lab stands on, as the page has it.
pub trait Sample: Sized {
    /// That.
    ///
    /// # Errors
    /// Where a file of it cannot be read.
    fn sample() -> Result<Self, Box<dyn Error>>;
}

impl Sample for () {
    fn sample() -> Result<Self, Box<dyn Error>> {
        Ok(())
    }
}

/// The log that the page fetches.
impl Sample for Arc<LoggedDrive> {
    fn sample() -> Result<Self, Box<dyn Error>> {
        let log = robot_log::parse(include_str!("../../../../content/logs/plaza1.csv"))?;
        Ok(Arc::new(LoggedDrive::new(log.drive)))
    }
}
