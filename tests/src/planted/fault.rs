//! Faults that are planted in a sound log.
//!
//! **How large an effect is.** A number that is off by z of the standard errors with which the log tells it has an
//! effect of z σ. The standard error is taken on the log as it was before, where nothing is wrong, by the second
//! difference of the log-likelihood: the readings are then likelier by about z²/2 where the fault is mended. For
//! outliers, which have no such number, z is the root of twice that gain.

use super::{Log, WORLDS, World};
use estimate::drive::{Event, Fault, Fitted, Pose, Row, Settings, Truth, log_likelihood};
use sim::Noise;

/// The kinds, as tables name them.
pub const FAULTS: [Fault; 7] =
    [Fault::Start, Fault::Clock, Fault::Bias, Fault::Scale, Fault::Tails, Fault::Sigma, Fault::Turned];

/// Their logs: new kinds of fault leave those of the others as they are.
const SEEDS: [u64; FAULTS.len() + 1] = [1, 2, 3, 4, 6, 7, 8, 9];

/// A log with a fault.
#[derive(Clone, Debug)]
pub struct Case {
    /// The log.
    pub log: Log,
    /// In which world.
    pub world: &'static str,
    /// Whether the truth is in the log.
    pub truth: bool,
    /// What is wrong; `None` of a sound log.
    pub fault: Option<Fault>,
    /// Which number of the settings mends it, as far as one does.
    pub number: Option<Fitted>,
    /// How large its effect is, in σ.
    pub effect: f64,
    /// By how much the number is off.
    pub size: f64,
}

/// A sound log: half of them have a truth. `even`, rates change evenly from row to row, as of tables.
pub fn sound(n: u64, even: bool) -> Case {
    let world = worlds(even)[n as usize % WORLDS.len()];
    let truth = (n / WORLDS.len() as u64).is_multiple_of(2);
    let log = world.sound(100_000 + n, truth);
    Case { log, world: world.name, truth, fault: None, number: None, effect: 0.0, size: 0.0 }
}

fn worlds(even: bool) -> [World; WORLDS.len()] {
    WORLDS.map(|world| if even { world.even() } else { world })
}

/// The n-th log with this fault: half of them have a truth.
pub fn planted(fault: Fault, n: u64, even: bool) -> Case {
    let kind = FAULTS.iter().position(|one| *one == fault).unwrap_or(FAULTS.len());
    let seed = 1000 * SEEDS[kind] + n;
    let mut noise = Noise::new(seed);
    let worlds: Vec<World> = worlds(even).into_iter().filter(|world| has(world, fault)).collect();
    let (world, truth) = (&worlds[(n / 2) as usize % worlds.len()], n.is_multiple_of(2));
    let log = world.sound(seed + 500_000, truth);
    let effect = 5.0 + 5.0 * noise.uniform();
    let sign = if noise.uniform() < 0.5 { -1.0 } else { 1.0 };
    let mut pick = |from: &[Fitted]| from[(noise.uniform() * from.len() as f64) as usize % from.len()];
    let case = |log, number, size| Case { log, world: world.name, truth, fault: Some(fault), number, effect, size };
    match fault {
        Fault::Start => {
            let (log, size) = start(log, effect, &mut noise);
            case(log, None, size)
        }
        Fault::Tails => case(outliers(log, effect, &mut noise), None, 0.0),
        Fault::Sigma => {
            let told = |number: &Fitted| standard_error(&log, *number) < 0.15;
            let number = pick(&sigmas(world).into_iter().filter(told).collect::<Vec<_>>());
            let size = sign * effect * standard_error(&log, number);
            case(misclaimed(log, number, size), Some(number), size)
        }
        _ => {
            let number = pick(&numbers(world, fault));
            let size = sign * effect * standard_error(&log, number);
            case(corrupted(log, number, size), Some(number), size)
        }
    }
}

/// Whether a log of the world can have the fault.
fn has(world: &World, fault: Fault) -> bool {
    match fault {
        Fault::Start | Fault::Tails | Fault::Sigma => true,
        _ => !numbers(world, fault).is_empty(),
    }
}

