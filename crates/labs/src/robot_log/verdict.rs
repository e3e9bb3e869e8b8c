//! The verdict on a log, as a worker goes on with it.

use super::{LogParams, LoggedDrive};
use estimate::Error;
use estimate::drive::{Judgement, Settings, Verdict};
use lab::Params;
use std::sync::Arc;

/// What is wrong with a log or its settings, a suspect at a time.
#[derive(Clone, Debug)]
pub struct LogVerdict {
    logged: Arc<LoggedDrive>,
    verdict: Verdict,
}

impl LogVerdict {
    /// A verdict on the log under `params`.
    ///
    /// # Errors
    /// As [`Verdict::new`], and where a parameter is out of its limits.
    pub fn new(logged: Arc<LoggedDrive>, params: LogParams) -> Result<Self, Error> {
        params.check()?;
        let verdict = Verdict::new(logged.drive(), Settings::from(params))?;
        let verdict = if logged.is_by_wheels() { verdict.by_wheels() } else { verdict };
        Ok(Self { logged, verdict })
    }

    /// Looks at the next suspect; whether there is more to do.
    ///
    /// # Errors
    /// As [`Verdict::step`].
    pub fn step(&mut self) -> Result<bool, Error> {
        self.verdict.step(self.logged.drive())
    }

    /// What has been found so far.
    pub fn found(&self) -> Judgement {
        self.verdict.found()
    }
}
