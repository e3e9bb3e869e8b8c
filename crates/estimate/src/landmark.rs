//! A landmark of the map.

use serde::Serialize;

/// A mapped point that a sensor can recognize; metres, in the frame of its map.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Landmark {
    /// Its name in the map.
    pub id: u32,
    /// East of the map's origin.
    pub x: f64,
    /// North of the map's origin.
    pub y: f64,
}
