//! Write the filter: a reader's program, what the judge says of it, and its run beside a right filter's.

pub(crate) mod frame;
mod observer;
mod params;
mod programs;
mod view;
pub(crate) mod world;

pub use frame::{Verdict, WriteFault, WriteFrame, WriteMean, WriteName, WriteObserver, WriteSeries, WriteWorlds};
pub use params::{FilterWorld, Letters, MOST_BYTES, WriteParams};
pub use programs::Begin;
pub use world::{WriteBelief, WriteStep, WriteSystem, WriteWorld};

use crate::worlds::Run;
use estimate::{Code, Error};
use lab::series::Tracks;
use lab::{Digest, Lab, Params, kept, named};
use program::judge;
use program::{Fault, Notation, Program, Stop, World, relettered};
use std::rc::Rc;

/// How many of the last positions a track keeps.
const TRACK: usize = 500;
/// Beyond this an estimate or a standard deviation has left every bound, and the run stands still.
const DIVERGED: f64 = 1e9;

/// The lab.
#[derive(Clone, Debug)]
pub struct WriteFilter {
    params: WriteParams,
    step: u32,
    program: Program,
    right: Program,
    judged: Rc<Judged>,
    /// The program's run and the right filter's, of the same noise.
    runs: [Run; 2],
    stopped: Option<Fault>,
    series: WriteSeries,
    tracks: Tracks,
    digest: Digest,
}

/// What is said of a program, whatever its run.
#[derive(Clone, Debug)]
struct Judged {
    verdict: judge::Verdict,
    /// Of the text, or of its sizes in this world.
    faults: Vec<Fault>,
    observer: Option<WriteObserver>,
    made: Vec<String>,
    names_gain: bool,
    divides: bool,
}

/// The program that the parameters say.
fn program_of(params: &WriteParams) -> Program {
    Program::new(&text_of(params), params.begin.world().into(), params.notation.into())
}

fn text_of(params: &WriteParams) -> String {
    match &params.text {
        Some(text) => text.as_str().into(),
        None => {
            relettered(&params.begin.text(), params.begin.world().into(), [Notation::Choset, params.notation.into()])
        }
    }
}

impl Lab for WriteFilter {
    named! {
        "write-filter", WriteParams, WriteFrame, &[frame::INTERFACES, world::INTERFACES],
        "A filter that the reader writes, what is wrong with it, and its run beside a right filter's."
    }
    kept! {}

    fn start((): (), params: WriteParams) -> Result<Self, Error> {
        params.check()?;
        let world: World = params.begin.world().into();
        let program = program_of(&params);
        let run = Run::start(world, params.seed)?;
        let judged = Rc::new(view::judged(&program));
        let mut lab = Self {
            right: Program::new(&judge::right(world), world, Notation::Choset),
            stopped: judged.faults.first().cloned(),
            judged,
            program,
            params,
            step: 0,
            runs: [run.clone(), run],
            series: WriteSeries::default(),
            tracks: Tracks::default(),
            digest: Digest::default(),
        };
        lab.record();
        Ok(lab)
    }

    fn tried() -> Vec<Self::Params> {
        let open = WriteParams::default();
        vec![open, WriteParams { begin: Begin::Transposed, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        // On the right filter the judge stands: it has a value wherever a run leads.
        let [_, right] = &mut self.runs;
        let given = |_| Error::new(Code::NotFinite, "step", "the right filter has no value");
        right.next(&mut self.right).map_err(given)?;
        if self.stopped.is_none() {
            self.go_on();
        }
        self.record();
        Ok(())
    }

    fn frame(&self) -> WriteFrame {
        view::frame(self)
    }
}

impl WriteFilter {
    /// The worlds in which a program is counted.
    pub fn worlds(&self) -> crate::worlds::Worlds {
        crate::worlds::Worlds::new(&self.program)
    }

    /// The first steps of the run's world, on which the program is tested in another language.
    ///
    /// # Errors
    /// None, on the chapter's constants.
    pub fn world(&self) -> Result<WriteWorld, Error> {
        world::of(self)
    }

    /// The program's text in the letters of another notation.
    pub fn text_in(&self, letters: Letters) -> String {
        let notations = [self.params.notation.into(), letters.into()];
        relettered(self.program.text(), self.program.world(), notations)
    }

    /// The program's own step; a line without a value, or an answer out of every bound, ends its run.
    fn go_on(&mut self) {
        let [run, _] = &mut self.runs;
        self.stopped = match run.next(&mut self.program) {
            Err(Stop::Fault(fault) | Stop::Trouble(_, fault)) => Some(fault),
            Err(Stop::Given) => {
                Some(view::said("The program makes no estimate and no covariance of the world’s size."))
            }
            Ok(()) => {
                let (x, p) = &run.belief;
                let within = |entries: &[f64], most: f64| entries.iter().all(|entry| entry.abs() <= most);
                let bounded = within(&x.entries, DIVERGED) && within(&p.entries, DIVERGED * DIVERGED);
                (!bounded).then(|| view::said("The estimate has left every bound."))
            }
        };
    }

    fn record(&mut self) {
        let [run, right] = &self.runs;
        let (truth, x, p) = (run.truth(), &run.belief.0, &run.belief.1);
        self.digest.take(&truth);
        self.digest.take(&x.entries);
        self.digest.take(&p.entries);
        let driven = right.truth();
        self.tracks.truth.push(driven[0], driven[1], TRACK);
        if self.stopped.is_some() && self.step > 0 {
            return;
        }
        let error = run.error();
        let two_sigma = |i: usize| 2.0 * p.at(i, i).max(0.0).sqrt();
        let series = &mut self.series;
        series.step.push(f64::from(self.step));
        series.first.push(error[0]);
        series.second.push(error[1]);
        series.two_sigma_first.push(two_sigma(0));
        series.two_sigma_second.push(two_sigma(1));
        series.nees.push(run.nees().unwrap_or(f64::NAN));
        self.tracks.estimate.push(x.entries[0], x.entries[1], TRACK);
    }
}

#[cfg(test)]
mod tests;
