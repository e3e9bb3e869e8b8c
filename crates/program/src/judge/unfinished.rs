//! How far a program has come that is right so far: its prediction, parts of its update, and no answer yet. What
//! stands there is no line's fault.

use super::sentences::uses;
use super::{Outcome, Steps, TOLERANCE, Verdict, apart, line_of};
use crate::tree::Node;
use crate::words::Words;
use crate::{Matrix, Quantity, World};
use alloc::string::String;
use alloc::vec::Vec;

/// No entry of it is an angle.
const NO_ANGLE: usize = usize::MAX;
/// What is compared, the right filter's name of its prediction, and the entry that is an angle in the robot's world.
const COMPARED: [(Quantity, Option<&str>, usize); 5] = [
    (Quantity::X, Some("xm"), 2),
    (Quantity::P, Some("Pm"), NO_ANGLE),
    (Quantity::Innovation, None, 1),
    (Quantity::S, None, NO_ANGLE),
    (Quantity::Gain, None, NO_ANGLE),
];

/// The answers that are a right prediction, and are not corrected by the reading; and what is said where all else that
/// has a name is right.
pub(super) fn judged(theirs: &Steps, ours: &Steps) -> (Vec<Quantity>, Option<Verdict>) {
    let (mut lacks, mut right, mut unwrapped, mut is_right) = (Vec::new(), Vec::new(), Vec::new(), true);
    for (quantity, predicted, angle) in COMPARED {
        if predicted.is_none() && !(0..theirs.steps.len()).all(|step| theirs.made(step, quantity).is_some()) {
            continue;
        }
        let letter = theirs.program.notation().letter(quantity);
        let answer = |case: usize| ours.made(ours.on(case)?, quantity);
        let prediction = |case: usize| ours.line(case, predicted?);
        let lacking = !meets(theirs, quantity, angle, answer);
        if !lacking {
            right.push(String::from(letter));
        } else if !is_copied(theirs, quantity) && !reads(theirs, letter) && meets(theirs, quantity, angle, prediction) {
            right.push(Words::new("the predicted ").text(letter).0.clone());
            lacks.push(quantity);
        } else {
            is_right = false;
            continue;
        }
        let is_wrapped = if lacking {
            meets(theirs, quantity, NO_ANGLE, prediction)
        } else {
            meets(theirs, quantity, NO_ANGLE, answer)
        };
        if !is_wrapped {
            let mut words = Words::new("No line wraps ");
            words.text(letter).text("[").whole(angle as i64 + 1);
            unwrapped.push(words.text("] yet: near ±π it is off by a turn.").0.clone());
        }
    }
    if lacks.is_empty() || !is_right {
        return (lacks, None);
    }
    let mut sentences = alloc::vec![said(theirs, &lacks, "Not finished: no line corrects ")];
    sentences.append(&mut unwrapped);
    sentences.push(Words::new("Right so far: ").list(&right).text(".").0.clone());
    let verdict = Verdict { outcome: Outcome::Unfinished, line: None, sentences, breaks: false };
    (lacks, Some(verdict))
}

/// "No line corrects x and P by the reading yet."
pub(super) fn said(theirs: &Steps, lacks: &[Quantity], begin: &str) -> String {
    let mut letters = Vec::new();
    for quantity in lacks {
        letters.push(String::from(theirs.program.notation().letter(*quantity)));
    }
    Words::new(begin).list(&letters).text(" by the reading yet.").0.clone()
}

/// Whether a quantity is in every step what it is to be, where an angle may be off by turns.
fn meets<'a>(theirs: &Steps, quantity: Quantity, angle: usize, of: impl Fn(usize) -> Option<&'a Matrix>) -> bool {
    theirs.steps.iter().enumerate().all(|(step, (case, _))| {
        let Some((made, wanted)) = theirs.made(step, quantity).zip(of(*case)) else { return false };
        let mut made = made.clone();
        if theirs.program.world() == World::Robot
            && let (Some(entry), Some(of)) = (made.entries.get_mut(angle), wanted.entries.get(angle))
        {
            *entry = of + geom::wrap(*entry - of);
        }
        apart(&made, wanted) <= TOLERANCE
    })
}

/// Whether what a name has become depends on the reading, if only by a gain of zero.
fn reads(theirs: &Steps, name: &str) -> bool {
    let mut of_it = alloc::vec![String::from(theirs.program.notation().letter(Quantity::Y))];
    for line in theirs.program.tree(None).unwrap_or_default() {
        let reads = uses(&line.value, &of_it);
        if !reads && line.part.is_none() {
            of_it.retain(|known| *known != line.name);
        } else if reads {
            of_it.push(line.name);
        }
    }
    of_it.iter().any(|known| known == name)
}

/// Whether the last line that makes it is a name alone, as P = P: that line leaves out the correction.
fn is_copied(theirs: &Steps, quantity: Quantity) -> bool {
    let read = &theirs.program.read;
    let value = |line: u32| read.tree.lines[read.lines.iter().rposition(|number| *number == line)?].value;
    let node = line_of(theirs, quantity).and_then(value).and_then(|value| read.tree.nodes.get(value));
    matches!(node, Some((Node::Name(_), _)))
}
