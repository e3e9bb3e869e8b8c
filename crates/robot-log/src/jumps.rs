//! Where the counts of a file's encoders jump, in the order of its times.

use crate::counter::Jumps;
use crate::fields::Line;
use crate::file::File;
use crate::role::Role;
use crate::row;
use crate::source::Source;
use crate::unit;
use crate::wheels::{Counting, is_speed};

impl File {
    /// The jumps of its encoders that neither motion nor the end of a counter's range explains, as a question.
    pub(crate) fn odd_jumps(&self) -> Option<String> {
        let jumps = self.jumps();
        let first = jumps.odd.first()?;
        let column = self.source.column(["left", "right"][first.side])?;
        let (name, line, from, to) = (&self.header()[column], first.line, first.from, first.to);
        let more = jumps.odd.len() - 1;
        if let Some(gap) = first.gap {
            return Some(format!(
                "Before line {line} nothing was counted for {gap:.1} s, in which \u{201c}{name}\u{201d} may have begun \
                 anew unseen: part the file there, or say that the count begins anew at a jump, and the way of that \
                 time is lost."
            ));
        }
        let others = if more == 0 { String::new() } else { format!(" ({more} more like it)") };
        Some(format!(
            "In line {line} \u{201c}{name}\u{201d} jumps from {from} to {to}, which no motion does{others}: mend the \
             file, or say that the count begins anew at a jump."
        ))
    }

    /// Where its encoders' counts jump, as far as they are totals.
    pub(crate) fn jumps(&self) -> Jumps {
        if self.role() == Role::Reckoned {
            return self.pose_jumps();
        }
        let Source { table: Some(table), units, columns, wheels, .. } = &self.source else { return Jumps::default() };
        let counts = matches!(wheels.counting, Some(Counting::Total | Counting::Restarted));
        let Some(unit) = units.get(1).copied().flatten().filter(|unit| counts && !is_speed(unit.name)) else {
            return Jumps::default();
        };
        let [Some(time), Some(left), Some(right)] = [0, 1, 2].map(|i| columns[i]) else { return Jumps::default() };
        let number = |line: &Line<'_>, at: usize| row::number(line.fields.get(at)?.text).filter(|it| it.is_finite());
        let lines = self.lines(table).filter_map(Result::ok).filter(|line| self.source.is_read(line));
        let counted = lines.filter_map(|line| {
            let [left, right] = [number(&line, left)?, number(&line, right)?].map(|it| unit::convert(unit, it));
            // Of dates the difference does not matter: then the steps themselves are compared.
            Some((line.number, number(&line, time).unwrap_or(0.0), [left, right]))
        });
        Jumps::of(&counted.collect::<Vec<_>>(), unit)
    }
}
