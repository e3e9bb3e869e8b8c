//! Which feature was sighted? Data association by Mahalanobis distance, with a gate and a threshold for founding new
//! features (sister volume, chapter 7).

use crate::covariance::finite;
use crate::error::{Error, Quantity};
use nalgebra::{SMatrix, SVector};
use numerics::Spd;

/// What to minimize over the candidates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rule {
    /// d² + ln det S: the likeliest of normal densities of different widths.
    #[default]
    MaximumLikelihood,
    /// d² alone. A candidate with a vast S then looks near.
    ChiSquared,
}

/// Two thresholds on d². One alone cannot serve both for rejecting a sighting and for founding a feature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thresholds {
    /// A sighting farther than this from the feature it is taken for is not used.
    pub gate: f64,
    /// A sighting farther than this from every feature is of a new one.
    pub found: f64,
}

impl Thresholds {
    /// A gate without founding, as for a map that is complete.
    pub fn gate(gate: Option<f64>) -> Self {
        Self { gate: gate.unwrap_or(f64::INFINITY), found: f64::INFINITY }
    }
}

/// A feature that the sighting may be of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<const M: usize> {
    /// The feature.
    pub j: usize,
    /// Innovation against it.
    pub innovation: SVector<f64, M>,
    /// Its covariance S.
    pub s: SMatrix<f64, M, M>,
    /// d² = νᵀS⁻¹ν.
    pub d2: f64,
    /// What the rule minimizes.
    pub cost: f64,
}

impl<const M: usize> Candidate<M> {
    /// Weighs feature `j`.
    ///
    /// # Errors
    /// [`Error::InnovationNotPositiveDefinite`], or [`Error::NotFinite`] on overflow.
    pub fn new(j: usize, innovation: SVector<f64, M>, s: SMatrix<f64, M, M>, rule: Rule) -> Result<Self, Error> {
        let spd = Spd::new(finite(s, Quantity::InnovationCovariance)?).ok_or(Error::InnovationNotPositiveDefinite)?;
        let d2 = spd.squared_length(&innovation);
        let cost = match rule {
            Rule::ChiSquared => d2,
            Rule::MaximumLikelihood => d2 + spd.ln_determinant(),
        };
        if cost.is_finite() {
            Ok(Self { j, innovation, s, d2, cost })
        } else {
            Err(Error::NotFinite(Quantity::SquaredDistance))
        }
    }
}

/// What becomes of a sighting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Association<const M: usize> {
    /// It is of this feature.
    Matched(Candidate<M>),
    /// It is not to be used; the candidate was the best.
    Rejected(Candidate<M>),
    /// It is of a feature not met before.
    New,
}

impl<const M: usize> Association<M> {
    /// The feature that the sighting is of, if it is of a known one.
    pub fn matched(self) -> Option<Candidate<M>> {
        if let Self::Matched(candidate) = self { Some(candidate) } else { None }
    }
}

