//! Verdicts on logs with a fault that is large: speeds in another unit, ranges in feet, turns of the wrong sign beside
//! other faults. Natively only.

use chapter_tests::planted::{Log, WORLDS, judged};
use estimate::drive::{Drive, Event, Fault, Fit, Fitted, Motion, Row, Settings, Standing, Suspect, Truth};
use geom::wrap;
use sim::Noise;

/// A sound log of a world, whose events are spoiled; half of them have a truth.
fn spoiled(world: usize, n: u64, mut spoil: impl FnMut(&mut Event)) -> Log {
    let mut log = WORLDS[world].sound(9000 + n, n.is_multiple_of(2));
    log.drive.rows.iter_mut().for_each(|row| spoil(&mut row.event));
    log
}

/// A log whose speeds are read so many times too high.
fn faster(world: usize, n: u64, times: f64) -> Log {
    spoiled(world, n, |event| {
        if let Event::Velocity { v, .. } = event {
            *v *= times;
        }
    })
}

/// What is named first, and is sure.
fn first(log: &Log) -> Suspect {
    let mut suspects = judged(log).expect("a verdict").suspects;
    assert_eq!(suspects[0].standing, Standing::Sure, "{:?}", &suspects[..3]);
    suspects.remove(0)
}

/// The car with its fixes, and the robot with a compass beside them.
const WITH_FIXES: [usize; 2] = [2, 3];

#[test]
fn a_speed_is_named_with_how_many_times_too_much_it_reads() {
    for (world, times) in WITH_FIXES.iter().flat_map(|world| [0.8, 1.2, 1.5, 2.8, 4.5].map(|times| (*world, times))) {
        for n in 0..2 {
            let named = first(&faster(world, n, times));
            assert_eq!(named.number, Some(Fitted::SpeedScale), "{world} {times} {n}: {named:?}");
            let read = named.times().expect("a scale");
            assert!((read.value - times).abs() < 3.0 * read.sigma, "{world} {times} {n}: {read:?}");
            assert!(read.sigma < 0.03 * times && read.set == 1.0, "{world} {times} {n}: {read:?}");
            assert_eq!((read.unit, named.sizes[0].end), (None, false), "{world} {times} {n}: {read:?}");
        }
    }
}

#[test]
fn a_speed_in_another_unit_is_asked_for_it() {
    let units = [
        (3.6, ["km/h", "m/s"]),
        (1.0 / 3.6, ["m/s", "km/h"]),
        (1.609_344, ["km/h", "mph"]),
        (2.236_936, ["mph", "m/s"]),
        (0.514_444, ["m/s", "kn"]),
        (0.447_04, ["m/s", "mph"]),
    ];
    for (world, (times, unit)) in WITH_FIXES.iter().flat_map(|world| units.map(|unit| (*world, unit))) {
        let named = first(&faster(world, 4, times));
        let read = named.times().expect("a scale");
        assert_eq!((named.number, read.unit), (Some(Fitted::SpeedScale), Some(unit)), "{world} {times}: {read:?}");
        assert!((read.value / times - 1.0).abs() < 0.02, "{world} {times}: {read:?}");
    }
}

#[test]
fn ranges_in_feet_are_asked_for_it() {
    for n in 0..2 {
        let named = first(&spoiled(0, n, |event| {
            if let Event::Range { range, .. } = event {
                *range /= 0.3048;
            }
        }));
        let read = named.times().expect("a scale");
        assert_eq!((named.number, read.unit), (Some(Fitted::Scale), Some(["ft", "m"])), "{n}: {named:?} {read:?}");
    }
}

/// What is set is no part of what is read: only of what is to be done.
#[test]
fn how_many_times_too_much_is_read_does_not_depend_on_what_is_set() {
    let mut log = faster(2, 0, 1.2);
    log.settings.speed_scale = 0.25;
    let read = first(&log).times().expect("a scale");
    assert!((read.value - 1.2).abs() < 3.0 * read.sigma && (read.set - 0.8).abs() < 1e-12, "{read:?}");
}

