//! Verdicts on the two real logs.

use estimate::Code;
use estimate::drive::{
    BySensor, Delays, Fault, Fit, Fitted, Judgement, Sensor, Settings, Standing, Verdict, log_likelihood,
};
use robot_log::parse;

const CAR: &str = include_str!("../../../content/logs/car.csv");
const COPIED: &str = include_str!("../../../content/logs/plaza1-copied.csv");
const MOWER: &str = include_str!("../../../content/logs/plaza1.csv");

fn verdict(text: &str, settings: Settings) -> Judgement {
    let drive = parse(text).expect("a log").drive;
    let mut verdict = Verdict::new(&drive, settings).expect("readings");
    while verdict.step(&drive).expect("a replay") {}
    verdict.found()
}

/// Numbers with mean 0 and variance 1.
fn normals(mut seed: u64) -> impl FnMut() -> f64 {
    let mut unit = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    // The sum of twelve is nearly normal.
    move || (0..12).map(|_| unit()).sum::<f64>() - 6.0
}

#[test]
fn the_mower_s_ranges_are_scaled_and_a_gate_does_not_hide_it() {
    for gate in [BySensor::all(None), BySensor::all(Some(0.999))] {
        let judgement = verdict(MOWER, Settings { gate, ..Settings::default() });
        let first = &judgement.suspects[0];
        assert_eq!((first.fault, first.number), (Fault::Scale, Some(Fitted::Scale)));
        assert_eq!((first.standing, judgement.ungated), (Standing::Sure, gate.range.is_some()));
        assert!(!judgement.beside);
        let size = first.sizes[0];
        assert!((size.value - 0.07).abs() < 0.002 && size.sigma < 0.001, "{size:?}");
        let (before, after) = (judgement.against.expect("a truth"), first.mended.expect("a truth"));
        assert!(before.rmse > 3.0 && after.rmse < 0.4 && after.nees < before.nees);
    }
}

/// The copy with two beacons exchanged, under the settings at which an exercise looks at it: no start is blamed.
#[test]
fn two_beacons_of_the_copy_are_exchanged() {
    for scale in [0.0, 0.07] {
        let judgement = verdict(COPIED, Settings { scale, gate: BySensor::all(Some(0.999)), ..Settings::default() });
        let first = &judgement.suspects[0];
        assert_eq!(
            (first.fault, first.landmarks.as_slice(), first.standing),
            (Fault::Exchanged, &[1, 6][..], Standing::Sure)
        );
        let (before, after) = (judgement.against.expect("a truth"), first.mended.expect("a truth"));
        assert!(!judgement.other && after.rmse < 0.5 * before.rmse, "{after:?}");
        assert!(scale == 0.0 || after.rmse < 0.4, "{after:?}");
    }
}

/// Three beacons whose places went round: no exchange of two mends it, and nothing else that is looked for.
#[test]
fn a_remedy_that_does_not_bring_the_truth_nearer_is_none() {
    let places = ["-46.623,11.026", "11.036,-6.959", "22.053,23.848"];
    let mut text = String::from(MOWER);
    for (i, id) in [0, 1, 6].into_iter().enumerate() {
        text = text.replace(&format!("L,{id},{}\n", places[i]), &format!("L,{id},{}\n", places[(i + 1) % 3]));
    }
    let judgement = verdict(&text, Settings { scale: 0.07, ..Settings::default() });
    assert!(judgement.other, "{:?}", judgement.suspects[0]);
    let before = judgement.against.expect("a truth");
    let held: Vec<_> = judgement.suspects.iter().filter(|suspect| suspect.excess > 0.0).collect();
    assert!(held.len() > 2 && held.iter().all(|suspect| suspect.standing == Standing::Maybe));
    for suspect in held {
        let after = suspect.mended.expect("held against the truth");
        assert!(after.rmse > 0.9 * before.rmse, "{suspect:?} {before:?}");
    }
}