fn numbers(world: &World, fault: Fault) -> Vec<Fitted> {
    let (held, [sightings, fixes, headings]) = (!world.odometry, world.periods.map(|period| period > 0.0));
    let all: &[(Fitted, bool)] = match fault {
        Fault::Clock => &[
            (Fitted::DelaySpeed, held),
            (Fitted::DelaySighting, sightings),
            (Fitted::DelayFix, fixes),
            (Fitted::DelayHeading, headings),
        ],
        Fault::Bias => &[(Fitted::TurnBias, held), (Fitted::Offset, sightings)],
        Fault::Scale => &[(Fitted::SpeedScale, held), (Fitted::Scale, sightings)],
        _ => &[(Fitted::BearingOffset, world.bearings), (Fitted::HeadingOffset, headings)],
    };
    all.iter().filter(|(_, has)| *has).map(|(number, _)| *number).collect()
}

fn sigmas(world: &World) -> Vec<Fitted> {
    let [sightings, fixes, headings] = world.periods.map(|period| period > 0.0);
    let all = [
        (Fitted::SigmaRange, sightings),
        (Fitted::SigmaBearing, world.bearings),
        (Fitted::SigmaFix, fixes),
        (Fitted::SigmaHeading, headings),
        (Fitted::SigmaDistance, true),
        (Fitted::SigmaTurn, true),
    ];
    all.into_iter().filter(|(_, has)| *has).map(|(number, _)| number).collect()
}

/// The settings with a number off by so much; a σ by its logarithm.
fn off(settings: &Settings, number: Fitted, by: f64) -> Settings {
    let mut s = *settings;
    match number {
        Fitted::SigmaDistance => s.sigma_distance *= libm::exp(by),
        Fitted::SigmaTurn => s.sigma_turn *= libm::exp(by),
        Fitted::SigmaFix => s.sigma_fix *= libm::exp(by),
        Fitted::SigmaHeading => s.sigma_heading *= libm::exp(by),
        Fitted::FixSigmaScale => s.fix_sigma_scale *= libm::exp(by),
        Fitted::HeadingSigmaScale => s.heading_sigma_scale *= libm::exp(by),
        Fitted::SigmaRange => s.sigma_range *= libm::exp(by),
        Fitted::SigmaBearing => s.sigma_bearing *= libm::exp(by),
        Fitted::DelaySpeed => s.delays.speed += by,
        Fitted::DelayTurn => s.delays.turn += by,
        Fitted::DelayFix => s.delays.fix += by,
        Fitted::DelayHeading => s.delays.heading += by,
        Fitted::DelaySighting => s.delays.sighting += by,
        Fitted::Scale => s.scale += by,
        Fitted::Offset => s.offset += by,
        Fitted::BearingOffset => s.bearing_offset += by,
        Fitted::HeadingOffset => s.heading_offset += by,
        Fitted::SpeedScale => s.speed_scale += by,
        Fitted::TurnBias => s.turn_bias += by,
    }
    s
}

/// Readings count from then on, s: those before are not in every replay where a delay is changed.
const FROM: f64 = 8.0;

/// How well a sound log tells a number.
fn standard_error(log: &Log, number: Fitted) -> f64 {
    let from = if number.is_delay() { FROM } else { -1.0 };
    let (first, last) = if number.is_delay() { (0.02, 2.0) } else { (1e-5, 2.0) };
    fall(log, |by| off(&log.settings, number, by), from, [first, last])
}

/// 1/√(−d²L/ds²), by differences at which the log-likelihood L has fallen by 2.
fn fall(log: &Log, settings: impl Fn(f64) -> Settings, from: f64, [first, last]: [f64; 2]) -> f64 {
    let of = |by: f64| log_likelihood(&log.drive, settings(by), from).map_or(f64::NEG_INFINITY, |it| it.0);
    let best = of(0.0);
    let mut by = first;
    loop {
        let fallen = best - (of(by) + of(-by)) / 2.0;
        if fallen > 2.0 || by > last {
            return by / (2.0 * fallen).sqrt();
        }
        by *= 1.5;
    }
}

