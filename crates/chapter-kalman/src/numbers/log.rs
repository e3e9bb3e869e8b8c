//! Numbers of the real robot's log: the replays that the text goes through.

use estimate::drive::{BySensor, Event, FIRST_SIGMA, Line, Points, PoseAndScale, Scaled};
use estimate::landmarks::RangeOnly;
use estimate::path_observability::PathStack;
use estimate::{Code, Error, Landmark, Unicycle};
use filters::{MeasurementModel, MotionModel};
use geom::SE2;
use lab::Lab;
use lab::Listing;
use labs::{LogFrame, LogLandmark, LogParams, LoggedDrive, RobotLog};
use nalgebra::{SMatrix, Vector2};
use std::sync::Arc;

/// The log, as the figure fetches it.
const PLAZA: &str = include_str!("../../../../content/logs/plaza1.csv");
/// The same log, copied with the mistake that an exercise asks for: two beacons have each other's number.
const COPIED: &str = include_str!("../../../../content/logs/plaza1-copied.csv");
/// The gate that the text tries.
const GATE: f64 = 0.999;
/// The offset that it tries, metres.
const OFFSET: f64 = 2.4;
/// The rank test takes so much of the drive.
const TESTED_ROWS: usize = 4000;
const TOLERANCE: f64 = 1e-9;

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let logged = read("plaza1.csv", PLAZA)?;
    drive(&logged, to);
    constants(to);
    replays(&logged, to)?;
    for (name, beacons) in [("all", logged.drive().landmarks.len()), ("one", 1)] {
        let (rank, unseen) = learned_scale(&logged, beacons)?;
        to.by("estimate::path_observability::PathStack", None)
            .add(format!("log.rank.{name}"), rank as f64, "the rank along the drive with ε in the state, of 4")
            .add(format!("log.unseen.{name}"), unseen, "the largest |ε| of an unseen direction of length 1");
    }
    Ok(())
}

fn read(name: &'static str, text: &str) -> Result<Arc<LoggedDrive>, Error> {
    let log = robot_log::parse(text).map_err(|e| Error::new(Code::Type, name, e.to_string()))?;
    Ok(Arc::new(LoggedDrive::new(log.drive)))
}

/// The frame at the end of a log.
fn whole(logged: &Arc<LoggedDrive>, params: LogParams) -> Result<LogFrame, Error> {
    RobotLog::at(Arc::clone(logged), params, logged.rows()).map(|lab| lab.frame())
}

fn drive(logged: &LoggedDrive, to: &mut Listing) {
    let [first, last] = logged.span();
    let poses = logged.drive().truth.poses();
    let legs = poses.windows(2).map(|pair| numerics::hypot(pair[1].x - pair[0].x, pair[1].y - pair[0].y));
    let sightings = logged.drive().rows.iter().filter(|row| !row.event.is_motion()).count();
    to.by("labs::LoggedDrive", None)
        .add("log.minutes", ((last - first) / 60.0).round(), "how long the drive took")
        .add("log.km", legs.sum::<f64>() / 1000.0, "how far the robot drove, by its true positions")
        .add("log.ranges", sightings as f64, "ranges in the log")
        .add("log.beacons", logged.drive().landmarks.len() as f64, "radio beacons");
    let (length, middle) = gap(logged);
    to.add("log.gap.seconds", length.round(), "the longest time without a range, s").add(
        "log.gap.minute",
        (middle / 60.0).round(),
        "the middle of the longest time without a range, in minutes of the drive",
    );
}

/// The longest time without a range, and its middle, seconds.
fn gap(logged: &LoggedDrive) -> (f64, f64) {
    let rows = &logged.drive().rows;
    let times: Vec<f64> = rows.iter().filter(|row| !row.event.is_motion()).map(|row| row.time).collect();
    let gaps = times.windows(2).map(|pair| (pair[1] - pair[0], f64::midpoint(pair[0], pair[1]) - logged.span()[0]));
    gaps.fold((0.0, 0.0), |longest, gap| if gap.0 > longest.0 { gap } else { longest })
}

