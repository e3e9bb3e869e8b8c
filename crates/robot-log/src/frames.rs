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

/// What is asked of a truth whose origin is not that of the fixes. Either it is in latitude and longitude, and they are
/// in metres, or it is the other way round.
pub(crate) fn question(truth_is_global: bool) -> String {
    let (truth, fixes) = ("in metres", "in latitude and longitude");
    let (truth, fixes) = if truth_is_global { (fixes, truth) } else { (truth, fixes) };
    format!(
        "Its places are {truth}, the positions are {fixes}: where does its origin lie? Until that is said, no error \
         against it means anything. You may also leave the file out."
    )
}

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
