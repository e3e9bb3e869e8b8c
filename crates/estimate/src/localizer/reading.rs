//! What a localizer reads, and what it says of a reading.

use nalgebra::{DMatrix, DVector};

/// Which sensor a localizer has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SensorKind {
    /// Range and bearing; W is 2×2.
    #[default]
    RangeBearing,
    /// Range alone; W is 1×1.
    Range,
}

/// One reading of a caller without types.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LandmarkReading {
    /// Metres, not negative.
    pub range: f64,
    /// Radians, from the landmark; any finite angle, taken on the circle. A range sensor has none.
    pub bearing: Option<f64>,
    /// The landmark's id; without one, the reading is associated.
    pub landmark: Option<u32>,
}

/// One step of a log: how the robot moved, and what it then read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Logged {
    /// [Δs, Δθ], metres and radians.
    pub u: [f64; 2],
    /// The reading after the motion.
    pub reading: LandmarkReading,
}

/// What became of a reading.
#[derive(Clone, Debug, PartialEq)]
pub struct Localized {
    /// Whether it was within the gate and corrected the belief.
    pub accepted: bool,
    /// The landmark it was of, or was nearest to.
    pub landmark: u32,
    /// ν.
    pub innovation: DVector<f64>,
    /// S.
    pub s: DMatrix<f64>,
    /// χ² = νᵀS⁻¹ν.
    pub chi2: f64,
}
