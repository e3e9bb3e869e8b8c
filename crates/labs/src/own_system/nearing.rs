//! In how many steps the filter's covariance comes near to its limit, as an engineer asks: to within a hundredth of it.
//!
//! With P∞ the limit of P(k+1 | k), R its gain and Φ = F (I − RH), the difference D from the limit is known after any
//! number of steps without taking them one by one:
//!
//! D_k = Φᵏ D₀ (I + S_k D₀)⁻¹ Φᵏᵀ, S_k = Σ_{j<k} Φʲᵀ Hᵀ (H P∞ Hᵀ + W)⁻¹ H Φʲ,
//!
//! and S_{a+b} = S_a + Φᵃᵀ S_b Φᵃ.

use estimate::dynamic::System;
use nalgebra::DMatrix;

/// What may be left of the difference from the limit.
const SHARE: f64 = 0.01;
/// What tells a fall by a factor in each step from one as that of an average: after 2⁸ times as many steps as it takes
/// to a hundredth nothing is left of the former, and of the latter more than this part.
const LATER: usize = 8;
const NEXT_TO_NOTHING: f64 = 1e-10;
/// A variance that no noise feeds counts as one that falls to 0 below this part of its start's: then its start is what
/// it is a share of.
const NOTHING: f64 = 1e-9;
/// Doubled steps are taken as far as this.
const DOUBLINGS: usize = 50;

/// How near the covariance comes, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nearing {
    /// Steps until it is within a hundredth of the limit.
    pub steps: f64,
    /// Whether it falls ever more slowly, as the variance of an average does.
    pub slowly: bool,
}

/// Φᵏ and S_k.
struct Stride {
    phi: DMatrix<f64>,
    s: DMatrix<f64>,
}

impl Stride {
    fn then(&self, next: &Self) -> Self {
        Self { phi: &next.phi * &self.phi, s: &self.s + self.phi.transpose() * &next.s * &self.phi }
    }
}

/// From P(0 | 0) to a limit of P(k+1 | k), where noise feeds the variances of some states; `None` where it is not
/// reached, or where the limit leaves a reading without any noise.
pub(super) fn nearing(system: &System, p0: &DMatrix<f64>, limit: &DMatrix<f64>, fed: &[bool]) -> Option<Nearing> {
    let n = p0.nrows();
    let begins = &system.f * p0 * system.f.transpose() + &system.v;
    let inverse = (&system.h * limit * system.h.transpose() + &system.w).try_inverse()?;
    let gain = limit * system.h.transpose() * &inverse;
    let phi = &system.f * (DMatrix::identity(n, n) - gain * &system.h);
    let first = Stride { phi, s: system.h.transpose() * inverse * &system.h };
    let off = &begins - limit;
    let largest = begins.amax().max(limit.amax());
    let unit = |i: usize| {
        let (at, from) = (limit[(i, i)], begins[(i, i)]);
        let unit = if at > NOTHING * from || (fed[i] && at > 0.0) { at } else { from };
        if unit > 0.0 {
            unit
        } else if largest > 0.0 {
            NOTHING * largest
        } else {
            1.0
        }
    };
    let units: Vec<f64> = (0..n).map(unit).collect();
    // What is left, in units of what it is a share of.
    let left = |stride: &Stride| -> Option<f64> {
        let met = (DMatrix::identity(n, n) + &stride.s * &off).try_inverse()?;
        let left = &stride.phi * &off * met * stride.phi.transpose();
        let part = |i: usize, j: usize| left[(i, j)].abs() / (units[i] * units[j]).sqrt();
        let parts = || (0..n).flat_map(|i| (0..n).map(move |j| part(i, j)));
        parts().all(f64::is_finite).then(|| parts().fold(0.0, f64::max))
    };
    let none = Stride { phi: DMatrix::identity(n, n), s: DMatrix::zeros(n, n) };
    if left(&none)? <= SHARE {
        return Some(Nearing { steps: 0.0, slowly: false });
    }
    let mut strides = vec![first];
    while left(&strides[strides.len() - 1])? > SHARE {
        let last = &strides[strides.len() - 1];
        if strides.len() > DOUBLINGS {
            return None;
        }
        strides.push(last.then(last));
    }
    let doubled = strides.len() - 1;
    let (mut count, mut here) = (0.0, none);
    for bit in (0..doubled).rev() {
        let further = here.then(&strides[bit]);
        if left(&further)? > SHARE {
            (count, here) = (count + libm::exp2(bit as f64), further);
        }
    }
    let at_first = left(&strides[doubled])?;
    let later = (0..LATER).fold(strides.swap_remove(doubled), |stride, _| stride.then(&stride));
    let slowly = left(&later).is_none_or(|left| left > NEXT_TO_NOTHING * at_first);
    Some(Nearing { steps: count + 1.0, slowly })
}

#[cfg(test)]
mod tests {
    use super::*;
    use estimate::dynamic;
    use nalgebra::dmatrix;

    fn system(f: DMatrix<f64>, h: DMatrix<f64>, v: DMatrix<f64>) -> System {
        let (n, p) = (f.nrows(), h.nrows());
        System::new(f, DMatrix::zeros(n, 0), h, v, DMatrix::identity(p, p)).expect("sound")
    }

