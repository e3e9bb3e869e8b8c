//! Two landmarks that are taken for one another: each pair of those whose readings fit worst is exchanged, and the log
//! replayed.

use crate::drive::evidence::Trial;
use crate::drive::freed::Search;
use crate::drive::row::Event;
use alloc::vec::Vec;

/// So many landmarks are looked at, at most.
const MOST: usize = 6;

/// How many pairs are tried of so many landmarks.
pub(crate) fn pairs(landmarks: usize) -> usize {
    let tried = landmarks.min(MOST);
    tried * tried.saturating_sub(1) / 2
}

/// The pair whose exchange makes the readings likeliest, by their places in the list, and by how much; `None` where no
/// exchange can be replayed.
pub(crate) fn likeliest(search: &Search<'_>, place: &Trial) -> Option<([usize; 2], f64)> {
    let worst = worst(search);
    let pairs =
        worst.iter().enumerate().flat_map(|(i, a)| worst.iter().skip(i + 1).map(move |b| [*a.min(b), *a.max(b)]));
    let mut best: Option<([usize; 2], f64)> = None;
    for pair in pairs {
        let mut exchanged = *place;
        exchanged.otherwise.exchanged = Some(pair);
        let Some(evidence) = search.replay(&exchanged) else { continue };
        let gain = evidence.gain(search.base, search.from);
        if gain.is_finite() && best.is_none_or(|(_, most)| gain > most) {
            best = Some((pair, gain));
        }
    }
    best
}

/// The landmarks whose readings are least likely for their number.
pub(crate) fn worst(search: &Search<'_>) -> Vec<usize> {
    let mut sums = alloc::vec![(0.0, 0_u32); search.drive.landmarks.len()];
    for reading in &search.base.readings {
        let event = search.drive.rows[reading.row as usize].event;
        if let Event::Range { landmark, .. } | Event::RangeBearing { landmark, .. } = event
            && let Some((sum, count)) = sums.get_mut(landmark)
        {
            (*sum, *count) = (*sum + reading.log_likelihood, *count + 1);
        }
    }
    let mut seen: Vec<(usize, f64)> = sums
        .into_iter()
        .enumerate()
        .filter(|(_, (_, count))| *count > 0)
        .map(|(i, (sum, count))| (i, sum / f64::from(count)))
        .collect();
    seen.sort_by(|a, b| a.1.total_cmp(&b.1));
    seen.into_iter().take(MOST).map(|(i, _)| i).collect()
}