/// The receiver filters its fixes: they come ten times a second, and err alike for seconds. A fault that so many seem
/// to tell is not named; of as few as err apart, with the σ that they tell, the speed's delay is.
#[test]
fn the_car_s_fixes_go_together_and_its_speed_is_late() {
    let judgement = verdict(CAR, Settings::default());
    let thinning = judgement.thinning.expect("fixes that go together");
    assert!(!judgement.beside && judgement.suspects[0].fault == Fault::Sigma, "{:?}", judgement.suspects[0]);
    assert_eq!((thinning.sensor, thinning.every), (Sensor::Fix, 5.0));
    let [counts, tells] = thinning.counts;
    assert!(thinning.by[0] > 0.97 && thinning.by[1] < 0.5 && counts > 2000.0 && tells < 50.0, "{thinning:?}");

    let every = BySensor { fix: thinning.every, ..BySensor::all(0.0) };
    let few = Settings { every, ..Settings::default() };
    let drive = parse(CAR).expect("a log").drive;
    let sigmas = [Fitted::SigmaFix, Fitted::SigmaDistance, Fitted::SigmaTurn];
    let mut fit = Fit::only(&drive, few, &sigmas).expect("readings");
    while fit.step(&drive).expect("a replay") {}
    let of = |which| fit.found().numbers.iter().find(|(number, ..)| *number == which).expect("it was fitted").1;
    let [sigma_fix, sigma_distance, sigma_turn] = sigmas.map(of);
    let settings = Settings { sigma_fix, sigma_distance, sigma_turn, ..few };
    let judgement = verdict(CAR, settings);
    let clock = &judgement.suspects[0];
    assert_eq!((clock.fault, clock.number, judgement.thinning), (Fault::Clock, Some(Fitted::DelaySpeed), None));
    assert!((clock.sizes[0].value - 0.55).abs() < 2.0 * clock.sizes[0].sigma, "{clock:?}");
}

/// A reader who moves the delay watches the log-likelihood: what the sentence says and what the line shows are one.
#[test]
fn the_delay_that_is_said_is_where_the_likelihood_of_the_settings_is_highest() {
    // The speed is 0.6 s late, and the robot is pushed about by more than σ of the distance says.
    let mut normal = normals(3);
    let (mut text, mut x) = (String::new(), 0.0);
    for i in 0..3000 {
        let time = f64::from(i) / 10.0;
        let speed = |time: f64| 2.0 + 1.5 * (time / 3.0).sin();
        text += &format!("V,{time},{},0\n", speed(time - 0.6));
        if i % 10 == 0 {
            text += &format!("P,{time},{},{}\n", x + 0.4 * normal(), 0.4 * normal());
        }
        x += 0.1 * speed(time) + 0.06 * normal();
    }
    let judgement = verdict(&text, Settings::default());
    let clock = &judgement.suspects[0];
    assert!(judgement.beside && clock.number == Some(Fitted::DelaySpeed), "{clock:?}");
    assert!(judgement.suspects.iter().any(|it| it.number == Some(Fitted::SigmaDistance) && it.gain > clock.gain));
    let drive = parse(&text).expect("a log").drive;
    let told = |by: f64| {
        let delays = Delays { speed: clock.sizes[0].value + by, ..Delays::default() };
        log_likelihood(&drive, Settings { delays, ..Settings::default() }, 4.0).expect("a replay").0
    };
    assert!(told(0.0) > told(-0.04) && told(0.0) > told(0.04), "{:?}", [-0.04, 0.0, 0.04].map(told));
}

/// A drive in curves with a position ten times a second that claims 1 m: its errors wander by 1 m within 40 s, or are
/// noise, and there is noise of 3 cm; the speed may be late, s.
fn claimed(wanders: bool, late: f64) -> String {
    let mut normal = normals(5);
    let (mut text, mut pose, mut error) = (String::new(), [0.0; 3], [normal(), normal()]);
    let keep = (-0.1 / 40.0_f64).exp();
    for i in 0..3000 {
        let time = f64::from(i) / 10.0;
        let speed = |time: f64| 8.0 + 4.0 * (time / 9.0).sin() + 2.0 * (time / 3.1).sin();
        let omega = 0.25 * (time / 13.0).sin() + 0.15 * (time / 5.0).sin();
        let [x, y, theta]: [f64; 3] = pose;
        let off = error.map(|it| if wanders { it } else { 0.0 } + 0.03 * normal());
        text += &format!("VE,{time},{},{omega}\nP,{time},{},{},1\n", speed(time - late), x + off[0], y + off[1]);
        let (way, about) = (0.1 * speed(time + 0.05), theta + 0.05 * omega);
        pose = [x + way * about.cos(), y + way * about.sin(), theta + 0.1 * omega];
        error = error.map(|it| keep * it + (1.0 - keep * keep).sqrt() * normal());
    }
    text
}

