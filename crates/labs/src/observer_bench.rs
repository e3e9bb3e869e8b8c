//! The Observer Bench: the rail robot of §8.2.6 under an observer whose gain the reader sets, or the filter does.

pub(crate) mod frame;
mod params;

pub use frame::{BenchFrame, BenchSeries, Feet};
pub use params::{BenchParams, Mode, Sensor};

use crate::shapes::root;
use estimate::kf::{Gaussian, kalman_step};
use estimate::rail::{dead_reckoning, position_sensor};
use estimate::{Complex, Error, Lti, Observer};
use geom::AffineSet;
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::{Matrix1, Matrix2, U1, U2, Vector1, Vector2};
use sim::Noise;
use std::sync::OnceLock;

/// Beyond this error (m or m/s) or root of variance a run has diverged, and stands still.
const DIVERGED: f64 = 1e6;
/// Iterations granted to R∞. The velocity sensor's P never converges; its gain converges long before the last of them.
const STEADY_ITERATIONS: usize = 500;
/// R∞ of each sensor's system, once for all runs: a reader who turns the knob asks for it at every move. A run whose
/// system is another computes its own.
static STEADY: [OnceLock<(Lti<U2, U1, U1>, Vector2<f64>)>; 2] = [const { OnceLock::new() }; 2];

/// The lab.
#[derive(Clone, Debug)]
pub struct ObserverBench {
    params: BenchParams,
    system: Lti<U2, U1, U1>,
    steady: Vector2<f64>,
    root_v: Matrix2<f64>,
    sigma_w: f64,
    noise: Noise,
    step: u32,
    diverged: bool,
    truth: Vector2<f64>,
    /// The belief that the run begins with.
    first: Gaussian<U2>,
    /// The belief of the Kalman filter, which runs along also when the reader chooses the gain.
    filter: Gaussian<U2>,
    filter_gain: Vector2<f64>,
    gain: Vector2<f64>,
    predicted: Gaussian<U2>,
    posterior: Gaussian<U2>,
    reading: Option<f64>,
    series: BenchSeries,
    digest: Digest,
}

impl Lab for ObserverBench {
    named! {
        "observer-bench", BenchParams, BenchFrame, &[frame::INTERFACES],
        "The rail robot of §8.2.6 under an observer whose gain the reader sets, or the filter does."
    }
    kept! {}

    fn start((): (), params: BenchParams) -> Result<Self, Error> {
        params.check()?;
        let (system, belief) = match params.sensor {
            Sensor::Velocity => dead_reckoning(),
            Sensor::Position => position_sensor(),
        };
        let steady = steady_gain(params.sensor, &system, &belief)?;
        let first = system.gain_schedule(&belief.p, 1)?.remove(0);
        let mut noise = Noise::new(u64::from(params.seed));
        let truth = belief.x + noise.correlated(&root(&belief.p, "P")?);
        let mut bench = Self {
            params,
            system,
            steady,
            root_v: root(&system.v, "V")?,
            sigma_w: system.w[0].sqrt(),
            noise,
            step: 0,
            diverged: false,
            truth,
            first: belief,
            filter: belief,
            filter_gain: first,
            gain: match params.mode {
                Mode::Fixed => steady * params.gain,
                Mode::Filter => first,
            },
            predicted: belief,
            posterior: belief,
            reading: None,
            series: BenchSeries::default(),
            digest: Digest::default(),
        };
        bench.record();
        Ok(bench)
    }

