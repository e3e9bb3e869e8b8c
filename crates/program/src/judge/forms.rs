//! What one form of a filter has and another does without: a gain, or a division by a matrix.

use super::{TOLERANCE, apart, cases, right};
use crate::{Formula, Matrix, Notation, Program, Quantity, Stop, World};
use alloc::vec;
use alloc::vec::Vec;
use core::cell::RefCell;

/// Whether a line makes a right filter's gain, or a part of a line is a right filter's S, in all cases: whatever they
/// are called. A program without a value has neither.
pub fn has_gain(program: &Program) -> bool {
    let world = program.world();
    let (mut theirs, mut ours) = (program.clone(), Program::new(&right(world), world, Notation::Choset));
    // Whether each part of a formula has been the gain so far, and S.
    let mut all: Option<Vec<[bool; 2]>> = None;
    for case in cases(world, program.sizes()) {
        let Ok(step) = ours.step(case.clone()) else { return false };
        let wanted = [Quantity::Gain, Quantity::S].map(|quantity| ours.made(&step, quantity));
        let is = RefCell::new(vec![[false; 2]; program.read.tree.nodes.len()]);
        let look = |id: usize, m: &Matrix| {
            let mut is = is.borrow_mut();
            for (is, wanted) in is.iter_mut().skip(id).take(1).flatten().zip(wanted) {
                *is |= wanted.is_some_and(|wanted| apart(m, wanted) <= TOLERANCE);
            }
        };
        match theirs.step_seen(case, Some(&look)) {
            Ok(_) => {}
            // A program for three states is not asked for two.
            Err(Stop::Fault(_)) => continue,
            Err(_) => return false,
        }
        let is = is.into_inner();
        match &mut all {
            Some(all) => {
                for (all, is) in all.iter_mut().flatten().zip(is.iter().flatten()) {
                    *all &= is;
                }
            }
            None => all = Some(is),
        }
    }
    let all = all.unwrap_or_default();
    let of_line = |line: &crate::tree::Line| line.value.and_then(|value| all.get(value)).is_some_and(|[gain, _]| *gain);
    program.read.tree.lines.iter().any(of_line) || all.iter().any(|[_, s]| *s)
}

/// Whether a line divides by a matrix of more than one row, or inverts one. A program with faults does not.
pub fn divides(program: &Program) -> bool {
    let usual = if program.world() == World::Robot { [3, 2, 2] } else { [2, 2, 1] };
    let known = program.sizes();
    let sizes = [0, 1, 2].map(|i| known[i].unwrap_or(usual[i]));
    program.tree(Some(sizes)).is_ok_and(|lines| lines.iter().any(|line| divided(&line.value)))
}

fn divided(it: &Formula) -> bool {
    let divisor = match it.word {
        "over" => it.parts.get(1),
        "under" | "inv" => it.parts.first(),
        "power" if it.number < 0.0 => it.parts.first(),
        _ => None,
    };
    // A multiple of I is divided by as its number.
    divisor.and_then(|divisor| divisor.sides).is_some_and(|[rows, _]| rows > 1) || it.parts.iter().any(divided)
}
