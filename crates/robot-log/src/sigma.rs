//! Whose σ a column holds: a position's or a heading's.

use crate::heading::is_course;
use crate::names::{Name, candidates};
use crate::role::Quantity;

/// Whether a column that holds a σ may be a position's: only beside one, and never where it is an angle.
pub(crate) fn is_of_position(names: &[Name], at: usize) -> bool {
    is_placed(names) && names[at].unit(Quantity::Angle).is_none()
}

/// The columns that may hold the σ of a heading, of those that are called so, and where none is, of those that are
/// called a σ and no more. Of a course the accuracy of a compass says nothing, nor the other way round.
pub(crate) fn of_heading(names: &[Name], heading: Option<usize>, called: Vec<usize>) -> Vec<usize> {
    let Some(heading) = heading else {
        return Vec::new();
    };
    if called.is_empty() {
        return unnamed(names);
    }
    let is_course = |at: usize| is_course(&names[at]);
    called.into_iter().filter(|at| is_course(*at) == is_course(heading)).collect()
}

/// A σ whose name says no more is the heading's where nothing else was read, or where it is an angle. Beside a turn
/// rate it may be that one's.
fn unnamed(names: &[Name]) -> Vec<usize> {
    let has = |value, quantity| !candidates(value, quantity, names).is_empty();
    if has("omega", Quantity::AngleRate) {
        return Vec::new();
    }
    let alone = !is_placed(names) && !has("v", Quantity::Speed);
    let mut found = candidates("sigma", Quantity::Angle, names);
    found.retain(|at| alone || names[*at].unit(Quantity::Angle).is_some());
    found
}

/// Whether a position is among the columns.
fn is_placed(names: &[Name]) -> bool {
    let has = |value, quantity| !candidates(value, quantity, names).is_empty();
    (has("x", Quantity::Length) && has("y", Quantity::Length))
        || (has("latitude", Quantity::Coordinate) && has("longitude", Quantity::Coordinate))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The column of the position's σ and of the heading's, of a table with these columns.
    fn of(columns: &[&str]) -> [Vec<usize>; 2] {
        let names = Name::all(&columns.iter().map(|name| name.to_string()).collect::<Vec<_>>());
        let mut position = candidates("sigma", Quantity::SigmaWords, &names);
        position.retain(|at| is_of_position(&names, *at));
        let heading = candidates("heading", Quantity::Heading, &names).first().copied();
        let called = candidates("sigma of heading", Quantity::AngleSpread, &names);
        [position, of_heading(&names, heading, called)]
    }

    #[test]
    fn a_sigma_by_itself_is_of_what_stands_beside_it() {
        assert_eq!(of(&["time_s", "heading_rad", "sigma_rad"]), [vec![], vec![2]]);
        assert_eq!(of(&["time_s", "heading_rad", "sigma"]), [vec![], vec![2]]);
        assert_eq!(of(&["time_s", "yaw_deg", "std_deg"]), [vec![], vec![2]]);
        assert_eq!(of(&["t", "x", "y", "sigma"]), [vec![3], vec![]]);
        assert_eq!(of(&["t", "x", "y", "heading", "sigma", "sigma_rad"]), [vec![4], vec![5]]);
        assert_eq!(of(&["t", "lat", "lon", "accuracy", "heading_deg"]), [vec![3], vec![]]);
    }

    #[test]
    fn a_sigma_that_may_be_anothers_is_nobodys() {
        assert_eq!(of(&["t", "speed", "sigma"]), [vec![], vec![]]);
        assert_eq!(of(&["t", "speed", "heading", "sigma"]), [vec![], vec![]]);
        assert_eq!(of(&["t", "omega", "heading", "sigma_rad"]), [vec![], vec![]]);
    }
}
