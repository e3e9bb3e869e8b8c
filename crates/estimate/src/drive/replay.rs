//! The replay of a drive, row by row.

use crate::drive::row::{Drive, Event, Motion, Row};
use crate::drive::settings::Settings;
use crate::drive::summary::{Errors, Innovations, Summary};
use crate::ekf::Localizer;
use crate::error::{Code, Error};
use crate::odometry::Unicycle;
use crate::reading::{Corrected, Reading, Setup};
use crate::scaled::{PoseAndScale, Scalable, first_covariance, of_pose};
use core::f64::consts::PI;
use filters::consistency::chi2_quantile;
use filters::{Ekf, MotionModel};
use geom::{SE2, wrap};
use nalgebra::{DMatrix, DVector, Matrix2, Vector2};
use numerics::sqrt;

/// What became of a sighting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// Whether it corrected the estimate.
    pub used: bool,
    /// ν₁, the range's innovation, m.
    pub innovation: f64,
    /// S₁₁, its variance before the sighting, m².
    pub variance: f64,
    /// d² = νᵀS⁻¹ν.
    pub d2: f64,
    /// p, the outputs of the sighting.
    pub outputs: u32,
}

/// The filter, with or without ε in its state.
#[derive(Clone, Copy, Debug)]
enum Filter {
    Given(Localizer),
    Learning(Localizer<PoseAndScale, 4>),
}

/// A localizer that replays a [`Drive`] row by row.
///
/// The state is [x, y, θ], with `learn` [x, y, θ, ε]. It starts at the first true pose, at its time; where there is no
/// truth, at the origin and at the first row's time. Rows before the start are skipped.
///
/// Over dt seconds, with the distance d and the turn a at the heading θ,
/// x ← [x + d cos θ, y + d sin θ, θ + a] and P ← F P Fᵀ + B diag(σ_d², σ_θ²) Bᵀ dt. `O` rows bring d and a; `V` rows
/// bring velocities, which move the estimate to the time of every later row. A sighting is gated by its d² and taken in
/// Joseph's form.
///
/// # Example
/// ```
/// use estimate::Landmark;
/// use estimate::drive::{Drive, Event, Motion, Replay, Row, Settings, Truth};
/// let drive = Drive {
///     landmarks: vec![Landmark { id: 7, x: 3.0, y: 4.0 }],
///     truth: Truth::default(),
///     rows: vec![
///         Row::new(0.0, Event::Odometry { distance: 0.0, turn: 0.0 }),
///         Row::new(0.5, Event::Range { landmark: 0, range: 4.9 }),
///     ],
///     motion: Motion::Odometry,
/// };
/// let mut replay = Replay::new(&drive, Settings::default())?;
/// for row in &drive.rows {
///     replay.take(&drive, row)?;
/// }
/// assert_eq!(replay.summary().used, 1);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Replay {
    settings: Settings,
    /// χ² quantiles of the gate for one and two outputs.
    gates: [Option<f64>; 2],
    filter: Filter,
    start: f64,
    /// When the estimate was last predicted, s.
    time: f64,
    /// v and ω, held since the last `V` row.
    velocity: Vector2<f64>,
    innovations: Innovations,
    refused: u32,
    errors: Errors,
}

impl Replay {
    /// A replay at its start.
    ///
    /// # Errors
    /// [`Code::NotFinite`] or [`Code::Limit`] naming the setting: a standard deviation is negative or one of a sensor
    /// 0, the gate is no probability between 0 and 1, 1 + scale is not positive.
    pub fn new(drive: &Drive, settings: Settings) -> Result<Self, Error> {
        settings.check()?;
        let gate = |dof| settings.gate.map(|p| chi2_quantile(dof, p)).transpose();
        let first = drive.truth.poses().first();
        let pose = first.map_or(SE2::new(0.0, 0.0, 0.0), |at| SE2::new(at.x, at.y, at.theta));
        let start = first.map(|at| at.time).or(drive.span().map(|[first, _]| first)).unwrap_or(0.0);
        Ok(Self {
            gates: [gate(1)?, gate(2)?],
            filter: if settings.learn {
                let x = PoseAndScale { pose, epsilon: 0.0 };
                Filter::Learning(Localizer { filter: Ekf { x, p: first_covariance() } })
            } else {
                Filter::Given(Localizer { filter: Ekf { x: pose, p: first_covariance() } })
            },
            settings,
            start,
            time: start,
            velocity: Vector2::zeros(),
            innovations: Innovations::default(),
            refused: 0,
            errors: Errors::default(),
        })
    }

