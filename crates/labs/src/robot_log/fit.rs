//! The fit of a log's noise and delays, as a worker goes on with it.

use super::{LogParams, LoggedDrive};
use estimate::Error;
use estimate::drive::{Fit, FitResult, Fitted, Settings};
use lab::Params;
use std::sync::Arc;

/// A search for the σ and the delays under which a log's readings are likeliest, a replay at a time.
#[derive(Clone, Debug)]
pub struct LogFit {
    logged: Arc<LoggedDrive>,
    fit: Fit,
}

impl LogFit {
    /// A search that begins at `params`, for the usual numbers or for `only` these.
    ///
    /// # Errors
    /// As [`Fit::new`] and [`Fit::only`], and where a parameter is out of its limits.
    pub fn new(logged: Arc<LoggedDrive>, params: LogParams, only: Option<&[Fitted]>) -> Result<Self, Error> {
        params.check()?;
        let (drive, settings) = (logged.drive(), Settings::from(params));
        let fit = only.map_or_else(|| Fit::new(drive, settings), |only| Fit::only(drive, settings, only))?;
        Ok(Self { logged, fit })
    }

    /// Replays the log once more; whether there is more to do.
    ///
    /// # Errors
    /// As [`Fit::step`].
    pub fn step(&mut self) -> Result<bool, Error> {
        self.fit.step(self.logged.drive())
    }

    /// What has been found so far.
    pub fn found(&self) -> FitResult {
        self.fit.found()
    }
}