/// What the filter of the log is given, for the table of constants.
fn constants(to: &mut Listing) {
    let usual = LogParams::default();
    to.by("labs::LogParams", None)
        .add("const.log.distance", usual.sigma_distance, "standard deviation of the distance driven in a second, m")
        .add("const.log.turn", usual.sigma_turn, "of the turn in a second, rad")
        .add("const.log.range", usual.sigma_range, "of a range, m")
        .vector("const.log.p0", &FIRST_SIGMA, "first uncertainty, standard deviation: m, m, rad, and the scale");
}

fn replays(logged: &Arc<LoggedDrive>, to: &mut Listing) -> Result<(), Error> {
    let usual = LogParams::default();
    let whole = |params| whole(logged, params);
    let off = || Error::new(Code::Limit, "plaza1.csv", "has no truth, or no range was used");
    to.by("labs::RobotLog", None);
    let reckoned = whole(LogParams { sightings: false, ..usual })?;
    to.add("log.reckoned.rmse", reckoned.summary.rmse.ok_or_else(off)?, "RMS error of dead reckoning, m");
    to.add("log.reckoned.worst", reckoned.summary.worst.ok_or_else(off)?, "its largest error, m");
    let raw = whole(usual)?;
    let gated = whole(LogParams { gate: BySensor::all(Some(GATE)), ..usual })?;
    let offset = whole(LogParams { offset: OFFSET, ..usual })?;
    // As the figure does it: the slope of what is off of the ranges, in steps of the slider.
    let line = raw.range_line.ok_or_else(off)?;
    let scale = (1000.0 * line.slope).round() / 1000.0;
    let scaled = whole(LogParams { scale, ..usual })?;
    let learned = whole(LogParams { learn: true, ..usual })?;
    let tuned = usual.sigma_range * scaled.summary.nis.ok_or_else(off)?.sqrt();
    let calibrated = whole(LogParams { scale, sigma_range: (100.0 * tuned).round() / 100.0, ..usual })?;
    for (name, frame) in [
        ("raw", &raw),
        ("gated", &gated),
        ("offset", &offset),
        ("scaled", &scaled),
        ("learned", &learned),
        ("tuned", &calibrated),
    ] {
        summary(name, frame, to).ok_or_else(off)?;
    }
    for (name, frame) in [("scaled", &scaled), ("tuned", &calibrated)] {
        to.add(
            format!("log.{name}.claim"),
            claim(frame),
            "mean of (error / claimed σ)² of the position, 1 is expected",
        );
    }
    stops(logged, LogParams { scale, ..usual }, tuned, to)?;
    wrong(logged, LogParams { scale, ..usual }, to)?;
    to.by("labs::RobotLog", None)
        .add("log.given.gate", GATE, "the gate's probability that the text tries")
        .add("log.given.offset", OFFSET, "the offset that it tries, m")
        .add("log.given.scale", scale, "the scale that it tries: the slope of the line, rounded")
        .add("log.scatter", scatter(logged, line), "how far ranges scatter about the line against the true range, m")
        .add("log.gate.expected", 1.0 - GATE, "share of readings that the gate refuses where the model holds")
        .add("log.tuned.sigma", calibrated.params.sigma_range, "σ_ρ at which NIS is near 1, m");
    let slopes: Vec<f64> = lines_by_beacon(logged).into_iter().flatten().map(|line| line.slope).collect();
    to.by("chapter_kalman::numbers::log::lines_by_beacon", None)
        .add(
            "log.line.beacon.least",
            slopes.iter().copied().fold(f64::INFINITY, f64::min),
            "the least slope of a beacon",
        )
        .add("log.line.beacon.most", slopes.iter().copied().fold(f64::NEG_INFINITY, f64::max), "the greatest");
    let reckoned = reckoned_line(logged);
    for (name, line) in [("truth", raw.range_line), ("inner", raw.innovation_line), ("reckoned", reckoned)] {
        let line = line.ok_or_else(off)?;
        to.by(if name == "reckoned" { "chapter_kalman::numbers::log::reckoned_line" } else { "labs::RobotLog" }, None);
        to.add(format!("log.line.{name}.slope"), line.slope, "the slope of the line through errors over ranges")
            .add(format!("log.line.{name}.offset"), line.offset, "its value at 0, m")
            .add(format!("log.line.{name}.r2"), line.r2, "R², the share of the variance that it explains");
    }
    let (epsilon, sigma) = learned.summary.epsilon.zip(learned.summary.epsilon_sigma).ok_or_else(off)?;
    to.by("labs::RobotLog", None).add("log.learned.epsilon", epsilon, "the learned scale").add(
        "log.learned.sigma",
        sigma,
        "its standard deviation",
    );
    Ok(())
}

