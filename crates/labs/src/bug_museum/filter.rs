//! A filter with a bug in it: the extended Kalman filter of the core, put together anew with one line wrong.

use super::Bug;
use core::f64::consts::{PI, TAU};
use estimate::Unicycle;
use estimate::landmarks::RangeBearing;
use filters::consistency::nis;
use filters::{Ekf, MeasurementModel, MotionModel, linear};
use geom::SE2;
use nalgebra::{Matrix2, Matrix2x3, Matrix3, Vector2, Vector3};
use numerics::{Spd, all_finite};
use sim::Sighting;
use sim::scenarios::BUG_MUSEUM;

/// How many steps a late reading is late.
pub(super) const DELAY: usize = 2;
/// The factor of the gain that is scaled by hand.
const HAND: f64 = 1.3;
/// How many times as long the step is that V was made for.
const STEP: f64 = 16.0;
/// A belief with a number beyond this is not taken: a wrong filter may diverge without end.
const FAR: f64 = 1e9;

/// What the filter made of a reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Outcome {
    pub innovation: Vector2<f64>,
    pub s: Matrix2<f64>,
    /// νᵀS⁻¹ν; none where S is no covariance.
    pub nis: Option<f64>,
    /// Whether it corrected the estimate.
    pub used: bool,
}

impl Outcome {
    /// Each part of the innovation in its own standard deviations.
    pub fn normalized(&self) -> [f64; 2] {
        [0, 1].map(|i| self.innovation[i] / self.s[(i, i)].sqrt())
    }
}

/// The filter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Filter {
    bugs: [Bug; 2],
    /// x̂; its heading may leave (−π, π] with one of the bugs.
    pub x: Vector3<f64>,
    pub p: Matrix3<f64>,
    /// The first estimate, and the one at which each landmark was first sighted: where a Jacobian is computed once.
    first: SE2,
    first_sights: [Option<SE2>; BUG_MUSEUM.landmarks.len()],
}

impl Filter {
    pub fn new(bugs: [Bug; 2], x: Vector3<f64>) -> Self {
        let p = crate::true_path::squares(BUG_MUSEUM.p0_sigma);
        Self { bugs, x, p, first: SE2::from_vector(&x), first_sights: [None; _] }
    }

    fn has(&self, bug: Bug) -> bool {
        self.bugs.contains(&bug)
    }

    /// Whether the covariance is computed here: the core mends what a bug breaks.
    fn breaks_covariance(&self) -> bool {
        [Bug::Transposed, Bug::ShortForm, Bug::Asymmetric].iter().any(|bug| self.has(*bug))
    }

    pub fn pose(&self) -> SE2 {
        SE2::from_vector(&self.x)
    }

    /// The prediction with u = [Δs, Δθ].
    pub fn predict(&mut self, u: &Vector2<f64>) {
        let pose = self.pose();
        let input = Matrix2::from_diagonal(&Vector2::from(BUG_MUSEUM.u_sigma.map(|s| s * s)));
        let scale = if self.has(Bug::StepLength) { STEP } else { 1.0 };
        let v = Unicycle::process_covariance(&pose, &input) * scale;
        let mut core = Ekf { x: pose, p: self.p };
        if self.breaks_covariance() {
            let moved = Unicycle.f(&pose, u);
            let f = Unicycle.jacobian(if self.has(Bug::FrozenJacobian) { &self.first } else { &pose }, u);
            let f = if self.has(Bug::Transposed) { f.transpose() } else { f };
            core = Ekf { x: moved, p: f * self.p * f.transpose() + v };
        } else if self.has(Bug::FrozenJacobian) {
            let f = Unicycle.jacobian(&self.first, u);
            let Ok(p) = linear::predicted_covariance(&f, &self.p, &v) else { return };
            core = Ekf { x: Unicycle.f(&pose, u), p };
        } else if core.predict(&Unicycle, u, &v).is_err() {
            return;
        }
        let x = self.kept_heading(core.x, self.x[2] + u[1]);
        self.carry_on(x, core.p);
    }

