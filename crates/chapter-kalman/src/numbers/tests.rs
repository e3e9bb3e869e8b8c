//! The list of numbers, and the numbers of the prose that no check holds, against what is known of them without the
//! core: closed forms, and the covariance recursion of the rail robot written out in numbers.

use super::*;
use lab::Lab;
use labs::bug_museum::{Bug, BugMuseum, MuseumParams};
use std::collections::BTreeMap;

fn by_id(givens: &Givens) -> BTreeMap<String, f64> {
    numbers(givens).expect("computed").into_iter().map(|n| (n.id, n.value)).collect()
}

#[test]
fn ids_are_unique_and_every_number_is_finite() {
    let all = numbers(&Givens::default()).expect("computed");
    assert_eq!(by_id(&Givens::default()).len(), all.len());
    for number in all {
        assert!(number.value.is_finite(), "{}", number.id);
        assert!(!number.source.is_empty() && !number.about.is_empty(), "{}", number.id);
    }
}

#[test]
fn a_changed_matrix_or_reading_moves_the_numbers_that_depend_on_it() {
    let before = by_id(&Givens::default());
    let mut givens = Givens::default();
    givens.velocity.v[(1, 1)] *= 1.01;
    let after = by_id(&givens);
    for id in ["step1.P.22", "step3.P.11", "velocity.Rinf.2", "knob.limit.velocity"] {
        assert_ne!(before[id], after[id], "{id}");
    }
    assert_eq!(before["position.Rinf.1"], after["position.Rinf.1"]);
    let mut givens = Givens::default();
    givens.readings[1] += 0.1;
    let after = by_id(&givens);
    assert_ne!(before["step2.x.1"], after["step2.x.1"]);
    assert_eq!(before["step2.P.11"], after["step2.P.11"], "no covariance depends on a reading");
}

/// T = 0.5 s, V and W of the rail robot (§8.2.6).
const T: f64 = 0.5;
const V: [f64; 3] = [0.2, 0.05, 0.1];
const W: f64 = 0.5;

/// Gains and corrected P₁₁ of so many steps from P = diag(1, 2), for H = [1, 0] or [0, 1]. With one output of one state
/// m, S = P⁻ₘₘ + W, R = P⁻·ₘ / S and P = P⁻ − R P⁻ₘ·: no matrix is needed, and the short form loses nothing at these
/// sizes.
fn recursion(reads_velocity: bool, steps: usize) -> Vec<([f64; 2], f64)> {
    let (mut a, mut b, mut d) = (1.0, 0.0, 2.0);
    let step = |_| {
        (a, b, d) = (a + 2.0 * T * b + T * T * d + V[0], b + T * d + V[1], d + V[2]);
        let column = if reads_velocity { [b, d] } else { [a, b] };
        let s = W + if reads_velocity { d } else { a };
        let r = column.map(|entry| entry / s);
        (a, b, d) = (a - r[0] * column[0], b - r[0] * column[1], d - r[1] * column[1]);
        (r, a)
    };
    (0..steps).map(step).collect()
}

/// The gain's limit. For the velocity sensor [1/2, (√21 − 1)/10]: R₂ follows from P⁻₂₂² = V₂₂ (P⁻₂₂ + W), and R₁ = T
/// since V₁₂ = T V₂₂. For the position sensor what 400 steps lead to, each of which leaves two fifths of the distance.
fn limit(reads_velocity: bool) -> [f64; 2] {
    if reads_velocity { [0.5, (21.0_f64.sqrt() - 1.0) / 10.0] } else { recursion(false, 400)[399].0 }
}

