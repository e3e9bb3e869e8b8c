//! The Observability Probe: Rusty on its square in room A, one to three landmarks that the reader drags, and what can
//! be known from them.
//!
//! The robot drives its square exactly, and its filter is told a motion that is off by a draw from V at every tick. So
//! the true path, and with it the rank along the path, depends on no seed.

pub(crate) mod frame;
mod ghost;
mod localize;
mod params;
pub(crate) mod ranks;
mod snap;
mod view;

pub use frame::{
    Fate, Ghost, GhostReadings, MapLandmark, Means, ProbeFrame, ProbeLandmark, ProbeMap, ProbeSeries, ProbeSighting,
    RoomShape, Traces,
};
pub use params::ProbeParams;
pub use ranks::ProbeRanks;
pub use ranks::{Moment, frozen_ranks, stacked_ranks};
pub(crate) use view::{map_shape, mapped_sighting};

use crate::mapping::Mapping;
use crate::true_path::{TruePath, parts};
use estimate::Landmark;
use estimate::localizer::SensorKind;
use estimate::{Code, Error};
use filters::consistency::nees;
use geom::SE2;
use ghost::Haunting;
use lab::series::Tracks;
use lab::{Digest, Lab, Params, kept, named};
use localize::{Evidence, Localizer};
use nalgebra::{Matrix3, Vector2};
use sim::Noise;
use sim::paths::Tick;
use sim::scenarios::{PROBE, RANGE_BEARING_SLAM};
use std::collections::VecDeque;
use std::sync::Arc;

/// How many of the last steps the rank along the path looks at: one side of the square.
pub const PATH_STEPS: usize = 30;
/// The most landmarks of a forgotten map. A sighting of one of several landmarks that stand close together is sometimes
/// taken for a new landmark, and every such ghost makes each later step slower. Four for each true landmark show that
/// well, and keep a step below a tenth of a millisecond.
const MAX_MAP: usize = 12;
/// How many of the last positions a track keeps, two laps and the present.
const TRACK: usize = 241;

/// What estimates: the map is known, or it is mapped.
#[derive(Clone, Debug)]
enum Estimator {
    /// A robot with a map.
    Localizer(Localizer),
    /// A robot that must found one.
    Mapper(Box<Mapping>),
}

impl Estimator {
    fn belief(&self) -> (SE2, Matrix3<f64>) {
        match self {
            Self::Localizer(l) => (l.ekf.pose(), *l.ekf.covariance()),
            Self::Mapper(m) => (m.slam.pose(), m.slam.pose_covariance()),
        }
    }
}

/// Sums over the run.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    nees: f64,
    nees_steps: u32,
    nis: f64,
    nis_dof: u32,
}

/// The lab.
#[derive(Clone, Debug)]
pub struct ObservabilityProbe {
    params: ProbeParams,
    shown: Arc<[Landmark]>,
    noise: Noise,
    step: u32,
    driven: u32,
    truth: SE2,
    estimator: Estimator,
    haunting: Option<Haunting>,
    reference: TruePath,
    /// The last moments on the true path, the present one last.
    moments: VecDeque<Moment>,
    sightings: Vec<ProbeSighting>,
    nees: Option<f64>,
    nis: Evidence,
    sums: Sums,
    series: ProbeSeries,
    tracks: Tracks,
    digest: Digest,
}

impl Lab for ObservabilityProbe {
    named! {
        "observability-probe", ProbeParams, ProbeFrame, &[frame::INTERFACES, ranks::INTERFACES],
        "Rusty on a square in room A: which landmarks does it take to know where it is?"
    }
    kept! {}

    fn start((): (), params: ProbeParams) -> Result<Self, Error> {
        params.check().map_err(|mut error| {
            if error.argument == "tolerance" && error.code == Code::Limit {
                error.code = Code::Tolerance;
            }
            error
        })?;
        let shown = params.shown();
        let mut noise = Noise::new(u64::from(params.seed));
        let truth = PROBE.course.start();
        let (estimator, sightings) = if params.forget {
            let mut mapping = Mapping::new(&shown, &RANGE_BEARING_SLAM)?;
            mapping.most = MAX_MAP;
            // A map begins where its robot first looks about.
            let seen = mapping.look(truth, &mut noise)?;
            let sightings = seen.iter().map(|s| view::mapped_sighting(s, &mapping)).collect();
            (Estimator::Mapper(Box::new(mapping)), sightings)
        } else {
            (Estimator::Localizer(Localizer::new(truth, Arc::clone(&shown), params.sight(), &mut noise)), Vec::new())
        };
        let mut probe = Self {
            params,
            shown,
            noise,
            step: 0,
            driven: 0,
            truth,
            estimator,
            haunting: (params.ghost && !params.forget).then(|| Haunting::new(&params, truth)),
            reference: TruePath::new(&PROBE, 2, SensorKind::Range),
            moments: VecDeque::new(),
            sightings,
            nees: None,
            nis: None,
            sums: Sums::default(),
            series: ProbeSeries::default(),
            tracks: Tracks::default(),
            digest: Digest::default(),
        };
        probe.note();
        Ok(probe)
    }

