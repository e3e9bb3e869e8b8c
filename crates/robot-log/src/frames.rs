//! From which point the places of a log's files are counted. Latitudes and longitudes become metres east and north of
//! the first of them; a table in metres has an origin of its own, and nobody but the reader knows where that lies.

use crate::own::{Own, shift};
use estimate::drive::{Drive, Event, Pose, Row, Truth};

/// Which frame and which clock a truth has that does not lie on the fixes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Frame {
    /// Those of the others.
    Same,
    /// Elsewhere: the truth is moved so that it lies on the fixes.
    Moved,
    /// At this latitude and longitude, in degrees.
    At([f64; 2]),
    /// Its own: the truth is turned, shifted and shifted in time so that it lies on all fixes.
    Own,
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

/// What is asked of landmarks and fixes in metres beside latitudes and longitudes.
pub(crate) const BESIDE: &str = "Its places are in metres, others are in latitude and longitude: where does its origin \
                                 lie? You may also leave the file out.";

/// True poses that are moved once the fixes are known.
#[derive(Clone, Debug, Default)]
pub(crate) struct Moved {
    /// Each, and whether its heading is known.
    pub poses: Vec<(Pose, bool)>,
}

impl Moved {
    /// Moves them so that they lie on these fixes, where they are few on the first, and says by how much.
    pub fn onto(&mut self, rows: &[Row]) -> Option<String> {
        let truth = Truth::new(self.poses.iter().map(|(pose, _)| *pose).collect());
        let onto_all = shift(rows, &truth);
        let by = match onto_all {
            Some((by, _)) => by,
            None => {
                let (time, at) = first(rows)?;
                let from = truth.position(time)?;
                [at[0] - from[0], at[1] - from[1]]
            }
        };
        for (pose, _) in &mut self.poses {
            (pose.x, pose.y) = (pose.x + by[0], pose.y + by[1]);
        }
        let ([x, y], turn) = (by.map(signed), "a turn between the axes of the two");
        let moved = format!("The truth is moved by {x} m along x and {y} m along y, so that it lies on the");
        Some(match onto_all {
            Some((_, sigma)) => format!(
                "{moved} positions: what all of them together are off by is in no error now, and the errors are no \
                 surer than the standard deviation of that, {sigma:.2} m. In every error is {turn}."
            ),
            None => format!("{moved} first position: what that is off by is in every error, and so is {turn}."),
        })
    }
}

/// A number with two decimals, and a minus that is one.
pub(crate) fn signed(number: f64) -> String {
    format!("{number:.2}").replace('-', "\u{2212}")
}

impl Own {
    /// What is done with the truth, in words that go on: "turned by 40.0° about its origin".
    fn done(&self) -> String {
        let late = if self.delay < 0.0 { "earlier" } else { "later" };
        let mut done = Vec::new();
        done.extend((self.delay != 0.0).then(|| format!("{:.2} s {late}", self.delay.abs())));
        if let Some(frame) = &self.frame {
            let degrees = format!("{:.1}", frame.turn.to_degrees()).replace('-', "\u{2212}");
            done.extend(frame.mirrored.then(|| "mirrored (its y against itself)".to_string()));
            done.extend((frame.turn != 0.0).then(|| format!("turned by {degrees}\u{b0} about its origin")));
            let [x, y] = frame.shift.map(signed);
            done.push(format!("shifted by {x} and {y} m"));
        }
        let last = done.pop().unwrap_or_default();
        if done.is_empty() { last } else { format!("{} and {last}", done.join(", ")) }
    }

    /// How near the truth then is to the positions.
    fn near(&self) -> String {
        let [before, after] = self.distances;
        format!("{after:.2} m from them instead of {before:.2} m (root mean square)")
    }

    /// What is asked of a truth that would lie on the fixes otherwise.
    pub(crate) fn question(&self) -> String {
        let (done, near) = (self.done(), self.near());
        let mut letters = done.chars();
        let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
        let (agree, another) = match (self.frame, self.delay != 0.0) {
            (Some(_), false) => ("", "is its frame another one"),
            (None, _) => (", and goes as the motion does", "is its clock another one"),
            (Some(_), true) => (", and goes as the motion does", "are its frame and its clock others"),
        };
        format!(
            "{first}{}, the truth lies on the positions, {near}{agree}: {another}? Until that is said, no error \
             against it means anything.",
            letters.as_str()
        )
    }

    /// What is said of a truth that was brought onto the fixes, and what it costs.
    pub(crate) fn note(&self) -> String {
        let [turn, shift, delay] = self.sigmas;
        let (mut known, mut lost) = (Vec::new(), Vec::new());
        if let Some(frame) = &self.frame {
            let turned = frame.turn != 0.0;
            known.extend(turned.then(|| format!("{:.2}\u{b0} of the turn", turn.to_degrees())));
            known.push(format!("{shift:.2} m of the shift"));
            lost.push(if turned { "off and turned by" } else { "off by" });
        }
        if self.delay != 0.0 {
            known.push(format!("{delay:.3} s of the clock"));
            lost.push("late by");
        }
        format!(
            "The truth is {}, so that it lies on the positions, {}: what all positions together are {} is in no error \
             now, and the errors are no surer than the standard deviations of that, {}.",
            self.done(),
            self.near(),
            lost.join(" or "),
            known.join(" and ")
        )
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
