//! The corridor's loop: a robot of short reach founds landmarks on its way round, and sees the first ones again at the
//! end.
//!
//! The cross-covariances tie the far end of the map to its beginning. The wrong filter, whose cross-covariances are
//! dropped after every step, is put together here from the right one.

pub(crate) mod frame;
mod params;
mod view;

pub use frame::{LoopFrame, LoopGate, LoopMoment, LoopPull, LoopSeries, LoopSighting, LoopThresholds};
pub use params::LoopParams;

use crate::mapping::{Mapping, Seen};
use crate::true_path::sensor_covariance;
use estimate::Error;
use estimate::kf::Gaussian;
use estimate::slam::{EkfSlam, Mapped, Outcome};
use filters::association::Thresholds;
use filters::consistency::{mahalanobis_squared, nees};
use geom::{SE2, angle_diff};
use lab::series::Tracks;
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::Vector2;
use sim::Noise;
use sim::scenarios::{LOOP_CLOSURE, RangeBearingSlam};

/// The most landmarks of the map: more than twice the true ones, so that ghosts show and a step stays cheap.
const MAX_MAP: usize = 36;
/// How many of the last positions a track keeps: two laps and the present.
const TRACK: usize = 257;

/// A sighting, and its χ² against the landmark that it was matched to, or else against the nearest.
#[derive(Clone, Debug)]
struct Weighed {
    seen: Seen,
    chi2: Option<f64>,
}

/// The lab.
#[derive(Clone, Debug)]
pub struct LoopClosure {
    params: LoopParams,
    noise: Noise,
    step: u32,
    truth: SE2,
    mapping: Mapping,
    /// Robot and map as predicted for this step, before its sightings.
    predicted: EkfSlam,
    sightings: Vec<Weighed>,
    /// The step at which each true landmark was last in sight.
    last_seen: Vec<Option<u32>>,
    closure: Option<LoopMoment>,
    nees: Option<f64>,
    /// The sum of all NEES, and how many there are.
    nees_sum: (f64, u32),
    series: LoopSeries,
    tracks: Tracks,
    digest: Digest,
}

impl Lab for LoopClosure {
    named! {
        "loop-closure", LoopParams, LoopFrame, &[frame::INTERFACES],
        "Range–bearing SLAM around the corridor with a sensor of short reach: a loop that is closed, with or \
         without cross-covariances."
    }
    kept! {}

    fn start((): (), params: LoopParams) -> Result<Self, Error> {
        params.check()?;
        let constants = RangeBearingSlam { gate: params.gate.min(params.found), found: params.found, ..LOOP_CLOSURE };
        let mut mapping = Mapping::new(constants.landmarks, &constants)?;
        mapping.most = MAX_MAP;
        let mut lab = Self {
            params,
            noise: Noise::new(u64::from(params.seed)),
            step: 0,
            truth: constants.course.start(),
            predicted: mapping.slam.clone(),
            mapping,
            sightings: Vec::new(),
            last_seen: vec![None; constants.landmarks.len()],
            closure: None,
            nees: None,
            nees_sum: (0.0, 0),
            series: LoopSeries::default(),
            tracks: Tracks::default(),
            digest: Digest::default(),
        };
        lab.look()?;
        Ok(lab)
    }

