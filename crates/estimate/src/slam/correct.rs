//! The update of the whole state by one sighting, O(N²), and the guard over its rounding.

use super::EkfSlam;
use super::sighting::Expected;
use crate::error::Error;
use alloc::vec;
use alloc::vec::Vec;
use filters::Quantity;
use filters::covariance::{MAP_ROUNDING, SEMIDEFINITE_TOLERANCE};
use geom::wrap;
use nalgebra::Vector2;
use numerics::sqrt;
use numerics::{MIN_PIVOT, Spd};

/// Up to this many states P is checked at every change.
const ALWAYS: usize = 35;

/// What an update will do, worked out before anything is touched.
struct Step {
    k: [Vec<f64>; 2],
    l: [Vec<f64>; 2],
    dx: Vec<f64>,
    /// νᵀS⁻¹ν.
    d2: f64,
    /// The largest sum of sizes of the terms of a new variance. It is far above the variance where the terms cancel:
    /// when robot and landmark know each other far better than the world, or S is nearly singular.
    scale: f64,
    /// The largest of the new variances.
    after: f64,
}

impl EkfSlam {
    /// Corrects the whole state by an innovation of the landmark `expected` is of.
    pub(super) fn correct(&mut self, expected: &Expected, innovation: &Vector2<f64>) -> Result<(), Error> {
        let step = self.worked_out(expected, innovation)?;
        let sound = self.guarded(step.scale, step.after, |slam| {
            slam.p.subtract_pairs([&step.k[0], &step.k[1]], [&step.l[0], &step.l[1]]);
            for (x, dx) in slam.x.iter_mut().zip(&step.dx) {
                *x += dx;
            }
            slam.x[2] = wrap(slam.x[2]);
            slam.nis = (slam.nis.0 + step.d2, slam.nis.1 + 2);
        });
        if sound { Ok(()) } else { Err(filters::Error::InnovationNotPositiveDefinite.into()) }
    }

    /// Changes P, and keeps account of the rounding: the change adds up terms of size `scale` to variances of which the
    /// largest is `after`. Where the rounding may matter, P is checked. The answer is false when it is no covariance
    /// any more; the change is then undone.
    pub(super) fn guarded(&mut self, scale: f64, after: f64, change: impl FnOnce(&mut Self)) -> bool {
        let rounding = numerics::hypot(self.rounding, f64::EPSILON * scale);
        // A small state is always checked, a large one rarely: in an ordinary run its variances do not fall far enough.
        let suspect = self.x.len() <= ALWAYS || rounding > (MAP_ROUNDING + 2.0 * self.resolution()) * after;
        let before = suspect.then(|| self.clone());
        change(self);
        self.rounding = rounding;
        let Some(before) = before else { return true };
        match self.semidefinite_to() {
            Some(size) => {
                self.rounding = size;
                true
            }
            None => {
                *self = before;
                false
            }
        }
    }

