//! The odometry hook: a loop of the corridor on encoders, with a wheel that is not as large as the software believes.
//!
//! Truth keeps to the loop; the estimate follows the encoders, and its claimed covariance knows of the slip and not of
//! the bias. Landmark fixes, when they are on, are one range and bearing of each mapped corner as it comes within reach.

use crate::lab::{Digest, Lab};
use crate::odometry_frame::{Belief3, HookFrame, LastSighting, Quality, Record, Seen, Spread, World};
use estimate::kf::Gaussian;
use estimate::landmarks::RangeBearing;
use estimate::{ChosetEkf, Code, Error, Sighting, Unicycle, odometry_delta, slip_covariance, validate};
use geom::{SE2, angle_diff};
use nalgebra::{Matrix2, Matrix3, U3, Vector2};
use serde::Serialize;
use sim::scenarios::HOOK;
use sim::{Apartment, Noise, Rusty};

/// The greatest bias of the wheel's radius: past a quarter turn of heading error in two laps.
pub const MAX_BIAS: f64 = 0.01;
/// The greatest slip, metres per wheel and tick: a tenth of the way.
pub const MAX_SLIP: f64 = 0.005;

/// What the reader can change.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HookParams {
    /// The right wheel's nominal radius exceeds its true one by this fraction, 0 to [`MAX_BIAS`].
    pub bias: f64,
    /// One sigma of what each wheel slips in a tick, metres, 0 to [`MAX_SLIP`]; the filter knows it.
    pub slip: f64,
    /// Whether sightings of the corners correct the estimate.
    pub fixes: bool,
    /// Fixes slip and sensor noise.
    pub seed: u32,
}

impl Default for HookParams {
    fn default() -> Self {
        Self { bias: HOOK.bias, slip: HOOK.slip, fixes: false, seed: 1 }
    }
}

/// The run itself, without a memory: truth, encoders, sensor, filter.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    params: HookParams,
    home: Apartment,
    rusty: Rusty,
    /// Slip and sensor noise come from streams of their own, so that turning fixes on changes no encoder tick.
    slip: Noise,
    sensor: Noise,
    step: u32,
    input_covariance: Matrix2<f64>,
    w: Matrix2<f64>,
    ekf: ChosetEkf,
    pub(crate) predicted: Gaussian<U3>,
    pub(crate) u: Option<Vector2<f64>>,
    pub(crate) seen: Vec<Seen>,
    last: Option<LastSighting>,
    /// The corners within reach and in sight.
    near: Vec<u32>,
}

impl Drive {
    pub(crate) fn new(params: HookParams) -> Result<Self, Error> {
        // In words: the formatter of floating-point numbers would weigh a thirtieth of the module.
        let bias = (params.bias, MAX_BIAS, "bias", "must be from 0 to 0.01");
        let slip = (params.slip, MAX_SLIP, "slip", "must be from 0 to 0.005");
        for (value, most, name, message) in [bias, slip] {
            if !(0.0..=most).contains(&validate::finite(value, name)?) {
                return Err(Error::new(Code::Limit, name, message));
            }
        }
        let start = HOOK.course.start();
        let belief = Gaussian { x: start.to_vector(), p: Matrix3::zeros() };
        let sigma = Vector2::new(HOOK.sensor.range_sigma, HOOK.sensor.bearing_sigma);
        Ok(Self {
            params,
            home: Apartment::new(),
            rusty: Rusty::new(start, HOOK.wheels, params.bias, params.slip),
            slip: Noise::new(u64::from(params.seed)),
            sensor: Noise::new(u64::from(params.seed) | 1 << 32),
            step: 0,
            input_covariance: slip_covariance(&HOOK.wheels, params.slip),
            w: Matrix2::from_diagonal(&sigma.component_mul(&sigma)),
            ekf: ChosetEkf::new(&belief),
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
        self.ekf.belief()
    }

    pub(crate) fn advance(&mut self) -> Result<(), Error> {
        let counted = self.rusty.drive(HOOK.course.tick(self.step), &mut self.slip);
        self.step += 1;
        let u = odometry_delta(&HOOK.wheels, counted);
        let v = Unicycle::process_covariance(&self.ekf.pose(), &self.input_covariance);
        self.ekf.predict(&u, &v)?;
        self.u = Some(u);
        self.predicted = self.ekf.belief();
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
                    self.seen.push(Seen { landmark: corner.id, x: corner.x, y: corner.y, range, bearing });
                }
            }
        }
        if let Some(seen) = self.seen.last() {
            self.last = Some(LastSighting { step: self.step, seen: *seen, from: [truth.x(), truth.y()] });
        }
    }

    fn fix(&mut self) -> Result<(), Error> {
        if !self.params.fixes || self.seen.is_empty() {
            return Ok(());
        }
        let map = self.home.corners;
        let sightings: Vec<Sighting<2>> = self
            .seen
            .iter()
            .filter_map(|seen| {
                let j = map.iter().position(|corner| corner.id == seen.landmark)?;
                Some(Sighting { j, y: Vector2::new(seen.range, seen.bearing) })
            })
            .collect();
        match self.ekf.update_stacked(&RangeBearing { map }, &sightings, &self.w) {
            // On the corner itself a sighting says nothing that could be linearized: it is left aside.
            Err(error) if error.code != Code::AtLandmark => Err(error),
            _ => Ok(()),
        }
    }

    /// The error, what is claimed of it, and their ratio.
    pub(crate) fn quality(&self) -> (Quality, Spread) {
        let (truth, Gaussian { p, .. }) = (self.truth(), self.belief());
        let off = self.ekf.pose().boxminus(truth);
        let error = Quality {
            position: numerics::hypot(off[0], off[1]),
            heading: angle_diff(self.ekf.pose().theta(), truth.theta()),
        };
        let sigma = Spread { position: (p[(0, 0)] + p[(1, 1)]).max(0.0).sqrt(), heading: p[(2, 2)].max(0.0).sqrt() };
        (error, sigma)
    }
}

