//! What is known of a system before it runs: ranks, verdicts, the limit of the covariance, and the eigenvalues under
//! the gain in use.

use super::frame::OwnEigenvalue;
use super::params::{GainBy, OwnParams};
use estimate::dynamic::{self, System};
use estimate::observability::Observability;
use estimate::{Code, Complex, Detectability, Error, Movable, Reachability};
use nalgebra::DMatrix;
use numerics::hypot;

/// Steps after which P has settled if it does so within a reader's patience.
const SETTLE_STEPS: usize = 1000;
/// What is known of a system before it runs.
#[derive(Debug)]
pub(super) struct Analysis {
    pub system: System,
    pub rank: Observability,
    pub seen: Detectability,
    pub noise: Reachability,
    pub input: Reachability,
    pub movable: Movable,
    /// The step at which P settled, and how many were tried.
    pub settled: Option<u32>,
    pub tried: Option<u32>,
    pub limit_p: Option<DMatrix<f64>>,
    /// The gain whose eigenvalues are shown.
    pub gain: DMatrix<f64>,
    pub placed: Option<bool>,
    pub eigenvalues: Vec<OwnEigenvalue>,
    /// Roots of V and W.
    pub roots: [DMatrix<f64>; 2],
}

impl Analysis {
    pub fn new(params: &OwnParams) -> Result<Self, Error> {
        let [n, m, p] = [params.states, params.inputs, params.readings].map(|count| count as usize);
        let part = |entries: &[[f64; 4]; 4], rows: usize, columns: usize| {
            DMatrix::from_fn(rows, columns, |i, j| entries[i][j])
        };
        let system = System::new(
            part(&params.f, n, n),
            part(&params.g, n, m),
            part(&params.h, p, n),
            part(&params.v, n, n),
            part(&params.w, p, p),
        )?;
        let (f, h) = (&system.f, &system.h);
        let tolerance = tolerance(params);
        let movable = dynamic::movable(f.clone(), h.clone(), tolerance)?;
        let p0 = DMatrix::identity(n, n) * params.start;
        let limit = match system.steady_state_gain(&p0, SETTLE_STEPS, 1e-12) {
            Ok(state) => Some(state),
            // P grows beyond every number.
            Err(error) if error.code == Code::NotFinite => None,
            Err(error) => return Err(error),
        };
        let settled = limit.as_ref().filter(|state| state.converged && state.gain_converged);
        let mut placed = None;
        let gain = match params.gain {
            GainBy::Filter => limit.as_ref().map(|state| state.r.clone()),
            GainBy::Hand => Some(part(&params.k, n, p)),
            GainBy::Placement => {
                let found = movable.gain(&wanted(&params.poles, movable.count()));
                placed = Some(found.is_ok());
                found.ok()
            }
        };
        let gain = gain.unwrap_or_else(|| DMatrix::zeros(n, p));
        let found = dynamic::error_eigenvalues(&system, gain.clone())?;
        Ok(Self {
            rank: dynamic::observability(f.clone(), h.clone(), tolerance)?,
            seen: dynamic::detectability(f.clone(), h.clone(), tolerance)?,
            noise: dynamic::noise_reach(f.clone(), system.v.clone(), tolerance)?,
            input: dynamic::stabilizability(f.clone(), system.g.clone(), tolerance)?,
            settled: settled.map(|state| state.iterations as u32),
            tried: limit.as_ref().map(|state| state.iterations as u32),
            limit_p: settled.map(|state| state.p.clone()),
            eigenvalues: marked(&found, &movable.fixed()?),
            gain,
            placed,
            roots: [dynamic::noise_input(system.v.clone())?, dynamic::noise_input(system.w.clone())?],
            movable,
            system,
        })
    }
}

pub(super) fn tolerance(params: &OwnParams) -> f64 {
    libm::pow(10.0, params.log_tolerance)
}

/// The first `count` eigenvalues that the reader wants, with their conjugates. For the last one there may be no room
/// for its conjugate: then it is real.
pub(super) fn wanted(poles: &[[f64; 2]; 4], count: usize) -> Vec<Complex<f64>> {
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
