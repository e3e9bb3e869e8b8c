//! What is known of a system before it runs: ranks, verdicts, the limit of the covariance, and the eigenvalues under
//! the gain in use.

use super::decay::{ON_CIRCLE, decay_of, run_length};
use super::frame::{OwnDecay, OwnEigenvalue, OwnLimit};
use super::nearing::{Nearing, nearing};
use super::params::{Entries, GainBy, OwnParams};
use super::rates::looks_like_rates;
use estimate::dynamic::{self, Continuous, Discrete, Limit, System};
use estimate::observability::Observability;
use estimate::riccati::SteadyState;
use estimate::{Code, Complex, Detectability, Error, Movable, Reachability, RiccatiLimit, Verdict};
use nalgebra::{DMatrix, DVector, Dyn};
use numerics::hypot;

/// Steps after which P has settled if it does so within a reader's patience.
const SETTLE_STEPS: usize = 1000;
/// What single steps and the limit may differ by where they are the same.
const SAME: f64 = 1e-9;

/// As far as doubled steps go: 2⁵⁰.
const FURTHEST: f64 = 1_125_899_906_842_624.0;

/// A decay takes many times as long as its time constant. P that comes to rest in fewer time constants than this falls
/// as the variance of an average does.
const AVERAGING: f64 = 8.0;

/// What is known of a system before it runs.
#[derive(Debug)]
pub(super) struct Analysis {
    pub system: System,
    pub rank: Observability,
    pub seen: Detectability,
    pub kind: RiccatiLimit,
    pub noise: Reachability,
    pub input: Reachability,
    pub movable: Movable,
    /// The step at which P settled, and how many were tried.
    pub settled: Option<u32>,
    pub tried: Option<u32>,
    pub limit_p: Option<DMatrix<f64>>,
    pub doubled: OwnLimit,
    /// How soon P is near its limit.
    pub near: Option<Nearing>,
    pub p0: DMatrix<f64>,
    pub looks_like_rates: bool,
    pub decay: Vec<OwnDecay>,
    pub run_length: u32,
    /// The gain whose eigenvalues are shown.
    pub gain: DMatrix<f64>,
    pub placed: Option<bool>,
    pub eigenvalues: Vec<OwnEigenvalue>,
    /// Roots of V and W.
    pub roots: [DMatrix<f64>; 2],
}

