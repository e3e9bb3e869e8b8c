//! First fixes that are outliers: their distances from their neighbours are not those that the motion tells.

use super::Drive;
use super::row::Event;
use alloc::vec::Vec;

/// So many fixes are looked at, each beside so many before and behind it.
pub(super) const FIRST: usize = 32;
const NEIGHBOURS: usize = 4;
/// A distance is another one where it is off by so many of its standard deviations, √(σ₁² + σ₂²), and by so much of the
/// way between, which may be misread.
const SIGMAS: f64 = 5.0;
const MISREAD: f64 = 0.1;
/// An outlier is taken to be so uncertain, m: it tells nothing, and its time stays. What is so uncertain tells nothing.
const NOTHING: f64 = 1e9;
const TELLS: f64 = 1e5;

/// Whether a fix of this standard deviation tells something.
pub(super) fn tells(sigma: f64) -> bool {
    sigma < TELLS
}

/// A fix beside where the motion alone leads: where that is, where the fix is, and its standard deviation, m.
pub(super) struct Held {
    pub reckoned: [f64; 2],
    pub fix: [f64; 2],
    pub sigma: f64,
}

/// Which of the fixes are outliers: without them the distances of neighbours are those that the motion tells.
fn outliers(fixes: &[Held]) -> Vec<usize> {
    let distance = |a: [f64; 2], b: [f64; 2]| libm::hypot(a[0] - b[0], a[1] - b[1]);
    let mut way = alloc::vec![0.0; fixes.len()];
    for (i, pair) in fixes.windows(2).enumerate() {
        way[i + 1] = way[i] + distance(pair[0].reckoned, pair[1].reckoned);
    }
    let another = |i: usize, j: usize| {
        let (one, other) = (&fixes[i], &fixes[j]);
        let off = distance(one.fix, other.fix) - distance(one.reckoned, other.reckoned);
        off.abs() > MISREAD * (way[i] - way[j]).abs() + SIGMAS * libm::hypot(one.sigma, other.sigma)
    };
    let mut kept: Vec<usize> = (0..fixes.len()).collect();
    // The one that agrees with the fewest goes first: those beside it may be right.
    loop {
        let disagreements = |at: usize| {
            let near = at.saturating_sub(NEIGHBOURS)..kept.len().min(at + NEIGHBOURS + 1);
            near.filter(|beside| *beside != at && another(kept[at], kept[*beside])).count()
        };
        let worst = (0..kept.len()).map(|at| (disagreements(at), at)).max_by_key(|(count, _)| *count);
        match worst {
            Some((count, at)) if count > 0 => kept.remove(at),
            _ => return (0..fixes.len()).filter(|i| !kept.contains(i)).collect(),
        };
    }
}

/// The first rows of a drive, so many, with the outliers among these first fixes taken to tell nothing; `None` where
/// none is one, or most are.
pub(super) fn trusted(drive: &Drive, fixes: &[Held], rows: usize) -> Option<Drive> {
    let out = outliers(fixes);
    if out.is_empty() || 2 * out.len() > fixes.len() {
        return None;
    }
    let rows = drive.rows.iter().take(rows).copied().collect();
    let (landmarks, truth) = (drive.landmarks.clone(), drive.truth.clone());
    let mut trusted = Drive { landmarks, truth, rows, motion: drive.motion };
    let all = trusted.rows.iter_mut().filter_map(|row| match &mut row.event {
        Event::Position { sigma, .. } => Some(sigma),
        _ => None,
    });
    for (_, sigma) in all.enumerate().filter(|(i, _)| out.contains(i)) {
        *sigma = Some(NOTHING);
    }
    Some(trusted)
}
