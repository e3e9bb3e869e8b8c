//! Headings of a true track that has none: the direction of its way.

use estimate::drive::Pose;

/// Where the truth has no heading, it is the direction to the next true position that is so far away, m.
const HEADING_OVER: f64 = 0.2;

/// The poses by time, each headed for the next that is [`HEADING_OVER`] away; the last ones as the one before.
pub(crate) fn headed(poses: &mut [Pose]) -> Vec<Pose> {
    poses.sort_by(|a, b| a.time.total_cmp(&b.time));
    let (mut to, mut theta) = (0, 0.0);
    for i in 0..poses.len() {
        let from = poses[i];
        let away = |at: &Pose| (at.x - from.x) * (at.x - from.x) + (at.y - from.y) * (at.y - from.y);
        to = to.max(i);
        while to < poses.len() && away(&poses[to]) < HEADING_OVER * HEADING_OVER {
            to += 1;
        }
        if let Some(next) = poses.get(to) {
            theta = libm::atan2(next.y - from.y, next.x - from.x);
        }
        poses[i].theta = theta;
    }
    poses.to_vec()
}
