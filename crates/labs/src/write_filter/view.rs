//! From a program and its run to the frame.

use super::frame::{WriteFault, WriteFrame, WriteName};
use super::{Judged, WriteFilter, observer};
use crate::shapes::ellipse_of;
use crate::worlds::Run;
use geom::Ellipse;
use nalgebra::Matrix2;
use program::judge::{Outcome, Verdict, divides, has_gain, judge};
use program::words::Words;
use program::{Fault, Program, Quantity, World, given};
use sim::scenarios::BUG_MUSEUM;

/// What is said of a program, whatever its run.
pub(super) fn judged(program: &Program) -> Judged {
    let (mut faults, mut verdict) = (program.faults().to_vec(), judge(program));
    if let Some(fault) = misfit(program) {
        let (line, sentences) = (Some(fault.line), vec![fault.message.clone()]);
        verdict = Verdict { outcome: Outcome::Refused, line, sentences, breaks: false };
        faults.push(fault);
    }
    let sound = faults.is_empty() && verdict.outcome != Outcome::Unfinished;
    let observer = (sound && program.world() == World::Linear).then(|| observer::of(program)).flatten();
    if let Some(observer) = observer {
        let [first, second] = observer.gain;
        let mut words = Words::new("It is an observer with the fixed gain [");
        words.number(first).text("; ").number(second).text("]: an error is multiplied by ").number(observer.radius);
        words.text(" a step in the end");
        words.text(if observer.radius < 1.0 { ", and dies out. " } else { ", and does not die out. " });
        words.text(program.letter(Quantity::P));
        words.text(if observer.honest { " is the covariance of its error." } else { " is not that of its error." });
        verdict.sentences.push(words.0);
    }
    let made = program.makes();
    let names_gain = made.iter().any(|name| name == program.letter(Quantity::Gain)) || has_gain(program);
    Judged { verdict, faults, observer, made, names_gain, divides: divides(program) }
}

/// The fault of a text that is right by itself, and is for another count of states or inputs than the rail has. There
/// may be more readings: the judge's cases have up to three.
fn misfit(program: &Program) -> Option<Fault> {
    if program.world() == World::Robot || !program.faults().is_empty() {
        return None;
    }
    let readings = program.sizes()[1].unwrap_or(1);
    program.clone().fit([2, readings, 1]).err()
}

/// A fault of the run as a whole.
pub(super) fn said(words: &str) -> Fault {
    Fault { line: 1, column: 1, length: 0, message: words.into() }
}

pub(super) fn frame(lab: &WriteFilter) -> WriteFrame {
    let Judged { verdict, faults, observer, made, names_gain, divides } = &*lab.judged;
    // The world is the right filter's, which goes on where the program's run has ended.
    let [run, right] = &lab.runs;
    let runs = lab.stopped.is_none();
    let (world, notation) = (lab.program.world(), lab.program.notation());
    let name = |(name, about, size)| WriteName { name, about, size };
    WriteFrame {
        step: lab.step,
        params: lab.params,
        text: lab.program.text().into(),
        world: lab.params.begin.world(),
        given: given(world, notation).into_iter().map(name).collect(),
        made: made.clone(),
        faults: faults.iter().map(WriteFault::from).collect(),
        outcome: verdict.outcome.into(),
        bug: bug_of(verdict.outcome),
        line: verdict.line,
        sentences: verdict.sentences.clone(),
        breaks: verdict.breaks,
        names_gain: *names_gain,
        divides: *divides,
        observer: *observer,
        stopped: lab.stopped.as_ref().map(WriteFault::from),
        truth: right.truth(),
        estimate: run.belief.0.entries.clone(),
        ellipse: if runs { ellipse(run) } else { None },
        right: right.belief.0.entries.clone(),
        right_ellipse: ellipse(right),
        landmarks: if world == World::Robot { &BUG_MUSEUM.landmarks } else { &[] },
        sighted: right.seen().map(|seen| seen.landmark),
        used: runs && run.used,
        nees: if runs { run.nees() } else { None },
        series: lab.series.clone(),
        tracks: lab.tracks.outlined(),
    }
}

fn bug_of(outcome: Outcome) -> Option<&'static str> {
    if let Outcome::Bug(bug) = outcome { Some(bug.word()) } else { None }
}

/// Of the first two states; none where their covariance is none.
fn ellipse(run: &Run) -> Option<Ellipse> {
    let p = &run.belief.1;
    let p = Matrix2::new(p.at(0, 0), p.at(0, 1), p.at(1, 0), p.at(1, 1));
    let p = filters::covariance::symmetric(p);
    (p[(0, 0)] >= 0.0 && p[(1, 1)] >= 0.0 && p.determinant() >= 0.0).then(|| ellipse_of(&p))
}
