//! A caller's function, with its answers checked, and its Jacobian by differences.

use super::Model;
use crate::error::{Code, Error};
use crate::validate;
use alloc::format;
use nalgebra::{DMatrix, DVector};

/// Half the step of a difference, for a component of about one: near the cube root of a double's spacing, where the
/// error of the difference and that of rounding are alike.
const STEP: f64 = 1.0 / 131_072.0;

/// A function that must answer `len` finite numbers.
pub struct Function<'a, E> {
    pub model: Model<'a, E>,
    /// What an error calls its answer: `f(x)`.
    pub name: &'static str,
    pub len: usize,
    /// The components of its answer that are angles.
    pub angles: &'a [usize],
}

impl<E: From<Error>> Function<'_, E> {
    pub fn at(&mut self, x: &DVector<f64>) -> Result<DVector<f64>, E> {
        let answer = (self.model)(x.as_slice())?;
        if answer.len() == self.len
            && let Some(i) = answer.iter().position(|number| !number.is_finite())
        {
            let at = format!("{}[{i}]", self.name);
            return Err(Error::new(Code::NotFinite, at, "is a NaN or an infinity").into());
        }
        validate::entries(&answer, self.len, self.name)?;
        Ok(DVector::from_vec(answer))
    }

    /// a − b, angles the short way round.
    pub fn difference(&self, a: DVector<f64>, b: &DVector<f64>) -> DVector<f64> {
        let mut difference = a - b;
        wrap_at(self.angles, &mut difference);
        difference
    }

    /// ∂/∂x at x by central differences.
    pub fn differences(&mut self, x: &DVector<f64>) -> Result<DMatrix<f64>, E> {
        let mut jacobian = DMatrix::zeros(self.len, x.len());
        for (i, &at) in x.iter().enumerate() {
            let step = STEP * at.abs().max(1.0);
            let (mut ahead, mut behind) = (x.clone(), x.clone());
            ahead[i] += step;
            behind[i] -= step;
            let change = self.at(&ahead)?;
            let change = self.at(&behind).map(|behind| self.difference(change, &behind))?;
            jacobian.set_column(i, &(change / (ahead[i] - behind[i])));
        }
        Ok(jacobian)
    }
}

/// Takes the components of these indices into (−π, π].
pub fn wrap_at(angles: &[usize], numbers: &mut DVector<f64>) {
    for &angle in angles {
        numbers[angle] = geom::wrap(numbers[angle]);
    }
}
