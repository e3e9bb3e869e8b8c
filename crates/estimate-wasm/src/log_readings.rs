//! Which readings a log has, and which standard deviations they bring, as a caller reads it.

use crate::encode::{list, record};
use estimate::drive::{BySensor, Drive, Sensor};
use wasm_bindgen::prelude::*;

/// How many readings each sensor of a log has.
pub(crate) fn readings(drive: &Drive) -> JsValue {
    let mut counts = BySensor::<u32>::default();
    for sensor in drive.rows.iter().filter_map(|row| Sensor::of(&row.event)) {
        *counts.of_mut(sensor) += 1;
    }
    let there = counts.each().into_iter().filter(|(_, count)| **count > 0);
    record(&there.map(|(name, count)| (name, (*count).into())).collect::<Vec<_>>())
}

/// The standard deviations that readings bring along.
pub(crate) fn own(drive: &Drive) -> JsValue {
    let of = |(name, sensor)| {
        let (count, sigmas) = drive.own_sigmas(sensor)?;
        Some((name, record(&[("count", count.into()), ("sigmas", list(&sigmas))])))
    };
    record(&[("fix", Sensor::Fix), ("heading", Sensor::Heading)].into_iter().filter_map(of).collect::<Vec<_>>())
}
