//! A reader's program in many worlds: does what it claims of itself fit its errors?
//!
//! A linear program runs on the chapter's rail robot with its position sensor, a robot's in the museum's stadium, whose
//! frame refuses a reading beyond the gate. A world is a seed, and worlds are counted one by one, so that whoever runs
//! them can show how far it has come, and stop.

pub(crate) mod linear;
mod run;
mod stadium;

pub(crate) use run::Run;

use crate::bug_museum;
use crate::ensemble::SEEDS;
use estimate::Error;
use filters::consistency::chi2_interval;
use program::words::Words;
use program::{Matrix, Program, Quantity, Step, Stop, World};
use sim::scenarios::BUG_MUSEUM;

/// Steps of a linear world.
const STEPS: u32 = 60;
/// In so many of a hundred cases the mean of right filters lies in its band.
const SHARE: f64 = 0.99;
/// A reading that is refused, or missing, is one whose variance is so many times as large.
const UNREAD: f64 = 1e12;

/// One number over worlds, beside a right filter's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// Where a right filter's lies in 99 of 100 cases.
    pub band: [f64; 2],
}

impl Mean {
    /// Whether it is one of a right filter's.
    pub fn fits(&self) -> bool {
        self.value >= self.band[0] && self.value <= self.band[1]
    }
}

/// What one world has shown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Shown {
    /// Σ eᵀP⁻¹e, and of how many steps; of a linear world the last step alone, which those of other worlds do not
    /// resemble.
    nees: (f64, u32),
    /// Σ νᵀS⁻¹ν over the readings that were used, and their number.
    nis: (f64, u32),
}

/// A program, and the worlds that it has been run in.
#[derive(Clone, Debug)]
pub struct Worlds {
    program: Program,
    /// The worlds so far.
    pub count: u32,
    /// Of each world the mean NEES, and the mean NIS where it has one.
    nees: Vec<f64>,
    nis: Vec<f64>,
    /// Worlds in which P was no covariance at the end of it.
    lost: u32,
    readings: u32,
}

impl Worlds {
    /// No world yet.
    pub fn new(program: &Program) -> Self {
        Self { program: program.clone(), count: 0, nees: Vec::new(), nis: Vec::new(), lost: 0, readings: 0 }
    }

    /// Whether all worlds have been counted.
    pub fn is_done(&self) -> bool {
        self.count >= SEEDS
    }

    /// Runs the program in the next world.
    ///
    /// # Errors
    /// [`Stop`], where the program has a fault or a line has no value; the worlds before it stay counted.
    pub fn next_world(&mut self) -> Result<(), Stop> {
        let shown = self.shown()?;
        self.count += 1;
        match shown.nees.1 {
            0 => self.lost += 1,
            steps => self.nees.push(shown.nees.0 / f64::from(steps)),
        }
        if shown.nis.1 > 0 {
            self.nis.push(shown.nis.0 / f64::from(shown.nis.1));
            self.readings += shown.nis.1;
        }
        Ok(())
    }

    /// The next world's run.
    fn shown(&mut self) -> Result<Shown, Stop> {
        let world = self.program.world();
        let mut run = Run::start(world, self.count).map_err(|_| Stop::Given)?;
        let mut shown = Shown::default();
        let steps = if world == World::Robot { BUG_MUSEUM.steps } else { STEPS };
        for k in 1..=steps {
            run.next(&mut self.program)?;
            if let Some(nis) = run.nis {
                shown.nis = (shown.nis.0 + nis, shown.nis.1 + 1);
            }
            let counts = world == World::Robot || k == steps;
            if let Some(nees) = run.nees().filter(|_| counts) {
                shown.nees = (shown.nees.0 + nees, shown.nees.1 + 1);
            }
        }
        Ok(shown)
    }

    /// The mean NEES over the worlds; none before the first, and where P was a covariance in none of them.
    ///
    /// # Errors
    /// Whatever the band's iteration answers; on these numbers, nothing.
    pub fn nees(&self) -> Result<Option<Mean>, Error> {
        self.mean(&self.nees, 3, |count| chi2_interval(2, count, SHARE))
    }

    /// The mean NIS over the worlds; none where the program does not make ν and S under these names.
    ///
    /// # Errors
    /// As [`Worlds::nees`].
    pub fn nis(&self) -> Result<Option<Mean>, Error> {
        self.mean(&self.nis, 4, |_| chi2_interval(1, self.readings, SHARE))
    }

    /// `figure` is the museum's number for it.
    fn mean(
        &self,
        values: &[f64],
        figure: usize,
        chi2: impl FnOnce(u32) -> Result<(f64, f64), filters::Error>,
    ) -> Result<Option<Mean>, Error> {
        if values.is_empty() {
            return Ok(None);
        }
        let count = values.len() as f64;
        let value = values.iter().sum::<f64>() / count;
        let band = match self.program.world() {
            World::Linear => chi2(values.len() as u32).map(|(low, high)| [low, high])?,
            World::Robot => {
                let (_, [mean, sigma]) = bug_museum::bands(figure);
                // 99 % of a normal distribution lie within 2.576 standard deviations.
                let off = 2.576 * sigma / count.sqrt();
                [mean - off, mean + off]
            }
        };
        Ok(Some(Mean { value, band }))
    }

    /// What is said of them.
    ///
    /// # Errors
    /// As [`Worlds::nees`].
    pub fn sentences(&self) -> Result<Vec<String>, Error> {
        let mut all = Vec::new();
        for (name, mean, low, high) in [
            (
                "NEES",
                self.nees()?,
                "the filter claims larger errors than it makes",
                "the filter’s errors are larger than it claims",
            ),
            ("NIS", self.nis()?, "its innovations are smaller than S says", "its innovations are larger than S says"),
        ] {
            let Some(mean) = mean else { continue };
            let mut words = Words::new("The mean ");
            words.text(name).text(" of ").whole(i64::from(self.count)).text(" worlds is ").number(mean.value);
            words.text("; a right filter’s lies from ").number(mean.band[0]).text(" to ").number(mean.band[1]);
            words.text(" in 99 of 100 cases");
            if !mean.fits() {
                words.text(": ").text(if mean.value < mean.band[0] { low } else { high });
            }
            all.push(words.text(".").0.clone());
        }
        if self.nis.is_empty() && self.count > 0 {
            let [nu, s] = [Quantity::Innovation, Quantity::S].map(|quantity| self.program.letter(quantity));
            let mut words = Words::new("The program does not make ");
            words.text(nu).text(" and ").text(s).text(" under these names, so there is no NIS");
            words.text(if self.program.world() == World::Robot { ", and no reading is refused." } else { "." });
            all.push(words.0);
        }
        if self.lost > 0 {
            let mut words = Words::new("In ");
            words.whole(i64::from(self.lost)).text(" of ").whole(i64::from(self.count));
            all.push(words.text(" worlds P is no covariance at the end.").0.clone());
        }
        Ok(all)
    }
}

/// νᵀS⁻¹ν of a step; none where the program does not name both, or where S is no covariance.
fn nis(program: &Program, step: &Step) -> Option<f64> {
    let [nu, s] = [Quantity::Innovation, Quantity::S].map(|quantity| program.made(step, quantity));
    squared(nu?, s?)
}

/// eᵀM⁻¹e; none where M is no covariance.
fn squared(e: &Matrix, m: &Matrix) -> Option<f64> {
    let m = nalgebra::DMatrix::from_row_slice(m.rows, m.columns, &m.entries);
    let factor = numerics::Spd::new(m)?;
    let value = factor.squared_length(&nalgebra::DVector::from_column_slice(&e.entries));
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests;
