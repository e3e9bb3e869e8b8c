use super::*;
use crate::error::Quantity;
use nalgebra::{Matrix1, Matrix2, Matrix2x1, RowVector2, Vector2};

#[test]
fn predicted_and_innovation_covariance_are_their_formulas() {
    let p = Matrix2::new(3.0, 1.0, 1.0, 2.0);
    let (a, r) = (Matrix2::new(1.0, 2.0, 0.0, 1.0), Matrix2::new(0.5, 0.25, 0.25, 0.125));
    assert_eq!(predicted_covariance(&a, &p, &r), Ok(Matrix2::new(15.5, 5.25, 5.25, 2.125)));
    let (c, q) = (RowVector2::new(1.0, 2.0), Matrix1::new(0.75));
    assert_eq!(innovation_covariance(&c, &p, &q), Matrix1::new(15.75));
}

#[test]
fn the_complement_is_the_identity_less_the_gain_times_the_output() {
    let left = complement(&Matrix2x1::new(0.5, 0.25), &RowVector2::new(1.0, 2.0));
    assert_eq!(left, Matrix2::new(0.5, -1.0, -0.25, 0.5));
}

/// However precise the reading is, at least half of its own variance remains, and never zero.
#[test]
fn a_precise_reading_leaves_at_least_its_own_variance() {
    let p = Matrix2::new(3.0, 0.2, 0.2, 1.1);
    for h in [1.0, 0.2, 0.3, 7.0] {
        for w in [1e-20, 1e-26, 1e-31, 1e-33, 1e-36] {
            let left = gain(&p, &RowVector2::new(h, 0.0), &Matrix1::new(w)).expect("positive definite").p;
            let own = w / (h * h);
            assert!(left[(0, 0)] > 0.5 * own, "{h} {w}: {left}");
            assert!((left[(1, 1)] - (1.1 - 0.04 / 3.0)).abs() < 1e-14);
        }
    }
}

/// Outputs δ = 1e-9 apart: no pivot is left of S, and square roots still have six digits.
#[test]
fn d2_is_none_where_s_has_no_factor() {
    let delta = 1e-9;
    let (c, q) = (Matrix2::new(1.0, 0.0, 1.0, delta), Matrix2::identity() * (delta * delta));
    let gain = gain(&Matrix2::identity(), &c, &q).expect("square roots suffice");
    assert_eq!((gain.factor.pivot(), gain.d2(&Vector2::new(1e-3, 2e-3))), (0.0, None));
}

#[test]
fn a_prediction_refuses_infinities_and_mends_cancelled_terms() {
    let (one, zero) = (Matrix2::identity(), Matrix2::zeros());
    assert_eq!(predicted_covariance(&one, &zero, &zero), Ok(zero));
    let refused = Err(Error::NotFinite(Quantity::PredictedCovariance));
    assert_eq!(predicted_covariance(&one, &(one * f64::NAN), &zero), refused);
    assert_eq!(predicted_covariance(&(one * 1e200), &one, &zero), refused);
    // Out by a huge lever and back: what is left is rounding, of either sign, and is taken as none.
    let lever = Matrix2::new(1.0, 1e9, 0.0, 1.0);
    let p = predicted_covariance(&lever, &Matrix2::new(1.0, 0.3, 0.3, 0.7), &zero).expect("finite");
    let back = lever.try_inverse().expect("a shear");
    let p = predicted_covariance(&back, &p, &zero).expect("finite");
    assert!(p.symmetric_eigenvalues().min() >= -1e-12 * p.symmetric_eigenvalues().max());
}

/// P is of rank one and H is orthogonal to it: HPHᵀ is 0, and its terms, of size 10¹⁷, cancel to their rounding.
/// Multiplied out, S came out as −44. From square roots it is W and the square of that rounding.
#[test]
fn where_the_terms_of_s_cancel_it_is_no_less_than_w() {
    let p = Matrix2::new(8.1e17, 6.3e17, 6.3e17, 4.9e17);
    let found = gain(&p, &RowVector2::new(0.7, -0.9), &Matrix1::new(0.5)).expect("W is positive");
    let rounding = f64::EPSILON * 1.3 * p.norm();
    assert!((0.5..0.5 + rounding).contains(&found.s[0]), "S = {}", found.s[0]);
    assert!(found.p.iter().chain(&found.k).all(|e| e.is_finite()));
}

/// Systems of the same kind: P of rank one, all but unseen through H, and twelve to twenty orders of magnitude above W.
#[test]
fn s_is_positive_in_every_answer() {
    let (mut answered, mut refused) = (0, 0);
    for a in -9..=9 {
        for b in 1..=9 {
            for exponent in [6, 8, 9, 10] {
                let size = libm::exp10(f64::from(exponent));
                let v = nalgebra::Vector2::new(0.1 * f64::from(b), 0.1 * f64::from(a)) * size;
                let p = v * v.transpose();
                for w in [1e-3, 0.5, 7.0] {
                    for off in [0.0, 1e-12, -1e-9] {
                        let h = RowVector2::new(-0.1 * f64::from(a) + off, 0.1 * f64::from(b));
                        match gain(&p, &h, &Matrix1::new(w)) {
                            Ok(found) => {
                                assert!(found.s[0] > 0.0, "S = {} of {p}{h}{w}", found.s[0]);
                                answered += 1;
                            }
                            Err(Error::InnovationNotPositiveDefinite) => refused += 1,
                            Err(error) => panic!("{error} of {p}{h}{w}"),
                        }
                    }
                }
            }
        }
    }
    assert!(answered > 100 * refused, "{answered} answered, {refused} refused");
}
