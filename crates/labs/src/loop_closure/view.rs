//! From the state of the corridor's loop to its frame.

use super::frame::{LoopFrame, LoopGate, LoopPull, LoopSighting, LoopThresholds};
use super::{LoopClosure, Weighed};
use crate::observability_probe::{map_shape, mapped_sighting};
use crate::odometry_hook::World;
use crate::shapes::{POSE_BAND, ellipse_of, rows};
use core::f64::consts::TAU;
use estimate::slam::{EkfSlam, Mapped};
use geom::SE2;
use nalgebra::{DMatrix, Vector2};
use numerics::Spd;
use sim::Apartment;
use sim::scenarios::LOOP_CLOSURE;
use std::sync::LazyLock;

/// Places on the edge of a gate, the first once more at the end.
const EDGE: usize = 49;

/// The unit circle.
static CIRCLE: LazyLock<[Vector2<f64>; EDGE]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let (sin, cos) = libm::sincos(TAU * (i % (EDGE - 1)) as f64 / (EDGE - 1) as f64);
        Vector2::new(cos, sin)
    })
});

pub(super) fn frame(lab: &LoopClosure) -> LoopFrame {
    let slam = &lab.mapping.slam;
    let (pose, p) = (slam.pose(), slam.pose_covariance());
    let constants = &lab.mapping.constants;
    LoopFrame {
        step: lab.step,
        lap: lab.step / constants.course.lap(),
        params: lab.params,
        world: World { reach: constants.sensor.reach, ..World::of(&Apartment::new()) },
        landmarks: LOOP_CLOSURE.landmarks,
        truth: lab.truth.to_vector().into(),
        predicted: lab.predicted.pose().to_vector().into(),
        estimate: pose.to_vector().into(),
        p: rows(&p),
        ellipse: ellipse_of(&p.fixed_view::<2, 2>(0, 0).into_owned()),
        error: lab.truth.boxminus(pose).into(),
        nees: lab.nees,
        mean_nees: lab.mean_nees(),
        nees_band: *POSE_BAND,
        thresholds: LoopThresholds {
            gate: constants.gate,
            found: constants.found,
            passes: -libm::expm1(-0.5 * constants.gate),
            ghosts: libm::exp(-0.5 * constants.found),
        },
        gates: gates(&lab.predicted, constants.gate, constants.sensor.reach),
        sightings: lab.sightings.iter().map(|sighting| shown(sighting, lab)).collect(),
        map: map_shape(&lab.mapping),
        correlation: correlation(&slam.belief().1),
        closure: lab.closure,
        series: lab.series.clone(),
        tracks: lab.tracks.outlined(),
        pulls: if lab.closure.is_some_and(|it| it.step == lab.step) { pulls(&lab.predicted, slam) } else { Vec::new() },
    }
}

/// What a step made of each landmark that was in the map before it: a map keeps the order in which it was founded.
fn pulls(before: &EkfSlam, after: &EkfSlam) -> Vec<LoopPull> {
    let pull = |(old, new): (Mapped, Mapped)| LoopPull {
        id: old.id,
        from: old.position.into(),
        ellipse: ellipse_of(&old.p),
        to: new.position.into(),
        // Rounding can leave a difference of equal variances a little below zero.
        reach: (0.5 * (old.p - new.p).trace()).max(0.0).sqrt(),
    };
    before.landmarks().zip(after.landmarks()).map(pull).collect()
}

/// Where a sighting puts its landmark, seen from this pose; the bearing is the landmark's.
fn placed(pose: SE2, range: f64, bearing: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(pose.theta() + bearing);
    [pose.x() - range * cos, pose.y() - range * sin]
}

/// The gate round each sighting that is expected within reach.
fn gates(slam: &EkfSlam, gate: f64, reach: f64) -> Vec<LoopGate> {
    let of = |landmark: Mapped| {
        let (expected, s) = slam.expected_sighting(landmark.id).ok().filter(|(z, _)| z[0] <= reach)?;
        let root = Spd::new(s)?.root() * gate.sqrt();
        let edge = CIRCLE.iter().map(|unit| {
            let sighting = expected + root * unit;
            placed(slam.pose(), sighting[0].max(0.0), sighting[1])
        });
        let (x, y) = edge.map(|[x, y]| (x, y)).unzip();
        Some(LoopGate { id: landmark.id, expected: expected.into(), s: rows(&s), x, y })
    };
    slam.landmarks().filter_map(of).collect()
}

fn shown(weighed: &Weighed, lab: &LoopClosure) -> LoopSighting {
    let Weighed { seen, chi2 } = weighed;
    let shape = mapped_sighting(seen, &lab.mapping);
    LoopSighting {
        landmark: seen.truth,
        range: seen.range,
        bearing: seen.bearing,
        at: placed(lab.predicted.pose(), seen.range, seen.bearing),
        chi2: *chi2,
        outcome: shape.outcome,
        to: shape.to,
    }
}

/// tr Pᵢⱼ / √(tr Pᵢᵢ tr Pⱼⱼ) for the positions of the robot and of each landmark.
fn correlation(p: &DMatrix<f64>) -> Vec<Vec<f64>> {
    let starts: Vec<usize> = core::iter::once(0).chain((3..p.nrows()).step_by(2)).collect();
    let trace = |a: usize, b: usize| p[(a, b)] + p[(a + 1, b + 1)];
    let of = |a: usize, b: usize| {
        let scale = trace(a, a) * trace(b, b);
        if scale > 0.0 { trace(a, b) / scale.sqrt() } else { 0.0 }
    };
    starts.iter().map(|&a| starts.iter().map(|&b| of(a, b)).collect()).collect()
}
