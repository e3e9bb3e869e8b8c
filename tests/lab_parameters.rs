//! Whatever parameters a lab is given, it runs or refuses: no panic, no change by a refused call, and every covariance
//! of every frame is one.

#![cfg(not(target_arch = "wasm32"))]

#[path = "src/draws.rs"]
mod draws;

use estimate::validate;
use lab::{Lab, Params, Shape};
use labs::*;
use nalgebra::DMatrix;
use proptest::prelude::*;
use serde_json::Value;
use std::any::Any;
use world::Sample;

#[path = "../crates/labs/examples/world/mod.rs"]
mod world;

/// A number as callers send them: mostly within `sound`, sometimes at the edge of the representable, sometimes none.
fn number(sound: impl Strategy<Value = f64> + 'static) -> impl Strategy<Value = f64> {
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
fn answers_or_refuses<L: Lab<World: Sample, Params: PartialEq + std::fmt::Debug>>(
    first: L::Params,
    second: L::Params,
    steps: u32,
) -> Result<(), TestCaseError> {
    let world = Sample::sample(L::NAME).expect("the log of the page");
    let Ok(mut lab) = L::start(world, first) else { return Ok(()) };
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
        let frame = serde_json::to_value(lab::Shown(&lab.frame())).map_err(|e| TestCaseError::fail(e.to_string()))?;
        covariances(&frame, &mut found);
        for p in found {
            let refusal = validate::covariance(p.clone(), p.nrows(), "P").err();
            prop_assert!(refusal.is_none(), "{:?} {}", refusal, p);
        }
    }
    Ok(())
}

/// The numbers of one value as callers send them: mostly within the limits that its parameter declares.
fn values(shape: &'static Shape, limits: [f64; 2]) -> BoxedStrategy<Vec<f64>> {
    let [least, greatest] = limits;
    let one = |number| vec![number];
    match shape {
        Shape::Number => {
            let sound = if (greatest - least).is_finite() { least..greatest } else { -10.0..10.0 };
            // A third near zero, as far as the limits let it be: W and tolerances are small there.
            let near = 0_f64.clamp(least, greatest);
            let small = sound.clone().prop_map(move |x| near + 0.1 * (x - near));
            number(prop_oneof![2 => sound, 1 => small]).prop_map(one).boxed()
        }
        Shape::Whole => {
            let outside = [(least - 1.0).max(0.0), (greatest + 1.0).min(f64::from(u32::MAX))];
            prop_oneof![
                8 => (least as u32..=greatest.min(least + 300.0) as u32).prop_map(f64::from),
                4 => (least as u32..=greatest as u32).prop_map(f64::from),
                1 => prop::sample::select(outside.to_vec()),
            ]
            .prop_map(one)
            .boxed()
        }
        Shape::Flag => any::<bool>().prop_map(move |flag| one(f64::from(flag))).boxed(),
        Shape::Word(words) => (0..words.len()).prop_map(move |index| one(index as f64)).boxed(),
        Shape::Maybe(value) => {
            let present = values(value, limits).prop_map(|row| [vec![1.0], row].concat());
            prop_oneof![Just(one(0.0)), present].boxed()
        }
        Shape::Exactly(n, entry) => {
            prop::collection::vec(values(entry, limits), *n).prop_map(|rows| rows.concat()).boxed()
        }
        Shape::Each(names, value) => {
            let apart = prop::collection::vec(values(value, limits), names.len()).prop_map(|rows| rows.concat());
            let n = names.len();
            prop_oneof![apart, values(value, limits).prop_map(move |row| row.repeat(n))].boxed()
        }
        Shape::Between(least, most, entry) => prop::collection::vec(values(entry, limits), *least..=*most)
            .prop_map(|rows| [vec![rows.len() as f64], rows.concat()].concat())
            .boxed(),
        Shape::Text => {
            let parts = "x = F x\n|P = 9 P\n|P = F P F' + V\n|x = x + |nu|K = |(|)|'| H|\\|^-1|[1, 2]|1e9 ".split('|');
            prop::collection::vec(prop::sample::select(parts.collect::<Vec<_>>()), 0..12)
                .prop_map(|parts| {
                    let mut row = Vec::new();
                    lab::Plain::write(parts.concat().as_str(), &mut row);
                    row
                })
                .boxed()
        }
        Shape::List(_) | Shape::Record(..) | Shape::Sparse(..) => {
            unreachable!("no parameter holds a {shape:?}")
        }
    }
}

/// Parameters of a lab, drawn from their declaration: a new parameter is drawn here without another line.
fn of<P: Params + std::fmt::Debug + 'static>() -> impl Strategy<Value = P> {
    let each: Vec<_> = P::PARAMETERS.iter().map(|known| values(&known.shape, [known.least, known.greatest])).collect();
    let place = || prop_oneof![4 => Just(None), 2 => prop::sample::select(vec![Some([1.5, 1.5]), Some([3.0, 1.5])])];
    (each, [place(), place(), place()], any::<bool>()).prop_map(|(rows, places, sound)| {
        let mut params = P::read(&mut rows.concat().iter());
        let any = &mut params as &mut dyn Any;
        // Landmarks on the course itself too, where the robot drives over them.
        if let Some(ProbeParams { landmarks, .. }) = any.downcast_mut() {
            landmarks.iter_mut().zip(places).for_each(|(landmark, place)| *landmark = place.unwrap_or(*landmark));
        }
        // For half of a reader's own systems V and W are made covariances, of which few are drawn.
        if let Some(OwnParams { v, w, .. }) = any.downcast_mut().filter(|_| sound) {
            (*v, *w) = (square(*v), square(*w));
        }
        params
    })
}

/// M Mᵀ.
fn square(m: labs::own_system::Entries) -> labs::own_system::Entries {
    let mut of = m;
    let places = (0..m.len()).flat_map(|i| (0..m.len()).map(move |j| (i, j)));
    places.for_each(|(i, j)| of[i][j] = (0..m.len()).map(|k| m[i][k] * m[j][k]).sum());
    of
}

macro_rules! each {
    ($($module:ident::$lab:ident $(of $world:ident)? in $build:literal $(, was $was:literal)?;)*) => {$(
        #[allow(non_snake_case)]
        mod $lab {
            use super::*;

            proptest! {
                #![proptest_config(draws::cases(100))]

                #[test]
                fn answers_or_refuses(first in of(), second in of(), steps in 1..200_u32) {
                    super::answers_or_refuses::<labs::$lab>(first, second, steps)?;
                }
            }
        }
    )*};
}

labs::figures!(each);
