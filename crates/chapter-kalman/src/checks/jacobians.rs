//! Check 8: the Jacobians of the sensor, in both forms, and of the motion, against each other and against differences.

use crate::givens::Givens;
use estimate::Error;
use estimate::Unicycle;
use estimate::landmarks::{RangeBearing, raw_bearing_row};
use filters::{MeasurementModel, MotionModel};
use geom::SE2;
use lab::Check;
use nalgebra::{Vector2, Vector3};
use sim::scenarios::{HOOK, PROBE};

/// The step of the central differences: at 10⁻⁵ truncation and rounding are both near 10⁻¹⁰.
const STEP: f64 = 1e-5;
/// Bars of the two gaps.
const BARS: [f64; 2] = [1e-15, 1e-9];

/// The poses compared at: the Probe's lap, with headings that are no multiple of a quarter turn.
fn poses() -> impl Iterator<Item = SE2> {
    let turn = |(k, pose): (u32, SE2)| SE2::new(pose.x(), pose.y(), pose.theta() + 0.05 * f64::from(k));
    (0..).zip(PROBE.course.poses()).take(PROBE.course.lap() as usize).map(turn)
}

/// The largest difference between the simplified bearing row and the raw one.
pub(crate) fn raw_gap() -> Result<f64, Error> {
    let model = RangeBearing { map: &PROBE.landmarks };
    let mut gap = 0.0_f64;
    for pose in poses() {
        for (j, landmark) in PROBE.landmarks.iter().enumerate() {
            // Straight above or below the landmark the raw row is 0/0.
            if (pose.x() - landmark.x).abs() > 1e-9 {
                let simplified = model.jacobian(&pose, j)?;
                gap = gap.max((simplified.row(1) - raw_bearing_row(&pose, landmark)).amax());
            }
        }
    }
    Ok(gap)
}

/// The largest difference between an analytic Jacobian, of the sensor or of the motion, and central differences.
pub(crate) fn central_gap() -> Result<f64, Error> {
    let model = RangeBearing { map: &PROBE.landmarks };
    let u = Vector2::new(HOOK.course.ds, 0.3);
    let mut gap = 0.0_f64;
    for pose in poses() {
        let motion = Unicycle.jacobian(&pose, &u);
        for i in 0..3 {
            let step = Vector3::ith(i, STEP);
            let (ahead, behind) = (pose.boxplus(&step), pose.boxplus(&-step));
            let slope = Unicycle.f(&ahead, &u).boxminus(Unicycle.f(&behind, &u)) / (2.0 * STEP);
            gap = gap.max((slope - motion.column(i)).amax());
            for j in 0..PROBE.landmarks.len() {
                let slope = model.residual(&model.h(&ahead, j)?, &model.h(&behind, j)?) / (2.0 * STEP);
                gap = gap.max((slope - model.jacobian(&pose, j)?.column(i)).amax());
            }
        }
    }
    Ok(gap)
}

/// Check 8: both gaps, each in units of its bar, 10⁻¹⁵ and 10⁻⁹.
pub(super) fn agreement(_: &Givens) -> Result<Check, Error> {
    let gaps = [raw_gap()? / BARS[0], central_gap()? / BARS[1]];
    let title = "The Jacobians: simplified against raw, in 10⁻¹⁵, and against central differences, in 10⁻⁹";
    Ok(Check::new(8, title, vec![0.0, 0.0], gaps.to_vec(), 1.0))
}
