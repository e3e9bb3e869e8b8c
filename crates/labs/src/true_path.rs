//! The covariance of a localizer whose Jacobians are taken on the true path. No noise is drawn, so it depends on no
//! seed: the chapter quotes its trace as that of the Probe, and the figure draws it as the reference.

use estimate::Landmark;
use estimate::landmarks::{RangeBearing, RangeOnly};
use estimate::localizer::SensorKind;
use estimate::{Error, Unicycle};
use filters::linear;
use filters::{MeasurementModel, MotionModel};
use geom::SE2;
use nalgebra::{Matrix1, Matrix2, Matrix3, Vector2, Vector3};
use sim::paths::Tick;
use sim::scenarios::Probe;

/// diag(σ²).
pub(crate) fn squares(sigma: [f64; 3]) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::from(sigma.map(|s| s * s)))
}

/// W of a sensor: range and bearing.
pub fn sensor_covariance(sensor: &sim::LandmarkSensor) -> Matrix2<f64> {
    let [r, b] = [sensor.range_sigma, sensor.bearing_sigma];
    Matrix2::new(r * r, 0.0, 0.0, b * b)
}

/// A robot on its true path with the covariance that goes with it.
#[derive(Clone, Debug)]
pub struct TruePath {
    /// Where the robot is.
    pub pose: SE2,
    /// P after the sightings of this step.
    pub p: Matrix3<f64>,
    landmarks: Vec<Landmark>,
    sight: SensorKind,
    v: Matrix3<f64>,
    w: Matrix2<f64>,
}

impl TruePath {
    /// The scenario's robot at its start, seeing its first `count` landmarks at every step.
    pub fn new(scenario: &Probe, count: usize, sight: SensorKind) -> Self {
        Self {
            pose: scenario.course.start(),
            p: squares(scenario.p0_sigma),
            landmarks: scenario.landmarks.iter().take(count).copied().collect(),
            sight,
            v: squares(scenario.v_sigma),
            w: sensor_covariance(&scenario.sensor),
        }
    }

    /// A tick and the sightings after it, stacked one by one (all at the same, true pose).
    ///
    /// # Errors
    /// Whatever the core answers, as where the path leads over a landmark.
    pub fn step(&mut self, tick: Tick) -> Result<(), Error> {
        let u = Vector2::new(tick.ds, tick.dtheta);
        let v = if tick.ds == 0.0 && tick.dtheta == 0.0 { Matrix3::zeros() } else { self.v };
        self.p = linear::predicted_covariance(&Unicycle.jacobian(&self.pose, &u), &self.p, &v)?;
        self.pose = tick.drive(self.pose);
        for j in 0..self.landmarks.len() {
            self.p = match self.sight {
                SensorKind::Range => {
                    let h = RangeOnly { map: &self.landmarks }.jacobian(&self.pose, j)?;
                    linear::gain(&self.p, &h, &Matrix1::new(self.w[(0, 0)]))?.p
                }
                SensorKind::RangeBearing => {
                    let h = RangeBearing { map: &self.landmarks }.jacobian(&self.pose, j)?;
                    linear::gain(&self.p, &h, &self.w)?.p
                }
            };
        }
        Ok(())
    }

    /// tr P.
    pub fn trace(&self) -> f64 {
        self.p.trace()
    }

    /// The two parts of the trace, which have different units: m² and rad².
    pub fn parts(&self) -> [f64; 2] {
        parts(&self.p)
    }
}

/// P₁₁ + P₂₂ in m², and P₃₃ in rad².
pub(crate) fn parts(p: &Matrix3<f64>) -> [f64; 2] {
    [p[(0, 0)] + p[(1, 1)], p[(2, 2)]]
}

/// The Probe's first landmarks seen for so many steps: P at the end.
///
/// # Errors
/// Whatever the core answers; on the chapter's constants, nothing.
pub fn after(scenario: &Probe, landmarks: usize, sight: SensorKind, steps: u32) -> Result<TruePath, Error> {
    let mut path = TruePath::new(scenario, landmarks, sight);
    for k in 0..steps {
        path.step(scenario.course.tick(k))?;
    }
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use sim::scenarios::PROBE;

    #[test]
    fn the_parts_add_up_to_the_trace() {
        let path = after(&PROBE, 1, SensorKind::Range, 240).expect("clear of the landmarks");
        let [position, heading] = path.parts();
        assert!((position + heading - path.trace()).abs() < 1e-15);
        assert!((path.trace() - 0.48232).abs() < 5e-6);
    }

    #[test]
    fn each_constant_of_the_scenario_moves_the_trace() {
        let trace =
            |scenario: &Probe| after(scenario, 1, SensorKind::Range, 240).expect("clear of the landmarks").trace();
        let as_chosen = trace(&PROBE);
        for (what, change) in [
            ("v_sigma", (|p: &mut Probe| p.v_sigma[0] *= 2.0) as fn(&mut Probe)),
            ("p0_sigma", |p| p.p0_sigma[2] *= 2.0),
            ("range_sigma", |p| p.sensor.range_sigma *= 2.0),
            ("landmarks", |p| p.landmarks[0].x += 1.0),
        ] {
            let mut moved = PROBE;
            change(&mut moved);
            assert!((trace(&moved) - as_chosen).abs() > 1e-6, "{what}");
        }
    }

    #[test]
    fn a_stopped_robot_gains_no_noise() {
        let mut path = after(&PROBE, 2, SensorKind::Range, 60).expect("clear");
        let before = path.trace();
        for _ in 0..50 {
            path.step(Tick { ds: 0.0, dtheta: 0.0 }).expect("clear");
        }
        assert!(path.trace() < before);
    }
}
