//! The Probe's robot with its map: the EKF of §8.3 on sightings whose landmarks it knows.

use super::frame::{Fate, ProbeSighting};
use crate::shapes::innovation;
use crate::true_path::{sensor_covariance, squares};
use estimate::Landmark;
use estimate::kf::Gaussian;
use estimate::landmarks::{RangeBearing, RangeOnly, candidate};
use estimate::localizer::SensorKind;
use estimate::{Error, Sighting};
use filters::MeasurementModel;
use filters::association::Rule;
use geom::SE2;
use nalgebra::{DMatrix, Matrix1, Matrix3, SMatrix, SVector, Vector2, Vector3};
use sim::Noise;
use sim::paths::Tick;
use sim::scenarios::PROBE;
use std::sync::Arc;

/// A localizer and the landmarks it knows.
#[derive(Clone, Debug)]
pub(super) struct Localizer {
    pub ekf: estimate::Localizer,
    landmarks: Arc<[Landmark]>,
    sight: SensorKind,
}

/// NIS of a step and its degrees of freedom, where a sighting was used.
pub(super) type Evidence = Option<(f64, u32)>;

impl Localizer {
    /// A first estimate drawn from P₀ about the truth.
    pub fn new(truth: SE2, landmarks: Arc<[Landmark]>, sight: SensorKind, noise: &mut Noise) -> Self {
        let off = drawn(PROBE.p0_sigma, noise);
        let belief = Gaussian { x: truth.boxplus(&off).to_vector(), p: squares(PROBE.p0_sigma) };
        Self { ekf: estimate::Localizer::new(&belief), landmarks, sight }
    }

    /// The robot has driven `tick` and stands at `truth`. `sightings` is filled anew with what became of its sightings.
    pub fn step(
        &mut self,
        tick: Tick,
        truth: SE2,
        noise: &mut Noise,
        sightings: &mut Vec<ProbeSighting>,
    ) -> Result<Evidence, Error> {
        // Drawn also at rest, so that a seed gives the same sightings whether the robot moves or not.
        let off = drawn(PROBE.v_sigma, noise);
        let moving = tick.ds != 0.0 || tick.dtheta != 0.0;
        let (off, v) = if moving { (off, squares(PROBE.v_sigma)) } else { (Vector3::zeros(), Matrix3::zeros()) };
        self.ekf.predict(&Vector2::new(tick.ds, tick.dtheta), &v)?;
        let Gaussian { x, p } = self.ekf.belief();
        self.ekf = estimate::Localizer::new(&Gaussian { x: SE2::from_vector(&x).boxplus(&off).to_vector(), p });

        let map = Arc::clone(&self.landmarks);
        let readings = map.iter().map(|landmark| {
            let z = PROBE.sensor.sight(truth, landmark, noise);
            (landmark, Vector2::new(z.range, z.bearing))
        });
        let w = sensor_covariance(&PROBE.sensor);
        Ok(match self.sight {
            SensorKind::RangeBearing => self.correct(&RangeBearing { map: &map }, readings, |z| z, &w, sightings),
            SensorKind::Range => {
                let (model, w) = (RangeOnly { map: &map }, Matrix1::new(w[(0, 0)]));
                self.correct(&model, readings, |z| z.fixed_rows::<1>(0).into_owned(), &w, sightings)
            }
        })
    }

    /// All sightings stacked; one that cannot be linearized (the estimate stands on its landmark) is left out.
    fn correct<'m, const M: usize>(
        &mut self,
        model: &impl MeasurementModel<SE2, 3, M>,
        readings: impl Iterator<Item = (&'m Landmark, Vector2<f64>)>,
        of: impl Fn(Vector2<f64>) -> SVector<f64, M>,
        w: &SMatrix<f64, M, M>,
        sightings: &mut Vec<ProbeSighting>,
    ) -> Evidence {
        let belief = self.ekf.filter;
        let mut stack = Vec::new();
        sightings.clear();
        for (j, (landmark, z)) in readings.enumerate() {
            let y = of(z);
            let weighed = candidate(model, &belief, &y, j, w, Rule::ChiSquared).ok();
            if weighed.is_some() {
                stack.push(Sighting { j, y });
            }
            sightings.push(ProbeSighting {
                landmark: j,
                range: z[0],
                bearing: (M == 2).then_some(z[1]),
                innovation: weighed.map(|c| innovation(&c.innovation, &c.s).0),
                s: weighed.map(|c| innovation(&c.innovation, &c.s).1),
                chi2: weighed.map(|c| c.d2),
                outcome: if weighed.is_some() { Fate::Accepted } else { Fate::Rejected },
                to: Some([landmark.x, landmark.y]),
            });
        }
        let evidence = match stack.as_slice() {
            [] => None,
            [one] => self.ekf.update(model, one, w).ok().and_then(|u| nis(&u.innovation, &u.s)),
            all => self.ekf.update_stacked(model, all, w).ok().and_then(|(nu, s): (_, DMatrix<f64>)| nis(&nu, &s)),
        };
        if evidence.is_none() {
            for sighting in sightings {
                sighting.outcome = Fate::Rejected;
            }
        }
        evidence
    }
}

fn nis<D: nalgebra::Dim>(nu: &nalgebra::OVector<f64, D>, s: &nalgebra::OMatrix<f64, D, D>) -> Option<(f64, u32)>
where
    nalgebra::DefaultAllocator: nalgebra::allocator::Allocator<D> + nalgebra::allocator::Allocator<D, D>,
{
    filters::consistency::nis(nu, s).ok().map(|nis| (nis, nu.nrows() as u32))
}

fn drawn(sigma: [f64; 3], noise: &mut Noise) -> Vector3<f64> {
    Vector3::from(sigma.map(|s| s * noise.normal()))
}
