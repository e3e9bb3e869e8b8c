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
    /// [`Code::NotPositiveSemidefinite`], or [`Code::Limit`] for a threshold that is not positive and for `found` below
    /// the gate.
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
    /// Naming u or V: [`Code::Shape`], [`Code::NotFinite`], [`Code::NotSymmetric`], [`Code::NotPositiveSemidefinite`];
    /// V for a covariance that overflows or loses its digits where it would not without V, otherwise u.
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
    use nalgebra::{dmatrix, dvector};

    fn belief() -> Belief {
        validate::belief(dvector![0.0, 0.0, 0.0], DMatrix::identity(3, 3) * 0.01).expect("sound")
    }

    #[test]
    fn bad_arguments_are_refused_by_name() {
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
}