fn expected() -> Vec<(String, f64)> {
    let mut table = Vec::new();
    for (name, reads_velocity) in [("velocity", true), ("position", false)] {
        // HR(k) / HR∞: the gain of the state that is read, over its limit.
        let read = usize::from(reads_velocity);
        let knob = |k: [f64; 2]| k[read] / limit(reads_velocity)[read];
        let knobs = recursion(reads_velocity, 8).into_iter().map(|(k, _)| knob(k));
        table.extend((1..).zip(knobs).map(|(k, value)| (format!("knob.{name}.{k}"), value)));
    }
    // The velocity sensor's second eigenvalue is 1 − g R₂, and −1 at g = 2 / R₂. With the position sensor trace and
    // determinant are 2 − g (R₁ + T R₂) and 1 − g R₁: λ = −1 solves λ² − tr λ + det = 0 at g = 4 / (2 R₁ + T R₂).
    let ([_, v2], [p1, p2]) = (limit(true), limit(false));
    table.push(("knob.limit.velocity".into(), 2.0 / v2));
    table.push(("knob.limit.position".into(), 4.0 / (2.0 * p1 + T * p2)));
    // In fractions, after 16429/10440, 59/261 and 131/522 of the second step.
    table.push(("step3.P.11".into(), 41599.0 / 22210.0));
    // K = [0.9, 0.8] makes A = [0.1 0.05; −0.8 0.6] with the eigenvalues 0.5 and 0.2, hence by Lagrange's formula
    // 0.3 Aᵏ = 0.5ᵏ (A − 0.2 I) − 0.2ᵏ (A − 0.5 I), which turns e₀ = [1, 1] into this.
    let error = |k: i32| {
        let (slow, fast) = (0.5_f64.powi(k), 0.2_f64.powi(k));
        (-0.05 * slow + 0.35 * fast).hypot(-0.4 * slow + 0.7 * fast)
    };
    table.push(("placed.ratio.12".into(), error(12) / error(11)));
    table
}

#[test]
fn numbers_without_a_check_agree_with_closed_forms() {
    let all = numbers(&Givens::default()).expect("computed");
    let computed: BTreeMap<_, _> = all.into_iter().map(|n| (n.id, n.value)).collect();
    for (id, value) in expected() {
        let ours = computed[&id];
        // The core stops looking for R∞ where it moves by 10⁻¹² a step.
        assert!((ours - value).abs() <= 1e-10, "{id} is {ours}, and should be {value}");
    }
}

/// The table's own formulas, against values computed elsewhere (exact fractions and a decimal arithmetic of 60 digits).
#[test]
fn the_closed_forms_agree_with_values_computed_elsewhere() {
    let table: BTreeMap<_, _> = expected().into_iter().collect();
    let elsewhere = [
        ("knob.velocity.1", 2.254501722962935),
        ("knob.velocity.2", 1.400991218465929),
        ("knob.velocity.3", 1.151202011836909),
        ("knob.position.1", 1.312861411074128),
        ("knob.position.2", 1.206453069550442),
        ("knob.position.3", 1.175775316193692),
        ("knob.limit.velocity", 5.58257569495584),
        ("step3.P.11", 1.872985141828005),
    ];
    for (id, value) in elsewhere {
        assert!((table[id] - value).abs() < 1e-12, "{id} is {}, not {value}", table[id]);
    }
    assert!((table["knob.limit.position"] - 3.028947960).abs() < 1e-9);
    assert!((table["placed.ratio.12"] - 0.500023).abs() < 5e-7);
    let [p, v] = [limit(false), limit(true)];
    assert!((p[0] - 0.5885825161812468).abs() < 1e-14 && (p[1] - 0.2868510009809105).abs() < 1e-14, "{p:?}");
    assert!((recursion(true, 400)[399].0[1] - v[1]).abs() < 1e-14, "{v:?}");
    assert!((recursion(true, 3)[2].1 - table["step3.P.11"]).abs() < 1e-14);
}

