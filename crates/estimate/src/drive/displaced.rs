//! A landmark that stands elsewhere than its row says: each of those whose readings fit worst is moved, and the log
//! replayed.

use crate::drive::evidence::Trial;
use crate::drive::exchange::worst;
use crate::drive::freed::{Freed, Numbers, ROUNDS, Search};
use alloc::vec;

/// How far a landmark is moved for a difference, and how far it is looked for, m.
const STEP: f64 = 0.02;
const FURTHEST: f64 = 1e4;

/// The replay in which a landmark, by its place in the list, is moved by so much.
pub(crate) fn moved(place: &Trial, landmark: usize, by: &[f64]) -> Trial {
    let mut place = *place;
    if let &[x, y] = by {
        place.otherwise.displaced = Some((landmark, [x, y]));
    }
    place
}

/// The landmark whose move makes the readings likeliest, by its place in the list, and by how much it is moved; `None`
/// where the readings do not tell it.
pub(crate) fn displaced(search: &Search<'_>, place: &Trial) -> Option<(usize, Freed)> {
    let look = |landmark: usize, rounds: u32| {
        let place = |by: &[f64]| moved(place, landmark, by);
        search.means(&Numbers {
            first: vec![0.0; 2],
            steps: vec![STEP; 2],
            bounds: vec![[-FURTHEST, FURTHEST]; 2],
            both: false,
            others: vec![],
            rounds,
            place: &place,
        })
    };
    let found = worst(search).into_iter().filter_map(|landmark| Some((landmark, look(landmark, 1)?.gain)));
    let (landmark, _) = found.max_by(|one, other| one.1.total_cmp(&other.1))?;
    Some((landmark, look(landmark, ROUNDS)?))
}
