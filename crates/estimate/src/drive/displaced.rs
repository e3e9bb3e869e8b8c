//! One landmark that stands elsewhere than its row says, or whose ranges are off by a constant: each of those whose
//! readings fit worst is tried, and the log replayed.

use crate::drive::evidence::Trial;
use crate::drive::exchange::worst;
use crate::drive::freed::{Freed, Numbers, ROUNDS, Search};
use alloc::vec;

/// How far a landmark is moved for a difference, and how far it is looked for, m; of its ranges the same.
const STEP: f64 = 0.02;
const FURTHEST: f64 = 1e4;

/// The landmark whose move makes the readings likeliest, by its place in the list, by how much it is moved, and the
/// replay in which it is; `None` where the readings do not tell it.
pub(crate) fn displaced(search: &Search<'_>, place: &Trial) -> Option<(usize, Freed, Trial)> {
    likeliest(search, 2, |landmark, by| {
        let mut place = *place;
        if let &[x, y] = by {
            place.otherwise.displaced = Some((landmark, [x, y]));
        }
        place
    })
}

/// The landmark whose ranges, all taken shorter by a constant, make the readings likeliest, in the same way.
pub(crate) fn biased(search: &Search<'_>, place: &Trial) -> Option<(usize, Freed, Trial)> {
    likeliest(search, 1, |landmark, by| {
        let mut place = *place;
        place.otherwise.biased = by.first().map(|by| (landmark, *by));
        place
    })
}

/// Frees so many numbers of one landmark after the other, and of the likeliest once more to the end.
fn likeliest(
    search: &Search<'_>,
    count: usize,
    place: impl Fn(usize, &[f64]) -> Trial,
) -> Option<(usize, Freed, Trial)> {
    let look = |landmark: usize, rounds: u32| {
        let place = |by: &[f64]| place(landmark, by);
        search.means(&Numbers {
            first: vec![0.0; count],
            steps: vec![STEP; count],
            bounds: vec![[-FURTHEST, FURTHEST]; count],
            both: false,
            others: vec![],
            rounds,
            place: &place,
        })
    };
    let found = worst(search).into_iter().filter_map(|landmark| Some((landmark, look(landmark, 1)?.gain)));
    let (landmark, _) = found.max_by(|one, other| one.1.total_cmp(&other.1))?;
    let freed = look(landmark, ROUNDS)?;
    let mended = place(landmark, &freed.at);
    Some((landmark, freed, mended))
}
