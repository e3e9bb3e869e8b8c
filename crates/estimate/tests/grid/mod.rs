//! Ordinary systems in great number: small whole and decimal numbers, rotations, companion and Jordan matrices,
//! permutations, repeated rows. Every answer is held to the equation that defines it, every refusal to exact
//! arithmetic.
//!
//! A system is F = G/d with a whole G, so its characteristic polynomial and the rank of its observability matrix are
//! known exactly.

mod exact;
mod families;

use estimate::dynamic::{System, observability, place_observer_gain, steady_state_gain};
use estimate::{Code, Complex};
use exact::Whole;
pub use families::FAMILIES;
use nalgebra::{DMatrix, DVector};

/// The largest residual of the Riccati equation, in the same unit: the recursion ends at a change of 10⁻¹², which is
/// 4504 ε, and a correction may leave 5·10⁻¹⁴ of rounding, 225 ε, which an unstable F amplifies.
const MOST_RICCATI: f64 = 50_000.0;

/// What was counted and the largest residuals, each as a multiple of its unit: rounding times the size of the terms.
#[derive(Debug, Default)]
pub struct Count {
    /// Systems examined.
    pub systems: usize,
    /// Systems whose observability matrix has full rank in exact arithmetic.
    pub observable: usize,
    /// Those of them in which the numeric rank is smaller: a singular value below 10⁻⁹ of the largest.
    pub nearly_unobservable: usize,
    /// Gains placed.
    pub placed: usize,
    /// Placements refused because F is singular.
    pub singular_f: usize,
    /// Placements refused because F or the pair is within 10⁻⁹ of singular, or the poles were missed.
    pub nearly_unplaceable: usize,
    /// Riccati recursions that converged.
    pub converged: usize,
    /// Riccati recursions of observable systems that reached their limit to its rounding, which exceeds the tolerance.
    pub converged_to_rounding: usize,
    /// Riccati recursions of unobservable systems that have no limit.
    pub unbounded: usize,
    /// The largest residual of a characteristic polynomial.
    pub eigenvalues: f64,
    /// The largest residual of QᵀQv = σ²v and of VᵀV = I.
    pub singular_values: f64,
    /// The largest residual of the polynomial of placed poles.
    pub poles: f64,
    /// The largest residual of the Riccati equation.
    pub riccati: f64,
    /// What is wrong, the first few in words.
    pub faults: Vec<String>,
    /// How many were wrong in all.
    pub wrong: usize,
}

impl Count {
    fn fault(&mut self, what: String) {
        self.wrong += 1;
        if self.faults.len() < 40 {
            self.faults.push(what);
        }
    }
}

/// Examines the systems `from`, `from + stride`, … of every family.
pub fn examine(systems: usize, stride: usize) -> Count {
    let mut count = Count::default();
    for family in FAMILIES {
        for index in (0..systems / FAMILIES.len()).step_by(stride) {
            let (g, h) = family(index as u64);
            count.systems += 1;
            one(&g, &h, index, &mut count);
        }
    }
    count
}

fn one(g: &Whole, h: &Whole, index: usize, count: &mut Count) {
    let (f, output) = (g.matrix(), h.matrix());
    let n = f.nrows();
    let exact_rank = exact::observability_rank(g, h);
    let shown = || shown(&f, &output);

    let exact = g.characteristic_polynomial();
    match numerics::eigenvalues(&f) {
        Ok(found) => {
            let residual = polynomial_residual(&polynomial(&found), &exact, f.norm());
            count.eigenvalues = count.eigenvalues.max(residual);
            if residual > 20.0 {
                count.fault(format!("eigenvalues {found:?} miss by {residual}: {}", shown()));
            }
        }
        Err(e) => count.fault(format!("eigenvalues: {e}: {}", shown())),
    }

    let rank = match observability(f.clone(), output.clone(), 1e-9) {
        Ok(seen) => {
            if seen.rank > exact_rank {
                count.fault(format!("rank {} where it is {exact_rank}: {}", seen.rank, shown()));
            }
            seen.rank
        }
        Err(e) => {
            count.fault(format!("observability: {e}: {}", shown()));
            exact_rank
        }
    };
    count.observable += usize::from(exact_rank == n);
    count.nearly_unobservable += usize::from(exact_rank == n && rank < n);
    let stack = estimate::observability::observability_matrix(&f, &output);
    if let Ok(residual) = numerics::singular_values(stack.clone()).map(|s| singular_residual(&stack, &s)) {
        count.singular_values = count.singular_values.max(residual);
        if residual > 20.0 {
            count.fault(format!("singular values miss by {residual}: {}", shown()));
        }
    }

    if output.nrows() == 1 {
        placement(&f, &output, (exact_rank, rank), exact[n] == 0.0, count);
    }
    // The recursion takes as long as all else together: every fourth system.
    if index.is_multiple_of(4) {
        riccati(&f, &output, rank == n, count);
    }
}