#[test]
fn the_log_s_story_holds() {
    let n = by_id(&Givens::default());
    assert!(n["log.reckoned.rmse"] < n["log.raw.rmse"] && n["log.raw.rmse"] < n["log.gated.rmse"], "worse with ranges");
    assert!(n["log.scaled.rmse"] < n["log.reckoned.rmse"] / 5.0 && n["log.learned.rmse"] < n["log.offset.rmse"]);
    assert!(
        n["log.offset.mean"].abs() < 0.01 && n["log.offset.nis"] > n["log.offset.band.high"],
        "an offset zeroes the mean alone"
    );
    assert!(n["log.raw.refused"] == 0.0 && n["log.gated.refused"] > 0.5);
    assert!(n["log.line.truth.r2"] > 0.7 && n["log.line.inner.slope"] < 0.0, "the filter hides the line");
    let (slope, r2) = (n["log.line.reckoned.slope"], n["log.line.reckoned.r2"]);
    assert!((slope - 0.068).abs() < 1e-3 && (r2 - 0.27).abs() < 0.01, "dead reckoning blurs it: {slope}, {r2}");
    assert!(n["log.gap.seconds"] > 90.0 && n["log.gap.minute"] == 17.0, "the claimed error rises where no range comes");
    // Four states; one beacon leaves the turn about it unseen, which does not touch the scale.
    assert_eq!((n["log.rank.all"], n["log.rank.one"]), (4.0, 3.0));
    assert!(n["log.unseen.one"] < 1e-9);
    // An independent replay has 0.86 and 1.00 over all rows; the figure draws a part of them.
    let (before, after) = (n["log.scaled.claim"], n["log.tuned.claim"]);
    assert!((before - 0.86).abs() < 0.02 && (after - 1.0).abs() < 0.02, "claims and errors agree: {before}, {after}");
    assert!(n["log.tuned.band.low"] < n["log.tuned.nis"] && n["log.tuned.nis"] < n["log.tuned.band.high"]);
    assert!(
        (n["log.scatter"] / n["log.tuned.sigma"] - 1.0).abs() < 0.1,
        "the truth says of the radios what the filter says"
    );
    assert!(n["log.stop.below.sigma"] < n["log.tuned.sigma"] && n["log.tuned.sigma"] < n["log.stop.above.sigma"]);
    assert!(n["log.stop.above.nis"] < 1.0 && n["log.stop.below.nis"] > 1.0, "the stops lie about a NIS of 1");
    let refused = |beacon: u32| n[&format!("log.wrong.{beacon}.refused")];
    assert!(
        refused(1) > 0.9 && refused(6) > 0.9 && refused(0) < 0.01 && refused(5) < 0.01 && n["log.wrong.mended"] < 0.001
    );
    assert!(
        n["log.wrong.mended.rmse"] < n["log.wrong.rmse"] && n["log.wrong.rmse"] < n["log.reckoned.rmse"] / 3.0,
        "with two beacons exchanged the estimate stays near the true track: {}",
        n["log.wrong.rmse"]
    );
}

#[test]
fn the_direction_that_a_drive_past_one_landmark_hides_is_a_turn_about_it() {
    let n = by_id(&Givens::default());
    // [−Δy, Δx, 1] at Δx = −3 m, Δy = 4 m.
    let c = [1, 2, 3].map(|i| n[&format!("ex.ghost.c.{i}")]);
    assert!([-4.0, -3.0, 1.0].iter().zip(c).all(|(a, b)| (a - b).abs() < 1e-9), "{c:?}");
    assert_eq!(n["ex.ghost.rank"], 2.0);
}

