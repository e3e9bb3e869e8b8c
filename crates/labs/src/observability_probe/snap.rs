//! Snaps a landmark onto the line through the robot and another landmark, where no hand can drag it exactly.

use super::{ObservabilityProbe, ProbeParams};
use estimate::{Code, Error};
use lab::{Lab, State};
use nalgebra::Vector2;
use sim::scenarios::PROBE;

/// A landmark that a round moves by less than this (metres) has settled.
const SETTLED: f64 = 1e-13;
/// Rounds granted; each moves the landmark by a small part of what the last one did.
const ROUNDS: usize = 40;
/// The landmark keeps this far from the robot and from the other landmark, metres.
const APART: f64 = 0.4;

impl ObservabilityProbe {
    /// Where landmark `j` must stand to be in line with the robot's estimate and the nearest other landmark shown.
    ///
    /// Moving a landmark changes its readings and so the estimate: the run is replayed with the landmark on the line
    /// until neither moves any more.
    ///
    /// # Errors
    /// [`Code::Index`] when landmark `j`, or another beside it, is not shown; whatever the core answers to a replay.
    pub fn collinear_point(&self, j: u32) -> Result<[f64; 2], Error> {
        let shown = self.shown.len();
        let index = j as usize;
        if index >= shown || shown < 2 {
            let message = format!("is {j}; {shown} landmarks are shown, and a line needs two of them");
            return Err(Error::new(Code::Index, "j", message));
        }
        let mut params = self.params;
        let mut replayed = None;
        for _ in 0..ROUNDS {
            let next = replayed.as_ref().unwrap_or(self).on_the_line(&params, index);
            let moved = (Vector2::from(next) - Vector2::from(params.landmarks[index])).norm();
            params.landmarks[index] = next;
            if moved < SETTLED {
                break;
            }
            replayed = Some(Self::from_state(State { params, step: self.step })?);
        }
        Ok(params.landmarks[index])
    }

    /// The point of the line nearest to where landmark `j` is, in the room and apart from the two others on it.
    fn on_the_line(&self, params: &ProbeParams, j: usize) -> [f64; 2] {
        let at = Vector2::from(params.landmarks[j]);
        let pose = self.estimator.belief().0;
        let robot = Vector2::new(pose.x(), pose.y());
        let others = params.landmarks.iter().take(self.shown.len()).enumerate().filter(|(i, _)| *i != j);
        let nearest = others.map(|(_, p)| Vector2::from(*p)).min_by(|a, b| (a - at).norm().total_cmp(&(b - at).norm()));
        let Some(other) = nearest else { return params.landmarks[j] };
        let line = robot - other;
        let length = line.norm();
        if length < 1e-9 {
            return params.landmarks[j];
        }
        let along = line / length;
        // The part of the line in the room, as distances from the other landmark, which is in it.
        let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..2 {
            if along[axis].abs() > 1e-12 {
                let ends = [-other[axis] / along[axis], (PROBE.room - other[axis]) / along[axis]];
                least = least.max(ends[0].min(ends[1]));
                most = most.min(ends[0].max(ends[1]));
            }
        }
        let free = |t: &f64| (least..=most).contains(t) && t.abs() >= APART && (t - length).abs() >= APART;
        let wanted = (at - other).dot(&along);
        let choices = [wanted.max(least).min(most), -APART, APART, length - APART, length + APART, least, most];
        let t = choices.into_iter().filter(free).min_by(|a, b| (a - wanted).abs().total_cmp(&(b - wanted).abs()));
        let point = other + along * t.unwrap_or(wanted.max(least).min(most));
        [point[0].clamp(0.0, PROBE.room), point[1].clamp(0.0, PROBE.room)]
    }
}
