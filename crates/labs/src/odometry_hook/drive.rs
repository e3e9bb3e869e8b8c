//! The run of the odometry hook: truth, encoders, sensor and filter, without a memory of the past.

use super::HookParams;
use super::frame::{CornerSighting, LastSighting, Quality, Spread, WheelBelief};
use super::learning::Learning;
use estimate::kf::Gaussian;
use estimate::landmarks::RangeBearing;
use estimate::{Code, Error, Localizer, Sighting, Unicycle, odometry_delta, slip_covariance};
use geom::{SE2, angle_diff};
use lab::Params;
use nalgebra::{Matrix2, Matrix3, U3, Vector2};
use sim::scenarios::HOOK;
use sim::{Apartment, Noise, Rusty};

/// The filter, with or without the wheel's bias in its state.
#[derive(Clone, Debug)]
enum Filter {
    Pose(Localizer),
    Learning(Box<Learning>),
}

/// The run itself.
#[derive(Clone, Debug)]
pub struct Drive {
    /// What the reader chose.
    pub params: HookParams,
    /// Where it drives.
    pub home: Apartment,
    rusty: Rusty,
    /// Slip and sensor noise come from streams of their own, so that turning fixes on changes no encoder tick.
    slip: Noise,
    sensor: Noise,
    /// Ticks so far.
    pub step: u32,
    input_covariance: Matrix2<f64>,
    w: Matrix2<f64>,
    filter: Filter,
    pub(crate) predicted: Gaussian<U3>,
    pub(crate) u: Option<Vector2<f64>>,
    /// What it sees at this tick.
    pub seen: Vec<CornerSighting>,
    /// The last sighting of all.
    pub last: Option<LastSighting>,
    /// The corners within reach and in sight.
    near: Vec<u32>,
}

impl Drive {
    /// The robot at its start.
    ///
    /// # Errors
    /// As a lab's.
    pub fn new(params: HookParams) -> Result<Self, Error> {
        params.check()?;
        Self::with_bias(params, params.bias)
    }

    /// With a bias that the slider need not reach.
    ///
    /// # Errors
    /// As a lab's.
    pub fn with_bias(params: HookParams, bias: f64) -> Result<Self, Error> {
        let start = HOOK.course.start();
        let belief = Gaussian { x: start.to_vector(), p: Matrix3::zeros() };
        let sigma = Vector2::new(HOOK.sensor.range_sigma, HOOK.sensor.bearing_sigma);
        Ok(Self {
            params,
            home: Apartment::new(),
            rusty: Rusty::new(start, HOOK.wheels, bias, params.slip),
            slip: Noise::new(u64::from(params.seed)),
            sensor: Noise::new(u64::from(params.seed) | 1 << 32),
            step: 0,
            input_covariance: slip_covariance(&HOOK.wheels, params.slip),
            w: Matrix2::from_diagonal(&sigma.component_mul(&sigma)),
            filter: if params.learn {
                Filter::Learning(Box::new(Learning::new(start)))
            } else {
                Filter::Pose(Localizer::new(&belief))
            },
            predicted: belief,
            u: None,
            seen: Vec::new(),
            last: None,
            near: Vec::new(),
        })
    }

    pub(crate) fn truth(&self) -> SE2 {
        self.rusty.pose()
    }

    pub(crate) fn belief(&self) -> Gaussian<U3> {
        match &self.filter {
            Filter::Pose(ekf) => ekf.belief(),
            Filter::Learning(learning) => learning.belief(),
        }
    }

    /// What is believed of the wheel, where its bias is a state.
    pub(crate) fn wheel(&self) -> Option<WheelBelief> {
        match &self.filter {
            Filter::Pose(_) => None,
            // The encoder counts 1 + bias where the wheel rolls 1.
            Filter::Learning(learning) => Some(learning.wheel(self.params.bias / (1.0 + self.params.bias))),
        }
    }

    /// One tick.
    ///
    /// # Errors
    /// Whatever the core answers.
    pub fn advance(&mut self) -> Result<(), Error> {
        let (tick, from) = (HOOK.course.tick(self.step), self.truth());
        let counted = self.rusty.drive(tick, &mut self.slip);
        self.step += 1;
        let u = odometry_delta(&HOOK.wheels, counted);
        match &mut self.filter {
            Filter::Pose(ekf) => {
                ekf.predict(&u, &Unicycle::process_covariance(&ekf.pose(), &self.input_covariance))?;
            }
            Filter::Learning(learning) => learning.predict(&u, &self.input_covariance, (from, tick))?,
        }
        self.u = Some(u);
        self.predicted = self.belief();
        self.look();
        self.fix()
    }

    /// Reads each corner once as it comes within reach and in sight, whether or not the reading is used.
    fn look(&mut self) {
        let truth = self.truth();
        let was_near = core::mem::take(&mut self.near);
        self.seen.clear();
        for corner in self.home.corners {
            if HOOK.sensor.reaches(truth, corner) && self.home.in_sight(truth, corner) {
                self.near.push(corner.id);
                if !was_near.contains(&corner.id) {
                    let reading = HOOK.sensor.sight(truth, corner, &mut self.sensor);
                    let (range, bearing) = (reading.range, reading.bearing);
                    self.seen.push(CornerSighting { landmark: corner.id, x: corner.x, y: corner.y, range, bearing });
                }
            }
        }
        if let Some(seen) = self.seen.last() {
            let CornerSighting { landmark, x, y, range, bearing } = *seen;
            let from = [truth.x(), truth.y()];
            self.last = Some(LastSighting { step: self.step, landmark, x, y, range, bearing, from });
        }
    }

    fn fix(&mut self) -> Result<(), Error> {
        if !self.params.fixes || self.seen.is_empty() {
            return Ok(());
        }
        let (map, truth) = (self.home.corners, self.truth());
        let model = RangeBearing { map };
        let sightings: Vec<Sighting<2>> = self
            .seen
            .iter()
            .filter_map(|seen| {
                let j = map.iter().position(|corner| corner.id == seen.landmark)?;
                Some(Sighting { j, y: Vector2::new(seen.range, seen.bearing) })
            })
            .collect();
        let fixed = match &mut self.filter {
            Filter::Pose(ekf) => ekf.update_stacked(&model, &sightings, &self.w).map(|_| ()),
            Filter::Learning(learning) => sightings.iter().try_for_each(|s| learning.update(model, s, &self.w, truth)),
        };
        match fixed {
            // Where the estimate stands on the corner its sighting cannot be linearized, and is left out.
            Err(error) if error.code != Code::AtLandmark => Err(error),
            _ => Ok(()),
        }
    }

    /// The error, what is claimed of it, and their ratio.
    pub fn quality(&self) -> (Quality, Spread) {
        let (truth, Gaussian { x, p }) = (self.truth(), self.belief());
        let pose = SE2::from_vector(&x);
        let off = pose.boxminus(truth);
        let error =
            Quality { position: numerics::hypot(off[0], off[1]), heading: angle_diff(pose.theta(), truth.theta()) };
        let sigma = Spread { position: (p[(0, 0)] + p[(1, 1)]).max(0.0).sqrt(), heading: p[(2, 2)].max(0.0).sqrt() };
        (error, sigma)
    }
}
