//! Logs with one fault planted in each, or none: what a verdict on a log is tried by.

mod fault;
mod world;

pub use fault::{Case, FAULTS, corrupted, planted, sound};
pub use world::{ARCS, Log, WORLDS, World};

use estimate::Error;
use estimate::drive::{Judgement, Verdict};

/// How many logs have each fault.
pub const EACH: u64 = 30;
/// How many have none.
pub const SOUND: u64 = 70;

/// The verdict on a log.
///
/// # Errors
/// The log cannot be replayed.
pub fn judged(Log { drive, settings }: &Log) -> Result<Judgement, Error> {
    let mut verdict = Verdict::new(drive, *settings)?;
    while verdict.step(drive)? {}
    Ok(verdict.found())
}
