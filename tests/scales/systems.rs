//! Random systems whose numbers lie many powers of ten apart, and their readings.

use estimate::dynamic::{Belief, System};
use nalgebra::{DMatrix, DVector};
use sim::Noise;

/// How far apart the numbers of a system lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scales {
    /// Nothing is known at the start: variances of 10⁸ to 10¹⁴ beside readings with 10⁻¹⁰ to 10⁻⁴.
    HugePrior,
    /// Nothing moves the state but itself, and readings have variances of 10⁻²⁰ to 10⁻⁴.
    NoMotionNoise,
    /// All variances lie between 10⁻⁴ and 10⁴.
    Ordinary,
}

/// A system, a belief and readings, drawn by a number.
pub struct Trial {
    pub system: System,
    pub belief: Belief,
    pub readings: Vec<DVector<f64>>,
}

impl Trial {
    pub fn new(scales: Scales, number: u64) -> Self {
        let mut draw = Draw(Noise::new(number));
        let n = 1 + draw.below(4);
        let p = 1 + draw.below(n.min(2));
        let f = if draw.below(3) == 0 { DMatrix::identity(n, n) } else { draw.matrix(n, n) };
        let mut h = draw.matrix(p, n);
        for i in (0..p).filter(|&i| h.row(i).amax() == 0.0).collect::<Vec<_>>() {
            h[(i, 0)] = 1.0;
        }
        let root = draw.matrix(n, n);
        let noise = &root * root.transpose();
        let (prior, v, w) = match scales {
            Scales::HugePrior => (draw.decade(8.0, 14.0), noise * draw.decade(-10.0, 0.0), draw.decade(-10.0, -4.0)),
            Scales::NoMotionNoise => (draw.decade(-2.0, 2.0), noise * 0.0, draw.decade(-20.0, -4.0)),
            Scales::Ordinary => (draw.decade(-4.0, 4.0), noise * draw.decade(-4.0, 3.0), draw.decade(-4.0, 4.0)),
        };
        let v = (&v + v.transpose()) * 0.5;
        let system = System { f, g: DMatrix::zeros(n, 0), h, v, w: DMatrix::identity(p, p) * w };
        let belief = Belief { x: DVector::zeros(n), p: DMatrix::identity(n, n) * prior };
        let readings = (0..6).map(|_| DVector::from_fn(p, |_, _| 3.0 * draw.0.normal())).collect();
        Self { system, belief, readings }
    }
}

struct Draw(Noise);

impl Draw {
    /// A number in [0, 1), of a normal one.
    fn uniform(&mut self) -> f64 {
        let phase = self.0.normal() * 1024.0;
        phase - phase.floor()
    }

    fn below(&mut self, n: usize) -> usize {
        (self.uniform() * n as f64) as usize
    }

    /// A number between 10^low and 10^high.
    fn decade(&mut self, low: f64, high: f64) -> f64 {
        libm::pow(10.0, low + (high - low) * self.uniform())
    }

    /// Normal entries, small whole ones, or half of them 0.
    fn matrix(&mut self, rows: usize, columns: usize) -> DMatrix<f64> {
        let kind = self.below(3);
        DMatrix::from_fn(rows, columns, |_, _| match kind {
            0 => self.0.normal(),
            1 => self.below(3) as f64 - 1.0,
            _ if self.below(2) == 0 => 0.0,
            _ => self.0.normal(),
        })
    }
}
