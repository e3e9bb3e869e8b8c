//! How well first ranges tell a start, where the motion between them has drifted: what has drifted by one reading is in
//! all later ones too, so that many together tell less than they would one by one.

use super::opening_seen::Seen;
use nalgebra::{Matrix3, Vector3};

/// Readings that fit better than they claim tell the start better by this at most.
const LEAST: f64 = 0.5;

/// The standard deviations of x, y and θ of a start where the readings are so many times farther from it than they
/// claim (`spread`): with A the information, gᵢ the slope of a residual by the start and ℓᵢ by the pose at its time,
/// A⁻¹(Σ w² ggᵀ + ΣᵢΣⱼ w g ℓᵀ cov(δᵢ, δⱼ) ℓ gᵀ w)A⁻¹.
pub(super) fn spread(
    information: Matrix3<f64>,
    pose: &Vector3<f64>,
    seen: &[Seen],
    spread: f64,
) -> Option<Vector3<f64>> {
    let inverse = information.try_inverse()?;
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
    let covariance = inverse * (noise * of_noise + drift * of_drift) * inverse;
    let off = Vector3::from_fn(|i, _| libm::sqrt(covariance[(i, i)].max(0.0)));
    off.iter().all(|it| it.is_finite()).then_some(off)
}

/// How an error of the pose at one time goes on to another: it is turned about.
fn led(from: [f64; 3], to: [f64; 3]) -> Matrix3<f64> {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    Matrix3::new(1.0, 0.0, -dy, 0.0, 1.0, dx, 0.0, 0.0, 1.0)
}