fn placement(
    f: &DMatrix<f64>,
    h: &DMatrix<f64>,
    (exact_rank, rank): (usize, usize),
    singular: bool,
    count: &mut Count,
) {
    let n = f.nrows();
    let poles: Vec<Complex<f64>> = [0.5, 0.2, -0.3, 0.4, 0.6, -0.1][..n].iter().map(|p| Complex::from(*p)).collect();
    match place_observer_gain(f.clone(), h.clone(), &poles) {
        Ok(k) => {
            count.placed += 1;
            let closed = (DMatrix::identity(n, n) - &k * h) * f;
            // The gain is known to rounding only, and with it the closed loop: its terms are F and KHF.
            let size = f.norm() + (&k * (h * f)).norm();
            let wanted = polynomial(&poles);
            let found = numerics::eigenvalues(&closed).map(|l| polynomial(&l)).unwrap_or_default();
            let residual = polynomial_residual(&found, &wanted, size);
            count.poles = count.poles.max(residual);
            if found.is_empty() || !residual.is_finite() || residual * f64::EPSILON > 1e-6 {
                count.fault(format!("poles missed by {residual}: {}", shown(f, h)));
            }
        }
        Err(e) if e.code == Code::Unobservable && rank < n => {}
        Err(e) if e.code == Code::NotPlaceable && singular => count.singular_f += 1,
        Err(e) if e.code == Code::NotPlaceable => {
            count.nearly_unplaceable += 1;
            let reached = estimate::observability::observability_matrix(f, &(h * f));
            let values = numerics::singular_values(reached).map(|s| s.values).unwrap_or_default();
            if values.last().zip(values.first()).is_none_or(|(least, most)| least / most > 1e-7) {
                count.fault(format!("not placeable (rank {exact_rank}): {e}: {} {values:?}", shown(f, h)));
            }
        }
        Err(e) => count.fault(format!("placement: {e}: {}", shown(f, h))),
    }
}

fn riccati(f: &DMatrix<f64>, h: &DMatrix<f64>, observable: bool, count: &mut Count) {
    let (p, n) = h.shape();
    let (v, w) = (DMatrix::identity(n, n) * 0.1, DMatrix::identity(p, p) * 0.5);
    let system = System::new(f.clone(), DMatrix::zeros(n, 1), h.clone(), v.clone(), w.clone()).expect("sound");
    let run = |iterations| steady_state_gain(&system, DMatrix::identity(n, n), iterations, 1e-12);
    let residual = |p: &DMatrix<f64>, r: &DMatrix<f64>| {
        let inverse = (h * p * h.transpose() + &w).try_inverse().unwrap_or_default();
        let next = f * (p - p * h.transpose() * inverse * h * p) * f.transpose() + &v;
        // Joseph's form adds up terms of this size, whatever is left of them.
        let terms = (f.norm() * (1.0 + r.norm() * h.norm())).powi(2) * p.norm() + v.norm();
        (next - p).norm() / (f64::EPSILON * terms)
    };
    let mut limit = run(1000);
    if observable && limit.as_ref().is_ok_and(|l| residual(&l.p, &l.r) > MOST_RICCATI) {
        limit = run(100_000);
    }
    let limit = match limit {
        Ok(limit) if limit.converged || observable => limit,
        Err(e) if observable => return count.fault(format!("Riccati: {e}: {}", shown(f, h))),
        _ => return count.unbounded += 1,
    };
    let residual = residual(&limit.p, &limit.r);
    if limit.converged {
        count.converged += 1;
    } else {
        count.converged_to_rounding += 1;
    }
    count.riccati = count.riccati.max(residual);
    if !residual.is_finite() || residual > MOST_RICCATI {
        count.fault(format!("Riccati misses by {residual} after {}: {}", limit.iterations, shown(f, h)));
    }
}

/// The system on one line.
fn shown(f: &DMatrix<f64>, h: &DMatrix<f64>) -> String {
    let rows = |m: &DMatrix<f64>| {
        m.row_iter().map(|r| format!("{:?}", r.iter().collect::<Vec<_>>())).collect::<Vec<_>>().join("; ")
    };
    format!("F = {} and H = {}", rows(f), rows(h))
}

/// The coefficients of ∏(λ − rᵢ), the leading one first.
fn polynomial(roots: &[Complex<f64>]) -> Vec<f64> {
    let mut c = vec![Complex::from(1.0)];
    for root in roots {
        c.push(Complex::from(0.0));
        for i in (1..c.len()).rev() {
            let before = c[i - 1];
            c[i] -= root * before;
        }
    }
    c.iter().map(|c| c.re).collect()
}

/// How far the coefficients are from those of a matrix F, as a multiple of what a change of F by ε‖F‖ makes of them:
/// coefficient k is a sum of the C(n, k) principal minors of size k.
fn polynomial_residual(found: &[f64], exact: &[f64], size: f64) -> f64 {
    let n = exact.len() - 1;
    let mut binomial = 1.0;
    (1..=n.min(found.len().saturating_sub(1))).fold(0.0, |worst: f64, k| {
        binomial *= (n - k + 1) as f64 / k as f64;
        let unit = f64::EPSILON * k as f64 * binomial * size.powi(k as i32);
        let off = (found[k] - exact[k]).abs();
        if off == 0.0 { worst } else { worst.max(off / unit) }
    })
}

fn singular_residual(q: &DMatrix<f64>, found: &numerics::Singular) -> f64 {
    let n = q.ncols();
    let (v, size) = (&found.directions, q.norm_squared());
    let squares = DMatrix::from_diagonal(&DVector::from_iterator(n, found.values.iter().map(|s| s * s)));
    let equation = (q.transpose() * (q * v) - v * squares).norm() / size.max(f64::MIN_POSITIVE);
    let orthonormal = (v.transpose() * v - DMatrix::identity(n, n)).norm();
    equation.max(orthonormal) / (f64::EPSILON * n as f64)
}
