//! How well first ranges tell a start, where the motion between them has drifted: what has drifted by one reading is in
//! all later ones too, so that many together tell less than they would one by one.

use super::opening_seen::Seen;
use nalgebra::{Cholesky, Matrix3, Vector3};

/// Readings that fit better than they claim tell the start better by this at most.
const LEAST: f64 = 0.5;

/// An information whose eigenvalues are so far apart tells no start: one landmark that is seen while the robot stands
/// lets it stand anywhere around it, and its inverse is rounding.
const TELLS: f64 = 1e-10;

/// The covariance of a start that so much is known of; `None` where it is not told.
pub(super) fn covariance(information: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let eigenvalues = information.symmetric_eigenvalues();
    let told = eigenvalues.min() > TELLS * eigenvalues.max();
    Cholesky::new(*information).filter(|_| told).map(|factor| factor.inverse())
}

/// The roots of its diagonal.
pub(super) fn roots(covariance: &Matrix3<f64>) -> Option<Vector3<f64>> {
    let all = covariance.diagonal().iter().all(|of| of.is_finite() && *of > 0.0);
    all.then(|| covariance.diagonal().map(libm::sqrt))
}

/// The standard deviations of x, y and θ of a start where the readings are so many times farther from it than they
/// claim (`spread`): with A the information, gᵢ the slope of a residual by the start and ℓᵢ by the pose at its time,
/// A⁻¹(Σ w² ggᵀ + ΣᵢΣⱼ w g ℓᵀ cov(δᵢ, δⱼ) ℓ gᵀ w)A⁻¹.
pub(super) fn spread(
    information: Matrix3<f64>,
    pose: &Vector3<f64>,
    seen: &[Seen],
    spread: f64,
) -> Option<Vector3<f64>> {
    let inverse = covariance(&information)?;
    let [of_noise, of_drift] = [spread.max(LEAST), spread.max(1.0)].map(|it| it * it);
    let (mut noise, mut drift) = (Matrix3::zeros(), Matrix3::zeros());
    // What the drift of all readings before one, led on to it, adds up to.
    let mut before: Option<(Matrix3<f64>, [f64; 3])> = None;
    for it in seen {
        let [weighed, own] = it.weighed(pose);
        noise += own;
        let led = before.map_or(Matrix3::zeros(), |(sum, from)| sum * led(from, it.reckoned).transpose());
        let cross = led * weighed.transpose();
        drift += weighed * it.drift * weighed.transpose() + cross + cross.transpose();
        before = Some((led + weighed * it.drift, it.reckoned));
    }
    roots(&(inverse * (noise * of_noise + drift * of_drift) * inverse))
}

/// How an error of the pose at one time goes on to another: it is turned about.
fn led(from: [f64; 3], to: [f64; 3]) -> Matrix3<f64> {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    Matrix3::new(1.0, 0.0, -dy, 0.0, 1.0, dx, 0.0, 0.0, 1.0)
}
