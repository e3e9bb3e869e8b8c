//! Tune me: a log of the rail robot whose noise levels are hidden, a filter whose noise levels the reader chooses, and
//! what the log itself says about them.

pub(crate) mod frame;
mod log;
mod params;

pub use frame::{TuneBand, TuneFit, TuneFrame, TuneVerdict};
pub use params::TuneParams;

use core::f64::consts::LN_10;
use estimate::kf::kalman_step;
use estimate::likelihood::{NoiseFit, log_density, log_likelihood};
use estimate::{Code, Error, validate};
use filters::consistency::{chi2_interval, chi2_quantile, nees, nis};
use geom::Ellipse;
use lab::{Digest, Lab, Params, kept, named};
use log::{Log, system};
use nalgebra::{Matrix2, Vector2};
use numerics::Spd;
use sim::scenarios::TUNING;
use std::rc::Rc;
use std::sync::LazyLock;

/// The lags at which innovations are correlated with themselves.
const LAGS: usize = 20;
/// The most rows or columns of a map of the likelihood.
pub const MAX_MAP_SIZE: usize = 200;

/// The bands of means of NIS: a quantile is an iteration, and these never change. From one number of readings to the
/// next a fifth is added.
static BANDS: LazyLock<Vec<TuneBand>> = LazyLock::new(|| {
    let next = |readings: &u32| Some(readings + 1 + readings / 5).filter(|n| *n <= 1000);
    core::iter::successors(Some(1), next).filter_map(|readings| band(readings).ok()).collect()
});
/// Where 95 % of χ² with 2 degrees of freedom lie, and the quantile that 95 % lie below.
static TWO_STATES: LazyLock<([f64; 2], f64)> = LazyLock::new(|| {
    let interval = chi2_interval(2, 1, 0.95).map_or([f64::NAN; 2], |(low, high)| [low, high]);
    (interval, chi2_quantile(2, 0.95).unwrap_or(f64::NAN))
});

fn band(readings: u32) -> Result<TuneBand, Error> {
    let (low, high) = chi2_interval(1, readings, 0.95)?;
    Ok(TuneBand { readings, low, high })
}

/// What the chosen filter makes of the log.
#[derive(Clone, Debug, Default)]
struct Filtered {
    innovations: Vec<f64>,
    /// √S.
    sigma: Vec<f64>,
    nis: Vec<f64>,
    nees: Vec<f64>,
    log_likelihood: f64,
}

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Clone, Debug)]
pub struct Tune {
    params: TuneParams,
    log: Rc<Log>,
    filtered: Filtered,
    fit: Option<NoiseFit>,
    last_band: TuneBand,
    digest: Digest,
    step: u32,
}

impl Lab for Tune {
    named! {
        "tune", TuneParams, TuneFrame, &[frame::INTERFACES],
        "A log of the rail robot whose noise levels are hidden, and a filter whose noise levels the reader \
         chooses. It has no steps."
    }
    kept! {}

    fn start((): (), params: TuneParams) -> Result<Self, Error> {
        params.check()?;
        Self::on(Rc::new(Log::new(params.seed, params.length)?), params)
    }

    fn tried() -> Vec<Self::Params> {
        vec![TuneParams { length: 1000, committed: true, ..TuneParams::default() }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        Ok(())
    }

    /// The log, and its fit with it, is kept where the parameters leave it as it is.
    fn set(&mut self, params: TuneParams) -> Result<(), Error> {
        params.check()?;
        let same = (params.seed, params.length as usize) == (self.log.seed, self.log.entries.len());
        let log = if same { Rc::clone(&self.log) } else { Rc::new(Log::new(params.seed, params.length)?) };
        *self = Self { step: self.step, ..Self::on(log, params)? };
        Ok(())
    }

    fn frame(&self) -> TuneFrame {
        let Filtered { innovations, sigma, nis, nees, log_likelihood } = &self.filtered;
        let readings = innovations.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / readings;
        let mut sum = 0.0;
        let running = |(k, nis): (usize, &f64)| {
            sum += nis;
            sum / (k + 1) as f64
        };
        let normalized: Vec<f64> = innovations.iter().zip(sigma).map(|(nu, sigma)| nu / sigma).collect();
        TuneFrame {
            params: self.params,
            innovations: innovations.clone(),
            two_sigma: sigma.iter().map(|sigma| 2.0 * sigma).collect(),
            beyond: normalized.iter().filter(|e| e.abs() > 2.0).count() as f64 / readings,
            autocorrelation: autocorrelation(&normalized),
            autocorrelation_band: 1.96 / readings.sqrt(),
            nis: nis.clone(),
            mean_nis: nis.iter().enumerate().map(running).collect(),
            mean_nis_band: {
                let shorter = BANDS.iter().filter(|band| band.readings < self.last_band.readings);
                shorter.chain([&self.last_band]).copied().collect()
            },
            log_likelihood: *log_likelihood,
            fit: self.fit.map(|fit| shown(&fit, *log_likelihood)),
            verdict: self.fit.filter(|_| self.params.committed).and_then(|fit| {
                let [log_q, log_w] = self.log.truth;
                let likelihood = self.likelihood(self.log.truth).ok()?;
                Some(TuneVerdict {
                    log_q,
                    log_w,
                    log_likelihood: likelihood,
                    lacking: 2.0 * (fit.log_likelihood - likelihood),
                    nees: nees.clone(),
                    mean_nees: mean(nees),
                    nees_band: TWO_STATES.0,
                })
            }),
        }
    }
}

impl Tune {
    /// The square of (fit − truth) in the metric of the information; none where nothing is fitted.
    pub fn distance(&self) -> Option<f64> {
        let fit = self.fit?;
        let off = Vector2::new(libm::log(fit.q), libm::log(fit.w)) - Vector2::from(self.log.truth) * LN_10;
        Some(off.dot(&(fit.information * off)))
    }

