//! The Observer Bench: the rail robot of §8.2.6 under an observer whose gain the reader sets, or the filter does.

mod frame;

pub use frame::{BenchFrame, BenchSeries, Feet};

use crate::lab::{Digest, Lab};
use crate::shapes::{Root, pair, root};
use estimate::kf::{Gaussian, kalman_step};
use estimate::rail::{dead_reckoning, position_sensor};
use estimate::{Code, Error, Lti, Observer, validate};
use geom::AffineSet;
use nalgebra::{Matrix1, Matrix2, U1, U2, Vector1, Vector2};
use serde::Serialize;
use sim::Noise;

/// The largest knob: past divergence with either sensor.
pub const MAX_GAIN: f64 = 8.0;
/// Beyond this error (m or m/s) or root of variance a run has diverged, and stands still.
const DIVERGED: f64 = 1e6;
/// Iterations for R∞; the velocity sensor's P never converges, its gain has long before these run out.
const STEADY_ITERATIONS: usize = 500;

/// What the sensor measures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Sensor {
    /// H = [0 1].
    #[default]
    Velocity,
    /// H = [1 0].
    Position,
}

/// Who chooses the gain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Mode {
    /// The reader: K = g · R∞ at every step.
    #[default]
    Fixed,
    /// The filter: K = R(k).
    Filter,
}

/// What the reader can change.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BenchParams {
    /// What the sensor measures.
    pub sensor: Sensor,
    /// Who chooses the gain.
    pub mode: Mode,
    /// g, the knob: a multiple of R∞ between 0 and [`MAX_GAIN`].
    pub gain: f64,
    /// Fixes truth and readings.
    pub seed: u32,
}

impl Default for BenchParams {
    fn default() -> Self {
        Self { sensor: Sensor::Velocity, mode: Mode::Fixed, gain: 1.0, seed: 1 }
    }
}

/// The lab.
#[derive(Debug)]
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
    /// The filter's own belief, whoever chooses the gain: its covariance is the schedule.
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
    const NAME: &'static str = "observer-bench";
    type Params = BenchParams;
    type Frame = BenchFrame;

    fn new(params: BenchParams) -> Result<Self, Error> {
        let gain = validate::finite(params.gain, "gain")?;
        if !(0.0..=MAX_GAIN).contains(&gain) {
            return Err(Error::new(Code::Limit, "gain", "is out of reach; the knob turns from 0 to 8"));
        }
        let (system, belief) = match params.sensor {
            Sensor::Velocity => dead_reckoning(),
            Sensor::Position => position_sensor(),
        };
        let steady = system.steady_state_gain(&belief.p, STEADY_ITERATIONS, 1e-12)?.r;
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
            filter: belief,
            filter_gain: first,
            gain: match params.mode {
                Mode::Fixed => steady * gain,
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

    fn params(&self) -> &BenchParams {
        &self.params
    }

    fn steps(&self) -> u32 {
        self.step
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
        let roots: Vec<Root> = observer.error_eigs().unwrap_or_default().into_iter().map(Root::from).collect();
        let eigenvalues = [0, 1].map(|i| roots.get(i).copied().unwrap_or(Root { re: f64::NAN, im: f64::NAN }));
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
            truth: pair(&self.truth),
            reading: self.reading,
            predicted: (&self.predicted).into(),
            posterior: (&self.posterior).into(),
            innovation,
            s,
            r: pair(&self.gain),
            filter_gain: pair(&self.filter_gain),
            steady_gain: pair(&self.steady),
            h: [self.system.h[0], self.system.h[1]],
            most_likely_output: self.most_likely_output(spread),
            feet: omega.and_then(|o| {
                let euclidean = pair(&o.euclidean_foot(&self.predicted.x)?);
                let mahalanobis = pair(&o.mahalanobis_foot(&self.predicted.p, &self.predicted.x)?);
                Some(Feet { euclidean, mahalanobis })
            }),
            spectral_radius: modulus[0],
            stable: movable.clone().all(|(_, m)| *m < 1.0),
            eigenvalues,
            pinned,
            stable_up_to: knob_limit(&self.system, &self.steady),
            equivalent_knob: self.equivalent_knob(),
            series: self.series.clone(),
        }
    }

    fn digest(&self) -> u64 {
        self.digest.value()
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
        self.digest.take(self.truth.iter());
        self.digest.take(self.gain.iter());
        self.digest.take(self.reading.iter());
        for belief in [&self.predicted, &self.posterior] {
            self.digest.take(belief.x.iter());
            self.digest.take(belief.p.iter());
        }
    }
}

