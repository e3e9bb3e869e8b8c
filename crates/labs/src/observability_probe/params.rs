//! What a reader of the Probe can change.

use core::f64::consts::PI;
use estimate::Landmark;
use estimate::localizer::SensorKind;
use lab::MAX_STEP;
use lab::params;
use sim::scenarios::PROBE;
use std::sync::Arc;

params! {
    /// What the reader can change.
    pub struct ProbeParams {
        /// Where the three landmarks stand, [x, y] in room A.
        pub landmarks: [[f64; 2]; 3] = (PROBE.landmarks.map(|l| [l.x, l.y])), from 0.0 to (PROBE.room) by 0.05 in "m";
        /// How many of them are seen.
        pub count: u32 = 1, from 1.0 to 3.0 by 1.0;
        /// What is read of them.
        pub sensor: SensorKind = (SensorKind::Range);
        /// The step at which the robot stops; without one it drives on.
        pub stop: Option<u32> = None, from 0.0 to (MAX_STEP as f64) by 1.0;
        /// Whether the robot has lost its map and must found it anew, with range and bearing whatever the sensor.
        pub forget: bool = false;
        /// Whether a ghost of the robot drives along, from a start of its own; not where the map is forgotten.
        pub ghost: bool = false;
        /// By how much the ghost's start is turned about the first landmark, its heading left alone.
        pub ghost_around: f64 = 0.0, from (-PI / 9.0) to (PI / 9.0) by (PI / 180.0) in "rad";
        /// How far it is shifted to the east.
        pub ghost_shift: f64 = 0.0, from (-1.0) to 1.0 by 0.05 in "m";
        /// By how much it is turned on the spot.
        pub ghost_turn: f64 = 0.0, from (-PI / 9.0) to (PI / 9.0) by (PI / 180.0) in "rad";
        /// Below this part of the largest a singular value counts as zero.
        pub tolerance: f64 = 1e-6, from 0.0 to 1.0 by 1e-16;
        /// Fixes all noise.
        pub seed: u32 = 1;
    }
}

impl ProbeParams {
    /// The landmarks that are seen.
    pub(super) fn shown(&self) -> Arc<[Landmark]> {
        let all = self.landmarks.iter().zip(0..);
        all.take(self.count as usize).map(|(p, id)| Landmark { id, x: p[0], y: p[1] }).collect()
    }

    /// The sensor in effect.
    pub(super) fn sight(&self) -> SensorKind {
        if self.forget { SensorKind::RangeBearing } else { self.sensor }
    }
}
