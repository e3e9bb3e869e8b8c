//! Where the robot really was, as far as it is known.

use alloc::vec::Vec;

/// A pose at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// s.
    pub time: f64,
    /// m.
    pub x: f64,
    /// m.
    pub y: f64,
    /// rad.
    pub theta: f64,
}

/// The true poses of a log by time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Truth {
    poses: Vec<Pose>,
}

impl Truth {
    /// The poses in the order of their times.
    pub fn new(mut poses: Vec<Pose>) -> Self {
        poses.sort_by(|a, b| a.time.total_cmp(&b.time));
        Self { poses }
    }

    /// The poses, by time, those of one time in the order of their lines.
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    /// Whether the true position at `time` is known, and not that of the pose nearest to it.
    pub(crate) fn covers(&self, time: f64) -> bool {
        let (first, last) = (self.poses.first(), self.poses.last());
        first.zip(last).is_some_and(|(first, last)| first.time < last.time && first.time <= time && time <= last.time)
    }

    /// The true position at `time`, interpolated linearly in time; before the first pose the first, after the last the
    /// last. `None` in a log without truth.
    pub fn position(&self, time: f64) -> Option<[f64; 2]> {
        let after = self.poses.partition_point(|pose| pose.time <= time);
        let (first, last) = (self.poses.first()?, self.poses.last()?);
        if after == 0 {
            return Some([first.x, first.y]);
        }
        let Some(next) = self.poses.get(after) else {
            return Some([last.x, last.y]);
        };
        // Not equal: the pose before is at or before `time`, the next after it.
        let before = self.poses[after - 1];
        let share = (time - before.time) / (next.time - before.time);
        Some([before.x + share * (next.x - before.x), before.y + share * (next.y - before.y)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_position_is_interpolated_between_poses_and_held_outside_them() {
        let pose = |time, x| Pose { time, x, y: -x, theta: 0.0 };
        let truth = Truth::new(vec![pose(2.0, 6.0), pose(1.0, 4.0), pose(2.0, 8.0), pose(4.0, 0.0)]);
        let x = |time| truth.position(time).expect("known")[0];
        assert_eq!([x(0.0), x(1.0), x(1.5), x(2.0), x(3.0), x(9.0)], [4.0, 4.0, 5.0, 8.0, 4.0, 0.0]);
        assert_eq!(truth.position(1.5), Some([5.0, -5.0]));
        assert_eq!(Truth::default().position(1.0), None);
    }
}
