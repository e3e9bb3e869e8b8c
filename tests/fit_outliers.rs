//! Fits of logs in which one reading in twenty is an outlier: behind a gate they are left out, wherever the search
//! begins. Natively only.

use chapter_tests::planted::{Log, WORLDS};
use estimate::drive::{BySensor, Drive, Event, Fit, FitResult, Fitted, Motion, Row, Settings, Truth};
use std::f64::consts::FRAC_PI_2;

/// Beacons, a car, a mower with odometry.
const TRIED: [usize; 3] = [0, 2, 4];

/// A log of a world, one reading in twenty of which lies 8 to 14 σ off.
fn spoiled(world: usize, n: u64) -> Log {
    let mut log = WORLDS[world].sound(9700 + n, false);
    let sigma = if log.drive.landmarks.is_empty() { log.settings.sigma_fix } else { log.settings.sigma_range };
    let mut count = 0;
    for row in &mut log.drive.rows {
        if let Event::Range { range: value, .. } | Event::Position { x: value, .. } = &mut row.event {
            count += 1;
            let far = sigma * (8.0 + f64::from(count % 7));
            *value += if count % 20 == 0 { far } else { 0.0 };
        }
    }
    log
}

fn fitted(log: &Log, settings: Settings) -> FitResult {
    let mut fit = Fit::new(&log.drive, settings).expect("readings");
    while fit.step(&log.drive).expect("a replay") {}
    fit.found()
}

/// The farthest that numbers of two fits lie apart, in the ± of the first. Beside odometry a delay is told in stairs.
fn apart(one: &FitResult, other: &FitResult) -> f64 {
    let stair = |number: &Fitted| one.flat.iter().any(|flat| flat.0 == *number);
    let apart = |((number, one, told), (_, other, _)): (&Number, &Number)| {
        let told = (*told)? * if number.is_sigma() { *one } else { 1.0 };
        (!stair(number)).then_some((one - other).abs() / told)
    };
    one.numbers.iter().zip(&other.numbers).filter_map(apart).fold(0.0, f64::max)
}

type Number = (Fitted, f64, Option<f64>);

fn each() -> impl Iterator<Item = (usize, u64)> {
    TRIED.into_iter().flat_map(|world| (0..3).map(move |n| (world, n)))
}

#[test]
fn behind_a_gate_a_fit_finds_what_it_would_without_outliers() {
    for (world, n) in each() {
        let (sound, log) = (WORLDS[world].sound(9700 + n, false), spoiled(world, n));
        let clean = fitted(&sound, sound.settings);
        for level in [0.95, 0.999] {
            let found = fitted(&log, Settings { gate: BySensor::all(Some(level)), ..log.settings });
            let off = apart(&clean, &found);
            assert!(found.settled && off < 1.0, "{world} {n} {level}: {off} {found:?} {clean:?}");
            let share = f64::from(found.outliers.expect("a gate")) / f64::from(found.readings);
            assert!((share - 0.05).abs() < 0.008, "{world} {n}: {share}");
            // A narrow gate refuses sound readings besides.
            let refused = f64::from(found.refused.expect("a gate")) / f64::from(found.readings);
            assert!(refused - share < 2.0 * (1.0 - level) + 0.01, "{world} {n} {level}: {refused} {share}");
            assert!(f64::from(found.beyond) < 2.0 * found.expected * f64::from(found.readings) + 3.0);
        }
        let open = fitted(&log, log.settings);
        assert!(open.outliers.is_none() && open.beyond > 3 && apart(&clean, &open) > 4.0, "{world} {n}: {open:?}");
    }
}

/// A σ five times too small refuses sound readings, one five times too large lets outliers in.
#[test]
fn where_the_search_begins_does_not_matter() {
    for (world, n) in each() {
        let log = spoiled(world, n);
        let from = |times: f64| {
            let mut settings = Settings { gate: BySensor::all(Some(0.999)), ..log.settings };
            (settings.sigma_fix, settings.sigma_range) = (settings.sigma_fix * times, settings.sigma_range * times);
            fitted(&log, settings)
        };
        let [small, large] = [0.2, 5.0].map(from);
        let off = apart(&small, &large);
        assert!(small.settled && large.settled && off < 1.0, "{world} {n}: {off} {small:?} {large:?}");
    }
}

#[test]
fn without_outliers_a_gate_changes_next_to_nothing() {
    for (world, n) in each() {
        let log = WORLDS[world].sound(9800 + n, false);
        let gated = Settings { gate: BySensor::all(Some(0.999)), ..log.settings };
        let [open, behind] = [log.settings, gated].map(|settings| fitted(&log, settings));
        let off = apart(&open, &behind);
        assert!(off < 0.6, "{world} {n}: {off} {open:?} {behind:?}");
    }
}

/// A robot that drives straight and turns at corners, of which nothing says so: a filter that has refused the fixes
/// behind one corner goes straight on, and refuses all that follow.
#[test]
fn gates_that_shut_the_filter_out_are_seen_by_what_they_refuse() {
    let mut rows = Vec::new();
    let [mut x, mut y, mut heading] = [0.0, 0.0, 0.0_f64];
    for k in 0..3000_u32 {
        let time = 0.1 * f64::from(k);
        let corner = k % 300 >= 280;
        heading += if corner { 0.1 * FRAC_PI_2 / 2.0 } else { 0.0 };
        (x, y) = (x + 0.4 * heading.cos(), y + 0.4 * heading.sin());
        rows.push(Row::new(time, Event::Speed { v: 4.0 }));
        if k % 10 == 0 {
            let noise = |phase: f64| (f64::from(k) * phase).sin();
            rows.push(Row::new(time, Event::Position { x: x + noise(0.7), y: y + noise(1.3), sigma: None }));
        }
    }
    let drive = Drive { landmarks: Vec::new(), truth: Truth::default(), rows, motion: Motion::Velocity };
    let settings = Settings { start: Some([0.0; 3]), gate: BySensor::all(Some(0.999)), ..Settings::default() };
    let only = [Fitted::SigmaTurn, Fitted::SigmaFix];
    let find = |gate| {
        let mut fit = Fit::only(&drive, Settings { gate, ..settings }, &only).expect("fixes");
        while fit.step(&drive).expect("a replay") {}
        fit.found()
    };
    let found = find(settings.gate);
    let share = |count: Option<u32>| f64::from(count.expect("a gate")) / f64::from(found.readings);
    assert!(share(found.refused) > 0.5 && share(found.outliers) < 0.02, "{found:?}");
    assert_eq!(find(BySensor::all(None)).refused, None);
}