    fn tried() -> Vec<Self::Params> {
        let open = BenchParams::default();
        vec![open, BenchParams { sensor: Sensor::Position, mode: Mode::Filter, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        if self.diverged {
            return Ok(());
        }
        let none = Vector1::zeros();
        self.truth = self.system.f * self.truth + self.noise.correlated(&self.root_v);
        let y = self.system.h * self.truth + Vector1::new(self.sigma_w * self.noise.normal());
        self.reading = Some(y[0]);

        let step = kalman_step(&self.system, &self.filter, &none, &y)?;
        (self.filter, self.filter_gain) = (step.posterior, step.r);
        match self.params.mode {
            Mode::Filter => {
                self.gain = step.r;
                (self.predicted, self.posterior) = (step.predicted, step.posterior);
            }
            Mode::Fixed => {
                let mut observer = Observer { sys: self.system, k: self.gain, xhat: self.posterior.x };
                observer.step(&none, &y);
                self.predicted = self.posterior.predicted::<U1>(&self.system.f, &self.system.v, None)?;
                let p = observer.covariance_update(&self.predicted.p);
                self.posterior = Gaussian { x: observer.xhat, p };
            }
        }
        let error = self.truth - self.posterior.x;
        self.diverged = error.amax() > DIVERGED || self.posterior.p.trace() > DIVERGED * DIVERGED;
        self.record();
        Ok(())
    }

    fn frame(&self) -> BenchFrame {
        let observer = Observer { sys: self.system, k: self.gain, xhat: self.posterior.x };
        // Two real or conjugate roots: a 2×2 has them in closed form, so the iteration that could fail is not run.
        let nan = [Complex::new(f64::NAN, f64::NAN); 2];
        let eigenvalues = observer.error_eigs().ok().and_then(|roots| roots.try_into().ok()).unwrap_or(nan);
        let modulus = eigenvalues.map(|l| numerics::hypot(l.re, l.im));
        let pinned = (self.params.sensor == Sensor::Velocity)
            .then(|| eigenvalues.iter().position(|l| l.re == 1.0 && l.im == 0.0))
            .flatten();
        let movable = modulus.iter().enumerate().filter(|(i, _)| Some(*i) != pinned);
        let omega = self.reading.map(|y| AffineSet { h: self.system.h, y: Vector1::new(y) });
        let innovation = omega.as_ref().map(|o| o.residual(&self.predicted.x)[0]);
        let spread = (self.system.h * self.predicted.p * self.system.h.transpose())[0];
        let s = innovation.map(|_| spread + self.system.w[0]);
        BenchFrame {
            step: self.step,
            time: f64::from(self.step) * self.period(),
            params: self.params,
            diverged: self.diverged,
            truth: self.truth.into(),
            reading: self.reading,
            predicted: (&self.predicted).into(),
            posterior: (&self.posterior).into(),
            innovation,
            s,
            r: self.gain.into(),
            filter_gain: self.filter_gain.into(),
            steady_gain: self.steady.into(),
            h: self.system.h.transpose().into(),
            most_likely_output: self.most_likely_output(spread),
            feet: omega.and_then(|o| {
                let euclidean = o.euclidean_foot(&self.predicted.x)?.into();
                let mahalanobis = o.mahalanobis_foot(&self.predicted.p, &self.predicted.x)?.into();
                Some(Feet { euclidean, mahalanobis })
            }),
            spectral_radius: modulus[0],
            stable: movable.clone().all(|(_, m)| *m < 1.0),
            outside: [0, 1].map(|i| Some(i) != pinned && modulus[i] >= 1.0),
            modulus,
            eigenvalues,
            pinned,
            stable_up_to: knob_limit(&self.system, &self.steady),
            equivalent_knob: self.equivalent_knob(),
            series: self.series.clone(),
            first: (&self.first).into(),
        }
    }
}

impl ObserverBench {
    /// T, seconds: what F adds to the position for each m/s.
    fn period(&self) -> f64 {
        self.system.f[(0, 1)]
    }

    fn equivalent_knob(&self) -> f64 {
        match self.params.mode {
            Mode::Fixed => self.params.gain,
            Mode::Filter => equivalent_knob(&self.system, &self.gain, &self.steady),
        }
    }

    fn most_likely_output(&self, spread: f64) -> Option<f64> {
        let predicted = Gaussian { x: self.system.h * self.predicted.x, p: Matrix1::new(spread) };
        let read = Gaussian { x: Vector1::new(self.reading?), p: self.system.w };
        Some(predicted.product(&read).ok()?.x[0])
    }

    fn record(&mut self) {
        let error = self.truth - self.posterior.x;
        let knob = self.equivalent_knob();
        let series = &mut self.series;
        series.step.push(f64::from(self.step));
        series.r1.push(self.gain[0]);
        series.r2.push(self.gain[1]);
        series.p11.push(self.posterior.p[(0, 0)]);
        series.p22.push(self.posterior.p[(1, 1)]);
        series.e1.push(error[0]);
        series.e2.push(error[1]);
        series.knob.push(knob);
        self.digest.take(self.truth.as_slice());
        self.digest.take(self.gain.as_slice());
        self.digest.take(self.reading.as_slice());
        for belief in [&self.predicted, &self.posterior] {
            self.digest.take(belief.x.as_slice());
            self.digest.take(belief.p.as_slice());
        }
    }
}

/// R∞ of a sensor's system.
pub(crate) fn steady_gain(
    sensor: Sensor,
    system: &Lti<U2, U1, U1>,
    belief: &Gaussian<U2>,
) -> Result<Vector2<f64>, Error> {
    match STEADY[sensor as usize].get() {
        Some((of, known)) if of == system => Ok(*known),
        _ => {
            let found = system.steady_state_gain(&belief.p, STEADY_ITERATIONS, 1e-12)?.r;
            STEADY[sensor as usize].get_or_init(|| (*system, found));
            Ok(found)
        }
    }
}

/// The setting of the knob that moves the predicted output as far as the gain `k` does: HK / HR∞. Both products are
/// shares of the innovation and have no units, so the ratio is the same in metres and in millimetres.
pub fn equivalent_knob(system: &Lti<U2, U1, U1>, k: &Vector2<f64>, steady: &Vector2<f64>) -> f64 {
    (system.h * k)[0] / (system.h * steady)[0]
}

/// The knob g at which an eigenvalue of (I − g R∞ H)F reaches −1: det(F + I − g R∞ H F) = 0 at
/// g = 1 / (HF (F + I)⁻¹ R∞). With these systems that is where the last movable eigenvalue leaves the unit disc.
pub fn knob_limit(system: &Lti<U2, U1, U1>, steady: &Vector2<f64>) -> f64 {
    let shifted = system.f + Matrix2::identity();
    shifted.lu().solve(steady).map_or(f64::INFINITY, |v| 1.0 / (system.h * system.f * v)[0])
}

#[cfg(test)]
mod tests;
