//! Seeded noise with the same bits on every platform: ChaCha8 and Box–Muller through `libm`.
//!
//! `rand_distr`'s normal takes its logarithm from whichever mathematics its features were unified to, so its digits
//! would depend on what else is in the build; hence our own dozen lines.

use core::f64::consts::TAU;
use nalgebra::{SMatrix, SVector};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A stream of independent standard normal numbers, fixed by its seed.
///
/// # Example
/// ```
/// let (mut a, mut b) = (sim::Noise::new(7), sim::Noise::new(7));
/// assert_eq!(a.normal().to_bits(), b.normal().to_bits());
/// ```
#[derive(Clone, Debug)]
pub struct Noise {
    rng: ChaCha8Rng,
    spare: Option<f64>,
}

impl Noise {
    /// The stream of `seed`.
    pub fn new(seed: u64) -> Self {
        Self { rng: ChaCha8Rng::seed_from_u64(seed), spare: None }
    }

    /// A number uniform in [0, 1), a multiple of 2⁻⁵³.
    pub fn uniform(&mut self) -> f64 {
        const UNIT: f64 = 1.0 / (1_u64 << 53) as f64;
        (self.rng.next_u64() >> 11) as f64 * UNIT
    }

    /// A standard normal number.
    pub fn normal(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        // 1 − u lies in (0, 1], where the logarithm is finite.
        let radius = (-2.0 * libm::log(1.0 - self.uniform())).sqrt();
        let (sin, cos) = libm::sincos(TAU * self.uniform());
        self.spare = Some(radius * sin);
        radius * cos
    }

    /// A draw from N(0, LLᵀ), given a lower triangular `root` L.
    pub fn correlated<const N: usize>(&mut self, root: &SMatrix<f64, N, N>) -> SVector<f64, N> {
        root * SVector::from_fn(|_, _| self.normal())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix2;

    #[test]
    fn the_moments_are_those_of_a_standard_normal() {
        let mut noise = Noise::new(1);
        let n = 100_000;
        let draws: Vec<f64> = (0..n).map(|_| noise.normal()).collect();
        let moment = |k: i32| draws.iter().map(|d| d.powi(k)).sum::<f64>() / f64::from(n);
        // Five standard errors of each sample moment: √(1/n), √(2/n), √(96/n).
        assert!(moment(1).abs() < 0.016 && (moment(2) - 1.0).abs() < 0.023 && (moment(4) - 3.0).abs() < 0.16);
    }

    #[test]
    fn neighbours_are_uncorrelated() {
        let mut noise = Noise::new(2);
        let draws: Vec<f64> = (0..100_000).map(|_| noise.normal()).collect();
        let lag = draws.windows(2).map(|w| w[0] * w[1]).sum::<f64>() / draws.len() as f64;
        assert!(lag.abs() < 0.016);
    }

    #[test]
    fn seeds_differ_and_the_first_draws_are_pinned() {
        assert_ne!(Noise::new(1).normal(), Noise::new(2).normal());
        let mut noise = Noise::new(0);
        let uniforms = [noise.uniform(), noise.uniform()];
        // Recorded: a new version of the generator with another stream would show here, and move every seeded run.
        assert_eq!(uniforms, [0.709_075_415_426_561_8, 0.465_921_722_289_610_15]);
    }

    #[test]
    fn correlated_draws_have_the_covariance_asked_for() {
        let root = Matrix2::new(2.0, 0.0, 1.0, 0.5);
        let mut noise = Noise::new(3);
        let n = 50_000;
        let sum: Matrix2<f64> = (0..n)
            .map(|_| {
                let d = noise.correlated(&root);
                d * d.transpose()
            })
            .sum();
        assert!((sum / f64::from(n) - root * root.transpose()).amax() < 0.1);
    }
}
