//! [`EkfSlam`] for a caller without types: shapes known at run time only, every argument checked and the culprit named.

use super::EkfSlam;
use crate::dynamic::Belief;
use crate::error::{Code, Error};
use crate::validate;
use filters::association::Thresholds;
use nalgebra::{DMatrix, DVector, Matrix3, Vector2};

impl EkfSlam {
    /// A robot with a belief over [x, y, θ] and an empty map; W is 2×2, the gate an upper bound on χ² (or none), and a
    /// sighting whose χ² is above `found` for every landmark founds a new one.
    ///
    /// # Errors
    /// Naming the argument: [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`],
    /// [`Code::NotPositiveSemidefinite`], or [`Code::Limit`] for a threshold that is not positive and for `found` below the
    /// gate.
    pub fn from_belief(belief: &Belief, w: DMatrix<f64>, gate: Option<f64>, found: f64) -> Result<Self, Error> {
        for (threshold, name) in gate.iter().map(|g| (*g, "gate")).chain([(found, "found")]) {
            if validate::finite(threshold, name)? <= 0.0 {
                return Err(Error::new(Code::Limit, name, "is not positive; a threshold on χ² is"));
            }
        }
        Self::checked(belief.clone(), w, Thresholds { gate: gate.unwrap_or(f64::INFINITY), found })
    }

    /// The pose moves by `u` = [Δs, Δθ]; `v` is 3×3, in the pose.
    ///
    /// # Errors
    /// Naming u or V: [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`], [`Code::NotPositiveSemidefinite`]; V
    /// for a covariance that overflows or loses its digits where it would not without V, otherwise u.
    pub fn predict_by(&mut self, u: DVector<f64>, v: DMatrix<f64>) -> Result<(), Error> {
        let u = validate::vector(u, 2, "u")?;
        let v = validate::covariance(v, 3, "V")?;
        let u = Vector2::new(u[0], u[1]);
        self.predict(&u, &Matrix3::from_fn(|i, j| v[(i, j)])).map_err(|e| {
            let without_noise = self.clone().predict(&u, &Matrix3::zeros());
            e.called(|_| if without_noise.is_ok() { "V" } else { "u" }.into())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::slam::Reading;
    use nalgebra::{dmatrix, dvector};
    use proptest::prelude::*;

    fn belief() -> Belief {
        validate::belief(dvector![0.0, 0.0, 0.0], DMatrix::identity(3, 3) * 0.01).expect("sound")
    }

    #[test]
    fn what_is_no_argument_is_refused_by_name() {
        let w = dmatrix![0.01, 0.0; 0.0, 0.001];
        let refused = |b: &Belief, w: &DMatrix<f64>, gate, found| {
            let e = EkfSlam::from_belief(b, w.clone(), gate, found).expect_err("refused");
            (e.code, e.argument.to_string())
        };
        let short = validate::belief(dvector![0.0, 0.0], DMatrix::identity(2, 2)).expect("sound");
        assert_eq!(refused(&short, &w, None, 50.0), (Code::Shape, "belief.x".into()));
        assert_eq!(refused(&belief(), &dmatrix![1.0], None, 50.0), (Code::Shape, "W".into()));
        assert_eq!(refused(&belief(), &-w.clone(), None, 50.0), (Code::NotPositiveSemidefinite, "W".into()));
        assert_eq!(refused(&belief(), &w, Some(-1.0), 50.0), (Code::Limit, "gate".into()));
        assert_eq!(refused(&belief(), &w, Some(f64::NAN), 50.0), (Code::NotFinite, "gate".into()));
        assert_eq!(refused(&belief(), &w, None, 0.0), (Code::Limit, "found".into()));
        // Every sighting between the two thresholds would be both matched and new.
        assert_eq!(refused(&belief(), &w, Some(100.0), 1.0), (Code::Limit, "found".into()));
        assert!(EkfSlam::from_belief(&belief(), w.clone(), Some(50.0), 50.0).is_ok());
        let mut slam = EkfSlam::from_belief(&belief(), w, None, 50.0).expect("sound");
        let refused = |e: Result<(), Error>| e.expect_err("refused").argument.to_string();
        assert_eq!(refused(slam.predict_by(dvector![1.0], DMatrix::zeros(3, 3))), "u");
        assert_eq!(refused(slam.predict_by(dvector![1.0, 0.0], DMatrix::zeros(2, 2))), "V");
        assert_eq!(refused(slam.predict_by(dvector![1e200, 0.0], DMatrix::zeros(3, 3))), "u");
        slam.predict_by(dvector![0.0, 0.0], 1e308 * DMatrix::identity(3, 3)).expect("just within");
        assert_eq!(refused(slam.predict_by(dvector![0.0, 0.0], 1e308 * DMatrix::identity(3, 3))), "V");
    }

    /// Numbers as a page may send them: ordinary ones mostly, and the worst there are.
    fn number(ordinary: u32) -> impl Strategy<Value = f64> {
        prop_oneof![
            ordinary => -10.0..10.0_f64,
            1 => prop::sample::select(vec![
                f64::NAN, f64::INFINITY, -f64::INFINITY, 1e308, -1e308, 5e-324, 1e-160, 0.0, -0.0, 1e9,
            ]),
        ]
    }

    /// A covariance of one, two or three unequal scales, sometimes vast, tiny, singular or none at all.
    fn square(n: usize) -> impl Strategy<Value = DMatrix<f64>> {
        (prop::collection::vec(number(60), n * n), -9..9_i32, 0..10_u32).prop_map(move |(entries, scale, sound)| {
            let root = DMatrix::from_vec(n, n, entries);
            let scale = libm::exp10(f64::from(scale));
            if sound > 0 { &root * root.transpose() * scale } else { root * scale }
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

        /// Whatever is sent: no panic, a refusal changes nothing, and what is accepted leaves a covariance.
        #[test]
        fn nonsense_never_harms(
            (p, w, v) in (square(3), square(2), square(3)),
            steps in prop::collection::vec((number(12), number(12), number(12), number(12), 0..4_u32, any::<bool>()), 1..25),
        ) {
            let Ok(belief) = validate::belief(dvector![0.0, 0.0, 0.0], p) else { return Ok(()) };
            let Ok(mut slam) = EkfSlam::from_belief(&belief, w, Some(9.21), 50.0) else { return Ok(()) };
            for (a, b, c, d, id, named) in steps {
                let (x, before) = slam.belief();
                let (x, before) = (x.to_vec(), before);
                let one = Reading { range: c.abs(), bearing: d, landmark: named.then_some(id) };
                let accepted = match id {
                    0 => slam.predict_by(dvector![a, b], v.clone()).is_ok(),
                    1 => slam.update(&[one, Reading { range: a, bearing: b, landmark: None }]).is_ok(),
                    _ => slam.update(&[one]).is_ok(),
                };
                let (now, after) = slam.belief();
                if accepted {
                    prop_assert!(now.iter().chain(after.iter()).all(|e| e.is_finite()));
                    let scale = after.amax();
                    if scale > 0.0 {
                        let eigenvalues = (&after / scale).symmetric_eigenvalues();
                        prop_assert!(eigenvalues.min() >= -1e-12 * eigenvalues.max(), "{}", eigenvalues);
                    }
                } else {
                    prop_assert_eq!(now, x.as_slice());
                    prop_assert_eq!(after, before);
                }
            }
        }
    }
}
