//! Numbers of the odometry hook, after one lap and just before its fourth corner. They depend on the scenario alone,
//! not on the givens: means over many seeds, since one run would quote its luck, and beside them the run that the
//! figure shows.

use core::f64::consts::{FRAC_PI_4, PI};
use estimate::Error;
use lab::Listing;
use labs::HookParams;
use labs::odometry_hook::Drive;
use sim::Noise;
use sim::scenarios::HOOK;

/// Seeds in every mean.
const SEEDS: u32 = 500;
/// A wheel-radius bias of half and of one per cent.
const BIASES: [f64; 2] = [0.005, 0.01];
/// Biases that a learning filter meets, beside that of half a per cent.
const GREATER: [(&str, f64); 2] = [("one", 0.01), ("two", 0.02)];
/// The seed of the first drive's own bias; the slip and the sensor have the streams of small seeds.
const OWN_BIAS: u64 = 1 << 40;

/// The last tick of the third side before the corner at its end comes within reach.
const LATE: u32 = 505;

/// Over the seeds: the mean size of the heading error, and for position and heading the root mean square of the error
/// and of the claimed sigma. The two are equal for a filter whose claim is right.
#[derive(Clone, Copy, Default)]
pub(crate) struct Means {
    pub heading: f64,
    pub error: [f64; 2],
    pub sigma: [f64; 2],
}

/// A run with the figure's slip and fixes.
fn with_fixes(bias: f64) -> HookParams {
    HookParams { bias, fixes: true, ..HookParams::default() }
}

/// The biased robot whose filter has the bias in its state.
fn learning() -> HookParams {
    HookParams { learn: true, ..with_fixes(BIASES[0]) }
}

/// A drive's own bias, drawn from what a learning filter believes at the start.
fn drawn(seed: u32) -> f64 {
    HOOK.bias_sigma * Noise::new(OWN_BIAS + u64::from(seed)).normal()
}

/// At each of these ticks, in increasing order, with so many seeds.
pub(crate) fn means<const N: usize>(params: HookParams, ticks: [u32; N], seeds: u32) -> Result<[Means; N], Error> {
    means_over(params, |_| params.bias, ticks, seeds)
}

