//! Tables with the rows of several robots or tags, which a column tells apart: only one of them is the robot of the
//! log, and nobody but the reader knows which.

use crate::names::Name;
use crate::role::Role;
use crate::table::Table;
use std::collections::BTreeMap;

/// What such a column is called.
const CALLED: [&str; 8] = ["tag", "robot", "rover", "vehicle", "agent", "mobile", "initiator", "fahrzeug"];
/// What may stand beside that in its name.
const BESIDE: [&str; 8] = ["id", "name", "no", "number", "nr", "device", "node", "address"];
/// More different values than these are readings and not names.
const MOST: usize = 20;
/// The longest name, in bytes.
const LONGEST: usize = 40;

/// The column that tells them apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Several {
    pub column: usize,
    /// What stands in it, and in how many rows, in the order of the alphabet.
    pub values: Vec<(String, usize)>,
}

/// A column that tells several robots apart and holds no value of the file's role.
pub(crate) fn several(
    role: Role,
    table: &Table,
    names: &[Name],
    used: &[Option<usize>],
    text: &str,
) -> Option<Several> {
    if table.nameless || matches!(role, Role::Landmarks | Role::Barcodes | Role::Unused | Role::Undecided | Role::Log) {
        return None;
    }
    let is_name = |name: &Name| {
        let mut words = name.words.iter().map(String::as_str);
        name.has_one(&CALLED) && words.all(|word| CALLED.contains(&word) || BESIDE.contains(&word))
    };
    let columns = (0..names.len()).filter(|at| is_name(&names[*at]) && !used.contains(&Some(*at)));
    columns.filter_map(|column| told_apart(table, column, text)).next()
}

fn told_apart(table: &Table, column: usize, text: &str) -> Option<Several> {
    let mut counts = BTreeMap::<&str, usize>::new();
    for line in table.lines(text).filter_map(Result::ok) {
        let called = line.fields.get(column).map_or("", |field| field.text);
        if called.len() > LONGEST {
            return None;
        }
        *counts.entry(called).or_default() += 1;
        if counts.len() > MOST {
            return None;
        }
    }
    let values: Vec<(String, usize)> = counts.into_iter().map(|(value, rows)| (value.to_string(), rows)).collect();
    (values.len() > 1).then_some(Several { column, values })
}

/// A number with commas between its thousands.
pub(crate) fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
