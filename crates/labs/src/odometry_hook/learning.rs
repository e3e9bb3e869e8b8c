//! The filter of the hook that has the right wheel's bias as a fourth state, and what its readings can tell of the
//! four.

use super::frame::WheelBelief;
use estimate::drive::{PoseAndScale, Scaled};
use estimate::kf::Gaussian;
use estimate::landmarks::RangeBearing;
use estimate::path_observability::PathStack;
use estimate::{Error, Localizer, RightWheel, Sighting};
use filters::{Ekf, MeasurementModel, MotionModel};
use geom::SE2;
use nalgebra::{DMatrix, Matrix2, Matrix4, SMatrix, U3, Vector2};
use sim::paths::Tick;
use sim::scenarios::HOOK;

const WHEEL: RightWheel = RightWheel { baseline: HOOK.wheels.baseline };
/// A singular value below this part of the largest counts as zero.
const TOLERANCE: f64 = 1e-9;

/// The same matrix with its sizes known at run time only, as the Probe's stack has them: one copy of the stack's code
/// serves both.
fn sized<const R: usize, const C: usize>(m: &SMatrix<f64, R, C>) -> DMatrix<f64> {
    DMatrix::from_column_slice(R, C, m.as_slice())
}

/// The filter. Its state is [x, y, θ, ε]; see [`RightWheel`].
#[derive(Clone, Debug)]
pub(super) struct Learning {
    ekf: Localizer<PoseAndScale, 4>,
    /// The readings used, along the true path.
    stack: PathStack,
    rank: usize,
}

impl Learning {
    /// The pose is known exactly at the start, the bias to its first standard deviation.
    pub fn new(start: SE2) -> Self {
        let mut p = Matrix4::zeros();
        p[(3, 3)] = HOOK.bias_sigma * HOOK.bias_sigma;
        Self {
            ekf: Localizer { filter: Ekf { x: PoseAndScale { pose: start, epsilon: 0.0 }, p } },
            stack: PathStack::new(4),
            rank: 0,
        }
    }

    /// The pose's part of the belief.
    pub fn belief(&self) -> Gaussian<U3> {
        Gaussian { x: self.ekf.filter.x.pose.to_vector(), p: self.ekf.filter.p.fixed_view::<3, 3>(0, 0).into_owned() }
    }

    /// The bias's part of the belief, beside the true ε.
    pub fn wheel(&self, truth: f64) -> WheelBelief {
        WheelBelief {
            epsilon: self.ekf.filter.x.epsilon,
            sigma: self.ekf.filter.p[(3, 3)].max(0.0).sqrt(),
            truth,
            rank: self.rank,
        }
    }

    /// The encoders say `u`. In truth the robot has driven the tick from the given pose.
    pub fn predict(&mut self, u: &Vector2<f64>, input: &Matrix2<f64>, (from, tick): (SE2, Tick)) -> Result<(), Error> {
        self.ekf.filter.predict(&WHEEL, u, &RightWheel::process_covariance(&self.ekf.filter.x.pose, input))?;
        if self.rank < 4 {
            let moved = Vector2::new(tick.ds, tick.dtheta);
            self.stack.advance(&sized(&WHEEL.jacobian(&PoseAndScale { pose: from, epsilon: 0.0 }, &moved)));
        }
        Ok(())
    }

    /// A corner was read from the true pose `from`. What four readings have shown stays shown: nothing is stacked any
    /// more.
    pub fn update(
        &mut self,
        model: RangeBearing<'_>,
        sighting: &Sighting<2>,
        w: &Matrix2<f64>,
        from: SE2,
    ) -> Result<(), Error> {
        let model = Scaled { sensor: model, scale: Some(0.0), offset: 0.0 };
        self.ekf.update_stacked(&model, core::slice::from_ref(sighting), w)?;
        if self.rank < 4 {
            let at = PoseAndScale { pose: from, epsilon: 0.0 };
            self.stack.observe(&sized(&model.jacobian(&at, sighting.j)?));
            self.rank = self.stack.analyze(TOLERANCE)?.start.rank;
        }
        Ok(())
    }
}