/// Beyond a factor of ten no scale is tried: what lies at the end of the search is marked, and is no estimate.
#[test]
fn a_scale_at_the_end_of_the_search_says_so() {
    for (world, times) in WITH_FIXES.iter().flat_map(|world| [30.0, 1.0 / 30.0].map(|times| (*world, times))) {
        let judgement = judged(&faster(world, 0, times)).expect("a verdict");
        let named = judgement.suspects.iter().find(|it| it.number == Some(Fitted::SpeedScale)).expect("looked for");
        assert!(named.sizes[0].end, "{world} {times}: {named:?}");
    }
}

/// A fit that may take σ of the distance for it does: that σ is told beside how far the robot drives in a second.
#[test]
fn a_fit_tells_how_large_the_noise_of_the_distance_is_beside_the_way() {
    let share = |log: &Log| {
        let mut fit = Fit::only(&log.drive, log.settings, &[Fitted::SigmaDistance]).expect("readings");
        while fit.step(&log.drive).expect("a replay") {}
        let found = fit.found();
        found.numbers[0].1 / found.pace
    };
    for world in WITH_FIXES {
        let [sound, scaled] = [1.0, 1.6].map(|times| share(&faster(world, 1, times)));
        assert!(sound < 0.15 && scaled > 0.2, "{world}: {sound} {scaled}");
    }
}

/// A car on a grid of streets, with fixes that claim 8 m and come late, and headings now and then. Its
/// turn rates have the wrong sign, and more noise than σ of the turn says.
fn on_the_wrong_side(n: u64) -> Log {
    let (late, turn, rough) = [(2.0, 0.1, 0.1), (-2.0, 0.1, 0.1), (-2.0, 0.2, 0.1), (-2.0, 0.1, 0.15)][n as usize % 4];
    let (mut noise, mut rows, dt) = (Noise::new(9500 + n), Vec::new(), 0.1_f64);
    let [mut x, mut y, mut theta] = [0.0_f64; 3];
    for k in 0..2400 {
        let t = dt * f64::from(k);
        let (street, on) = ((t - 10.0).div_euclid(20.0), (t - 10.0).rem_euclid(20.0));
        let side = if street.rem_euclid(3.0) == 0.0 { -1.0 } else { 1.0 };
        let omega = if street >= 0.0 && on < 5.0 { side * turn } else { 0.0 };
        let v = 15.0 * (1.0 + 0.3 * (t / 5.0).sin());
        let mut read = |time: f64, event: Event| rows.push(Row { time, event, line: rows.len() as u32 });
        read(t, Event::Velocity { v, omega: -omega });
        if k % 10 == 0 {
            let (x, y) = (x + 2.0 * noise.normal(), y + 2.0 * noise.normal());
            read(t + late + 0.003, Event::Position { x, y, sigma: Some(8.0) });
        }
        if k % 30 == 0 {
            read(t + 0.006, Event::Heading { theta: wrap(theta + 0.03 * noise.normal()), sigma: None });
        }
        let driven = v * dt + 0.3 * dt.sqrt() * noise.normal();
        (x, y) = (x + driven * theta.cos(), y + driven * theta.sin());
        theta += omega * dt + rough * dt.sqrt() * noise.normal();
    }
    rows.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.line.cmp(&b.line)));
    let drive = Drive { landmarks: Vec::new(), truth: Truth::default(), rows, motion: Motion::Velocity };
    let opening = drive.opening(&Settings::default()).expect("fixes");
    let (start_sigma, start_sigma_heading) = (opening.sigma, opening.sigma_heading);
    let settings = Settings { start: Some(opening.pose), start_sigma, start_sigma_heading, ..Settings::default() };
    Log { drive, settings }
}

/// A σ of the turn as large as the turns themselves explains about as much as their sign, and leaves nothing of it:
/// what is left beside that σ is the delay.
#[test]
fn a_wrong_sign_is_named_before_what_is_left_beside_a_larger_sigma() {
    for n in 0..12 {
        let judgement = judged(&on_the_wrong_side(n)).expect("a verdict");
        let [named, next] = &judgement.suspects[..2] else { panic!("suspects") };
        assert_eq!((named.fault, named.standing), (Fault::Mirrored, Standing::Sure), "{n}: {named:?} {next:?}");
    }
}
