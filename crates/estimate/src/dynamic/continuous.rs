//! A system in continuous time, and the discrete one that it is over any span of time (Van Loan 1978).

use crate::error::{Code, Error};
use crate::validate::{self, MAX_INPUTS, MAX_STATES, size};
use alloc::format;
use alloc::vec::Vec;
use filters::covariance::is_finite;
use filters::linear::predicted_covariance;
use nalgebra::DMatrix;

/// The terms of a series that are added. A chain of 16 integrators has 31 that are not zero; of any other system 17
/// suffice for the last digit, over a span in which 2‖A‖h is at most a half.
const TERMS: usize = 2 * MAX_STATES;

/// ẋ = A x + B u + noise, with n states and m inputs. The noise is white and of the density Q: over a short time h it
/// adds Q h to the covariance.
#[derive(Clone, Debug, PartialEq)]
pub struct Continuous {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    q: DMatrix<f64>,
}

/// x(t + dt) = F x(t) + G u + v, Cov v = V: what a system in continuous time is over one span of time, for an input
/// that is held.
#[derive(Clone, Debug, PartialEq)]
pub struct Discrete {
    /// F = e^{A dt}, n×n. Thrun A.
    pub f: DMatrix<f64>,
    /// G = ∫ e^{As} B ds from 0 to dt, n×m. Thrun B.
    pub g: DMatrix<f64>,
    /// V = ∫ e^{As} Q e^{Aᵀs} ds from 0 to dt, n×n, exactly symmetric; 0 where its largest entry is no normal number.
    /// Thrun R.
    pub v: DMatrix<f64>,
}

impl Continuous {
    /// A checked system: A n×n per second, B n×m, Q n×n, with n ≤ 16 and m ≤ 8; all finite, Q a covariance per second.
    ///
    /// # Errors
    /// Naming the matrix: [`Code::Limit`], [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`] or
    /// [`Code::NotPositiveSemidefinite`].
    pub fn new(a: DMatrix<f64>, b: DMatrix<f64>, q: DMatrix<f64>) -> Result<Self, Error> {
        let (n, m) = (a.nrows(), b.ncols());
        size(n, MAX_STATES, "A")?;
        if m > MAX_INPUTS {
            return Err(Error::new(Code::Limit, "B", format!("has {m} inputs; at most {MAX_INPUTS}")));
        }
        let a = validate::matrix(a, (n, n), "A")?;
        Ok(Self { a, b: validate::matrix(b, (n, m), "B")?, q: validate::covariance(q, n, "Q")? })
    }

    /// How many states and inputs there are.
    pub fn sizes(&self) -> (usize, usize) {
        self.b.shape()
    }

    /// The system over `dt` seconds, zero or more: over no time at all I, 0 and 0.
    ///
    /// A short span h is computed by Taylor's series, which for a chain of integrators ends by itself; a long one is
    /// doubled from it, F(2h) = F F, G(2h) = G + F G and V(2h) = V + F V Fᵀ. Van Loan's way, one exponential of the
    /// block matrix [−A, Q; 0, Aᵀ], would need e^{−A dt}, which overflows where a state dies out fast.
    ///
    /// Not [`Lti::discretize`](crate::Lti::discretize), which is Euler's step of the chapter.
    ///
    /// # Errors
    /// Naming dt: [`Code::Limit`] when it is negative; [`Code::NotFinite`] when it is not finite, or an answer is too
    /// large for a number.
    ///
    /// # Example
    /// ```
    /// use estimate::dynamic::Continuous;
    /// use nalgebra::dmatrix;
    /// // Position and speed; the acceleration is the input, and is disturbed.
    /// let (a, b, q) = (dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![0.0; 1.0], dmatrix![0.0, 0.0; 0.0, 3.0]);
    /// let half = Continuous::new(a, b, q)?.discretize(0.5)?;
    /// assert_eq!(half.f, dmatrix![1.0, 0.5; 0.0, 1.0]);
    /// assert_eq!(half.g, dmatrix![0.125; 0.5]);
    /// assert_eq!(half.v, dmatrix![0.125, 0.375; 0.375, 1.5]);
    /// # Ok::<(), estimate::Error>(())
    /// ```
    pub fn discretize(&self, dt: f64) -> Result<Discrete, Error> {
        if validate::finite(dt, "dt")? < 0.0 {
            return Err(Error::new(Code::Limit, "dt", "is negative; a span of time is zero or more"));
        }
        let (n, m) = self.sizes();
        if dt == 0.0 {
            let nothing = DMatrix::zeros(n, n);
            return Ok(Discrete { f: DMatrix::identity(n, n), g: DMatrix::zeros(n, m), v: nothing });
        }
        let doublings = self.doublings(dt);
        let mut span = Span::short(self, libm::ldexp(dt, -doublings));
        for _ in 0..doublings {
            span = span.doubled()?;
        }
        let mut discrete = span.finite()?.discrete;
        // Below the normal numbers the entries are rounded so coarsely that they need not be a covariance.
        if discrete.v.amax() < f64::MIN_POSITIVE {
            discrete.v.fill(0.0);
        }
        Ok(discrete)
    }