/// The lab.
#[derive(Debug)]
pub struct OdometryHook {
    drive: Drive,
    record: Record,
    digest: Digest,
}

impl Lab for OdometryHook {
    const NAME: &'static str = "odometry-hook";
    type Params = HookParams;
    type Frame = HookFrame;

    fn new(params: HookParams) -> Result<Self, Error> {
        let mut lab = Self { drive: Drive::new(params)?, record: Record::default(), digest: Digest::default() };
        lab.note();
        Ok(lab)
    }

    fn params(&self) -> &HookParams {
        &self.drive.params
    }

    fn steps(&self) -> u32 {
        self.drive.step
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.drive.advance()?;
        self.note();
        Ok(())
    }

    fn frame(&self) -> HookFrame {
        let drive = &self.drive;
        let (error, sigma) = drive.quality();
        let belief = Belief3::from(&drive.belief());
        HookFrame {
            step: drive.step,
            time: f64::from(drive.step) * HOOK.period,
            lap: drive.step / HOOK.course.lap(),
            params: drive.params,
            world: World::of(&drive.home),
            truth: drive.truth().to_vector().into(),
            estimate: belief.x,
            p: belief.p,
            ellipse: belief.ellipse,
            predicted: (&drive.predicted).into(),
            u: drive.u.map(Into::into),
            sightings: drive.seen.clone(),
            last_sighting: drive.last,
            error,
            sigma,
            ratio: error.over(sigma),
            tracks: self.record.tracks.outlined(),
            trail: self.record.trail.clone(),
            series: self.record.series.clone(),
        }
    }

    fn digest(&self) -> u64 {
        self.digest.value()
    }
}