/// The two stops of the figure's slider about `sigma`, 50 to a power of ten and of three decimals, and the NIS there.
fn stops(logged: &Arc<LoggedDrive>, scaled: LogParams, sigma: f64, to: &mut Listing) -> Result<(), Error> {
    let below = (50.0 * libm::log10(sigma)).floor();
    for (name, stop) in [("below", below), ("above", below + 1.0)] {
        let sigma_range = (1000.0 * libm::exp10(0.02 * stop)).round() / 1000.0;
        let frame = whole(logged, LogParams { sigma_range, ..scaled })?;
        to.add(format!("log.stop.{name}.sigma"), sigma_range, "a stop of the slider of σ_ρ, m").add(
            format!("log.stop.{name}.nis"),
            frame.summary.nis.unwrap_or(f64::NAN),
            "the NIS there",
        );
    }
    Ok(())
}

/// The mean of (error / σ)² of the position at the rows that the figure draws, with the σ that the filter claims.
fn claim(frame: &LogFrame) -> f64 {
    let ratios = frame.errors.error.iter().zip(&frame.errors.bound).map(|(error, bound)| 2.0 * error / bound);
    ratios.map(|ratio| ratio * ratio).sum::<f64>() / frame.errors.error.len() as f64
}

/// The line through how far the ranges are off from those of dead reckoning, which starts at the first true pose.
fn reckoned_line(logged: &LoggedDrive) -> Option<Line> {
    let drive = logged.drive();
    let first = drive.truth.poses().first()?;
    let (mut pose, mut points) = (SE2::new(first.x, first.y, first.theta), Points::default());
    for row in &drive.rows {
        match row.event {
            Event::Odometry { distance, turn } => pose = Unicycle.f(&pose, &Vector2::new(distance, turn)),
            Event::Range { landmark, range } => {
                let at = drive.landmarks[landmark];
                let known = numerics::hypot(at.x - pose.x(), at.y - pose.y());
                points.take(known, range - known);
            }
            _ => {}
        }
    }
    points.line()
}

/// The line through how far each beacon's ranges are off from the true ones.
fn lines_by_beacon(logged: &LoggedDrive) -> Vec<Option<Line>> {
    let drive = logged.drive();
    let mut points: Vec<Points> = drive.landmarks.iter().map(|_| Points::default()).collect();
    for row in &drive.rows {
        let Event::Range { landmark, range } = row.event else { continue };
        let Some([x, y]) = drive.truth.position(row.time) else { continue };
        let known = numerics::hypot(drive.landmarks[landmark].x - x, drive.landmarks[landmark].y - y);
        points[landmark].take(known, range - known);
    }
    points.iter().map(Points::line).collect()
}

/// The standard deviation of the ranges about the line that says how far they are off.
fn scatter(logged: &LoggedDrive, line: Line) -> f64 {
    let drive = logged.drive();
    let (mut count, mut squares) = (0.0, 0.0);
    for row in &drive.rows {
        let Event::Range { landmark, range } = row.event else { continue };
        let Some([x, y]) = drive.truth.position(row.time) else { continue };
        let known = numerics::hypot(drive.landmarks[landmark].x - x, drive.landmarks[landmark].y - y);
        let off = range - known - line.offset - line.slope * known;
        count += 1.0;
        squares += off * off;
    }
    (squares / count).sqrt()
}

