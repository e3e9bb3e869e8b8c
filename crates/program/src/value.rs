//! Values with their derivatives in one direction: forward mode by dual matrices, A + ε dA with ε² = 0.

use crate::matrix::Matrix;

/// A value. Without a derivative it does not depend on what is varied.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// The value itself.
    pub m: Matrix,
    /// Its derivative, of the same size.
    pub(crate) d: Option<Matrix>,
    /// Whether it stands for so many times the identity, of whatever size fits: `I` is the number 1 so marked.
    pub(crate) identity: bool,
}

impl From<Matrix> for Value {
    fn from(m: Matrix) -> Self {
        Self { m, d: None, identity: false }
    }
}

/// The sum of two derivatives.
fn both(a: Option<Matrix>, b: Option<Matrix>) -> Option<Matrix> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.plus(1.0, &b)),
        (a, b) => a.or(b),
    }
}

impl Value {
    #[inline(never)]
    pub(crate) fn number(x: f64) -> Self {
        Matrix::number(x).into()
    }

    pub(crate) fn slope(&self) -> Matrix {
        self.d.clone().unwrap_or_else(|| Matrix::zeros(self.m.rows, self.m.columns))
    }

    fn dual(m: Matrix, d: Option<Matrix>) -> Self {
        Self { m, d, identity: false }
    }

    /// What a linear map makes of it.
    pub(crate) fn linear(&self, f: &dyn Fn(&Matrix) -> Matrix) -> Self {
        Self { m: f(&self.m), d: self.d.as_ref().map(f), identity: self.identity }
    }

    /// As a matrix of n rows where it is a multiple of the identity.
    fn spread(&self, n: usize) -> Self {
        if !self.identity {
            return self.clone();
        }
        let mut spread = self.linear(&|m| Matrix::identity(n).scaled(m.at(0, 0)));
        spread.identity = false;
        spread
    }

    pub(crate) fn plus(&self, by: f64, other: &Self) -> Self {
        if self.identity != other.identity {
            let n = if self.identity { other.m.rows } else { self.m.rows };
            return self.spread(n).plus(by, &other.spread(n));
        }
        let d = both(self.d.clone(), other.d.as_ref().map(|d| d.scaled(by)));
        Self { m: self.m.plus(by, &other.m), d, identity: self.identity }
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let left = self.d.as_ref().map(|d| d.times(&other.m));
        let d = both(left, other.d.as_ref().map(|d| self.m.times(d)));
        // A number times the identity is one still; a matrix times it is the matrix.
        let identity = (self.identity && other.m.is_number()) || (other.identity && self.m.is_number());
        Self { m: self.m.times(&other.m), d, identity }
    }

    /// self⁻¹ b: of AX = B the derivative is A dX = dB − dA X.
    pub(crate) fn solved(&self, b: &Self) -> Option<Self> {
        if self.m.is_number() {
            let by = 1.0 / self.m.at(0, 0);
            let d = self.d.as_ref().map(|d| d.scaled(-by * by));
            return by.is_finite().then(|| Self { m: Matrix::number(by), d, identity: self.identity }.times(b));
        }
        let b = b.spread(self.m.rows);
        let m = self.m.solved(&b.m)?;
        let d = both(b.d, self.d.as_ref().map(|d| d.times(&m).scaled(-1.0)));
        let d = match d {
            Some(d) => Some(self.m.solved(&d)?),
            None => None,
        };
        Some(Self::dual(m, d))
    }

    pub(crate) fn inverse(&self) -> Option<Self> {
        self.solved(&Self { identity: !self.m.is_number(), ..Self::number(1.0) })
    }

    #[inline(never)]
    pub(crate) fn transposed(&self) -> Self {
        self.linear(&Matrix::transposed)
    }

    /// A function of each entry, with its derivative.
    pub(crate) fn mapped(&self, f: fn(f64) -> f64, slope: fn(f64) -> f64) -> Self {
        let (m, d) = (&self.m, self.d.as_ref());
        let made = |entry: &dyn Fn(usize, usize) -> f64| Matrix::made(m.rows, m.columns, entry);
        let d = d.map(|d| made(&|i, j| slope(m.at(i, j)) * d.at(i, j)));
        Self::dual(made(&|i, j| f(m.at(i, j))), d)
    }

    /// √(xᵀx), whose derivative is xᵀ dx over it.
    pub(crate) fn norm(&self) -> Self {
        let (mut norm, mut slope) = (0.0, 0.0);
        for x in &self.m.entries {
            norm = numerics::hypot(norm, *x);
        }
        for (x, d) in self.m.entries.iter().zip(self.slope().entries) {
            slope += x * d / norm;
        }
        Self::dual(Matrix::number(norm), self.d.as_ref().map(|_| Matrix::number(slope)))
    }

    pub(crate) fn trace(&self) -> Self {
        self.linear(&|m| {
            let mut sum = 0.0;
            for i in 0..m.rows {
                sum += m.at(i, i);
            }
            Matrix::number(sum)
        })
    }

    /// Of det A the derivative is det A tr(A⁻¹ dA).
    pub(crate) fn determinant(&self) -> Option<Self> {
        let determinant = self.m.determinant();
        let d = match &self.d {
            Some(d) => {
                let part = Self::from(self.m.solved(d)?).trace();
                Some(part.m.scaled(determinant))
            }
            None => None,
        };
        Some(Self::dual(Matrix::number(determinant), d))
    }

    /// Of LLᵀ = A the derivative is L Φ(L⁻¹ dA L⁻ᵀ), where Φ takes the lower triangle and half of the diagonal.
    pub(crate) fn root(&self) -> Option<Self> {
        let root = self.m.root()?;
        let d = match &self.d {
            Some(d) => {
                let inner = root.solved(&root.solved(d)?.transposed())?;
                let half = [0.0, 0.5, 1.0];
                let weight = |i: usize, j: usize| half[1 + usize::from(i > j) - usize::from(i < j)];
                let lower = Matrix::made(inner.rows, inner.rows, &|i, j| weight(i, j) * inner.at(i, j));
                Some(root.times(&lower))
            }
            None => None,
        };
        Some(Self::dual(root, d))
    }

    /// atan2 of two numbers.
    pub(crate) fn angle(&self, x: &Self) -> Self {
        let (a, b) = (self.m.at(0, 0), x.m.at(0, 0));
        let square = a * a + b * b;
        let d = both(self.d.as_ref().map(|d| d.scaled(b / square)), x.d.as_ref().map(|d| d.scaled(-a / square)));
        Self::dual(Matrix::number(libm::atan2(a, b)), d)
    }
}
