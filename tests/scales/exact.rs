//! The Kalman filter in numbers of 200 digits, by its plainest formulas: what a filter in doubles is measured by.

use dashu_float::FBig;
use estimate::dynamic;
use nalgebra::{DMatrix, DVector};

/// 700 bits are 210 digits: of those the worst of the systems here costs some forty.
const BITS: usize = 700;

/// A matrix, row by row.
#[derive(Clone)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    entries: Vec<FBig>,
}

fn number(x: f64) -> FBig {
    FBig::try_from(x).expect("a finite number").with_precision(BITS).value()
}

impl From<&DMatrix<f64>> for Matrix {
    fn from(m: &DMatrix<f64>) -> Self {
        Self::of(m.nrows(), m.ncols(), |i, j| number(m[(i, j)]))
    }
}

impl From<&DVector<f64>> for Matrix {
    fn from(v: &DVector<f64>) -> Self {
        Self::of(v.len(), 1, |i, _| number(v[i]))
    }
}

impl Matrix {
    fn of(rows: usize, columns: usize, entry: impl Fn(usize, usize) -> FBig) -> Self {
        let entries = (0..rows * columns).map(|at| entry(at / columns, at % columns)).collect();
        Self { rows, columns, entries }
    }

    fn at(&self, i: usize, j: usize) -> &FBig {
        &self.entries[i * self.columns + j]
    }

    fn transpose(&self) -> Self {
        Self::of(self.columns, self.rows, |i, j| self.at(j, i).clone())
    }

    fn times(&self, other: &Self) -> Self {
        Self::of(self.rows, other.columns, |i, j| {
            (0..self.columns).fold(number(0.0), |sum, k| sum + self.at(i, k) * other.at(k, j))
        })
    }

    fn plus(&self, other: &Self) -> Self {
        Self::of(self.rows, self.columns, |i, j| self.at(i, j) + other.at(i, j))
    }

    fn minus(&self, other: &Self) -> Self {
        Self::of(self.rows, self.columns, |i, j| self.at(i, j) - other.at(i, j))
    }

    /// This matrix's inverse times `other`, and its determinant, by elimination; nothing where a pivot is 0.
    fn solved(&self, other: &Self) -> Option<(Self, FBig)> {
        let (mut left, mut right, mut determinant) = (self.clone(), other.clone(), number(1.0));
        for j in 0..self.rows {
            let pivot = left.at(j, j).clone();
            if pivot == number(0.0) {
                return None;
            }
            determinant *= &pivot;
            for i in (0..self.rows).filter(|&i| i != j) {
                let factor = left.at(i, j) / &pivot;
                for matrix in [&mut left, &mut right] {
                    for k in 0..matrix.columns {
                        let less = &factor * matrix.at(j, k);
                        matrix.entries[i * matrix.columns + k] -= less;
                    }
                }
            }
        }
        let solution = Self::of(other.rows, other.columns, |i, j| right.at(i, j) / left.at(i, i));
        Some((solution, determinant))
    }

    /// Its entry of the largest size.
    pub fn largest(&self) -> f64 {
        self.entries.iter().map(|e| e.to_f64().value().abs()).fold(0.0, f64::max)
    }

    /// The largest difference of an entry.
    fn distance(&self, found: &Self) -> f64 {
        self.minus(found).largest()
    }

    /// How far `found` is from it, as a part of its largest entry.
    pub fn error_of(&self, found: &Self) -> f64 {
        let off = self.distance(found);
        if off == 0.0 { 0.0 } else { off / self.largest() }
    }
}

/// A linear system F, H, V, W without inputs.
pub struct System {
    pub f: Matrix,
    pub h: Matrix,
    pub v: Matrix,
    pub w: Matrix,
}

impl From<&dynamic::System> for System {
    fn from(system: &dynamic::System) -> Self {
        let [f, h, v, w] = [&system.f, &system.h, &system.v, &system.w].map(Matrix::from);
        Self { f, h, v, w }
    }
}

/// A belief, and what the last step computed beside it.
pub struct Filter {
    pub x: Matrix,
    pub p: Matrix,
    pub s: Option<Matrix>,
    pub log_likelihood: f64,
}

impl Filter {
    pub fn new(belief: &dynamic::Belief) -> Self {
        Self { x: (&belief.x).into(), p: (&belief.p).into(), s: None, log_likelihood: 0.0 }
    }

    /// How far a filter in doubles is off: x as a part of its largest entry or of the largest standard deviation, P of
    /// its largest entry, the log-likelihood, where there is one, of itself, or of 1 where it is smaller.
    #[allow(dead_code, reason = "not every program that measures looks at all of them")]
    pub fn errors_of(&self, found: &dynamic::Belief, log_likelihood: Option<f64>) -> [f64; 3] {
        let scale = self.x.largest().max(self.p.largest().sqrt());
        let off = self.x.distance(&(&found.x).into());
        let x = if off == 0.0 { 0.0 } else { off / scale };
        let size = self.log_likelihood.abs().max(1.0);
        let likelihood = log_likelihood.map_or(0.0, |found| (found - self.log_likelihood).abs() / size);
        [x, self.p.error_of(&(&found.p).into()), likelihood]
    }

    /// A step with the reading `y`; nothing where S is singular.
    pub fn step(&mut self, system: &System, y: &Matrix) -> Option<()> {
        let System { f, h, v, w } = system;
        let x = f.times(&self.x);
        let p = f.times(&self.p).times(&f.transpose()).plus(v);
        let hp = h.times(&p);
        let s = hp.times(&h.transpose()).plus(w);
        let innovation = y.minus(&h.times(&x));
        let (solved, determinant) = s.solved(&hp)?;
        let gain = solved.transpose();
        let (weighed, _) = s.solved(&innovation)?;
        let squared = innovation.transpose().times(&weighed).at(0, 0).to_f64().value();
        let outputs = y.rows as f64;
        self.log_likelihood -=
            0.5 * (outputs * std::f64::consts::TAU.ln() + determinant.ln().to_f64().value() + squared);
        self.x = x.plus(&gain.times(&innovation));
        self.p = p.minus(&gain.times(&hp));
        self.s = Some(s);
        Some(())
    }
}
