//! The top of a likelihood over poses, as a parabola that goes through its values nearby.

use nalgebra::{Matrix3, Vector3};

/// Slope and bend of the likelihood at a pose, by its values so far to either side.
pub(super) fn parabola(
    told: impl Fn(Vector3<f64>) -> Option<(f64, f64)>,
    pose: Vector3<f64>,
    steps: Vector3<f64>,
) -> Option<(Vector3<f64>, Matrix3<f64>)> {
    let at = |moved: Vector3<f64>| told(pose + moved).map(|(sum, _)| sum);
    let side = |i: usize, sign: f64| {
        let mut moved = Vector3::zeros();
        moved[i] = sign * steps[i];
        moved
    };
    let here = at(Vector3::zeros())?;
    let (mut slope, mut bend) = (Vector3::zeros(), Matrix3::zeros());
    for i in 0..3 {
        let (after, before) = (at(side(i, 1.0))?, at(side(i, -1.0))?);
        slope[i] = (after - before) / (2.0 * steps[i]);
        bend[(i, i)] = (after - 2.0 * here + before) / (steps[i] * steps[i]);
        for j in 0..i {
            let alike = at(side(i, 1.0) + side(j, 1.0))? + at(side(i, -1.0) + side(j, -1.0))?;
            let unlike = at(side(i, 1.0) + side(j, -1.0))? + at(side(i, -1.0) + side(j, 1.0))?;
            bend[(i, j)] = (alike - unlike) / (4.0 * steps[i] * steps[j]);
            bend[(j, i)] = bend[(i, j)];
        }
    }
    Some((slope, bend))
}