    /// Corrects with a reading. Answers the outcome of each use of it: two where it is used twice.
    pub fn update(&mut self, seen: &Sighting) -> impl Iterator<Item = Outcome> + use<> {
        let first = self.correct(seen);
        let second = if self.has(Bug::Twice) { self.correct(seen) } else { None };
        [first, second].into_iter().flatten()
    }

    /// None where the estimate stands on the landmark: there is nothing to expect.
    fn correct(&mut self, seen: &Sighting) -> Option<Outcome> {
        let (model, j) = (RangeBearing { map: &BUG_MUSEUM.landmarks }, seen.landmark as usize);
        let pose = self.pose();
        let (mut expected, mut h) = model.linearized(&pose, j).ok()?;
        if self.has(Bug::FrozenJacobian) {
            h = model.jacobian(self.first_sights.get_mut(j)?.get_or_insert(pose), j).ok()?;
        }
        if self.has(Bug::WrongDerivative) {
            h[(1, 2)] = -1.0 / (expected[0] * expected[0]);
        }
        let z = Vector2::new(seen.range, seen.bearing);
        let mut innovation = model.residual(&z, &expected);
        if self.has(Bug::UnwrappedHeading) {
            expected[1] += pose.theta() - self.x[2];
            let off = z[1] - expected[1];
            innovation[1] = if off.abs() > PI { off - libm::copysign(TAU, off) } else { off };
        }
        if self.has(Bug::UnwrappedInnovation) {
            innovation[1] = z[1] - expected[1];
        }
        let w = self.reading_covariance();
        let s = linear::innovation_covariance(&h, &self.p, &w);
        let nis = nis(&innovation, &s).ok();
        let gate = if self.has(Bug::OpenGate) { f64::INFINITY } else { BUG_MUSEUM.gate };
        let used = nis.is_some_and(|nis| nis <= gate) && self.apply(&innovation, &h, &w, s);
        Some(Outcome { innovation, s, nis, used })
    }

    /// W.
    fn reading_covariance(&self) -> Matrix2<f64> {
        let sensor = BUG_MUSEUM.sensor;
        let bearing = if self.has(Bug::Degrees) { sensor.bearing_sigma.to_degrees() } else { sensor.bearing_sigma };
        let entry = |sigma: f64| if self.has(Bug::Deviation) { sigma } else { sigma * sigma };
        Matrix2::new(entry(sensor.range_sigma), 0.0, 0.0, entry(bearing))
    }

    fn apply(&mut self, nu: &Vector2<f64>, h: &Matrix2x3<f64>, w: &Matrix2<f64>, s: Matrix2<f64>) -> bool {
        let mut core = Ekf { x: self.pose(), p: self.p };
        let step = if self.breaks_covariance() {
            let Some(factor) = Spd::new(s) else { return false };
            let hp = h * self.p;
            let gain = factor.solve(&hp).transpose() * if self.has(Bug::ShortForm) { HAND } else { 1.0 };
            let short = self.has(Bug::ShortForm) || self.has(Bug::Asymmetric);
            core.p = if short { self.p - gain * hp } else { linear::joseph(&self.p, &gain, h, w) };
            if self.has(Bug::ShortForm) && !self.has(Bug::Asymmetric) {
                core.p = filters::covariance::symmetric(core.p);
            }
            core.x = core.x.boxplus(&(gain * nu));
            gain * nu
        } else {
            let Ok(update) = core.correct(nu, h, w) else { return false };
            update.k * nu
        };
        let x = self.kept_heading(core.x, self.x[2] + step[2]);
        self.carry_on(x, core.p)
    }

    /// The pose as a vector, its heading unwrapped where the bug is.
    fn kept_heading(&self, pose: SE2, heading: f64) -> Vector3<f64> {
        let theta = if self.has(Bug::UnwrappedHeading) { heading } else { pose.theta() };
        Vector3::new(pose.x(), pose.y(), theta)
    }

    /// Takes the new belief, unless its numbers are too large to be drawn: a wrong filter may diverge.
    fn carry_on(&mut self, x: Vector3<f64>, p: Matrix3<f64>) -> bool {
        let sound = all_finite(x.iter().chain(p.iter())) && x.amax() < FAR && p.amax() < FAR;
        if sound {
            (self.x, self.p) = (x, p);
        }
        sound
    }
}
