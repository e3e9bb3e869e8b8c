//! Whether the covariance of the Kalman filter tends to a limit, and why (de Souza, Gevers and Goodwin, IEEE
//! Transactions on Automatic Control 31, 1986, 831–838).

use crate::verdict::Verdict::{self, No, Yes};

/// What becomes of P(k+1 | k) as k grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RiccatiLimit {
    /// One limit from every P(0 | 0), and the error of the filter's limit gain dies out: (F, H) is detectable and (F,
    /// V^½) stabilizable.
    FromEveryStart,
    /// A limit from every P(0 | 0) that is not smaller than it: (F, H) is detectable. Noise does not reach every
    /// direction that F keeps alive, so from a smaller start there may be another limit, and near the limit the filter
    /// corrects such a direction ever less.
    FromLargeStart,
    /// None, from any P(0 | 0): noise reaches every direction that F keeps alive, and one of them is unseen, so P grows
    /// without bound.
    None,
    /// It depends on P(0 | 0) and on V: a direction that F keeps alive is unseen, and noise does not reach every such
    /// direction.
    DependsOnStart,
    /// The tolerance does not decide whether (F, H) is detectable, or, where it is not, whether (F, V^½) is
    /// stabilizable.
    Undecided,
}

impl RiccatiLimit {
    /// What follows of the two verdicts: whether (F, H) is detectable, and whether (F, V^½) is stabilizable.
    ///
    /// Where (F, V^½) is stabilizable, a limit would make the error die out, which no gain does of a system that is not
    /// detectable: so there is none.
    pub fn of(detectable: Verdict, stabilizable: Verdict) -> Self {
        match (detectable, stabilizable) {
            (Yes, Yes) => Self::FromEveryStart,
            // It holds of a stabilizable pair too.
            (Yes, _) => Self::FromLargeStart,
            (No, Yes) => Self::None,
            (No, No) => Self::DependsOnStart,
            _ => Self::Undecided,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamic::{System, detectability, noise_reach};
    use nalgebra::{DMatrix, dmatrix};

    fn limit(f: DMatrix<f64>, h: DMatrix<f64>, v: DMatrix<f64>) -> (RiccatiLimit, System) {
        let n = f.nrows();
        let p = h.nrows();
        let detectable = detectability(f.clone(), h.clone(), 1e-9).expect("found").detectable;
        let stabilizable = noise_reach(f.clone(), v.clone(), 1e-9).expect("found").stabilizable;
        let system = System::new(f, DMatrix::zeros(n, 0), h, v, DMatrix::identity(p, p)).expect("sound");
        (RiccatiLimit::of(detectable, stabilizable), system)
    }

    /// The largest entry of P(k+1 | k) after so many steps from σ²I.
    fn after(system: &System, variance: f64, steps: usize) -> f64 {
        let n = system.f.nrows();
        system.steady_state_gain(&(DMatrix::identity(n, n) * variance), steps, 0.0).expect("runs").p.amax()
    }

    #[test]
    fn the_recursion_does_what_the_verdict_says() {
        let cv = dmatrix![1.0, 0.5; 0.0, 1.0];
        let position = dmatrix![1.0, 0.0];
        let velocity = dmatrix![0.0, 1.0];
        let kicks = dmatrix![0.05, 0.1; 0.1, 0.2];

        let (every, system) = limit(cv.clone(), position.clone(), kicks.clone());
        assert_eq!(every, RiccatiLimit::FromEveryStart);
        assert!((after(&system, 0.0, 2000) - after(&system, 100.0, 2000)).abs() < 1e-9);

        let (large, system) = limit(cv.clone(), position, DMatrix::zeros(2, 2));
        assert_eq!(large, RiccatiLimit::FromLargeStart);
        assert!(after(&system, 1.0, 4000) < after(&system, 1.0, 2000) && after(&system, 1.0, 4000) < 1e-2);

        let (none, system) = limit(cv, velocity, kicks);
        assert_eq!(none, RiccatiLimit::None);
        assert!(after(&system, 0.0, 4000) > 1.9 * after(&system, 0.0, 2000));

        let still = dmatrix![1.0, 0.0; 0.0, 0.5];
        let (depends, system) = limit(still, dmatrix![0.0, 1.0], dmatrix![0.0, 0.0; 0.0, 1.0]);
        assert_eq!(depends, RiccatiLimit::DependsOnStart);
        assert_eq!([after(&system, 2.0, 500), after(&system, 9.0, 500)], [2.0, 9.0]);
    }

    #[test]
    fn an_open_question_leaves_the_limit_open_where_it_matters() {
        use crate::verdict::Verdict::Undecided;
        assert_eq!(RiccatiLimit::of(Undecided, Yes), RiccatiLimit::Undecided);
        assert_eq!(RiccatiLimit::of(No, Undecided), RiccatiLimit::Undecided);
        assert_eq!(RiccatiLimit::of(Yes, Undecided), RiccatiLimit::FromLargeStart);
    }
}