/// The log as it is where the number is off in the world and not in the settings.
pub fn corrupted(mut log: Log, number: Fitted, by: f64) -> Log {
    if matches!(number, Fitted::DelaySpeed | Fitted::DelayTurn) {
        split(&mut log);
    }
    for row in &mut log.drive.rows {
        match (&mut row.event, number) {
            (Event::Speed { .. }, Fitted::DelaySpeed)
            | (Event::TurnRate { .. }, Fitted::DelayTurn)
            | (Event::Position { .. }, Fitted::DelayFix)
            | (Event::Heading { .. }, Fitted::DelayHeading)
            | (Event::Range { .. } | Event::RangeBearing { .. }, Fitted::DelaySighting) => row.time += by,
            (Event::Velocity { v, .. }, Fitted::SpeedScale) => *v /= 1.0 + by,
            (Event::Velocity { omega, .. }, Fitted::TurnBias) => *omega += by,
            (Event::Range { range, .. } | Event::RangeBearing { range, .. }, Fitted::Scale) => *range *= 1.0 + by,
            (Event::Range { range, .. } | Event::RangeBearing { range, .. }, Fitted::Offset) => *range += by,
            (Event::RangeBearing { bearing, .. }, Fitted::BearingOffset) => *bearing += by,
            (Event::Heading { theta, .. }, Fitted::HeadingOffset) => *theta += by,
            _ => {}
        }
    }
    let key = |row: &Row| (!row.event.is_motion(), row.line);
    log.drive.rows.sort_by(|a, b| a.time.total_cmp(&b.time).then_with(|| key(a).cmp(&key(b))));
    log
}

/// Speeds and turn rates in rows of their own.
fn split(log: &mut Log) {
    let rows = core::mem::take(&mut log.drive.rows);
    log.drive.rows = rows
        .into_iter()
        .flat_map(|row| match row.event {
            Event::Velocity { v, omega } => {
                let of = |event| Row { event, ..row };
                vec![of(Event::Speed { v }), of(Event::TurnRate { omega })]
            }
            _ => vec![row],
        })
        .collect();
}

fn misclaimed(log: Log, number: Fitted, by: f64) -> Log {
    Log { settings: off(&log.settings, number, by), ..log }
}

/// A start in some direction of place and heading: of the settings, or, where the truth says it, of its first pose.
fn start(log: Log, effect: f64, noise: &mut Noise) -> (Log, f64) {
    let (place, heading) = (log.settings.start_sigma, log.settings.start_sigma_heading);
    let way = [place, place, heading].map(|sigma| sigma * noise.normal());
    let first = log.drive.truth.poses().first().map(|pose| [pose.x, pose.y, pose.theta]);
    let begin = first.or(log.settings.start).unwrap_or_default();
    let moved = |by: f64| [0, 1, 2].map(|i| begin[i] + by * way[i]);
    // The same without the truth, whose first pose would go before the settings.
    let mut blind = log.clone();
    blind.drive.truth = Truth::default();
    let by = |by: f64| Settings { start: Some(moved(by)), ..blind.settings };
    let size = effect * fall(&blind, by, -1.0, [1e-2, 100.0]);
    let [x, y, theta] = moved(size);
    let mut log = log;
    match log.drive.truth.poses().split_first() {
        Some((first, others)) => {
            let wrong = Pose { x, y, theta, ..*first };
            log.drive.truth = Truth::new(core::iter::once(wrong).chain(others.iter().copied()).collect());
        }
        None => log.settings.start = Some([x, y, theta]),
    }
    (log, size)
}

/// Some readings are off by five to nine σ either way.
fn outliers(mut log: Log, effect: f64, noise: &mut Noise) -> Log {
    let readings: Vec<usize> = (0..log.drive.rows.len()).filter(|i| !log.drive.rows[*i].event.is_motion()).collect();
    let s = log.settings;
    let mut gain = 0.0;
    // Of a reading that is one of a few per hundred: what a component six times as wide explains better.
    let explained = |far: f64| 0.5 * far * far * (1.0 - 1.0 / 36.0) - libm::log(50.0) - libm::log(6.0);
    while gain < 0.5 * effect * effect {
        let row = &mut log.drive.rows[readings[(noise.uniform() * readings.len() as f64) as usize % readings.len()]];
        let far = 5.0 + 4.0 * noise.uniform();
        let by = if noise.uniform() < 0.5 { -far } else { far };
        match &mut row.event {
            Event::Position { x, y, .. } => {
                let side = if noise.uniform() < 0.5 { x } else { y };
                *side += by * s.sigma_fix;
            }
            Event::Heading { theta, .. } => *theta += by * s.sigma_heading,
            Event::Range { range, .. } | Event::RangeBearing { range, .. } => {
                *range = (*range + by * s.sigma_range).abs()
            }
            _ => {}
        }
        gain += explained(far);
    }
    log
}
