//! What is said of a program and shown of its run.

use super::params::{FilterWorld, WriteParams};
use crate::worlds::{Mean, Worlds};
use estimate::{Error, Landmark};
use geom::Ellipse;
use lab::record;
use lab::series::{Series, Tracks};
use program::Fault;
use program::judge::Outcome;

lab::worded! {
    Verdict {
        Refused = "refused",
        Right = "right",
        Bug = "bug",
        Unfinished = "unfinished",
        Wrong = "wrong",
    }
}

/// What a program is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It has faults, or no value.
    Refused,
    /// It gives what a right filter gives.
    Right,
    /// It gives what a bug of the museum gives.
    Bug,
    /// What stands there is right, and no line corrects the estimate or its covariance by the reading yet.
    Unfinished,
    /// It gives something else.
    Wrong,
}

impl From<Outcome> for Verdict {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Refused => Self::Refused,
            Outcome::Right => Self::Right,
            Outcome::Bug(_) => Self::Bug,
            Outcome::Unfinished => Self::Unfinished,
            Outcome::Wrong => Self::Wrong,
        }
    }
}

record! {
    /// A program, what the judge says of it, and its run.
    pub struct WriteFrame {
        /// Steps of the run that are made.
        pub step: u32,
        /// What the reader has set.
        pub params: WriteParams,
        /// The program.
        pub text: String,
        /// The world that it is for.
        pub world: FilterWorld,
        /// What the world gives.
        pub given: Vec<WriteName>,
        /// What the program makes, in the order of its lines; each name once.
        pub made: Vec<String>,
        /// What is wrong with the text.
        pub faults: Vec<WriteFault>,
        /// What the program is.
        pub outcome: Verdict,
        /// The museum's word for the bug that it has, or none.
        pub bug: Option<&'static str>,
        /// The line to look at, from 1.
        pub line: Option<u32>,
        /// Why, in sentences.
        pub sentences: Vec<String>,
        /// Whether a right form loses its digits where the prior knows nothing.
        pub breaks: bool,
        /// Whether the program names its gain, makes a right filter's by another name, or has its S in a line.
        pub names_gain: bool,
        /// Whether a line divides by a matrix of more than one row, or inverts one.
        pub divides: bool,
        /// What it is as an observer, where its gain depends on nothing.
        pub observer: Option<WriteObserver>,
        /// Why the run stands still, where it does.
        pub stopped: Option<WriteFault>,
        /// The true state.
        pub truth: Vec<f64>,
        /// The program's estimate; where its run stands still, the last one.
        pub estimate: Vec<f64>,
        /// The one-sigma ellipse of the first two states that it claims; none where P is no covariance, or its run
        /// stands still.
        pub ellipse: Option<Ellipse>,
        /// A right filter's estimate of the same readings.
        pub right: Vec<f64>,
        /// Its ellipse.
        pub right_ellipse: Option<Ellipse>,
        /// The landmarks; none on the rail.
        pub landmarks: &'static [Landmark],
        /// The landmark that was sighted in this step.
        pub sighted: Option<u32>,
        /// Whether the gate let the reading in.
        pub used: bool,
        /// eᵀP⁻¹e; none where P is no covariance, or its run stands still.
        pub nees: Option<f64>,
        /// The run so far.
        pub series: WriteSeries,
        /// Where truth and estimate have been, in the first two states.
        pub tracks: Tracks,
    }

    /// A name that the world gives.
    pub struct WriteName {
        /// The name.
        pub name: &'static str,
        /// What it is.
        pub about: &'static str,
        /// Rows and columns.
        pub size: String,
    }

    /// A fault of a text.
    pub struct WriteFault {
        /// The line, from 1.
        pub line: u32,
        /// Where it begins in its line, from 1, in characters.
        pub column: u32,
        /// How many characters it takes.
        pub length: u32,
        /// What is wrong.
        pub message: String,
    }

    /// A filter whose gain depends on nothing, on the rail.
    #[derive(Copy)]
    pub struct WriteObserver {
        /// Its gain.
        pub gain: [f64; 2],
        /// The spectral radius of its error: below 1 the error dies out.
        pub radius: f64,
        /// Whether its P is the covariance of its error.
        pub honest: bool,
    }

    /// The steps of the run.
    #[derive(Default)]
    pub struct WriteSeries {
        /// Step.
        pub step: Series,
        /// Truth less estimate of the first state.
        pub first: Series,
        /// Two standard deviations of it, as claimed; 0 where P has a negative variance.
        pub two_sigma_first: Series,
        /// Of the second.
        pub second: Series,
        /// Likewise.
        pub two_sigma_second: Series,
        /// eᵀP⁻¹e; NaN where P is no covariance.
        pub nees: Series,
    }

    /// A mean over many worlds.
    #[derive(Copy)]
    pub struct WriteMean {
        /// The mean.
        pub value: f64,
        /// Where a right filter's lies in 99 of 100 cases.
        pub band: [f64; 2],
    }

    /// What many worlds say of a program.
    pub struct WriteWorlds {
        /// How many have been run.
        pub count: u32,
        /// The mean NEES.
        pub nees: Option<WriteMean>,
        /// The mean NIS; none where the program does not name innovation and covariance.
        pub nis: Option<WriteMean>,
        /// What is said of them.
        pub sentences: Vec<String>,
    }
}

impl From<&Fault> for WriteFault {
    fn from(fault: &Fault) -> Self {
        let Fault { line, column, length, message } = fault;
        Self { line: *line, column: *column, length: *length, message: message.clone() }
    }
}

impl From<Mean> for WriteMean {
    fn from(mean: Mean) -> Self {
        Self { value: mean.value, band: mean.band }
    }
}

impl WriteWorlds {
    /// What the worlds so far say.
    ///
    /// # Errors
    /// As [`Worlds::nees`].
    pub fn of(worlds: &Worlds) -> Result<Self, Error> {
        let mean = |mean: Option<Mean>| mean.map(WriteMean::from);
        Ok(Self {
            count: worlds.count,
            nees: mean(worlds.nees()?),
            nis: mean(worlds.nis()?),
            sentences: worlds.sentences()?,
        })
    }
}