    /// How often `dt` is halved until the series may be summed: until ‖A‖h is at most a quarter, or not at all where
    /// the series ends by itself.
    fn doublings(&self, dt: f64) -> i32 {
        let n = self.a.nrows();
        let entries = self.a.map(|entry| f64::from(u8::from(entry != 0.0)));
        let powers = (1..n).fold(entries.clone(), |power, _| product(&power, &entries).map(|ways| ways.min(1.0)));
        if powers.amax() == 0.0 {
            return 0;
        }
        // By exponents, since the product may be too large for a number.
        let exponent = |size: f64| libm::frexp(size).1;
        (exponent(self.a.amax()) + exponent(n as f64) + exponent(dt) + 2).max(0)
    }
}

/// A system over a span of time, with more digits of F's diagonal than F holds.
struct Span {
    discrete: Discrete,
    /// The diagonal of F − I. Of a state that changes slowly beside the others F holds few digits of the change, and
    /// each doubling would double their error.
    change: Vec<f64>,
}

impl Span {
    /// By Taylor's series: F − I = Σ Mᵏ/k!, G = h Σ MᵏB/(k+1)! and V = h Σ Lᵏ(Q)/(k+1)!, with M = A h and
    /// L(X) = M X + X Mᵀ.
    fn short(system: &Continuous, h: f64) -> Self {
        let m = scaled(&system.a, h);
        let times = |term: &DMatrix<f64>| product(&m, term);
        let both_sides = |term: &DMatrix<f64>| {
            let half = product(&m, term);
            &half + half.transpose()
        };
        let mut f = series(m.clone(), &times);
        let (g, v) = (series(scaled(&system.b, h), &times), series(scaled(&system.q, h), &both_sides));
        let change = f.diagonal().as_slice().to_vec();
        (0..m.nrows()).for_each(|i| f[(i, i)] += 1.0);
        Self { discrete: Discrete { f, g, v }, change }
    }

    /// The same over twice the time.
    ///
    /// # Errors
    /// As [`Continuous::discretize`].
    fn doubled(self) -> Result<Self, Error> {
        let Discrete { f, g, v } = &self.discrete;
        let n = f.nrows();
        let (g, v) = (g + product(f, g), predicted_covariance(f, v, v).map_err(|_| too_large())?);
        let (mut doubled, mut change) = (f.clone(), self.change);
        for j in 0..n {
            for i in 0..n {
                let others = (0..n).filter(|k| *k != i && *k != j).map(|k| f[(i, k)] * f[(k, j)]).sum::<f64>();
                if i != j {
                    doubled[(i, j)] = f[(i, j)] * (f[(i, i)] + f[(j, j)]) + others;
                    continue;
                }
                change[i] = change[i] * (2.0 + change[i]) + others;
                if change[i].abs() <= 0.5 {
                    doubled[(i, i)] = 1.0 + change[i];
                } else {
                    doubled[(i, i)] = f[(i, i)] * f[(i, i)] + others;
                    change[i] = doubled[(i, i)] - 1.0;
                }
            }
        }
        Self { discrete: Discrete { f: doubled, g, v }, change }.finite()
    }

    fn finite(self) -> Result<Self, Error> {
        let Discrete { f, g, v } = &self.discrete;
        if is_finite(f) && is_finite(g) && is_finite(v) { Ok(self) } else { Err(too_large()) }
    }
}

/// Σ Xₖ/(k+1)! from X₀ on, where `next` makes Xₖ₊₁ of Xₖ and takes a factor along.
fn series(first: DMatrix<f64>, next: &dyn Fn(&DMatrix<f64>) -> DMatrix<f64>) -> DMatrix<f64> {
    let (mut sum, mut term) = (first.clone(), first);
    for k in 1..TERMS {
        term = next(&term) / (k + 1) as f64;
        sum += &term;
    }
    sum
}

// Each of these is compiled once.

#[inline(never)]
fn product(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    a * b
}

#[inline(never)]
fn scaled(m: &DMatrix<f64>, h: f64) -> DMatrix<f64> {
    m * h
}

#[cold]
fn too_large() -> Error {
    Error::new(
        Code::NotFinite,
        "dt",
        "is too long for this system: e^{A dt}, or an integral of it, is no finite number",
    )
}
