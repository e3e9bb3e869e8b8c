//! Numbers of the late readings: the figure's run as the text goes through it, over 500 seeds too, and what the
//! exercises work out with a pencil.

use estimate::Error;
use lab::{Lab, Listing};
use labs::ensemble::SEEDS;
use labs::{Course, LateFrame, LateParams, LateReadings, Way};
use sim::scenarios::THREE_SENSORS;

/// The standard deviation at the end of a gap that an exercise asks for, metres.
const HALF: f64 = 0.5;
/// The camera's place among the sensors.
const CAMERA: usize = 2;

fn open(way: Way) -> LateParams {
    LateParams { way, ..LateParams::default() }
}

/// The figure with the camera alone.
fn alone(way: Way) -> LateParams {
    LateParams { sonar_rate: 0.0, laser_rate: 0.0, ..open(way) }
}

/// The figure with its gap, and the track afterwards.
pub(super) fn in_gap() -> LateParams {
    LateParams { gap: Some([8.0, 13.0]), smooth: true, ..open(Way::GoBack) }
}

fn frame(params: LateParams) -> Result<LateFrame, Error> {
    LateReadings::new(params).map(|lab| lab.frame())
}

fn camera(frame: &LateFrame) -> f64 {
    frame.sensors[CAMERA].mean.unwrap_or(f64::NAN)
}

/// The mean lag of the estimate just before a reading of the camera is taken: ν is y − x̂⁻, and y is off by y − x.
fn before(frame: &LateFrame) -> f64 {
    let camera = &frame.sensors[CAMERA];
    let mut used = camera.used.iter().zip(&camera.came).zip(&camera.off).filter(|((used, _), _)| **used);
    let (mut sum, mut count) = (0.0, 0.0);
    for innovation in &camera.innovation {
        let Some(((_, came), off)) = used.next() else { break };
        if *came >= frame.settled {
            sum += innovation - off;
            count += 1.0;
        }
    }
    sum / count
}

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let (beside, by_itself) = (frame(open(Way::AsNew))?, frame(alone(Way::AsNew))?);
    to.by("labs::LateReadings::frame", None)
        .add("late.delay", beside.params.delay, "how late the camera is, s")
        .add("late.travelled", beside.travelled, "v·τ: how far the robot drives in the delay, in the mean, m")
        .add("late.lag", beside.lag, "how far the estimate is behind, where late readings are taken as new, m")
        .add("late.camera", camera(&beside), "the camera's mean innovation then, m")
        .add("late.lag.before", before(&beside), "how far the estimate is behind when a camera's reading comes, m")
        .add("late.nis", beside.sensors[CAMERA].nis.unwrap_or(f64::NAN), "the camera's mean NIS then")
        .add("late.alone.lag", by_itself.lag, "how far the estimate is behind with the camera alone, m")
        .add("late.alone.camera", camera(&by_itself), "the camera's mean innovation then, m")
        .add("late.back.camera", camera(&frame(open(Way::GoBack))?), "the same where one goes back, m");
    gap(to)?;
    pencil(to)
}

fn gap(to: &mut Listing) -> Result<(), Error> {
    if let Some(gap) = frame(in_gap())?.gap {
        to.by("labs::LateReadings::frame", None)
            .add("late.gap.seconds", gap.to - gap.from, "how long the figure's gap is, s")
            .add("late.gap.before", gap.sigma_before, "σ of the position as it begins, m")
            .add("late.gap.after", gap.sigma_after, "σ as it ends, m")
            .add("late.gap.smoothed", gap.sigma_smoothed.unwrap_or(f64::NAN), "the smoother's largest σ in it, m")
            .add("late.gap.worst", gap.worst_place.unwrap_or(f64::NAN), "where that is, a part of the gap")
            .add("late.gap.helped", gap.helped_place.unwrap_or(f64::NAN), "where the smoother takes most off σ");
    }
    // By the steps of the handles.
    let (from, step) = (8.0, 0.05);
    let (mut long, mut least) = (f64::NAN, f64::INFINITY);
    for steps in 20..100 {
        let seconds = step * f64::from(steps);
        let gap = frame(LateParams { gap: Some([from, from + seconds]), ..in_gap() })?.gap;
        let miss = gap.map_or(f64::INFINITY, |gap| (gap.sigma_after - HALF).abs());
        if miss < least {
            (long, least) = (seconds, miss);
        }
    }
    to.by("labs::LateReadings::frame", None)
        .add(
            "late.gap.half.seconds",
            long,
            "how long a gap from the same beginning is that ends with the exercise's σ, s",
        )
        .add("ex.gap.half", HALF, "the σ at the end of a gap that the exercise asks for, m");
    Ok(())
}

/// What the exercises on late readings ask for.
pub(super) fn pencil(to: &mut Listing) -> Result<(), Error> {
    let (speed, delay, goal) = (1.4, 0.35, 1.0);
    let q = THREE_SENSORS.q;
    to.by("chapter_kalman::numbers::late::pencil", None)
        .add("ex.late.speed", speed, "the speed of the exercise, m/s")
        .add("ex.late.delay", delay, "its delay, s")
        .add("ex.late.innovation", -speed * delay, "the mean innovation −v·τ, m")
        .add("ex.late.ahead", speed * delay, "the same with the wrong sign")
        .add("ex.late.over", -speed / delay, "−v/τ")
        .add("ex.gap.q", q, "the density of the acceleration's noise, m²/s³")
        .add("ex.gap.sigma", goal, "the standard deviation to be reached, m")
        .add("ex.gap.time", libm::cbrt(3.0 * goal * goal / q), "after how long it is reached: q t³/3 = σ², s")
        .add("ex.gap.third", libm::cbrt(goal * goal / q), "the same without the third")
        .add("ex.gap.walk", goal * goal / q, "the same were the position itself to be kicked: q t = σ²");
    let fro = frame(LateParams { course: Course::ToAndFro, ..open(Way::AsNew) })?;
    to.by("labs::LateReadings::frame", None).add("ex.late.fro", fro.lag, "the lag on the way to and fro, m");
    Ok(())
}

/// What each way costs over the seeds.
pub(super) fn ensembles(to: &mut Listing) -> Result<(), Error> {
    for (name, params) in [("all", open(Way::AsNew)), ("alone", alone(Way::AsNew))] {
        let lab = LateReadings::new(params)?;
        let (mut sums, seeds) = ([0.0; 6], f64::from(SEEDS));
        for costs in lab.seeds(0, SEEDS)?.chunks(sums.len()) {
            sums.iter_mut().zip(costs).for_each(|(sum, cost)| *sum += cost);
        }
        to.by("labs::LateReadings::seeds", None);
        for (i, way) in ["new", "dropped", "back"].into_iter().enumerate() {
            let id = |part: &str| format!("ensemble.late.{name}.{way}.{part}");
            to.add(id("rms"), sums[2 * i] / seeds, "the mean RMS error of a run, m").add(
                id("nees"),
                sums[2 * i + 1] / seeds,
                "the mean NEES; 2 is expected",
            );
        }
    }
    Ok(())
}
