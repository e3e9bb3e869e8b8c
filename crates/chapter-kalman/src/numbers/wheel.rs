//! The bias of the wheel as a fourth state: what a lap of the corridor can tell about it. Covariances along the true
//! path, so no noise is drawn.

use super::hook::bias_for;
use estimate::drive::{PoseAndScale, Scaled};
use estimate::landmarks::RangeBearing;
use estimate::path_observability::PathStack;
use estimate::{Error, RightWheel, slip_covariance};
use filters::linear;
use filters::{MeasurementModel, MotionModel};
use lab::Listing;
use labs::true_path::sensor_covariance;
use nalgebra::{Matrix1, Matrix4, Vector2};
use sim::Apartment;
use sim::scenarios::HOOK;

const TOLERANCE: f64 = 1e-9;

/// What is known after a lap.
struct Lap {
    /// The rank of the readings along the lap, of four states.
    rank: usize,
    /// σ of the bias, and of the heading (radians), at the end.
    bias: f64,
    heading: f64,
}

/// The state is [x, y, θ, ε] with ε = 0.
fn lap(fixes: bool) -> Result<Lap, Error> {
    let (home, course) = (Apartment::new(), HOOK.course);
    let (slip, w) = (slip_covariance(&HOOK.wheels, HOOK.slip), sensor_covariance(&HOOK.sensor));
    let wheel = RightWheel { baseline: HOOK.wheels.baseline };
    let mut p = Matrix4::zeros();
    p[(3, 3)] = HOOK.bias_sigma * HOOK.bias_sigma;
    let (mut stack, mut near) = (PathStack::new(4), Vec::new());
    for (k, pose) in (0..course.lap()).zip(course.poses()) {
        let tick = course.tick(k);
        let f = wheel.jacobian(&PoseAndScale { pose, epsilon: 0.0 }, &Vector2::new(tick.ds, tick.dtheta));
        p = linear::predicted_covariance(&f, &p, &RightWheel::process_covariance(&pose, &slip))?;
        stack.advance(&f);
        let at = tick.drive(pose);
        let seen = |j: &usize| HOOK.sensor.reaches(at, &home.corners[*j]) && home.in_sight(at, &home.corners[*j]);
        let now: Vec<usize> = (0..home.corners.len()).filter(seen).collect();
        for &j in now.iter().filter(|j| fixes && !near.contains(*j)) {
            let sensor = Scaled { sensor: RangeBearing { map: home.corners }, scale: Some(0.0), offset: 0.0 };
            let h = sensor.jacobian(&PoseAndScale { pose: at, epsilon: 0.0 }, j)?;
            p = linear::gain(&p, &h, &w)?.p;
            stack.observe(&h);
        }
        near = now;
    }
    Ok(Lap { rank: stack.analyze(TOLERANCE)?.start.rank, bias: p[(3, 3)].sqrt(), heading: p[(2, 2)].sqrt() })
}

/// The exercise: the lap as one reading of the bias. ε turns the estimate by `lever` ε, slip adds to that, and the
/// heading is read once at the end. Answers the lever, the slip's variance, and σ of ε: with both noises, without the
/// slip, and without the sensor's.
fn one_reading() -> Result<(f64, f64, [f64; 3]), Error> {
    let lever = bias_for(1.0).recip();
    let slip = f64::from(HOOK.course.lap()) * slip_covariance(&HOOK.wheels, HOOK.slip)[(1, 1)];
    let (p, h) = (Matrix1::new(HOOK.bias_sigma * HOOK.bias_sigma), Matrix1::new(lever));
    let read = HOOK.sensor.bearing_sigma * HOOK.sensor.bearing_sigma;
    let after = |w: f64| linear::gain(&p, &h, &Matrix1::new(w)).map(|gain| gain.p[0].sqrt());
    Ok((lever, slip, [after(read + slip)?, after(read)?, after(slip)?]))
}

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let [blind, fixed] = [lap(false)?, lap(true)?];
    let (lever, slip, [learned, slipless, noiseless]) = one_reading()?;
    to.by("chapter_kalman::numbers::wheel::lap", None)
        .add("wheel.sigma.first", HOOK.bias_sigma, "the first standard deviation of the wheel's bias")
        .add("wheel.rank.blind", blind.rank as f64, "rank of pose and bias along a lap without fixes")
        .add("wheel.rank.fixes", fixed.rank as f64, "rank of pose and bias along a lap with fixes")
        .add("wheel.sigma.blind", blind.bias, "the bias's standard deviation after a lap without fixes")
        .add("wheel.sigma.fixes", fixed.bias, "the bias's standard deviation after a lap with fixes")
        .add("wheel.heading.blind", blind.heading.to_degrees(), "heading σ after a lap without fixes, degrees")
        .add("wheel.heading.fixes", fixed.heading.to_degrees(), "heading σ after a lap with fixes, degrees")
        .by("chapter_kalman::numbers::wheel::one_reading", None)
        .add("ex.wheel.lever", lever, "rad of heading a lap for ε = 1")
        .add("ex.wheel.slip", slip.sqrt(), "what slip adds to the heading in a lap, standard deviation, rad")
        .add("ex.wheel.sigma", 100.0 * learned, "σ of ε after one reading of the heading, per cent")
        .add("ex.wheel.share", learned, "the same as a fraction")
        .add("ex.wheel.slipless", 100.0 * slipless, "the same if nothing slipped, per cent")
        .add("ex.wheel.noiseless", 100.0 * noiseless, "the same if the sensor had no noise, per cent")
        .add("ex.wheel.first", 100.0 * HOOK.bias_sigma, "σ of ε before it, per cent");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_reading_nothing_is_learned_of_the_bias_and_with_fixes_it_is_observable() {
        let [blind, fixed] = [lap(false).expect("computed"), lap(true).expect("computed")];
        assert_eq!((blind.rank, fixed.rank), (0, 4));
        assert!((blind.bias - HOOK.bias_sigma).abs() < 1e-15);
        assert!(fixed.bias < 0.2 * HOOK.bias_sigma, "{}", fixed.bias);
        // Blind, the heading's σ is that of the bias times (L + πb)/b, and the slip's beside it.
        let b = HOOK.wheels.baseline;
        let by_bias = HOOK.bias_sigma * (32.0 + core::f64::consts::PI * b) / b;
        let by_slip = f64::from(HOOK.course.lap()).sqrt() * 2.0_f64.sqrt() * HOOK.slip / b;
        assert!((blind.heading - by_bias.hypot(by_slip)).abs() < 1e-12);
    }
    #[test]
    fn one_reading_of_the_heading_tells_about_as_much_of_the_bias_as_the_fixes_of_a_lap() {
        let (lever, slip, [learned, slipless, noiseless]) = one_reading().expect("computed");
        // 1/σ² = 1/0.01² + h²/W, with h = (32 + 0.4 π)/0.4 and W = 640 · 2 · 0.0025² + 0.035².
        let h = (32.0 + 0.4 * core::f64::consts::PI) / 0.4;
        let by_pencil = |w: f64| (1e4 + h * h / w).sqrt().recip();
        assert!((lever - h).abs() < 1e-12 && (slip - 0.008).abs() < 1e-15);
        assert!((learned - by_pencil(0.008 + 0.035 * 0.035)).abs() < 1e-15);
        assert!((slipless - by_pencil(0.035 * 0.035)).abs() < 1e-15);
        assert!((noiseless - by_pencil(0.008)).abs() < 1e-15);
        let fixed = lap(true).expect("computed");
        assert!((0.5..2.0).contains(&(fixed.bias / learned)), "{} and {learned}", fixed.bias);
    }
}
