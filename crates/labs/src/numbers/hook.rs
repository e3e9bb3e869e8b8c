//! Numbers of the odometry hook, after one lap. They depend on the scenario alone, not on the givens: means over many
//! seeds, since one run would quote its luck.

use super::Listing;
use crate::odometry_hook::{Drive, HookParams};
use core::f64::consts::{FRAC_PI_4, PI};
use estimate::Error;
use sim::scenarios::HOOK;

/// Seeds in every mean.
const SEEDS: u32 = 500;
/// A wheel-radius bias of half and of one per cent.
const BIASES: [f64; 2] = [0.005, 0.01];

/// Means over the seeds after a lap: position error, size of the heading error, claimed sigma of the heading.
pub(crate) struct Lap {
    pub position: f64,
    pub heading: f64,
    pub sigma: f64,
}

/// A lap for each of so many seeds.
pub(crate) fn laps(bias: f64, fixes: bool, seeds: u32) -> Result<Lap, Error> {
    let mut mean = Lap { position: 0.0, heading: 0.0, sigma: 0.0 };
    for seed in 1..=seeds {
        let mut drive = Drive::new(HookParams { bias, slip: HOOK.slip, fixes, seed })?;
        for _ in 0..HOOK.course.lap() {
            drive.advance()?;
        }
        let (error, sigma) = drive.quality();
        mean.position += error.position / f64::from(seeds);
        mean.heading += error.heading.abs() / f64::from(seeds);
        mean.sigma += sigma.heading / f64::from(seeds);
    }
    Ok(mean)
}

/// The bias that turns the estimate by `angle` in a lap: the right wheel's way is the loop's and half a baseline more
/// for each turn, L + πb, and ε of it over b is the error.
pub(crate) fn bias_for(angle: f64) -> f64 {
    let b = HOOK.wheels.baseline;
    let length = HOOK.course.ds * f64::from(HOOK.course.lap());
    angle * b / (length + PI * b)
}

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let blind = [laps(BIASES[0], false, SEEDS)?, laps(BIASES[1], false, SEEDS)?];
    let fixed = [laps(BIASES[0], true, SEEDS)?, laps(BIASES[1], true, SEEDS)?];
    to.by("labs::numbers::hook::bias_for", None)
        .add("hook.bias.45", bias_for(FRAC_PI_4), "the bias that turns the estimate by 45° in a lap")
        .by("labs::numbers::hook::laps", None)
        .add("hook.heading.half", blind[0].heading.to_degrees(), "mean heading error after a lap at 0.5 %, degrees")
        .add("hook.heading.one", blind[1].heading.to_degrees(), "mean heading error after a lap at 1 %, degrees")
        .add("hook.sigma.heading", blind[0].sigma.to_degrees(), "claimed heading sigma after a lap, degrees")
        .add("hook.fixes.position", fixed[0].position, "mean position error after a lap with fixes at 0.5 %, metres")
        .add("hook.fixes.sigma", fixed[0].sigma.to_degrees(), "claimed heading sigma after a lap with fixes, degrees")
        .add("hook.fixes.heading.low", fixed[0].heading.to_degrees(), "mean heading error with fixes at 0.5 %, degrees")
        .add("hook.fixes.heading.high", fixed[1].heading.to_degrees(), "mean heading error with fixes at 1 %, degrees");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closed_form_is_what_the_encoders_do() {
        let mut drive =
            Drive::new(HookParams { bias: bias_for(FRAC_PI_4), slip: 0.0, fixes: false, seed: 1 }).expect("sound");
        for _ in 0..HOOK.course.lap() {
            drive.advance().expect("finite");
        }
        // Encoder ticks are 77 µm, over a baseline of 0.4 m.
        assert!((drive.quality().0.heading - FRAC_PI_4).abs() < 5e-4);
    }

    #[test]
    fn bias_outruns_the_claim_and_fixes_rescue_the_position_alone() {
        let degrees = |bias, fixes| {
            let lap = laps(bias, fixes, 60).expect("finite");
            (lap.position, lap.heading.to_degrees(), lap.sigma.to_degrees())
        };
        // Bands of three standard errors and more of 60 seeds about means found independently.
        let (_, heading, sigma) = degrees(0.005, false);
        assert!((heading - 23.6).abs() < 2.5 && (sigma - 5.12).abs() < 0.01, "{heading} {sigma}");
        let (_, heading, _) = degrees(0.01, false);
        assert!((heading - 47.0).abs() < 2.5, "{heading}");
        for bias in BIASES {
            let (position, heading, sigma) = degrees(bias, true);
            assert!(position < 0.2 && (1.1..1.5).contains(&sigma), "{bias}: {position} {sigma}");
            assert!((1.5..6.0).contains(&heading), "{bias}: {heading}");
        }
    }
}
