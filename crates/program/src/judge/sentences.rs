//! What a judgement says, with numbers.

use super::{Bug, Off, Outcome, Steps, TOLERANCE, Verdict, apart, cases, line_of, off};
use crate::words::Words;
use crate::{Formula, Quantity};
use alloc::string::String;
use alloc::vec::Vec;

pub(super) fn is_right(theirs: &Steps, ours: &Steps, cases: usize) -> Verdict {
    let (mut worst, mut lopsided) = (0.0, None);
    for (step, (case, _)) in theirs.steps.iter().enumerate() {
        for quantity in [Quantity::X, Quantity::P] {
            let ours = ours.on(*case).and_then(|step| ours.made(step, quantity));
            if let (Some(a), Some(b)) = (theirs.made(step, quantity), ours) {
                worst = f64::max(worst, apart(a, b));
                if quantity == Quantity::P && !a.is_symmetric() {
                    lopsided = lopsided.or(Some(*case));
                }
            }
        }
    }
    let [x, p] = [Quantity::X, Quantity::P].map(|quantity| theirs.program.notation().letter(quantity));
    let mut words = Words::new("Right: ");
    words.text(x).text(" and ").text(p).text(" are those of a right filter in all ");
    words.whole(theirs.steps.len() as i64).text(" cases, to ").number(worst).text(" of their largest entry.");
    let mut sentences = alloc::vec![words.0];
    if theirs.steps.len() < cases {
        let mut words = Words::new("The other ");
        words.whole((cases - theirs.steps.len()) as i64).text(" cases are of sizes that it is not written for.");
        sentences.push(words.0);
    }
    if let Some(case) = lopsided {
        let mut words = Words::new(p);
        words.text(" is not symmetric in its last digits, as in case ").whole(case as i64 + 1);
        words
            .text(", which in a long run is the museum’s bug “P is not symmetric”. A last line ")
            .text(p)
            .text(" = sym(");
        sentences.push(words.text(p).text(") cures it.").0.clone());
    }
    for quantity in [Quantity::Innovation, Quantity::S, Quantity::Gain] {
        if let Some((line, other)) = line_of(theirs, quantity).zip(another(theirs, ours, quantity)) {
            let mut words = Words::new("But line ");
            words.whole(i64::from(line)).text(" makes another ").text(theirs.program.notation().letter(quantity));
            words.text(" than a right filter has, which a gate or a statistic would use. ");
            other.say(theirs, &mut words);
            sentences.push(words.0);
        }
    }
    let broken = breaks(theirs);
    let breaks = broken.is_some();
    sentences.extend(broken);
    let line = if sentences.len() > 1 { line_of(theirs, Quantity::P) } else { None };
    Verdict { outcome: Outcome::Right, line, sentences, breaks }
}

/// Where a named quantity of the size that it has is off.
fn another(theirs: &Steps, ours: &Steps, quantity: Quantity) -> Option<Off> {
    let sized = |(step, (case, _)): (usize, &(usize, _))| {
        let ours = ours.on(*case).and_then(|step| ours.made(step, quantity))?;
        Some((theirs.made(step, quantity)?, ours)).filter(|(a, b)| (a.rows, a.columns) == (b.rows, b.columns))
    };
    let all = theirs.steps.iter().enumerate().all(|step| sized(step).is_some());
    off(theirs, ours, quantity).filter(|_| all)
}

/// Where a form that is right on paper loses its digits: a prior that knows nothing.
fn breaks(theirs: &Steps) -> Option<String> {
    let hard = cases::knowing_nothing(theirs.program.world(), theirs.program.sizes())?;
    let mut words = Words::new("With a prior of 10²⁴ I and a reading of variance 0.04, ");
    let letter = theirs.program.notation().letter(Quantity::P);
    match theirs.program.clone().step(hard) {
        Ok(step) => {
            let variance = theirs.program.made(&step, Quantity::P)?.at(0, 0);
            if libm::fabs(variance - 0.04) < 1e-6 {
                return None;
            }
            words.text(letter).text("[1, 1] becomes ").number(variance);
            words.text(", where Joseph’s form has 0.04: on paper the form is right, in numbers it breaks there.");
        }
        Err(_) => {
            words.text("it has no value: on paper the form is right, in numbers it breaks there.");
        }
    }
    Some(words.0)
}

/// The first line that makes what a line of the bug makes and no line of the right filter.
pub(super) fn is_bug(bug: Bug, theirs: &Steps, ours: &Steps, mutant: &Steps, off: &Off) -> Verdict {
    let same = |line: usize, of: &Steps, other: usize| {
        theirs.steps.iter().all(|(case, step)| {
            let (Some(a), Some(at)) = (step.made.get(line), of.on(*case)) else { return false };
            of.steps[at].1.made.get(other).is_some_and(|b| apart(a.value(), b.value()) <= TOLERANCE)
        })
    };
    let lines = |of: &Steps| of.steps.first().map_or(0, |(_, step)| step.made.len());
    // What a later line makes anew is no answer of a filter.
    let stays = |of: &Steps, line: usize| {
        let made = |line: usize| of.program.name(&of.steps[0].1.made[line]);
        (line + 1..lines(of)).all(|later| made(later) != made(line))
    };
    let any = |line: usize, of: &Steps| (0..lines(of)).any(|other| stays(of, other) && same(line, of, other));
    let tells = |line: &usize| any(*line, mutant) && !any(*line, ours);
    let first = (0..lines(theirs)).find(tells);
    let line = match bug {
        Bug::Twice => last_use(theirs),
        _ => first.map(|line| theirs.steps[0].1.made[line].line).or_else(|| line_of(theirs, off.quantity)),
    };
    let mut words = Words::default();
    if let Some(line) = line {
        words.text("Line ").whole(i64::from(line)).text(": ");
    }
    words.text(bug.sentence());
    let mut numbers = Words::default();
    off.say(theirs, &mut numbers);
    numbers.text(" In all ").whole(theirs.steps.len() as i64).text(" cases the answer is that of this bug.");
    Verdict { outcome: Outcome::Bug(bug), line, sentences: alloc::vec![words.0, numbers.0], breaks: false }
}