/// The log with a mistake: a beacon a metre off, and the copy in which two beacons have each other's number.
fn wrong(logged: &Arc<LoggedDrive>, calibrated: LogParams, to: &mut Listing) -> Result<(), Error> {
    let off = || Error::new(Code::Limit, "plaza1.csv", "has other beacons than the text says");
    let mut moved = logged.drive().clone();
    let beacon = moved.landmarks.first_mut().ok_or_else(off)?;
    beacon.y += 1.0;
    let id = beacon.id;
    let frame = whole(&Arc::new(LoggedDrive::new(moved)), calibrated)?;
    to.by("labs::RobotLog", None).add("log.moved.id", f64::from(id), "the beacon that is moved");
    summary("moved", &frame, to).ok_or_else(off)?;
    let gated = LogParams { gate: BySensor::all(Some(GATE)), ..calibrated };
    let share = |used: u32, refused: u32| f64::from(refused) / f64::from(used + refused);
    let sound = whole(logged, gated)?.summary;
    let copied = whole(&read("plaza1-copied.csv", COPIED)?, gated)?;
    to.add("log.wrong.mended", share(sound.used, sound.refused), "the share of refused readings with the right map")
        .add("log.wrong.mended.rmse", sound.rmse.ok_or_else(off)?, "RMS error of the position with it, m")
        .add("log.wrong.rmse", copied.summary.rmse.ok_or_else(off)?, "the same of the log with a mistake, m");
    for (LogLandmark { id, used, refused, .. }, said) in copied.by_landmark.iter().zip(&copied.landmark_statistics) {
        let (readings, mean) = (f64::from(used + refused), said.mean.ok_or_else(off)?);
        to.add(format!("log.wrong.{id}.readings"), readings, "a beacon's readings in the log with a mistake")
            .add(format!("log.wrong.{id}.refused"), share(*used, *refused), "the share of them that the gate refuses")
            .add(format!("log.wrong.{id}.mean"), mean, "the mean of ν/√S of those that are used")
            .add(format!("log.wrong.{id}.nis"), said.nis.ok_or_else(off)?, "their NIS");
    }
    Ok(())
}

fn summary(name: &str, frame: &LogFrame, to: &mut Listing) -> Option<()> {
    let s = &frame.summary;
    let (bands, refused) = (frame.bands?, f64::from(s.refused) / f64::from(s.used + s.refused));
    to.add(format!("log.{name}.rmse"), s.rmse?, "RMS error of the position, m")
        .add(format!("log.{name}.nis"), s.nis?, "NIS for each output, 1 is expected")
        .add(format!("log.{name}.mean"), s.mean_innovation?, "mean of ν/√S, 0 is expected")
        .add(format!("log.{name}.lag1"), s.lag1?, "its autocorrelation at lag 1, 0 is expected")
        .add(format!("log.{name}.refused"), refused, "share of refused readings")
        .add(format!("log.{name}.band.low"), bands.nis[0], "the lower end of the 95 % band of NIS")
        .add(format!("log.{name}.band.high"), bands.nis[1], "its upper end");
    Some(())
}

/// The rank of the readings along the drive, by odometry alone, with ε among four states; and ε in the unseen
/// directions.
fn learned_scale(logged: &LoggedDrive, beacons: usize) -> Result<(usize, f64), Error> {
    let drive = logged.drive();
    let map: &[Landmark] = &drive.landmarks;
    let start = drive.truth.poses().first().map_or(SE2::new(0.0, 0.0, 0.0), |at| SE2::new(at.x, at.y, at.theta));
    let mut state = PoseAndScale { pose: start, epsilon: 0.0 };
    let mut stack = PathStack::new(4);
    let sensor = Scaled { sensor: RangeOnly { map }, scale: None, offset: 0.0 };
    for row in drive.rows.iter().take(TESTED_ROWS) {
        match row.event {
            Event::Odometry { distance, turn } => {
                let u = Vector2::new(distance, turn);
                stack.advance(&MotionModel::<PoseAndScale, 4, 2>::jacobian(&Unicycle, &state, &u));
                state = Unicycle.f(&state, &u);
            }
            Event::Range { landmark, .. } if landmark < beacons => {
                let h: SMatrix<f64, 1, 4> = sensor.jacobian(&state, landmark)?;
                stack.observe(&h);
            }
            _ => {}
        }
    }
    let seen = stack.analyze(TOLERANCE)?.start;
    let unseen = seen.nullspace.iter().map(|direction| direction[3].abs()).fold(0.0, f64::max);
    Ok((seen.rank, unseen))
}