impl Analysis {
    pub fn new(params: &OwnParams) -> Result<Self, Error> {
        let [n, p] = [params.states, params.readings].map(|count| count as usize);
        let system = system_of(params)?;
        let (f, h) = (&system.f, &system.h);
        let tolerance = tolerance(params);
        let movable = dynamic::movable(f.clone(), h.clone(), tolerance)?;
        let p0 = DMatrix::from_diagonal(&DVector::from_fn(n, |i, _| params.start * params.spread[i]));
        let limit = match dynamic::steady_state(&system, p0.clone()) {
            // P grows beyond every number.
            Err(error) if error.code == Code::NotFinite => nowhere(&p0, p),
            found => found?,
        };
        let seen = dynamic::detectability(f.clone(), h.clone(), tolerance)?;
        // Of readings without noise it is asked of what is left to know after them.
        let left = dynamic::after_exact_readings(&system);
        let zero = falls_to_zero(left.last().unwrap_or(&system), &seen).then(|| zero(&system, &left)).flatten();
        let falls = zero.is_some();
        let limit = zero.unwrap_or(limit);
        // Where P grows beyond every number, or so far that it hides all that is read, there is no last step.
        let stepped = dynamic::steady_state_gain(&system, p0.clone(), SETTLE_STEPS, 1e-12).ok();
        let arrived = stepped.as_ref().filter(|state| state.converged && state.gain_converged);
        let settled = arrived.filter(|state| !limit.converged || same_covariance(state, &limit));
        let limit_p = settled.map(|state| state.p.clone()).or_else(|| limit.converged.then(|| limit.p.clone()));
        let noise = dynamic::noise_reach(f.clone(), system.v.clone(), tolerance)?;
        let fed = fed(&noise, left.is_empty(), n);
        let near = limit_p.as_ref().and_then(|limit| nearing(&system, &p0, limit, &fed));
        // Numbers alone do not tell it: rounding of a limit that the start decides looks like the end of a slow fall,
        // and a slow fall far enough on like rest.
        let structure = dynamic::falls_as_average(&system, dynamic::STRUCTURE).unwrap_or(Verdict::Undecided);
        let unknown = p0.diagonal().iter().all(|variance| *variance > 0.0);
        let certain = structure == Verdict::Yes && unknown && left.is_empty() && settled.is_none();
        let slowly = |near: &Nearing| certain || falls && unknown || near.slowly && structure != Verdict::No;
        let near = near.map(|near| Nearing { slowly: slowly(&near), ..near });
        let mut placed = None;
        let filter = filter_gain(stepped.as_ref(), &limit);
        let unsettled = structure != Verdict::No && settled.is_none() && limit.converged;
        let averages = falls || unsettled && (certain || averages(&system, &filter, limit.steps));
        let gain = match params.gain {
            GainBy::Filter => Some(filter),
            GainBy::Hand => Some(part(&params.k, [n, p])),
            GainBy::Placement => {
                let found = movable.gain(&wanted(&params.poles[..], movable.count()));
                placed = Some(found.is_ok());
                found.ok()
            }
        };
        let gain = gain.unwrap_or_else(|| DMatrix::zeros(n, p));
        let found = dynamic::error_eigenvalues(&system, gain.clone())?;
        let eigenvalues = marked(&found, &movable.fixed()?);
        Ok(Self {
            rank: dynamic::observability(f.clone(), h.clone(), tolerance)?,
            seen,
            kind: dynamic::riccati_limit(&system, tolerance)?,
            noise,
            input: dynamic::stabilizability(f.clone(), system.g.clone(), tolerance)?,
            settled: settled.map(|state| state.iterations as u32),
            tried: stepped.as_ref().map(|state| state.iterations as u32),
            limit_p,
            near,
            doubled: OwnLimit {
                converged: limit.converged,
                gain_converged: limit.gain_converged,
                depends_on_start: limit.depends_on_start,
                steps: limit.steps,
                averages,
                part: certain && !limit.converged,
                grows: dynamic::grows(&system),
            },
            looks_like_rates: !params.continuous
                && own_modes(&system).is_ok_and(|modes| looks_like_rates(f, &modes, params.period)),
            decay: decay_of(&eigenvalues, params.period),
            run_length: run_length(&eigenvalues, n + p),
            eigenvalues,
            p0,
            gain,
            placed,
            roots: [dynamic::noise_input(system.v.clone())?, dynamic::noise_input(system.w.clone())?],
            movable,
            system,
        })
    }
}

fn part(entries: &Entries, [rows, columns]: [usize; 2]) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |i, j| entries[i][j])
}

/// The system over a step.
fn system_of(params: &OwnParams) -> Result<System, Error> {
    let [n, m, p] = [params.states, params.inputs, params.readings].map(|count| count as usize);
    let (f, g, v) = (part(&params.f, [n, n]), part(&params.g, [n, m]), part(&params.v, [n, n]));
    let Discrete { f, g, v } = if params.continuous {
        if params.period <= 0.0 {
            return Err(Error::new(Code::Limit, "period", "must be positive, for a system in continuous time"));
        }
        Continuous::new(f, g, v).and_then(|system| system.discretize(params.period)).map_err(|mut error| {
            error.argument = match error.argument.as_ref() {
                "A" => "F".into(),
                "B" => "G".into(),
                "Q" => "V".into(),
                _ => "period".into(),
            };
            error
        })?
    } else {
        Discrete { f, g, v }
    };
    System::new(f, g, part(&params.h, [p, n]), v, part(&params.w, [p, p]))
}

/// Which states noise moves: where each reading is `noisy`, no variance of theirs falls to 0.
fn fed(noise: &Reachability, noisy: bool, n: usize) -> Vec<bool> {
    let known = noisy && noise.reachable != Verdict::Undecided;
    (0..n).map(|i| known && noise.unreached.iter().all(|direction| direction[i] == 0.0)).collect()
}

/// Whether P falls to 0 from every start and never comes to rest: no noise moves the state, F has eigenvalues on the
/// unit circle and none beyond it, and all of them are seen. Then every reading counts, for ever. Doubling cannot tell
/// the limit of a state that falls faster than others, as a speed's 1/k³ beside a place's 1/k.
fn falls_to_zero(system: &System, seen: &Detectability) -> bool {
    let still = system.v.iter().all(|entry| *entry == 0.0) && seen.detectable == Verdict::Yes;
    let slowest = |found: &[Complex<f64>]| found.first().map(|it| hypot(it.re, it.im));
    let modulus = own_modes(system).ok().and_then(|found| slowest(&found));
    still && modulus.is_some_and(|modulus| (modulus - 1.0).abs() <= ON_CIRCLE)
}