/// What a quantity is made of, by a right filter's name, and in words.
fn parts(quantity: Quantity) -> &'static [(&'static str, &'static str)] {
    match quantity {
        Quantity::Innovation => &[("xm", "predicted estimate")],
        Quantity::S => &[("Pm", "predicted covariance"), ("H", "Jacobian of the reading")],
        _ => &[],
    }
}

/// The last line before `at` that makes something of such a part's size, where no line makes the right one.
fn unmade(theirs: &Steps, ours: &Steps, name: &str, at: u32) -> Option<u32> {
    let made = |line: usize| {
        theirs.steps.iter().all(|(case, step)| {
            step.made.get(line).zip(ours.line(*case, name)).is_some_and(|(a, b)| apart(a.value(), b) <= TOLERANCE)
        })
    };
    let (case, first) = theirs.steps.first()?;
    let expected = ours.line(*case, name)?;
    let candidates = |line: &usize| {
        let value = first.made[*line].value();
        first.made[*line].line < at && (value.rows, value.columns) == (expected.rows, expected.columns)
    };
    let last = (0..first.made.len()).rfind(candidates)?;
    (!(0..first.made.len()).any(made)).then(|| first.made[last].line)
}

/// Whether a formula has one of these names.
pub(super) fn uses(formula: &Formula, names: &[String]) -> bool {
    names.contains(&formula.name) || formula.parts.iter().any(|part| uses(part, names))
}

/// The last line that uses the reading.
fn last_use(of: &Steps) -> Option<u32> {
    let letter = [String::from(of.program.notation().letter(Quantity::Y))];
    let lines = of.program.tree(None).ok()?;
    lines.iter().rev().find(|line| uses(&line.value, &letter)).map(|line| line.lines[0])
}

pub(super) fn is_wrong(theirs: &Steps, ours: &Steps, off_first: &Off) -> Verdict {
    let mut words = Words::default();
    off_first.say(theirs, &mut words);
    let mut sentences = alloc::vec![words.0];
    let mut line = line_of(theirs, off_first.quantity);
    // The first of the named quantities that is off, with those before it that are right.
    let mut right = Vec::new();
    for quantity in [Quantity::Innovation, Quantity::S, Quantity::Gain] {
        let Some(at) = line_of(theirs, quantity) else { continue };
        if !(0..theirs.steps.len()).all(|step| theirs.made(step, quantity).is_some()) {
            continue;
        }
        let letter = theirs.program.notation().letter(quantity);
        match off(theirs, ours, quantity) {
            None => right.push(String::from(letter)),
            Some(off) => {
                let mut words = Words::default();
                if !right.is_empty() {
                    words.list(&right).text(if right.len() > 1 { " are right. " } else { " is right. " });
                }
                words.text("In line ").whole(i64::from(at)).text(", ");
                off.entry(theirs, &mut words);
                words.text(" is ").number(off.theirs).text(" in case ");
                words.whole(theirs.steps[off.step].0 as i64 + 1).text(", and a right filter has ").number(off.ours);
                sentences.push(words.text(".").0.clone());
                let missing = |(name, of): &(&str, &'static str)| Some((unmade(theirs, ours, name, at)?, *of));
                let before = parts(quantity).iter().find_map(missing);
                if let Some((line, of)) = before {
                    let mut words = Words::new("No line makes a right filter’s ");
                    words.text(of).text(": look at line ").whole(i64::from(line)).text(" first.");
                    sentences.push(words.0);
                }
                let line = before.map(|(line, _)| line).or(Some(at));
                return Verdict { outcome: Outcome::Wrong, line, sentences, breaks: false };
            }
        }
    }
    if !right.is_empty() {
        let mut words = Words::default();
        words.list(&right).text(if right.len() > 1 { " are right" } else { " is right" });
        sentences.push(words.text(", so the fault is in what is made of them.").0.clone());
    }
    // Where x is right, P alone is off.
    if off_first.quantity == Quantity::P {
        let x = theirs.program.notation().letter(Quantity::X);
        let mut words = Words::new(x);
        sentences.push(words.text(" is right in all cases.").0.clone());
    } else if off(theirs, ours, Quantity::P).is_none() {
        let mut words = Words::new(theirs.program.notation().letter(Quantity::P));
        sentences.push(words.text(" is right in all cases.").0.clone());
    }
    line = line.or(Some(1));
    Verdict { outcome: Outcome::Wrong, line, sentences, breaks: false }
}
