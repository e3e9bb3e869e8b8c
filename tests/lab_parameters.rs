//! Whatever parameters a lab is given, it runs or refuses: no panic, no change by a refused call, and every covariance of
//! every frame is one.

#![cfg(not(target_arch = "wasm32"))]

use estimate::validate;
use labs::{
    BenchParams, HookParams, Lab, Mode, ObservabilityProbe, ObserverBench, OdometryHook, Picture, PictureParams,
    ProbeParams, Sensor, SensorKind,
};
use nalgebra::DMatrix;
use proptest::prelude::*;
use serde_json::Value;

/// A number as callers send them: mostly within `sound`, sometimes at the edge of the representable, sometimes none.
fn number(sound: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    let edges = vec![0.0, -0.0, -1.0, 1e-9, 1e9, 1e154, 1e308, -1e308, f64::MIN_POSITIVE, 5e-324];
    prop_oneof![
        16 => sound,
        1 => prop::sample::select(edges),
        1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
    ]
}

/// Every square matrix under a key P, however deep.
fn covariances(value: &Value, found: &mut Vec<DMatrix<f64>>) {
    match value {
        Value::Array(all) => all.iter().for_each(|inner| covariances(inner, found)),
        Value::Object(fields) => {
            for (key, inner) in fields {
                let rows = inner.as_array().filter(|rows| key == "P" && rows.iter().all(Value::is_array));
                let Some(rows) = rows else {
                    covariances(inner, found);
                    continue;
                };
                // JSON has no NaN: it would be null, and is put back here.
                let entry = |i: usize, j: usize| rows[i][j].as_f64().unwrap_or(f64::NAN);
                found.push(DMatrix::from_fn(rows.len(), rows.len(), entry));
            }
        }
        _ => {}
    }
}

/// The lab under these parameters, then under those, some steps each.
fn answers_or_refuses<L: Lab<Params: PartialEq + std::fmt::Debug>>(
    first: L::Params,
    second: L::Params,
    steps: u32,
) -> Result<(), TestCaseError> {
    let Ok(mut lab) = L::new(first) else { return Ok(()) };
    for call in 0..3 {
        let before = (lab.params().clone(), lab.steps(), lab.digest());
        let accepted = match call {
            1 => lab.set(second.clone()).is_ok(),
            _ => lab.run(steps).is_ok(),
        };
        if !accepted {
            prop_assert_eq!((lab.params().clone(), lab.steps(), lab.digest()), before);
            continue;
        }
        let mut found = Vec::new();
        let frame = serde_json::to_value(labs::Shown(&lab.frame())).map_err(|e| TestCaseError::fail(e.to_string()))?;
        covariances(&frame, &mut found);
        for p in found {
            let refusal = validate::covariance(p.clone(), p.nrows(), "P").err();
            prop_assert!(refusal.is_none(), "{:?} {}", refusal, p);
        }
    }
    Ok(())
}

fn bench() -> impl Strategy<Value = BenchParams> {
    let sensor = prop::sample::select(vec![Sensor::Velocity, Sensor::Position]);
    let mode = prop::sample::select(vec![Mode::Fixed, Mode::Filter]);
    (sensor, mode, number(0.0..6.0), any::<u32>()).prop_map(|(sensor, mode, gain, seed)| BenchParams {
        sensor,
        mode,
        gain,
        seed,
    })
}

fn hook() -> impl Strategy<Value = HookParams> {
    (number(0.0..0.01), number(0.0..0.005), any::<bool>(), any::<u32>())
        .prop_map(|(bias, slip, fixes, seed)| HookParams { bias, slip, fixes, seed })
}

fn probe() -> impl Strategy<Value = ProbeParams> {
    // On the course itself too, where the robot drives over a landmark.
    let landmark =
        || prop_oneof![4 => [number(0.0..6.0), number(0.0..6.0)], 1 => Just([1.5, 1.5]), 1 => Just([3.0, 1.5])];
    let sensor = prop::sample::select(vec![SensorKind::Range, SensorKind::RangeBearing]);
    let stop = prop_oneof![Just(None), (0..300_u32).prop_map(Some)];
    let landmarks = [landmark(), landmark(), landmark()];
    (landmarks, 0..5_u32, sensor, stop, any::<bool>(), number(0.0..0.1), any::<u32>()).prop_map(
        |(landmarks, count, sensor, stop, forget, tolerance, seed)| ProbeParams {
            landmarks,
            count,
            sensor,
            stop,
            forget,
            tolerance,
            seed,
        },
    )
}

fn picture() -> impl Strategy<Value = PictureParams> {
    let axes = [number(0.1..3.0), number(0.1..3.0)];
    let rest = [number(-3.0..3.0), number(-3.0..3.0), number(0.0..2.0), number(-1.5..1.5)];
    ([number(-3.0..3.0), number(-3.0..3.0)], axes, rest).prop_map(
        |(mean, [semi_major, semi_minor], [angle, reading, noise, tilt])| PictureParams {
            mean,
            semi_major,
            semi_minor,
            angle,
            reading,
            noise,
            tilt,
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_bench(first in bench(), second in bench(), steps in 1..200_u32) {
        answers_or_refuses::<ObserverBench>(first, second, steps)?;
    }

    #[test]
    fn the_hook(first in hook(), second in hook(), steps in 1..200_u32) {
        answers_or_refuses::<OdometryHook>(first, second, steps)?;
    }

    #[test]
    fn the_probe(first in probe(), second in probe(), steps in 1..60_u32) {
        answers_or_refuses::<ObservabilityProbe>(first, second, steps)?;
    }

    #[test]
    fn the_picture(first in picture(), second in picture(), steps in 1..3_u32) {
        answers_or_refuses::<Picture>(first, second, steps)?;
    }
}