#[test]
fn the_ellipse_that_touches_the_line_is_the_step_s_innovation_in_standard_deviations() {
    let n = by_id(&Givens::default());
    // ν = −1.3 and HP⁻Hᵀ = 2.1; the gray foot is 1.3 m/s below the mean: det P⁻ = 2.4675, (P⁻⁻¹)₂₂ = 1.7/2.4675.
    let (touch, gray) = ((1.69_f64 / 2.1).sqrt(), (1.69 * 1.7 / 2.4675_f64).sqrt());
    assert!((n["picture.touch"] - touch).abs() < 1e-12 && (n["picture.gray"] - gray).abs() < 1e-12);
    assert!((n["picture.touch.inside"] - 100.0 * (1.0 - (-0.5 * touch * touch).exp())).abs() < 1e-9);
    assert!((n["picture.gray.density"] - (0.5 * (touch * touch - gray * gray)).exp()).abs() < 1e-12);
    assert!((n["picture.even"] - 2.1).abs() < 1e-12 && (n["picture.touch.even"] - 0.5 * touch).abs() < 1e-12);
    assert!((n["balance.variance"] - 1.0 / (1.0 / 2.1 + 2.0)).abs() < 1e-12 && (n["balance.read"] - 2.0).abs() < 1e-15);
    assert!((n["balance.expected"] - 1.0 / 2.1).abs() < 1e-12);
}

#[test]
fn a_filter_with_the_least_q_is_in_its_nis_band_and_wrong() {
    let mut to = Listing::new();
    tune::in_band(&mut to).expect("computed");
    let n: BTreeMap<_, _> = to.numbers.iter().map(|n| (n.id.as_str(), n.value)).collect();
    assert!(1.0 < n["ex.band.W.least"] && n["ex.band.W.least"] < n["ex.band.W.most"] && n["ex.band.W.most"] < 5.0);
    assert!(n["ex.band.lag1"] > 0.8, "innovations alike: {}", n["ex.band.lag1"]);
    assert!(n["ex.band.lacking"] > 100.0 && n["ex.band.nees"] > 10.0, "{} {}", n["ex.band.lacking"], n["ex.band.nees"]);
}

#[test]
fn what_the_text_says_of_beacons_bugs_and_sigma_points_holds() {
    let mut to = Listing::new();
    museum::list(&mut to).expect("computed");
    // The factor of 1.33 that the text prints: 200 · (0.33 · 20)².
    tune::exercises(1.33_f64.ln(), &mut to);
    let n: BTreeMap<_, _> =
        by_id(&Givens::default()).into_iter().chain(to.numbers.into_iter().map(|n| (n.id, n.value))).collect();
    for (id, value, within) in [
        ("log.line.beacon.least", 0.067970, 1e-6),
        ("log.line.beacon.most", 0.071463, 1e-6),
        ("problem9.ukf.between.1", 0.001, 6e-4),
        ("problem9.ukf.between.2", 0.090, 6e-4),
        ("problem9.ukf.between.3", 0.052, 6e-4),
        ("museum.deviation.mean.3", 1.4, 0.06),
        ("museum.deviation.mean.4", 2.0 / 7.0, 0.03),
        ("museum.twice.mean.10", 0.50, 0.01),
        ("museum.twice.mean.11", 0.32, 0.01),
        ("museum.step-length.mean.10", 0.12, 0.015),
        ("museum.step-length.mean.11", -0.29, 0.01),
        // The mean of 4000 runs.
        ("museum.none.mean.0", 0.065, 0.002),
        ("ex.readings.unlogged", 8712.0, 1e-6),
        ("const.museum.straight", 4.0, 1e-12),
    ] {
        assert!((n[id] - value).abs() < within, "{id}: {}", n[id]);
    }
    // The table says of a bug what its figure counts.
    let params = MuseumParams { bug: Bug::FrozenJacobian, many: true, ..MuseumParams::default() };
    let figure = BugMuseum::from_state(lab::State { params, step: crate::ensembles::SEEDS }).expect("sound").frame();
    assert_eq!(n["museum.frozen-jacobian.map"], 100.0 * figure.figures[0].beyond[1]);
    let gate = n["museum.open-gate.mean.0"] / n["museum.none.mean.0"];
    assert!((1.5..4.0).contains(&gate), "an open gate multiplies the position's error by {gate}");
}

