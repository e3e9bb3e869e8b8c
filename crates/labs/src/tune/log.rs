//! The log that is tuned on: the rail robot with its position sensor under hidden noise levels.

use crate::shapes::root;
use core::f64::consts::LN_10;
use estimate::kf::Gaussian;
use estimate::likelihood::{Entry, NoiseFit, fit_noise};
use estimate::rail::position_sensor;
use estimate::{Error, Lti};
use nalgebra::{Matrix1, U1, U2, Vector1, Vector2};
use sim::Noise;
use sim::scenarios::TUNING;
use std::cell::OnceCell;

/// The system with V = q V₀ and W = w, given as decimal logarithms.
pub(super) fn system([log_q, log_w]: [f64; 2]) -> Lti<U2, U1, U1> {
    let (system, _) = position_sensor();
    Lti { v: system.v * power(log_q), w: Matrix1::new(power(log_w)), ..system }
}

fn power(log: f64) -> f64 {
    libm::exp(LN_10 * log)
}

/// A log, and what was behind it.
#[derive(Debug)]
pub(super) struct Log {
    pub seed: u32,
    /// The decimal logarithms of the true q and W.
    pub truth: [f64; 2],
    /// The belief before the first reading; the true first state is drawn from it.
    pub belief: Gaussian<U2>,
    pub entries: Vec<Entry<U1, U1>>,
    /// The true state at each reading.
    pub states: Vec<Vector2<f64>>,
    fit: OnceCell<NoiseFit>,
}

impl Log {
    pub fn new(seed: u32, length: u32) -> Result<Self, Error> {
        let mut noise = Noise::new(u64::from(seed));
        let mut hidden = || TUNING.hidden * (2.0 * noise.uniform() - 1.0);
        let truth = [hidden(), hidden()];
        let (Lti { f, h, v, w, .. }, (_, belief)) = (system(truth), position_sensor());
        let (kick, sigma) = (root(&v, "V")?, w[0].sqrt());
        let mut state = belief.x + noise.correlated(&root(&belief.p, "P")?);
        let (mut entries, mut states) = (Vec::new(), Vec::new());
        for _ in 0..length {
            state = f * state + noise.correlated(&kick);
            states.push(state);
            entries.push((Vector1::zeros(), h * state + Vector1::new(sigma * noise.normal())));
        }
        Ok(Self { seed, truth, belief, entries, states, fit: OnceCell::new() })
    }

    /// The likeliest factors of V₀ and of 1 m², looked for once.
    pub fn fit(&self) -> Result<NoiseFit, Error> {
        if let Some(known) = self.fit.get() {
            return Ok(*known);
        }
        let bounds = [[power(-TUNING.reach), power(TUNING.reach)]; 2];
        let found = fit_noise(&system([0.0, 0.0]), &self.belief, &self.entries, &bounds)?;
        Ok(*self.fit.get_or_init(|| found))
    }
}