/// Chooses among the candidates: of those within the gate the one of least cost. Where none is, the sighting is of a
/// new feature if even the nearest is beyond `thresholds.found` (or there is none), and rejected otherwise. Those
/// `taken`, by another sighting of the same moment, are not chosen, and are features all the same: near one of them
/// nothing is new.
pub fn associate<const M: usize>(
    candidates: &[Candidate<M>],
    taken: &[Candidate<M>],
    thresholds: Thresholds,
) -> Association<M> {
    let within = candidates.iter().filter(|c| c.d2 <= thresholds.gate);
    let best = within.min_by(|a, b| a.cost.total_cmp(&b.cost));
    let nearest = candidates.iter().chain(taken).min_by(|a, b| a.d2.total_cmp(&b.d2));
    match (nearest, best) {
        (Some(nearest), _) if nearest.d2 > thresholds.found => Association::New,
        (_, Some(best)) => Association::Matched(*best),
        (Some(nearest), None) => Association::Rejected(*nearest),
        (None, None) => Association::New,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix1, Matrix2, Vector1, Vector2};

    fn candidate(j: usize, nu: f64, s: f64, rule: Rule) -> Candidate<1> {
        Candidate::new(j, Vector1::new(nu), Matrix1::new(s), rule).expect("positive definite")
    }

    #[test]
    fn the_determinant_decides_between_gates_of_different_size() {
        let both = |rule| [candidate(0, 1.0, 1.0, rule), candidate(1, 3.0, 100.0, rule)];
        let Association::Matched(by_chi2) = associate(&both(Rule::ChiSquared), &[], Thresholds::gate(None)) else {
            panic!("within an infinite gate");
        };
        let Association::Matched(by_likelihood) =
            associate(&both(Rule::MaximumLikelihood), &[], Thresholds::gate(None))
        else {
            panic!("within an infinite gate");
        };
        assert_eq!((by_chi2.j, by_likelihood.j), (1, 0));
        assert!((by_chi2.cost - 0.09).abs() < 1e-15);
    }

    #[test]
    fn the_cost_is_twice_the_negative_log_likelihood() {
        let s = Matrix2::new(2.0, 0.3, 0.3, 0.5);
        let nu = Vector2::new(0.4, -0.7);
        let c = Candidate::new(0, nu, s, Rule::MaximumLikelihood).expect("positive definite");
        let inverse = s.try_inverse().expect("invertible");
        let exact = (nu.transpose() * inverse * nu)[0] + libm::log(s.determinant());
        assert!((c.cost - exact).abs() < 1e-14);
    }

    #[test]
    fn two_thresholds_separate_three_outcomes() {
        let thresholds = Thresholds { gate: 9.0, found: 50.0 };
        let at = |nu: f64| associate(&[candidate(4, nu, 1.0, Rule::ChiSquared)], &[], thresholds);
        assert!(matches!(at(3.0), Association::Matched(c) if c.j == 4));
        assert!(matches!(at(3.1), Association::Rejected(c) if c.j == 4));
        assert!(matches!(at(7.0), Association::Rejected(_)));
        assert_eq!(at(7.1), Association::New);
        assert_eq!(associate::<1>(&[], &[], thresholds), Association::New);
    }

    #[test]
    fn a_near_candidate_forbids_founding_whatever_its_likelihood() {
        let rule = Rule::MaximumLikelihood;
        let thresholds = Thresholds { gate: 9.0, found: 50.0 };
        // The second is likelier by its narrow S, and far outside its gate; the first is near in a vast one.
        let answer = associate(&[candidate(0, 1e20, 1e40, rule), candidate(1, 8.0, 1.0, rule)], &[], thresholds);
        assert!(matches!(answer, Association::Matched(c) if c.j == 0), "{answer:?}");
    }

    #[test]
    fn a_taken_candidate_is_not_chosen_and_forbids_founding() {
        let thresholds = Thresholds { gate: 9.0, found: 50.0 };
        let at = |j, nu| candidate(j, nu, 1.0, Rule::ChiSquared);
        assert!(matches!(associate(&[], &[at(0, 1.0)], thresholds), Association::Rejected(c) if c.j == 0));
        assert_eq!(associate(&[], &[at(0, 8.0)], thresholds), Association::New);
        let second = associate(&[at(1, 2.0), at(2, 2.5)], &[at(0, 1.0)], thresholds);
        assert!(matches!(second, Association::Matched(c) if c.j == 1), "{second:?}");
        let near = associate(&[at(1, 8.0)], &[at(0, 7.0)], thresholds);
        assert!(matches!(near, Association::Rejected(c) if c.j == 0), "{near:?}");
    }

    #[test]
    fn of_two_equal_candidates_the_first_is_chosen_and_bounds_are_inclusive() {
        let at = |j, nu| candidate(j, nu, 1.0, Rule::ChiSquared);
        let thresholds = Thresholds { gate: 9.0, found: 49.0 };
        assert!(matches!(associate(&[at(3, 2.0), at(1, -2.0)], &[], thresholds), Association::Matched(c) if c.j == 3));
        assert!(matches!(associate(&[at(3, 5.0), at(1, -5.0)], &[], thresholds), Association::Rejected(c) if c.j == 3));
        assert!(matches!(associate(&[at(1, 7.0)], &[], thresholds), Association::Rejected(_)));
    }

    #[test]
    fn a_candidate_without_a_finite_distance_is_refused() {
        let rule = Rule::ChiSquared;
        assert!(Candidate::new(0, Vector1::new(1.0), Matrix1::new(0.0), rule).is_err());
        assert!(Candidate::new(0, Vector1::new(f64::NAN), Matrix1::new(1.0), rule).is_err());
        assert!(Candidate::new(0, Vector1::new(1e200), Matrix1::new(1e-200), rule).is_err());
    }
}
