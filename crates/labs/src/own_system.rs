//! A system of the reader's own: what can be known of it, where its eigenvalues go under a gain, and a simulated run.

mod analysis;
mod decay;
mod directions;
pub(crate) mod frame;
mod nearing;
mod params;
mod rates;

pub use frame::{OwnDecay, OwnEigenvalue, OwnFrame, OwnLimit, OwnRank, OwnReach, OwnSeries};
pub use params::{Entries, GainBy, MOST, OwnParams};

use analysis::{Analysis, tolerance};
use directions::readable;
use estimate::dynamic::Belief;
use estimate::kf::kalman_step;
use estimate::{Error, Observer, Reachability, Verdict, validate};
use filters::{Conditioning, linear};
use lab::{Digest, Lab, Params, kept, named};
use nalgebra::{DMatrix, DVector};
use sim::Noise;
use std::rc::Rc;

/// Beyond this a state, an estimate or a root of variance has left every bound, and the run stands still.
const DIVERGED: f64 = 1e9;
/// Steps after which the inputs change their sign.
const HALF_WAVE: u32 = 20;

/// The lab.
#[derive(Clone, Debug)]
pub struct OwnSystem {
    params: OwnParams,
    known: Rc<Analysis>,
    noise: Noise,
    step: u32,
    diverged: bool,
    truth: DVector<f64>,
    filter: Belief,
    conditioning: Conditioning,
    estimate: Belief,
    filter_gain: Option<DMatrix<f64>>,
    reading: Option<DVector<f64>>,
    series: OwnSeries,
    digest: Digest,
}

impl Lab for OwnSystem {
    named! {
        "own-system", OwnParams, OwnFrame, &[frame::INTERFACES],
        "A linear system that the reader types: what can be known of it, the eigenvalues that a gain gives \
         it, and a simulated run."
    }
    kept! {}

    fn start((): (), params: OwnParams) -> Result<Self, Error> {
        params.check()?;
        let known = Analysis::new(&params).map_err(in_the_reader_s_letters)?;
        let n = params.states as usize;
        let belief = validate::belief(DVector::zeros(n), known.p0.clone())?;
        let mut noise = Noise::new(u64::from(params.seed));
        let truth = draw(&mut noise, n).component_mul(&known.p0.diagonal().map(f64::sqrt));
        let mut lab = Self {
            params,
            known: Rc::new(known),
            noise,
            step: 0,
            diverged: false,
            truth,
            conditioning: Conditioning::of(&belief.p),
            filter: belief.clone(),
            estimate: belief,
            filter_gain: None,
            reading: None,
            series: OwnSeries::of(n, params.readings as usize),
            digest: Digest::default(),
        };
        lab.record();
        Ok(lab)
    }

