//! What the readings of a drive can tell: frozen at one pose, and stacked along the last steps.

use estimate::Landmark;
use estimate::landmarks::{RangeBearing, RangeOnly};
use estimate::localizer::SensorKind;
use estimate::observability::Observability;
use estimate::path_observability::{PathStack, frozen};
use estimate::{Error, Unicycle};
use filters::{MeasurementModel, MotionModel};
use geom::SE2;
use lab::record;
use nalgebra::{DMatrix, DVector, Vector2};
use std::sync::Arc;

/// One moment of a drive: the pose, the map at that time, and the input of the step that followed.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Where readings and motion are linearized.
    pub pose: SE2,
    /// The landmarks as they were believed to be (or are).
    pub landmarks: Arc<[Landmark]>,
    /// The input of the step that followed.
    pub u: Vector2<f64>,
}

record! {
    /// A rank with what stands behind it, as a view draws it. The default stands where no rank could be found.
    #[derive(Default)]
    pub struct ProbeRanks {
        /// Singular values above the tolerance.
        pub rank: usize,
        /// States.
        pub n: usize,
        /// In decreasing order.
        pub singular_values: Vec<f64>,
        /// The same, each divided by the largest (zeros where that is zero).
        pub relative: Vec<f64>,
        /// Orthonormal directions that no reading sees; for a stack, at its start.
        pub nullspace: Vec<Vec<f64>>,
        /// The same at the present pose, the robot's part: [dx, dy, dθ], of length 1 in the plane, or a pure turn dθ =
        /// 1.
        pub directions: Vec<[f64; 3]>,
        /// Steps stacked; 0 for a frozen pair.
        pub steps: usize,
    }
}

impl ProbeRanks {
    fn new(found: Observability, now: &[DVector<f64>], steps: usize) -> Self {
        let largest = found.singular_values.first().copied().unwrap_or(0.0);
        let relative = |s: &f64| if largest > 0.0 { s / largest } else { 0.0 };
        Self {
            rank: found.rank,
            n: found.n,
            relative: found.singular_values.iter().map(relative).collect(),
            singular_values: found.singular_values,
            nullspace: found.nullspace.iter().map(|c| c.iter().copied().collect()).collect(),
            directions: now.iter().map(|c| direction([c[0], c[1], c[2]])).collect(),
            steps,
        }
    }
}

/// A displacement [dx, dy, dθ] scaled to length 1 in the plane. A direction has no sign: this one is turned so that its
/// first component of any size is positive.
pub(super) fn direction(c: [f64; 3]) -> [f64; 3] {
    let planar = numerics::hypot(c[0], c[1]);
    let scale = if planar > 1e-9 {
        planar
    } else if c[2].abs() > 1e-9 {
        c[2].abs()
    } else {
        return [0.0; 3];
    };
    let facing = if c[0].abs() > 1e-9 * planar { c[0] } else { c[1] + c[2] };
    c.map(|e| e / libm::copysign(scale, facing))
}

/// The rows of H over the pose, and over the map's coordinates too when the map is part of the state. A landmark
/// under the robot has no row.
pub(crate) fn output_rows(pose: &SE2, landmarks: &[Landmark], sight: SensorKind, mapped: bool) -> DMatrix<f64> {
    let mut h = DMatrix::zeros(0, 3 + if mapped { 2 * landmarks.len() } else { 0 });
    for j in 0..landmarks.len() {
        let block = match sight {
            SensorKind::Range => RangeOnly { map: landmarks }.jacobian(pose, j).map(|h| h.resize_vertically(1, 0.0)),
            SensorKind::RangeBearing => {
                RangeBearing { map: landmarks }.jacobian(pose, j).map(|h| h.resize_vertically(2, 0.0))
            }
        };
        let Ok(block) = block else { continue };
        let (from, outputs) = (h.nrows(), block.nrows());
        h = h.resize_vertically(from + outputs, 0.0);
        h.view_mut((from, 0), (outputs, 3)).copy_from(&block);
        if mapped {
            h.view_mut((from, 3 + 2 * j), (outputs, 2)).copy_from(&-block.columns(0, 2));
        }
    }
    h
}

fn motion(moment: &Moment, n: usize) -> DMatrix<f64> {
    let mut f = DMatrix::identity(n, n);
    f.fixed_view_mut::<3, 3>(0, 0).copy_from(&Unicycle.jacobian(&moment.pose, &moment.u));
    f
}

/// The ranks of the pair (F, H) of one moment, as if that moment lasted.
///
/// # Errors
/// As [`frozen`].
pub fn frozen_ranks(moment: &Moment, sight: SensorKind, mapped: bool, tolerance: f64) -> Result<ProbeRanks, Error> {
    let h = output_rows(&moment.pose, &moment.landmarks, sight, mapped);
    let found = frozen(&motion(moment, h.ncols()), &h, tolerance)?;
    let now = found.nullspace.clone();
    Ok(ProbeRanks::new(found, &now, 0))
}

/// The ranks of the stack along a drive. The motion that follows the last moment is left out.
///
/// # Errors
/// As [`PathStack::analyze`].
pub fn stacked_ranks<'m>(
    moments: impl DoubleEndedIterator<Item = &'m Moment> + Clone,
    sight: SensorKind,
    mapped: bool,
    tolerance: f64,
) -> Result<ProbeRanks, Error> {
    // A landmark founded on the way enters the state from then on: only the moments that know the whole map are
    // stacked.
    let known = moments.clone().next_back().map_or(0, |m| m.landmarks.len());
    let n = 3 + if mapped { 2 * known } else { 0 };
    let mut stack = PathStack::new(n);
    let whole: Vec<&Moment> = moments.filter(|m| !mapped || m.landmarks.len() == known).collect();
    for (i, moment) in whole.iter().enumerate() {
        stack.observe(&output_rows(&moment.pose, &moment.landmarks, sight, mapped));
        if i + 1 < whole.len() {
            stack.advance(&motion(moment, n));
        }
    }
    let found = stack.analyze(tolerance)?;
    Ok(ProbeRanks::new(found.start, &found.now, found.steps))
}