    /// K and L = M − K S/2 for P − KMᵀ − MKᵀ + KSKᵀ = P − KLᵀ − LKᵀ, with M = PHᵀ: the covariance that this K leaves,
    /// whether K is exact or not, as Joseph's form does, from five columns of P.
    fn worked_out(&self, expected: &Expected, innovation: &Vector2<f64>) -> Result<Step, Error> {
        let n = self.x.len();
        let (mut m0, mut m1) = (vec![0.0; n], vec![0.0; n]);
        let mut column = vec![0.0; n];
        for (a, c) in expected.columns().into_iter().enumerate() {
            self.p.column(c, &mut column);
            let (h0, h1) = (expected.h[(0, a)], expected.h[(1, a)]);
            for ((m0, m1), p) in m0.iter_mut().zip(&mut m1).zip(&column) {
                *m0 += h0 * p;
                *m1 += h1 * p;
            }
        }
        let s = expected.innovation_covariance(&self.p, &self.w);
        let spd = Spd::new(s).filter(|spd| spd.pivot() >= MIN_PIVOT);
        let spd = spd.ok_or(filters::Error::InnovationNotPositiveDefinite)?;
        let d2 = spd.squared_length(innovation);
        let k = [m0.clone(), m1.clone()];
        let mut step = Step { k, l: [m0, m1], dx: column, d2, scale: 0.0, after: 0.0 };
        let (mut before, mut after, mut largest) = (0.0_f64, 0.0_f64, 0.0_f64);
        // The sum of sizes of the terms in each row of H.
        let columns = expected.columns();
        let spread = [0, 1].map(|a| {
            let seen = |b: usize| expected.h[(a, b)].abs() * sqrt(self.p.get(columns[b], columns[b]));
            (0..5).map(seen).sum::<f64>() + sqrt(self.w[(a, a)])
        });
        for i in 0..n {
            let m = Vector2::new(step.l[0][i], step.l[1][i]);
            let k = spd.solve(&m);
            let l = m - s * k * 0.5;
            for a in 0..2 {
                step.k[a][i] = k[a];
                step.l[a][i] = l[a];
            }
            step.dx[i] = k.dot(innovation);
            let variance = self.p.get(i, i);
            before = before.max(variance);
            after = after.max(variance - 2.0 * k.dot(&l));
            largest = largest.max(k.amax()).max(l.amax());
            let terms = sqrt(variance.max(0.0)) + k[0].abs() * spread[0] + k[1].abs() * spread[1];
            step.scale = step.scale.max(terms * terms);
        }
        let x_is_finite = self.x.iter().zip(&step.dx).all(|(x, dx)| (x + dx).is_finite());
        // Every entry of P changes by at most 4 max|K| max|L|, so P cannot overflow if this does not.
        let bounded = (4.0 * largest * largest + before + d2).is_finite();
        if !(x_is_finite && bounded) {
            return Err(filters::Error::NotFinite(Quantity::Mean).into());
        }
        step.after = after;
        Ok(step)
    }

    /// A bound b, well within what a covariance is allowed, such that no eigenvalue of P lies below −b. `None` when
    /// there is no such bound, or when a landmark's own block is no covariance.
    fn semidefinite_to(&self) -> Option<f64> {
        let largest = self.p.diagonal().fold(0.0, |a: f64, b| a.max(b.abs()));
        if largest == 0.0 {
            return Some(0.0);
        }
        let mut p = self.p.to_dense() / largest;
        // In all a part of 10⁻¹² may be lost. A factorization of n rows has n roundings in its pivots.
        let part = if self.x.len() <= ALWAYS {
            5.0 * MAP_ROUNDING
        } else {
            0.1 * MAP_ROUNDING + p.nrows() as f64 * f64::EPSILON
        };
        for i in 0..p.nrows() {
            p[(i, i)] += part;
        }
        let sound = filters::covariance::is_finite(&p) && Spd::new(p).is_some() && self.landmarks_are_covariances();
        sound.then_some(part * largest)
    }

    /// Whether each landmark's 2×2 block is a covariance relative to its own size. Beside a robot whose position is
    /// uncertain by 10⁸ m, the whole P may pass while such a block consists of rounding.
    fn landmarks_are_covariances(&self) -> bool {
        self.landmarks().all(|mapped| {
            let (mean, half) =
                (0.5 * (mapped.p[(0, 0)] + mapped.p[(1, 1)]), 0.5 * (mapped.p[(0, 0)] - mapped.p[(1, 1)]));
            let radius = numerics::hypot(half, mapped.p[(1, 0)]);
            mean - radius >= -SEMIDEFINITE_TOLERANCE * (mean + radius)
        })
    }

    /// The rounding in the pivots of a factorization of n rows, as a part of the largest.
    fn resolution(&self) -> f64 {
        self.x.len() as f64 * f64::EPSILON
    }
}

#[cfg(test)]
mod tests;
