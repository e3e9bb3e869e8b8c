//! A real polynomial by its roots, which are real or come in conjugate pairs.

use crate::error::{Code, Error};
use alloc::borrow::Cow;
use alloc::format;
use alloc::vec::Vec;
use nalgebra::{Complex, DMatrix};
use numerics::hypot;

/// λ − a, or (λ − z)(λ − z̄).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Factor {
    /// The root a.
    Real(f64),
    /// The root z in the upper half of the plane, and its conjugate.
    Pair(Complex<f64>),
}

impl Factor {
    /// The factor's value for a matrix of this norm is no larger.
    pub fn size(&self, norm: f64) -> f64 {
        match self {
            Self::Real(root) => norm + root.abs(),
            Self::Pair(root) => {
                let each = norm + hypot(root.re, root.im);
                each * each
            }
        }
    }
}

/// The polynomial of `n` roots.
///
/// # Errors
/// [`Code::Poles`] when they are not `n` numbers closed under conjugation, [`Code::NotFinite`] when one is not finite.
pub(super) fn real_factors(poles: &[Complex<f64>], n: usize) -> Result<Vec<Factor>, Error> {
    let refuse = |message: Cow<'static, str>| Err(Error::new(Code::Poles, "poles", message));
    if poles.len() != n {
        return refuse(format!("are {}; {n} are needed", poles.len()).into());
    }
    if poles.iter().any(|p| !p.re.is_finite() || !p.im.is_finite()) {
        return Err(Error::new(Code::NotFinite, "poles", "hold a NaN or an infinity; every pole must be finite"));
    }
    let mut factors: Vec<Factor> = poles.iter().filter(|p| p.im == 0.0).map(|p| Factor::Real(p.re)).collect();
    let mut lower: Vec<&Complex<f64>> = poles.iter().filter(|p| p.im < 0.0).collect();
    for upper in poles.iter().filter(|p| p.im > 0.0) {
        let Some(at) = lower.iter().position(|l| l.re == upper.re && l.im == -upper.im) else {
            return refuse("hold a complex number without its conjugate".into());
        };
        lower.swap_remove(at);
        factors.push(Factor::Pair(*upper));
    }
    if lower.is_empty() { Ok(factors) } else { refuse("hold a complex number without its conjugate".into()) }
}

/// The polynomial's value for the square matrix `m`.
pub(super) fn evaluate(factors: &[Factor], m: &DMatrix<f64>) -> DMatrix<f64> {
    let identity = DMatrix::identity(m.nrows(), m.ncols());
    factors.iter().fold(identity.clone(), |product, factor| match factor {
        Factor::Real(root) => product * (m - &identity * *root),
        Factor::Pair(root) => {
            let (sum, constant) = (2.0 * root.re, root.re * root.re + root.im * root.im);
            product * (m * m - m * sum + &identity * constant)
        }
    })
}
