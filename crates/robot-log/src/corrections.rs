//! What is read otherwise than the files have it, as a verdict on the log proposes it: distances and turns by factors,
//! turns by an angle on each metre, landmarks at other places, the ranges of one shorter, and a part of the log alone.

use crate::frames::signed;
use estimate::drive::{Drive, Event};
use std::collections::BTreeMap;

/// No range is taken shorter than this, m.
const LEAST: f64 = 1e-3;

/// What is read otherwise than the files have it.
#[derive(Clone, Debug, PartialEq)]
pub struct Corrections {
    /// How many times distances and speeds, and how many times turns and turn rates, are taken as they are read.
    pub driven: [f64; 2],
    /// By how much more to its left the robot turns on each metre than is read, rad, where distance and turn, or speed
    /// and turn rate, stand in one row; counted in what `driven` makes of them.
    pub swerve: f64,
    /// Where landmarks stand instead, by their numbers; m.
    pub landmarks: BTreeMap<u32, [f64; 2]>,
    /// By how much ranges are taken shorter than they are read, by the numbers of their landmarks; m.
    pub ranges: BTreeMap<u32, f64>,
    /// From when to when the log is read, s since the first row of its files; all of it where nothing is said.
    pub kept: Option<[f64; 2]>,
}

impl Default for Corrections {
    fn default() -> Self {
        Self { driven: [1.0; 2], swerve: 0.0, landmarks: BTreeMap::new(), ranges: BTreeMap::new(), kept: None }
    }
}

impl Corrections {
    /// Whether a log can be read so: factors are above 0, a part ends after it begins, and all is finite.
    pub(crate) fn is_sound(&self) -> bool {
        let factor = |by: &f64| by.is_finite() && *by > 0.0;
        let metres = self.landmarks.values().flatten().chain(self.ranges.values());
        let part = self.kept.is_none_or(|[from, to]| from.is_finite() && to.is_finite() && from < to);
        part && self.swerve.is_finite() && self.driven.iter().all(factor) && { metres }.all(|at| at.is_finite())
    }

    /// Reads a log so, and says what was done; what it says of landmarks or of motion that the log has not does
    /// nothing.
    pub(crate) fn onto(&self, drive: &mut Drive, names: &[String]) -> Vec<String> {
        let mut said = Vec::new();
        let ([far, much], mut driven, mut turned, mut swerved) = (self.driven, false, false, false);
        for row in &mut drive.rows {
            match &mut row.event {
                Event::Odometry { distance, turn } => {
                    *distance *= far;
                    (*turn, swerved) = (much * *turn + self.swerve * *distance, true);
                }
                Event::Velocity { v, omega } => {
                    *v *= far;
                    (*omega, driven, turned, swerved) = (much * *omega + self.swerve * *v, true, true, true);
                }
                Event::Speed { v } => (*v, driven) = (far * *v, true),
                Event::TurnRate { omega } => (*omega, turned) = (much * *omega, true),
                _ => {}
            }
        }
        if drive.motion.is_odometry() && self.driven != [1.0; 2] {
            said.push(format!(
                "Distances of odometry are taken {far:.4} times as they are read, and turns {much:.4} times."
            ));
        } else {
            let factors = [(driven, "Speeds", far), (turned, "Turn rates", much)];
            let off = factors.into_iter().filter(|(there, _, by)| *there && *by != 1.0);
            said.extend(off.map(|(_, what, by)| format!("{what} are taken {by:.4} times as they are read.")));
        }
        if swerved && self.swerve != 0.0 {
            let side = if self.swerve > 0.0 { "left" } else { "right" };
            let much = self.swerve.abs().to_degrees();
            said.push(format!("On each metre {much:.3}\u{b0} more to the {side} is turned than is read."));
        }
        let name = |id: u32| {
            let name = names.get((id as usize).wrapping_sub(1)).cloned();
            name.unwrap_or_else(|| id.to_string())
        };
        let shorter: Vec<f64> =
            drive.landmarks.iter().map(|it| self.ranges.get(&it.id).copied().unwrap_or(0.0)).collect();
        for row in &mut drive.rows {
            if let Event::Range { landmark, range } | Event::RangeBearing { landmark, range, .. } = &mut row.event
                && let Some(by) = shorter.get(*landmark).filter(|by| **by != 0.0)
            {
                *range = (*range - by).max(LEAST);
            }
        }
        for (landmark, by) in drive.landmarks.iter().zip(shorter).filter(|(_, by)| *by != 0.0) {
            let how = if by > 0.0 { "shorter" } else { "longer" };
            said.push(format!(
                "Ranges to landmark {} are taken {:.3} m {how} than they are read.",
                name(landmark.id),
                by.abs()
            ));
        }
        for landmark in &mut drive.landmarks {
            let elsewhere = self.landmarks.get(&landmark.id).filter(|place| **place != [landmark.x, landmark.y]);
            let Some([x, y]) = elsewhere else { continue };
            let places = [landmark.x, landmark.y, *x, *y].map(signed);
            let [from_x, from_y, to_x, to_y] = places;
            let name = name(landmark.id);
            said.push(format!("Landmark {name} is taken at ({to_x}, {to_y}) m, and not at ({from_x}, {from_y}) m."));
            (landmark.x, landmark.y) = (*x, *y);
        }
        said
    }
}
