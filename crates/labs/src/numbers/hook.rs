//! Numbers of the odometry hook, after one lap and just before its fourth corner. They depend on the scenario alone, not
//! on the givens: means over many seeds, since one run would quote its luck, and beside them the run that the figure shows.

use super::Listing;
use crate::odometry_hook::{Drive, HookParams};
use core::f64::consts::{FRAC_PI_4, PI};
use estimate::Error;
use sim::scenarios::HOOK;

/// Seeds in every mean.
const SEEDS: u32 = 500;
/// A wheel-radius bias of half and of one per cent.
const BIASES: [f64; 2] = [0.005, 0.01];

/// The last tick of the third side before the corner at its end comes within reach.
const LATE: u32 = 505;

/// Means over the seeds after so many ticks: position error, size of the heading error, claimed sigma of the heading.
pub(crate) struct Means {
    pub position: f64,
    pub heading: f64,
    pub sigma: f64,
}

/// One run, driven for so many ticks.
fn driven(bias: f64, fixes: bool, seed: u32, ticks: u32) -> Result<Drive, Error> {
    let mut drive = Drive::new(HookParams { bias, slip: HOOK.slip, fixes, seed })?;
    for _ in 0..ticks {
        drive.advance()?;
    }
    Ok(drive)
}

/// So many ticks with each of so many seeds.
pub(crate) fn means(bias: f64, fixes: bool, ticks: u32, seeds: u32) -> Result<Means, Error> {
    let mut mean = Means { position: 0.0, heading: 0.0, sigma: 0.0 };
    for seed in 1..=seeds {
        let (error, sigma) = driven(bias, fixes, seed, ticks)?.quality();
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
    let lap = HOOK.course.lap();
    let blind = [means(BIASES[0], false, lap, SEEDS)?, means(BIASES[1], false, lap, SEEDS)?];
    let fixed = means(BIASES[0], true, lap, SEEDS)?;
    let late = means(BIASES[0], true, LATE, SEEDS)?;
    let shown = HookParams::default();
    let shown = driven(shown.bias, true, shown.seed, LATE)?.quality().0;
    to.by("labs::numbers::hook::bias_for", None)
        .add("hook.bias.45", bias_for(FRAC_PI_4), "the bias that turns the estimate by 45° in a lap")
        .by("labs::numbers::hook::means", None)
        .add("hook.heading.half", blind[0].heading.to_degrees(), "mean heading error after a lap at 0.5 %, degrees")
        .add("hook.heading.one", blind[1].heading.to_degrees(), "mean heading error after a lap at 1 %, degrees")
        .add("hook.sigma.heading", blind[0].sigma.to_degrees(), "claimed heading sigma after a lap, degrees")
        .add("hook.fixes.position", fixed.position, "mean position error after a lap with fixes at 0.5 %, metres")
        .add("hook.fixes.heading", fixed.heading.to_degrees(), "mean heading error after a lap with fixes, degrees")
        .add("hook.fixes.sigma", fixed.sigma.to_degrees(), "claimed heading sigma after a lap with fixes, degrees")
        .add("hook.late.tick", f64::from(LATE), "the last tick before the fourth corner is read")
        .add("hook.late.heading", late.heading.to_degrees(), "mean heading error there with fixes at 0.5 %, degrees")
        .add("hook.late.sigma", late.sigma.to_degrees(), "claimed heading sigma there with fixes, degrees")
        .add("hook.late.shown", shown.heading.abs().to_degrees(), "heading error there in the figure's run, degrees");
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
            let lap = means(bias, fixes, HOOK.course.lap(), 60).expect("finite");
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

    #[test]
    fn before_a_corner_the_heading_is_past_its_claim_in_the_mean_and_in_the_run_shown() {
        let late = means(BIASES[0], true, LATE, 60).expect("finite");
        assert!(late.heading > 2.0 * late.sigma, "{} {}", late.heading, late.sigma);
        let mut shown = driven(BIASES[0], true, HookParams::default().seed, LATE).expect("finite");
        let (error, sigma) = shown.quality();
        assert!(error.heading.abs() > 2.0 * sigma.heading);
        assert!(shown.seen.is_empty());
        shown.advance().expect("finite");
        assert_eq!(shown.seen.len(), 1, "the corner is read in the very next tick");
    }
}