/// The setting of the knob that moves the predicted output as far as the gain `k` does: HK / HR∞. Both products are shares
/// of the innovation and have no units, so the ratio is the same in metres and in millimetres.
pub(crate) fn equivalent_knob(system: &Lti<U2, U1, U1>, k: &Vector2<f64>, steady: &Vector2<f64>) -> f64 {
    (system.h * k)[0] / (system.h * steady)[0]
}

/// The knob g at which an eigenvalue of (I − g R∞ H)F reaches −1: det(F + I − g R∞ H F) = 0 at
/// g = 1 / (HF (F + I)⁻¹ R∞). With these systems that is where the last movable eigenvalue leaves the unit disc.
pub(crate) fn knob_limit(system: &Lti<U2, U1, U1>, steady: &Vector2<f64>) -> f64 {
    let shifted = system.f + Matrix2::identity();
    shifted.lu().solve(steady).map_or(f64::INFINITY, |v| 1.0 / (system.h * system.f * v)[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(params: BenchParams, steps: u32) -> ObserverBench {
        let mut bench = ObserverBench::new(params).expect("sound parameters");
        bench.run(steps).expect("within the limit");
        bench
    }

    fn with(sensor: Sensor, mode: Mode, gain: f64) -> BenchParams {
        BenchParams { sensor, mode, gain, seed: 1 }
    }

    #[test]
    fn the_velocity_sensor_pins_an_eigenvalue_at_one() {
        for gain in [0.0, 0.5, 1.0, 3.0, 6.0] {
            let frame = at(with(Sensor::Velocity, Mode::Fixed, gain), 3).frame();
            let pinned = frame.pinned.expect("one is pinned");
            assert_eq!((frame.eigenvalues[pinned].re, frame.eigenvalues[pinned].im), (1.0, 0.0));
        }
        assert_eq!(at(with(Sensor::Position, Mode::Fixed, 1.0), 3).frame().pinned, None);
    }

    #[test]
    fn the_knob_s_limit_parts_stable_from_unstable() {
        for sensor in [Sensor::Velocity, Sensor::Position] {
            let limit = ObserverBench::new(with(sensor, Mode::Fixed, 1.0)).expect("sound").frame().stable_up_to;
            for (gain, stable) in [(0.999 * limit, true), (1.001 * limit, false), (0.01, true)] {
                let frame = at(with(sensor, Mode::Fixed, gain), 1).frame();
                assert_eq!(frame.stable, stable, "{sensor:?} at {gain}");
            }
        }
    }

    #[test]
    fn past_the_limit_a_run_diverges_says_so_and_stands_still() {
        let mut bench = at(with(Sensor::Position, Mode::Fixed, 6.0), 200);
        let frame = bench.frame();
        assert!(frame.diverged);
        bench.run(50).expect("within the limit");
        let later = bench.frame();
        assert_eq!((later.truth, later.posterior, later.series), (frame.truth, frame.posterior, frame.series));
        assert_eq!(later.step, 250);
    }

    #[test]
    fn the_filter_s_equivalent_knob_drifts_to_one() {
        for sensor in [Sensor::Velocity, Sensor::Position] {
            let bench = at(with(sensor, Mode::Filter, 1.0), 100);
            assert!((bench.frame().equivalent_knob - 1.0).abs() < 1e-9);
            let first = bench.frame().series.knob.iter().next().expect("recorded");
            assert!((first - 1.0).abs() > 0.2, "{first}");
        }
    }

    #[test]
    fn the_equivalent_knob_does_not_depend_on_the_unit_of_time() {
        for (system, belief) in [dead_reckoning(), position_sensor()] {
            // A velocity in m/s is 60 times as large in m/min: x' = D x with D = diag(1, 60).
            let d = Matrix2::from_diagonal(&Vector2::new(1.0, 60.0));
            let inverse = Matrix2::from_diagonal(&Vector2::new(1.0, 1.0 / 60.0));
            // The velocity sensor's reading is converted as well; the position sensor's stays in metres.
            let c = if system.h[1] == 0.0 { 1.0 } else { 60.0 };
            let minutes = Lti {
                f: d * system.f * inverse,
                g: d * system.g,
                h: system.h * inverse * c,
                v: d * system.v * d,
                w: system.w * (c * c),
            };
            let knob = |system: &Lti<U2, U1, U1>, p: &Matrix2<f64>| {
                let steady = system.steady_state_gain(p, STEADY_ITERATIONS, 1e-12).expect("sound").r;
                let first = system.gain_schedule(p, 1).expect("sound").remove(0);
                equivalent_knob(system, &first, &steady)
            };
            let [in_seconds, in_minutes] = [knob(&system, &belief.p), knob(&minutes, &(d * belief.p * d))];
            // The two limits each stop within 1e-12 of R∞; ⟨R, R∞⟩/⟨R∞, R∞⟩ differed by more than 0.1 here.
            assert!((in_seconds - in_minutes).abs() < 1e-9, "{in_seconds} {in_minutes}");
        }
    }

    #[test]
    fn one_knob_is_the_filter_s_limit() {
        let fixed = at(with(Sensor::Position, Mode::Fixed, 1.0), 200).frame();
        let filter = at(with(Sensor::Position, Mode::Filter, 1.0), 200).frame();
        assert_eq!(fixed.truth, filter.truth, "the seed fixes truth and readings");
        for i in 0..2 {
            assert!((fixed.posterior.x[i] - filter.posterior.x[i]).abs() < 1e-9);
            assert!((fixed.posterior.p[i][i] - filter.posterior.p[i][i]).abs() < 1e-9);
        }
    }

    #[test]
    fn the_filter_s_update_is_the_mahalanobis_foot_on_the_most_likely_output() {
        let bench = at(with(Sensor::Velocity, Mode::Filter, 1.0), 7);
        let frame = bench.frame();
        let omega = AffineSet { h: bench.system.h, y: Vector1::new(frame.most_likely_output.expect("a reading")) };
        let foot = omega.mahalanobis_foot(&bench.predicted.p, &bench.predicted.x).expect("positive");
        assert!((foot - bench.posterior.x).norm() < 1e-13);
    }

    #[test]
    fn a_change_replays_the_whole_run() {
        let mut turned = at(with(Sensor::Velocity, Mode::Fixed, 1.0), 30);
        turned.set(with(Sensor::Velocity, Mode::Fixed, 2.5)).expect("sound");
        assert_eq!(turned.frame(), at(with(Sensor::Velocity, Mode::Fixed, 2.5), 30).frame());
        let again = ObserverBench::from_state(turned.state()).expect("a state of its own");
        assert_eq!(again.digest(), turned.digest());
        assert_ne!(again.digest(), at(with(Sensor::Velocity, Mode::Fixed, 2.5), 31).digest());
    }

    #[test]
    fn what_is_out_of_bounds_is_refused_and_the_lab_kept() {
        let mut bench = at(BenchParams::default(), 5);
        let before = bench.frame();
        for gain in [-0.1, MAX_GAIN + 0.1] {
            let error = bench.set(BenchParams { gain, ..BenchParams::default() }).expect_err("out of bounds");
            assert_eq!((error.code, error.argument.as_ref()), (Code::Limit, "gain"));
        }
        let error = bench.set(BenchParams { gain: f64::NAN, ..BenchParams::default() }).expect_err("NaN");
        assert_eq!(error.code, Code::NotFinite);
        for n in [0, crate::MAX_STEP] {
            assert_eq!(bench.run(n).expect_err("too few or too many").code, Code::Limit);
        }
        let beyond = crate::State { params: BenchParams::default(), step: crate::MAX_STEP + 1 };
        assert_eq!(ObserverBench::from_state(beyond).expect_err("too far").argument, "step");
        assert_eq!(bench.frame(), before);
    }

    #[test]
    fn a_long_run_keeps_its_memory_and_stays_finite() {
        let frame = at(with(Sensor::Velocity, Mode::Filter, 1.0), 10_000).frame();
        assert_eq!(frame.series.p11.len(), crate::WINDOW);
        assert!(!frame.diverged && frame.posterior.p[0][0] > 2900.0);
    }
}
