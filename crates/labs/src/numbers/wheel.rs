//! The bias of the wheel as a fourth state: what a lap of the corridor can tell about it. Covariances along the true path,
//! so no noise is drawn.

use super::Listing;
use crate::true_path::sensor_covariance;
use estimate::landmarks::RangeBearing;
use estimate::path_observability::PathStack;
use estimate::{Error, Unicycle, slip_covariance};
use filters::linear;
use filters::{MeasurementModel, MotionModel};
use nalgebra::{Matrix2x4, Matrix4, Vector2};
use sim::Apartment;
use sim::scenarios::HOOK;

/// The first standard deviation of the bias: the largest that the figure offers.
const FIRST_SIGMA: f64 = 0.01;
const TOLERANCE: f64 = 1e-9;

/// What is known after a lap.
struct Lap {
    /// The rank of the readings along the lap, of four states.
    rank: usize,
    /// σ of the bias, and of the heading (radians), at the end.
    bias: f64,
    heading: f64,
}

/// The state is [x, y, θ, ε]: the right wheel rolls d (1 − ε) where the encoder says d.
fn lap(fixes: bool) -> Result<Lap, Error> {
    let (home, course) = (Apartment::new(), HOOK.course);
    let (slip, w) = (slip_covariance(&HOOK.wheels, HOOK.slip), sensor_covariance(&HOOK.sensor));
    let mut p = Matrix4::zeros();
    p[(3, 3)] = FIRST_SIGMA * FIRST_SIGMA;
    let (mut stack, mut near) = (PathStack::new(4), Vec::new());
    for (k, pose) in (0..course.lap()).zip(course.poses()) {
        let tick = course.tick(k);
        let u = Vector2::new(tick.ds, tick.dtheta);
        let rolled = tick.ds + 0.5 * HOOK.wheels.baseline * tick.dtheta;
        let by_bias = Unicycle::input_jacobian(&pose) * Vector2::new(-0.5 * rolled, -rolled / HOOK.wheels.baseline);
        let (mut f, mut v) = (Matrix4::identity(), Matrix4::zeros());
        f.fixed_view_mut::<3, 3>(0, 0).copy_from(&Unicycle.jacobian(&pose, &u));
        f.fixed_view_mut::<3, 1>(0, 3).copy_from(&by_bias);
        v.fixed_view_mut::<3, 3>(0, 0).copy_from(&Unicycle::process_covariance(&pose, &slip));
        p = linear::predicted_covariance(&f, &p, &v)?;
        stack.advance(&f);
        let at = tick.drive(pose);
        let seen = |j: &usize| HOOK.sensor.reaches(at, &home.corners[*j]) && home.in_sight(at, &home.corners[*j]);
        let now: Vec<usize> = (0..home.corners.len()).filter(seen).collect();
        for &j in now.iter().filter(|j| fixes && !near.contains(*j)) {
            let mut h = Matrix2x4::zeros();
            h.fixed_view_mut::<2, 3>(0, 0).copy_from(&RangeBearing { map: home.corners }.jacobian(&at, j)?);
            p = linear::gain(&p, &h, &w)?.p;
            stack.observe(&h);
        }
        near = now;
    }
    Ok(Lap { rank: stack.analyze(TOLERANCE)?.start.rank, bias: p[(3, 3)].sqrt(), heading: p[(2, 2)].sqrt() })
}

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let [blind, fixed] = [lap(false)?, lap(true)?];
    to.by("labs::numbers::wheel::lap", None)
        .add("wheel.sigma.first", FIRST_SIGMA, "the first standard deviation of the wheel's bias")
        .add("wheel.rank.blind", blind.rank as f64, "rank of pose and bias along a lap without fixes")
        .add("wheel.rank.fixes", fixed.rank as f64, "rank of pose and bias along a lap with fixes")
        .add("wheel.sigma.blind", blind.bias, "the bias's standard deviation after a lap without fixes")
        .add("wheel.sigma.fixes", fixed.bias, "the bias's standard deviation after a lap with fixes")
        .add("wheel.heading.blind", blind.heading.to_degrees(), "heading σ after a lap without fixes, degrees")
        .add("wheel.heading.fixes", fixed.heading.to_degrees(), "heading σ after a lap with fixes, degrees");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_reading_nothing_is_learned_of_the_bias_and_with_fixes_it_is_observable() {
        let [blind, fixed] = [lap(false).expect("computed"), lap(true).expect("computed")];
        assert_eq!((blind.rank, fixed.rank), (0, 4));
        assert!((blind.bias - FIRST_SIGMA).abs() < 1e-15);
        assert!(fixed.bias < 0.2 * FIRST_SIGMA, "{}", fixed.bias);
        // Blind, the heading's σ is that of the bias times (L + πb)/b, and the slip's beside it.
        let b = HOOK.wheels.baseline;
        let by_bias = FIRST_SIGMA * (32.0 + core::f64::consts::PI * b) / b;
        let by_slip = f64::from(HOOK.course.lap()).sqrt() * 2.0_f64.sqrt() * HOOK.slip / b;
        assert!((blind.heading - by_bias.hypot(by_slip)).abs() < 1e-12);
    }
}