    fn tried() -> Vec<Self::Params> {
        let open = LoopParams::default();
        vec![open, LoopParams { correlated: false, found: 12.0, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        let tick = LOOP_CLOSURE.course.tick(self.step);
        self.truth = tick.drive(self.truth);
        self.step += 1;
        self.mapping.drive(tick, &mut self.noise)?;
        self.predicted = self.mapping.slam.clone();
        self.look()
    }

    fn frame(&self) -> LoopFrame {
        view::frame(self)
    }
}

impl LoopClosure {
    /// The mean NEES of the run.
    pub(crate) fn mean_nees(&self) -> Option<f64> {
        (self.nees_sum.1 > 0).then(|| self.nees_sum.0 / f64::from(self.nees_sum.1))
    }

    /// The sightings of a step, and what they make of robot and map.
    fn look(&mut self) -> Result<(), Error> {
        let seen = self.mapping.look(self.truth, &mut self.noise)?;
        if !self.params.correlated {
            self.mapping.slam = without_cross_covariances(&self.mapping.slam, &self.mapping.constants)?;
        }
        let weighed = |seen: Seen| {
            let compared = seen.report.evidence.map(|(.., chi2)| chi2);
            Weighed { chi2: compared.or_else(|| nearest(&self.predicted, &seen)), seen }
        };
        self.sightings = seen.into_iter().map(weighed).collect();
        self.nees = nees(&self.truth.boxminus(self.mapping.slam.pose()), &self.mapping.slam.pose_covariance()).ok();
        if let Some(nees) = self.nees {
            self.nees_sum = (self.nees_sum.0 + nees, self.nees_sum.1 + 1);
        }
        self.note_closure();
        self.record();
        Ok(())
    }

    /// Keeps the first step that matches a landmark which has been out of sight for half a lap.
    fn note_closure(&mut self) {
        for Weighed { seen: Seen { truth, report, .. }, .. } in &self.sightings {
            let before = self.last_seen[*truth].replace(self.step);
            let long_ago = before.is_some_and(|last| self.step - last > LOOP_CLOSURE.course.lap() / 2);
            if long_ago && report.outcome == Outcome::Matched && self.closure.is_none() {
                let [before, after] = [&self.predicted, &self.mapping.slam].map(map_sigma);
                self.closure = Some(LoopMoment { step: self.step, landmark: *truth, before, after });
            }
        }
    }

    fn record(&mut self) {
        let slam = &self.mapping.slam;
        let (pose, p) = (slam.pose(), slam.pose_covariance());
        let error = self.truth.boxminus(pose);
        let series = &mut self.series;
        series.step.push(f64::from(self.step));
        series.nees.push(self.nees.unwrap_or(f64::NAN));
        series.error.push(numerics::hypot(error[0], error[1]));
        series.sigma.push((0.5 * (p[(0, 0)] + p[(1, 1)])).sqrt());
        series.map_sigma.push(map_sigma(slam));
        self.sightings.iter().for_each(|sighting| series.chi2.push(sighting.chi2.unwrap_or(f64::NAN)));
        self.tracks.truth.push(self.truth.x(), self.truth.y(), TRACK);
        self.tracks.estimate.push(pose.x(), pose.y(), TRACK);
        self.digest.take(self.truth.to_vector().as_slice());
        for slam in [&self.predicted, slam] {
            self.digest.take(slam.pose().to_vector().as_slice());
            self.digest.take(slam.pose_covariance().as_slice());
        }
        for landmark in slam.landmarks() {
            self.digest.take(landmark.position.as_slice());
            self.digest.take(landmark.p.as_slice());
        }
        for Weighed { seen, chi2 } in &self.sightings {
            self.digest.take(&[seen.range, seen.bearing]);
            self.digest.take(chi2.as_slice());
        }
        self.digest.take(self.nees.as_slice());
    }
}

/// The same robot and map with their errors taken for independent: the wrong filter of this lab.
fn without_cross_covariances(slam: &EkfSlam, constants: &RangeBearingSlam) -> Result<EkfSlam, Error> {
    let belief = Gaussian { x: slam.pose().to_vector(), p: slam.pose_covariance() };
    let map: Vec<Mapped> = slam.landmarks().collect();
    let thresholds = Thresholds { gate: constants.gate, found: constants.found };
    EkfSlam::with_map(&belief, &map, &sensor_covariance(&constants.sensor), thresholds)
}

/// The least χ² of a sighting against any landmark of the map.
fn nearest(slam: &EkfSlam, seen: &Seen) -> Option<f64> {
    let against = |landmark: Mapped| {
        let (expected, s) = slam.expected_sighting(landmark.id).ok()?;
        let off = Vector2::new(seen.range - expected[0], angle_diff(seen.bearing, expected[1]));
        mahalanobis_squared(&off, &s).ok()
    };
    slam.landmarks().filter_map(against).min_by(f64::total_cmp)
}

/// The mean standard deviation of the map's landmarks in a coordinate, √(½ tr P); NaN for an empty map.
fn map_sigma(slam: &EkfSlam) -> f64 {
    slam.landmarks().map(|landmark| (0.5 * landmark.p.trace()).sqrt()).sum::<f64>() / slam.len() as f64
}

#[cfg(test)]
mod tests;