/// Fixes that hardly change from one to the next may be better than they claim, or err alike: both are said. Where a
/// fault makes their innovations alike, it is not.
#[test]
fn a_receiver_whose_errors_wander_is_not_simply_better_than_it_claims() {
    let judged = |wanders, late| verdict(&claimed(wanders, late), Settings::default());
    for late in [0.0, 0.4] {
        let wanders = judged(true, late);
        let first = &wanders.suspects[0];
        assert_eq!((first.fault, first.number), (Fault::Sigma, Some(Fitted::FixSigmaScale)));
        let thinning = wanders.thinning.expect("two that are told");
        assert!(
            thinning.either && thinning.every >= 2.0 && thinning.by[0] > 0.9 && thinning.by[1] < 0.5,
            "{thinning:?}"
        );
        let white = judged(false, late);
        assert!(white.thinning.is_none(), "{late}: {:?}", white.thinning);
    }
}

#[test]
fn a_log_without_a_reading_that_is_used_is_refused() {
    let drive = parse(CAR).expect("a log").drive;
    let off = Settings { fixes: false, ..Settings::default() };
    assert_eq!(Verdict::new(&drive, off).expect_err("dead reckoning").code, Code::Limit);
}

/// Fixes that are better than they are said to be: with the right σ the estimate follows them more closely, and is a
/// little farther off by chance.
#[test]
fn a_sigma_is_mended_for_its_claim_and_not_for_the_error() {
    let mut normal = normals(11);
    let mut text = String::new();
    let (mut x, mut y, mut theta) = (0.0_f64, 0.0_f64, 0.0_f64);
    for i in 0..3000 {
        let (time, v, omega) = (f64::from(i) / 10.0, 1.2, 0.1 * (f64::from(i) / 150.0).sin());
        text += &format!("G,{time},{x},{y},{theta}\nV,{time},{v},{omega}\n");
        if i % 10 == 0 {
            text += &format!("P,{time},{},{}\n", x + 0.4 * normal(), y + 0.4 * normal());
        }
        x += 0.1 * v * theta.cos() + 0.003 * normal();
        y += 0.1 * v * theta.sin() + 0.003 * normal();
        theta += 0.1 * omega + 0.001 * normal();
    }
    let judgement = verdict(&text, Settings::default());
    let first = &judgement.suspects[0];
    assert!(!judgement.other && first.fault == Fault::Sigma, "{first:?}");
    assert_eq!(first.number, Some(Fitted::SigmaFix));
    assert!((first.sizes[0].value - 0.4).abs() < 0.05, "{first:?}");
}

#[test]
fn headings_alone_name_no_turned_compass_as_a_turned_start_looks_the_same() {
    // The robot begins at 0.8 rad, and the compass reads it with an error of 0.01 rad.
    let heading = |i: u32| 0.8 + 0.001 * f64::from(i) + 0.0141 * (2.7 * f64::from(i * i)).sin();
    let row = |i: u32| format!("V,{0},1.5,0.01\nH,{0},{1:.4},0.01\n", f64::from(i) / 10.0, heading(i));
    let text: String = (0..600).map(row).collect();
    let settings = Settings { sigma_turn: 0.0005, ..Settings::default() };
    let turned = |text: &str| verdict(text, settings).suspects.iter().any(|it| it.fault == Fault::Turned);
    assert!(!turned(&text));
    let fix = |i: u32| format!("P,{0},{1},0,0.5\n", f64::from(i) / 10.0, 0.15 * f64::from(i));
    assert!(turned(&format!("{text}{}", (0..60).map(fix).collect::<String>())), "beside fixes the two are told apart");
}
