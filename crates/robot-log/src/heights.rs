//! Landmarks whose heights a file says: the filter knows a plane, and a range over a height is longer than it expects.

use crate::file::File;
use crate::role::Role;
use estimate::drive::{Drive, Event};

/// What is said of a file of landmarks with heights beside a log of ranges.
pub(crate) fn note(files: &[File], drive: &Drive) -> Option<String> {
    let range = |event: &Event| matches!(event, Event::Range { .. } | Event::RangeBearing { .. });
    let there = drive.rows.iter().any(|row| range(&row.event));
    let placed = files.iter().filter(|file| there && file.role() == Role::Landmarks);
    let (file, z) = placed.filter_map(|file| Some((file, heights(file)?))).next()?;
    Some(format!(
        "{}: {z} is not read, and ranges are taken as level ones. Over a difference in height h a range r reads about \
         h\u{b2}/2r too long, which looks like a scale and an offset of the ranges, or like landmarks that stand \
         elsewhere.",
        file.name()
    ))
}

/// The name of a column of heights of which one is not 0.
fn heights(file: &File) -> Option<&str> {
    let source = &file.source;
    let z = |at: &usize| !source.columns.contains(&Some(*at));
    let z = (0..source.names.len()).filter(z).find(|at| source.names[*at].has_one(&["z", "height"]));
    let (table, z) = source.table.as_ref().zip(z)?;
    let is_height = |text: &str| text.trim().parse::<f64>().is_ok_and(|height| height != 0.0);
    table.column(file.text(), z).any(|(_, text)| is_height(text)).then(|| table.names[z].as_str())
}