#[test]
fn what_the_text_says_of_late_readings_holds() {
    let mut to = Listing::new();
    late::ensembles(&mut to).expect("computed");
    let n: BTreeMap<_, _> =
        by_id(&Givens::default()).into_iter().chain(to.numbers.into_iter().map(|n| (n.id, n.value))).collect();
    // Written out: 1.4 · 0.35, and the time t with 0.01 t³/3 = 1.
    for (id, value, within) in [
        ("ex.late.innovation", -0.49, 1e-12),
        ("ex.late.over", -4.0, 1e-12),
        ("ex.gap.time", 300.0_f64.powf(1.0 / 3.0), 1e-12),
        ("ex.gap.third", 100.0_f64.powf(1.0 / 3.0), 1e-12),
        ("ex.gap.walk", 100.0, 1e-9),
        // Alone the estimate lags by all of v·τ, and its innovations tell nothing; beside others by its share.
        ("late.alone.lag", n["late.travelled"], 0.05),
        ("late.alone.camera", 0.0, 0.05),
        ("late.back.camera", 0.0, 0.05),
        ("late.gap.worst", 0.5, 0.17),
        ("late.gap.helped", 1.0, 0.05),
        ("ensemble.late.all.dropped.nees", 2.0, 0.1),
        ("ensemble.late.all.back.nees", 2.0, 0.1),
    ] {
        assert!((n[id] - value).abs() < within, "{id}: {}", n[id]);
    }
    assert!(n["late.lag"] > 0.5 * n["late.travelled"] && n["late.lag"] < n["late.travelled"]);
    assert!(n["late.camera"] < -0.3 * n["late.travelled"]);
    // Between its readings the others bring the estimate forward; its innovation is what the lag leaves of v·τ, but for
    // the noise of its readings, 0.05 m over the root of their number.
    assert!(n["late.lag.before"] < 0.8 * n["late.lag"]);
    assert!((n["late.camera"] - n["late.lag.before"] + n["late.travelled"]).abs() < 0.05, "{}", n["late.lag.before"]);
    assert!((n["late.gap.half.seconds"] - 3.0).abs() < 0.5, "{}", n["late.gap.half.seconds"]);
    let rms = |id: &str| n[&format!("ensemble.late.{id}.rms")];
    assert!(rms("all.dropped") < 1.4 * rms("all.back") && rms("all.new") > 3.0 * rms("all.dropped"));
    assert!(rms("alone.dropped") > 10.0 * rms("alone.back"));
}

#[test]
fn what_the_text_says_of_the_car_holds() {
    let mut to = Listing::new();
    car::list(&mut to).expect("computed");
    let n: BTreeMap<_, _> = to.numbers.iter().map(|n| (n.id.as_str(), n.value)).collect();
    // Of an independent replay; the last four are of a delay of 0.58 s in place of its 0.5 s, or of none.
    for (id, value, within) in [
        ("car.all.nis", 0.633428672, 1e-6),
        ("car.second.nis", 2.923664776, 1e-6),
        ("car.delay", 0.58, 0.021),
        ("car.gain", 148.0, 1.0),
        ("car.late.nis", 2.20, 0.02),
        ("car.learned.lag1", 0.89, 0.01),
        ("car.kappa", 0.025, 0.005),
        ("car.tunnel.worst", 48.340891009, 1e-6),
        ("car.tunnel.smoothed", 13.977784991, 1e-6),
        ("car.gate.of", 205.0, 1e-12),
        ("car.gate.open.of", 205.0, 1e-12),
        ("car.alone", 90.0, 5.0),
    ] {
        assert!((n[id] - value).abs() < within, "{id}: {}", n[id]);
    }
    assert!(n["car.gate.refused"] > 20.0 && n["car.gate.nis"] < 1.2, "{}", n["car.gate.nis"]);
    assert!(n["car.gate.open.refused"] > 1.8 * n["car.gate.refused"], "{}", n["car.gate.open.refused"]);
    assert!(
        (n["car.gate.open.nis"] - n["car.gate.nis"]).abs() < 0.1,
        "the NIS of what passes does not tell them apart"
    );
}
