//! A table with a column of ranges for each landmark: `d1, d2, d3`. The number in a column's name is the landmark's.

use crate::names::Name;
use crate::role::Quantity;

/// What such a column may be called, besides its number.
const CALLED: [&str; 18] = [
    "d",
    "r",
    "range",
    "dist",
    "distance",
    "anchor",
    "beacon",
    "buoy",
    "uwb",
    "abstand",
    "entfernung",
    "distanz",
    "distancia",
    "distanza",
    "anker",
    "ancre",
    "ancla",
    "ancora",
];

/// The columns of the first such group, or of the one that a column is in, each with its landmark.
pub(crate) fn group(names: &[Name]) -> Option<Vec<(u32, usize)>> {
    let is_range =
        |at: &usize| parted(&names[*at]).is_some_and(|(words, _)| words.iter().any(|it| CALLED.contains(it)));
    (0..names.len()).filter(is_range).find_map(|at| group_of(names, at).filter(|found| found.len() > 1))
}

/// The ways of two wheels, which ArduPilot calls by numbers in a file of wheel encoders: `Dist0`, `Dist1`. Which of the
/// two is on which side, the file does not say.
pub(crate) fn of_wheels(names: &[Name], file: &str) -> Option<Vec<usize>> {
    let found = group(names).filter(|found| found.len() == 2)?;
    let is_way = |at: usize| names[at].has_one(&["d", "dist", "distance"]);
    let wheels = ["wenc", "encoder", "wheel"].iter().any(|word| file.to_lowercase().contains(word));
    (wheels && found.iter().all(|(_, at)| is_way(*at))).then(|| found.into_iter().map(|(_, at)| at).collect())
}

/// The columns that are called as one of them is, but for the number.
pub(crate) fn group_of(names: &[Name], at: usize) -> Option<Vec<(u32, usize)>> {
    let (called, _) = parted(names.get(at)?)?;
    let alike = |name: &Name| parted(name).filter(|(other, _)| *other == called).map(|(_, number)| number);
    Some(names.iter().enumerate().filter_map(|(i, name)| Some((alike(name)?, i))).collect())
}

/// Whether some columns differ by a number alone.
pub(crate) fn numbered(names: &[Name]) -> bool {
    (0..names.len()).any(|at| group_of(names, at).is_some_and(|found| found.len() > 1))
}

/// The columns that are called as landmarks are, but for words of a range and its unit: `A1`, `range_A1 [mm]`.
pub(crate) fn called(names: &[Name], landmarks: &[String]) -> Vec<(String, usize)> {
    let is_called = |name: &Name, landmark: &str| {
        let (base, own) = (name.base(Quantity::Length), Name::new(landmark).words);
        let parts = base.len().checked_sub(own.len()).map(|at| base.split_at(at));
        parts.is_some_and(|(before, it)| it == own && before.iter().all(|word| CALLED.contains(word)))
    };
    let column = |landmark: &String| {
        let mut columns = (0..names.len()).filter(|at| is_called(&names[*at], landmark));
        columns.next().map(|at| (landmark.clone(), at)).filter(|_| columns.next().is_none())
    };
    let mut found: Vec<(String, usize)> = landmarks.iter().filter_map(column).collect();
    found.sort_by_key(|(_, at)| *at);
    if found.len() > 1 { found } else { Vec::new() }
}

/// The words of a name, and the number that stands among them.
fn parted(name: &Name) -> Option<(Vec<&str>, u32)> {
    let is_number = |word: &&String| word.bytes().all(|b| b.is_ascii_digit());
    let mut numbers = name.words.iter().filter(is_number);
    let number = numbers.next()?.parse().ok()?;
    if numbers.next().is_some() {
        return None;
    }
    let words = name.words.iter().filter(|word| !is_number(word)).map(String::as_str);
    Some((words.collect(), number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_of_one_name_and_a_number_are_one_group() {
        let of = |names: &[&str]| group(&names.iter().map(|name| Name::new(name)).collect::<Vec<_>>());
        assert_eq!(of(&["t", "d1", "d2", "q"]), Some(vec![(1, 1), (2, 2)]));
        assert_eq!(of(&["anchor 7 [mm]", "anchor 9 [mm]"]), Some(vec![(7, 0), (9, 1)]));
        assert_eq!(of(&["t", "x1", "x2"]), None);
        assert_eq!(of(&["t", "d1"]), None);
        assert_eq!(of(&["t", "d99999999999", "d2"]), None);
    }
}