    fn tried() -> Vec<Self::Params> {
        let open = ProbeParams::default();
        vec![
            open,
            ProbeParams { count: 3, sensor: SensorKind::RangeBearing, ..open },
            ProbeParams { count: 3, forget: true, ..open },
            ProbeParams { ghost: true, ghost_around: 0.1, ghost_turn: 0.2, ..open },
        ]
    }

    fn advance(&mut self) -> Result<(), Error> {
        let tick = self.next_tick();
        self.truth = tick.drive(self.truth);
        if let Some(ghost) = &mut self.haunting {
            ghost.drive(tick);
        }
        self.driven += u32::from(self.moving());
        self.step += 1;
        self.reference.step(tick)?;
        match &mut self.estimator {
            Estimator::Localizer(localizer) => {
                self.nis = localizer.step(tick, self.truth, &mut self.noise, &mut self.sightings)?;
            }
            Estimator::Mapper(mapping) => {
                let seen = mapping.step(tick, self.truth, &mut self.noise)?;
                self.sightings = seen.iter().map(|s| view::mapped_sighting(s, mapping)).collect();
                self.nis = mapping.nis();
            }
        }
        self.note();
        Ok(())
    }

    fn frame(&self) -> ProbeFrame {
        view::frame(self)
    }
}

impl ObservabilityProbe {
    /// The mean NEES of the run.
    pub fn mean_nees(&self) -> Option<f64> {
        (self.sums.nees_steps > 0).then(|| self.sums.nees / f64::from(self.sums.nees_steps))
    }

    /// tr P of the pose after the last step.
    pub fn last_trace(&self) -> f64 {
        self.estimator.belief().1.trace()
    }

    fn moving(&self) -> bool {
        self.params.stop.is_none_or(|at| self.step < at)
    }

    /// What the next step drives.
    fn next_tick(&self) -> Tick {
        if self.moving() { PROBE.course.tick(self.driven) } else { Tick { ds: 0.0, dtheta: 0.0 } }
    }

    /// Keeps what the present step says.
    fn note(&mut self) {
        self.judge();
        self.remember();
        self.record();
        if let Some(ghost) = &mut self.haunting {
            ghost.compare(self.truth, &self.shown, TRACK);
            self.digest.take(&ghost.numbers());
        }
    }

    /// Compares with the truth.
    fn judge(&mut self) {
        let (pose, p) = self.estimator.belief();
        self.nees = nees(&self.truth.boxminus(pose), &p).ok();
        if let Some(nees) = self.nees {
            self.sums.nees += nees;
            self.sums.nees_steps += 1;
        }
        if let Some((nis, dof)) = self.nis {
            self.sums.nis += nis;
            self.sums.nis_dof += dof;
        }
    }

    /// Keeps the present moment for the ranks along the path.
    fn remember(&mut self) {
        let landmarks = match &self.estimator {
            Estimator::Localizer(_) => Arc::clone(&self.shown),
            Estimator::Mapper(m) => m.truth.iter().map(|&t| self.shown[t]).collect(),
        };
        self.moments.push_back(Moment { pose: self.truth, landmarks, u: self.next_input() });
        if self.moments.len() > PATH_STEPS + 1 {
            self.moments.pop_front();
        }
    }

    /// The present moment as the filter believes it to be.
    fn believed(&self) -> Moment {
        let landmarks = match &self.estimator {
            Estimator::Localizer(_) => Arc::clone(&self.shown),
            Estimator::Mapper(m) => {
                m.slam.landmarks().map(|l| Landmark { id: l.id, x: l.position[0], y: l.position[1] }).collect()
            }
        };
        Moment { pose: self.estimator.belief().0, landmarks, u: self.next_input() }
    }

    fn next_input(&self) -> Vector2<f64> {
        let tick = self.next_tick();
        Vector2::new(tick.ds, tick.dtheta)
    }

    fn record(&mut self) {
        let (pose, p) = self.estimator.belief();
        let [position, heading] = parts(&p);
        let series = &mut self.series;
        series.step.push(f64::from(self.step));
        series.trace.push(p.trace());
        series.trace_position.push(position);
        series.trace_heading.push(heading);
        series.reference.push(self.reference.trace());
        series.nees.push(self.nees.unwrap_or(f64::NAN));
        let (nis, dof) = self.nis.unwrap_or((f64::NAN, 0));
        series.nis.push(nis);
        series.nis_dof.push(f64::from(dof));
        self.tracks.truth.push(self.truth.x(), self.truth.y(), TRACK);
        self.tracks.estimate.push(pose.x(), pose.y(), TRACK);
        self.digest.take(self.truth.to_vector().as_slice());
        self.digest.take(pose.to_vector().as_slice());
        self.digest.take(p.as_slice());
        self.digest.take(self.reference.p.as_slice());
        self.digest.take(self.nees.as_slice());
        self.digest.take(self.nis.map(|(nis, _)| nis).as_slice());
        if let Estimator::Mapper(mapping) = &self.estimator {
            for landmark in mapping.slam.landmarks() {
                self.digest.take(landmark.position.as_slice());
                self.digest.take(landmark.p.as_slice());
            }
        }
    }
}

#[cfg(test)]
mod tests;