/// The eigenvalues of F, the largest first.
fn own_modes(system: &System) -> Result<Vec<Complex<f64>>, Error> {
    dynamic::error_eigenvalues(system, DMatrix::zeros(system.h.ncols(), system.h.nrows()))
}

/// The limit where nothing is left to know: 0, or after a reading without noise what the noise of a step adds.
fn zero(system: &System, left: &[System]) -> Option<Limit> {
    let (p, r) = dynamic::before_exact_readings(system, left, system.f.map(|_| 0.0))?;
    let ends = Limit { r, p, converged: true, gain_converged: true, depends_on_start: false, steps: FURTHEST };
    Some(ends)
}

/// Where the first step has no answer.
fn nowhere(p0: &DMatrix<f64>, outputs: usize) -> Limit {
    Limit {
        r: DMatrix::zeros(p0.nrows(), outputs),
        p: p0.clone(),
        converged: false,
        gain_converged: false,
        depends_on_start: false,
        steps: 0.0,
    }
}

/// The limit of the filter's gain. Where single steps have come to it, it is their last gain, to the last bit: links
/// were made with it.
fn filter_gain(stepped: Option<&SteadyState<Dyn, Dyn>>, limit: &Limit) -> DMatrix<f64> {
    let near = |r: &DMatrix<f64>| {
        r.row_iter().zip(limit.r.row_iter()).all(|(one, other)| (one - other).amax() <= SAME * other.amax())
    };
    match stepped {
        Some(state) if !limit.gain_converged || near(&state.r) => state.r.clone(),
        _ => limit.r.clone(),
    }
}

/// Whether what comes to rest in so many steps does so as the variance of an average: too early for the slowest of the
/// errors under the filter's gain.
fn averages(system: &System, gain: &DMatrix<f64>, steps: f64) -> bool {
    let Ok(found) = dynamic::error_eigenvalues(system, gain.clone()) else { return false };
    found.first().is_some_and(|slowest| (1.0 - hypot(slowest.re, slowest.im)) * steps < AVERAGING)
}

/// Whether the last of single steps is the limit, each entry in units of its own.
fn same_covariance(state: &SteadyState<Dyn, Dyn>, limit: &Limit) -> bool {
    let p = &limit.p;
    let off = |i: usize, j: usize| (state.p[(i, j)] - p[(i, j)]).abs() <= SAME * (p[(i, i)] * p[(j, j)]).sqrt();
    (0..p.nrows()).all(|i| (0..p.ncols()).all(|j| off(i, j)))
}

pub(super) fn tolerance(params: &OwnParams) -> f64 {
    libm::pow(10.0, params.log_tolerance)
}

/// The first `count` eigenvalues that the reader wants, with their conjugates. For the last one there may be no room
/// for its conjugate: then it is real.
pub(super) fn wanted(poles: &[[f64; 2]], count: usize) -> Vec<Complex<f64>> {
    let mut all = Vec::with_capacity(count);
    while all.len() < count {
        let [re, im] = poles[all.len()];
        if im != 0.0 && all.len() + 1 < count {
            all.extend([Complex::new(re, im.abs()), Complex::new(re, -im.abs())]);
        } else {
            all.push(Complex::from(re));
        }
    }
    all
}

/// The eigenvalues, with those marked that lie nearest to the `fixed` ones.
fn marked(eigenvalues: &[Complex<f64>], fixed: &[Complex<f64>]) -> Vec<OwnEigenvalue> {
    let mut all: Vec<OwnEigenvalue> = eigenvalues
        .iter()
        .map(|l| OwnEigenvalue { re: l.re, im: l.im, modulus: hypot(l.re, l.im), fixed: false })
        .collect();
    for one in fixed {
        let off = |l: &OwnEigenvalue| if l.fixed { f64::INFINITY } else { hypot(l.re - one.re, l.im - one.im) };
        let mut nearest = 0;
        for i in 1..all.len() {
            if off(&all[i]) < off(&all[nearest]) {
                nearest = i;
            }
        }
        if let Some(found) = all.get_mut(nearest) {
            found.fixed = true;
        }
    }
    all
}
