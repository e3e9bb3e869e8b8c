//! From which point the places of a log's files are counted. Latitudes and longitudes become metres east and north of
//! the first of them; a table in metres has an origin of its own, and nobody but the reader knows where that lies.

use estimate::drive::{Drive, Event, Pose, Row, Truth};

/// Where the origin of a truth lies whose places are counted otherwise than those of the fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// Where the others' lies.
    Same,
    /// Elsewhere: the truth is moved so that it lies on the first fix.
    Moved,
}

pub(crate) const ASK: &str = "It counts its places from another point than the positions do, which are in latitude \
                              and longitude where it is in metres, or the other way round: do the two origins lie in \
                              one place, or is it moved so that it lies on the first fix? Until that is known, an \
                              error against it means nothing; it may also be left out.";

/// True poses that are moved once the first fix is known.
#[derive(Clone, Debug, Default)]
pub(crate) struct Moved {
    /// Each, and whether its heading is known.
    pub poses: Vec<(Pose, bool)>,
}

impl Moved {
    /// Moves them so that they lie on the first of these fixes, and says by how much.
    pub fn onto(&mut self, rows: &[Row]) -> Option<String> {
        let (time, at) = first(rows)?;
        let from = Truth::new(self.poses.iter().map(|(pose, _)| *pose).collect()).position(time)?;
        let by = [at[0] - from[0], at[1] - from[1]];
        for (pose, _) in &mut self.poses {
            (pose.x, pose.y) = (pose.x + by[0], pose.y + by[1]);
        }
        let metres = by.map(|by| format!("{by:.2}").replace('-', "\u{2212}"));
        Some(format!(
            "The truth is moved by {} m along x and {} m along y, so that it lies on the first fix: what that fix \
             was off is in every error, and so is a turn between the axes of the two.",
            metres[0], metres[1]
        ))
    }
}

/// A fix that is farther from the truth than the whole truth reaches, and than this, m, is of another origin.
const FAR: f64 = 100.0;

/// What is said where the first fix lies far from the truth.
pub(crate) fn apart(drive: &Drive) -> Option<String> {
    let (time, at) = first(&drive.rows)?;
    let from = drive.truth.position(time)?;
    let mut ends = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for pose in drive.truth.poses() {
        let place = [pose.x, pose.y];
        ends = [[0, 1].map(|i| ends[0][i].min(place[i])), [0, 1].map(|i| ends[1][i].max(place[i]))];
    }
    let reach = libm::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
    let far = libm::hypot(at[0] - from[0], at[1] - from[1]);
    (far > reach + FAR)
        .then(|| format!("The first fix is {far:.0} m from the truth: are their origins, axes and units the same?"))
}

/// When the first fix was measured, and where it is.
fn first(rows: &[Row]) -> Option<(f64, [f64; 2])> {
    let fix = |row: &Row| if let Event::Position { x, y, .. } = row.event { Some((row.time, [x, y])) } else { None };
    rows.iter().filter_map(fix).min_by(|a, b| a.0.total_cmp(&b.0))
}
