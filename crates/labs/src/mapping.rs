//! Range–bearing SLAM on a true path, with the bookkeeping that only a simulation can do: which landmark of the map is
//! which in truth.

use crate::true_path::sensor_covariance;
use estimate::kf::Gaussian;
use estimate::slam::{EkfSlam, LandmarkReading, Outcome, Report};
use estimate::{Error, Landmark};
use filters::association::Thresholds;
use geom::SE2;
use lab::record;
use nalgebra::{Matrix2, Matrix3, Vector2};
use sim::Noise;
use sim::paths::Tick;
use sim::scenarios::RangeBearingSlam;

/// Counts of what became of the sightings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// All of them.
    pub sightings: u32,
    /// Those that corrected the state.
    pub matched: u32,
    /// Those that founded a landmark.
    pub founded: u32,
    /// Those that were not used.
    pub rejected: u32,
    /// Of the matched, those matched to another landmark than the one seen.
    pub wrong: u32,
    /// Of the founded, those of a landmark that was in the map already.
    pub spurious: u32,
}

/// A sighting as it was made and what became of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Which of the world's landmarks it truly was.
    pub truth: usize,
    /// Metres.
    pub range: f64,
    /// Radians.
    pub bearing: f64,
    /// What became of it.
    pub report: Report,
}

record! {
    /// The error of a mapped landmark, metres and in its own standard deviations.
    #[derive(Copy)]
    pub struct MapError {
        /// Metres.
        pub error: f64,
        /// √(eᵀP⁻¹e).
        pub sigma: f64,
    }
}

/// A run of SLAM.
#[derive(Clone, Debug)]
pub struct Mapping {
    /// Robot and map.
    pub slam: EkfSlam,
    /// For each landmark of the map, which of the world's it was founded on.
    pub truth: Vec<usize>,
    /// What became of all sightings so far.
    pub tally: Tally,
    /// How many landmarks the map may hold. When the next step could pass this, the map is closed.
    pub most: usize,
    /// Sightings of the last step.
    last_seen: usize,
    world: Vec<Landmark>,
    /// The scenario's constants.
    pub constants: RangeBearingSlam,
}

impl Mapping {
    /// The robot at the start of the course, which is known exactly: it is where the map begins.
    pub fn new(world: &[Landmark], constants: &RangeBearingSlam) -> Result<Self, Error> {
        let thresholds = Thresholds { gate: constants.gate, found: constants.found };
        let belief = Gaussian { x: constants.course.start().to_vector(), p: Matrix3::zeros() };
        let slam = EkfSlam::new(&belief, &sensor_covariance(&constants.sensor), thresholds)?;
        Ok(Self {
            slam,
            truth: Vec::new(),
            tally: Tally::default(),
            most: usize::MAX,
            last_seen: 0,
            world: world.to_vec(),
            constants: *constants,
        })
    }

    /// The robot has driven `tick` and stands at `truth`: its odometry says so with noise, and then it looks about.
    pub fn step(&mut self, tick: Tick, truth: SE2, noise: &mut Noise) -> Result<Vec<Seen>, Error> {
        self.drive(tick, noise)?;
        self.look(truth, noise)
    }

    /// The robot has driven `tick`, and its odometry says so with noise.
    pub fn drive(&mut self, tick: Tick, noise: &mut Noise) -> Result<(), Error> {
        let moving = tick.ds != 0.0 || tick.dtheta != 0.0;
        let sigma = self.constants.u_sigma.map(|s| if moving { s } else { 0.0 });
        let u = Vector2::new(tick.ds + sigma[0] * noise.normal(), tick.dtheta + sigma[1] * noise.normal());
        let input = Matrix2::from_diagonal(&Vector2::from(sigma.map(|s| s * s)));
        let v = estimate::Unicycle::process_covariance(&self.slam.pose(), &input);
        self.slam.predict(&u, &v)
    }