    /// The same by single steps: the first after which each entry is within a hundredth.
    fn counted(system: &System, p0: &DMatrix<f64>, limit: &DMatrix<f64>, steps: usize) -> usize {
        let unit = |i: usize, first: &DMatrix<f64>| if limit[(i, i)] > 0.0 { limit[(i, i)] } else { first[(i, i)] };
        let begins = &system.f * p0 * system.f.transpose() + &system.v;
        let (n, System { f, h, v, w, .. }) = (p0.nrows(), system);
        let near = |p: &DMatrix<f64>| {
            (0..n).all(|i| {
                (0..n).all(|j| {
                    let off = (p[(i, j)] - limit[(i, j)]).abs();
                    off <= SHARE * (unit(i, &begins) * unit(j, &begins)).sqrt()
                })
            })
        };
        let mut p = begins.clone();
        for count in 0..steps {
            if near(&p) {
                return count;
            }
            let gain = &p * h.transpose() * (h * &p * h.transpose() + w).try_inverse().expect("noise");
            let rest = DMatrix::identity(n, n) - &gain * h;
            // Joseph's form: what is left of a large start has its digits.
            p = f * (&rest * &p * rest.transpose() + &gain * w * gain.transpose()) * f.transpose() + v;
        }
        panic!("it does not come near in {steps} steps");
    }

    #[test]
    fn as_many_steps_are_found_as_single_ones_take() {
        let cv = system(dmatrix![1.0, 0.1; 0.0, 1.0], dmatrix![1.0, 0.0], dmatrix![0.0, 0.0; 0.0, 0.01]);
        let start = DMatrix::identity(2, 2) * 100.0;
        let limit = dynamic::steady_state(&cv, start.clone()).expect("a limit").p;
        let found = nearing(&cv, &start, &limit, &[true; 2]).expect("comes near");
        assert_eq!(found.steps, counted(&cv, &start, &limit, 400) as f64);
        assert!(found.steps > 20.0 && !found.slowly, "{found:?}");
        // A variance that falls to 0 by a factor in each step, where no noise is: not until the numbers end.
        let dying = system(dmatrix![0.5], dmatrix![1.0], dmatrix![0.0]);
        let (one, zero) = (dmatrix![1.0], dmatrix![0.0]);
        let found = nearing(&dying, &one, &zero, &[false]).expect("comes near");
        assert_eq!((found.steps, found.slowly), (counted(&dying, &one, &zero, 40) as f64, false));
    }

    #[test]
    fn a_limit_far_below_the_start_is_still_what_noise_leaves() {
        let near = |v: DMatrix<f64>, h: DMatrix<f64>, f: DMatrix<f64>, start: f64| {
            let n = f.nrows();
            let system = System { w: dmatrix![1e-8], ..system(f, h, v) };
            let start = DMatrix::identity(n, n) * start;
            let limit = dynamic::steady_state(&system, start.clone()).expect("a limit").p;
            let found = nearing(&system, &start, &limit, &[true; 2][..n]).expect("comes near");
            (found.steps, counted(&system, &start, &limit, 100_000) as f64)
        };
        for v in [1e-10, 1e-12, 1e-14] {
            let (found, counted) = near(dmatrix![v], dmatrix![1.0], dmatrix![1.0], 1.0);
            assert_eq!(found, counted, "{v}");
        }
        // A position and its drift, from a start that knows nothing and from one that knows much.
        for start in [1.0, 1e-4] {
            let drift = (dmatrix![1e-10, 0.0; 0.0, 1e-14], dmatrix![1.0, 0.0], dmatrix![1.0, 0.01; 0.0, 1.0]);
            let (found, counted) = near(drift.0, drift.1, drift.2, start);
            assert!((found - counted).abs() <= 2.0, "{start}: {found} {counted}");
        }
    }

    #[test]
    fn the_variance_of_an_average_falls_ever_more_slowly() {
        let constant = system(dmatrix![1.0], dmatrix![1.0], dmatrix![0.0]);
        // P(k+1 | k) is 1/(k + 1) of a start of 1, whose reading has the variance 1: a hundredth after 99.
        let found = nearing(&constant, &dmatrix![1.0], &dmatrix![0.0], &[false]).expect("falls");
        assert!((98.0..=100.0).contains(&found.steps) && found.slowly, "{found:?}");
        // What is not seen stays as it is.
        let two = system(DMatrix::identity(2, 2), dmatrix![1.0, 0.0], DMatrix::zeros(2, 2));
        let limit = dmatrix![1e-15, 0.0; 0.0, 1.0];
        assert!(nearing(&two, &DMatrix::identity(2, 2), &limit, &[false; 2]).expect("falls").slowly);
        // From a start that knows what lies on the circle the rest falls by a factor.
        let beside = system(dmatrix![1.0, 0.0; 0.0, 0.5], dmatrix![1.0, 1.0], DMatrix::zeros(2, 2));
        let start = dmatrix![0.0, 0.0; 0.0, 1.0];
        let found = nearing(&beside, &start, &DMatrix::zeros(2, 2), &[false; 2]).expect("falls");
        assert!(found.steps < 10.0 && !found.slowly, "{found:?}");
    }
}
