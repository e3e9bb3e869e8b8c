//! Every number the prose prints, each with what computes it and the check that pins it.

mod car;
mod detectability;
mod ensembles;
mod exercises;
mod hook;
mod late;
mod log;
mod loops;
mod maps;
mod museum;
mod probe;
mod rail;
mod robot;
mod scenarios;
mod tune;
mod wheel;

use crate::givens::Givens;
use estimate::Error;
use lab::{Listing, Number};

/// All numbers, computed from `givens`.
///
/// # Errors
/// Whatever the core answers; on the chapter's constants, nothing.
pub fn numbers(givens: &Givens) -> Result<Vec<Number>, Error> {
    let mut listing = Listing::new();
    rail::list(givens, &mut listing)?;
    detectability::list(givens, &mut listing)?;
    exercises::list(givens, &mut listing)?;
    robot::list(givens, &mut listing)?;
    hook::list(&mut listing)?;
    wheel::list(&mut listing)?;
    log::list(&mut listing)?;
    late::list(&mut listing)?;
    probe::list(givens, &mut listing)?;
    maps::list(givens, &mut listing)?;
    scenarios::list(givens, &mut listing);
    museum::constants(&mut listing);
    Ok(listing.numbers)
}

/// All numbers, and those of the ensembles too, which take some seconds on an optimized build: each topic has a thread
/// to itself.
///
/// # Errors
/// As [`numbers`].
pub fn with_ensembles(givens: &Givens) -> Result<Vec<Number>, Error> {
    let topics = [ensembles::list, car::list, late::ensembles, loops::list, tune::list, museum::list];
    let listed = |list: fn(&mut Listing) -> Result<(), Error>| {
        let mut listing = Listing::new();
        list(&mut listing).map(|()| listing.numbers)
    };
    std::thread::scope(|scope| {
        let threads = topics.map(|list| scope.spawn(move || listed(list)));
        let mut all = numbers(givens)?;
        for thread in threads {
            all.extend(thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))?);
        }
        Ok(all)
    })
}

#[cfg(test)]
mod tests;