    /// The robot stands at `truth`, and sees every landmark that is within reach and that no wall hides.
    #[inline(never)]
    pub fn look(&mut self, truth: SE2, noise: &mut Noise) -> Result<Vec<Seen>, Error> {
        let RangeBearingSlam { sensor, home, .. } = &self.constants;
        let visible = |landmark: &Landmark| {
            sensor.reaches(truth, landmark) && home.is_none_or(|home| home.in_sight(truth, landmark))
        };
        let near = self.world.iter().enumerate().filter(|(_, landmark)| visible(landmark));
        let sighted = near.map(|(index, landmark)| (index, sensor.sight(truth, landmark, noise)));
        // A landmark under the robot has no bearing.
        let seen: Vec<_> = sighted.filter(|(_, z)| z.range > 0.0).collect();
        let readings: Vec<LandmarkReading> =
            seen.iter().map(|(_, z)| LandmarkReading { range: z.range, bearing: z.bearing, landmark: None }).collect();
        self.last_seen = readings.len();
        if readings.is_empty() {
            return Ok(Vec::new());
        }
        if self.is_full() {
            self.slam.close_map();
        }
        let reports = self.slam.update(&readings)?;
        let ids: Vec<u32> = self.slam.landmarks().map(|l| l.id).collect();
        let pairs = seen.into_iter().zip(reports);
        Ok(pairs
            .map(|((truth, z), report)| {
                self.count(truth, &report, &ids);
                Seen { truth, range: z.range, bearing: z.bearing, report }
            })
            .collect())
    }

    /// Whether the map founds no more landmarks, because those of one more step could be too many.
    pub fn is_full(&self) -> bool {
        self.slam.landmarks().count() + self.world.len() > self.most
    }

    fn count(&mut self, truth: usize, report: &Report, ids: &[u32]) {
        let tally = &mut self.tally;
        tally.sightings += 1;
        match report.outcome {
            Outcome::Rejected => tally.rejected += 1,
            Outcome::Founded => {
                tally.founded += 1;
                tally.spurious += u32::from(self.truth.contains(&truth));
                self.truth.push(truth);
            }
            Outcome::Matched => {
                tally.matched += 1;
                let index = ids.iter().position(|id| Some(*id) == report.landmark);
                tally.wrong += u32::from(index.and_then(|i| self.truth.get(i)) != Some(&truth));
            }
        }
    }

    /// νᵀS⁻¹ν of the last step's matched sightings, and its degrees of freedom.
    pub fn nis(&self) -> Option<(f64, u32)> {
        self.slam.nis().filter(|_| self.last_seen > 0)
    }

    /// The error of each landmark of the map.
    pub fn errors(&self) -> Vec<MapError> {
        let pairs = self.slam.landmarks().zip(&self.truth);
        pairs
            .map(|(mapped, &truth)| {
                let at = Vector2::new(self.world[truth].x, self.world[truth].y);
                let e = mapped.position - at;
                let sigma = filters::consistency::mahalanobis_squared(&e, &mapped.p).map_or(f64::NAN, f64::sqrt);
                MapError { error: e.norm(), sigma }
            })
            .collect()
    }

    /// The landmark farthest from its true place.
    pub fn worst(&self) -> Option<MapError> {
        self.errors().into_iter().max_by(|a, b| a.error.total_cmp(&b.error))
    }
}

/// The chapter's run with a seed: 200 poses on the Probe's square, the first of them its start.
///
/// # Errors
/// Whatever the core answers; on the chapter's constants, nothing.
pub fn chapter_run(constants: &RangeBearingSlam, seed: u32) -> Result<Mapping, Error> {
    let mut mapping = Mapping::new(constants.landmarks, constants)?;
    let mut noise = Noise::new(u64::from(seed));
    let mut pose = constants.course.start();
    mapping.look(pose, &mut noise)?;
    for k in 0..constants.poses - 1 {
        let tick = constants.course.tick(k);
        pose = tick.drive(pose);
        mapping.step(tick, pose, &mut noise)?;
    }
    Ok(mapping)
}