/// The same where each drive has a bias of its own.
fn means_over<const N: usize>(
    params: HookParams,
    bias: impl Fn(u32) -> f64,
    ticks: [u32; N],
    seeds: u32,
) -> Result<[Means; N], Error> {
    let mut means = [Means::default(); N];
    for seed in 1..=seeds {
        let mut drive = Drive::with_bias(HookParams { seed, ..params }, bias(seed))?;
        for (mean, tick) in means.iter_mut().zip(ticks) {
            (drive.step..tick).try_for_each(|_| drive.advance())?;
            let (error, sigma) = drive.quality();
            mean.heading += error.heading.abs() / f64::from(seeds);
            mean.error[0] += error.position * error.position / f64::from(seeds);
            mean.error[1] += error.heading * error.heading / f64::from(seeds);
            mean.sigma[0] += sigma.position * sigma.position / f64::from(seeds);
            mean.sigma[1] += sigma.heading * sigma.heading / f64::from(seeds);
        }
    }
    Ok(means.map(|m| Means { error: m.error.map(f64::sqrt), sigma: m.sigma.map(f64::sqrt), ..m }))
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
    let blind = |bias| means(HookParams { fixes: false, ..with_fixes(bias) }, [lap], SEEDS);
    let [[half], [one]] = [blind(BIASES[0])?, blind(BIASES[1])?];
    let [honest, biased] =
        [means(with_fixes(0.0), [LATE, lap], SEEDS)?, means(with_fixes(BIASES[0]), [LATE, lap], SEEDS)?];
    let learn = |bias: &dyn Fn(u32) -> f64| {
        means_over(learning(), bias, [LATE, lap + LATE], SEEDS)
            .map(|[late, later]| [("before", late), ("later", later)])
    };
    to.by("chapter_kalman::numbers::hook::bias_for", None)
        .add("hook.bias.45", bias_for(FRAC_PI_4), "the bias that turns the estimate by 45° in a lap")
        .by("chapter_kalman::numbers::hook::means", None)
        .add("hook.heading.half", half.heading.to_degrees(), "mean heading error after a lap at 0.5 %, degrees")
        .add("hook.heading.one", one.heading.to_degrees(), "mean heading error after a lap at 1 %, degrees")
        .add("hook.sigma.heading", half.sigma[1].to_degrees(), "claimed heading sigma after a lap, degrees")
        .add("hook.late.tick", f64::from(LATE), "the last tick before the fourth corner is read");
    let [honest, biased] = [honest, biased].map(|[late, end]| [("before", late), ("after", end)]);
    let mut cases = vec![("honest".to_string(), honest), ("biased".to_string(), biased)];
    cases.push(("learned".to_string(), learn(&|_| BIASES[0])?));
    cases.push(("learned.drawn".to_string(), learn(&drawn)?));
    for (name, bias) in GREATER {
        cases.push((format!("learned.{name}"), learn(&|_| bias)?));
    }
    for (name, moments) in cases {
        for (when, m) in moments {
            let id = format!("hook.{name}.{when}");
            let ratio = [0, 1].map(|i| m.error[i] / m.sigma[i]);
            to.add(format!("{id}.position"), m.error[0], "root mean square position error with fixes, m")
                .add(format!("{id}.position.sigma"), m.sigma[0], "what the filter claims of it, m")
                .add(format!("{id}.position.ratio"), ratio[0], "error over claim")
                .add(format!("{id}.heading"), m.error[1].to_degrees(), "root mean square heading error, degrees")
                .add(format!("{id}.heading.sigma"), m.sigma[1].to_degrees(), "what the filter claims of it, degrees")
                .add(format!("{id}.heading.ratio"), ratio[1], "error over claim");
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One run, driven for so many ticks.
    fn driven(params: HookParams, ticks: u32) -> Result<Drive, Error> {
        let mut drive = Drive::new(params)?;
        (0..ticks).try_for_each(|_| drive.advance())?;
        Ok(drive)
    }

    #[test]
    fn the_closed_form_is_what_the_encoders_do() {
        let params = HookParams { bias: bias_for(FRAC_PI_4), slip: 0.0, ..HookParams::default() };
        let mut drive = Drive::new(params).expect("sound");
        for _ in 0..HOOK.course.lap() {
            drive.advance().expect("finite");
        }
        // Encoder ticks are 77 µm, over a baseline of 0.4 m.
        assert!((drive.quality().0.heading - FRAC_PI_4).abs() < 5e-4);
    }

    #[test]
    fn bias_outruns_the_claim_and_fixes_rescue_the_position_alone() {
        let degrees = |bias, fixes| {
            let params = HookParams { fixes, ..with_fixes(bias) };
            let [lap] = means(params, [HOOK.course.lap()], 60).expect("finite");
            (lap.error[0], lap.heading.to_degrees(), lap.sigma[1].to_degrees())
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
    fn error_and_claim_agree_without_a_bias_and_part_with_it_before_a_corner() {
        let ratios = |bias| {
            let ends = means(with_fixes(bias), [LATE, HOOK.course.lap()], 200).expect("finite");
            ends.map(|m| [0, 1].map(|i| m.error[i] / m.sigma[i]))
        };
        // A root mean square over 200 seeds scatters by √(1/400) of itself, 5 %; linearization takes a little more.
        assert!(ratios(0.0).into_iter().flatten().all(|r| (0.85..1.15).contains(&r)), "{:?}", ratios(0.0));
        let [before, after] = ratios(BIASES[0]);
        assert!(before.iter().all(|r| *r > 2.2), "{before:?}");
        // Just after a fix the position is as good as claimed, the heading is not.
        assert!((0.85..1.25).contains(&after[0]) && after[1] > 1.4, "{after:?}");
    }

    #[test]
    fn before_a_corner_the_heading_is_past_its_claim_in_the_mean_and_in_the_run_shown() {
        let [late] = means(with_fixes(BIASES[0]), [LATE], 60).expect("finite");
        assert!(late.heading > 2.0 * late.sigma[1], "{} {}", late.heading, late.sigma[1]);
        let mut shown = driven(with_fixes(BIASES[0]), LATE).expect("finite");
        let (error, sigma) = shown.quality();
        assert!(error.heading.abs() > 2.0 * sigma.heading);
        assert!(shown.seen.is_empty());
        shown.advance().expect("finite");
        assert_eq!(shown.seen.len(), 1, "the corner is read in the very next tick");
    }

    #[test]
    fn a_bias_drawn_from_the_first_belief_makes_a_linearized_filter_claim_too_much_for_a_lap() {
        // Without linearization the root mean square would be the claim. Ratios by an independent program: 1.34 and
        // 1.17, then 1.0.
        let [late, later] = means_over(learning(), drawn, [LATE, HOOK.course.lap() + LATE], SEEDS).expect("finite");
        let ratios = |m: &Means| [0, 1].map(|i| m.error[i] / m.sigma[i]);
        let ([position, heading], later) = (ratios(&late), ratios(&later));
        assert!((1.15..1.6).contains(&position) && (1.05..1.35).contains(&heading), "{position} {heading}");
        assert!(later.iter().all(|r| (0.9..1.12).contains(r)), "{later:?}");
        // The greater the bias, the worse.
        let [half, one, two] = [BIASES[0], GREATER[0].1, GREATER[1].1].map(|bias| {
            let [late] = means_over(learning(), |_| bias, [LATE], 200).expect("finite");
            ratios(&late)[0]
        });
        assert!(half < 1.1 && (1.05..1.4).contains(&one) && (2.5..3.7).contains(&two), "{half} {one} {two}");
    }

    #[test]
    fn a_filter_that_learns_the_bias_claims_what_it_errs_before_a_corner() {
        let moments = means(learning(), [LATE, HOOK.course.lap() + LATE], 200).expect("finite");
        for m in moments {
            // The bias is one value and not drawn from the first σ, so the ratio need not be 1; past it the claim would
            // be false.
            assert!(
                [0, 1].iter().all(|i| (0.6..1.2).contains(&(m.error[*i] / m.sigma[*i]))),
                "{:?} {:?}",
                m.error,
                m.sigma
            );
        }
    }
}