    /// Takes one row of `drive`; answers what became of it when it is a sighting that was looked at.
    ///
    /// # Errors
    /// [`Code::NotFinite`] or [`Code::InnovationNotPositiveDefinite`] where the numbers leave the range of floating
    /// point; the replay is then as it was. [`Code::Limit`] for a landmark that `drive` does not have.
    pub fn take(&mut self, drive: &Drive, row: &Row) -> Result<Option<Judged>, Error> {
        if row.time < self.start {
            return Ok(None);
        }
        let mut next = *self;
        let judged = next.taken(drive, row)?;
        *self = next;
        Ok(judged)
    }

    fn taken(&mut self, drive: &Drive, row: &Row) -> Result<Option<Judged>, Error> {
        if drive.motion == Motion::Velocity {
            let u = self.velocity * (row.time - self.time).max(0.0);
            self.moved(row.time, u)?;
        }
        let sighting = match row.event {
            Event::Odometry { distance, turn } => {
                self.moved(row.time, Vector2::new(distance, turn))?;
                self.compare(drive, row.time);
                return Ok(None);
            }
            Event::Velocity { v, omega } => {
                self.velocity = Vector2::new(v, omega);
                self.compare(drive, row.time);
                return Ok(None);
            }
            Event::Speed { v } => {
                self.velocity[0] = v;
                self.compare(drive, row.time);
                return Ok(None);
            }
            Event::TurnRate { omega } => {
                self.velocity[1] = omega;
                self.compare(drive, row.time);
                return Ok(None);
            }
            // The next commits take them.
            Event::Position { .. } | Event::Heading { .. } => return Ok(None),
            Event::Range { .. } | Event::RangeBearing { .. } if !self.settings.sightings => return Ok(None),
            Event::Range { landmark, range } => {
                let w = self.settings.sigma_range * self.settings.sigma_range;
                self.sighted(drive, &Reading::Range { landmark: Some(landmark), range, w })
            }
            Event::RangeBearing { landmark, range, bearing } => {
                let s = &self.settings;
                let w = Matrix2::new(s.sigma_range * s.sigma_range, 0.0, 0.0, s.sigma_bearing * s.sigma_bearing);
                // A log has the bearing from the robot's nose.
                let bearing = wrap(bearing + PI);
                self.sighted(drive, &Reading::RangeBearing { landmark: Some(landmark), range, bearing, w })
            }
        };
        match sighting {
            Ok(judged) => {
                if judged.used {
                    let n = judged.innovation / sqrt(judged.variance);
                    self.innovations.take(n, judged.d2 / f64::from(judged.outputs));
                } else {
                    self.refused += 1;
                }
                Ok(Some(judged))
            }
            Err(error) if error.code == Code::AtLandmark => {
                self.refused += 1;
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }

    /// Moves the estimate by u = [d, a] and the time to `time`.
    fn moved(&mut self, time: f64, u: Vector2<f64>) -> Result<(), Error> {
        let dt = (time - self.time).max(0.0);
        let s = &self.settings;
        let input = Matrix2::new(s.sigma_distance * s.sigma_distance, 0.0, 0.0, s.sigma_turn * s.sigma_turn) * dt;
        match &mut self.filter {
            Filter::Given(localizer) => predict(localizer, &u, &input)?,
            Filter::Learning(localizer) => predict(localizer, &u, &input)?,
        }
        self.time = self.time.max(time);
        Ok(())
    }

    fn compare(&mut self, drive: &Drive, time: f64) {
        if let Some([x, y]) = drive.truth.position(time) {
            let pose = self.pose();
            self.errors.take(numerics::hypot(pose.x() - x, pose.y() - y));
        }
    }

    fn sighted(&mut self, drive: &Drive, reading: &Reading) -> Result<Judged, Error> {
        let s = &self.settings;
        let gate = self.gates[usize::from(matches!(reading, Reading::RangeBearing { .. }))];
        let setup = Setup { map: &drive.landmarks, scale: (!s.learn).then_some(s.scale), offset: s.offset, gate };
        let Corrected { accepted, innovation, s, chi2, outputs, .. } = match &mut self.filter {
            Filter::Given(localizer) => localizer.correct(reading, &setup)?,
            Filter::Learning(localizer) => localizer.correct(reading, &setup)?,
        };
        // A distance too large for a number is beyond every gate; without a gate it cannot be taken.
        let d2 = match chi2 {
            Ok(d2) => d2,
            Err(_) if gate.is_some() => f64::INFINITY,
            Err(_) => return Err(Error::new(Code::NotFinite, "range", "is too large: its squared distance overflows")),
        };
        let (innovation, variance) = (innovation[0], s[(0, 0)]);
        Ok(Judged { used: accepted, innovation, variance, d2, outputs: outputs as u32 })
    }

    /// The estimated pose.
    pub fn pose(&self) -> SE2 {
        self.estimate().0
    }

    /// The learned ε; `None` where it is given.
    pub fn epsilon(&self) -> Option<f64> {
        self.estimate().1
    }

    /// The pose, and ε where it is learned.
    fn estimate(&self) -> (SE2, Option<f64>) {
        match &self.filter {
            Filter::Given(localizer) => (localizer.filter.x, None),
            Filter::Learning(localizer) => (localizer.filter.x.pose, Some(localizer.filter.x.epsilon)),
        }
    }

    /// P, 3×3 or, with ε in the state, 4×4.
    pub fn covariance(&self) -> DMatrix<f64> {
        match &self.filter {
            Filter::Given(localizer) => DMatrix::from_column_slice(3, 3, localizer.filter.p.as_slice()),
            Filter::Learning(localizer) => DMatrix::from_column_slice(4, 4, localizer.filter.p.as_slice()),
        }
    }

    /// When the replay starts, s: rows before are skipped.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The time that the estimate is of, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// What the replay says of itself so far.
    pub fn summary(&self) -> Summary {
        let (p, (pose, epsilon)) = (self.covariance(), self.estimate());
        Summary {
            used: self.innovations.count(),
            refused: self.refused,
            rmse: self.errors.rmse(),
            worst: self.errors.worst(),
            nis: self.innovations.nis(),
            mean_innovation: self.innovations.mean(),
            lag1: self.innovations.lag1(),
            epsilon,
            epsilon_sigma: epsilon.map(|_| sqrt(p[(3, 3)].max(0.0))),
            x: DVector::from_iterator(p.nrows(), pose.to_vector().iter().copied().chain(epsilon)),
            trace: p[(0, 0)] + p[(1, 1)] + p[(2, 2)],
        }
    }
}

/// P ← F P Fᵀ + B M Bᵀ for the input noise `input`, M already multiplied by dt.
fn predict<X: Scalable<N>, const N: usize>(
    localizer: &mut Localizer<X, N>,
    u: &Vector2<f64>,
    input: &Matrix2<f64>,
) -> Result<(), Error>
where
    Unicycle: MotionModel<X, N, 2>,
{
    let v = of_pose(&Unicycle::process_covariance(&localizer.filter.x.pose(), input));
    localizer.predict(u, &v)
}
