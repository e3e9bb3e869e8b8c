//! The way back of a smoother over the steps between two beliefs.

use filters::covariance::symmetric;
use filters::linear::{gain, predicted_covariance};
use filters::{Ekf, Quantity, State};
use nalgebra::{DMatrix, SMatrix, SVector};
use numerics::{MIN_PIVOT, Spd, all_finite};

/// Where less than this part of a variance is left, the difference P − C (P̄ − P(all)) Cᵀ has lost too many digits.
const LEAST_PART: f64 = 1e-6;

/// F and V of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linear<const N: usize> {
    pub f: SMatrix<f64, N, N>,
    pub v: SMatrix<f64, N, N>,
}

/// What is known of a row in the light of all readings, and the motion that leads to it from the rows before.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap<X, const N: usize> {
    /// The smoothed belief at the gap's end.
    smoothed: Ekf<X, N>,
    /// What was predicted there.
    predicted: Ekf<X, N>,
    /// The motion within the gap; `None` while there is none.
    motion: Option<Linear<N>>,
}

impl<X: State<N> + Copy, const N: usize> Gap<X, N> {
    /// The end of a replay, where the smoothed belief is the filter's.
    pub fn new(last: &Ekf<X, N>) -> Self {
        Self { smoothed: *last, predicted: *last, motion: None }
    }

    /// The smoothed belief at the gap's end.
    pub fn smoothed(&self) -> &Ekf<X, N> {
        &self.smoothed
    }

    /// Takes the step before into the gap.
    pub fn widen(&mut self, step: &Linear<N>) {
        self.motion = Some(match &self.motion {
            None => *step,
            Some(after) => {
                Linear { f: after.f * step.f, v: symmetric(after.v + after.f * step.v * after.f.transpose()) }
            }
        });
    }

    /// Goes back over the gap to a row with the belief `after` it, and stands before its reading, if it had one, where
    /// `predicted` was believed.
    pub fn close(&mut self, after: &Ekf<X, N>, predicted: &Ekf<X, N>) -> Result<(), filters::Error> {
        if let Some(motion) = self.motion.take() {
            self.smoothed = self.back(after, &motion)?;
        }
        self.predicted = *predicted;
        Ok(())
    }

    /// x + C (x⁺(all) − x̄⁺) and P + C (P⁺(all) − P̄⁺) Cᵀ. Where that has no digits, P − C P̄⁺ Cᵀ is computed as a
    /// correction is, in Joseph's form, from F and V.
    fn back(&self, after: &Ekf<X, N>, Linear { f, v }: &Linear<N>) -> Result<Ekf<X, N>, filters::Error> {
        let delta = self.smoothed.x.boxminus(&self.predicted.x);
        let factor = Spd::assumed(self.predicted.p);
        let mut p = after.p;
        let mut c = SMatrix::zeros();
        let mut sound = factor.pivot() >= MIN_PIVOT;
        if sound {
            c = factor.solve(&(f * after.p)).transpose();
            p = symmetric(after.p - c * (self.predicted.p - self.smoothed.p) * c.transpose());
            sound = (0..N).all(|i| p[(i, i)] > LEAST_PART * after.p[(i, i)]);
        }
        if !sound {
            (c, p) = corrected([&after.p, f, v, &self.smoothed.p])?;
        }
        let step: SVector<f64, N> = c * delta;
        let x = after.x.boxplus(&step);
        if !x.is_finite() {
            return Err(filters::Error::NotFinite(Quantity::Mean));
        }
        if !all_finite(p.iter()) {
            return Err(filters::Error::NotFinite(Quantity::Covariance));
        }
        Ok(Ekf { x, p })
    }
}

/// The rare way: C, and the smoothed covariance, of P, F, V and P⁺(all).
fn corrected<const N: usize>(
    given: [&SMatrix<f64, N, N>; 4],
) -> Result<(SMatrix<f64, N, N>, SMatrix<f64, N, N>), filters::Error> {
    let (c, p) = corrected_of_any_size(given.map(|m| DMatrix::from_column_slice(N, N, m.as_slice())))?;
    let of_size = |m: &DMatrix<f64>| SMatrix::from_column_slice(m.as_slice());
    Ok((of_size(&c), of_size(&p)))
}

/// Compiled once for all sizes.
#[cold]
#[inline(never)]
fn corrected_of_any_size([p, f, v, after]: [DMatrix<f64>; 4]) -> Result<(DMatrix<f64>, DMatrix<f64>), filters::Error> {
    let corrected = gain(&p, &f, &v)?;
    let smoothed = predicted_covariance(&corrected.k, &after, &corrected.p)?;
    Ok((corrected.k, smoothed))
}