    fn tried() -> Vec<Self::Params> {
        let open = OwnParams::default();
        vec![open, OwnParams { gain: GainBy::Placement, input: 1.0, ..open }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        if self.diverged {
            return Ok(());
        }
        let known = Rc::clone(&self.known);
        let system = &known.system;
        let sign = if ((self.step - 1) / HALF_WAVE).is_multiple_of(2) { 1.0 } else { -1.0 };
        let u = DVector::repeat(self.params.inputs as usize, sign * self.params.input);
        let [root_v, root_w] = &known.roots;
        let kicks = root_v * draw(&mut self.noise, root_v.ncols());
        let truth = &system.f * &self.truth + &system.g * &u + kicks;
        let y = &system.h * &truth + root_w * draw(&mut self.noise, root_w.ncols());
        // A step that has no answer is one out of every bound: what can be wrong with the system itself was refused at
        // the start.
        let Ok(filter) = kalman_step(system, &self.filter, &u, &y) else { return self.stop() };
        let estimate = match self.params.gain {
            GainBy::Filter => filter.posterior.clone(),
            GainBy::Hand | GainBy::Placement => {
                let Ok(predicted) = linear::predicted_covariance(&system.f, &self.estimate.p, &system.v) else {
                    return self.stop();
                };
                let mut observer =
                    Observer { sys: system.clone(), k: known.gain.clone(), xhat: self.estimate.x.clone() };
                observer.step(&u, &y);
                Belief { p: observer.covariance_update(&predicted), x: observer.xhat }
            }
        };
        let within = |m: f64| m <= DIVERGED;
        let sizes = [truth.amax(), estimate.x.amax(), filter.posterior.x.amax()];
        let variances = [estimate.p.amax(), filter.posterior.p.amax()];
        if !sizes.into_iter().all(within) || !variances.into_iter().all(|variance| within(variance.sqrt())) {
            return self.stop();
        }
        self.truth = truth;
        filter.follow(&mut self.conditioning, system, &self.filter);
        self.filter = filter.posterior;
        self.estimate = estimate;
        self.filter_gain = Some(filter.r);
        self.reading = Some(y);
        self.record();
        Ok(())
    }

    fn frame(&self) -> OwnFrame {
        let Analysis { rank, seen, noise, input, eigenvalues, .. } = &*self.known;
        let largest = rank.singular_values.first().copied().unwrap_or(0.0);
        OwnFrame {
            step: self.step,
            params: self.params,
            tolerance: tolerance(&self.params),
            rank: OwnRank {
                rank: rank.rank as u32,
                relative: rank.singular_values.iter().map(|s| if largest > 0.0 { s / largest } else { 0.0 }).collect(),
                singular_values: rank.singular_values.clone(),
                directions: readable(&rank.nullspace),
            },
            observable: seen.observable,
            detectable: seen.detectable,
            badly_scaled: seen.by_entry && seen.observable != Verdict::Yes,
            unseen_modes: seen.modes.clone(),
            noise: reach(noise),
            input: reach(input),
            limit: self.known.kind,
            settled: self.known.settled,
            tried: self.known.tried,
            limit_p: self.known.limit_p.as_ref().map(rows),
            doubled: self.known.doubled,
            near: self.known.near.map(|near| near.steps),
            slowly: self.known.near.is_some_and(|near| near.slowly),
            f: rows(&self.known.system.f),
            g: rows(&self.known.system.g),
            v: rows(&self.known.system.v),
            k: rows(&self.known.gain),
            looks_like_rates: self.known.looks_like_rates,
            decay: self.known.decay.clone(),
            run_length: self.known.run_length,
            spectral_radius: eigenvalues.first().map_or(0.0, |l| l.modulus),
            eigenvalues: eigenvalues.clone(),
            movable: self.known.movable.count() as u32,
            placed: self.known.placed,
            diverged: self.diverged,
            conditioned: self.conditioning.is_well_conditioned(),
            truth: self.truth.iter().copied().collect(),
            estimate: self.estimate.x.iter().copied().collect(),
            p: rows(&self.estimate.p),
            r: self.filter_gain.as_ref().map(rows),
            reading: self.reading.as_ref().map(|y| y.iter().copied().collect()),
            series: self.series.clone(),
        }
    }
}

impl OwnSystem {
    fn stop(&mut self) -> Result<(), Error> {
        self.diverged = true;
        Ok(())
    }

    fn record(&mut self) {
        let (n, p) = (self.params.states as usize, self.params.readings as usize);
        let kept = self.step.is_multiple_of(self.params.every);
        if kept {
            self.series.step.push(f64::from(self.step));
        }
        for i in (0..n).filter(|_| kept) {
            let variance = self.estimate.p[(i, i)];
            self.series.truth[i].push(self.truth[i]);
            self.series.estimate[i].push(self.estimate.x[i]);
            self.series.variance[i].push(variance);
            self.series.sigma[i].push(variance.max(0.0).sqrt());
            for j in 0..p {
                self.series.gain[i][j].push(self.filter_gain.as_ref().map_or(f64::NAN, |r| r[(i, j)]));
            }
        }
        self.digest.take(self.truth.as_slice());
        self.digest.take(self.estimate.x.as_slice());
        self.digest.take(self.estimate.p.as_slice());
        self.digest.take(self.filter.p.as_slice());
        if let Some(r) = &self.filter_gain {
            self.digest.take(r.as_slice());
        }
    }
}

fn reach(found: &Reachability) -> OwnReach {
    let Reachability { reachable, stabilizable, unreached, .. } = found;
    OwnReach { reachable: *reachable, stabilizable: *stabilizable, unreached: readable(unreached) }
}

fn rows(m: &DMatrix<f64>) -> Vec<Vec<f64>> {
    m.row_iter().map(|row| row.iter().copied().collect()).collect()
}

fn draw(noise: &mut Noise, n: usize) -> DVector<f64> {
    DVector::from_fn(n, |_, _| noise.normal())
}

/// The same error, naming the parameter that the matrix comes from.
fn in_the_reader_s_letters(mut error: Error) -> Error {
    error.argument = match error.argument.as_ref() {
        "P0" => "start".into(),
        "tolerance" => "logTolerance".into(),
        "B" => "g".into(),
        matrix => matrix.to_lowercase().into(),
    };
    error
}

#[cfg(test)]
mod design_tests;
#[cfg(test)]
mod tests;