    fn on(log: Rc<Log>, params: TuneParams) -> Result<Self, Error> {
        let chosen = [params.log_q, params.log_w];
        let filtered = filtered(&log, chosen)?;
        let fit = if params.fit || params.committed { Some(log.fit()?) } else { None };
        let mut digest = Digest::default();
        for (entry, state) in log.entries.iter().zip(&log.states) {
            digest.take(entry.1.as_slice());
            digest.take(state.as_slice());
        }
        let Filtered { innovations, sigma, nis, nees, log_likelihood } = &filtered;
        [innovations, sigma, nis, nees].into_iter().for_each(|part| digest.take(part));
        digest.take(&[*log_likelihood]);
        if let Some(fit) = &fit {
            digest.take(&[fit.q, fit.w, fit.log_likelihood]);
            digest.take(fit.information.as_slice());
        }
        Ok(Self { params, last_band: band(params.length)?, log, filtered, fit, digest, step: 0 })
    }

    /// The log-likelihood with these decimal logarithms of q and W.
    fn likelihood(&self, logs: [f64; 2]) -> Result<f64, Error> {
        log_likelihood(&system(logs), &self.log.belief, &self.log.entries)
    }

    /// One row of a map of the log-likelihood over all that the filter's noise levels can be: `columns` values of log q
    /// at one of `rows` values of log W, each at the middle of its cell; row 0 has the least W. A map is filled row by
    /// row, so that whoever fills it can show how far it has come, and stop.
    ///
    /// # Errors
    /// [`Code::Limit`] naming `rows` or `columns` beyond 200, or `row`, which must be below `rows`; whatever the filter
    /// answers.
    pub fn likelihood_row(&self, row: usize, rows: usize, columns: usize) -> Result<Vec<f64>, Error> {
        let rows = validate::count(rows, MAX_MAP_SIZE, "rows")?;
        let columns = validate::count(columns, MAX_MAP_SIZE, "columns")?;
        if row >= rows {
            return Err(Error::new(Code::Limit, "row", format!("is {row}; it must be below {rows}")));
        }
        let middle = |i: usize, of: usize| TUNING.reach * (2.0 * (i as f64 + 0.5) / of as f64 - 1.0);
        (0..columns).map(|column| self.likelihood([middle(column, columns), middle(row, rows)])).collect()
    }
}

fn filtered(log: &Log, chosen: [f64; 2]) -> Result<Filtered, Error> {
    let (system, mut belief, mut to) = (system(chosen), log.belief, Filtered::default());
    for ((u, y), state) in log.entries.iter().zip(&log.states) {
        let step = kalman_step(&system, &belief, u, y)?;
        belief = step.posterior;
        to.innovations.push(step.innovation[0]);
        to.sigma.push(step.s[0].sqrt());
        to.nis.push(nis(&step.innovation, &step.s)?);
        to.nees.push(nees(&(state - belief.x), &belief.p)?);
        to.log_likelihood += log_density(&step.innovation, &step.s).unwrap_or(f64::NAN);
    }
    Ok(to)
}

/// Σ e(k) e(k+l) / Σ e(k)² at the lags 1 to [`LAGS`], or as many as there are.
fn autocorrelation(e: &[f64]) -> Vec<f64> {
    let product = |lag: usize| e.iter().zip(&e[lag..]).map(|(a, b)| a * b).sum::<f64>();
    let all = product(0);
    (1..=LAGS.min(e.len() - 1)).map(|lag| product(lag) / all).collect()
}

/// A fit in decimal logarithms, beside the log-likelihood at the chosen noise levels.
fn shown(fit: &NoiseFit, chosen: f64) -> TuneFit {
    let (_, limit) = *TWO_STATES;
    let inside = Spd::new(fit.information).filter(|_| fit.held == [false; 2]);
    let covariance = inside.map(|spd| spd.solve(&Matrix2::identity()) / (LN_10 * LN_10));
    TuneFit {
        log_q: libm::log10(fit.q),
        log_w: libm::log10(fit.w),
        log_likelihood: fit.log_likelihood,
        held: fit.held,
        sigma: covariance.map(|c| [c[(0, 0)].sqrt(), c[(1, 1)].sqrt()]),
        region: covariance.map(|c| Ellipse::from_covariance(&c, limit.sqrt())),
        lacking: 2.0 * (fit.log_likelihood - chosen),
        limit,
    }
}

#[cfg(test)]
mod tests;