impl OdometryHook {
    fn note(&mut self) {
        let drive = &self.drive;
        let belief = drive.belief();
        self.record.take(drive.step, drive.truth(), &belief, drive.quality());
        self.digest.take(drive.truth().to_vector().iter());
        for seen in &drive.seen {
            self.digest.take(&[seen.range, seen.bearing]);
        }
        for belief in [&drive.predicted, &belief] {
            self.digest.take(belief.x.iter());
            self.digest.take(belief.p.iter());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(params: HookParams, steps: u32) -> OdometryHook {
        let mut hook = OdometryHook::new(params).expect("sound parameters");
        hook.run(steps).expect("within the limit");
        hook
    }

    fn with(bias: f64, fixes: bool) -> HookParams {
        HookParams { bias, fixes, ..HookParams::default() }
    }

    #[test]
    fn without_bias_and_slip_the_estimate_is_the_truth_to_a_tick() {
        let frame = at(HookParams { bias: 0.0, slip: 0.0, ..HookParams::default() }, 640).frame();
        assert!(frame.error.position < 0.01 && frame.error.heading.abs() < 0.001);
        assert_eq!((frame.sigma.position, frame.sigma.heading), (0.0, 0.0));
        assert_eq!((frame.ratio.position, frame.ratio.heading), (None, None));
        assert_eq!(frame.lap, 1);
    }

    #[test]
    fn with_bias_the_error_outruns_the_claim() {
        let frame = at(with(0.005, false), 640).frame();
        assert!(frame.ratio.heading.expect("a claim") > 2.0 && frame.ratio.position.expect("a claim") > 2.0);
        // What is claimed knows the slip alone: √640 ticks of √2 mm over 0.40 m.
        let claimed = (640.0 * 2.0_f64).sqrt() * 0.001 / 0.4;
        assert!((frame.sigma.heading - claimed).abs() < 1e-12);
    }

    #[test]
    fn fixes_change_neither_truth_nor_encoders_and_rescue_the_position() {
        let (blind, fixed) = (at(with(0.005, false), 600).frame(), at(with(0.005, true), 600).frame());
        assert_eq!((blind.truth, blind.u), (fixed.truth, fixed.u));
        assert_eq!(blind.tracks.truth, fixed.tracks.truth);
        let (blind, fixed) = (at(with(0.005, false), 626).frame(), at(with(0.005, true), 626).frame());
        assert_eq!(blind.sightings, fixed.sightings, "corners are seen, used or not");
        assert_eq!(fixed.sightings.len(), 1);
        assert!(fixed.error.position < 0.3 * blind.error.position);
        assert!(fixed.sigma.heading < 0.3 * blind.sigma.heading);
    }

    #[test]
    fn a_tick_without_a_corner_leaves_the_prediction() {
        let frame = at(with(0.005, true), 100).frame();
        assert!(frame.sightings.is_empty());
        assert_eq!((frame.predicted.x, frame.predicted.p), (frame.estimate, frame.p));
        let frame = at(with(0.005, true), 186).frame();
        assert_ne!(frame.predicted.x, frame.estimate);
    }

    #[test]
    fn each_corner_is_read_once_as_it_comes_within_reach() {
        let mut hook = at(with(0.0, false), 1);
        let mut read = vec![(1, hook.frame().sightings[0].landmark)];
        while hook.steps() < 640 {
            hook.step().expect("within the limit");
            read.extend(hook.frame().sightings.iter().map(|seen| (hook.steps(), seen.landmark)));
        }
        assert_eq!(read, [(1, 0), (186, 1), (306, 2), (506, 3), (626, 0)]);
        let last = hook.frame().last_sighting.expect("five of them");
        assert_eq!((last.step, last.seen.landmark), (626, 0));
    }

    #[test]
    fn memory_is_one_lap_however_long_the_run() {
        let hook = at(with(0.005, true), 3000);
        let (tracks, frame) = (&hook.record.tracks, hook.frame());
        assert_eq!((tracks.truth.len(), tracks.estimate.len(), frame.trail.len()), (641, 641, 17));
        // Of the truth the corners are left, and the two ends of the window.
        assert!(frame.tracks.truth.len() <= 7 && frame.tracks.estimate.len() < 100, "{:?}", frame.tracks);
        let ends = |track: &crate::series::Track| (track.x.front().copied(), track.y.back().copied());
        assert_eq!(ends(&frame.tracks.estimate), ends(&tracks.estimate));
        assert_eq!(frame.series.step.len(), crate::WINDOW);
        assert_eq!(frame.trail.back().map(|t| t.step), Some(3000));
        assert!(frame.error.position < 1.0, "{:?}", frame.error);
    }

    #[test]
    fn a_change_replays_the_run_and_bad_parameters_change_nothing() {
        let mut hook = at(with(0.0, false), 30);
        hook.set(with(0.008, true)).expect("sound");
        assert_eq!(hook.frame(), at(with(0.008, true), 30).frame());
        let before = hook.digest();
        for (bad, name) in [(with(0.011, true), "bias"), (HookParams { slip: -1e-6, ..with(0.0, true) }, "slip")] {
            let error = hook.set(bad).expect_err("out of bounds");
            assert_eq!((error.code, error.argument.as_ref()), (Code::Limit, name));
        }
        assert_eq!(hook.set(with(f64::NAN, true)).expect_err("NaN").code, Code::NotFinite);
        assert_eq!(hook.digest(), before);
    }
}
